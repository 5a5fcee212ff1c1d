// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Cluster_growth.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What a record of a cell has besides its corners. The moments are sums of areas times centroids. The same sums weighted by the
// density may be weighted by the deviation instead, because densities are linear in deviations.
struct Cell_data
{
  Index corners = 0, faces = 0;
  double area = 0, weighted_area = 0;
  Vector moment{{0, 0, 0}}, weighted_moment{{0, 0, 0}};
  std::uint64_t origin = 0;   // of the face that represents the cell
  Vector center{{0, 0, 0}}; // the centroid of this face

  void add(const Face_geometry& face, double density)
  {
    ++faces;
    area += face.area;
    weighted_area += density * face.area;
    moment = moment + face.area * face.centroid;
    weighted_moment = weighted_moment + (density * face.area) * face.centroid;
  }
};

// The number of a vertex of a cell, and the numbers of the previous and the next vertex on the boundary.
struct Cell_corner
{
  std::uint64_t vertex, before, after;
  Vector point;
};

struct Cell_record : Cell_data
{
  std::vector<Cell_corner> corner;
  std::vector<std::uint64_t> begins_star; // for each corner, whether the star of the vertex begins in the cell
};

inline void write_record(const Cell_record& cell, Words& words)
{
  write_records(static_cast<const Cell_data*>(&cell), 1, words);
  write_records(cell.corner.data(), cell.corner.size(), words);
  write_records(cell.begins_star.data(), cell.begins_star.size(), words);
}

inline const std::uint64_t* read_record(const std::uint64_t* word, Cell_record& cell)
{
  word = read_records(word, static_cast<Cell_data*>(&cell), 1);
  cell.corner.resize(cell.corners);
  cell.begins_star.resize(cell.corners);
  return read_records(read_records(word, cell.corner.data(), cell.corners), cell.begins_star.data(), cell.corners);
}

// Divides the own faces of a patch into cells, closed discs that are clustered like faces. A face is a cell of its own if other
// patches have faces at one of its vertices, or if it lies at the border of the mesh. Hence cells of several faces meet only
// cells of the same patch, and all their tests are local.
class Cells
{
public:
  // Level 0: each face is a cell.
  Cells(const Patch& patch, Index level, const Run_context& context)
    : patch_(patch),
      mesh_(patch.mesh),
      labels_(patch.mesh),
      context_(context)
  {
    std::vector<Index> inner;
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (level > 0 && is_inner(f))
        inner.push_back(f);
      else
        labels_.set(f, single_++);
    cells_ = single_;
    if (!inner.empty())
      grow(inner, level);
    labels_.recount();
    number_cells();
    sum_up();
    choose_corners();
  }

  std::size_t size() const { return boundary_edge_.size(); }
  // NONE for faces of other patches.
  Index cell_of(Index f) const { return number_[labels_[f]]; }
  // Whether a face represents its cell: of all faces of the cell, its centroid is nearest to the centroid of the cell.
  bool is_center(Index f) const { return patch_.is_own(f) && center_[cell_of(f)] == f; }

  // Calls `receive(record)` for each cell.
  template <class Receive>
  void write(const Receive& receive) const
  {
    Cell_record cell;
    std::vector<Index> boundary;
    for (std::size_t i = 0; i < size(); ++i) {
      static_cast<Cell_data&>(cell) = data_[i];
      list_boundary(boundary_edge_[i], boundary);
      list_corners(boundary, labels_[boundary_edge_[i].face], cell);
      receive(cell);
    }
  }

private:
  bool is_inner(Index f) const
  {
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
      if (!patch_.is_inner[mesh_.corner_vertex[c]] || mesh_.is_on_border(mesh_.corner_vertex[c]))
        return false;
    return true;
  }

  void grow(const std::vector<Index>& faces, Index level)
  {
    std::vector<Index> seeds;
    Seed_walk(mesh_, context_).run(faces, level, seeds);
    Cluster_growth growth(labels_, context_);
    for (const Index f : seeds)
      growth.plant(f, cells_++);
    growth.run();
    cells_ = growth.cover(faces, cells_);
    Cluster_splitting<std::vector<Index> > splitting(labels_, faces, cells_, context_, nullptr, single_);
    splitting.run();
    cells_ = splitting.number_of_clusters();
  }

  // Numbers the cells in the order of their first faces.
  void number_cells()
  {
    const Dual_walk walk(labels_);
    number_.assign(cells_, NONE);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (patch_.is_own(f)) {
        Index& number = number_[labels_[f]];
        if (number == NONE) {
          number = Index(boundary_edge_.size());
          boundary_edge_.push_back({});
        }
        if (boundary_edge_[number].face == NONE)
          boundary_edge_[number] = walk.boundary_edge(f);
      }
  }

  void sum_up()
  {
    data_.resize(size());
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (patch_.is_own(f))
        data_[cell_of(f)].add(face_geometry(mesh_, f), patch_.faces[f].density);
    center_.assign(size(), NONE);
    std::vector<double> nearest(size());
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      if (!patch_.is_own(f))
        continue;
      const Index x = cell_of(f);
      const Vector offset = data_[x].area * mean_of_corners(mesh_, f) - data_[x].moment;
      if (center_[x] == NONE || dot(offset, offset) < nearest[x]) {
        center_[x] = f;
        nearest[x] = dot(offset, offset);
      }
    }
    for (std::size_t i = 0; i < size(); ++i) {
      data_[i].origin = patch_.faces[center_[i]].origin;
      data_[i].center = face_geometry(mesh_, center_[i]).centroid;
    }
  }

  // A vertex is a corner of the incident cells if there are at least three of them, or if one of them is a single face. Cells
  // with fewer than three corners then get additional corners.
  void choose_corners()
  {
    is_corner_.assign(mesh_.number_of_vertices(), false);
    std::vector<Index> runs;
    for (Index v = 0; v < is_corner_.size(); ++v) {
      clusters_around_vertex(labels_, v, runs);
      is_corner_[v] = runs.size() > 2 || std::any_of(runs.begin(), runs.end(), [this](Index x) { return x < single_; });
    }
    std::vector<Index> boundary;
    for (const Directed_edge& start : boundary_edge_) {
      if (labels_[start.face] < single_)
        continue;
      list_boundary(start, boundary);
      auto corners = std::count_if(boundary.begin(), boundary.end(), [this](Index v) { return is_corner_[v]; });
      for (std::size_t i = 0; corners < 3; ++i)
        if (!is_corner_[boundary[i]]) {
          is_corner_[boundary[i]] = true;
          ++corners;
        }
    }
  }

  // Lists the vertices around a cell, counterclockwise.
  void list_boundary(const Directed_edge& start, std::vector<Index>& boundary) const
  {
    boundary.clear();
    const Dual_walk walk(labels_);
    Directed_edge e = start;
    do {
      boundary.push_back(mesh_.corner_vertex[e.corner]);
      e = walk.next_on_boundary(e);
    } while (!(e == start));
  }

  void list_corners(const std::vector<Index>& boundary, Index label, Cell_record& cell) const
  {
    cell.corner.clear();
    cell.begins_star.clear();
    const auto number = [&](std::size_t i) { return patch_.number[boundary[i % boundary.size()]]; };
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const Index v = boundary[i];
      if (!is_corner_[v])
        continue;
      cell.corner.push_back({number(i), number(i + boundary.size() - 1), number(i + 1), mesh_.points[v]});
      cell.begins_star.push_back(labels_[mesh_.star[mesh_.first_in_star[v]]] == label);
    }
    cell.corners = Index(cell.corner.size());
  }

  const Patch& patch_;
  const Flat_mesh& mesh_;
  Cluster_labels labels_;
  const Run_context context_;
  Index single_ = 0, cells_ = 0;             // labels below `single_` belong to single faces of this or other patches
  std::vector<Index> number_;                // of the cell of each label; NONE for faces of other patches
  std::vector<Directed_edge> boundary_edge_; // of each cell
  std::vector<Cell_data> data_;              // of each cell
  std::vector<Index> center_;                // the representative face of each cell
  std::vector<char> is_corner_;              // of each vertex
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H
