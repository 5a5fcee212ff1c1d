# SPDX-License-Identifier: GPL-3.0-or-later
"""Repair of meshes that are no oriented 2-manifolds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Tuple, Union

import numpy as np

from . import _core
from .arrays import Faces, mesh_arrays, take_mesh
from .checks import real


@dataclass(frozen=True)
class Repaired:
    """A repaired mesh, which the other functions take as it is.

    points: vertices, an array of shape (n, 3)
    faces: an integer array of shape (m, k) if all faces have k sides, otherwise their sizes and indices
    report: the number of repaired faults by description
    """

    points: np.ndarray
    faces: Union[np.ndarray, Tuple[np.ndarray, np.ndarray]]
    report: Dict[str, int]


def repair(points: Any, faces: Faces = None, *, fill_holes: float = 0) -> Repaired:
    """Repairs a mesh to an oriented 2-manifold, as option --repair of the tool does: merges coincident points, removes
    repeated and degenerate faces, orients faces, and separates what is not a manifold.

    points, faces: as in `coarsen()`
    fill_holes: fills holes whose border is at most as long as this, in the unit of length of the mesh; `math.inf` fills all
    """
    length = real(fill_holes, "fill_holes")
    if length < 0:
        raise ValueError(f"fill_holes is {length}, and has to be at least 0")
    mesh = mesh_arrays(*take_mesh(points, faces), finite=False)
    new_points, sizes, indices, report = _core.repair(*mesh, length)
    if sizes.size and (sizes == sizes[0]).all():
        return Repaired(new_points, indices.astype(np.int64).reshape(-1, int(sizes[0])), report)
    return Repaired(new_points, (sizes.astype(np.int64), indices.astype(np.int64)), report)
