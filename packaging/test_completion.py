#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Man pages and completion know every verb and option that the programs' own help names, and no other; shells that are here complete them.
Run by ctest: test_completion.py <hygroloom-cli> <folder of the written files> [<hygroloom>]"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

program, folder = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
faults = []


def output(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL, **more).stdout


def options_in(help_text):
    """Names of the options in a help text: those that open a line."""
    lines = re.findall(r"^ {2,6}(-[^\n]*)", help_text, re.M)
    return {name for line in lines for name in re.findall(r"(?:^|[, ])(--?[a-zA-Z][\w-]*)", re.split(r" {2,}|[A-Z]", line)[0])}


def compare(what, expected, found):
    if expected != found:
        faults.append(f"{what}: lacks {sorted(expected - found)}, has besides {sorted(found - expected)}")


def in_roff(text):
    return set(re.findall(r"\\fB(--?[a-zA-Z][\w-]*)\\fR", "\n".join(re.findall(r"^\.TP\n(.*)", text.replace("\\-", "-"), re.M))))


def completed_by_bash(*words):
    script = 'source "$1"; shift; COMP_WORDS=(hygroloom-cli "$@"); COMP_CWORD=$#; compopt() { :; }; _hygroloom_cli; printf "%s\\n" "${COMPREPLY[@]}"'
    return set(output("bash", "-c", script, "bash", str(folder / "hygroloom-cli.bash"), *words).split())


def completed_by_fish(*words):
    line = " ".join(("hygroloom-cli",) + words)
    script = f"source {folder}/hygroloom-cli.fish; complete -C'{line}'"
    return {answer.split("\t")[0] for answer in output("fish", "--no-config", "-c", script).splitlines()}


def completed_by_zsh(*words):
    """What the written function hands to _arguments and _describe, in the place of which stand functions that print it."""
    script = ('_describe() { print -l ${(P)2%%:*}; }; _arguments() { print -l -- "$@"; }; words=(hygroloom-cli "$@"); CURRENT=$#words; '
              f"f() {{ {(folder / '_hygroloom-cli').read_text()} }}; f")
    said = output("zsh", "-f", "-c", script, "zsh", *words).splitlines()
    return {name for line in said for name in re.findall(r"^(?:\([^)]*\)|\*)?(--?[\w-]+|[a-z]+)(?=\[|$)", line)}


for form, file in (("man", "hygroloom-cli.1"), ("bash", "hygroloom-cli.bash"), ("zsh", "_hygroloom-cli"), ("fish", "hygroloom-cli.fish")):
    if output(program, "reference", "--as", form) != (folder / file).read_text():
        faults.append(f"{file} is not what the program writes; build the target man_and_completion")

helped = output(program, "--help")
verbs = set(re.findall(r"^  ([a-z]+) {2,}", helped.split("Subcommands:")[1], re.M))
manual = (folder / "hygroloom-cli.1").read_text()
compare("verbs of the man page", verbs, set(re.findall(r"^\.SS (\w+)$", manual, re.M)))
shells = [(name, of) for name, of in (("bash", completed_by_bash), ("fish", completed_by_fish), ("zsh", completed_by_zsh)) if shutil.which(name)]
for name, of in shells:
    compare(f"{name}: verbs", verbs, of("") - options_in(helped))
for verb in sorted(verbs):
    expected = options_in(output(program, verb, "--help"))
    part = re.split(r"^\.S[SH] ", manual.split(f".SS {verb}\n")[1], flags=re.M)[0]
    compare(f"man page: {verb}", expected, in_roff(part))
    for name, of in shells:
        found = of(verb, "-") | (of(verb, "--") if name == "fish" else set())
        compare(f"{name}: {verb}", expected, found)
for name, of in shells:
    if name != "zsh":
        compare(f"{name}: --backend", {"auto", "cpu", "cuda"}, of("simulate", "--backend", ""))
        compare(f"{name}: garment --fidelity", {"live", "draft", "standard", "reference"}, of("garment", "--fidelity", ""))
        lacking = {"import", "plan", "map"} - of("garment", "")
        if lacking:
            faults.append(f"{name}: garment lacks {sorted(lacking)}")
if shutil.which("man"):
    warned = subprocess.run(["man", "--warnings", "-l", folder / "hygroloom-cli.1"], capture_output=True, text=True, env=os.environ | {"MANWIDTH": "100"})
    if warned.stderr:
        faults.append("man: " + warned.stderr)

if len(sys.argv) > 3:
    told = output(sys.argv[3], "--help", env=os.environ | {"QT_QPA_PLATFORM": "offscreen"})
    compare("man page of the window", options_in(told), in_roff(pathlib.Path(__file__).with_name("desktop").joinpath("hygroloom.1").read_text()))

if faults:
    sys.exit("\n".join(faults))
print(f"{len(verbs)} verbs; tried with {', '.join(name for name, _ in shells)}.")
