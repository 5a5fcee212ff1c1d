// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_BUILDER_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_BUILDER_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh_topology.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Numbering.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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
  Flat_mesh finish(const Cancellation_point& cancellation = Cancellation_point())
  {
    check_countable(mesh_.corner_vertex.size(), "face corners after faces were cut");
    Flat_mesh_topology::complete(mesh_, mesh_.points.size(), cancellation);
    return std::move(mesh_);
  }

private:
  Flat_mesh mesh_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FLAT_MESH_BUILDER_H
