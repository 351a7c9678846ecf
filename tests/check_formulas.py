#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Compares the formula tables of core/physics/README.md with the functions in core/physics/*.h: each function has one row, with a source, a
unit and a test function or case that exists. Run by ctest: check_formulas.py <root>"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
physics = root / "core/physics"
faults = []

declaration = re.compile(r"^[ \t]*(?:template <[^>]*> )?(?:static )?(?:HL_FN|inline|constexpr)(?: constexpr| inline)? [\w:<>]+ ([a-z]\w*)\(", re.M)
functions = {name: header.name for header in physics.glob("*.h") for name in declaration.findall(header.read_text())}

tests = {path.stem: path.read_text() for path in (root / "tests").rglob("tst_*.cpp")}
cases = "".join(path.read_text() for path in (root / "core/verify").glob("*.cpp"))


def check_test(reference):
    """`tst_file::function` or `verify case, case`."""
    if reference.startswith("verify "):
        missing = [case for case in reference[7:].split(", ") if f'"{case}"' not in cases]
        return f"there is no case {missing[0]}" if missing else ""
    file, _, function = reference.partition("::")
    found = function and re.search(rf"void {function}\(\)", tests.get(file, ""))
    return "" if found else f"there is no test function {reference}"


rows = {}
for line in (physics / "README.md").read_text().splitlines():
    cells = [cell.strip() for cell in line.strip("|").split("|")]
    if not line.startswith("| ") or len(cells) != 6 or cells[0] in ("eq.", "---"):
        continue
    names = re.findall(r"`([\w:]+)`", cells[2])
    references = re.findall(r"`([^`]+)`", cells[5])
    for name in names:
        if name in rows:
            faults.append(f"{name} has two rows")
        rows[name] = cells
    if not all(cells[3:5]) or "–" in cells[3:5]:
        faults.append(f"{names[0]}: the row has no source or no unit")
    if not any("::" in reference for reference in references):
        faults.append(f"{names[0]}: the row names no test function")
    faults += [f"{names[0]}: {fault}" for fault in map(check_test, references) if fault]

code = "".join(path.read_text() for folder in ("physics", "scene", "solver") for path in (root / "core" / folder).rglob("*.h"))
NO_FORMULAS = {"slots_for"}  # lengths of lists
listed = {name.split("::")[-1] for name in rows} | NO_FORMULAS
for name, header in sorted(functions.items()):
    if name not in listed:
        faults.append(f"{name} of core/physics/{header} has no row")
for name in rows:
    if not re.search(rf"\b{name.split('::')[-1]}\b", code):
        faults.append(f"{name} has a row and does not exist")

if faults:
    sys.exit("The formula tables of core/physics/README.md are not complete:\n  " + "\n  ".join(faults))
print(f"{len(functions)} functions have a row, a source and a test.")
