# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Recordings as arrays: read when they are asked for."""
from __future__ import annotations

import os
import pathlib
import threading
import warnings
from functools import partial
from typing import TYPE_CHECKING, Any, Iterable, Optional, Union

import numpy as np

from . import _checks, _hygroloom
from .errors import Error
from .projects import Project

if TYPE_CHECKING:
    import xarray

SIDES = ("top", "bottom", "total")
_UNITS = {"_mm": "mm", "_kg": "kg", "_g": "g", "_c": "degC", "_pct": "%", "_s": "s", "_j": "J"}
_FIELD_NAMES = {
    "saturation": "liquid volume / pore volume",
    "liquid": "liquid in the segment, with its share of that between the yarns",
    "bound_water": "water in the fibres / dry fibre",
    "vapour_concentration": "vapour in the pores",
    "temperature": "temperature",
    "liquid_between": "liquid between the yarns",
}


def unit_of(key: str) -> str:
    """Of a number whose key ends in its unit; "1" of a plain one."""
    return next((unit for ending, unit in _UNITS.items() if key.endswith(ending)), "1")


class Recording:
    """An open recording (.hygrorec) of a fabric's sample. Opening reads what the run was and the ledger, but no frame.

    Attributes:
        path: of the file.
        about: what the run was: fabric, experiment, type, fidelity, backend, device, seed, date, wall_s, finished, ends, picks,
            end_pitch_mm, pick_pitch_mm, yarns_per_cell, frames; problems: sentences about frames that are damaged and left out.
            Where yarns_per_cell is over 1, frames show cells of so many ends and picks, and ends and picks count those.
        times: s, of each frame.

    Raises FileError when the file is no recording, is damaged, or has no whole frame. Several threads may use it.
    """

    def __init__(self, path: Union[str, os.PathLike]):
        name = _checks.path_bytes(path, "path")
        self.path = pathlib.Path(os.fsdecode(name))
        self._place = self.path.absolute()  # for processes that are elsewhere
        self._file = _hygroloom.Recording(name)
        self.about: dict[str, Any] = self._file.about()
        self.ledger: dict[str, np.ndarray] = self._file.ledger()
        self.times: np.ndarray = self.ledger["time_s"]
        self._lock = threading.Lock()
        self._series: Optional[dict[str, np.ndarray]] = None

    def __len__(self) -> int:
        return len(self.times)

    def __reduce__(self):
        return Recording, (self._place,)

    def __repr__(self) -> str:
        return f"<hygroloom.Recording {self.path}: {self.about['fabric']}, {self.about['experiment']}, {len(self)} frames>"

    @property
    def project(self) -> Project:
        """The project that was run."""
        return Project(self._file.design())

    def frame(self, index: int, fields: Optional[Iterable[str]] = None) -> dict[str, Any]:
        """One frame; -1 is the last.

        Args:
            index: its number.
            fields: of the segments, those of :data:`FIELDS`; all when left out. Only these are read.

        Returns:
            A dictionary: each field as float32 of shape (segments,), in the order of :meth:`segments`; "time" in s; "water_top" and
            "water_bottom" in kg; "particle_position" (n, 3) in m and "particle_velocity" (n, 3) in m/s; "caps" (n, 6): x, y, height of
            the upper face, radius of the base, height in m, and volume in m3.

        Raises FileError, which names the frame, when it is damaged; IndexError when there is none.
        """
        number = _checks.place(index, "index", len(self))
        return self._file.frame(number, list(FIELDS) if fields is None else _checks.texts(fields, "fields"))

    def water_map(self, index: int, side: str = "top", cells: int = 2) -> np.ndarray:
        """Water over the start, g/m2, of one frame on a grid; shape (rows, columns), the first row at the bottom.

        Args:
            index: of the frame; -1 is the last.
            side: "top", "bottom" or "total".
            cells: a cell is this many crossings wide and high.
        """
        number = _checks.place(index, "index", len(self))
        values = self._file.map(number, _checks.word(side, "side", SIDES), _checks.whole(cells, "cells", 1, 1000))
        values *= 1e3
        return values

    def segments(self) -> dict[str, np.ndarray]:
        """Of each segment: system (0 warp, 1 weft), top (1 where it lies on the upper face), end, pick; middle (n, 3), m.

        First come the segments of all ends, pick by pick, then those of all picks, end by end.
        """
        return self._file.segments()

    def series(self) -> dict[str, np.ndarray]:
        """The time series of the metrics file, a number per frame, by their keys, which end in the unit. Reads all frames, once.

        A frame that cannot be read is NaN and gives a RuntimeWarning.
        """
        with self._lock:
            if self._series is None:
                self._series, problems = self._file.series()
                for problem in problems:
                    warnings.warn(problem, RuntimeWarning, stacklevel=2)
            return self._series


#: The fields of segments that frames have, and their units.
FIELDS: dict[str, str] = dict(_hygroloom.frame_fields())


class WearRecording:
    """An open recording of a garment that was worn. Attributes as :class:`Recording`; about has panels, their fabrics and zones."""

    def __init__(self, path: Union[str, os.PathLike]):
        name = _checks.path_bytes(path, "path")
        self.path = pathlib.Path(os.fsdecode(name))
        self._place = self.path.absolute()  # for processes that are elsewhere
        self._file = _hygroloom.WearRecording(name)
        self.about: dict[str, Any] = self._file.about()
        self.times: np.ndarray = self.about.pop("times")

    def __len__(self) -> int:
        return len(self.times)

    def __reduce__(self):
        return WearRecording, (self._place,)

    @property
    def project(self) -> Project:
        """The project that was run."""
        return Project(self._file.design())

    def frame(self, index: int) -> dict[str, np.ndarray]:
        """Of each cell: inside, outside (kg of water over the start on the face to the skin and on the other), evaporated and on_skin (kg),
        temperature (K)."""
        return self._file.frame(_checks.place(index, "index", len(self)))

    def cells(self) -> dict[str, np.ndarray]:
        """Of each cell: panel and zone by number, flat (n, 2) and place (n, 3) in m, area in m2, capacity in kg."""
        return self._file.cells()


def open_recording(path: Union[str, os.PathLike]) -> Union[Recording, WearRecording]:
    """A recording, of a sample or of a garment. Raises FileError."""
    return WearRecording(path) if _hygroloom.is_wear_recording(_checks.path_bytes(path, "path")) else Recording(path)


def read_recording(path: Union[str, os.PathLike], *, cells: int = 2) -> "xarray.Dataset":
    """A recording (.hygrorec) as a Dataset. Nothing of a frame is read before its values are asked for.

    Args:
        path: the file; it may be that of a run that goes on, or was stopped.
        cells: of the maps: a cell is this many crossings wide and high.

    Returns:
        An ``xarray.Dataset``; each variable has its unit in ``attrs["units"]``, each run's origin stands in the Dataset's ``attrs``.

        * water_map (time, side, y, x), g/m2 over the start; side is top, bottom or total; x and y in mm from the sample's middle
        * saturation, liquid, bound_water, vapour_concentration, temperature, liquid_between (time, segment); see :func:`grid`
        * the series of the metrics file (time), such as wetted_radius_top_mm; the first that is used reads all frames once
        * the ledger (time), such as water_evaporated_kg and energy_lost_j; there at once

        Of a garment: inside, outside, evaporated, on_skin (kg) and temperature (K), each (time, cell), with panel, zone, place and area.

    Raises:
        FileError: the file is no recording or is damaged; when values are asked for: the frame is damaged, which it names.

    >>> ds = read_recording("cloth.hygrorec")
    >>> ds.water_map.sel(side="top").isel(time=-1).plot()
    """
    number = _checks.whole(cells, "cells", 1, 1000)
    recording = open_recording(path)
    return _of_garment(recording) if isinstance(recording, WearRecording) else _of_sample(recording, number)


def grid(values: "xarray.DataArray", system: str) -> "xarray.DataArray":
    """Of values of segments those of one system of yarns, as a view with the dimensions end and pick in segment's place.

    >>> warp = grid(ds.saturation.isel(time=-1), "warp")   # (end, pick)
    """
    import xarray

    _checks.word(system, "system", ("warp", "weft"))
    if not isinstance(values, xarray.DataArray) or values.dims[-1:] != ("segment",) or "ends" not in values.attrs:
        raise ValueError("values: These must be segments' values of read_recording(), such as ds.saturation.isel(time=-1).")
    ends, picks = values.attrs["ends"], values.attrs["picks"]
    if values.sizes["segment"] != 2 * ends * picks:
        raise ValueError("values: These must be the values of all segments.")
    half = values.variable[..., : ends * picks] if system == "warp" else values.variable[..., ends * picks :]
    order = ("end", "pick") if system == "warp" else ("pick", "end")
    shape = half.shape[:-1] + ((ends, picks) if system == "warp" else (picks, ends))
    array = xarray.DataArray(
        np.asarray(half.values).reshape(shape),
        dims=half.dims[:-1] + order,
        coords={dim: values.coords[dim] for dim in half.dims[:-1] if dim in values.coords},
        attrs=values.attrs,
        name=values.name,
    )
    return array.transpose(..., "end", "pick")


def _field_of(recording: Union[Recording, WearRecording], name: str, number: int) -> np.ndarray:
    frame = recording.frame(number, [name]) if isinstance(recording, Recording) else recording.frame(number)
    return frame[name]


def _maps_of(recording: Recording, cells: int, number: int) -> np.ndarray:
    return np.stack([recording.water_map(number, side, cells) for side in SIDES])


def _series_of(recording: Recording, key: str, number: int) -> np.ndarray:
    return recording.series()[key][number]


def _of_sample(recording: Recording, cells: int) -> "xarray.Dataset":
    import xarray

    from ._lazy import frames_of

    about = recording.about
    frames, ends, picks = len(recording), about["ends"], about["picks"]
    count = 2 * ends * picks
    values: dict[str, Any] = {}
    for name, unit in FIELDS.items():
        attrs = {"units": unit, "long_name": _FIELD_NAMES.get(name, name), "ends": ends, "picks": picks}
        values[name] = xarray.Variable(("time", "segment"), frames_of((frames, count), np.float32, partial(_field_of, recording, name)), attrs)

    yarns = about["yarns_per_cell"]
    cells = max(1, int(cells / yarns + 0.5))  # of the shown ones
    rows, columns = -(-picks // cells), -(-ends // cells)
    values["water_map"] = xarray.Variable(
        ("time", "side", "y", "x"),
        frames_of((frames, len(SIDES), rows, columns), np.float64, partial(_maps_of, recording, cells * yarns)),
        {"units": "g/m2", "long_name": "water over the start", "crossings_per_cell": cells * yarns},
    )
    for key, title in recording._file.series_titles():
        if key != "time_s":
            attrs = {"units": unit_of(key), "long_name": title}
            values[key] = xarray.Variable("time", frames_of((frames,), np.float64, partial(_series_of, recording, key)), attrs)
    for key, numbers in recording.ledger.items():
        if key != "time_s":
            values[key] = xarray.Variable("time", numbers, {"units": unit_of(key), "long_name": key.rsplit("_", 1)[0].replace("_", " ")})

    segments = recording.segments()
    middle = 1e3 * segments["middle"]
    across = lambda count, pitch, of: ((np.arange(count) + 0.5) * cells - 0.5 * of) * pitch  # noqa: E731
    coords = {
        "time": xarray.Variable("time", recording.times, {"units": "s", "long_name": "time"}),
        "side": ("side", list(SIDES)),
        "x": ("x", across(columns, about["end_pitch_mm"], ends), {"units": "mm", "long_name": "along the weft"}),
        "y": ("y", across(rows, about["pick_pitch_mm"], picks), {"units": "mm", "long_name": "along the warp"}),
        "system": ("segment", np.where(segments["system"] == 0, "warp", "weft")),
        "top": ("segment", segments["top"].astype(bool), {"long_name": "lies on the upper face"}),
        "end": ("segment", segments["end"]),
        "pick": ("segment", segments["pick"]),
        **{f"{axis}_mm": ("segment", middle[:, k], {"units": "mm"}) for k, axis in enumerate("xyz")},
    }
    attrs = {key: value for key, value in about.items() if key not in ("ends", "picks", "frames", "problems")}
    return xarray.Dataset(values, coords, {**attrs, "finished": int(about["finished"]), "recording": str(recording.path)})


def _of_garment(recording: WearRecording) -> "xarray.Dataset":
    import xarray

    from ._lazy import frames_of

    about, cells = recording.about, recording.cells()
    frames, count = len(recording), len(cells["panel"])
    units = {"inside": "kg", "outside": "kg", "evaporated": "kg", "on_skin": "kg", "temperature": "K"}
    names = {
        "inside": "water over the start on the face to the skin",
        "outside": "water over the start on the outer face",
        "evaporated": "evaporated since the start",
        "on_skin": "water under the cloth",
        "temperature": "temperature of the cloth",
    }
    values = {
        name: xarray.Variable(
            ("time", "cell"),
            frames_of((frames, count), np.float32 if name == "temperature" else np.float64, partial(_field_of, recording, name)),
            {"units": unit, "long_name": names[name]},
        )
        for name, unit in units.items()
    }
    coords = {
        "time": xarray.Variable("time", recording.times, {"units": "s", "long_name": "time"}),
        "panel": ("cell", np.array(about["panels"])[cells["panel"]]),
        "zone": ("cell", np.array(about["zones"])[cells["zone"]]),
        "flat_x_mm": ("cell", 1e3 * cells["flat"][:, 0], {"units": "mm"}),
        "flat_y_mm": ("cell", 1e3 * cells["flat"][:, 1], {"units": "mm"}),
        **{f"{axis}_mm": ("cell", 1e3 * cells["place"][:, k], {"units": "mm"}) for k, axis in enumerate("xyz")},
        "area": ("cell", cells["area"], {"units": "m2"}),
        "capacity": ("cell", cells["capacity"], {"units": "kg"}),
    }
    attrs = {key: value for key, value in about.items() if key not in ("panels", "fabrics", "zones", "frames")}
    return xarray.Dataset(values, coords, {**attrs, "finished": int(about["finished"]), "recording": str(recording.path)})
