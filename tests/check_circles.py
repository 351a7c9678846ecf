#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Finds units (a header with its source) that include each other, directly or round a circle. Each circle needs a reason below; there may be
three at most. Run by ctest: check_circles.py <root>"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])

# The units of a circle, and why they belong together.
ALLOWED = {
    # How uneven a yarn usually is follows from its free linear density, that from its kind's packing, the kind from its being of filaments;
    # and a fitted yarn says how uneven it is.
    frozenset({"core/design/evenness", "core/design/yarn_class", "core/design/yarn_sections"}),
    # A scene's start is found from all the rest of the scene.
    frozenset({"core/scene/scene", "core/scene/wet_cloth"}),
}
assert len(ALLOWED) <= 3


def unit(path):
    return str(path).rsplit(".", 1)[0]


includes = {}
for folder in ("app", "core", "gpu", "ui"):
    for path in (root / folder).rglob("*"):
        if path.suffix not in (".h", ".cpp", ".cu", ".cuh"):
            continue
        own = unit(path.relative_to(root))
        named = re.findall(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', path.read_text(), re.M)
        includes.setdefault(own, set()).update(unit(name) for name in named if (root / name).exists() and unit(name) != own)


def reached_from(start):
    reached, waiting = set(), [start]
    while waiting:
        for other in includes.get(waiting.pop(), ()):
            if other not in reached:
                reached.add(other)
                waiting.append(other)
    return reached


reached = {own: reached_from(own) for own in includes}
circles = {frozenset(other for other in reached[own] if own in reached.get(other, ())) for own in includes if own in reached[own]}
faults = ["  " + " ".join(sorted(circle)) for circle in circles if circle not in ALLOWED]
stale = ["  no longer a circle: " + " ".join(sorted(circle)) for circle in ALLOWED if circle not in circles]
if faults or stale:
    sys.exit("Units include each other round a circle:\n" + "\n".join(sorted(faults) + stale))
print(f"{len(includes)} units, {len(circles)} circles that are allowed.")
