# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Other processes: what can be sent there and back, and how one ends whose threads still work."""
import copy
import os
import pathlib
import pickle
import subprocess
import sys
import textwrap

import numpy as np
import pytest

import hygroloom


def ended(code, *arguments, **more):
    """A process that runs this code to its end."""
    return subprocess.run([sys.executable, "-c", textwrap.dedent(code), *map(str, arguments)], capture_output=True, text=True, timeout=60, **more)


BUSY = """
    import sys, threading, time
    import hygroloom
    begun = threading.Event()
    def work(path=sys.argv[1]):
        project = hygroloom.Project.open(path).set("experiments[0].duration_s", 600)
        while True:
            hygroloom.simulate(project, fidelity="draft", progress=lambda share, what: begun.set())
    def reading(path=sys.argv[1]):
        while True:
            hygroloom.Project.open(path).validate()
    def busy(target, count=1, daemon=True):
        for _ in range(count):
            threading.Thread(target=target, daemon=daemon).start()
"""


def check_end(done, folder, code=0):
    assert done.returncode == code and "terminate" not in done.stderr and "FATAL" not in done.stderr, done.stderr
    assert not list(folder.iterdir())


@pytest.fixture
def temporary(tmp_path, monkeypatch):
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    return folder


@pytest.mark.parametrize(
    "end, code",
    [
        ("busy(work); begun.wait(); sys.exit(3)", 3),
        ("busy(work, 3); begun.wait(); time.sleep(0.1)", 0),
        ("busy(work); begun.wait(); raise RuntimeError('over')", 1),
        ("busy(reading, 3); time.sleep(0.2)", 0),  # without a run
        ("busy(work); time.sleep(0.02)", 0),  # hardly begun
        ("busy(lambda: hygroloom.verify('conservation')); time.sleep(0.3)", 0),
    ],
)
def test_a_process_ends_while_daemon_threads_work(examples, temporary, end, code):
    for _ in range(2):
        check_end(ended(textwrap.dedent(BUSY) + end, examples / "one-drop-on-cotton.hygro"), temporary, code)


def test_a_progress_that_waits_holds_up_no_end(examples, temporary):
    told = """
        def slowly(share, what):
            begun.set()
            time.sleep(60)
        project = hygroloom.Project.open(sys.argv[1]).set("experiments[0].duration_s", 600)
        busy(lambda: hygroloom.simulate(project, fidelity="draft", progress=slowly))
        begun.wait()
    """
    check_end(ended(textwrap.dedent(BUSY) + textwrap.dedent(told), examples / "one-drop-on-cotton.hygro"), temporary)


def test_what_is_called_at_exit_still_runs(small, temporary, tmp_path):
    small.save(tmp_path / "small.hygro")
    code = """
        import atexit, sys
        at_exit = lambda: print(hygroloom.simulate(sys.argv[1], fidelity="live").finished)
        atexit.register(at_exit)
        import hygroloom
    """
    done = ended(code, tmp_path / "small.hygro")
    assert done.stdout == "True\n"
    check_end(done, temporary)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_children_end_while_their_threads_work(examples, small, temporary, tmp_path, method):
    code = textwrap.dedent(BUSY) + textwrap.dedent("""
        import multiprocessing
        kept = []
        def with_daemon(path):
            threading.Thread(target=work, args=(path,), daemon=True).start()
            begun.wait()
        def with_thread(path):
            def run():
                time.sleep(0.1)  # until the child would end
                kept.append(hygroloom.simulate(path, fidelity="live").dataset.liquid.values)
                print("ran", flush=True)
            threading.Thread(target=run).start()
        if __name__ == "__main__":
            context = multiprocessing.get_context(sys.argv[2])
            for target, path in ((with_daemon, sys.argv[1]), (with_thread, sys.argv[3])):
                child = context.Process(target=target, args=(path,))
                child.start()
                child.join(20)
                print(child.exitcode, flush=True)
    """)
    script = tmp_path / "children.py"
    script.write_text(code)
    small.save(tmp_path / "small.hygro")
    command = [sys.executable, script, examples / "one-drop-on-cotton.hygro", method, tmp_path / "small.hygro"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=90)
    assert done.stdout.split() == ["0", "ran", "0"], done.stdout + done.stderr
    assert not [left for left in temporary.iterdir() if left.name.startswith("hygroloom")]


def test_a_forked_child_leaves_its_parents_recording(small, temporary):
    run = hygroloom.simulate(small, fidelity="live")
    child = os.fork()
    if child == 0:
        del run
        os._exit(0)
    os.waitpid(child, 0)
    assert run.recording.exists()


def copies_of(value):
    return [pickle.loads(pickle.dumps(value)), copy.deepcopy(value), copy.copy(value)]


def test_projects_are_sent(examples, tmp_path):
    for path in sorted(examples.glob("*.hygro")):
        project = hygroloom.Project.open(path)
        for again in copies_of(project):
            assert again == project and again.path == path and again.to_json() == project.to_json()
    project.set("fabrics[0].name", "ü \"…\" 1e400")
    again = copy.deepcopy(project)
    assert again == project
    assert again.set("fabrics[0].name", "other") != project


def test_runs_are_sent_with_their_recording(small, temporary, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for recording in (True, False, "own.hygrorec"):
        run = hygroloom.simulate(small, fidelity="live", recording=recording)
        if recording:
            run.dataset
        for again in copies_of(run):
            assert again.json == run.json and again.finished and again.table.equals(run.table)
            if recording is False:
                assert again.recording is None
                continue
            monkeypatch.chdir(temporary)
            np.testing.assert_array_equal(again.dataset.liquid.values, run.dataset.liquid.values)
            monkeypatch.chdir(tmp_path)
            assert (again.recording == run.recording.absolute()) == (recording is not True)
    run = hygroloom.simulate(small, fidelity="live")
    sent = pickle.dumps(run)
    del run, again
    again = pickle.loads(sent)  # the first one's folder is gone
    assert again.dataset.sizes["time"] == len(again.series)
    del again
    assert not list(temporary.iterdir())


def test_recordings_are_sent_before_they_are_read(small, tmp_path, monkeypatch):
    hygroloom.simulate(small, fidelity="live", recording=tmp_path / "a.hygrorec")
    monkeypatch.chdir(tmp_path)
    ds = hygroloom.read_recording("a.hygrorec")
    sent = pickle.dumps(ds)
    monkeypatch.chdir("/")
    again = pickle.loads(sent)
    for name in ds.data_vars:
        np.testing.assert_array_equal(again[name].values, ds[name].values)
    part = pickle.loads(pickle.dumps(ds.water_map.isel(time=-1)))
    np.testing.assert_array_equal(part.values, ds.water_map.isel(time=-1).values)
    assert copy.deepcopy(ds).identical(ds)
    (tmp_path / "a.hygrorec").unlink()
    with pytest.raises(hygroloom.FileError, match="a.hygrorec"):
        pickle.loads(sent)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_a_pool_maps_projects_to_runs(small, temporary, tmp_path, method):
    script = tmp_path / "pool.py"
    script.write_text(textwrap.dedent("""
        import multiprocessing, sys
        import hygroloom
        def run(project):
            return hygroloom.simulate(project, fidelity="live")
        if __name__ == "__main__":
            project = hygroloom.Project.open(sys.argv[1])
            angles = (20, 60)
            projects = [project.copy().set("fabrics[0].contact_angle_deg", angle) for angle in angles]
            with multiprocessing.get_context(sys.argv[2]).Pool(2) as pool:
                runs = pool.map(run, projects)
            for sent, own in zip(runs, map(run, projects)):
                assert sent.metrics == own.metrics and sent.dataset.liquid.equals(own.dataset.liquid)
    """))
    done = subprocess.run([sys.executable, script, small.save(tmp_path / "small.hygro"), method], capture_output=True, text=True, timeout=90)
    assert done.returncode == 0, done.stderr
    assert not [left for left in temporary.iterdir() if left.name.startswith("hygroloom")]


def test_what_cannot_be_saved_is_a_file_error(small, tmp_path, monkeypatch):
    run = hygroloom.simulate(small, fidelity="live")
    folder = tmp_path / "folder"
    folder.mkdir()
    for path in (tmp_path / "none/s.hygrorec", folder, tmp_path / ("n" * 300), "/proc/s.hygrorec", tmp_path / "folder/a/b"):
        with pytest.raises(hygroloom.FileError, match=str(path)) as refused:
            run.save(path)
        assert ".part" not in str(refused.value)
    assert not list(folder.iterdir())
    assert run.save(tmp_path / ("n" * 255)).stat().st_size == run.recording.stat().st_size
    assert run.save(run.recording) == run.recording and hygroloom.measure(run.recording).metrics == run.metrics
    kept = run.save(tmp_path / "kept.hygrorec").read_bytes()
    run.recording.unlink()
    with pytest.raises(hygroloom.FileError, match="run.hygrorec"):
        run.save(tmp_path / "kept.hygrorec")
    with pytest.raises(hygroloom.FileError, match="run.hygrorec"):
        pickle.dumps(run)
    assert (tmp_path / "kept.hygrorec").read_bytes() == kept
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "none"))
    with pytest.raises(hygroloom.FileError, match="temporary folder"):
        hygroloom.simulate(small, fidelity="live")
