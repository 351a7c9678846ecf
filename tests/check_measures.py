#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Keeps the program in small pieces: the length of its files and functions, and the switches over the type of an experiment. Run by ctest:
check_measures.py <root>"""
import pathlib
import re
import sys

LARGEST_FILE, P95_OF_FILES, LONGEST_FUNCTION, LONG_FUNCTIONS, TYPE_SWITCHES = 450, 350, 60, 3, 3  # lines, lines, lines, number, number

root = pathlib.Path(sys.argv[1])
paths = [p for folder in ("app", "core", "gpu", "ui") for p in sorted((root / folder).rglob("*")) if p.suffix in (".h", ".cpp", ".cu", ".cuh")]
texts = {str(path.relative_to(root)): path.read_text() for path in paths}


def functions(lines):
    """First line, length and head of each function: clang-format opens a function's body on a line of its own."""
    for opens, line in enumerate(lines):
        indent = line[: len(line) - len(line.lstrip())]
        if line != indent + "{":
            continue
        head = next(k for k in range(opens - 1, -1, -1) if not lines[k].startswith(indent + " "))
        if lines[head][len(indent) :].startswith(("class ", "struct ", "enum ", "namespace ", "union ")):
            continue
        closes = next((k for k in range(opens, len(lines)) if lines[k].startswith(indent + "}")), opens)
        yield head + 1, closes - head + 1, lines[head].strip()


faults = []
lengths = sorted((text.count("\n"), name) for name, text in texts.items())
faults += [f"{name}: {length} lines; at most {LARGEST_FILE}" for length, name in lengths if length > LARGEST_FILE]
p95 = lengths[int(0.95 * len(lengths))][0]
if p95 > P95_OF_FILES:
    faults.append(f"one file in twenty has more than {p95} lines; at most {P95_OF_FILES}")

found = [(length, f"{name}:{line}: {length} lines: {head}") for name, text in texts.items() for line, length, head in functions(text.split("\n"))]
long = [what for length, what in found if length > LONGEST_FUNCTION]
if len(long) > LONG_FUNCTIONS:
    faults += [f"{len(long)} functions over {LONGEST_FUNCTION} lines; at most {LONG_FUNCTIONS}:"] + long

switches = [
    f"{name}:{text[: m.start()].count(chr(10)) + 1}"
    for name, text in texts.items()
    for m in re.finditer(r"switch \(", text)
    if "case ExperimentType::" in text[m.end() : m.end() + 300]
]
if len(switches) > TYPE_SWITCHES:
    faults.append(f"{len(switches)} switches over the type of an experiment; at most {TYPE_SWITCHES}: " + ", ".join(switches))

if faults:
    sys.exit("The program is in too large pieces:\n  " + "\n  ".join(faults))
print(f"{len(paths)} files, the largest of {lengths[-1][0]} lines, p95 {p95}; {len(found)} functions, {len(long)} over {LONGEST_FUNCTION} lines; {len(switches)} switches over the type.")
