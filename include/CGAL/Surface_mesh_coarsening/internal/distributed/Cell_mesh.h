// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_MESH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>

#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The density of a face as a linear function of its deviation (section 5.2), or of the density that the caller passes.
struct Linear_density
{
  double constant = 0, factor = 1;

  double operator()(double x) const { return constant + factor * x; }
};

// Returns the face that has a corner.
inline Index face_of_corner(const Flat_mesh& m, Index c)
{
  const Number_range faces = numbers_below(Index(m.first_corner.size() - 1));
  return *std::partition_point(faces.begin(), faces.end(), [&](Index f) { return m.first_corner[f + 1] <= c; });
}

// The mesh of all cells, on one rank.
//
// An edge of this mesh is a path of edges between two cells. One cell identifies it by its first edge, the other cell by its
// last edge, because two cells may have several edges with the same ends. The stars begin at the same places as the stars of the
// faces, so the dual of clusters of cells is the dual of the same clusters of faces.
class Cell_mesh
{
public:
  // What remains of a cell after `make()`: the face that represents it, the centroid of this face, and the number of its faces.
  struct Cell
  {
    std::uint64_t origin;
    Vector center;
    Index faces;
  };

  explicit Cell_mesh(const Linear_density& density) : density_(density) {}

  void count(const Cell_data& cell)
  {
    ++expected_cells_;
    expected_corners_ += cell.corners;
  }

  // Reserves memory for the counted cells; growing arrays would take almost twice as much.
  void reserve()
  {
    if (expected_corners_ >= NONE / 2)
      throw Invalid_input("the mesh of cells has " + std::to_string(expected_corners_) + " corners, more than the " +
                          std::to_string(NONE / 2 - 1) + " that can be numbered");
    cells_.reserve(expected_cells_);
    sums_.reserve(expected_cells_);
    first_corner_.reserve(expected_cells_ + 1);
    first_corner_.push_back(0);
    corners_.reserve(expected_corners_);
    begins_star_.reserve(expected_corners_);
  }

  void add(const Cell_record& cell)
  {
    cells_.push_back({cell.origin, cell.center, cell.faces});
    sums_.push_back({cell.area, density_.constant * cell.area + density_.factor * cell.weighted_area,
                     density_.constant * cell.moment + density_.factor * cell.weighted_moment});
    corners_.insert(corners_.end(), cell.corner.begin(), cell.corner.end());
    for (const std::uint64_t begins : cell.begins_star)
      begins_star_.push_back(char(begins));
    first_corner_.push_back(Index(corners_.size()));
  }

  const std::vector<Cell>& cells() const { return cells_; }
  // For each corner, the corner at which the same edge begins on the other side; NONE on the border. Valid after `make()`.
  const std::vector<Index>& corners_across() const { return corner_across_; }

  // Called once; afterwards, only the two functions above can be called.
  Clustering_input make(bool cells_are_faces, const Run_context& context)
  {
    Clustering_input input;
    Flat_mesh& m = input.mesh;
    m.first_corner = std::move(first_corner_);
    const std::size_t vertices = number_vertices(m);
    pair_edges(m, vertices);
    corners_ = std::vector<Cell_corner>();
    complete_topology(m, vertices, context);
    begin_stars(m);
    begins_star_ = std::vector<char>();
    set_sums(input, cells_are_faces);
    sums_ = std::vector<Sums>();
    return input;
  }

private:
  struct Sums
  {
    double area, mass;
    Vector moment; // sum of mass times centroid
  };

  // A corner of a cell, and the numbers of the vertices before and after it on the boundary.
  struct Corner
  {
    Index corner;
    std::uint64_t previous, next;
  };

  std::size_t number_vertices(Flat_mesh& m) const
  {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(corners_.size());
    for (const Cell_corner& corner : corners_)
      numbers.push_back(corner.vertex);
    sort_unique(numbers);
    m.points.resize(numbers.size());
    m.corner_vertex.reserve(corners_.size());
    for (const Cell_corner& corner : corners_) {
      const auto v = std::lower_bound(numbers.begin(), numbers.end(), corner.vertex) - numbers.begin();
      m.corner_vertex.push_back(Index(v));
      m.points[std::size_t(v)] = corner.point;
    }
    return numbers.size();
  }

  void pair_edges(Flat_mesh& m, std::size_t vertices)
  {
    const auto corner = [this](Index c) { return Corner{c, corners_[c].before, corners_[c].after}; };
    const Bucketed_items<Corner> corners_at(numbers_below(Index(corners_.size())) | boost::adaptors::transformed(corner), vertices,
                                            [&](const Corner& x) { return m.corner_vertex[x.corner]; });
    m.face_across.assign(corners_.size(), NONE);
    corner_across_.assign(corners_.size(), NONE);
    std::vector<Corner> corners;
    for (std::size_t v = 0; v < vertices; ++v)
      pair_edges_at_vertex(corners_at[v], corners, [&](const Corner& x, const Corner& y) {
        m.face_across[x.corner] = face_of_corner(m, y.corner);
        corner_across_[x.corner] = m.previous_corner(m.face_across[x.corner], y.corner);
      });
  }

  void begin_stars(Flat_mesh& m) const
  {
    for (Index x = 0; x < cells_.size(); ++x)
      for (const Index c : m.corners(x)) {
        const Index v = m.corner_vertex[c];
        if (begins_star_[c] && !m.is_on_border(v))
          std::rotate(m.star.begin() + m.first_in_star[v], m.star.begin() + m.position_in_star(v, x),
                      m.star.begin() + m.first_in_star[v + 1]);
      }
  }

  void set_sums(Clustering_input& input, bool cells_are_faces) const
  {
    input.area.reserve(sums_.size());
    input.density.reserve(sums_.size());
    for (Index x = 0; x < sums_.size(); ++x) {
      const auto& [area, mass, moment] = sums_[x];
      input.area.push_back(area);
      input.density.push_back(area > 0 ? mass / area : 1);
      if (cells_are_faces)
        continue;
      input.item_faces.push_back(cells_[x].faces);
      input.item_centroid.push_back(mass > 0 ? (1 / mass) * moment : mean_of_corners(input.mesh, x));
    }
  }

  Linear_density density_;
  std::size_t expected_cells_ = 0, expected_corners_ = 0;
  std::vector<Cell> cells_;
  std::vector<Sums> sums_; // of each cell
  Corner_offsets first_corner_; // of each cell, and the total
  std::vector<Cell_corner> corners_;
  std::vector<char> begins_star_; // of each corner
  std::vector<Index> corner_across_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_MESH_H
