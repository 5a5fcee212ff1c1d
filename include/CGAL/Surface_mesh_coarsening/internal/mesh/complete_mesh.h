// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_COMPLETE_MESH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Computes the stars, components and loops of a mesh from its faces; throws if these do not form a 2-manifold.
void complete_topology(Flat_mesh& mesh, std::size_t number_of_vertices, const Run_context& context);

// The same without components, which are not known of a part of a mesh.
void complete_stars(Flat_mesh& mesh, std::size_t number_of_vertices, const Run_context& context);

class Flat_mesh_builder
{
public:
  explicit Flat_mesh_builder(std::vector<Vector> points)
  {
    mesh_.points = std::move(points);
    mesh_.first_corner.push_back(0);
  }

  void reserve(std::size_t faces, std::size_t corners)
  {
    mesh_.first_corner.reserve(faces + 1);
    mesh_.corner_vertex.reserve(corners);
    mesh_.face_across.reserve(corners);
  }

  Index add_point(const Vector& p)
  {
    mesh_.points.push_back(p);
    return Index(mesh_.points.size() - 1);
  }

  // Adds a corner to the face, and the face across the edge after it; NONE on the border.
  void add_corner(Index vertex, Index face_across)
  {
    mesh_.corner_vertex.push_back(vertex);
    mesh_.face_across.push_back(face_across);
  }

  void end_face() { mesh_.first_corner.push_back(Index(mesh_.corner_vertex.size())); }

  // Throws if the faces do not form a 2-manifold.
  Flat_mesh finish(const Run_context& context = Run_context())
  {
    check_countable(mesh_.corner_vertex.size(), "face corners after faces were cut");
    complete_topology(mesh_, mesh_.points.size(), context);
    return std::move(mesh_);
  }

protected:
  Flat_mesh mesh_;
};

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
