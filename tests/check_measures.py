#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Keeps the program and its tests in small pieces: the length of files and functions, and the switches over the type of an experiment. Run by ctest:
check_measures.py <root>"""
import pathlib
import re
import sys

LARGEST_FILE, P95_OF_FILES, LONGEST_FUNCTION, LONG_FUNCTIONS, TYPE_SWITCHES = 450, 350, 60, 3, 3  # lines, lines, lines, number, number
LARGEST_TEST, LONG_TESTS, LONG_TEST_FUNCTIONS = 540, 7, 1  # lines, number over LARGEST_FILE, number over LONGEST_FUNCTION; tables of rows are free

root = pathlib.Path(sys.argv[1])


def texts_of(*folders):
    paths = [p for folder in folders for p in sorted((root / folder).rglob("*")) if p.suffix in (".h", ".cpp", ".cu", ".cuh")]
    return {str(path.relative_to(root)): path.read_text() for path in paths}


texts, tests = texts_of("app", "core", "gpu", "ui"), texts_of("tests")


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


def sized(texts):
    """Length and place of each function."""
    return [(length, f"{name}:{line}: {length} lines: {head}") for name, text in texts.items() for line, length, head in functions(text.split("\n"))]


faults = []
lengths = sorted((text.count("\n"), name) for name, text in texts.items())
faults += [f"{name}: {length} lines; at most {LARGEST_FILE}" for length, name in lengths if length > LARGEST_FILE]
p95 = lengths[int(0.95 * len(lengths))][0]
if p95 > P95_OF_FILES:
    faults.append(f"one file in twenty has more than {p95} lines; at most {P95_OF_FILES}")

found = sized(texts)
long = [what for length, what in found if length > LONGEST_FUNCTION]
if len(long) > LONG_FUNCTIONS:
    faults += [f"{len(long)} functions over {LONGEST_FUNCTION} lines; at most {LONG_FUNCTIONS}:"] + long

long_tests = [f"{name}: {length} lines" for name, length in ((name, text.count("\n")) for name, text in tests.items()) if length > LARGEST_FILE]
faults += [f"{what}; at most {LARGEST_TEST}" for what in long_tests if int(what.split()[-2]) > LARGEST_TEST]
if len(long_tests) > LONG_TESTS:
    faults += [f"{len(long_tests)} tests over {LARGEST_FILE} lines; at most {LONG_TESTS}:"] + long_tests
long_in_tests = [what for length, what in sized(tests) if length > LONGEST_FUNCTION and not what.endswith("_data()")]
if len(long_in_tests) > LONG_TEST_FUNCTIONS:
    faults += [f"{len(long_in_tests)} functions of tests over {LONGEST_FUNCTION} lines; at most {LONG_TEST_FUNCTIONS}:"] + long_in_tests

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
print(f"{len(texts)} files, the largest of {lengths[-1][0]} lines, p95 {p95}; {len(found)} functions, {len(long)} over {LONGEST_FUNCTION} lines; {len(switches)} switches over the type; {len(tests)} files of tests, {len(long_tests)} over {LARGEST_FILE} lines.")
