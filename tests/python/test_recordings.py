# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Recordings: the arrays are those of the file, are read late, and nothing in a damaged file is trusted."""
import pickle
import random
import sqlite3
import threading
import zlib

import numpy as np
import pytest

import hygroloom


@pytest.fixture
def recording(small, tmp_path):
    return hygroloom.simulate(small, fidelity="live", recording=tmp_path / "small.hygrorec").recording


def query(recording, sql, *values):
    with sqlite3.connect(recording) as file:
        return file.execute(sql, values).fetchall()


def numbers(field, kind=np.float32):
    """A field of numbers, as the guide describes it."""
    size, held = int.from_bytes(field[:8], "little"), field[8:]
    if len(held) == size:
        return np.frombuffer(held, kind)
    shuffled = np.frombuffer(zlib.decompress(held), np.uint8).reshape(np.dtype(kind).itemsize, -1)
    return shuffled.T.copy().view(kind).ravel()


def textile(recording, name, kind):
    return numbers(query(recording, "SELECT value FROM meta WHERE name=?", "textile/" + name)[0][0], kind)


def test_values_are_those_of_the_file(small, tmp_path):
    recording = hygroloom.simulate(small, fidelity="draft", recording=tmp_path / "small.hygrorec").recording
    ds = hygroloom.read_recording(recording)
    times = query(recording, "SELECT time_s, water_delivered_kg FROM frames ORDER BY number")
    assert ds.sizes["time"] == len(times)
    np.testing.assert_array_equal(ds.time.values, [time for time, _ in times])
    np.testing.assert_array_equal(ds.water_delivered_kg.values, [water for _, water in times])
    for number in (0, len(times) // 2, len(times) - 1):
        for field in hygroloom.FIELDS:
            held = query(recording, f"SELECT {field} FROM frames WHERE number=?", number)[0][0]
            np.testing.assert_array_equal(ds[field].isel(time=number).values, numbers(held))
    np.testing.assert_array_equal(ds.system.values == "weft", textile(recording, "kind", np.int32) == 1)
    np.testing.assert_array_equal(ds.pick.values, textile(recording, "pick", np.int32))
    np.testing.assert_allclose(ds.x_mm.values, 1e3 * textile(recording, "position", np.float32)[::3], rtol=1e-6, atol=1e-4)
    assert ds.saturation.attrs["units"] == "1" and ds.temperature.attrs["units"] == "K"
    assert ds.water_map.attrs["units"] == "g/m2" and ds.wetted_radius_top_mm.attrs["units"] == "mm" and ds.energy_lost_j.attrs["units"] == "J"
    assert ds.attrs["fidelity"] == "draft" and ds.attrs["finished"] == 1


def test_a_live_recording_holds_bundles_and_is_read_as_yarns(recording):
    ds = hygroloom.read_recording(recording)
    kept = numbers(query(recording, "SELECT liquid FROM frames ORDER BY number DESC LIMIT 1")[0][0])
    assert len(kept) < ds.sizes["segment"]
    np.testing.assert_allclose(ds.liquid.isel(time=-1).sum(), kept.sum(), rtol=1e-5)


def test_maps_hold_the_water_that_the_metrics_have(recording):
    run, ds = hygroloom.measure(recording), hygroloom.read_recording(recording, cells=3)
    open_file = hygroloom.Recording(recording)
    cell = 9e-6 * open_file.about["end_pitch_mm"] * open_file.about["pick_pitch_mm"]
    last = ds.water_map.isel(time=-1)
    columns = -(-open_file.about["ends"] // 3)
    assert last.shape == (3, -(-open_file.about["picks"] // 3), columns)
    inside = last.isel(x=slice(0, -1), y=slice(0, -1))  # those at the far edges may be smaller
    assert float(inside.sel(side="top").sum()) * cell == pytest.approx(run.series.water_top_g.iloc[-1], rel=3e-3)  # cells take a yarn's fibres for as many everywhere
    np.testing.assert_allclose(last.sel(side="top") + last.sel(side="bottom"), last.sel(side="total"), rtol=1e-9, atol=1e-9)
    np.testing.assert_array_equal(open_file.water_map(-1, "bottom", 3), last.sel(side="bottom").values)
    assert abs(float(last.x.mean())) < 3 * open_file.about["end_pitch_mm"]


def test_series_are_those_of_measure(recording):
    run, ds = hygroloom.measure(recording), hygroloom.read_recording(recording)
    for key in run.series:
        np.testing.assert_array_equal(ds[key].values, run.series[key].values)
    np.testing.assert_array_equal(ds.time.values, run.series.index)
    assert float(ds.water_delivered_kg[-1]) == run.ledger["water_in_kg"]


def test_frames_are_read_when_they_are_asked_for(recording, monkeypatch):
    reads = []
    of_file, of_map = hygroloom.Recording.frame, hygroloom.Recording.water_map
    monkeypatch.setattr(hygroloom.Recording, "frame", lambda self, k, fields=None: reads.append(k) or of_file(self, k, fields))
    monkeypatch.setattr(hygroloom.Recording, "water_map", lambda self, k, side, cells: reads.append(k) or of_map(self, k, side, cells))
    monkeypatch.setattr(hygroloom.Recording, "series", lambda self: pytest.fail("all frames were read"))
    ds = hygroloom.read_recording(recording)
    repr(ds), ds.time.values, ds.water_free_kg.values, ds.isel(time=slice(0, 5)).saturation
    assert reads == []
    ds.saturation.isel(time=3).values
    assert reads == [3]
    ds.temperature.isel(time=[1, 4], segment=slice(0, 5)).values
    assert reads == [3, 1, 4]
    ds.liquid[-2:, 10].values
    assert reads[3:] == [len(ds.time) - 2, len(ds.time) - 1]
    ds.water_map.isel(time=2).values
    assert reads[5:] == [2, 2, 2]


def test_opening_reads_no_frame(recording):
    """Also below Python: frames whose values are spoilt are found out only when they are read."""
    query(recording, "UPDATE frames SET saturation=NULL")
    ds = hygroloom.read_recording(recording)
    assert ds.water_delivered_kg.values[-1] > 0 and ds.temperature.isel(time=1).values.min() > 250
    with pytest.raises(hygroloom.FileError, match="Frame 1 cannot be read: .*saturation"):
        ds.saturation.isel(time=1).values
    with pytest.warns(RuntimeWarning, match="saturation"):
        assert np.isnan(ds.wetted_radius_top_mm.values).all()


def test_a_frame_is_not_copied(recording):
    values = hygroloom.Recording(recording).frame(-1, ["saturation"])
    assert sorted(values)[0] == "caps" and "temperature" not in values
    saturation = values["saturation"]
    assert saturation.dtype == np.float32 and not saturation.flags.owndata and type(saturation.base).__name__ == "PyCapsule"
    saturation[:] = 2  # its own memory
    assert hygroloom.Recording(recording).frame(-1)["saturation"].max() <= 1.01
    assert values["particle_position"].shape[1] == 3 and values["caps"].shape[1] == 6


def test_yarns_of_one_system_lie_on_a_grid(recording):
    last = hygroloom.read_recording(recording).saturation.isel(time=-1).load()
    for system in ("warp", "weft"):
        yarns = hygroloom.grid(last, system)
        assert yarns.dims == ("end", "pick") and np.shares_memory(yarns.values, last.values)
        one = last.values[((last.system == system) & (last.end == 3) & (last.pick == 5)).values]
        assert yarns[3, 5] == one[0]
    with pytest.raises(ValueError, match="values: "):
        hygroloom.grid(last.isel(segment=slice(0, 4)), "warp")
    with pytest.raises(ValueError, match="system: "):
        hygroloom.grid(last, "diagonal")


def test_several_threads_read_one_recording(recording):
    ds = hygroloom.read_recording(recording)
    alone, seen = [ds.liquid.isel(time=k).values for k in range(8)], {}
    threads = [threading.Thread(target=lambda k=k: seen.update({k: ds.liquid.isel(time=k).values})) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k in range(8):
        np.testing.assert_array_equal(seen[k], alone[k])
    again = pickle.loads(pickle.dumps(hygroloom.Recording(recording)))
    np.testing.assert_array_equal(again.frame(0)["liquid"], alone[0])


def test_what_was_run_stands_in_the_recording(recording, small):
    file = hygroloom.Recording(recording)
    assert file.project == small and file.about["seed"] == 1 and file.about["fabric"] == small.fabrics[0]


@pytest.mark.filterwarnings("ignore:.*left out:RuntimeWarning", "ignore:.*cannot be read:RuntimeWarning")
def test_damaged_files_are_refused(recording, tmp_path):
    whole = recording.read_bytes()
    chance = random.Random(5)
    refused = 0
    for trial in range(60):
        damaged = tmp_path / "damaged.hygrorec"
        if trial < 40:
            damaged.write_bytes(whole[: chance.randrange(len(whole))])
        else:
            bytes_ = bytearray(whole)
            for _ in range(20):
                bytes_[chance.randrange(len(bytes_))] = chance.randrange(256)
            damaged.write_bytes(bytes_)
        try:
            ds = hygroloom.read_recording(damaged)
            ds.saturation.isel(time=-1).values, ds.water_map.isel(time=-1).values
            hygroloom.measure(damaged)
        except hygroloom.FileError as error:
            assert "damaged.hygrorec" in str(error)
            refused += 1
    assert refused >= 40
    for wrong in (tmp_path, tmp_path / "none.hygrorec"):
        with pytest.raises(hygroloom.FileError):
            hygroloom.read_recording(wrong)
    with pytest.raises(ValueError, match="cells: "):
        hygroloom.read_recording(recording, cells=0)
    file = hygroloom.Recording(recording)
    for use in (lambda: file.frame(10**6), lambda: file.water_map(-(10**6))):
        with pytest.raises(IndexError, match="index: "):
            use()
    with pytest.raises(hygroloom.Error, match="no field .colour."):
        file.frame(0, "colour")
    with pytest.raises(ValueError, match="side: "):
        file.water_map(0, "left")
