# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of coarse meshes."""

from __future__ import annotations

from typing import Any, Dict, Union

from . import _core
from .arrays import Faces, mesh_arrays, take_mesh
from .checks import whole


def measure(
    points: Any, faces: Faces = None, coarse_points: Any = None, coarse_faces: Faces = None, *, samples: int = 100000
) -> Dict[str, Union[float, int, Dict[str, float]]]:
    """Measures how well the second mesh approximates the first. Both may be objects, as in `coarsen()`: `measure(mesh, result)`.

    Distances and deviations of normals are the larger of both ways, from `samples` samples each, in the unit of the meshes, for
    surfaces and for borders; angles are in degrees. Keys: rms_distance, mean_distance, maximum_distance, border_rms_distance,
    border_mean_distance, border_maximum_distance, rms_normal_deviation, mean_normal_deviation, maximum_normal_deviation,
    from_mesh and from_coarse (dictionaries of the surface's distances and deviations one way), mean_smallest_angle,
    smallest_angle, part_below_30_degrees, self_intersections (pairs of faces of the second mesh), diagonal (of the bounding box of the first).
    """
    points, faces, *coarse = take_mesh(points, faces, coarse_points, coarse_faces)
    coarse = take_mesh(*coarse) if coarse else ()
    if len(coarse) != 2:
        raise TypeError("measure() takes two meshes, each as an object or as points and faces")
    mesh, coarse_mesh = mesh_arrays(points, faces), mesh_arrays(*coarse, "coarse_")
    return _core.measure(*mesh, *coarse_mesh, whole(samples, "samples", 1))
