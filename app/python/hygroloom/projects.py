# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Projects: read, change, check, save."""
from __future__ import annotations

import io
import json
import os
import pathlib
from typing import TYPE_CHECKING, Any, Mapping, Optional, Union

from . import _checks, _hygroloom
from .errors import Error, Issue

if TYPE_CHECKING:
    import pandas

_nothing = object()


class Project:
    """A project: fabrics, experiments, materials, liquids and garments.

    Made by :meth:`open` or :meth:`from_json`. Values are in trade units; each key ends in its unit, as in the file. Nothing is
    written before :meth:`save`.

    >>> project = Project.open("cloth.hygro")
    >>> project.set("fabrics[0].contact_angle_deg", 60)
    >>> project.get("fabrics.Textile F.ends_per_cm")
    35.0
    """

    def __init__(self, design: Any, path: Optional[pathlib.Path] = None):
        if not isinstance(design, _hygroloom.Design):
            raise TypeError("A project is made by Project.open(path) or Project.from_json(text).")
        self._design = design
        self.path = path  #: of its file; None: it has none yet

    @classmethod
    def open(cls, path: Union[str, os.PathLike]) -> "Project":
        """Reads a project file (.hygro).

        Raises:
            FileError: the file cannot be read, is no project, or has an unknown key or a value of a wrong type; the message names
                the place, what is allowed and what was given. Values out of range are for :meth:`validate`.
        """
        name = _checks.path_bytes(path, "path")
        return cls(_hygroloom.read_project(name), pathlib.Path(os.fsdecode(name)))

    @classmethod
    def from_json(cls, project: Union[str, Mapping[str, Any]]) -> "Project":
        """Of the text of a project file, or of a dictionary with the same keys. Raises FileError, as :meth:`open`."""
        text = project if isinstance(project, str) else _checks.json_text(project, "project")
        return cls(_hygroloom.parse_project(_checks.text(text, "project"), "project"))

    def set(self, path: str, value: Any) -> "Project":
        """Changes one value and returns the project, so that calls can follow each other.

        Args:
            path: such as ``"fabrics[0].contact_angle_deg"`` or, with names for numbers, ``"experiments.one drop.duration_s"``.
            value: a number, text, list or dictionary, as the file would hold it; None takes the key out, so that the program's
                own value holds.

        Raises:
            Error: there is no such place, or the value is of a wrong type; the project is then as it was.
        """
        self._design = _hygroloom.with_value(self._design, _checks.text(path, "path"), _checks.json_text(value, str(path)))
        return self

    def get(self, path: str, default: Any = _nothing) -> Any:
        """The value at a path, as :meth:`set` takes it; objects and lists as dictionaries and lists.

        Raises:
            Error: the path leads nowhere, or its last key is not set and there is no default.
        """
        value = _hygroloom.value_at(self._design, _checks.text(path, "path"))
        if value is not None:
            return json.loads(value)
        if default is not _nothing:
            return default
        raise Error(f"{path}: This is not set in the project; the program takes its own value.")

    def save(self, path: Union[str, os.PathLike, None] = None) -> pathlib.Path:
        """Writes the project and returns its path; without one to the file that it came from.

        The file is replaced as a whole; the version before stays beside it as ``.hygro~``. Raises FileError; the file is then unchanged.
        """
        if path is None and self.path is None:
            raise Error("The project has no file yet; give save() a path.")
        name = _checks.path_bytes(self.path if path is None else path, "path")
        _hygroloom.write_project(self._design, name)
        self.path = pathlib.Path(os.fsdecode(name))
        return self.path

    def validate(self) -> list[Issue]:
        """What is wrong or unusual, in the order of the file; an empty list: nothing. Errors refuse a run, warnings and notes do not."""
        return [Issue(*issue) for issue in _hygroloom.validate(self._design)]

    @property
    def fabrics(self) -> list[str]:
        """The names of the fabrics."""
        return _hygroloom.fabric_names(self._design)

    @property
    def experiments(self) -> list[str]:
        """The names of the experiments, those on garments last."""
        return [name for name, _ in _hygroloom.experiment_names(self._design)]

    @property
    def experiment_types(self) -> dict[str, str]:
        """The type of each experiment by its name, such as "droplet" or "wear"."""
        return dict(_hygroloom.experiment_names(self._design))

    def copy(self) -> "Project":
        """Another project with the same values."""
        return Project(self._design, self.path)

    def to_json(self) -> str:
        """The text that :meth:`save` writes."""
        return _hygroloom.format_project(self._design)

    def to_dict(self) -> dict[str, Any]:
        """The same as a dictionary."""
        return json.loads(self.to_json())

    def __reduce__(self):
        """As the text of its file, so that it can be sent to other processes."""
        return _of_json, (self.to_json(), self.path)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Project) and self._design == other._design

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<hygroloom.Project {str(self.path) if self.path else 'without a file'}: fabrics {self.fabrics}, experiments {self.experiments}>"


def _of_json(text: str, path: Optional[pathlib.Path]) -> Project:
    return Project(_hygroloom.parse_project(text, "project"), path)


def project_of(project: Any) -> Project:
    """A project, or the path of one."""
    if isinstance(project, Project):
        return project
    if isinstance(project, (str, os.PathLike)):
        return Project.open(project)
    raise TypeError(f"project: This must be a Project or the path of one; given is {project!r}.")


def folder_of(project: Project) -> bytes:
    """That the files of its garments are relative to."""
    return os.fsencode(project.path.parent if project.path else ".") or b"."


def read_yarns(library: Union[str, os.PathLike]) -> "pandas.DataFrame":
    """The yarns of a library (.hygrolib) of one's own, a row each, as ``hygroloom-cli yarns --write`` has them, with linear density
    and plies beside the count. A library that is not there is empty.

    Raises FileError when the file is no library.
    """
    import pandas

    return pandas.read_csv(io.StringIO(_hygroloom.yarn_table(_checks.path_bytes(library, "library"))))
