# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Two inputs over their ranges, as a table: how contact angle and sett change the way a drop goes in.

    python3 sweep_to_table.py [folder]

With a folder each row is kept as soon as it has ended, and results.csv and study.sqlite at the end.
"""
# %% The project, and what is to change
import pathlib
import sys

import hygroloom

examples = pathlib.Path(__file__).resolve().parent.parent
project = hygroloom.Project.open(examples / "one-drop-on-cotton.hygro")
study = {
    "factors": [
        {"path": "fabrics[0].contact_angle_deg", "values": [20, 40, 60]},
        {"path": "fabrics[0].ends_per_cm", "low": 25, "high": 35, "levels": 2},
    ],
    "design": {"type": "grid"},
    "metrics": ["absorbency_time_s", "maximum_wetted_radius_top_mm"],
    "fidelity": "live",
}

# %% A run for each combination, side by side; sys.argv[1] may be a folder from before, which resume=True would go on with
table = hygroloom.sweep(project, study, sys.argv[1] if len(sys.argv) > 1 else None)
print(table)

# %% As a grid: the angle down, the sett across
print(table.pivot(index="fabrics[0].contact_angle_deg", columns="fabrics[0].ends_per_cm", values="absorbency_time_s"))
