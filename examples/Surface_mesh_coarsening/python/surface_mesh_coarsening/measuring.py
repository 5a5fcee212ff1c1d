# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of coarse meshes."""

from __future__ import annotations

from typing import Any, Dict, Union

from . import _core
from .arrays import Faces, mesh_arrays


def measure(
    points: Any, faces: Faces, coarse_points: Any, coarse_faces: Faces, *, samples: int = 100000
) -> Dict[str, Union[float, int, Dict[str, float]]]:
    """Measures how well the second mesh approximates the first.

    Distances and deviations of normals are the larger of both ways, from `samples` samples each, in the unit of the meshes, for
    surfaces and for borders; angles are in degrees. Keys: rms_distance, mean_distance, maximum_distance, border_rms_distance,
    border_mean_distance, border_maximum_distance, rms_normal_deviation, mean_normal_deviation, maximum_normal_deviation,
    from_mesh and from_coarse (dictionaries of the surface's distances and deviations one way), mean_smallest_angle,
    smallest_angle, part_below_30_degrees, self_intersections (pairs of faces of the second mesh), diagonal (of the bounding box of the first).
    """
    if samples < 1:
        raise ValueError(f"the number of samples is {samples}")
    return _core.measure(*mesh_arrays(points, faces), *mesh_arrays(coarse_points, coarse_faces), samples)
