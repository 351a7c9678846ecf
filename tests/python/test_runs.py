# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Runs: the numbers are those of the command line, whatever thread they come from."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import threading
import time

import pandas
import pytest

import hygroloom


def without_times(metrics):
    """Of a metrics file: what is the same whenever and however fast it runs."""
    return {key: metrics[key] for key in ("metrics", "intervals", "series", "ledger")}


def test_numbers_are_those_of_the_command_line(small, cli, tmp_path):
    project = small.save(tmp_path / "small.hygro")
    options = ("--fidelity", "live", "--seed", "7", "--threads", "1")
    by_cli = cli("simulate", project, *options, "-o", tmp_path / "cli.hygrorec")
    run = hygroloom.simulate(project, fidelity="live", seed=7, threads=1, recording=tmp_path / "own.hygrorec")
    assert without_times(run.json) == without_times(by_cli)
    assert run.provenance["seed"] == 7 and run.provenance["fidelity"] == "live"
    for file in (tmp_path / "own.hygrorec", tmp_path / "cli.hygrorec"):
        assert without_times(hygroloom.measure(file).json) == without_times(cli("measure", tmp_path / "own.hygrorec"))
    other = hygroloom.simulate(small, fidelity="live", seed=7, threads=2, recording=False, physics={"heat": False}, knobs={"free_liquid": "cap"})
    asked = ("--physics", "heat=off", "--set", "fidelity.free_liquid=cap")
    assert without_times(other.json) == without_times(cli("simulate", project, *options, *asked))


def test_series_sum_up_to_the_ledger(small):
    run = hygroloom.simulate(small, fidelity="live", recording=False)
    last, ledger = run.series.iloc[-1], run.ledger
    assert ledger["water_in_kg"] == pytest.approx(2e-6, rel=0.01)
    held = last.free_water_g + last.yarn_water_g + last.bound_water_g
    started = run.series.iloc[0]
    gained = held - started.free_water_g - started.yarn_water_g - started.bound_water_g
    delivered_since = 1e3 * ledger["water_in_kg"] - started.free_water_g
    gone = last.evaporated_g + last.dripped_g
    vapour = 2e-6  # g, in the pores
    assert gained + gone == pytest.approx(delivered_since, abs=vapour)
    assert abs(ledger["water_imbalance_kg"]) < 1e-9 * ledger["water_in_kg"]


def test_a_run_has_tables_and_a_recording(small, tmp_path):
    run = hygroloom.simulate(small, fidelity="live")
    assert isinstance(run.series, pandas.DataFrame) and run.series.index.name == "time_s"
    radius = run.table.loc["maximum_wetted_radius_top_mm"]
    assert radius.value == run.metrics["maximum_wetted_radius_top_mm"] and radius.unit == "mm" and radius.low <= radius.value <= radius.high
    assert set(run.metrics) >= set(run.table.index)
    kept = run.save(tmp_path / "kept.hygrorec")
    assert without_times(hygroloom.measure(kept).json) == without_times(run.json)
    temporary = run.recording
    assert temporary.exists() and run.dataset.sizes["time"] == len(run.series)
    del run
    assert not temporary.parent.exists() and kept.exists()
    bare = hygroloom.simulate(small, fidelity="live", recording=False)
    for use in (lambda: bare.dataset, lambda: bare.save(tmp_path / "none.hygrorec")):
        with pytest.raises(hygroloom.Error, match="not recorded"):
            use()
    with pytest.raises(hygroloom.Error, match="panels"):
        bare.panels


def test_progress_is_told_and_may_end_the_run(small):
    small.set("experiments[0].duration_s", 30)
    told = []

    def enough(share, what):
        told.append((share, what))
        raise RuntimeError("enough")

    begin = time.monotonic()
    with pytest.raises(RuntimeError, match="enough"):
        hygroloom.simulate(small, fidelity="standard", progress=enough)
    assert time.monotonic() - begin < 6  # rooms between yarns are drawn first, which does not end early
    assert 0 <= told[0][0] <= 1 and told[0][1].endswith("of 30.00 s") and len(told) == 1


def test_two_threads_run_side_by_side(small):
    alone = [without_times(hygroloom.simulate(small, fidelity="live", seed=seed).json) for seed in (1, 2)]
    runs, steps = {}, []

    def work(seed):
        runs[seed] = hygroloom.simulate(small, fidelity="live", seed=seed)

    threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        steps.append(time.monotonic())
        time.sleep(0.002)
    assert [without_times(runs[seed].json) for seed in (1, 2)] == alone
    assert max(b - a for a, b in zip(steps, steps[1:])) < 0.3  # this thread went on meanwhile


def limit_s():
    """For Ctrl-C; more where the machine has more to do than it can."""
    return 0.3 if os.getloadavg()[0] < os.cpu_count() else 0.8


def interrupted_after(child, begin):
    """Sends Ctrl-C; s, until the child saw it."""
    begin()
    sent = time.clock_gettime(time.CLOCK_MONOTONIC)
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=60)
    said = [line for line in out.splitlines() if line.startswith("interrupted")]
    assert child.returncode == -signal.SIGINT and "KeyboardInterrupt" in err
    return float(said[0].split()[1]) - sent


def child_of(code, *arguments):
    command = [sys.executable, "-c", textwrap.dedent(code), *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


CHILD = """
    import sys, time
    import hygroloom
    project = hygroloom.Project.open(sys.argv[1])
    project.set("experiments[0].duration_s", 600)
    def told(share, what):
        print("running", flush=True)
    try:
        hygroloom.simulate(project, fidelity="standard", recording=sys.argv[2], progress=told)
    except KeyboardInterrupt:
        print("interrupted", time.clock_gettime(time.CLOCK_MONOTONIC), flush=True)
        raise
"""


def test_ctrl_c_ends_a_run_at_once(examples, tmp_path):
    recording = tmp_path / "cut.hygrorec"
    child = child_of(CHILD, examples / "one-drop-on-cotton.hygro", recording)

    def begin():
        assert child.stdout.readline() == "running\n"
        while not recording.exists():
            time.sleep(0.01)

    assert interrupted_after(child, begin) < limit_s()
    cut = hygroloom.measure(recording)
    assert not cut.finished and cut.end_s < 600


SLOW_START = """
    import sys, time
    import hygroloom
    project = hygroloom.Project.open(sys.argv[1]).set("experiments.drying.sample_mm", [120, 120])
    print("begins", flush=True)
    try:
        hygroloom.simulate(project, experiment="drying", fidelity="reference", recording=False)
    except KeyboardInterrupt:
        print("interrupted", time.clock_gettime(time.CLOCK_MONOTONIC), flush=True)
        raise
"""


def test_ctrl_c_is_obeyed_before_the_first_step(examples):
    """What builds a scene asks nobody; it goes on by itself until the process ends."""
    child = child_of(SLOW_START, examples / "laboratory.hygro")
    assert interrupted_after(child, lambda: (child.stdout.readline(), time.sleep(0.1))) < limit_s()


def test_wrong_arguments_are_named(small, tmp_path):
    cases = [
        (dict(fabric="Cotton plian"), hygroloom.Error, "no fabric \"Cotton plian\".* It has "),
        (dict(experiment="two drops"), hygroloom.Error, "no experiment \"two drops\""),
        (dict(fabric=3), TypeError, "fabric: This must be a text; given is 3"),
        (dict(fidelity="fine"), ValueError, "fidelity: This must be live, draft, standard or reference; given is 'fine'"),
        (dict(fidelity=["live"]), ValueError, "fidelity: "),
        (dict(backend="opencl"), ValueError, "backend: This must be auto, cpu or cuda"),
        (dict(seed=-1), ValueError, "seed: .* from 0 to 18446744073709551615; given is -1"),
        (dict(seed=2**64), ValueError, "seed: "),
        (dict(seed=1.5), TypeError, "seed: "),
        (dict(threads=5000), ValueError, "threads: .* to 1024"),
        (dict(physics="warmth=off"), hygroloom.Error, "warmth"),
        (dict(physics=3), TypeError, "physics: "),
        (dict(knobs={"fibre_shels": 3}), hygroloom.Error, "fibre_shels"),
        (dict(knobs={"fibre_shells": 1e9}), hygroloom.Error, "fibre_shells"),
        (dict(knobs=[1]), TypeError, "knobs: This must be a dictionary"),
        (dict(recording=3), TypeError, "recording: This must be a path"),
        (dict(recording=tmp_path / "no folder" / "a.hygrorec"), hygroloom.FileError, "no folder"),
        (dict(progress=3), TypeError, "progress: This must be a function"),
        (dict(cell_mm=3), hygroloom.Error, "type wear"),
        (dict(cell_mm="3"), TypeError, "cell_mm: "),
    ]
    for arguments, error, words in cases:
        with pytest.raises(error, match=words):
            hygroloom.simulate(small, **{"fidelity": "live", **arguments})
    with pytest.raises(TypeError, match="project: This must be a Project"):
        hygroloom.simulate(3)
    small.set("experiments", small.get("experiments") + [{**small.get("experiments[0]"), "name": "second"}])
    with pytest.raises(hygroloom.Error, match="several experiments; name one with experiment=: \".*\", \"second\""):
        hygroloom.simulate(small)


def test_verify_gives_the_command_lines_numbers(cli):
    own = hygroloom.verify("washburn", radius_um=20, contact_angle_deg=45)
    by_cli = cli("verify", "washburn", "--set", "radius_um=20", "--set", "contact_angle_deg=45")
    assert own["results"] == by_cli["results"] and own["parameters"]["radius_um"] == 20
    assert own["results"][0]["pass"]
    assert "washburn" in hygroloom.verify_cases().index
    for arguments, words in ((("wasburn", {}), "wasburn"), (("washburn", {"radius": 1}), "radius"), (("washburn", {"radius_um": -1}), "radius_um")):
        with pytest.raises(hygroloom.Error, match=words):
            hygroloom.verify(arguments[0], **arguments[1])


def test_a_card_is_the_command_lines(small, cli, tmp_path):
    project = small.save(tmp_path / "small.hygro")
    fabric = small.fabrics[0]
    own, by_cli = hygroloom.card(small, fabric), cli("card", project, "--fabric", fabric)
    assert own["laboratory"] == by_cli["laboratory"] and own["construction"] == by_cli["construction"]
    air = own["laboratory"]["air_permeability_mm_s"]
    assert 0 < air["low"] <= air["value"] <= air["high"]
    with pytest.raises(hygroloom.Error, match="no such"):
        hygroloom.card(small, "no such")
    with pytest.raises(hygroloom.Error, match="no test"):
        hygroloom.card(small, fabric, runs="no such")
    shares = []
    ran = hygroloom.card(small, fabric, runs="regain", backend="cpu", progress=lambda share, _: shares.append(share))["laboratory"]
    ran_by_cli = cli("card", project, "--fabric", fabric, "--runs", "regain", "--backend", "cpu")["laboratory"]
    assert ran["regain_percent"] == ran_by_cli["regain_percent"] and ran["regain_percent"]["run"] == "live, cpu"
    assert "drying_time_min" not in ran and ran["air_permeability_mm_s"] == air


def test_yarns_of_a_library_are_a_table(cli, tmp_path):
    (tmp_path / "yarns.csv").write_text("name,count,material,price\nfine,Ne 60/2,cotton 60 + polyester 40,6.5\n")
    library = tmp_path / "own.hygrolib"
    assert hygroloom.read_yarns(library).empty
    cli("yarns", library, "--read", tmp_path / "yarns.csv")
    table = hygroloom.read_yarns(library)
    assert list(table.name) == ["fine"] and table.price[0] == 6.5 and table.plies[0] == 2 and table["count"][0] == "Ne 60/2" and table.material[0] == "cotton 60 + polyester 40"
    with pytest.raises(hygroloom.FileError):
        hygroloom.read_yarns(tmp_path / "yarns.csv")


def test_fabrics_are_compared(small, cli, tmp_path):
    second = {**small.get("fabrics[0]"), "name": "repellent", "contact_angle_deg": 100.0}
    small.set("fabrics", small.get("fabrics") + [second])
    table = hygroloom.compare(small, fidelity="live")
    by_cli = cli("compare", small.save(tmp_path / "two.hygro"), "--fidelity", "live")
    assert table.attrs["json"]["verdicts"] == by_cli["verdicts"] and set(table.fabric) == {small.fabrics[0], "repellent"}
    assert [row.verdict for row in table.itertuples() if row.fabric == small.fabrics[0]][0] is None
    with pytest.raises(hygroloom.Error, match="two or more"):
        hygroloom.compare(small, fabrics="repellent", fidelity="live")
    with pytest.raises(hygroloom.Error, match="named twice"):
        hygroloom.compare(small, fabrics=["repellent", "repellent"], fidelity="live")
    with pytest.raises(hygroloom.Error, match="baseline"):
        hygroloom.compare(small, baseline="other", fidelity="live")


def test_calibration_refuses_what_cannot_be_told(examples):
    strip = hygroloom.Project.open(examples / "laboratory.hygro")
    flat = pandas.DataFrame({"time_s": [1, 2, 3], "wick_height_mm": [5, 5, 5]})
    fit = hygroloom.calibrate(strip, experiment="vertical wicking", measured=flat, free="contact_angle_deg", fidelity="live")
    assert not fit.identifiable and fit.refusal
    with pytest.raises(hygroloom.Error, match=fit.refusal[:20]):
        fit.project
    for arguments, words in ((dict(free="colour"), "colour"), (dict(free=""), "Name an input"), (dict(measured=flat.astype(str) + "x"), "measured")):
        with pytest.raises(hygroloom.Error, match=words):
            hygroloom.calibrate(strip, experiment="vertical wicking", fidelity="live", **{"measured": flat, "free": "contact_angle_deg", **arguments})
    with pytest.raises(hygroloom.FileError, match="none.csv"):
        hygroloom.calibrate(strip, experiment="vertical wicking", measured="none.csv", free="contact_angle_deg")


def test_a_sweep_is_kept_and_gone_on_with(small, cli, tmp_path):
    study = {
        "factors": [{"path": "fabrics[0].contact_angle_deg", "values": [20, 60]}, {"path": "fabrics[0].warp.material", "values": ["cotton", "hemp"]}],
        "design": {"type": "grid"}, "metrics": ["absorbency_time_s", "maximum_wetted_radius_top_mm"], "fidelity": "live",
    }  # fmt: skip
    told = []
    table = hygroloom.sweep(small, study, tmp_path / "out", progress=lambda share, what: told.append(what))
    assert list(table.point) == [0, 1, 2, 3] and list(table["fabrics[0].warp.material"].unique()) == ["cotton", "hemp"]
    for row in table.itertuples(index=False):
        alone = small.copy().set("fabrics[0].contact_angle_deg", row[2]).set("fabrics[0].warp.material", row[3])
        run = hygroloom.simulate(alone, fidelity="live", recording=False)
        assert row.maximum_wetted_radius_top_mm == pytest.approx(run.metrics["maximum_wetted_radius_top_mm"], rel=1e-12)
    kept = (tmp_path / "out/results.csv").read_bytes()
    with pytest.raises(hygroloom.Error, match="resume"):
        hygroloom.sweep(small, study, tmp_path / "out")
    again = hygroloom.sweep(small, study, tmp_path / "out", resume=True)
    pandas.testing.assert_frame_equal(again, table)
    assert (tmp_path / "out/results.csv").read_bytes() == kept
    unkept = hygroloom.sweep(small, study)
    pandas.testing.assert_frame_equal(unkept.drop(columns="wall_s"), table.drop(columns="wall_s"))
    study["factors"][0]["path"] = "fabrics[0].contct_angle_deg"
    with pytest.raises(hygroloom.InvalidProject, match="The study has errors.*contct_angle_deg") as refused:
        hygroloom.sweep(small, study)
    assert refused.value.issues[0].where.startswith("factors[0]")
    for wrong, error, words in (
        ({**study, "factrs": []}, hygroloom.FileError, "study: .*factrs"),
        (tmp_path / "none.json", hygroloom.FileError, "none.json"),
        (3, TypeError, "study: This must be a path"),
        ({"seed": object()}, TypeError, "study: "),
    ):
        with pytest.raises(error, match=words):
            hygroloom.sweep(small, wrong)
