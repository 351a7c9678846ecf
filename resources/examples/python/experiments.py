# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""One example for each experiment: what it asks of a cloth, and the numbers that answer.

    python3 experiments.py [droplet | moisture_management | ... | wear]

Fidelities and samples are small, so that each takes seconds; for numbers to rely on, take fidelity="standard" and the sample of the standard.
"""
# %%
import pathlib
import sys

import hygroloom

examples = pathlib.Path(__file__).resolve().parent.parent


def laboratory() -> hygroloom.Project:
    """A project with one fabric and an experiment of each type."""
    return hygroloom.Project.open(examples / "laboratory.hygro")


# %% AATCC 79: how far and how fast does a drop spread?
def droplet() -> hygroloom.Run:
    run = hygroloom.simulate(laboratory(), experiment="one drop", fidelity="live")
    print(run.table[["value", "low", "high", "unit"]])
    print(run.dataset.water_map.isel(time=-1).sum(["x", "y"]))
    return run


# %% AATCC 195: how do both faces take up solution?
def moisture_management() -> hygroloom.Run:
    project = laboratory().set("experiments.moisture management.duration_s", 30).set("experiments.moisture management.volume_ul", 25)
    project.set("experiments.moisture management.sample_mm", [40, 40])
    run = hygroloom.simulate(project, experiment="moisture management", fidelity="live")
    print(run.metrics.get("grades"), run.metrics["ommc"], run.metrics.get("fabric_class"))
    print(run.series[["water_content_top_pct", "water_content_bottom_pct"]].iloc[::20])
    return run


# %% AATCC 197: how high does water rise in a hanging strip?
def vertical_wicking() -> hygroloom.Run:
    project = laboratory().set("experiments.vertical wicking.strip_mm", [5, 60]).set("experiments.vertical wicking.duration_s", 60)
    run = hygroloom.simulate(project, experiment="vertical wicking", fidelity="draft")
    print(run.series.wick_height_mm.iloc[::10])
    warp = hygroloom.grid(run.dataset.saturation.isel(time=-1), "warp")  # (end, pick)
    print(f"{float((warp > 0.05).mean()):.0%} of the strip is wet.")
    return run


# %% AATCC 198: how large does a stain grow?
def horizontal_wicking() -> hygroloom.Run:
    project = laboratory().set("experiments.horizontal wicking.sample_mm", [30, 30]).set("experiments.horizontal wicking.volume_ul", 30)
    project.set("experiments.horizontal wicking.duration_s", 30)
    run = hygroloom.simulate(project, experiment="horizontal wicking", fidelity="live")
    print(run.series[["wetted_radius_top_mm", "yarn_water_g"]].iloc[::10])
    return run


# %% AATCC 199, 201: how fast does wet cloth dry, and how cold does it get?
def drying() -> hygroloom.Run:
    run = hygroloom.simulate(laboratory(), experiment="drying", fidelity="draft")
    print(run.table[["value", "unit", "missing"]])
    coldest = run.series.temperature_min_c.min()
    print(f"The cloth gets as cold as {coldest:.1f} degrees.")
    return run


# %% ISO 139: how fast does cloth take up moisture from air, and how warm does it get?
def conditioning() -> hygroloom.Run:
    run = hygroloom.simulate(laboratory(), experiment="conditioning", fidelity="draft")
    print(run.series[["regain_mean", "temperature_max_c"]].iloc[::20])
    return run


# %% Where does an even feed on one face go?
def sweat() -> hygroloom.Run:
    project = laboratory().set("experiments.sweat.sample_mm", [10, 10])
    run = hygroloom.simulate(project, experiment="sweat", fidelity="draft")
    ledger = run.dataset[["water_delivered_kg", "water_evaporated_kg", "water_liquid_kg", "water_bound_kg"]].isel(time=-1)
    print({name: f"{1e6 * float(value):.0f} mg" for name, value in ledger.items()})
    return run


# %% A shirt that is worn: where does it get wet?
def wear() -> hygroloom.Run:
    project = laboratory()
    project.set("garments", [{"name": "tee", "source": {"built_in": "tee"}, "panels": {"*": {"fabric": "Textile F"}}}])
    worn = {"name": "run", "type": "wear", "garment": "tee", "duration_s": 600, "activity": [{"time_s": 0, "factor": 1.0}]}
    project.set("experiments", project.get("experiments") + [worn])
    run = hygroloom.simulate(project, experiment="run", fidelity="draft", cell_mm=20)
    print(run.panels[["water_g", "wet_area_m2", "temperature_c"]])
    wettest = (run.dataset.inside + run.dataset.outside).isel(time=-1).groupby("zone").sum()
    print(wettest.to_series().sort_values().tail(3))
    return run


# %%
everything = [droplet, moisture_management, vertical_wicking, horizontal_wicking, drying, conditioning, sweat, wear]
if __name__ == "__main__":
    asked = sys.argv[1:] or [example.__name__ for example in everything]
    for example in everything:
        if example.__name__ in asked:
            print(f"--- {example.__name__}")
            example()
