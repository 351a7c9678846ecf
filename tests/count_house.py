#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Counts what the size and the doubles of the house can be told by: lines, places where one number is written, twins.
Usage: count_house.py <root>; prints a table."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])


def files(*folders, ends=(".cpp", ".h", ".cu", ".cuh")):
    return [p for folder in folders for p in sorted((root / folder).rglob("*")) if p.suffix in ends and p.is_file()]


def lines(paths):
    return sum(len(p.read_text(errors="replace").splitlines()) for p in paths)


def named_in(paths, pattern):
    """Files in which the pattern stands."""
    found = re.compile(pattern)
    return [p for p in paths if found.search(p.read_text(errors="replace"))]


source = files("core", "ui", "app", "gpu")
tests = files("tests", ends=(".cpp", ".h", ".py", ".sh"))
text = {p: p.read_text(errors="replace") for p in source}


rows = [
    ("source lines: core, ui, app, gpu", lines(source)),
    ("lines of tests", lines(tests)),
    ("files in which a yarn's twist is written as a key", len(named_in(source, r'"twist_per_m"'))),
    ("files in which a yarn's irregularity is written as a key", len(named_in(source, r'"irregularity_cv"'))),
    ("files in which a wearer's skin temperature is written as a key", len(named_in(source, r'skin_temperature_c"'))),
    ("calls of run_experiment and run_garment", sum(len(re.findall(r"\brun_(?:experiment|garment)\(", t)) for p, t in text.items() if p.name not in ("runner.h", "runner.cpp", "garment_run.h", "garment_run.cpp"))),
    ("calls of run_job", sum(len(re.findall(r"\brun_job\(", t)) for p, t in text.items() if "run_job" not in p.name)),
    ("lines that name HDF5", sum(len(re.findall(r"(?i)hdf5|H5[A-Z]\w+\(", t)) for t in text.values())),
    ("ways to write a report", len(named_in(source, r"\nReportPage \w+\([^;{]*\)\n\{"))),
    ("largest file, lines", max(len(t.splitlines()) for t in text.values())),
]
print("| counted | now |\n| --- | --- |")
for what, number in rows:
    print(f"| {what} | {number} |")
