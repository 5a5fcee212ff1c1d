# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsens surface meshes to an exact number of vertices.

The result is a 2-manifold triangle mesh with the genus, borders, components and orientation of the input. The same input and
arguments give the same result, for any number of threads.

    import surface_mesh_coarsening as smc
    result = smc.coarsen(points, faces, 1000)
    result.points, result.faces
"""

from ._core import version as __version__
from .coarsening import Coarsening, coarsen, coarsen_levels
from .errors import UnreachableDistance, UnreachableNumberOfVertices
from .measuring import measure
from .transferring import Transferred, transfer

__all__ = [
    "Coarsening",
    "Transferred",
    "UnreachableDistance",
    "UnreachableNumberOfVertices",
    "__version__",
    "coarsen",
    "coarsen_levels",
    "measure",
    "transfer",
]
