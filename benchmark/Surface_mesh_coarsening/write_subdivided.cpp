// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes a triangle mesh with each triangle divided into K x K triangles. The output may be larger than memory:
//   write_subdivided INPUT OUTPUT K

#include "support/Ply_stream.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef std::array<std::size_t, 3> Triangle;
typedef std::pair<std::size_t, std::size_t> Edge; // the smaller vertex first

// The vertices of the input come first, then vertices on edges, from the smaller vertex on, then vertices within triangles.
class Subdivision
{
public:
  Subdivision(const std::string& file, std::size_t k) : k_(k)
  {
    std::vector<std::vector<std::size_t> > polygons;
    if (!CGAL::IO::read_polygon_soup(file, points_, polygons))
      throw std::runtime_error("cannot read " + file);
    for (const auto& polygon : polygons) {
      if (polygon.size() != 3)
        throw std::runtime_error(file + " has a face with " + std::to_string(polygon.size()) + " sides");
      triangles_.push_back({{polygon[0], polygon[1], polygon[2]}});
      for (std::size_t i = 0; i < 3; ++i)
        edges_.push_back(std::minmax(polygon[i], polygon[(i + 1) % 3]));
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  void write_to(const std::string& file) const
  {
    benchmark_support::Ply_stream stream(file, number_of_vertices(), triangles_.size() * k_ * k_);
    for (const Point& p : points_)
      write_vertex(stream, p);
    for (const Edge& e : edges_)
      for (std::size_t i = 1; i < k_; ++i)
        write_vertex(stream, between(points_[e.first], points_[e.second], points_[e.second], i, 0));
    for (const Triangle& t : triangles_)
      for (std::size_t i = 1; i < k_; ++i)
        for (std::size_t j = 1; i + j < k_; ++j)
          write_vertex(stream, between(points_[t[0]], points_[t[1]], points_[t[2]], i, j));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < k_; ++i)
        for (std::size_t j = 0; i + j < k_; ++j) {
          stream.write_triangle({{vertex(t, i, j), vertex(t, i + 1, j), vertex(t, i, j + 1)}});
          if (i + j + 1 < k_)
            stream.write_triangle({{vertex(t, i + 1, j), vertex(t, i + 1, j + 1), vertex(t, i, j + 1)}});
        }
    stream.close();
  }

private:
  std::size_t inner_vertices() const { return (k_ - 1) * (k_ - 2) / 2; }
  std::size_t number_of_vertices() const
  {
    return points_.size() + edges_.size() * (k_ - 1) + triangles_.size() * inner_vertices();
  }

  // Returns the point i steps from a towards b, and j steps towards c.
  Point between(const Point& a, const Point& b, const Point& c, std::size_t i, std::size_t j) const
  {
    return a + (double(i) / double(k_)) * (b - a) + (double(j) / double(k_)) * (c - a);
  }

  // Returns the number of the vertex at such a point of a triangle.
  std::uint64_t vertex(std::size_t t, std::size_t i, std::size_t j) const
  {
    const Triangle& corner = triangles_[t];
    const std::size_t rest = k_ - i - j;
    if (i == k_ || j == k_ || rest == k_)
      return corner[i == k_ ? 1 : j == k_ ? 2 : 0];
    if (j == 0)
      return on_edge(corner[0], corner[1], i);
    if (i == 0)
      return on_edge(corner[0], corner[2], j);
    if (rest == 0)
      return on_edge(corner[1], corner[2], j);
    const std::size_t before = (i - 1) * (k_ - 1) - i * (i - 1) / 2; // in the rows before row i
    return points_.size() + edges_.size() * (k_ - 1) + t * inner_vertices() + before + j - 1;
  }

  // Returns the number of the vertex i steps from v towards w.
  std::uint64_t on_edge(std::size_t v, std::size_t w, std::size_t i) const
  {
    const Edge edge = std::minmax(v, w);
    const auto number = std::size_t(std::lower_bound(edges_.begin(), edges_.end(), edge) - edges_.begin());
    return points_.size() + number * (k_ - 1) + (v < w ? i : k_ - i) - 1;
  }

  static void write_vertex(benchmark_support::Ply_stream& stream, const Point& p) { stream.write_vertex(p.x(), p.y(), p.z()); }

  std::size_t k_;
  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_; // in order
};

} // namespace

int main(int argc, char* argv[])
{
  try {
    const int k = argc == 4 ? std::atoi(argv[3]) : 0;
    if (k < 1 || k > 1000)
      throw std::invalid_argument("usage: write_subdivided INPUT OUTPUT K, with K from 1 to 1000");
    Subdivision(argv[1], std::size_t(k)).write_to(argv[2]);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "write_subdivided: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
