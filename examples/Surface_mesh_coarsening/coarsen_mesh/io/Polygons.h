// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_POLYGONS_H
#define COARSENING_SUPPORT_POLYGONS_H

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace coarsening_support {

// The number of a vertex of a polygon soup. Meshes number vertices with 32 bits.
typedef std::uint32_t Vertex_number;

// Not the number of any vertex.
constexpr Vertex_number no_vertex = (std::numeric_limits<Vertex_number>::max)();

inline Vertex_number to_vertex_number(std::size_t v) { return v < no_vertex ? static_cast<Vertex_number>(v) : no_vertex; }

// Lists of vertices in one array: reading a file with a million polygons allocates a few times.
class Polygons
{
  std::vector<Vertex_number> corners_;
  std::vector<std::size_t> ends_;

  struct Polygon_at
  {
    const Polygons* polygons;
    boost::iterator_range<const Vertex_number*> operator()(std::size_t f) const { return (*polygons)[f]; }
  };

public:
  typedef boost::iterator_range<const Vertex_number*> Polygon;

  Polygons() = default;

  // Converts a list of lists.
  template <class Lists>
  explicit Polygons(const Lists& lists)
  {
    for (const auto& list : lists)
      push_back(list);
  }

  std::size_t size() const { return ends_.size(); }
  bool empty() const { return ends_.empty(); }
  void clear()
  {
    corners_.clear();
    ends_.clear();
  }
  void reserve(std::size_t polygons, std::size_t corners)
  {
    ends_.reserve(polygons);
    corners_.reserve(corners);
  }

  // The corners of all polygons, and the first corner of each polygon; the begin of the one after the last is their
  // number.
  const std::vector<Vertex_number>& corners() const { return corners_; }
  std::vector<Vertex_number>& corners() { return corners_; }
  std::size_t first_corner(std::size_t f) const { return f == 0 ? 0 : ends_[f - 1]; }

  Polygon operator[](std::size_t f) const
  {
    return Polygon(corners_.data() + first_corner(f), corners_.data() + ends_[f]);
  }
  auto begin() const { return boost::make_transform_iterator(boost::counting_iterator<std::size_t>(0), Polygon_at{this}); }
  auto end() const { return boost::make_transform_iterator(boost::counting_iterator<std::size_t>(size()), Polygon_at{this}); }

  // Adds a polygon corner by corner, or as a whole.
  void add_corner(Vertex_number v) { corners_.push_back(v); }
  void end_polygon() { ends_.push_back(corners_.size()); }

  template <class Range>
  void push_back(const Range& polygon)
  {
    for (const auto v : polygon)
      add_corner(to_vertex_number(static_cast<std::size_t>(v)));
    end_polygon();
  }
  void push_back(std::initializer_list<std::size_t> polygon) { push_back<std::initializer_list<std::size_t> >(polygon); }

  // Converts to the type of CGAL's functions for polygon soups.
  std::vector<std::vector<std::size_t> > lists() const
  {
    std::vector<std::vector<std::size_t> > result;
    result.reserve(size());
    for (const Polygon& p : *this)
      result.emplace_back(p.begin(), p.end());
    return result;
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_POLYGONS_H
