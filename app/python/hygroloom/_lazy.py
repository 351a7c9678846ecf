# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""Arrays of recordings that are read when their values are asked for."""
from __future__ import annotations

from typing import Any, Callable

import numpy as np
from xarray.backends import BackendArray
from xarray.core import indexing


class Frames(BackendArray):
    """An array of which xarray reads only the frames that it needs. read(number): the values of one, of the shape without its time;
    other processes can be sent it."""

    def __init__(self, shape: tuple[int, ...], dtype: Any, read: Callable[[int], np.ndarray]):
        self.shape, self.dtype, self.read = shape, np.dtype(dtype), read

    def __getitem__(self, key: Any) -> Any:
        return indexing.explicit_indexing_adapter(key, self.shape, indexing.IndexingSupport.OUTER, self._read)

    def _read(self, key: tuple) -> np.ndarray:
        times, rest = key[0], key[1:]
        if isinstance(times, (int, np.integer)):
            return _outer(self.read(int(times)), rest)
        numbers = np.arange(self.shape[0])[times]
        empty = np.empty((0,) + self.shape[1:], self.dtype)
        if len(numbers) == 0:
            return _outer(empty, (slice(None),) + rest)
        return np.stack([_outer(self.read(int(number)), rest) for number in numbers])


def frames_of(shape: tuple[int, ...], dtype: Any, read: Callable[[int], np.ndarray]) -> indexing.LazilyIndexedArray:
    return indexing.LazilyIndexedArray(Frames(shape, dtype, read))


def _outer(values: np.ndarray, key: tuple) -> np.ndarray:
    """Each dimension by its own key."""
    for axis, one in reversed(list(enumerate(key))):
        if not (isinstance(one, slice) and one == slice(None)):
            values = values[(slice(None),) * axis + (one,)]
    return values
