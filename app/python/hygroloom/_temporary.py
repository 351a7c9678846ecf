# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""What goes with the process: its temporary folders, and runs of threads that nobody waits for."""
from __future__ import annotations

import atexit
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
    try:
        folder = tempfile.mkdtemp(prefix="hygroloom-")
    except OSError as error:
        raise FileError(f"A temporary folder cannot be made: {error.strerror}.") from None
    _folders[folder] = os.getpid()
    return folder


def remove(folder: str) -> None:
    """Unless it is that of another process, from which this one was forked."""
    if _folders.pop(folder, None) == os.getpid():
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


atexit.register(_at_exit)
multiprocessing.util.register_after_fork(_in_child, _in_child)  # forgets what was to be finalized before
if multiprocessing.parent_process() is not None:
    _in_child()
