// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_choice.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Dual_parts.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/cut_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A surface that approximates the input, on one rank: each cell of several faces is a fan of triangles around a point of the
// cell. There are several triangles for each triangle of the coarse mesh, so all vertices can be fitted to this surface in place
// of the input, and the placement can be repaired. Its border is the border of the input, because the faces on the border are
// cells.
class Cell_surface
{
public:
  Cell_surface(const Cell_mesh& cells, const Flat_mesh& mesh) : corner_across_(cells.corners_across())
  {
    if (mesh.corner_vertex.size() >= NONE / 6)
      throw Invalid_input("the mesh of cells has " + std::to_string(mesh.corner_vertex.size()) +
                          " corners, more than the " + std::to_string(NONE / 6 - 1) + " to which vertices can be fitted");
    const std::size_t size = mesh.number_of_faces();
    first_corner_.reserve(size + 1);
    for (std::size_t x = 0; x <= size; ++x)
      first_corner_.push_back(mesh.first_corner[x]);
    corner_vertex_ = mesh.corner_vertex;
    center_.reserve(size);
    cell_of_origin_.reserve(size);
    points_.reserve(mesh.points.size() + size);
    points_.insert(points_.end(), mesh.points.begin(), mesh.points.end());
    for (Index x = 0; x < size; ++x) {
      center_.push_back(cells.faces()[x] > 1 ? Index(points_.size()) : NONE);
      if (center_[x] != NONE)
        points_.push_back(cells.centers()[x]);
      cell_of_origin_.emplace_back(cells.origins()[x], x);
    }
    std::sort(cell_of_origin_.begin(), cell_of_origin_.end());
  }

  // Fits the vertices to this surface if the placement does so, and repairs the placement on request. Called once. The parts know
  // the clusters of the faces that represent cells.
  Repair_counts place(const Dual_parts& parts, const Distributed_choice& choice, const Output_coordinates& output_coordinates,
                      const Cancellation_point& cancellation, std::vector<Triangle>& triangles, std::vector<Vector>& positions)
  {
    const Clustering_input input = make_input(cancellation, choice.execution);
    Cluster_labels labels(input.mesh);
    set_labels(parts, labels);
    labels.recount();
    const Clustered_faces surface(input, labels, parts.bounds(), choice.execution, cancellation);
    const Border_arcs border(surface, choice.places_on_borders);
    border.place(positions);
    if (choice.placement.from_start) {
      cancellation.stage_begins(Coarsening_stage::PLACEMENT);
      choice.placement.from_start(surface, border, triangles, positions);
      cancellation.stage_ends(Coarsening_stage::PLACEMENT);
    }
    if (!choice.repairs_output)
      return Repair_counts();
    Repair_budget budget(input.mesh.number_of_faces());
    return repair_placement(surface, border, choice.placement, output_coordinates, triangles, positions, budget, cancellation);
  }

private:
  Index degree(Index x) const { return first_corner_[x + 1] - first_corner_[x]; }
  Index number_of_faces_in(Index x) const { return center_[x] == NONE ? 1 : degree(x); }

  Clustering_input make_input(const Cancellation_point& cancellation, Execution execution)
  {
    first_face_.assign(1, 0);
    for (Index x = 0; x < center_.size(); ++x)
      first_face_.push_back(first_face_.back() + number_of_faces_in(x));
    Clustering_input input;
    Flat_mesh& m = input.mesh;
    m.first_corner.reserve(first_face_.back() + 1);
    m.corner_vertex.reserve(3 * first_face_.back());
    m.face_across.reserve(3 * first_face_.back());
    m.first_corner.push_back(0);
    for (Index x = 0; x < center_.size(); ++x) {
      cancellation.poll(degree(x));
      for (Index c = first_corner_[x]; c != first_corner_[x + 1]; ++c)
        add_side(x, c, m);
      if (center_[x] == NONE)
        m.first_corner.push_back(Index(m.corner_vertex.size()));
    }
    m.points.swap(points_);
    first_corner_ = corner_vertex_ = corner_across_ = center_ = std::vector<Index>(); // frees their memory
    complete_stars(m, m.points.size(), cancellation, execution);
    compute_areas_and_centroids(input, cancellation, execution);
    input.density.assign(input.area.size(), 1);
    return input;
  }

  // Adds the triangle at a side of a cell, or the corner of a single face.
  void add_side(Index x, Index c, Flat_mesh& m) const
  {
    const Index begin = first_corner_[x], sides = degree(x), i = c - begin;
    m.corner_vertex.push_back(corner_vertex_[c]);
    m.face_across.push_back(corner_across_[c] == NONE ? NONE : face_at(corner_across_[c]));
    if (center_[x] == NONE)
      return;
    m.corner_vertex.push_back(corner_vertex_[begin + (i + 1) % sides]);
    m.face_across.push_back(first_face_[x] + (i + 1) % sides);
    m.corner_vertex.push_back(center_[x]);
    m.face_across.push_back(first_face_[x] + (i + sides - 1) % sides);
    m.first_corner.push_back(Index(m.corner_vertex.size()));
  }

  // Returns the face at the side that begins at a corner of the mesh of cells.
  Index face_at(Index c) const
  {
    const Index x = Index(std::upper_bound(first_corner_.begin(), first_corner_.end(), c) - first_corner_.begin() - 1);
    return center_[x] == NONE ? first_face_[x] : first_face_[x] + (c - first_corner_[x]);
  }

  // A face belongs to the cluster of the face that represents its cell.
  void set_labels(const Dual_parts& parts, Cluster_labels& labels) const
  {
    for (const Dual_parts::Center_part& part : parts.centers) {
      const auto cell = std::lower_bound(cell_of_origin_.begin(), cell_of_origin_.end(), std::make_pair(part.origin, Index(0)));
      const Index x = cell->second;
      for (Index f = first_face_[x]; f != first_face_[x + 1]; ++f)
        labels.set(f, part.cluster);
    }
  }

  std::vector<Index> first_corner_;                // of each cell, and the total
  std::vector<Index> corner_vertex_, corner_across_; // of each corner
  std::vector<Index> center_;                      // the vertex within each cell; NONE if the cell is a single face
  std::vector<Vector> points_;
  std::vector<std::pair<std::uint64_t, Index> > cell_of_origin_;
  std::vector<Index> first_face_; // of each cell, and the total
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_SURFACE_H
