#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""What a text search can check of the documents: their size, that each decision is short and in the index, that links lead somewhere.
Run by ctest: check_papers.py <root>"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
LINES = {"README.md": 80, "ARCHITECTURE.md": 130}
INDEX_BYTES = 8192
ENTRY_WORDS = 120

papers = [p for folder in ("app", "core", "gpu", "packaging", "python", "resources", "tests", "ui") for p in (root / folder).rglob("*.md")]
papers += root.glob("*.md")
faults = []


def fault(path, sentence):
    faults.append(f"  {path.relative_to(root)}: {sentence}")


def anchor_of(heading):
    """As web pages of repositories make it."""
    return re.sub(r"[^\w -]", "", heading.strip().lower()).replace(" ", "-")


def anchors_in(path):
    return [anchor_of(heading) for heading in re.findall(r"^#+ (.*)$", path.read_text(), re.M)]


for name, most in LINES.items():
    lines = len((root / name).read_text().splitlines())
    if lines > most:
        fault(root / name, f"{lines} lines; at most {most}")
index = root / "DECISIONS.md"
if index.stat().st_size > INDEX_BYTES:
    fault(index, f"{index.stat().st_size} bytes; an index of at most {INDEX_BYTES}")

entries = 0
for path in papers:
    if path.name != "DECISIONS.md" or path == index:
        continue
    for entry in path.read_text().split("\n## ")[1:]:
        heading, body = entry.split("\n", 1)
        entries += 1
        if len(body.split()) > ENTRY_WORDS:
            fault(path, f'"{heading}" has {len(body.split())} words; at most {ENTRY_WORDS}')
        if "**Decision.**" not in body or "**Why.**" not in body:
            fault(path, f'"{heading}" lacks its decision or its why')
        if f"({path.relative_to(root)}#{anchor_of(heading)})" not in index.read_text():
            fault(path, f'"{heading}" is not in the index DECISIONS.md')

links = 0
for path in papers:
    text = re.sub(r"^```.*?^```", "", path.read_text(), flags=re.M | re.S)
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"https?:|mailto:", link):
            continue
        links += 1
        target, _, anchor = link.partition("#")
        there = path.parent / target if target else path
        if not there.exists():
            fault(path, f"the link {link} leads nowhere")
        elif anchor and anchor not in anchors_in(there):
            fault(path, f"the link {link} names a heading that is not there")

if faults:
    sys.exit("Documents:\n" + "\n".join(faults))
print(f"{len(papers)} documents with {links} links and {entries} decisions are in order.")
