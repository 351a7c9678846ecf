#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Refuses a comment or text that cites a document (name.md) which is not in the repository. Run by ctest: check_citations.py <root>"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
SOURCES = {".h", ".cpp", ".cu", ".cuh", ".cmake", ".txt", ".sh", ".py", ".vert", ".frag", ".glsl", ".json", ".hygro", ".ts"}
folders = ("app", "core", "gpu", "ui", "tests", "packaging", "resources", "python")

documents = ["/" + str(path.relative_to(root)) for folder in (*folders, ".github") for path in (root / folder).rglob("*.md")]
documents += ["/" + path.name for path in root.glob("*.md")]
paths = [root / "CMakeLists.txt"] + [p for folder in folders for p in (root / folder).rglob("*") if p.suffix in SOURCES and p.is_file()]

faults = []
for path in paths:
    if path.name == pathlib.Path(__file__).name:
        continue
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        for name in re.findall(r"[\w./-]*\w\.md\b", line):
            if not any(document.endswith("/" + name.lstrip("./").removeprefix("share/hygroloom/")) for document in documents):
                faults.append(f"  {path.relative_to(root)}:{number}: {name}")
if faults:
    sys.exit("Documents are cited that are not in the repository:\n" + "\n".join(faults))
print(f"{len(paths)} files cite only documents of the repository.")
