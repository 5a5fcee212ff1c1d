# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsening of meshes."""

from __future__ import annotations

import functools
import inspect
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Dict, List, NamedTuple, Optional, Sequence, TypedDict

import numpy as np

from . import _core
from .arrays import Arrays, Faces, diagonal, edge_ends, labels, mesh_arrays, numbers, per_face, take_mesh, vertex_marks
from .checks import flag, real, text, whole
from .errors import UnreachableDistance

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
    boundary_counts: the number of edges at each vertex of the input that lie between two clusters or on the border; None if a
        distance was requested, and for all levels but the first
    patches: the integer of each face, if the input has `patches`; None for all levels but the first
    """

    points: np.ndarray
    faces: np.ndarray
    labels: np.ndarray
    report: Dict[str, Any]
    boundary_counts: Optional[np.ndarray] = None
    patches: Optional[np.ndarray] = None

    def to_trimesh(self) -> Any:
        """Returns a `trimesh.Trimesh`, with vertices and faces in this order."""
        import trimesh

        return trimesh.Trimesh(self.points, self.faces, process=False)

    def to_pyvista(self) -> Any:
        """Returns a `pyvista.PolyData`."""
        import pyvista

        padded = np.concatenate([np.full((len(self.faces), 1), 3), self.faces], axis=1)
        return pyvista.PolyData(self.points, padded.ravel())


class VertexNumberRange(NamedTuple):
    """The smallest and the largest number of vertices that can be requested."""

    least: int
    most: int


class Settings(TypedDict, total=False):
    """The keyword arguments that `coarsen()` and `coarsen_levels()` share."""

    energy: str
    weight: str
    placement: Optional[str]
    maximum_density: Optional[float]
    density: Any
    paper: bool
    mean_angle: float
    error_feedback: Optional[int]
    minimum_component_area: float
    subdivide: bool
    repair_output: Optional[bool]
    iterations: Optional[int]
    convergence_tolerance: Optional[float]
    threads: Optional[int]
    progress: Optional[Callable[[str, int, Optional[int]], Any]]


_DEFAULTS: Dict[str, Any] = {
    "energy": "weighted",
    "weight": "area",
    "placement": None,
    "maximum_density": None,
    "density": None,
    "paper": False,
    "mean_angle": 40,
    "error_feedback": None,
    "minimum_component_area": 0,
    "subdivide": False,
    "repair_output": None,
    "iterations": None,
    "convergence_tolerance": None,
    "threads": None,
    "progress": None,
}


def _with_settings(function: Callable[..., Any]) -> Callable[..., Any]:
    """Lists the settings with their defaults in the signature, instead of `**settings`, and binds calls to it."""
    own = list(inspect.signature(function).parameters.values())[:-1]
    types = Settings.__annotations__
    kind = inspect.Parameter.KEYWORD_ONLY
    listed = [inspect.Parameter(n, kind, default=d, annotation=types[n]) for n, d in _DEFAULTS.items()]
    signature = inspect.signature(function).replace(parameters=own + listed)

    @functools.wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        try:
            signature.bind(*arguments, **keywords)
        except TypeError as e:
            raise TypeError(f"{function.__name__}() {e}") from None
        return function(*arguments, **keywords)

    call.__signature__ = signature  # type: ignore[attr-defined]
    return call


def _options(settings: Dict[str, Any]) -> "_core.Options":
    s = {**_DEFAULTS, **settings}

    def chosen(name: str, default: Any) -> Any:
        return default if s[name] is None else s[name]

    options = _core.Options()
    options.energy, options.weight = text(s["energy"], "energy"), text(s["weight"], "weight")
    if options.energy != "weighted" and options.weight != "area":
        raise ValueError(f"weight is '{options.weight}', but the energy '{options.energy}' has no weight")
    paper = options.paper = flag(s["paper"], "paper")
    options.placement = text(chosen("placement", "centroid" if paper else "fitted"), "placement")
    most = (3 if options.weight == "variance" else 50) if paper else 10
    options.maximum_density = real(chosen("maximum_density", most), "maximum_density")
    # Given densities determine the distribution of vertices.
    feedback = 12 if s["density"] is None and not paper else 0
    options.mean_angle = real(s["mean_angle"], "mean_angle")
    options.error_feedback = whole(chosen("error_feedback", feedback), "error_feedback")
    options.minimum_component_area = real(s["minimum_component_area"], "minimum_component_area")
    options.subdivide = flag(s["subdivide"], "subdivide")
    options.repair_output = flag(chosen("repair_output", not paper), "repair_output")
    options.iterations = None if s["iterations"] is None else whole(s["iterations"], "iterations")
    options.convergence_tolerance = real(chosen("convergence_tolerance", 0 if paper else 1e-3), "convergence_tolerance")
    if s["threads"] is not None:
        options.threads = min(whole(s["threads"], "threads", 1), os.cpu_count() or 1)
    if s["progress"] is not None and not callable(s["progress"]):
        raise TypeError(f"progress is {s['progress']!r}, which cannot be called")
    return options


def _fields(
    mesh: Arrays,
    options: "_core.Options",
    features: Optional[float] = None,
    patches: Any = None,
    keep_edges: Any = None,
    keep_vertices: Any = None,
    keep_borders: bool = False,
) -> "_core.Fields":
    fields = _core.Fields()
    options.feature_angle = 180.0 if features is None else real(features, "features")
    options.keep_borders = flag(keep_borders, "keep_borders")
    if patches is not None:
        fields.patches = per_face(labels(patches, "patches"), "patches", mesh)
    if keep_edges is not None:
        fields.keep_edges = edge_ends(keep_edges, "keep_edges")
    if keep_vertices is not None:
        fields.keep_vertices = vertex_marks(keep_vertices, "keep_vertices", mesh)
    return fields


def _coarsen(mesh: Arrays, options: "_core.Options", fields: "_core.Fields", settings: Dict[str, Any]) -> List[Coarsening]:
    density = settings.get("density")
    if density is not None:
        fields.density = per_face(numbers(density, "densities"), "densities", mesh)
    return [Coarsening(*result) for result in _core.coarsen(*mesh, options, fields, settings.get("progress"))]


def _start_clusters(values: Any, mesh: Arrays) -> np.ndarray:
    clusters = labels(values, "start_clusters")
    per_face(clusters, "start_clusters", mesh)
    if clusters.size and clusters.min() < 0:
        raise ValueError(f"start_clusters have {clusters.min()} at entry {int(np.argmin(clusters))}")
    return clusters


def _set_target(options: "_core.Options", fields: "_core.Fields", mesh: Arrays, name: str, value: Any) -> None:
    if name == "n":
        options.vertices = [whole(value, "the number of vertices n", 1)]
    elif name == "vertex_ratio":
        options.vertex_ratio = real(value, name)
    elif name == "target_reduction":
        reduction = real(value, name)
        if not 0 <= reduction < 1:
            raise ValueError(f"target_reduction is {reduction}, not in [0, 1)")
        options.vertex_ratio = 1 - reduction
    elif name == "number_of_faces":
        options.faces = whole(value, name, 1)
    elif name == "level":
        options.level = whole(value, name)
    elif name == "start_clusters":
        fields.clusters = _start_clusters(value, mesh)
    else:
        distance = real(value, name) * (diagonal(mesh) if name == "maximum_distance" else 1)
        options.maximum_distance = min(distance, float(np.finfo(float).max))


# The targets that may be given together with a distance.
_LIMITS = ("n", "vertex_ratio", "target_reduction")


def _relative_to(length: float, error: UnreachableDistance) -> UnreachableDistance:
    """Returns the error with a nearest distance in parts of `length`, rounded up."""
    nearest = error.nearest / length
    while nearest * length < error.nearest:
        nearest = float(np.nextafter(nearest, np.inf))
    return UnreachableDistance(f"{error.args[0]}, in the unit of the mesh, whose diagonal is {length:.4g}", nearest)


@_with_settings
def coarsen(
    points: Any,
    faces: Faces = None,
    n: Optional[int] = None,
    *,
    vertex_ratio: Optional[float] = None,
    target_reduction: Optional[float] = None,
    number_of_faces: Optional[int] = None,
    level: Optional[int] = None,
    maximum_distance: Optional[float] = None,
    maximum_distance_absolute: Optional[float] = None,
    start_clusters: Any = None,
    features: Optional[float] = None,
    patches: Any = None,
    keep_edges: Any = None,
    keep_vertices: Any = None,
    keep_borders: bool = False,
    keep_small: bool = False,
    **settings: Unpack[Settings],
) -> Coarsening:
    """Coarsens a mesh to `n` vertices, or to one of the next seven arguments instead. A distance may be given together with `n`,
    `vertex_ratio` or `target_reduction`, which is then the maximum. A level may be given together with `n`: its seeds are merged.

    points: vertices, of shape (v, 3); or a mesh, which stands for `points` and `faces`: any object with the attributes `faces` and
        `vertices` (trimesh) or `points` (PyVista)
    faces: triangles or polygons: an integer array of shape (f, k), or the sizes of the polygons and their indices in a tuple,
        or one array in the layout of PyVista, in which the size of each polygon precedes its indices
    n: the number of vertices of the result
    vertex_ratio: the number of vertices of the result divided by the number of vertices of the input
    target_reduction: the part of the vertices to be removed, 1 - vertex_ratio
    number_of_faces: the number of triangles of the result; the nearest possible number, if this number is not possible
    level: the level of the neighborhoods of the seeds, which gives the number of vertices (section 6 of the paper)
    maximum_distance: as few vertices as keep the result within this distance of the input, both ways, in parts of the diagonal
        of the input's bounding box
    maximum_distance_absolute: the same in the unit of length of the mesh
    start_clusters: a cluster for each face, numbered from 0, from which the minimization starts
    features: keeps edges whose normals differ by this angle in degrees or more
    patches: integers of the faces; edges between faces of different integers are kept
    keep_edges: edges to keep as lines, as pairs of vertices, of shape (k, 2)
    keep_vertices: vertices to keep at their points, as their numbers or a mask of shape (v,)
    keep_borders: whether to keep all vertices and edges of borders
    keep_small: with `vertex_ratio` or `target_reduction`, whether components that cannot be reduced to it stay as they are
    settings: any of the following, which are settings of `coarsen_levels()`, too
    energy: "weighted", the default, "quadric" or "normals"
    weight: "uniform", "area", the default, "maximum", "exact-maximum" or "variance"
    placement: "centroid", "closest-vertex", "quadric" or "fitted", the default
    maximum_density: densities run from 1 on flat parts to this, 10 by default, on the sharpest
    density: densities of the faces, in [1e-20, 1e20], instead of computed ones
    paper: whether to run the method as printed in the paper: placement "centroid", maximum_density 50 (weight "variance": 3),
        error_feedback 0, repair_output False and convergence_tolerance 0 unless given, no densities for borders, merging by area,
        and the check by boundary-edge counts
    mean_angle: with the placement "fitted", the mean of the triangles' smallest angles to aim at, in degrees from 0 to 60;
        smaller angles bring the surfaces closer
    error_feedback: with the placement "fitted", at most this number of rounds relocates vertices to places of large
        distance; 12 by default, 0 with `density`
    minimum_component_area: removes connected components of smaller area
    subdivide: whether to subdivide faces internally until there are 20 for each vertex of the result
    repair_output: whether to move vertices and flip edges where triangles of the result intersect or are reversed; True by
        default. Function `repair()` repairs the input
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
    points, faces, *number = take_mesh(points, faces, n)
    targets = {
        "n": number[0] if number else None,
        "vertex_ratio": vertex_ratio,
        "target_reduction": target_reduction,
        "number_of_faces": number_of_faces,
        "level": level,
        "maximum_distance": maximum_distance,
        "maximum_distance_absolute": maximum_distance_absolute,
        "start_clusters": start_clusters,
    }
    given = [name for name, value in targets.items() if value is not None]
    is_pair = len(given) == 2 and given[0] in _LIMITS and given[1].startswith("maximum_distance") or given == ["n", "level"]
    if len(given) != 1 and not is_pair or len(number) > 1:
        raise TypeError(f"coarsen() takes either of {', '.join(targets)}, not {' and '.join(given) or 'none'}")
    if keep_small and (is_pair or given[0] not in ("vertex_ratio", "target_reduction")):
        raise ValueError("keep_small goes with vertex_ratio or target_reduction, without a distance")
    options = _options(dict(settings))
    mesh = mesh_arrays(points, faces)
    fields = _fields(mesh, options, features, patches, keep_edges, keep_vertices, keep_borders)
    options.keep_small = flag(keep_small, "keep_small")
    for name in given:
        _set_target(options, fields, mesh, name, targets[name])
    try:
        return _coarsen(mesh, options, fields, dict(settings))[0]
    except UnreachableDistance as e:
        if given[-1] == "maximum_distance":
            raise _relative_to(diagonal(mesh), e) from None
        raise


@_with_settings
def coarsen_levels(
    points: Any,
    faces: Faces = None,
    numbers: Optional[Sequence[int]] = None,
    **settings: Unpack[Settings],
) -> List[Coarsening]:
    """Coarsens a mesh to levels of detail with `numbers` of vertices, from fine to coarse.

    The first equals the result of `coarsen()`; each cluster of a level is a union of clusters of the previous level, so
    `labels` nest. `points`, `faces` and the settings are those of `coarsen()`. Features cannot be kept.

    Raises UnreachableNumberOfVertices if a level has too few vertices for the topology of the mesh.
    """
    points, faces, *rest = take_mesh(points, faces, numbers)
    if len(rest) != 1:
        raise TypeError("coarsen_levels() takes a mesh, or points and faces, and numbers of vertices")
    options = _options(dict(settings))
    options.vertices = [whole(n, f"the number of vertices of level {i}", 1) for i, n in enumerate(rest[0])]
    if not options.vertices:
        raise ValueError("there are no numbers of vertices")
    if any(fine < coarse for fine, coarse in zip(options.vertices, options.vertices[1:])):
        raise ValueError("the numbers of vertices do not fall")
    mesh = mesh_arrays(points, faces)
    return _coarsen(mesh, options, _core.Fields(), dict(settings))


def vertex_number_range(
    points: Any,
    faces: Faces = None,
    *,
    features: Optional[float] = None,
    patches: Any = None,
    keep_edges: Any = None,
    keep_vertices: Any = None,
    keep_borders: bool = False,
    minimum_component_area: float = 0,
    subdivide: bool = False,
    threads: Optional[int] = None,
    progress: Optional[Callable[[str, int, Optional[int]], Any]] = None,
) -> VertexNumberRange:
    """Returns the smallest and the largest number of vertices that `coarsen()` accepts with the same arguments."""
    mesh = mesh_arrays(*take_mesh(points, faces))
    options = _options(
        {"minimum_component_area": minimum_component_area, "subdivide": subdivide, "threads": threads, "progress": progress}
    )
    fields = _fields(mesh, options, features, patches, keep_edges, keep_vertices, keep_borders)
    return VertexNumberRange(*_core.range(*mesh, options, fields, progress))


def face_densities(points: Any, faces: Faces = None, *, maximum_density: float = 10, paper: bool = False) -> np.ndarray:
    """Returns the densities of the faces that `coarsen()` computes with the same arguments."""
    mesh = mesh_arrays(*take_mesh(points, faces))
    return _core.face_densities(*mesh, real(maximum_density, "maximum_density"), flag(paper, "paper"))
