# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""The worked examples run as they stand, and a worn garment's arrays hold its water."""
import importlib.util
import sys

import numpy as np
import pandas
import pytest

import hygroloom

pytestmark = pytest.mark.slow


def run(examples, monkeypatch, folder, name, *arguments):
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "argv", [name, *arguments])
    spec = importlib.util.spec_from_file_location(name, examples / "python" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_recording_becomes_a_picture(examples, monkeypatch, tmp_path):
    run(examples, monkeypatch, tmp_path, "recording_to_picture")
    assert (tmp_path / "drop.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "drop.hygrorec").exists()
    run(examples, monkeypatch, tmp_path, "recording_to_picture", "drop.hygrorec", "again.png")
    assert (tmp_path / "again.png").read_bytes() == (tmp_path / "drop.png").read_bytes()


def test_a_sweep_becomes_a_table(examples, monkeypatch, tmp_path):
    table = run(examples, monkeypatch, tmp_path, "sweep_to_table", "swept").table
    assert len(table) == 6 and (table.status == "done").all()
    kept = pandas.read_csv(tmp_path / "swept/results.csv", float_precision="round_trip")
    assert list(kept.columns) == list(table.columns)
    np.testing.assert_array_equal(kept.absorbency_time_s, table.absorbency_time_s)
    times = table.set_index("fabrics[0].contact_angle_deg").absorbency_time_s
    assert (times[20].values < times[60].values).all()


def test_a_strip_is_calibrated(examples, monkeypatch, tmp_path):
    example = run(examples, monkeypatch, tmp_path, "calibrate_a_strip")
    assert example.angle["low"] <= 42 <= example.angle["high"] and abs(example.angle["value"] - 42) < 4
    example.fit.save_report(tmp_path / "fit.html")
    assert "<svg" in (tmp_path / "fit.html").read_text()


@pytest.mark.parametrize(
    "name", ["droplet", "moisture_management", "vertical_wicking", "horizontal_wicking", "drying", "conditioning", "sweat", "wear"])  # fmt: skip
def test_each_experiment_has_an_example(examples, monkeypatch, tmp_path, name):
    done = getattr(run(examples, monkeypatch, tmp_path, "experiments"), name)()
    assert done.finished and len(done.series) > 3
    ds = done.dataset
    assert ds.attrs["type"] == name and ds.sizes["time"] == len(done.series)
    if name == "wear":
        water = 1e3 * float((ds.inside + ds.outside).isel(time=-1).sum())
        assert water == pytest.approx(done.metrics["water_g"], rel=1e-8)  # frames have single precision
        assert set(np.unique(ds.panel)) == set(done.panels.index) and set(np.unique(ds.zone)) == set(done.zones.index)
        again = hygroloom.measure(done.recording)  # recordings hold areas with 7 digits
        assert again.metrics["water_g"] == pytest.approx(done.metrics["water_g"], rel=1e-6) and set(again.metrics) == set(done.metrics)


@pytest.mark.slow
def test_garments_are_compared_and_studied(examples, tmp_path):
    project = hygroloom.Project.open(examples / "lined-singlet.hygro")
    name = project.experiments[-1]
    project.set(f"experiments.{name}.duration_s", 5)
    run = hygroloom.simulate(project, experiment=name, fidelity="live", recording=False)
    assert run.table.loc["panels/front/water_g", "value"] == run.panels.loc["front", "water_g"]
    assert run.table.loc["panels/front/wet_area_m2", "title"] == "wet area, panel front" and run.table.loc["wet_area_m2", "unit"] == "m²"
    table = hygroloom.compare(project, name, fabrics=["Poplin shirting", "Sports micro-twill"], fidelity="live")
    assert len(table[table.metric == "panels/front/water_g"]) == 2 and "verdicts" in table.attrs["json"]
    study = {"experiments": [name], "factors": [{"path": f"experiments.{name}.initial_water_g_m2", "values": [0, 20]}],
             "design": {"type": "grid"}, "fidelity": "live", "metrics": ["initial_water_g"]}  # fmt: skip
    swept = hygroloom.sweep(project, study)
    assert swept.initial_water_g[0] == 0 and swept.initial_water_g[1] > 10
