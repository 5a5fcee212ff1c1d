#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsens a mesh with pyacvd and with the Python module of this package, and prints processor time and quality of both.

  compare_pyacvd.py FILE.off VERTICES

Needs surface_mesh_coarsening on the path of Python. pyacvd, which needs PyVista and pykdtree, is omitted if it is not installed.
Run the script by hand: nothing else of this package needs pyacvd.
"""

import sys
import time
from pathlib import Path

import numpy as np
import surface_mesh_coarsening as smc

try:
    import pyacvd
    import pyvista
except ImportError:
    pyacvd = None


def read_off(file):
    """A triangle mesh, as points and indices."""
    words = Path(file).read_text().split()
    points, faces = int(words[1]), int(words[2])
    at = 4 + 3 * points
    corners = np.array(words[at : at + 4 * faces], dtype=int).reshape(-1, 4)
    return np.array(words[4:at], dtype=float).reshape(-1, 3), corners[:, 1:]


def with_pyacvd(points, faces, number):
    mesh = pyvista.PolyData(points, np.insert(faces, 0, 3, axis=1).ravel())
    clustering = pyacvd.Clustering(mesh)
    clustering.cluster(number)
    coarse = clustering.create_mesh()
    return coarse.points, coarse.faces.reshape(-1, 4)[:, 1:]


def with_this_module(points, faces, number, **settings):
    result = smc.coarsen(points, faces, number, threads=1, **settings)
    return result.points, result.faces


def main(file, number):
    points, faces = read_off(file)
    plain = {"weight": "uniform", "placement": "centroid", "error_feedback": 0}
    print("program,processor_s,vertices,rms_percent,mean_smallest_angle,self_intersections")
    programs = [
        ("uniform and centroid", lambda: with_this_module(points, faces, number, **plain)),
        ("defaults", lambda: with_this_module(points, faces, number)),
    ]
    if pyacvd:
        programs.insert(0, ("pyacvd", lambda: with_pyacvd(points, faces, number)))
    for name, coarsen in programs:
        begin = time.process_time()
        coarse = coarsen()
        seconds = time.process_time() - begin
        row = [name, f"{seconds:.2f}", len(coarse[0])]
        try:
            quality = smc.measure(points, faces, *coarse)
            rms = 100 * quality["rms_distance"] / quality["diagonal"]
            row += [f"{rms:.4f}", f"{quality['mean_smallest_angle']:.1f}", quality["self_intersections"]]
        except ValueError as error:
            row.append(str(error))
        print(*row, sep=",")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
