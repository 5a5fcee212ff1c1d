# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks and conversion of users' arrays for the compiled part, which relies on them."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional, Tuple, Union

import numpy as np

Faces = Union[Any, Tuple[Any, Any]]
"""Polygons: an integer array of shape (f, k); or the sizes of the polygons and their indices, in a tuple; or one array in which
the size of each polygon precedes its indices, as PyVista has it."""

_MOST_INDICES = 2**31 - 1  # the halfedges of a mesh have numbers of 32 bits


class Arrays(NamedTuple):
    """A mesh: points of shape (n, 3), the sizes of the polygons, and the indices of their corners."""

    points: np.ndarray
    sizes: np.ndarray
    indices: np.ndarray


def _array(values: Any, name: str) -> np.ndarray:
    try:
        array = np.asarray(values)
    except ValueError as e:  # rows of several lengths
        raise ValueError(f"{name} have rows of several lengths") from e
    if array.dtype == object and any(np.ndim(row) for row in array.flat):  # the same, with older versions of NumPy
        raise ValueError(f"{name} have rows of several lengths")
    return array


def integers(values: Any, name: str) -> np.ndarray:
    array = _array(values, name)
    if array.size and not np.issubdtype(array.dtype, np.integer):
        raise TypeError(f"{name} are of type {array.dtype}, not integers")
    return array


def labels(values: Any, name: str) -> np.ndarray:
    """Returns integers of 64 bits with sign."""
    array = integers(values, name)
    if array.size and array.max() > np.iinfo(np.int64).max:
        at = int(np.argmax(array))
        raise ValueError(f"{name} have the value {array.max()} at entry {at}, which exceeds 64 bits with sign")
    return np.ascontiguousarray(array, dtype=np.int64)


def numbers(values: Any, name: str) -> np.ndarray:
    array = _array(values, name)
    if array.size and array.dtype.kind not in "biuf":
        raise TypeError(f"{name} are of type {array.dtype}, not numbers")
    return np.ascontiguousarray(array, dtype=np.float64)


def per_face(array: Optional[np.ndarray], name: str, mesh: Arrays) -> Optional[np.ndarray]:
    if array is not None and array.shape != mesh.sizes.shape:
        raise ValueError(f"{name} have shape {array.shape}, but there are {mesh.sizes.size} faces")
    return array


def take_mesh(*arguments: Any) -> Tuple[Any, ...]:
    """Returns points, faces and the other arguments that are not None. A mesh of trimesh or PyVista, or a result of this module,
    may stand for points and faces: any object with `faces` and `vertices` or `points`."""
    first, others = arguments[0], tuple(a for a in arguments[1:] if a is not None)
    for name in ("vertices", "points"):
        if hasattr(first, "faces") and hasattr(first, name):
            return (getattr(first, name), first.faces) + others
    return (first,) + others


def mesh_arrays(points: Any, faces: Faces, prefix: str = "", *, finite: bool = True) -> Arrays:
    """`prefix` begins the names of the arguments in messages."""
    vertices = numbers(points, prefix + "points")
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise ValueError(f"{prefix}points have shape {vertices.shape}, not (n, 3)")
    sizes, indices = _sizes_and_indices(faces, prefix)
    _check_indices(sizes, indices, len(vertices))
    if finite:
        _check_finite(vertices, indices, prefix)
    return Arrays(vertices, np.ascontiguousarray(sizes, dtype=np.uint32), np.ascontiguousarray(indices, dtype=np.uint32))


def _check_indices(sizes: np.ndarray, indices: np.ndarray, vertices: int) -> None:
    """Checks ranges before conversion to 32 bits hides errors."""
    for corner in (int(np.argmin(indices)), int(np.argmax(indices))) if indices.size else ():
        if not 0 <= int(indices[corner]) < vertices:
            face = int(np.searchsorted(np.cumsum(sizes), corner, side="right"))
            raise ValueError(f"face {face} has vertex {int(indices[corner])} of {vertices}")


def _check_finite(vertices: np.ndarray, indices: np.ndarray, prefix: str) -> None:
    """Points that no face uses may be anything."""
    is_wrong = ~np.isfinite(vertices).all(axis=1)
    if is_wrong.any():
        wrong = indices[is_wrong[indices]]
        if wrong.size:
            point = ", ".join(map(str, vertices[wrong[0]]))
            raise ValueError(f"{prefix}points have ({point}) in row {int(wrong[0])}, which is not finite")


def diagonal(mesh: Arrays) -> float:
    used = mesh.points[np.unique(mesh.indices)]
    return float(np.linalg.norm(np.ptp(used, axis=0))) if len(used) else 0.0


def vertex_marks(values: Any, name: str, mesh: Arrays) -> np.ndarray:
    """Returns 0 or 1 for each vertex, of a mask or of the numbers of vertices."""
    array, number = _array(values, name), len(mesh.points)
    if array.dtype == bool:
        if array.shape != (number,):
            raise ValueError(f"{name} have shape {array.shape}, but there are {number} points")
        return array.astype(np.int64)
    chosen = integers(array, name).ravel()
    for i in (int(np.argmin(chosen)), int(np.argmax(chosen))) if chosen.size else ():
        if not 0 <= int(chosen[i]) < number:
            raise ValueError(f"{name} have vertex {int(chosen[i])} of {number} at entry {i}")
    marks = np.zeros(number, dtype=np.int64)
    marks[chosen.astype(np.int64)] = 1
    return marks


def edge_ends(values: Any, name: str) -> np.ndarray:
    array = labels(values, name)
    if array.size == 0:
        return np.zeros((0, 2), dtype=np.int64)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"{name} have shape {array.shape}, not (k, 2)")
    return array


def _check_sizes(sizes: np.ndarray, indices: int) -> np.ndarray:
    """Returns the sizes as 64-bit integers. Each one is compared before the sum, which then cannot wrap."""
    if indices > _MOST_INDICES or sizes.size > _MOST_INDICES:
        raise ValueError(f"{sizes.size} faces have {indices} indices, but at most {_MOST_INDICES} are possible")
    for face in (int(np.argmin(sizes)), int(np.argmax(sizes))) if sizes.size else ():
        if not 0 <= int(sizes[face]) <= indices:
            raise ValueError(f"face {face} has {int(sizes[face])} corners, but there are {indices} indices")
    sizes = sizes.astype(np.int64)
    if sizes.sum() != indices:
        raise ValueError(f"the sizes of the faces add up to {int(sizes.sum())}, but there are {indices} indices")
    return sizes


def _sizes_and_indices(faces: Faces, prefix: str) -> Tuple[np.ndarray, np.ndarray]:
    if isinstance(faces, tuple) and len(faces) == 2:
        sizes, indices = integers(faces[0], "sizes").ravel(), integers(faces[1], "indices").ravel()
        return _check_sizes(sizes, indices.size), indices
    array = integers(faces, prefix + "faces")
    if array.ndim == 2:
        return _check_sizes(np.full(array.shape[0], array.shape[1]), array.size), array.ravel()
    if array.ndim == 1:
        sizes, indices = _split_padded(array)
        return _check_sizes(sizes, indices.size), indices
    raise ValueError(f"{prefix}faces have shape {array.shape}, not (m, k)")


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
