# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsening of meshes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Sequence, TypedDict

import numpy as np

from . import _core
from .arrays import Faces, labels, mesh_arrays, numbers, per_face

if TYPE_CHECKING:
    from typing_extensions import Unpack


@dataclass(frozen=True)
class Coarsening:
    """A coarse mesh.

    points: vertices, an array of shape (n, 3)
    faces: triangles, an integer array of shape (m, 3)
    labels: the vertex of `points` that represents each face of the input; n for faces of removed components
    report: statistics, among others clusters, rounds and moves of the minimization, energies, and the intersections
        that the repair found and left
    """

    points: np.ndarray
    faces: np.ndarray
    labels: np.ndarray
    report: Dict[str, Any]


class Settings(TypedDict, total=False):
    """The keyword arguments that `coarsen()` and `coarsen_levels()` share."""

    weight: str
    placement: str
    maximum_density: float
    density: Any
    error_feedback: Optional[int]
    minimum_component_area: float
    subdivide: bool
    repair: bool
    iterations: Optional[int]
    convergence_tolerance: float
    threads: Optional[int]
    progress: Optional[Callable[[str, int, Optional[int]], Any]]


def _coarsen(
    points: Any,
    faces: Faces,
    options: "_core.Options",
    features: Optional[float] = None,
    patches: Any = None,
    *,
    weight: str = "area",
    placement: str = "fitted",
    maximum_density: float = 10,
    density: Any = None,
    error_feedback: Optional[int] = None,
    minimum_component_area: float = 0,
    subdivide: bool = False,
    repair: bool = True,
    iterations: Optional[int] = None,
    convergence_tolerance: float = 1e-3,
    threads: Optional[int] = None,
    progress: Optional[Callable[[str, int, Optional[int]], Any]] = None,
) -> List[Coarsening]:
    for name, number, least in (
        ("threads", threads, 1),
        ("iterations", iterations, 0),
        ("error_feedback", error_feedback, 0),
    ):
        if number is not None and number < least:
            raise ValueError(f"{name} is {number}, and has to be at least {least}")
    mesh = mesh_arrays(points, faces)
    options.weight, options.placement = weight, placement
    options.maximum_density = maximum_density
    options.feature_angle = 180.0 if features is None else features
    # Given densities determine the distribution of vertices.
    options.error_feedback = error_feedback if error_feedback is not None else 8 if density is None else 0
    options.minimum_component_area = minimum_component_area
    options.subdivide, options.repair = subdivide, repair
    options.iterations, options.convergence_tolerance = iterations, convergence_tolerance
    options.threads = threads or 0
    results = _core.coarsen(
        *mesh,
        options,
        per_face(None if density is None else numbers(density, "densities"), "densities", mesh),
        per_face(None if patches is None else labels(patches, "patches"), "patches", mesh),
        progress,
    )
    return [Coarsening(*result) for result in results]


def _positive(n: Any, name: str) -> int:
    number = int(n)
    if number != n or number < 1:
        raise ValueError(f"{name} is {n}")
    return number


def coarsen(
    points: Any,
    faces: Faces,
    n: Optional[int] = None,
    *,
    maximum_distance: Optional[float] = None,
    features: Optional[float] = None,
    patches: Any = None,
    **settings: Unpack[Settings],
) -> Coarsening:
    """Coarsens a mesh to `n` vertices, or to as few as keep it within `maximum_distance`.

    points: vertices, of shape (v, 3)
    faces: triangles or polygons: an integer array of shape (f, k), or the sizes of the polygons and their indices in a tuple,
        or one array in the layout of PyVista, in which the size of each polygon precedes its indices
    n: the number of vertices of the result
    maximum_distance: instead of `n`, a bound of the distance from the input, both ways, in its unit of length
    features: keeps edges whose normals differ by this angle in degrees or more
    patches: integers of the faces; edges between faces of different integers are kept
    settings: any of the following, which are settings of `coarsen_levels()`, too
    weight: "uniform", "area", the default, "maximum", "exact-maximum" or "variance"
    placement: "centroid", "closest-vertex", "quadric" or "fitted", the default
    maximum_density: densities run from 1 on flat parts to this, 10 by default, on the sharpest
    density: densities of the faces, in [1e-20, 1e20], instead of computed ones
    error_feedback: with the placement "fitted", rounds that relocate vertices to places of large distance; 8 by
        default, 0 with `density`
    minimum_component_area: removes connected components of smaller area
    subdivide: whether to subdivide faces internally until there are 20 for each vertex of the result
    repair: whether to move vertices and flip edges where triangles of the result intersect or are reversed; True by default
    iterations: the maximal number of rounds of the minimization
    convergence_tolerance: the minimization ends with the round that lowers the energy by no more than this part of it, 0.001
        by default
    threads: the maximal number of threads of this call; all by default. The result does not depend on it
    progress: is called with the name of the stage, the number of its rounds or repaired faults so far, and the largest number
        of them, which is None in the minimization and in stages without rounds

    Raises UnreachableNumberOfVertices or UnreachableDistance, both with `nearest`, and ValueError for other input that cannot be
    coarsened; the message names the element. Ctrl-C ends it, and so does an exception of `progress`. Other threads of the
    interpreter run meanwhile.
    """
    if (n is None) == (maximum_distance is None):
        raise TypeError("coarsen() takes either n or maximum_distance")
    options = _core.Options()
    if n is not None:
        options.vertices = [_positive(n, "the number of vertices")]
    else:
        options.maximum_distance = maximum_distance
    return _coarsen(points, faces, options, features, patches, **settings)[0]


def coarsen_levels(
    points: Any,
    faces: Faces,
    numbers: Sequence[int],
    **settings: Unpack[Settings],
) -> List[Coarsening]:
    """Coarsens a mesh to levels of detail with `numbers` of vertices, from fine to coarse.

    The first equals the result of `coarsen()`; each cluster of a level is a union of clusters of the previous level, so
    `labels` nest. The settings are the keyword arguments of `coarsen()` but `features` and `patches`.

    Raises UnreachableNumberOfVertices if a level has too few vertices for the topology of the mesh.
    """
    options = _core.Options()
    options.vertices = [_positive(n, f"the number of vertices of level {i}") for i, n in enumerate(numbers)]
    if not options.vertices:
        raise ValueError("there are no numbers of vertices")
    if any(fine < coarse for fine, coarse in zip(options.vertices, options.vertices[1:])):
        raise ValueError("the numbers of vertices do not fall")
    return _coarsen(points, faces, options, **settings)
