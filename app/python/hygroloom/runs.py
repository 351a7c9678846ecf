# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""One run, and what came of it."""
from __future__ import annotations

import json
import os
import pathlib
import warnings
import weakref
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Union

from . import _checks, _hygroloom, _temporary
from .errors import Error, FileError
from .projects import Project, folder_of, project_of
from .recordings import read_recording

if TYPE_CHECKING:
    import pandas
    import xarray

Progress = Optional[Callable[[float, str], Any]]


class Run:
    """What a run came to, of :func:`simulate` or :func:`measure`.

    Attributes:
        json: all of it, as ``hygroloom-cli simulate --json`` prints it.
        metrics: the numbers by their keys, which end in the unit, such as ``"absorbency_time_s"``; None: it could not be determined,
            and a sentence of notes says why. "grades" and the like stand beside.
        intervals: by key a dictionary with value, low, high, level, and parts: half widths of its named errors.
        ledger: where all water and heat went, kg and J.
        provenance: program, commit, backend, device, fidelity, seed, wall_s, the plan.
        notes: what limits the numbers, in sentences.
        finished: whether the run came to its end.
        recording: the file; None: there is none.
    """

    def __init__(self, results: tuple, recording: Optional[pathlib.Path] = None):
        metrics, outcomes, self.notes, troubles, self.end_s, self.finished = results
        self.json: dict[str, Any] = json.loads(metrics)
        self.metrics: dict[str, Any] = self.json["metrics"]
        self.intervals: dict[str, Any] = self.json.get("intervals", {})
        self.ledger: dict[str, float] = self.json.get("ledger", {})
        self.provenance: dict[str, Any] = self.json.get("provenance", {})
        self.recording = recording
        self._outcomes = json.loads(outcomes)
        self._is_temporary = False
        self._dataset: Optional["xarray.Dataset"] = None
        for trouble in troubles:
            warnings.warn(trouble, RuntimeWarning, stacklevel=4)

    @property
    def series(self) -> "pandas.DataFrame":
        """The time series, a row per frame: index time_s; each column ends in its unit, such as wetted_radius_top_mm."""
        import pandas

        series = {key: values for key, values in self.json["series"].items() if isinstance(values, list)}
        return pandas.DataFrame(series).set_index("time_s")

    @property
    def table(self) -> "pandas.DataFrame":
        """The metrics, a row each: index metric; title, unit, value, low and high (its interval), missing (why there is no value), grade.

        Those of a garment are followed by the same of its panels ("panels/front/water_g") and of the body's zones ("zones/chest/water_g").
        """
        import pandas

        rows = []
        for outcome in self._outcomes:
            interval = self.intervals.get(outcome["metric"], {})
            rows.append({**outcome, "low": interval.get("low"), "high": interval.get("high")})
        columns = ["metric", "title", "unit", "value", "low", "high", "missing", "grade"]
        return pandas.DataFrame(rows, columns=columns).set_index("metric")

    def _parts(self, which: str) -> "pandas.DataFrame":
        import pandas

        if which not in self.json:
            raise Error(f"Only runs of garments have {which}.")
        return pandas.DataFrame.from_dict(self.json[which], orient="index")

    @property
    def panels(self) -> "pandas.DataFrame":
        """Of a worn garment: the numbers of each panel, a row each."""
        return self._parts("panels")

    @property
    def zones(self) -> "pandas.DataFrame":
        """Of a worn garment: the numbers of each zone of the body, a row each."""
        return self._parts("zones")

    def _file(self) -> pathlib.Path:
        if self.recording is None:
            raise Error("The run was not recorded; call simulate() without recording=False.")
        return self.recording

    @property
    def dataset(self) -> "xarray.Dataset":
        """The recording: maps, values of segments, series and ledger over time; see :func:`read_recording`."""
        if self._dataset is None:
            self._dataset = read_recording(self._file())
        return self._dataset

    def save(self, path: Union[str, os.PathLike]) -> pathlib.Path:
        """Writes the recording to a file (.hygrorec), as a whole, and returns its path.

        Raises Error where the run was not recorded; FileError; a file that was there is then unchanged.
        """
        source, target = self._file(), pathlib.Path(os.fsdecode(_checks.path_bytes(path, "path")))
        _hygroloom.copy_file(os.fsencode(source), os.fsencode(target))
        return target

    def _record_in(self, folder: str) -> None:
        """The temporary folder goes with the run."""
        self._is_temporary = True
        self.recording = pathlib.Path(folder, "run.hygrorec")
        weakref.finalize(self, _temporary.remove, folder)

    def __reduce__(self):
        """A temporary recording comes along; of others the path does."""
        state = {**self.__dict__, "_dataset": None}
        if not self._is_temporary:
            state["recording"] = self.recording and self.recording.absolute()
            return _of_state, (state, None)
        try:
            return _of_state, (state, self._file().read_bytes())
        except OSError as error:
            raise FileError(f"{self.recording}: The recording cannot be read: {error.strerror}.") from None

    def __repr__(self) -> str:
        of = self.provenance
        what = f"{of['fabric']}, {of['experiment']}" if of else self.json.get("garment", "")
        return f"<hygroloom.Run {what}: {self.end_s:g} s{'' if self.finished else ', unfinished'}>"


def _of_state(state: dict[str, Any], recording: Optional[bytes]) -> Run:
    run = Run.__new__(Run)
    run.__dict__.update(state)
    if recording is not None:
        run._record_in(_temporary.make())
        try:
            run._file().write_bytes(recording)
        except OSError as error:
            raise FileError(f"{run.recording}: The recording cannot be written: {error.strerror}.") from None
    return run


def simulate(
    project: Union[Project, str, os.PathLike],
    fabric: Optional[str] = None,
    experiment: Optional[str] = None,
    *,
    fidelity: str = "standard",
    backend: str = "auto",
    seed: int = 1,
    threads: int = 0,
    physics: Union[str, Mapping[str, bool], None] = None,
    knobs: Optional[Mapping[str, Any]] = None,
    recording: Union[bool, str, os.PathLike] = True,
    cell_mm: Optional[float] = None,
    shown_mm: Optional[float] = None,
    detail: Union[str, Iterable[str]] = (),
    force: bool = False,
    progress: Progress = None,
) -> Run:
    """Runs an experiment on a fabric, in this process, and returns what came of it.

    The numbers are those of ``hygroloom-cli simulate`` with the same options. Python's lock is released meanwhile: runs in several threads
    go on side by side. Ctrl-C ends the run within 0.3 s with KeyboardInterrupt; a recording with a name then stays as far as it came.

    Args:
        project: a :class:`Project`, or the path of one.
        fabric: by name; may be left out where the project has one. A worn garment (experiment type wear) takes none.
        experiment: by name; may be left out where the project has one.
        fidelity: "live", "draft", "standard" or "reference", from the fastest to the finest.
        backend: "auto", "cpu" or "cuda".
        seed: of what is random, 0 to 2**64 - 1.
        threads: of the CPU; 0: all. Results do not depend on it.
        physics: parts to switch on or off, such as ``{"heat": False}`` or "heat=off,vapour=on".
        knobs: single knobs of the fidelity, such as ``{"free_liquid": "cap"}``.
        recording: a path (.hygrorec); True: a temporary file that goes with the Run; False: none, so that Run.dataset and save() are not
            there.
        cell_mm: of a worn garment: side of the cells that are computed, 0.05 to 100 mm.
        shown_mm: side of the cells that frames, maps and the recording show, 0.05 to 100 mm; 0: by the size of sample or garment.
        detail: of a worn garment: panels of which each computed cell is recorded.
        force: begin also what is expected to take more memory than is free.
        progress: called several times a second from the calling thread with the share done, 0 to 1, and a text. What it raises ends the run.

    Raises:
        InvalidProject: the project has errors, which are its ``issues``.
        FileError: the recording, or a file of the garment, cannot be written or read.
        DeviceError: the GPU that was asked for is not there.
        Error: no such fabric, experiment or knob, with the names there are; more memory is needed than is free; or the run failed.
        TypeError, ValueError: an argument is of a wrong type or out of its range.
        KeyboardInterrupt: Ctrl-C.

    >>> run = simulate("cloth.hygro", "Textile F", "one drop", fidelity="draft")
    >>> run.metrics["absorbency_time_s"]
    >>> run.series.wetted_radius_top_mm.plot()
    """
    opened = project_of(project)
    how = {**_checks.how(fidelity, backend, seed, threads, physics, knobs), "force": bool(force)}
    for name, side in (("cell_mm", cell_mm), ("shown_mm", shown_mm)):
        if side is not None:
            how[name] = _checks.number(side, name, 0.05, 100)
    how["detail"] = _checks.texts(detail, "detail")
    names = _checks.optional_text(fabric, "fabric"), _checks.optional_text(experiment, "experiment")
    folder = folder_of(opened)
    _checks.call(progress)

    temporary = _temporary.make() if recording is True else None
    path = None
    if temporary:
        path = pathlib.Path(temporary, "run.hygrorec")
    elif recording is not False and recording is not None:
        path = pathlib.Path(os.fsdecode(_checks.path_bytes(recording, "recording")))
    if path is not None:
        how["recording"] = os.fsencode(path)
    try:
        run = Run(_hygroloom.simulate(opened._design, *names, folder, how, progress), path)
    except BaseException:
        if temporary:
            _temporary.remove(temporary)
        raise
    if temporary:
        run._record_in(temporary)
    return run


def measure(recording: Union[str, os.PathLike], *, progress: Progress = None) -> Run:
    """The numbers of a recording, as ``hygroloom-cli measure --json`` prints them, also of a run that goes on or was stopped.

    Args:
        recording: the file (.hygrorec), of a sample or of a worn garment.
        progress: as in :func:`simulate`.

    Frames that are damaged are left out and named in a RuntimeWarning. Raises FileError when the file is no recording or has no frames.
    """
    path = _checks.path_bytes(recording, "recording")
    return Run(_hygroloom.measure(path, _checks.call(progress)), pathlib.Path(os.fsdecode(path)))


def card(
    project: Union[Project, str, os.PathLike, Mapping[str, Any]],
    fabric: Optional[str] = None,
    *,
    runs: Union[str, Iterable[str]] = (),
    replicates: int = 1,
    keep: Union[str, os.PathLike, None] = None,
    fidelity: str = "live",
    backend: str = "auto",
    seed: int = 1,
    threads: int = 0,
    physics: Union[str, Mapping[str, bool], None] = None,
    force: bool = False,
    progress: Progress = None,
) -> dict[str, Any]:
    """The technical card of a fabric, as ``hygroloom-cli card --json`` prints it: construction, yarn for a metre, laboratory.

    Args:
        project: a :class:`Project`, its file or its JSON.
        fabric: its name; the only one may be left out.
        runs: tests to run for their numbers: "absorbency", "wicking_warp", "wicking_weft", "management", "drying", "regain"; or "all".
        replicates: runs of each test, 1 to 1000. More than one draw what is not known of the cloth.
        keep: a folder for the tests' recordings; one of the same cloth there stands for a run, at the fidelity or a finer one.
        fidelity, backend, seed, threads, physics, force, progress: of the runs, as in :func:`simulate`.

    Returns:
        A dictionary: fabric, construction, missing, notes, and laboratory: by key a dictionary with value, low, high, unit, standard,
        conditions, compared, run.

    Raises InvalidProject, and Error where the fabric or a test is not there.

    >>> card("cloth.hygro", "Denim")["laboratory"]["air_permeability_mm_s"]["value"]
    >>> card("cloth.hygro", "Denim", runs="drying")["laboratory"]["drying_time_min"]["value"]
    """
    how = {**_checks.how(fidelity, backend, seed, threads, physics, None), "force": bool(force)}
    kept = b"" if keep is None else _checks.path_bytes(keep, "keep")
    return json.loads(_hygroloom.card(
        project_of(project)._design, _checks.optional_text(fabric, "fabric"), _checks.texts(runs, "runs"),
        _checks.whole(replicates, "replicates", 1, 1000), kept, how, _checks.call(progress),
    ))


def verify(case: str, /, *, backend: str = "auto", threads: int = 0, **parameters: Any) -> dict[str, Any]:
    """Runs a case with a known answer through the solver, as ``hygroloom-cli verify CASE --json`` does.

    Args:
        case: its name; see :func:`verify_cases`.
        backend, threads: as in :func:`simulate`.
        parameters: of the case, by their names, which end in the unit.

    Returns:
        A dictionary: case, parameters, wall_s, and results: a list of dictionaries with name, computed, expected, tolerance and pass.

    Raises Error naming the case, the parameter, its range and what was given; KeyboardInterrupt.

    >>> verify("washburn", radius_um=20, contact_angle_deg=45)["results"][0]["computed"]
    """
    changes = _checks.settings(parameters, "parameters")
    return json.loads(_hygroloom.verify(_checks.text(case, "case"), changes, _checks.machine(backend, threads)))


def verify_cases() -> "pandas.DataFrame":
    """The cases of :func:`verify`: index case; what it is about, and its parameters with their usual values as a dictionary."""
    import pandas

    return pandas.DataFrame(json.loads(_hygroloom.verify_list())).set_index("case")
