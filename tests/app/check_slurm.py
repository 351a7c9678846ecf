#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""A study on a real Slurm of one node, which this starts as root, without systemd, with keys, ports and folders of its own: 64 points in a job array,
one task killed in the middle, submitted again; then the table has the bytes of a run that was never stopped, but for times and devices.
Run by ctest: check_slurm.py <root of the source> <hygroloom-cli>"""
import contextlib
import csv
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo"]
TASKS = 4

root, cli = pathlib.Path(sys.argv[1]), sys.argv[2]
os.environ["PATH"] += ":/usr/sbin:/sbin"
missing = [program for program in PROGRAMS if not shutil.which(program)]
if missing or os.geteuid() != 0:
    print(f"SKIP   : {', '.join(missing)} not here (Debian: slurm-wlm, munge)" if missing else "SKIP   : starting Slurm needs root")
    sys.exit(SKIPPED)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(what, condition, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.1)
    sys.exit(f"{what}: not within {seconds} s")


def said(*words, ok=(0,)):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300)
    if ok and done.returncode not in ok:
        sys.exit(f"{' '.join(map(str, words))}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done


@contextlib.contextmanager
def slurm(folder):
    """munged, slurmctld and slurmd, until the end."""
    (folder / "key").write_bytes(os.urandom(1024))
    (folder / "key").chmod(0o400)
    for name in ("state", "spool"):
        (folder / name).mkdir()
    conf = folder / "slurm.conf"
    conf.write_text(
        f"""ClusterName=test
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
SchedulerParameters=sched_interval=2,batch_sched_delay=0
KillWait=2
NodeName=localhost NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=test Nodes=localhost Default=YES MaxTime=INFINITE State=UP
"""
    )
    os.environ["SLURM_CONF"] = str(conf)
    daemons = []

    def start(*words):
        daemons.append(subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=folder))

    try:
        start("munged", "--foreground", "--force", f"--key-file={folder}/key", f"--socket={folder}/munge.socket", f"--pid-file={folder}/munge.pid",
              f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed")  # fmt: skip
        wait_for("munged", (folder / "munge.socket").exists)
        start("slurmctld", "-D", "-f", str(conf))
        start("slurmd", "-D", "-f", str(conf), "-N", "localhost")
        wait_for("the node", lambda: "idle" in said("sinfo", "--noheader", "--format=%T", ok=()).stdout)
        yield
    finally:
        for daemon in reversed(daemons):
            daemon.send_signal(signal.SIGTERM)
        for daemon in daemons:
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()


def process_of_task(number):
    """Of the program, not of the shell that started it."""
    for entry in pathlib.Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if entry.name.isdigit() and os.path.samefile(entry / "exe", cli) and f"SLURM_ARRAY_TASK_ID={number}".encode() in (entry / "environ").read_bytes().split(b"\0"):
                return int(entry.name)
    sys.exit(f"task {number} has no process")


def table(folder):
    """The rows without what differs between machines and moments."""
    with open(folder / "results.csv", newline="") as file:
        return [[cell for name, cell in row.items() if name not in ("wall_s", "device")] for row in csv.DictReader(file)]


def is_on(job):
    return bool(said("squeue", "--noheader", "--jobs", job, ok=()).stdout)


def main(folder):
    project = folder / "drop.hygro"
    design = json.loads((root / "resources/examples/textile-F.hygro").read_text())
    design["experiments"] = [{**e, "duration_s": 0.3} for e in design["experiments"] if e["name"] == "one drop"]
    project.write_text(json.dumps(design))
    study = folder / "study.json"
    study.write_text(
        json.dumps(
            {
                "format": "hygroloom-study", "version": 1, "fidelity": "live", "design": {"type": "latin_hypercube", "points": 64},
                "factors": [{"path": "fabrics[0].ends_per_cm", "low": 24, "high": 36}, {"path": "fabrics[0].contact_angle_deg", "low": 20, "high": 60}],
            }
        )
    )  # fmt: skip
    local, out = folder / "local", folder / "50% on a cluster; $(true)"
    said(cli, "sweep", project, "--study", study, "-o", local, "--quiet")

    submitted = json.loads(said(cli, "sweep", project, "--study", study, "-o", out, "--slurm", "--tasks", TASKS, "--sbatch", "--time=10", "--json").stdout)
    assert submitted["submitted"] == TASKS, submitted
    part = out / "parts" / f"000001-of-{TASKS:06}.csv"
    wait_for("the first task's second row", lambda: part.exists() and part.read_text().count("\n") >= 3)
    os.kill(process_of_task(1), signal.SIGKILL)  # at once: scancel takes as long as the task
    wait_for("the end of the array", lambda: not is_on(submitted["job"]), 300)
    assert (out / "slurm" / "task-2.log").exists()

    rows = part.read_text().count("\n") - 1
    assert 2 <= rows < 64 / TASKS, f"the killed task has {rows} rows"
    merged = said(cli, "sweep", "-o", out, "--merge", "--json", ok=(1,))
    missing = json.loads(merged.stdout)["missing"]
    assert missing == 64 // TASKS - rows, merged.stdout
    resumed = json.loads(said(cli, "sweep", "-o", out, "--slurm", "--resume", "--tasks", TASKS, "--json").stdout)
    assert resumed["submitted"] == 1, resumed
    wait_for("the rest", lambda: not is_on(resumed["job"]), 300)
    said(cli, "sweep", "-o", out, "--merge")
    differ = [(a, b) for a, b in zip(table(local), table(out)) if a != b]
    assert not differ and len(table(local)) == len(table(out)), f"the tables differ: {differ[:3]}"
    print(f"64 points in {TASKS} tasks; the killed one had {rows} of {64 // TASKS} rows; after it went on the tables are the same")


with tempfile.TemporaryDirectory(prefix="hygroloom-slurm-") as name, slurm(pathlib.Path(name)):
    main(pathlib.Path(name))
