# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""What goes with the process: its temporary folders, and runs of threads that nobody waits for."""
from __future__ import annotations

import atexit
import glob
import multiprocessing
import multiprocessing.util
import os
import shutil
import tempfile
import threading
from typing import Any

from . import _hygroloom
from .errors import FileError

_folders: dict[str, int] = {}  #: and the process that made each


def make() -> str:
    """A folder that is there until remove(), or until the process ends. Raises FileError."""
    parent = multiprocessing.parent_process()
    try:
        folder = tempfile.mkdtemp(prefix="hygroloom-" if parent is None else _prefix_of_children(parent.pid))
    except OSError as error:
        raise FileError(f"A temporary folder cannot be made: {error.strerror}.") from None
    _folders[folder] = os.getpid()
    return folder


def remove(folder: str) -> None:
    """Unless it is that of another process, from which this one was forked."""
    if _folders.pop(folder, None) == os.getpid():
        shutil.rmtree(folder, ignore_errors=True)


def _prefix_of_children(parent: int) -> str:
    return f"hygroloom-of-{parent}-"


def _remove_of_children() -> None:
    """A pool ends its processes wherever they are, also while they remove a folder. They are gone when this is called."""
    for folder in glob.glob(os.path.join(glob.escape(tempfile.gettempdir()), _prefix_of_children(os.getpid()) + "*")):
        shutil.rmtree(folder, ignore_errors=True)


def _at_exit() -> None:
    _hygroloom.end_all_work()
    for folder in list(_folders):
        remove(folder)


def _at_exit_of_child() -> None:
    """multiprocessing ends children without atexit, and waits for their threads only after this."""
    for thread in threading.enumerate():
        if not thread.daemon and thread is not threading.current_thread():
            thread.join()
    _at_exit()


def _in_child(_: Any = None) -> None:
    multiprocessing.util.Finalize(None, _at_exit_of_child, exitpriority=-100)
    multiprocessing.util.Finalize(None, _remove_of_children, exitpriority=-200)


atexit.register(_at_exit)
multiprocessing.util.register_after_fork(_in_child, _in_child)  # forgets what was to be finalized before
if multiprocessing.parent_process() is not None:
    _in_child()
else:
    multiprocessing.util.Finalize(None, _remove_of_children, exitpriority=-200)
