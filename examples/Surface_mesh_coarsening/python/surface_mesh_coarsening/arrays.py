# SPDX-License-Identifier: GPL-3.0-or-later
"""Conversion of users' arrays for the compiled part."""

from __future__ import annotations

from typing import Any, NamedTuple, Tuple, Union

import numpy as np

Faces = Union[Any, Tuple[Any, Any]]
"""Polygons: an integer array of shape (f, k); or the sizes of the polygons and their indices, in a tuple; or one array in which
the size of each polygon precedes its indices, as PyVista has it."""


class Arrays(NamedTuple):
    """A mesh: points of shape (n, 3), the sizes of the polygons, and the indices of their corners."""

    points: np.ndarray
    sizes: np.ndarray
    indices: np.ndarray


def integers(values: Any, name: str) -> np.ndarray:
    array = np.asarray(values)
    if array.size and not np.issubdtype(array.dtype, np.integer):
        raise TypeError(f"{name} are of type {array.dtype}, not integers")
    return array


def mesh_arrays(points: Any, faces: Faces) -> Arrays:
    vertices = np.ascontiguousarray(points, dtype=np.float64)
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise ValueError(f"points have shape {vertices.shape}, not (n, 3)")
    sizes, indices = _sizes_and_indices(faces)
    _check_indices(sizes, indices, len(vertices))
    return Arrays(vertices, np.ascontiguousarray(sizes, dtype=np.uint32), np.ascontiguousarray(indices, dtype=np.uint32))


def _check_indices(sizes: np.ndarray, indices: np.ndarray, vertices: int) -> None:
    """Checks ranges before conversion to 32 bits hides errors."""
    if indices.size == 0:
        return
    for corner in (int(np.argmin(indices)), int(np.argmax(indices))):
        if not 0 <= indices[corner] < vertices:
            face = int(np.searchsorted(np.cumsum(sizes), corner, side="right"))
            raise ValueError(f"face {face} has vertex {int(indices[corner])} of {vertices}")


def _sizes_and_indices(faces: Faces) -> Tuple[np.ndarray, np.ndarray]:
    if isinstance(faces, tuple) and len(faces) == 2:
        sizes, indices = integers(faces[0], "sizes").ravel(), integers(faces[1], "indices").ravel()
        if sizes.size and sizes.min() < 0:
            raise ValueError(f"face {int(np.argmin(sizes))} has {int(sizes.min())} corners")
        if sizes.sum() != indices.size:
            raise ValueError(f"the sizes of the faces add up to {int(sizes.sum())}, but there are {indices.size} indices")
        return sizes, indices
    array = integers(faces, "faces")
    if array.ndim == 2:
        return np.full(array.shape[0], array.shape[1]), array.ravel()
    if array.ndim == 1:
        return _split_padded(array)
    raise ValueError(f"faces have shape {array.shape}, not (m, k)")


def _split_padded(array: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Splits an array in which the size of each polygon precedes it into sizes and indices."""
    if array.size and array[0] >= 0 and array.size % (int(array[0]) + 1) == 0:
        rows = array.reshape(-1, int(array[0]) + 1)  # all of one size, as they mostly are
        if (rows[:, 0] == array[0]).all():
            return rows[:, 0], rows[:, 1:].ravel()
    sizes, is_index, at = [], np.ones(array.size, dtype=bool), 0
    while at < array.size:
        size = int(array[at])
        if size < 0 or at + size >= array.size:
            raise ValueError(f"face {len(sizes)} has size {size} at entry {at} of {array.size}")
        is_index[at] = False
        sizes.append(size)
        at += size + 1
    return np.asarray(sizes, dtype=np.int64), array[is_index]
