#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Every block of commands in README.md and in the guide runs, in one folder, in which pages make what later ones use.
Run by ctest: run_blocks.py SOURCE BUILD [PYTHON_OF_THE_MODULE]   (shown: which block takes how long)

A comment before a block, which readers do not see, says what is to be done with it:
  <!-- file: study.json -->      it is the text of that file
  <!-- not run: REASON -->       it is not run
Tests are made short: projects that a command writes, and the examples, get small samples and short durations, and runs are live."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

SAMPLES = {"sample_mm": [5, 5], "strip_mm": [3, 60]}
DURATIONS = {"droplet": 0.3, "vertical_wicking": 10, "moisture_management": 2, "horizontal_wicking": 2, "wear": 2}
FIRST = ("index.md", "calibrate.md", "studies.md")  # which make what others use
LIMIT_S = 120  # of one block


def shorten(path):
    """The same project or study, made quick."""
    whole = json.loads(path.read_text())
    of_study = whole["format"] == "hygroloom-study"  # which names them
    for experiment in [] if of_study else whole.get("experiments", []):
        experiment["duration_s"] = min(DURATIONS.get(experiment["type"], 5), experiment.get("duration_s", 5))
        experiment.update({key: small for key, small in SAMPLES.items() if key in experiment})
        for drop in experiment.get("droplets", []):
            drop["volume_ul"] = min(1, drop.get("volume_ul", 1))
            drop["time_s"] = min(0.1, drop.get("time_s", 0))
            drop["at_mm"] = [0, 0]
    if of_study:
        whole["design"]["points"] = min(16, whole["design"]["points"])
    path.write_text(json.dumps(whole))


def wrapper(command):
    """In the place of hygroloom-cli: runs at the fidelity live, and makes the projects short that it writes."""
    if command and command[0] in ("simulate", "compare", "calibrate"):
        at = command.index("--fidelity") if "--fidelity" in command else len(command)
        command[at : at + 2] = ["--fidelity", "live"]
    before = {path: path.stat().st_mtime_ns for path in pathlib.Path().glob("*.hygro")}
    code = subprocess.run([os.environ["REAL_CLI"], *command]).returncode
    for path in pathlib.Path().glob("*.hygro"):
        if before.get(path) != path.stat().st_mtime_ns:
            shorten(path)
    return code


def blocks(page):
    """Line, language, text, and what a comment before it says, of each block."""
    told, inside = "", None
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if inside is not None:
            if line.startswith("```"):
                yield (*inside[:2], "\n".join(inside[2:]) + "\n", told)
                told, inside = "", None
            else:
                inside.append(line)
        elif line.startswith("```"):
            inside = [number, line[3:].strip()]
        elif comment := re.fullmatch(r"<!-- (.*) -->", line):
            told = comment[1]
        elif line:
            told = ""


def lay_out(folder, source, build):
    """What a reader has: the source with its examples, what was built, and files of their own."""
    shutil.copytree(source / "resources/examples", folder / "resources/examples", ignore=shutil.ignore_patterns("*-runs"))
    for path in [*(folder / "resources/examples").rglob("*.hygro"), *(folder / "resources/examples").rglob("*.study.json")]:
        shorten(path)
    shutil.copy(source / "tests/data/garments/tee.json", folder)
    (folder / "yarns.csv").write_text("name,count,material\nNe 40,Ne 40,cotton\nNe 36,Ne 36,cotton\n")
    programs = folder / "build/release/bin"
    programs.mkdir(parents=True)
    (programs / "hygroloom-cli").write_text(f"#!/bin/sh\nexec {sys.executable} {pathlib.Path(__file__).resolve()} --as-cli \"$@\"\n")
    (programs / "hygroloom-cli").chmod(0o755)
    environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "REAL_CLI": str(build / "bin/hygroloom-cli"),
                   "PYTHONPATH": str(build / "python"), "XDG_CACHE_HOME": str(folder / "cache"), "TMPDIR": str(folder)}  # fmt: skip
    made = ["presets", "Denim", "-o", "own.hygro"], ["export", "own.hygro", "-o", "draft.wif"]
    for command in made:
        subprocess.run(["hygroloom-cli", *command], cwd=folder, env=environment, check=True, capture_output=True)
    return environment


def main(source, build, python):
    faults, count = [], 0
    has_analysis = (build / "lib/hygroloom/hygroloom_openturns.so").exists()
    guide = source / "resources/help"
    others = sorted(page for page in guide.glob("*.md") if page.name not in FIRST)
    with tempfile.TemporaryDirectory(prefix="hygroloom-blocks-") as name:
        folder = pathlib.Path(name)
        environment = lay_out(folder, source, build)
        for page in [source / "README.md", *(guide / first for first in FIRST), *others]:
            for line, language, text, told in blocks(page):
                where = f"{page.relative_to(source)}:{line}"
                run = {"sh": ["sh", "-ec"], "python": [python, "-c"]}.get(language)
                if told.startswith("file: "):
                    path = folder / told[6:]
                    path.write_text(text)
                    if path.suffix == ".json":
                        shorten(path)
                    continue
                if told.startswith("not run: ") and len(told) > 15 or not run:
                    if language == "" and "hygroloom" in text:
                        faults.append(f"{where}: commands stand in a block without a language")
                    continue
                if language == "python" and not (build / "python/hygroloom/__init__.py").exists():
                    print(f"{where}: the Python package is not built", flush=True)
                    continue
                if re.search("--analyse|--predict|--suggest", text) and not has_analysis:
                    print(f"{where}: the analysis is not built", flush=True)
                    continue
                begin = time.monotonic()
                try:
                    done = subprocess.run([*run, text], cwd=folder, env=environment, capture_output=True, text=True, timeout=LIMIT_S)
                    if done.returncode != 0:
                        faults.append(f"{where}: ends with {done.returncode}: {done.stderr.strip()[-600:]}")
                except subprocess.TimeoutExpired:
                    faults.append(f"{where}: takes more than {LIMIT_S} s")
                count += 1
                print(f"{where}: {time.monotonic() - begin:.1f} s", flush=True)
    for fault in faults:
        print(fault)
    print(f"{count} blocks run." if not faults else f"{len(faults)} of {count} blocks fail.")
    return 1 if faults or count < 20 else 0


if __name__ == "__main__":
    if sys.argv[1] == "--as-cli":
        sys.exit(wrapper(sys.argv[2:]))
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3] if len(sys.argv) > 3 else sys.executable))
