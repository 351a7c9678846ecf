# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""From a strip that a laboratory measured to what a drop will do on the same cloth.

    python3 calibrate_a_strip.py

The heights here are made up by a run at 42 degrees with some noise, so that the answer is known.
"""
# %% A strip, as a laboratory would measure it: the height of the water over time
import pathlib

import numpy as np
import pandas

import hygroloom

examples = pathlib.Path(__file__).resolve().parent.parent
project = hygroloom.Project.open(examples / "laboratory.hygro")
project.set("experiments.vertical wicking.strip_mm", [3, 80]).set("experiments.vertical wicking.duration_s", 15)

truth = project.copy().set("fabrics[0].contact_angle_deg", 42)
height = hygroloom.simulate(truth, experiment="vertical wicking", fidelity="live", recording=False).series.wick_height_mm
times = np.linspace(2, 15, 14)
noise = np.random.default_rng(1).normal(1, 0.01, times.size)
measured = pandas.DataFrame({"time_s": times, "wick_height_mm": np.interp(times, height.index, height) * noise})
print(measured)

# %% The contact angle that fits it, and how sure that is
fit = hygroloom.calibrate(project, experiment="vertical wicking", measured=measured, free="contact_angle_deg", fidelity="live")
if not fit.identifiable:
    raise SystemExit(fit.refusal)
angle = fit.parameters["contact_angle_deg"]
print(f"Contact angle {angle['value']:.1f} degrees ({angle['low']:.1f} to {angle['high']:.1f}); before {angle['before']:.0f}.")

# %% What the calibrated cloth does with a drop; fit.project.save("calibrated.hygro") keeps it
for name, cloth in (("as given", project), ("calibrated", fit.project)):
    run = hygroloom.simulate(cloth, experiment="one drop", fidelity="live", recording=False)
    print(f"{name}: absorbency time {run.metrics['absorbency_time_s']} s")
