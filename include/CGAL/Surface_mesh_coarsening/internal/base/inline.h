// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_INLINE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_INLINE_H

// Functions of the headers NAME_impl.h are inline if the package is used header-only. They are not inline if
// CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE is defined; then the core is compiled once into a library.
#ifdef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#define CGAL_SURFACE_MESH_COARSENING_INLINE
#else
#define CGAL_SURFACE_MESH_COARSENING_INLINE inline
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_INLINE_H
