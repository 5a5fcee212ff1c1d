// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Computes the stars, components and loops of a mesh from its faces; throws if these do not form a 2-manifold.
void complete_topology(Flat_mesh& mesh, std::size_t number_of_vertices, const Run_context& context);

// The same without components, which are not known of a part of a mesh.
void complete_stars(Flat_mesh& mesh, std::size_t number_of_vertices, const Run_context& context);

// Computes the densities of section 5.2, raised near borders on request.
std::vector<double> compute_densities(const Flat_mesh& mesh, double maximum, bool at_borders, const Run_context& context);

// Computes the areas of the faces, and their centroids where these are stored.
void compute_areas_and_centroids(Clustering_input& input, const Run_context& context = Run_context());

// Returns the input for pieces of the polygons of `whole`. Densities and parents are inherited.
Clustering_input cut_input(const Clustering_input& whole, Flat_mesh pieces, const std::vector<Index>& whole_face,
                           const Run_context& context = Run_context());

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_H
