// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Cluster_growth.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// What remains of a cell when its sums are in the input of the clustering.
struct Cell
{
  Index corners = 0, faces = 0;
  std::uint64_t origin = 0; // of the face that represents the cell
  Vector center{{0, 0, 0}}; // the centroid of this face
};

// What a record of a cell has besides its corners. The moments are sums of areas times centroids. The same sums weighted by the
// density may be weighted by the deviation instead, because densities are linear in deviations.
struct Cell_data : Cell
{
  static constexpr Index max_corners = NONE;

  double area = 0, weighted_area = 0;
  Vector moment{{0, 0, 0}}, weighted_moment{{0, 0, 0}};

  void add(const Face_geometry& face, double density)
  {
    ++faces;
    area += face.area;
    weighted_area += density * face.area;
    moment = moment + face.area * face.centroid;
    weighted_moment = weighted_moment + (density * face.area) * face.centroid;
  }
};

// A corner of a cell: the number of its vertex, and the numbers of the previous and the next vertex on the boundary.
struct Cell_corner
{
  std::uint64_t vertex, before, after, begins_star; // whether the star of the vertex begins in the cell
  Vector point;
};

typedef Polygon_record<Cell_data, Cell_corner> Cell_record;

// Divides the own faces of a patch into cells, closed discs that are clustered like faces. A face is a cell of its own if other
// patches have faces at one of its vertices, or if it lies at the border of the mesh. Hence cells of several faces meet only
// cells of the same patch, and all their tests are local.
class Cells
{
public:
  // Level 0: each face is a cell.
  Cells(const Patch& patch, Index level, const Run_context& context)
    : patch_(patch),
      mesh_(patch.mesh()),
      labels_(patch.mesh()),
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
    choose_centers();
    choose_corners();
  }

  std::size_t size() const { return boundary_edge_.size(); }
  // NONE for faces of other patches.
  Index cell_of(Index f) const { return number_[labels_[f]]; }
  // Whether a face represents its cell: of all faces of the cell, its centroid is nearest to the centroid of the cell.
  bool is_center(Index f) const { return patch_.is_own(f) && data_[cell_of(f)].origin == patch_.faces[f].origin; }

  // Calls `receive(record)` for each cell.
  template <class Receive>
  void for_each_record(const Receive& receive) const
  {
    Cell_record cell;
    for (std::size_t i = 0; i < size(); ++i) {
      static_cast<Cell_data&>(cell) = data_[i];
      cell.corner.clear();
      const std::vector<Index> boundary = boundary_vertices(boundary_edge_[i]);
      const auto number = [&](std::size_t k) { return patch_.number[boundary[k % boundary.size()]]; };
      for (std::size_t k = 0; k < boundary.size(); ++k)
        if (const Index v = boundary[k]; is_corner_[v])
          cell.corner.push_back({number(k), number(k + boundary.size() - 1), number(k + 1),
                                 labels_[mesh_.star[mesh_.first_in_star[v]]] == labels_[boundary_edge_[i].face],
                                 mesh_.points[v]});
      receive(cell);
    }
  }

private:
  bool is_inner(Index f) const
  {
    return patch_.is_inner_face(f) &&
           !mesh_.any_corner(f, [this](Index c) { return mesh_.is_on_border(mesh_.corner_vertex[c]); });
  }

  void grow(const std::vector<Index>& faces, Index level)
  {
    std::vector<Index> seeds;
    Seed_walk(mesh_, context_).run(faces, level, seeds);
    Cluster_growth growth(labels_, context_);
    for (const Index f : seeds)
      growth.plant(f, cells_++);
    growth.run();
    Cluster_splitting<std::vector<Index> > splitting(growth, faces, growth.cover(faces, cells_), single_);
    splitting.run();
    cells_ = splitting.number_of_clusters();
  }

  // Numbers the cells in the order of their first faces, and sums up their faces.
  void number_cells()
  {
    const Dual_walk walk(labels_);
    number_.assign(cells_, NONE);
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      if (!patch_.is_own(f))
        continue;
      Index& number = number_[labels_[f]];
      if (number == NONE) {
        number = Index(size());
        boundary_edge_.push_back({});
        data_.push_back({});
      }
      if (boundary_edge_[number].face == NONE)
        boundary_edge_[number] = walk.boundary_edge(f);
      data_[number].add(face_geometry(mesh_, f), patch_.faces[f].density);
    }
  }

  void choose_centers()
  {
    std::vector<double> nearest(size(), std::numeric_limits<double>::infinity());
    for (Index f = 0; f < mesh_.number_of_faces(); ++f) {
      if (!patch_.is_own(f))
        continue;
      const Index x = cell_of(f);
      const Vector offset = data_[x].area * mean_of_corners(mesh_, f) - data_[x].moment;
      if (dot(offset, offset) < nearest[x]) {
        nearest[x] = dot(offset, offset);
        data_[x].origin = patch_.faces[f].origin;
        data_[x].center = face_geometry(mesh_, f).centroid;
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
    for (const Directed_edge& start : boundary_edge_) {
      if (labels_[start.face] < single_)
        continue;
      const std::vector<Index> boundary = boundary_vertices(start);
      auto corners = std::count_if(boundary.begin(), boundary.end(), [this](Index v) { return is_corner_[v]; });
      for (std::size_t i = 0; corners < 3; ++i)
        if (!is_corner_[boundary[i]]) {
          is_corner_[boundary[i]] = true;
          ++corners;
        }
    }
  }

  // Returns the vertices around a cell, counterclockwise.
  std::vector<Index> boundary_vertices(const Directed_edge& start) const
  {
    std::vector<Index> boundary;
    const Dual_walk walk(labels_);
    Directed_edge e = start;
    do {
      boundary.push_back(mesh_.corner_vertex[e.corner]);
      e = walk.next_on_boundary(e);
    } while (!(e == start));
    return boundary;
  }

  const Patch& patch_;
  const Flat_mesh& mesh_;
  Cluster_labels labels_;
  const Run_context context_;
  Index single_ = 0, cells_ = 0;             // labels below `single_` belong to single faces of this or other patches
  std::vector<Index> number_;                // of the cell of each label; NONE for faces of other patches
  std::vector<Directed_edge> boundary_edge_; // of each cell
  std::vector<Cell_data> data_;              // of each cell
  std::vector<char> is_corner_;              // of each vertex
};

// The density of a face as a linear function of its deviation (section 5.2), or of the density that the caller passes.
struct Linear_density
{
  double constant = 0, factor = 1;

  double operator()(double x) const { return constant + factor * x; }
};

// The mesh of all cells, on one rank.
//
// An edge of this mesh is a path of edges between two cells. One cell identifies it by its first edge, the other cell by its
// last edge, because two cells may have several edges with the same ends. The stars begin at the same places as the stars of the
// faces, so the dual of clusters of cells is the dual of the same clusters of faces.
struct Cell_mesh
{
  std::vector<Cell> cells;
  std::vector<std::size_t> ends; // of the cells of each bin
  Clustering_input input;

  // Moves the cells out of the own bins.
  Cell_mesh(Record_bins& records, const Linear_density& density, bool cells_are_faces, const Run_context& context)
  {
    std::vector<Cell_corner> corners;
    reserve(records, cells_are_faces, corners);
    input.mesh.first_corner.push_back(0);
    for (std::size_t i = 0; i < records.number_of_own(); ++i) {
      records.read<Cell_record>(i, [&](const Cell_record& cell) {
        add(cell, density, cells_are_faces);
        corners.insert(corners.end(), cell.corner.begin(), cell.corner.end());
        input.mesh.first_corner.push_back(Index(corners.size()));
      });
      records.clear(i);
      ends.push_back(cells.size());
    }
    complete_mesh(std::move(corners), context);
  }

private:
  // Reserves memory; growing arrays would take almost twice as much.
  void reserve(const Record_bins& records, bool cells_are_faces, std::vector<Cell_corner>& corners)
  {
    std::size_t number = 0, number_of_corners = 0;
    for (std::size_t i = 0; i < records.number_of_own(); ++i)
      records.read<Cell_record>(i, [&](const Cell_record& cell) {
        ++number;
        number_of_corners += cell.corners;
      });
    check_countable(number_of_corners, "corners", "the mesh of cells");
    cells.reserve(number);
    input.area.reserve(number);
    input.density.reserve(number);
    input.item_faces.reserve(cells_are_faces ? 0 : number);
    input.item_centroid.reserve(cells_are_faces ? 0 : number);
    input.mesh.first_corner.reserve(number + 1);
    corners.reserve(number_of_corners);
  }

  void add(const Cell_record& cell, const Linear_density& density, bool cells_are_faces)
  {
    const double mass = density.constant * cell.area + density.factor * cell.weighted_area;
    const Vector moment = density.constant * cell.moment + density.factor * cell.weighted_moment;
    cells.push_back(cell);
    input.area.push_back(cell.area);
    input.density.push_back(cell.area > 0 ? mass / cell.area : 1);
    if (!cells_are_faces) {
      input.item_faces.push_back(cell.faces);
      input.item_centroid.push_back(mass > 0 ? (1 / mass) * moment : mean_of_corners(cell));
    }
  }

  void complete_mesh(std::vector<Cell_corner> corners, const Run_context& context)
  {
    Flat_mesh& m = input.mesh;
    std::vector<std::uint64_t> numbers;
    numbers.reserve(corners.size());
    for (const Cell_corner& corner : corners)
      numbers.push_back(corner.vertex);
    sort_unique(numbers);
    const std::size_t vertices = numbers.size();
    m.points.resize(vertices);
    m.corner_vertex.reserve(corners.size());
    std::vector<Index> first_cell(vertices); // the cell in which the star of each vertex begins
    {
      const std::vector<Index> cell_of_corner = faces_of_corners(m);
      for (Index c = 0; c < corners.size(); ++c) {
        const auto v = Index(std::lower_bound(numbers.begin(), numbers.end(), corners[c].vertex) - numbers.begin());
        m.corner_vertex.push_back(v);
        m.points[v] = corners[c].point;
        if (corners[c].begins_star)
          first_cell[v] = cell_of_corner[c];
      }
      numbers = std::vector<std::uint64_t>();
      const Bucketed_items<Index> corners_at(numbers_below(Index(corners.size())), vertices,
                                             [&](Index c) { return m.corner_vertex[c]; });
      pair_edges(
        m, cell_of_corner, corners_at, [&](Index c) { return corners[c].before; }, [&](Index c) { return corners[c].after; });
    }
    corners = std::vector<Cell_corner>();
    complete_topology(m, vertices, context);
    for (Index v = 0; v < vertices; ++v) {
      const auto begin = m.star.begin() + m.first_in_star[v], end = m.star.begin() + m.first_in_star[v + 1];
      if (!m.is_on_border(v))
        std::rotate(begin, std::find(begin, end, first_cell[v]), end);
    }
  }
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELLS_H
