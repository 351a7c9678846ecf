#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Changes one input of a cloth at a time and says whether drop, strip and drying answer as textile practice expects.

Two plain cloths: A cotton of 20 tex, B polyester filament of 167 dtex. Each row prints the numbers of the base and of the changed cloth
and a verdict: right (the sign that is expected, or the bounds that the row names); blind (it moves by less than half a per cent); weak
(the right sign, less than expected, where a row says how much); wrong. Signs and bounds are practice's, not measurements of these cloths.

    tests/benchmarks/one_at_a_time.py build/release/bin/hygroloom-cli [--fidelity live] [--rows 1,2] [--jobs 2]
"""
import argparse
import concurrent.futures
import copy
import json
import math
import os
import subprocess
import sys
import tempfile

A = {"material": "cotton", "linear_density_tex": 20, "packing_factor": 0.55, "twist_per_m": 850}
B = {"material": "polyester", "linear_density_tex": 16.7, "filament_count": 48, "twist_per_m": 0}
SIGNS = {"up": 1, "down": -1}


def cloth(yarn, ends, picks, angle):
    return {"name": "cloth", "warp": dict(yarn), "weft": dict(yarn), "weave": {"pattern": "plain"},
            "ends_per_cm": ends, "picks_per_cm": picks, "contact_angle_deg": angle}


BASES = {"A": cloth(A, 24, 22, 40), "B": cloth(B, 30, 26, 45)}


def of(base, yarn=None, **fabric):
    """The base with other values of both yarns and of the fabric."""
    changed = copy.deepcopy(BASES[base])
    materials = fabric.pop("materials", [])
    for key in ("warp", "weft"):
        changed[key].update(yarn or {})
    changed.update(fabric)
    return {**changed, "materials": materials} if materials else changed


def project_of(fabric, experiments):
    fabric = dict(fabric)
    materials = fabric.pop("materials", [])
    return {"format": "hygroloom-project", "version": 1, "materials": materials, "fabrics": [fabric], "experiments": experiments}


def sett(base, factor):
    return of(base, ends_per_cm=BASES[base]["ends_per_cm"] * factor, picks_per_cm=BASES[base]["picks_per_cm"] * factor)


class Runs:
    """Runs of the program by what they need, each once."""

    def __init__(self, cli, fidelity):
        self.cli, self.fidelity, self.kept = cli, fidelity, {}

    def metrics(self, fabric, experiment):
        key = json.dumps([fabric, experiment], sort_keys=True)
        if key not in self.kept:
            self.kept[key] = self.run(fabric, experiment)
        return self.kept[key]

    def run(self, fabric, experiment):
        project = project_of(fabric, [experiment])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "one.hygro")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(project, file)
            done = subprocess.run([self.cli, "simulate", path, "--fidelity", self.fidelity, "--threads", "1", "--json", "-q"],
                                  capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr.strip() else "failed")
        return json.loads(done.stdout)["metrics"]


CLIMATE = {"temperature_c": 21, "relative_humidity": 0.65, "air_speed_m_s": 1.0}


def drop(volume=15, **climate):
    return {"name": "drop", "type": "droplet", "climate": {**CLIMATE, **climate}, "liquid": "water", "sample_mm": [60, 60],
            "duration_s": 60, "droplets": [{"volume_ul": volume, "time_s": 0, "at_mm": [0, 0], "height_mm": 2, "speed_m_s": 0}]}


def strip(direction="warp", seconds=60, **climate):
    return {"name": "strip", "type": "vertical_wicking", "climate": {**CLIMATE, **climate}, "liquid": "water",
            "strip_mm": [5, 200], "immersion_mm": 10, "duration_s": seconds, "direction": direction}


def drying(water=100, **climate):
    return {"name": "drying", "type": "drying", "climate": {**CLIMATE, **climate}, "liquid": "water", "sample_mm": [20, 20],
            "duration_s": 14400, "initial_water_g_m2": water}


def rise(runs, fabric, direction="warp", seconds=60, **climate):
    return runs.metrics(fabric, strip(direction, seconds, **climate))["wick_height_mm"]


def absorbed(runs, fabric, volume=15, **climate):
    found = runs.metrics(fabric, drop(volume, **climate))["absorbency_time_s"]
    return 1e9 if found is None else found


def radius(runs, fabric, volume=15):
    return runs.metrics(fabric, drop(volume))["equal_area_radius_mm"]


def dry_time(runs, fabric, water=100, **climate):
    return runs.metrics(fabric, drying(water, **climate))["time_to_dry_s"]


def sign(base, changed, expected, least=0.005, wanted=0.0):
    """expected: up, down; wanted: by how much at least, of the base's number."""
    if base >= 1e9 and changed >= 1e9:
        return "blind"
    change = (changed - base) / base
    if abs(change) < least:
        return "blind"
    if (change > 0) != (SIGNS[expected] > 0):
        return "wrong"
    return "right" if abs(change) >= wanted else "weak"


def equal(base, changed, within):
    return "right" if abs(changed / base - 1) <= within else "wrong"


def worst(*verdicts):
    return max(verdicts, key=["right", "weak", "blind", "wrong"].index)


def rows():
    a, b = BASES["A"], BASES["B"]

    def sett_up(r):
        s, d = (rise(r, a), rise(r, sett("A", 1.2))), (radius(r, a), radius(r, sett("A", 1.2)))
        return s + d, worst(sign(*s, "down"), sign(*d, "down"))

    def compare(number, changed, expected):
        def of_runs(r):
            found = number(r, a), number(r, changed)
            return found, sign(*found, expected)
        return of_runs

    def sett_dries(r):
        found = tuple(dry_time(r, c) for c in (sett("A", 0.8), a, sett("A", 1.2)))
        return found, equal(min(found), max(found), 0.15)

    def water_dries(r):
        found = dry_time(r, a), dry_time(r, a, 200)
        ratio = found[1] / found[0]
        return found, "right" if 1.85 <= ratio <= 2.15 else "weak" if ratio > 1 else "wrong"

    def twist(r):
        low, high = of("A", {"twist_per_m": 400}), of("A", {"twist_per_m": 1300})
        s, d = (rise(r, low), rise(r, high)), (absorbed(r, low), absorbed(r, high))
        return s + d, worst(sign(*s, "down", wanted=0.1), sign(*d, "up"))

    def packing(r):
        low, high = of("A", {"packing_factor": 0.48}), of("A", {"packing_factor": 0.62})
        s, d = (rise(r, low), rise(r, high)), (radius(r, low), radius(r, high))
        return s + d, worst(sign(*s, "down"), sign(*d, "up"))

    def weaves(r):
        plain = rise(r, a)
        others = [rise(r, of("A", weave={"pattern": p})) for p in ("twill 2/2", "basket 2/2", "satin 5/2")]
        return (plain, *others), worst(*(sign(plain, o, "up") for o in others))

    def angles(r):
        cloths = [of("A", contact_angle_deg=t) for t in (20, 40, 55, 62, 70)]
        s, d = [rise(r, c) for c in cloths], [absorbed(r, c) for c in cloths]
        falls = all(y < x for x, y in zip(s, s[1:])) and all(y > x for x, y in zip(d, d[1:]))
        return (*s, *d), "right" if falls and d[4] >= 10 * d[1] else "weak" if falls else "wrong"

    def faces(r):
        plain, found, fine = (rise(r, a), absorbed(r, a)), [], True
        for face, angle in (("face", 110), ("back", 110), ("face", 70), ("back", 70)):
            finished = of("A", **{f"finish_{face}": angle})
            found.append(rise(r, finished))
            fine = fine and found[-1] >= 0.7 * plain[0]
            if face == "back" and angle == 110:
                found.append(absorbed(r, finished))
                fine = fine and abs(found[-1] / plain[1] - 1) <= 0.2
        return (*plain, *found), "right" if fine else "wrong"

    def thicker(r):
        thick = of("A", thickness_mm=1.4 * thickness(r.cli, a))
        d, s = (radius(r, a), radius(r, thick)), (rise(r, a), rise(r, thick))
        return d + s, worst(sign(*d, "down"), "right" if abs(s[1] / s[0] - 1) > 0.005 else "blind")

    def thinner(r):
        cloth_t = of("B", thickness_mm=0.8 * thickness(r.cli, b))
        s, d = (rise(r, b), rise(r, cloth_t)), (absorbed(r, b), absorbed(r, cloth_t))
        return s + d, "right" if abs(s[1] / s[0] - 1) < 0.35 and d[1] < 1e9 and 1 <= d[1] / d[0] < 5 else "wrong"

    def uneven(r):
        even, varied = of("A", {"irregularity_cv": 0.0}), of("A", {"irregularity_cv": 0.15})
        s, d = (rise(r, even), rise(r, varied)), (radius(r, even), radius(r, varied))
        return s + d, worst(equal(*s, 0.1), equal(*d, 0.1))

    def plied(r):
        two = of("A", {"plies": 2})
        s = rise(r, a), rise(r, two)
        return s, sign(*s, "down")

    def hairy(r):
        hairs = of("A", flyaway={"loop_density_per_mm": 6, "hair_density_per_mm": 10, "loop_height_mm": 0.1, "hair_length_mm": 0.4})
        d = absorbed(r, a), absorbed(r, hairs)
        return d, sign(*d, "up")

    def filaments(r):
        found = [rise(r, of("B", {"filament_count": n})) for n in (24, 48, 96, 288)]
        return found, "right" if all(y < x for x, y in zip(found, found[1:])) else "wrong"  # coarser wicks faster

    def trilobal(r):
        fibre = {"name": "lobes", "based_on": "polyester", "cross_section": "trilobal"}
        s = rise(r, b), rise(r, of("B", {"material": "lobes"}, materials=[fibre]))
        return s, sign(*s, "up")

    def raw_packing(r):
        found = [absorbed(r, of("B", {"packing_factor": p}, contact_angle_deg=75)) for p in (0.5, 0.7)]
        return found, "right" if min(found) > 60 else "weak" if min(found) > 10 else "wrong"

    def warm(r):
        s = rise(r, a), rise(r, a, temperature_c=35)
        d = absorbed(r, a), absorbed(r, a, temperature_c=35)
        t = dry_time(r, a), dry_time(r, a, temperature_c=35)
        return s + d + t, worst(sign(*s, "up"), sign(*d, "down"), sign(*t, "down"))

    def drier(r):
        t = dry_time(r, a), dry_time(r, a, relative_humidity=0.4)
        return t, sign(*t, "down")

    def dry_air(r):
        s = rise(r, a), rise(r, a, relative_humidity=0.2, air_speed_m_s=2.0)
        return s, worst(sign(*s, "down"), equal(*s, 0.1))

    def wind(r):
        found = [dry_time(r, a, air_speed_m_s=v) for v in (0.0, 1.0, 2.0)]
        return found, "right" if found[0] > found[1] > found[2] else "wrong"

    def volume(r):
        d = [absorbed(r, a, v) for v in (5, 15, 30)]
        s = [radius(r, a, v) for v in (5, 15, 30)]
        power = [math.log(y[2] / y[0]) / math.log(6) for y in (d, [x * x for x in s])]
        return (*d, *s, *power), "right" if 0.7 <= power[0] <= 1.5 and 0.8 <= power[1] <= 1.2 else "wrong"

    def balanced(r):
        same = of("A", ends_per_cm=23, picks_per_cm=23)
        s = rise(r, same), rise(r, same, "weft")
        return s, equal(*s, 0.03)

    return [
        (1, "sett + 20 %: strip and stain smaller", sett_up),
        (2, "sett - 20 %: strip higher", compare(rise, sett("A", 0.8), "up")),
        (3, "ends + 25 %: warp strip lower", compare(rise, of("A", ends_per_cm=30), "down")),
        (4, "sett - 20, 0, + 20 %: 100 g/m2 dry in equal times", sett_dries),
        (5, "200 for 100 g/m2: twice the time to dry", water_dries),
        (6, "twist 400 to 1300 /m: strip lower by a tenth, drop slower", twist),
        (7, "packing .48 to .62: strip lower, stain larger", packing),
        (8, "30 for 20 tex: strip higher", compare(rise, of("A", {"linear_density_tex": 30}), "up")),
        (9, "twill, basket, satin for plain: strip higher", weaves),
        (10, "20 to 70 degrees: strip lower, drop slower by ten times", angles),
        (11, "finish of a face, 110 and 70 degrees: strip at least .7", faces),
        (12, "thickness + 40 %: smaller stain, another strip", thicker),
        (13, "thickness of B - 20 %: moderate", thinner),
        (14, "unevenness 0 to 15 %: small", uneven),
        (15, "two plies for one: strip lower", plied),
        (16, "hairs and loops: drop slower", hairy),
        (17, "24 to 288 filaments: coarser strip higher", filaments),
        (18, "trilobal for round: strip higher", trilobal),
        (19, "75 degrees, packing .5 and .7: both stand for a minute", raw_packing),
        (20, "35 for 21 C: strip higher, drop and drying faster", warm),
        (21, "40 for 65 % humidity: dries faster", drier),
        (22, "20 % humidity and wind: strip hardly lower", dry_air),
        (23, "air at 0, 1, 2 m/s: dries faster", wind),
        (24, "5, 15, 30 ul: time as V^.7 to V^1.5, area as V", volume),
        (25, "warp and weft strip of a balanced cloth: equal", balanced),
    ]


def thickness(cli, fabric):
    """mm, as computed."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "one.hygro")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(project_of(fabric, []), file)
        done = subprocess.run([cli, "check", path, "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["fabrics"][0]["derived"]["thickness_mm"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cli")
    parser.add_argument("--fidelity", default="live")
    parser.add_argument("--rows", default="")
    parser.add_argument("--jobs", type=int, default=1)
    asked = parser.parse_args()
    runs = Runs(asked.cli, asked.fidelity)
    wanted = [int(n) for n in asked.rows.split(",") if n]
    chosen = [row for row in rows() if not wanted or row[0] in wanted]

    def judge(row):
        try:
            numbers, verdict = row[2](runs)
            return row, " ".join("never" if n >= 1e9 else f"{n:.4g}" for n in numbers), verdict
        except (RuntimeError, KeyError, TypeError, ValueError, ZeroDivisionError) as error:
            return row, repr(error), "failed"

    count = {}
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for row, numbers, verdict in pool.map(judge, chosen):
            count[verdict] = count.get(verdict, 0) + 1
            print(f"{row[0]:3} {verdict:6} {row[1]}: {numbers}", flush=True)
    print(", ".join(f"{verdict} {n}" for verdict, n in sorted(count.items())))
    return 1 if "failed" in count else 0


if __name__ == "__main__":
    sys.exit(main())
