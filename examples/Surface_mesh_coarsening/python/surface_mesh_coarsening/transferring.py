# SPDX-License-Identifier: GPL-3.0-or-later
"""Transfer of values of a mesh to its coarse mesh."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Tuple

import numpy as np

from . import _core
from .arrays import Arrays, Faces, labels, mesh_arrays, take_mesh
from .coarsening import Coarsening

_POLICIES = ("interpolated", "conservative", "majority")


@dataclass(frozen=True)
class Transferred:
    """Values of the vertices, faces and corners of a coarse mesh by name. Values of corners have shape (m, 3, ...)."""

    vertex: Dict[str, np.ndarray]
    face: Dict[str, np.ndarray]
    corner: Dict[str, np.ndarray]


def _rows(values: Any, element: str, name: str, mesh: Arrays) -> np.ndarray:
    """Returns the values with one row per element; values of corners may be arranged by faces."""
    array = np.asarray(values)
    number = {"vertex": len(mesh.points), "face": len(mesh.sizes), "corner": len(mesh.indices)}[element]
    if element == "corner" and array.ndim > 1 and len(array) != number and array.shape[0] * array.shape[1] == number:
        array = array.reshape((number,) + array.shape[2:])
    if array.ndim == 0 or len(array) != number:
        raise ValueError(f"the values '{name}' have shape {array.shape}, but there are {number} of element {element}")
    return array


def _as_numbers(rows: np.ndarray, element: Any, policy: str) -> Tuple[Any, Callable[[np.ndarray], np.ndarray]]:
    def back(result: np.ndarray) -> np.ndarray:
        shaped = result.reshape((len(result),) + rows.shape[1:])
        if np.issubdtype(rows.dtype, np.integer):
            shaped = np.clip(np.rint(shaped), np.iinfo(rows.dtype).min, np.iinfo(rows.dtype).max)
        return shaped.astype(rows.dtype, copy=False)

    flat = np.ascontiguousarray(rows.reshape(len(rows), -1), dtype=np.float64)
    return _core.Values(element, getattr(_core.TransferPolicy, policy), flat), back


def _distinct(rows: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Returns the distinct rows in their order, and their number for each row. Objects need only be equal or not, and have a hash:
    they are numbered as they appear."""
    if rows.dtype != object:
        return np.unique(rows, axis=0, return_inverse=True)
    first: Dict[Any, int] = {}
    numbers = [first.setdefault(row if rows.ndim == 1 else tuple(row.flat), len(first)) for row in rows]
    at = {number: i for i, number in reversed(list(enumerate(numbers)))}
    return rows[[at[number] for number in range(len(first))]], np.asarray(numbers)


def _as_labels(rows: np.ndarray, element: Any, name: str) -> Tuple[Any, Callable[[np.ndarray], np.ndarray]]:
    """Numbers values of any type."""
    try:
        distinct, numbers = _distinct(rows)
    except TypeError as e:
        raise TypeError(f"the values '{name}' cannot be compared: {e}") from e
    return _core.Values(element, numbers.reshape(-1).astype(np.int64)), lambda result: distinct[result]


def _clusters(coarsening: Coarsening, mesh: Arrays) -> np.ndarray:
    clusters, vertices = labels(coarsening.labels, "labels"), len(coarsening.points)
    if clusters.shape != mesh.sizes.shape:
        raise ValueError(f"the coarsening is of {clusters.size} faces, the mesh has {mesh.sizes.size}")
    for face in (int(np.argmin(clusters)), int(np.argmax(clusters))) if clusters.size else ():
        if not 0 <= clusters[face] <= vertices:
            raise ValueError(f"face {face} has label {clusters[face]} in a coarsening of {vertices} vertices")
    return clusters


def _mesh_and_clusters(
    function: str, points: Any, faces: Faces, coarsening: Any
) -> Tuple[Arrays, np.ndarray, Coarsening]:
    points, faces, *rest = take_mesh(points, faces, coarsening)
    if len(rest) != 1 or not isinstance(rest[0], Coarsening):
        raise TypeError(f"{function}() takes a mesh, or points and faces, and a Coarsening")
    mesh = mesh_arrays(points, faces)
    return mesh, _clusters(rest[0], mesh), rest[0]


def _default_policy(rows: np.ndarray, name: str) -> str:
    is_color = rows.dtype == np.uint8 and rows.ndim == 2 and rows.shape[1] in (3, 4)
    has_name_of_color = np.issubdtype(rows.dtype, np.integer) and name in ("red", "green", "blue", "alpha")
    return "interpolated" if is_color or has_name_of_color or np.issubdtype(rows.dtype, np.floating) else "majority"


class VertexSources(NamedTuple):
    """The nearest point of the mesh for each vertex of a coarse mesh.

    faces: the face of each point
    coordinates: the part of each corner of the face, of shape (n, k) for faces of up to k sides; the rows add up to 1
    """

    faces: np.ndarray
    coordinates: np.ndarray


def vertex_sources(points: Any, faces: Faces = None, coarsening: Optional[Coarsening] = None) -> VertexSources:
    """Finds the nearest point of the mesh for each vertex of its coarse mesh. The arguments are those of `transfer()`."""
    mesh, clusters, coarsening = _mesh_and_clusters("vertex_sources", points, faces, coarsening)
    return VertexSources(*_core.sources(*mesh, clusters, *mesh_arrays(coarsening.points, coarsening.faces)))


def _check_policies(policy: Mapping[str, str], names: List[str]) -> None:
    for name, value in policy.items():
        if value not in _POLICIES:
            raise ValueError(f"there is no policy '{value}' ({', '.join(_POLICIES)})")
        if name not in names:
            raise ValueError(f"there is a policy for '{name}', but no values")


def transfer(
    points: Any,
    faces: Faces = None,
    coarsening: Optional[Coarsening] = None,
    *,
    vertex: Optional[Mapping[str, Any]] = None,
    face: Optional[Mapping[str, Any]] = None,
    corner: Optional[Mapping[str, Any]] = None,
    policy: Optional[Mapping[str, str]] = None,
) -> Transferred:
    """Transfers values of a mesh to its coarse mesh.

    points, faces: the mesh that `coarsening` was made of, as in `coarsen()`
    vertex, face, corner: arrays by name, with a row per vertex, face or corner; values of corners, such as texture
        coordinates, are in the order of the faces, or of shape (f, k, ...)
    policy: the transfer by name. "interpolated": the value at the nearest point, the default for floating-point numbers and
        for colors: arrays of `uint8` with 3 or 4 columns, and integers with the names red, green, blue and alpha.
        "conservative": keeps integrals over the surface. "majority": the value of largest area, the default for all
        other values, such as integers, strings and objects. Values of corners are interpolated within their face, never across a seam, or
        taken from the nearest corner instead of a majority.

    The results have the types of the given arrays; integers are rounded.
    """
    mesh, clusters, coarsening = _mesh_and_clusters("transfer", points, faces, coarsening)
    given = [(e, n, v) for e, all_of in (("vertex", vertex), ("face", face), ("corner", corner)) for n, v in (all_of or {}).items()]
    policy = policy or {}
    _check_policies(policy, [name for _, name, _ in given])
    values, backs = [], []
    for element, name, array in given:
        rows = _rows(array, element, name, mesh)
        how = policy.get(name, _default_policy(rows, name))
        if how != "majority" and not (np.issubdtype(rows.dtype, np.floating) or np.issubdtype(rows.dtype, np.integer)):
            raise TypeError(f"the values '{name}' are of type {rows.dtype}, which has no means")
        kind = getattr(_core.Element, element)
        value, back = _as_labels(rows, kind, name) if how == "majority" else _as_numbers(rows, kind, how)
        values.append(value)
        backs.append(back)
    results = _core.transfer(*mesh, clusters, *mesh_arrays(coarsening.points, coarsening.faces), values)
    transferred = Transferred({}, {}, {})
    for (element, name, _), back, result in zip(given, backs, results):
        array = back(result)
        if element == "corner":
            array = array.reshape((len(coarsening.faces), 3) + array.shape[1:])
        getattr(transferred, element)[name] = array
    return transferred
