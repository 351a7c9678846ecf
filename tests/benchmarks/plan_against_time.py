#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Random designs: the time that `plan` tells against the time that `simulate` takes.

    plan_against_time.py build/release/bin [--designs 500] [--first 0] [--jobs 2] [--longest 60] [--fidelity draft]

Each design is drawn by its number (`trial_files design`) and runs on one thread, whose processor time is taken. What is told is multiplied by one
factor, which is the machine: the median ratio of the runs that take twice the program's start or more. That start is what `plan` itself takes, and
is added. A run longer than --longest is ended: it counts as a miss where it is one by then, else it is left out.
Prints how many lie within a factor of 3, and those that do not."""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import resource
import signal
import statistics
import subprocess
import tempfile

WITHIN = 3


def timed(command, environment, longest):
    """Exit status as wait4 gives it, s of processor time, output."""
    run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=environment, text=True,
                           preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (longest, longest + 1)))
    output = run.stdout.read()
    _, status, used = os.wait4(run.pid, 0)
    return status, used.ru_utime + used.ru_stime, output


def tried(programs, number, fidelity, longest):
    """(type of experiment, s told, s of start, s taken, whether it was ended), or nothing for a design that is refused."""
    with tempfile.TemporaryDirectory() as folder:
        own = {**os.environ, "XDG_CACHE_HOME": folder}  # where nothing was learned
        project = pathlib.Path(folder) / "design.hygro"
        cli = programs / "hygroloom-cli"
        subprocess.run([programs / "tests/trial_files", "design", str(number), project], check=True, capture_output=True)
        status, start, plan = timed([cli, "plan", project, "--fidelity", fidelity, "--backend", "cpu", "--json", "-q"], own, longest)
        if status != 0:
            return None
        kind = json.loads(project.read_text())["experiments"][0]["type"]
        status, taken, _ = timed([cli, "simulate", project, "--fidelity", fidelity, "--backend", "cpu", "--threads", "1", "-q"], own, longest)
        ended = os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGKILL)
        if os.WIFSIGNALED(status) and not ended:
            raise SystemExit(f"design {number}: simulate ended by signal {os.WTERMSIG(status)}")
        return (kind, json.loads(plan)["expected"]["time_s"], start, taken, ended) if ended or status == 0 else None


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("programs", type=pathlib.Path)
    ask.add_argument("--designs", type=int, default=500)
    ask.add_argument("--first", type=int, default=0)
    ask.add_argument("--jobs", type=int, default=2)
    ask.add_argument("--longest", type=int, default=60, help="s of processor time")
    ask.add_argument("--fidelity", default="draft")
    ask.add_argument("--table", type=pathlib.Path, help="write all of them there: number;type;told;start;taken;ended")
    asked = ask.parse_args()
    programs = asked.programs.resolve()
    numbers = range(asked.first, asked.first + asked.designs)
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        found = dict(zip(numbers, pool.map(lambda n: tried(programs, n, asked.fidelity, asked.longest), numbers)))
    found = {number: run for number, run in found.items() if run}
    if asked.table:
        asked.table.write_text("".join(f"{n};{kind};{told:.4g};{start:.4g};{taken:.4g};{int(ended)}\n" for n, (kind, told, start, taken, ended) in found.items()))
    work = [(taken - start) / told for _, told, start, taken, ended in found.values() if taken > 2 * start and not ended]
    if not work:
        raise SystemExit("No run takes long enough to tell the machine by; take more designs.")
    machine = statistics.median(work)
    ratios = {n: taken / (machine * told + start) for n, (_, told, start, taken, _) in found.items()}
    open_ended = [n for n, run in found.items() if run[4] and ratios[n] <= WITHIN]
    counted = [n for n in found if n not in open_ended]
    missed = [n for n in counted if not 1 / WITHIN <= ratios[n] <= WITHIN]
    print(f"{len(counted) - len(missed)} of {len(counted)} within a factor of {WITHIN} ({100 * (1 - len(missed) / len(counted)):.1f} %); "
          f"{len(open_ended)} were ended before they showed; this machine takes {machine:.2f} times what is told.")
    for kind, count in collections.Counter(found[n][0] for n in missed).most_common():
        print(f"  {kind}: {count} missed of {sum(found[n][0] == kind for n in counted)}")
    for number in sorted(missed, key=lambda n: ratios[n]):
        kind, told, _, taken, ended = found[number]
        print(f"  design {number}, {kind}: told {told:.3g} s, taken {'over ' if ended else ''}{taken:.3g} s, {ratios[number]:.2g} times")


if __name__ == "__main__":
    main()
