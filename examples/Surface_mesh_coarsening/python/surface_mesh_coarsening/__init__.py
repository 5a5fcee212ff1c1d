# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsens surface meshes to an exact number of vertices.

The result is a 2-manifold triangle mesh with the genus, borders, components and orientation of the input. The same input and
arguments give the same result, for any number of threads.

    import surface_mesh_coarsening as smc
    result = smc.coarsen(points, faces, 1000)
    result.points, result.faces
"""

from ._core import version as __version__
from .coarsening import Coarsening, VertexNumberRange, coarsen, coarsen_levels, face_densities, vertex_number_range
from .errors import UnreachableDistance, UnreachableNumberOfVertices
from .measuring import measure
from .repairing import Repaired, repair
from .transferring import Transferred, VertexSources, transfer, vertex_sources

__all__ = [
    "Coarsening",
    "Repaired",
    "Transferred",
    "UnreachableDistance",
    "UnreachableNumberOfVertices",
    "VertexNumberRange",
    "VertexSources",
    "__version__",
    "coarsen",
    "coarsen_levels",
    "face_densities",
    "measure",
    "repair",
    "transfer",
    "vertex_number_range",
    "vertex_sources",
]
