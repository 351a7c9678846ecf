#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Compares the table of rooms in ARCHITECTURE.md with tests/rooms.txt: the same rooms, each with the same rooms it may include.
Run by ctest: check_rooms_table.py <root>"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
rules = dict(re.findall(r"^([a-z/]+): ?(.*)$", (root / "tests/rooms.txt").read_text(), re.M))

text = (root / "ARCHITECTURE.md").read_text()
if text.count("<!-- rooms -->") != 1 or text.count("<!-- /rooms -->") != 1:
    sys.exit("ARCHITECTURE.md has no table of rooms between <!-- rooms --> and <!-- /rooms -->.")
table = text.split("<!-- rooms -->")[1].split("<!-- /rooms -->")[0]
rows = {}
for line in table.splitlines():
    cells = [cell.strip().replace("`", "") for cell in line.strip("|").split("|")]
    if len(cells) == 3 and cells[0] not in ("room", "---"):
        rows[cells[0]] = cells[2]

faults = [f"{room} stands in tests/rooms.txt only" for room in rules if room not in rows]
faults += [f"{room} stands in ARCHITECTURE.md only" for room in rows if room not in rules]
for room in rules.keys() & rows.keys():
    if sorted(rules[room].split()) != sorted(re.findall(r"[a-z/]+", rows[room])):
        faults.append(f"{room} may include {rules[room] or 'nothing'}; ARCHITECTURE.md says {rows[room] or 'nothing'}")
if faults:
    sys.exit("The two tables of rooms differ:\n  " + "\n  ".join(sorted(faults)))
print(f"{len(rules)} rooms, the same in both tables.")
