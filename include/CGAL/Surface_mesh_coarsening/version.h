// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_VERSION_H
#define CGAL_SURFACE_MESH_COARSENING_VERSION_H

/// \file version.h
/// The version of the package.

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The version of the package as a string literal, `"major.minor.patch"`.
#define CGAL_SURFACE_MESH_COARSENING_VERSION "0.1.0"

#endif // CGAL_SURFACE_MESH_COARSENING_VERSION_H
