# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Many runs for one answer."""
from __future__ import annotations

import json
import os
import pathlib
import warnings
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Optional, Union

from . import _checks, _hygroloom, _temporary
from .errors import Error, FileError
from .projects import Project, folder_of, project_of
from .runs import Progress

if TYPE_CHECKING:
    import pandas

_LARGEST_TABLE = 16 << 20  # bytes


class Calibration:
    """What :func:`calibrate` found.

    Attributes:
        json: all of it, as ``hygroloom-cli calibrate --json`` prints it.
        parameters: by key a dictionary with value, low and high (90 % interval), before, and range.
        identifiable: whether the data tell the inputs.
        refusal: why they do not, in a sentence; empty: they do.
        residual_rms: root mean square of measured less simulated, in the curve's unit.
        notes: what limits the result, in sentences.
    """

    def __init__(self, results: tuple, path: Optional[pathlib.Path]):
        text, design, self.refusal, self._page = results
        self.json: dict[str, Any] = json.loads(text)
        self.parameters: dict[str, Any] = self.json["parameters"]
        self.identifiable: bool = self.json["identifiable"]
        self.residual_rms: float = self.json["residual_rms"]
        self.notes: list[str] = self.json["notes"]
        self._project = Project(design) if design is not None else None

    @property
    def project(self) -> Project:
        """The project with the fitted values, their ranges and where they come from. Raises Error where the data do not tell the inputs."""
        if self._project is None:
            raise Error(self.refusal)
        return self._project.copy()

    @property
    def table(self) -> "pandas.DataFrame":
        """Each measured number: key, unit, time_s of a curve, measured, before, fitted."""
        import pandas

        return pandas.DataFrame(self.json["data"])

    def save_report(self, path: Union[str, os.PathLike]) -> None:
        """Writes a page (.html) with the fit, its residuals and what it rests on."""
        _hygroloom.write_text(_checks.path_bytes(path, "path"), self._page)

    def __repr__(self) -> str:
        found = ", ".join(f"{key} {of['value']:.4g}" for key, of in self.parameters.items() if of["value"] is not None)
        return f"<hygroloom.Calibration {found or self.refusal}>"


def _file(path: Any, name: str) -> tuple[bytes, bytes]:
    """What a file holds, and its name."""
    name_bytes = _checks.path_bytes(path, name)
    shown = os.fsdecode(name_bytes)
    try:
        with open(name_bytes, "rb") as file:
            data = file.read(_LARGEST_TABLE + 1)
    except OSError as error:
        raise FileError(f"{shown}: The file cannot be read: {error.strerror}.") from None
    if len(data) > _LARGEST_TABLE:
        raise FileError(f"{shown}: The file is larger than 16 MiB.")
    return data, name_bytes


def _measured(measured: Any) -> tuple[bytes, bytes]:
    """Text and name of a file, or of a DataFrame."""
    if hasattr(measured, "to_csv"):
        frame = measured.reset_index() if "time_s" in getattr(measured.index, "names", ()) else measured
        return frame.to_csv(index=False).encode(), b"measured"
    return _file(measured, "measured")


def calibrate(
    project: Union[Project, str, os.PathLike],
    fabric: Optional[str] = None,
    experiment: Optional[str] = None,
    *,
    measured: Union[str, os.PathLike, "pandas.DataFrame"],
    free: Union[str, Iterable[str]],
    fidelity: str = "standard",
    backend: str = "auto",
    seed: int = 1,
    threads: int = 0,
    physics: Union[str, Mapping[str, bool], None] = None,
    knobs: Optional[Mapping[str, Any]] = None,
    at_once: int = 0,
    force: bool = False,
    progress: Progress = None,
) -> Calibration:
    """Fits the few inputs of a fabric that are not known to what a laboratory measured.

    Args:
        measured: a CSV file, or a DataFrame with the same columns: time_s (also as the index), a series such as wick_height_mm, and,
            where known, spread (standard deviation); or fabric, metric, value, unit, spread.
        free: the inputs: contact_angle_deg, receding_angle_deg, packing_factor.
        at_once: runs at the same time; 0: one on a CPU, up to 16 on each GPU. No more than the memory holds.
        project, fabric, experiment, fidelity, backend, seed, threads, physics, knobs, force, progress: as in :func:`simulate`.

    Returns:
        A :class:`Calibration`; its ``identifiable`` is False where the data cannot tell the inputs, and ``refusal`` says why.

    Raises as :func:`simulate`; Error also names the line of the table that is wrong, and an input that is not free.

    >>> fit = calibrate("cloth.hygro", experiment="strip", measured="strip.csv", free="contact_angle_deg", fidelity="draft")
    >>> fit.parameters["contact_angle_deg"]["value"]
    >>> fit.project.save("calibrated.hygro")
    """
    opened = project_of(project)
    how = {
        **_checks.how(fidelity, backend, seed, threads, physics, knobs),
        "at_once": _checks.whole(at_once, "at_once", 0, 1024),
        "force": bool(force),
    }
    keys = [key.strip() for one in _checks.texts(free, "free") for key in one.split(",") if key.strip()]
    names = _checks.optional_text(fabric, "fabric"), _checks.optional_text(experiment, "experiment")
    data, source = _measured(measured)
    return Calibration(_hygroloom.calibrate(opened._design, *names, data, source, keys, how, _checks.call(progress)), opened.path)


def compare(
    project: Union[Project, str, os.PathLike],
    experiment: Optional[str] = None,
    fabrics: Optional[Iterable[str]] = None,
    *,
    by: Optional[str] = None,
    baseline: Optional[str] = None,
    replicates: int = 1,
    fidelity: str = "standard",
    backend: str = "auto",
    seed: int = 1,
    threads: int = 0,
    physics: Union[str, Mapping[str, bool], None] = None,
    knobs: Optional[Mapping[str, Any]] = None,
    at_once: int = 0,
    force: bool = False,
    progress: Progress = None,
) -> "pandas.DataFrame":
    """Runs several fabrics on the same experiment and says which differences are real.

    With an experiment of the type wear its garment is cut from each of the fabrics; linings stay.

    Args:
        fabrics: two or more names; all of the project when left out.
        by: the metric to rank by, such as "absorbency_time_s".
        baseline: the fabric that verdicts are against; the first when left out.
        replicates: runs of each fabric, 1 to 1000. More than one draw what is not known of the cloth; 8 give useful intervals.
        at_once: runs at the same time; 0: one on a CPU, up to 16 on each GPU. No more than the memory holds.
        project, experiment, fidelity, backend, seed, threads, physics, knobs, force, progress: as in :func:`simulate`.

    Returns:
        A DataFrame, a row per fabric and metric, in the order of the ranks: fabric, rank, metric, value, low, high (90 % interval) and
        verdict ("better", "probably better", "no difference", ...; None for the baseline). ``attrs["json"]`` has all of it, as
        ``hygroloom-cli compare --json`` prints it. A fabric whose run failed has one row without a metric, and its failure in ``attrs``.

    Raises as :func:`simulate`.
    """
    import pandas

    opened = project_of(project)
    how = {
        **_checks.how(fidelity, backend, seed, threads, physics, knobs),
        "at_once": _checks.whole(at_once, "at_once", 0, 1024),
        "force": bool(force),
    }
    result = json.loads(
        _hygroloom.compare(
            opened._design,
            [] if fabrics is None else _checks.texts(fabrics, "fabrics"),
            _checks.optional_text(experiment, "experiment"),
            _checks.optional_text(by, "by"),
            _checks.optional_text(baseline, "baseline"),
            _checks.whole(replicates, "replicates", 1, 1000),
            folder_of(opened),
            how,
            _checks.call(progress),
        )
    )
    verdicts = {(of["fabric"], of["metric"]): of["verdict"] for of in result["verdicts"]}
    rows, failures = [], {}
    for candidate in result["candidates"]:
        fabric, head = candidate["fabric"], {"fabric": candidate["fabric"], "rank": candidate["rank"]}
        if "run" not in candidate:
            failures[fabric] = candidate["failure"]
            rows.append(head)
            continue
        for metric, of in candidate["run"]["intervals"].items():
            values = {"value": of["value"], "low": of["low"], "high": of["high"]}
            rows.append({**head, "metric": metric, **values, "verdict": verdicts.get((fabric, metric))})
    table = pandas.DataFrame(rows, columns=["fabric", "rank", "metric", "value", "low", "high", "verdict"])
    table.attrs.update(json=result, failures=failures)
    return table


def sweep(
    project: Union[Project, str, os.PathLike],
    study: Union[Mapping[str, Any], str, os.PathLike],
    folder: Union[str, os.PathLike, None] = None,
    *,
    resume: bool = False,
    retry_failed: bool = False,
    backend: str = "auto",
    threads: int = 0,
    at_once: int = 0,
    force: bool = False,
    progress: Progress = None,
) -> "pandas.DataFrame":
    """Runs a study of many points: changes values of a project and sees what follows.

    Args:
        project: a :class:`Project`, or the path of one.
        study: the path of a study file, or a dictionary with its keys. ``factors`` is a list: each has a ``path``, as
            :meth:`Project.set` takes it, and ``values``, or ``low`` and ``high``, or a ``distribution``. ``design`` has a ``type``
            ("grid", "latin_hypercube", "sobol", "one_at_a_time") and ``points``. ``fabrics``, ``experiments``, ``metrics``,
            ``fidelity``, ``replicates`` and ``seed`` may be left out.
        folder: keeps each row as soon as it has ended, then results.csv and study.sqlite; without one nothing is kept.
        resume: goes on in a folder that has rows already: runs what is missing.
        retry_failed: with resume: also runs what failed.
        backend: as in :func:`simulate`.
        threads: of each run on a CPU; 0: the cores shared out among the runs.
        at_once: runs at the same time; 0: one per core of a CPU, up to 16 on each GPU. No more than the memory holds.
        force, progress: as in :func:`simulate`.

    Returns:
        A DataFrame, a row per point, fabric, experiment and replicate: point, replicate, fabric and experiment (where there are
        several), the factors by their paths, status ("done", "failed"), the metrics by their keys, wall_s, device, commit, reason.
        The same as results.csv.

    Raises:
        InvalidProject: the project or the study has errors, which are its ``issues``.
        FileError: the study cannot be read, the folder cannot be written or has another study.
        Error: the folder has rows and resume is not set; one run needs more memory than is free.
        KeyboardInterrupt: Ctrl-C; a folder keeps every row that has ended.

    >>> table = sweep("cloth.hygro", {"factors": [{"path": "fabrics[0].contact_angle_deg", "values": [20, 40, 60]}],
    ...                               "design": {"type": "grid"}, "fidelity": "live"})
    >>> table.plot("fabrics[0].contact_angle_deg", "absorbency_time_s")
    """
    import numpy
    import pandas

    opened = project_of(project)
    how = {**_checks.machine(backend, threads), "at_once": _checks.whole(at_once, "at_once", 0, 1024), "force": bool(force)}
    if isinstance(study, Mapping):
        head = {"format": "hygroloom-study", "version": 1}
        data, source = _checks.json_text({**head, **study}, "study").encode(), b"study"
    else:
        data, source = _file(study, "study")
    _checks.call(progress)
    temporary = _temporary.make() if folder is None else None
    try:
        place = _checks.path_bytes(os.path.join(temporary, "study") if temporary else folder, "folder")
        ways = bool(resume), bool(retry_failed), how
        columns, failures, notes = _hygroloom.sweep(opened._design, data, source, place, folder_of(opened), *ways, progress)
    finally:
        if temporary:
            _temporary.remove(temporary)
    for note in notes:
        warnings.warn(note, RuntimeWarning, stacklevel=2)
    values = {}
    for name, numbers, words in columns:
        values[name] = numbers if words is None else numpy.array(words, dtype=object)[numbers]
    table = pandas.DataFrame(values)
    for name in ("point", "replicate"):
        table[name] = table[name].astype(int)
    table.attrs["failures"] = failures
    return table
