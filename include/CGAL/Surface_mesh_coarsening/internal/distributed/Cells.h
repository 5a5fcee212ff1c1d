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

// Divides the own faces of a patch into cells, closed discs that are clustered like faces. A face is a cell of its own if other
// patches have faces at one of its vertices, or if it lies at the border of the mesh. Hence cells of several faces meet only
// cells of the same patch, and all their tests are local.
class Cells
{
public:
  // Level 0: each face is a cell.
  Cells(const Patch& patch, Index level, const Cancellation_point& cancellation)
    : patch_(patch),
      mesh_(patch.mesh),
      labels_(patch.mesh),
      cancellation_(cancellation)
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

  // Calls `receive(words)` for each cell: sums, the representative face, and corners with their neighbors along the boundary.
  template <class Receive>
  void write(const Receive& receive) const
  {
    std::vector<Corner> corners;
    Words words;
    for (std::size_t i = 0; i < size(); ++i) {
      corners.clear();
      words.clear();
      list_corners(boundary_edge_[i], corners);
      words.push_back(packed(Index(corners.size()), sums_[i].faces));
      sums_[i].write(words);
      words.push_back(patch_.faces.origin[center_[i]]);
      for (const double x : face_geometry(mesh_, center_[i]).centroid)
        words.push_back(to_word(x));
      for (const Corner& c : corners)
        write(c, words);
      receive(words);
    }
  }

private:
  // The sums of areas and first moments, and the same sums weighted by `density`. `density` may be a deviation, because densities
  // are linear in deviations.
  struct Sums
  {
    Index faces = 0;
    double area = 0, weighted_area = 0;
    Vector moment{{0, 0, 0}}, weighted_moment{{0, 0, 0}};

    void add(const Flat_mesh& m, Index f, double density)
    {
      const Face_geometry geometry = face_geometry(m, f);
      ++faces;
      area += geometry.area;
      weighted_area += density * geometry.area;
      moment = moment + geometry.area * geometry.centroid;
      weighted_moment = weighted_moment + (density * geometry.area) * geometry.centroid;
    }

    void write(Words& words) const
    {
      words.push_back(to_word(area));
      words.push_back(to_word(weighted_area));
      for (const double x : moment)
        words.push_back(to_word(x));
      for (const double x : weighted_moment)
        words.push_back(to_word(x));
    }
  };

  // A vertex of a cell, with the previous and the next vertex on the boundary, and whether the star of the vertex begins in the
  // cell.
  struct Corner
  {
    Index vertex, before, after;
    bool begins_star;
  };

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
    Seed_walk(mesh_, cancellation_).run(faces, level, seeds);
    Cluster_growth growth(labels_, cancellation_);
    for (const Index f : seeds)
      growth.plant(f, cells_++);
    growth.run();
    cells_ = growth.cover(faces, cells_);
    Cluster_splitting<std::vector<Index> > splitting(labels_, faces, cells_, cancellation_, Execution::SEQUENTIAL, nullptr,
                                                     single_);
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
    sums_.resize(size());
    for (Index f = 0; f < mesh_.number_of_faces(); ++f)
      if (patch_.is_own(f))
        sums_[cell_of(f)].add(mesh_, f, patch_.faces.density[f]);
    center_.assign(size(), NONE);
    std::vector<double> nearest(size());
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      if (!patch_.is_own(f))
        continue;
      const Index x = cell_of(f);
      const Vector offset = sums_[x].area * mean_of_corners(mesh_, f) - sums_[x].moment;
      if (center_[x] == NONE || dot(offset, offset) < nearest[x]) {
        center_[x] = f;
        nearest[x] = dot(offset, offset);
      }
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

  void list_corners(const Directed_edge& start, std::vector<Corner>& corners) const
  {
    std::vector<Index> boundary;
    list_boundary(start, boundary);
    const std::size_t n = boundary.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Index v = boundary[i];
      if (!is_corner_[v])
        continue;
      const Index first = mesh_.star[mesh_.first_in_star[v]];
      corners.push_back({v, boundary[(i + n - 1) % n], boundary[(i + 1) % n], labels_[first] == labels_[start.face]});
    }
  }

  void write(const Corner& c, Words& words) const
  {
    words.push_back(c.begins_star);
    words.push_back(patch_.number[c.vertex]);
    words.push_back(patch_.number[c.before]);
    words.push_back(patch_.number[c.after]);
    for (const double x : mesh_.points[c.vertex])
      words.push_back(to_word(x));
  }

  const Patch& patch_;
  const Flat_mesh& mesh_;
  Cluster_labels labels_;
  Cancellation_point cancellation_;
  Index single_ = 0, cells_ = 0;             // labels below `single_` belong to single faces of this or other patches
  std::vector<Index> number_;                // of the cell of each label; NONE for faces of other patches
  std::vector<Directed_edge> boundary_edge_; // of each cell
  std::vector<Sums> sums_;                   // of each cell
  std::vector<Index> center_;                // the representative face of each cell
  std::vector<char> is_corner_;              // of each vertex
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H
