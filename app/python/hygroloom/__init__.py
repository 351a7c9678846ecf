# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Hygroloom: how woven fabric absorbs, spreads and loses water, from Python.

>>> import hygroloom
>>> project = hygroloom.Project.open("cloth.hygro")
>>> run = hygroloom.simulate(project, "Textile F", "one drop", fidelity="draft")
>>> run.metrics["maximum_wetted_radius_top_mm"]
>>> run.dataset.water_map.sel(side="top").isel(time=-1)

Runs and their numbers: :func:`simulate`, :func:`measure`, :func:`compare`, :func:`calibrate`, :func:`sweep`, :func:`card`, :func:`verify`.
Files: :class:`Project`, :func:`read_yarns`, :func:`read_recording`, :class:`Recording`, :class:`WearRecording`, :func:`grid`.
What goes wrong: :class:`Error`, :class:`FileError`, :class:`DeviceError`, :class:`InvalidProject`.
Names end in their unit: ``_mm``, ``_g``, ``_s``, ``_c``, ``_pct``; values without one are SI, with the unit in ``attrs["units"]``.
"""
from .errors import DeviceError, Error, FileError, InvalidProject, Issue
from .projects import Project, read_yarns
from .recordings import FIELDS, Recording, WearRecording, grid, open_recording, read_recording
from .runs import Run, card, measure, simulate, verify, verify_cases
from .studies import Calibration, calibrate, compare, sweep
from ._hygroloom import version as __version__

__all__ = [
    "Calibration", "DeviceError", "Error", "FIELDS", "FileError", "InvalidProject", "Issue", "Project", "Recording", "Run",
    "WearRecording", "calibrate", "card", "compare", "grid", "measure", "open_recording", "read_recording", "read_yarns", "simulate", "sweep", "verify", "verify_cases",
]  # fmt: skip
