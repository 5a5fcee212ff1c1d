// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_MESH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_store.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
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

// The mesh of all cells, on one rank.
//
// An edge of this mesh is a path of edges between two cells. One cell identifies it by its first edge, the other cell by its
// last edge, because two cells may have several edges with the same ends. The stars begin at the same places as the stars of the
// faces, so the dual of clusters of cells is the dual of the same clusters of faces.
class Cell_mesh
{
public:
  explicit Cell_mesh(const Linear_density& density) : density_(density) {}

  // Counts the cells that `Cells` has written, and their corners, for `reserve()`.
  void count(const std::uint64_t* words, const std::uint64_t* end)
  {
    for (; words != end; words += words_of_cell + words_of_corner * high_half(*words)) {
      ++expected_cells_;
      expected_corners_ += high_half(*words);
    }
  }

  // Reserves memory for the counted cells; growing arrays would take almost twice as much.
  void reserve()
  {
    for (std::vector<double>* const values : {&area_, &mass_})
      values->reserve(expected_cells_);
    faces_.reserve(expected_cells_);
    moment_.reserve(expected_cells_);
    origin_.reserve(expected_cells_);
    center_.reserve(expected_cells_);
    first_corner_.reserve(expected_cells_ + 1);
    begins_star_.reserve(expected_corners_);
    for (std::vector<std::uint64_t>* const values : {&number_, &before_, &after_})
      values->reserve(expected_corners_);
    point_.reserve(expected_corners_);
  }

  // Adds the cells that `Cells` has written.
  void read(const std::uint64_t* words, const std::uint64_t* end)
  {
    for (std::size_t i = 0; words + i != end;) {
      const Index corners = high_half(words[i]);
      faces_.push_back(low_half(words[i++]));
      area_.push_back(to_double(words[i]));
      mass_.push_back(density_.constant * area_.back() + density_.factor * to_double(words[i + 1]));
      moment_.push_back(density_.constant * vector_at(words, i + 2) + density_.factor * vector_at(words, i + 5));
      origin_.push_back(words[i + 8]);
      center_.push_back(vector_at(words, i + 9));
      i += words_of_cell - 1;
      for (Index c = 0; c < corners; ++c, i += words_of_corner) {
        begins_star_.push_back(char(words[i]));
        number_.push_back(words[i + 1]);
        before_.push_back(words[i + 2]);
        after_.push_back(words[i + 3]);
        point_.push_back(vector_at(words, i + 4));
      }
      first_corner_.push_back(number_.size());
    }
  }

  std::size_t number_of_cells() const { return faces_.size(); }
  const std::vector<Index>& faces() const { return faces_; } // the number of faces of each cell
  // The number and the centroid of a face of each cell.
  const std::vector<std::uint64_t>& origins() const { return origin_; }
  const std::vector<Vector>& centers() const { return center_; }
  // For each corner, the corner at which the same edge begins on the other side; NONE on the border. Valid after `make()`.
  const std::vector<Index>& corners_across() const { return corner_across_; }

  // Called once; afterwards, only the functions above can be called.
  Clustering_input make(bool cells_are_faces, const Cancellation_point& cancellation, Execution execution)
  {
    if (number_.size() >= NONE / 2)
      throw Invalid_input("the mesh of cells has " + std::to_string(number_.size()) + " corners, more than the " +
                          std::to_string(NONE / 2 - 1) + " that can be numbered");
    Clustering_input input;
    Flat_mesh& m = input.mesh;
    m.first_corner.reserve(first_corner_.size());
    for (const std::size_t c : first_corner_)
      m.first_corner.push_back(Index(c));
    pair_edges(m);
    const std::size_t vertices = number_vertices(m);
    complete_topology(m, vertices, cancellation, execution);
    begin_stars(m);
    set_sums(input, cells_are_faces);
    release();
    return input;
  }

private:
  static constexpr std::size_t words_of_cell = 13, words_of_corner = 7;

  static Vector vector_at(const std::uint64_t* words, std::size_t i)
  {
    return {{to_double(words[i]), to_double(words[i + 1]), to_double(words[i + 2])}};
  }

  struct End
  {
    std::uint64_t vertex, next; // the two ends of the first edge
    Index cell, corner;
    bool operator<(const End& e) const { return std::tie(vertex, next) < std::tie(e.vertex, e.next); }
  };

  void pair_edges(Flat_mesh& m)
  {
    std::vector<End> ends;
    ends.reserve(number_.size());
    for (Index x = 0; x < faces_.size(); ++x)
      for (Index c = m.first_corner[x]; c != m.first_corner[x + 1]; ++c)
        ends.push_back({number_[c], after_[c], x, c});
    std::sort(ends.begin(), ends.end());
    m.face_across.assign(number_.size(), NONE);
    corner_across_.assign(number_.size(), NONE);
    for (Index x = 0; x < faces_.size(); ++x)
      for (Index c = m.first_corner[x]; c != m.first_corner[x + 1]; ++c) {
        const End back{number_[c], before_[c], 0, 0};
        const auto i = std::lower_bound(ends.begin(), ends.end(), back);
        if (i != ends.end() && i->vertex == back.vertex && i->next == back.next) {
          m.face_across[m.previous_corner(x, c)] = i->cell;
          corner_across_[m.previous_corner(x, c)] = i->corner;
        }
      }
  }

  std::size_t number_vertices(Flat_mesh& m) const
  {
    std::vector<std::uint64_t> numbers = number_;
    sort_unique(numbers);
    m.points.resize(numbers.size());
    m.corner_vertex.resize(number_.size());
    for (std::size_t c = 0; c < number_.size(); ++c) {
      const auto v = std::size_t(std::lower_bound(numbers.begin(), numbers.end(), number_[c]) - numbers.begin());
      m.corner_vertex[c] = Index(v);
      m.points[v] = point_[c];
    }
    return numbers.size();
  }

  void begin_stars(Flat_mesh& m) const
  {
    for (Index x = 0; x < faces_.size(); ++x)
      for (Index c = m.first_corner[x]; c != m.first_corner[x + 1]; ++c) {
        const Index v = m.corner_vertex[c];
        if (begins_star_[c] && !m.is_on_border(v))
          std::rotate(m.star.begin() + m.first_in_star[v], m.star.begin() + m.position_in_star(v, x),
                      m.star.begin() + m.first_in_star[v + 1]);
      }
  }

  void set_sums(Clustering_input& input, bool cells_are_faces)
  {
    input.area = area_;
    for (std::size_t x = 0; x < faces_.size(); ++x)
      input.density.push_back(area_[x] > 0 ? mass_[x] / area_[x] : 1);
    if (cells_are_faces)
      return;
    for (std::size_t x = 0; x < faces_.size(); ++x) {
      input.item_faces.push_back(faces_[x]);
      input.item_centroid.push_back(mass_[x] > 0 ? (1 / mass_[x]) * moment_[x] : mean_of_corners(input.mesh, Index(x)));
    }
  }

  // Releases the memory of all that the mesh now has.
  void release()
  {
    area_ = mass_ = std::vector<double>();
    moment_ = point_ = std::vector<Vector>();
    first_corner_ = std::vector<std::size_t>();
    begins_star_ = std::vector<char>();
    number_ = before_ = after_ = std::vector<std::uint64_t>();
  }

  Linear_density density_;
  std::size_t expected_cells_ = 0, expected_corners_ = 0;
  // Of each cell:
  std::vector<Index> faces_;
  std::vector<double> area_, mass_;
  std::vector<Vector> moment_; // sum of mass times centroid
  std::vector<std::uint64_t> origin_;
  std::vector<Vector> center_;
  std::vector<std::size_t> first_corner_ = std::vector<std::size_t>(1, 0);
  // Of each corner, in global numbers:
  std::vector<char> begins_star_;
  std::vector<std::uint64_t> number_, before_, after_;
  std::vector<Vector> point_;
  std::vector<Index> corner_across_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_CELL_MESH_H
