#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Trials of hygroloom-cli in classes, each as long as its share of the time: random designs, kills, full disks, streams, names, writers, crafted
recordings, threads. A trial follows from the class and a number alone, so that what broke can be tried again. See packaging/reliability.sh."""
import argparse
import json
import math
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "resources/examples/one-drop-on-cotton.hygro"
THREE = ROOT / "resources/examples/three-candidates.hygro"
SHORT = ["--fidelity", "draft", "--backend", "cpu", "-q", "--set", "experiments[0].duration_s=0.3"]
FEW = ["--set", "fidelity.particles_per_droplet=100"]


class Broken(Exception):
    pass


class Skipped(Exception):
    pass


def demand(holds, sentence):
    if not holds:
        raise Broken(sentence)


class Bench:
    """Programs, a folder of the trial's own and its dice."""

    def __init__(self, build, folder, dice):
        self.cli, self.tools, self.folder, self.dice = build / "bin/hygroloom-cli", build / "bin/tests", folder, dice

    def call(self, *arguments, codes=(0,), seconds=120, **more):
        """Runs the program; what it may not do is crash, hang, or end with another code."""
        try:
            done = subprocess.run([self.cli, *map(str, arguments)], capture_output=True, cwd=self.folder, timeout=seconds, stdin=subprocess.DEVNULL, **more)
        except subprocess.TimeoutExpired:
            raise Broken(f"{arguments[0]} took more than {seconds} s") from None
        error = done.stderr.decode(errors="replace")
        demand(done.returncode in codes, f"{' '.join(map(str, arguments))} ended with {done.returncode}: {error[-400:]}")
        return done

    def call_within(self, most, *arguments, codes=(0,), seconds=30):
        """As call(); nor may the program take more memory, bytes."""
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen([self.cli, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=said)
            timer = threading.Timer(seconds, os.kill, (process.pid, signal.SIGKILL))
            timer.start()
            _, status, used = os.wait4(process.pid, 0)
            in_time = timer.is_alive()
            timer.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            said.seek(0)
            error = said.read().decode(errors="replace")
        demand(in_time, f"{arguments[0]} took more than {seconds} s")
        demand(process.returncode in codes, f"{' '.join(map(str, arguments))} ended with {process.returncode}: {error[-400:]}")
        demand(1024 * used.ru_maxrss <= most, f"{' '.join(map(str, arguments))} took {1024e-6 * used.ru_maxrss:.0f} MB of memory; at most {1e-6 * most:.0f}")

    def start(self, *arguments):
        return subprocess.Popen([self.cli, *map(str, arguments)], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL)

    def tool(self, name, *arguments):
        done = subprocess.run([self.tools / name, *map(str, arguments)], capture_output=True, text=True, errors="replace", cwd=self.folder, timeout=60)
        demand(done.returncode == 0, f"{name}: {done.stderr}")
        return done.stdout

    def holds_too_little(self):
        """Whether the cloth does not hold the water that drying shall begin with, which a run refuses."""
        if json.loads((self.folder / "design.hygro").read_text())["experiments"][0]["type"] != "drying":
            return False
        tried = self.call("simulate", "design.hygro", "-q", "--backend", "cpu", "--fidelity", "live", "--set", "experiments[0].duration_s=1e-6", codes=(0, 1))
        demand(tried.returncode == 0 or b"of water at most" in tried.stderr, f"a short run ended with 1: {tried.stderr[-400:]}")
        return tried.returncode != 0

    def random_design(self, longest):
        """A valid one: its number and the argument that shortens it, s; its drops fall all the same."""
        while True:
            seed = self.dice.randrange(10**6)
            simulated = min(float(self.tool("trial_files", "design", seed, "design.hygro")), longest)
            if self.call("check", "design.hygro", "-q", codes=(0, 3), seconds=30).returncode == 0 and not self.holds_too_little():
                drops = json.loads((self.folder / "design.hygro").read_text())["experiments"][0].get("droplets", [])
                last = max((drop["time_s"] for drop in drops), default=0)
                return seed, f"experiments[0].duration_s={max(simulated, last + 1e-3 if last > 0 else 0):.12g}"


def all_finite(value):
    if isinstance(value, dict):
        return all(map(all_finite, value.values()))
    if isinstance(value, list):
        return all(map(all_finite, value))
    return not isinstance(value, float) or math.isfinite(value)


def complaint(result):
    """What is wrong with a run's metrics: JSON has null for what is no number, which only a metric with a note may be."""
    metrics, ledger = result["metrics"], result["ledger"]
    named = {note.split(":")[0] for note in metrics.get("notes", [])}
    lost = [key for key, value in metrics.items() if value is None and key not in named]
    lost += [key for key, values in result["series"].items() if None in values]
    lost += [key for key, value in ledger.items() if value is None]
    if lost:
        return f"no number: {', '.join(lost)}"
    moved = abs(ledger["water_in_kg"]) + abs(ledger["water_out_kg"]) + abs(ledger["water_stored_kg"]) + result["series"]["bound_water_g"][0] / 1000
    least = 1e-18  # kg; particles give their water in quanta
    return f"{ledger['water_imbalance_kg']} of {moved} kg are missing" if abs(ledger["water_imbalance_kg"]) > 1e-9 * moved + least else ""


def readable(bench, recording, before=None):
    """A recording is missing, as before, or can be measured: with what a run left beside it, alone, and where nobody can write."""
    path = bench.folder / recording
    if not path.exists() or path.read_bytes() == before:
        return
    whole = json.loads(bench.call("measure", recording, "-q", "--json").stdout)
    alone = bench.folder / "alone"
    alone.mkdir(exist_ok=True)
    shutil.copy(path, alone / recording)
    demand(json.loads(bench.call("measure", alone / recording, "-q", "--json").stdout)["series"]["time_s"][0] == whole["series"]["time_s"][0], "the copy begins later")
    if os.path.exists(f"{path}-wal"):
        shutil.copy(f"{path}-wal", alone)
    alone.chmod(0o555)
    both = bench.call("measure", alone / recording, "-q", "--json")
    alone.chmod(0o755)
    demand(json.loads(both.stdout)["series"] == whole["series"], "the copy of both files gives other numbers")


def designs(bench):
    seed, short = bench.random_design(0.05)
    shown = bench.call("plan", "design.hygro", "--fidelity", "draft", "--json", "-q")
    demand(all_finite(json.loads(shown.stdout)), f"design {seed}: the plan is not finite")
    run = ["simulate", "design.hygro", "--fidelity", "draft", "--backend", "cpu", "--json", "-q", *FEW, "--set", short, "-o", "run.hygrorec"]
    metrics = json.loads(bench.call(*run).stdout)
    demand(not complaint(metrics), f"design {seed}: {complaint(metrics)}")
    bench.call("measure", "run.hygrorec", "--json", "-q")


def killed(bench, arguments, longest, check):
    process = bench.start(*arguments)
    time.sleep(longest * bench.dice.random() ** 2)
    if "run.hygrorec" in arguments and (bench.folder / "run.hygrorec").exists() and bench.dice.random() < 0.3:
        bench.call("measure", "run.hygrorec", "-q")  # beside the run
    process.kill()
    process.communicate()
    check()


def kills(bench):
    what = bench.dice.choice(["simulate", "simulate again", "export", "import", "compare"])
    if what.startswith("simulate"):
        before = None
        if what == "simulate again":
            bench.call("simulate", EXAMPLE, *SHORT, *FEW, "-o", "run.hygrorec")
            before = (bench.folder / "run.hygrorec").read_bytes()
        run = ["simulate", EXAMPLE, *SHORT, "-o", "run.hygrorec"]
        killed(bench, run, 1.5, lambda: readable(bench, "run.hygrorec", before))
        if before is not None:
            demand((bench.folder / "run.hygrorec").exists(), "the older recording is gone")
        bench.call(*run, *FEW)
        demand(not list(bench.folder.glob(".*")), "the next run leaves the killed one's files")
    elif what == "export":
        run = ["export", EXAMPLE, "-q", "--size-mm", "8x8", "-o", "cloth.obj"]
        killed(bench, run, 1, lambda: None)
        for left in bench.folder.glob(".*"):
            os.utime(left, (0, 0))  # what was written within the last minute would stay: its process may run on another machine
        part = (bench.folder / "cloth.obj").read_bytes() if (bench.folder / "cloth.obj").exists() else None
        bench.call(*run)
        demand(part in (None, (bench.folder / "cloth.obj").read_bytes()), "a killed export left a part under its name")
        demand({path.name for path in bench.folder.iterdir()} == {"cloth.obj", "cloth.mtl"}, f"left: {[path.name for path in bench.folder.iterdir()]}")
    elif what == "import":
        (bench.folder / "drawing.txt").write_text("1100\n0110\n0011\n1001\n")
        bench.call("import", "drawing.txt", "-q", "-o", "cloth.hygro")
        killed(bench, ["import", "drawing.txt", "-q", "-o", "cloth.hygro"], 0.1, lambda: None)
        fabrics = len(json.loads((bench.folder / "cloth.hygro").read_text())["fabrics"])
        demand(fabrics in (1, 2), f"{fabrics} fabrics after a killed import")
    else:
        run = ["compare", THREE, "--experiment", "one drop", *SHORT, *FEW, "-o", "compared"]
        killed(bench, run, 3, lambda: None)
        table = bench.folder / "compared/comparison.json"
        demand(not table.exists() or "candidates" in json.loads(table.read_text()), "the table is not whole")
        bench.call(*run)


def full_disk(bench):
    small = bench.folder / "small"
    small.mkdir()
    kilobytes = bench.dice.randrange(100, 1600)
    apart = ["unshare", "--map-root-user", "--mount"]
    mount = f"mount -t tmpfs -o size={kilobytes}k none '{small}'"
    if subprocess.run([*apart, "sh", "-c", mount], capture_output=True).returncode != 0:
        raise Skipped("a small disk may not be mounted here")
    older = bench.dice.random() < 0.5
    script = f"""{mount} && cd '{small}' || exit 99
    {'"$0" simulate "$1" --fidelity draft -q --set "experiments[0].duration_s=0.02" --set fidelity.particles_per_droplet=100 -o run.hygrorec >/dev/null 2>&1' if older else ':'}
    older=no; [ ! -e run.hygrorec ] || {{ "$0" measure run.hygrorec -q >/dev/null 2>&1 && older=yes; }}
    "$0" simulate "$1" --fidelity draft -q --set "experiments[0].duration_s=0.5" -o run.hygrorec >/dev/null; code=$?
    left=nothing; [ ! -e run.hygrorec ] || {{ "$0" measure run.hygrorec -q >/dev/null 2>&1 && left=readable || left=unreadable; }}
    echo $older $code $left"""
    done = subprocess.run([*apart, "sh", "-c", script, str(bench.cli), str(EXAMPLE)], capture_output=True, text=True, timeout=120)
    older, code, left = done.stdout.split()
    state = f"on {kilobytes} kB: older {older}, exit {code}, left {left}: {done.stderr[-300:]}"
    demand(code in "01" and left != "unreadable" and (older == "no" or left == "readable"), state)
    demand(len(done.stderr.strip().splitlines()) <= 2, state)


def streams(bench):
    redirection = bench.dice.choice(["2>&-", "2>/dev/full", "<&-", ">/dev/full", ">&-", ">&- 2>&- <&-", "| true", "2>&1 | head -c 5 >/dev/null"])
    verb = bench.dice.choice(["check \"$1\"", "simulate \"$1\" --fidelity draft --set \"experiments[0].duration_s=0.01\" --set fidelity.particles_per_droplet=100 -o r.hygrorec",
                              "devices", "verify washburn", "presets", "export \"$1\" --size-mm 1x1 -o c.obj"])
    script = f'{{ "$0" {verb}; echo $? > code; }} {redirection}'
    subprocess.run(["sh", "-c", script, str(bench.cli), str(EXAMPLE)], cwd=bench.folder, timeout=120, capture_output=True)
    code = int((bench.folder / "code").read_text())
    full = redirection.startswith(">")
    demand(code in ((1,) if full else (0, 1) if "|" in redirection else (0,)), f"{verb} {redirection} ends with {code}")


def names(bench):
    pieces = ["\x1b[2J", "\x00", "\n", "../", "/", "\u202e", "<script>", "💧", "a" * 300, "..", "\r", "%s%n", "~", ".", " ", "'", '"', "\x7f", "\x9b31m", "-o"]
    design = json.loads(THREE.read_text())
    for i, fabric in enumerate(design["fabrics"]):
        fabric["name"] = "".join(bench.dice.choice(pieces) for _ in range(bench.dice.randint(1, 4))) + str(i)
    (bench.folder / "design.hygro").write_text(json.dumps(design))
    outside = set(bench.folder.parent.iterdir())
    done = bench.call("compare", "design.hygro", "--experiment", "one drop", *SHORT, *FEW, "-o", "compared", codes=(0, 3))
    breaks = any("\n" in f["name"] or "\r" in f["name"] for f in design["fabrics"])
    demand(not breaks or done.returncode == 3, "a name in several lines is taken")
    for text in (done.stdout, done.stderr):
        commands = [c for c in text.decode(errors="replace") if (ord(c) < 32 and c not in "\n\t") or 0x7F <= ord(c) < 0xA0 or 0x2028 <= ord(c) <= 0x202E or 0x2066 <= ord(c) <= 0x2069]
        demand(not commands, f"control codes {commands[:4]} reach the terminal")
    demand(set(bench.folder.parent.iterdir()) == outside and {p.name for p in bench.folder.iterdir()} <= {"design.hygro", "compared"}, "a file lies outside the folder")
    if done.returncode == 0:
        demand(all(path.is_file() for path in (bench.folder / "compared").iterdir()), "a name made a folder")


def writers(bench):
    if bench.dice.random() < 0.5:
        run = ["simulate", EXAMPLE, *SHORT, "-o", "same.hygrorec"]
        first = bench.start(*run)
        time.sleep(0.3 * bench.dice.random())
        second = bench.start(*run)
        codes = []
        for process in (first, second):
            process.communicate(timeout=120)
            codes.append(process.returncode)
        demand(sorted(codes) in ([0, 0], [0, 1]), f"two runs to one recording end with {codes}")
        readable(bench, "same.hygrorec")
        demand((bench.folder / "same.hygrorec").exists(), "no recording is there")
        return
    (bench.folder / "drawing.txt").write_text("10\n01\n")
    processes = [bench.start("import", "drawing.txt", "-q", "-o", "cloth.hygro") for _ in range(bench.dice.randint(2, 6))]
    for process in processes:
        process.communicate(timeout=60)
        demand(process.returncode == 0, f"an import beside others ends with {process.returncode}")
    fabrics = len(json.loads((bench.folder / "cloth.hygro").read_text())["fabrics"])
    demand(fabrics == len(processes), f"{fabrics} fabrics of {len(processes)} imports")


def crafted(bench):
    seed, garment = bench.dice.randrange(2**31), bench.dice.random() < 0.4
    kind = "garment recording" if garment else "recording"
    how = bench.tool("trial_files", kind.split()[0], seed, "crafted.hygrorec").strip()
    recording = bytearray((bench.folder / "crafted.hygrorec").read_bytes())
    if bench.dice.random() < 0.3:
        for _ in range(bench.dice.randint(1, 20)):
            recording[bench.dice.randrange(len(recording))] ^= 1 << bench.dice.randrange(8)
        (bench.folder / "crafted.hygrorec").write_bytes(recording)
        how += ", and bits flipped"
    most = 200 * 10**6 + 3 * len(recording)
    shown = ["garment", "map", "crafted.hygrorec", "-q", "-o", "map"] if garment else ["measure", "crafted.hygrorec", "-q", "--report", "r.html", "--map", "top", "-o", "m.png"]
    try:
        for arguments in (["measure", "crafted.hygrorec", "--json"], shown):
            bench.call_within(most, *arguments, codes=(0, 1, 3))
    except Broken as error:
        raise Broken(f"{kind} {seed} ({how}): {error}") from None


def threads(bench):
    seed, short = bench.random_design(0.02)
    prints = {}
    for count in (1, 2, bench.dice.choice([3, 5, 8, 64])):
        bench.call("simulate", "design.hygro", "--fidelity", "draft", "--backend", "cpu", "-q", *FEW, "--threads", count,
                   "--set", short, "-o", "run.hygrorec")
        prints[count] = bench.tool("fingerprint", "run.hygrorec")
    demand(len(set(prints.values())) == 1, f"design {seed}: the bytes differ with {list(prints)} threads")


CLASSES = {"random designs": designs, "kills": kills, "full disk": full_disk, "streams": streams, "hostile names": names,
           "several writers": writers, "crafted recordings": crafted, "thread counts": threads}


def try_class(name, trial, seconds, seed, build, keep):
    end, tried, broken, skipped = time.monotonic() + seconds, 0, [], ""
    while time.monotonic() < end or tried == 0:
        number = seed + tried
        folder = pathlib.Path(tempfile.mkdtemp(dir=keep, prefix=f"{name.replace(' ', '-')}-{number}-"))
        tried += 1
        try:
            trial(Bench(build, folder, random.Random(f"{name} {number}")))
            shutil.rmtree(folder)
        except Skipped as reason:
            shutil.rmtree(folder)
            return tried - 1, broken, str(reason)
        except Exception as error:  # a trial that fails by itself counts as broken, too
            broken.append(f"{name}, --seed {number}: {error} ({folder})")
    return tried, broken, skipped


def main():
    asked = argparse.ArgumentParser()
    asked.add_argument("--minutes", type=float, default=4)
    asked.add_argument("--seed", type=int, default=1)
    asked.add_argument("--only", choices=CLASSES)
    asked.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    options = asked.parse_args()
    build = options.build.resolve()
    keep = pathlib.Path(tempfile.mkdtemp(prefix="hygroloom-reliability-"))
    classes = {options.only: CLASSES[options.only]} if options.only else CLASSES
    faults = []
    print(f"{'class':<20} {'tried':>6} {'held':>6} {'broken':>6}")
    for name, trial in classes.items():
        tried, broken, skipped = try_class(name, trial, 60 * options.minutes / len(classes), options.seed, build, keep)
        print(f"{name:<20} {tried:>6} {tried - len(broken):>6} {len(broken):>6}{'  skipped: ' + skipped if skipped else ''}", flush=True)
        faults += broken
    if not faults:
        shutil.rmtree(keep)
    print("\n".join(faults))
    return 1 if faults else 0


sys.exit(main())
