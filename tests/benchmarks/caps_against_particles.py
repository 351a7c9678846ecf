#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Drops on shipped fabrics, once as caps and once as particles: how far radius, contents and absorbency time are apart.

    caps_against_particles.py build/release/bin/hygroloom-cli [--scenes 20] [--jobs 8] [--fidelity standard]

Scenes are drawn by a seed: a fabric, a volume, a height. Those count in which the plan allows a cap and the drop is absorbed before the end.
Each runs as given and once more without hysteresis of its contact angles, which particles do not have. Prints a table in Markdown."""
import argparse
import concurrent.futures
import json
import pathlib
import random
import statistics
import subprocess
import tempfile

FIBRES = pathlib.Path(__file__).parents[2] / "resources" / "materials" / "fibres.json"
NUMBERS = ("radius", "liquid", "bound", "absorbency")


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}: {done.stderr}")
    return done.stdout


def drawn(cli, folder, seed):
    """A project with one drop on a fabric of the library; its words for the table."""
    chance = random.Random(seed)
    names = [preset["name"] for preset in json.loads(run([cli, "presets", "--json"]))["presets"]]
    name = chance.choice([n for n in names if n != "Textile F"])  # by which caps were set up
    volume, height = round(10 ** chance.uniform(0, 1.48), 1), round(chance.uniform(0.2, 3), 1)
    path = folder / f"{seed}.hygro"
    run([cli, "presets", name, "-q", "-o", path])
    project = json.loads(path.read_text())
    project["experiments"] = [{"type": "droplet", "name": "drop", "sample_mm": [30, 30], "duration_s": 2.0,
                               "droplets": [{"volume_ul": volume, "height_mm": height, "at_mm": [0, 0], "time_s": 0, "speed_m_s": 0}]}]
    path.write_text(json.dumps(project))
    return path, f"{name}, {volume} µl from {height} mm"


def without_hysteresis(path):
    project = json.loads(path.read_text())
    changed = {}
    for fabric in project["fabrics"]:
        for yarn in (fabric["warp"], fabric["weft"]):
            yarn["material"] = changed.setdefault(yarn["material"], f"{yarn['material']}, one angle")
    shipped = {fibre["name"]: fibre["contact_angle_deg"]["value"] for fibre in json.loads(FIBRES.read_text())["materials"]}
    own = {material["name"]: material for material in project.get("materials", [])}
    for name, new in changed.items():
        material = {**own.get(name, {"based_on": name}), "name": new}
        material["receding_angle_deg"] = material.get("contact_angle_deg", shipped.get(material["based_on"]))
        project.setdefault("materials", []).append(material)
    other = path.with_suffix(".one-angle.hygro")
    other.write_text(json.dumps(project))
    return other


def numbers(cli, path, liquid, fidelity):
    metrics = json.loads(run([cli, "simulate", path, "--json", "-q", "--backend", "cpu", "--threads", "2", "--fidelity", fidelity,
                              "--set", f"fidelity.free_liquid={liquid}"]))
    series = metrics["series"]
    return dict(zip(NUMBERS, (metrics["metrics"]["maximum_wetted_radius_top_mm"], series["yarn_water_g"][-1],
                              series["bound_water_g"][-1] - series["bound_water_g"][0], metrics["metrics"]["absorbency_time_s"])))


def allowed(cli, path):
    plan = json.loads(run([cli, "plan", path, "--json", "--fidelity", "live"]))
    return any(part["name"] == "cap" and part["on"] for part in plan["parts"])


def scene(cli, folder, seed, fidelity):
    path, words = drawn(cli, folder, seed)
    if not allowed(cli, path):
        return None
    row = [words]
    for variant in (path, without_hysteresis(path)):
        cap = numbers(cli, variant, "cap", fidelity)
        if cap["absorbency"] is None:
            return None
        particles = numbers(cli, variant, "particles", fidelity)
        if particles["absorbency"] is None:
            return None
        row.append({key: cap[key] / particles[key] - 1 for key in NUMBERS})
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli", type=pathlib.Path)
    parser.add_argument("--scenes", type=int, default=20)
    parser.add_argument("--jobs", type=int, default=1, help="scenes at once, two threads each")
    parser.add_argument("--fidelity", default="standard")
    asked = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for first in range(0, 10 * asked.scenes, asked.jobs):
            some = [pool.submit(scene, asked.cli, pathlib.Path(folder), first + k, asked.fidelity) for k in range(asked.jobs)]
            rows += [row.result() for row in some if row.result()]
            if len(rows) >= asked.scenes:
                break
    rows = rows[:asked.scenes]
    print("| scene | as given: " + ", ".join(NUMBERS) + " | one contact angle |\n| --- | --- | --- |")
    words = lambda apart: ", ".join(f"{100 * apart[key]:+.1f}" for key in NUMBERS)
    for name, given, one_angle in rows:
        print(f"| {name} | {words(given)} | {words(one_angle)} |")
    for title, pick in (("median", statistics.median), ("largest", max)):
        sizes = [{key: pick(abs(row[k][key]) for row in rows) for key in NUMBERS} for k in (1, 2)]
        print(f"| {title} of {len(rows)}, % | {words(sizes[0])} | {words(sizes[1])} |".replace("+", ""))


if __name__ == "__main__":
    main()
