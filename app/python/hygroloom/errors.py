# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""What hygroloom raises. Each message is a full sentence, the same that hygroloom-cli prints."""
from __future__ import annotations

from typing import NamedTuple


class Issue(NamedTuple):
    """Something that is wrong, or unusual, at one place of a project."""

    severity: str  #: "note", "warning" or "error"; an error refuses a run
    code: str  #: stable, for programs, such as "range"
    where: str  #: path into the project, such as "fabrics[0].warp.diameter_mm"
    text: str  #: what, the allowed range, and what was given


class Error(Exception):
    """Something failed; the message says what and where."""


class FileError(Error, OSError):
    """A file cannot be read or written, or is damaged; the message names it and the place in it."""


class DeviceError(Error, RuntimeError):
    """A GPU is missing, lost or out of memory."""


class InvalidProject(Error, ValueError):
    """A run was asked for of a project that has errors.

    Attributes:
        issues: all issues of the project, a list of :class:`Issue`.
    """

    def __init__(self, sentence: str, issues=()):
        super().__init__(sentence)
        self.issues = [Issue(*issue) for issue in issues]
