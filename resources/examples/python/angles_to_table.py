# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""One input over its range, as a table: how the contact angle of a finish changes the way a drop goes in.

    python3 angles_to_table.py [table.csv]
"""
# %% The project, and what is to change
import pathlib
import sys

import pandas

import hygroloom

examples = pathlib.Path(__file__).resolve().parent.parent
project = hygroloom.Project.open(examples / "one-drop-on-cotton.hygro")
angles = [20, 40, 60]

# %% A run for each; without a recording, as only the numbers are wanted
rows = []
for angle in angles:
    project.set("fabrics[0].contact_angle_deg", angle)
    run = hygroloom.simulate(project, fidelity="live", recording=False)
    rows.append({"contact_angle_deg": angle, **run.table.value, "wall_s": run.provenance["wall_s"]})

# %% The table: None where a number could not be determined
table = pandas.DataFrame(rows).set_index("contact_angle_deg")
print(table[["absorbency_time_s", "maximum_wetted_radius_top_mm", "maximum_wetted_radius_bottom_mm"]])
if len(sys.argv) > 1:
    table.to_csv(sys.argv[1])
