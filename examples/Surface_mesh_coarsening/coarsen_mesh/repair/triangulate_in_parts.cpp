// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/triangulate_in_parts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace coarsen_mesh_tool {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class Border_triangulation
{
  typedef std::vector<std::size_t> Part; // positions on the border, ascending
  typedef std::array<std::size_t, 3> Triangle;

  const Mesh& mesh_;
  const Stop& stop_;
  std::vector<Vertex> border_;
  std::vector<Triangle> triangles_;

  bool is_side(std::size_t a, std::size_t b) const { return a + 1 == b || (a == 0 && b + 1 == border_.size()); }

  // Returns whether a diagonal from `a` to a later position `b` would duplicate an edge of the mesh.
  bool is_taken(std::size_t a, std::size_t b) const
  {
    return !is_side(a, b) && mesh_.halfedge(border_[a], border_[b]) != Mesh::null_halfedge();
  }

  bool triangulate_whole(const Part& part)
  {
    std::vector<Exact_kernel::Point_3> points;
    for (const std::size_t i : part) {
      const Point& p = mesh_.point(border_[i]);
      points.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<CGAL::Triple<int, int, int> > found;
    const Step_counter counter(stop_);
    try {
      PMP::triangulate_hole_polyline(points, std::back_inserter(found), CGAL::parameters::visitor(counter));
    } catch (const Step_counter::Too_many_steps&) {
      return false;
    }
    std::vector<Triangle> triangles;
    for (const auto& t : found) {
      Triangle places{part[std::size_t(t.first)], part[std::size_t(t.second)], part[std::size_t(t.third)]};
      std::sort(places.begin(), places.end());
      if (is_taken(places[0], places[1]) || is_taken(places[1], places[2]) || is_taken(places[0], places[2]))
        return false;
      triangles.push_back(places);
    }
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    return !triangles.empty();
  }

  // Returns the shortest of some diagonals with at least a quarter of the part on each side.
  std::pair<std::size_t, std::size_t> short_diagonal(const Part& part) const
  {
    constexpr std::size_t tries = 64;
    const std::size_t n = part.size();
    double least = std::numeric_limits<double>::infinity();
    std::pair<std::size_t, std::size_t> best(0, 0);
    for (std::size_t k = 0; k < tries; ++k)
      for (std::size_t l = 0; l < tries; ++l) {
        const std::size_t one = k * n / tries, other = (one + n / 4 + l * (n / 2) / tries) % n;
        const std::size_t i = (std::min)(one, other), j = (std::max)(one, other);
        const double d = CGAL::squared_distance(mesh_.point(border_[part[i]]), mesh_.point(border_[part[j]]));
        if (d < least && j > i + 1 && !is_taken(part[i], part[j])) {
          least = d;
          best = {i, j};
        }
      }
    return best;
  }

public:
  Border_triangulation(const Mesh& mesh, Halfedge border, const Stop& stop) : mesh_(mesh), stop_(stop)
  {
    Halfedge h = border;
    do {
      border_.push_back(mesh.target(h));
      h = mesh.next(h);
    } while (h != border);
  }

  bool find()
  {
    std::vector<Part> open(1);
    for (std::size_t i = 0; i < border_.size(); ++i)
      open[0].push_back(i);
    while (!open.empty()) {
      if (stop_)
        stop_();
      const Part part = std::move(open.back());
      open.pop_back();
      constexpr std::size_t least_edges = 16, most_edges = 64; // of which all triangulations are searched in milliseconds
      if (part.size() <= most_edges && triangulate_whole(part))
        continue;
      const auto [i, j] = short_diagonal(part);
      if (i == j || part.size() < least_edges)
        return false;
      open.emplace_back(part.begin() + std::ptrdiff_t(i), part.begin() + std::ptrdiff_t(j) + 1);
      open.emplace_back(part.begin(), part.begin() + std::ptrdiff_t(i) + 1);
      open.back().insert(open.back().end(), part.begin() + std::ptrdiff_t(j), part.end());
    }
    return true;
  }

  // Positions on the border are ordered like the corners of a face.
  bool add_to(Mesh& mesh) const
  {
    for (const Triangle& t : triangles_)
      if (mesh.add_face(border_[t[0]], border_[t[1]], border_[t[2]]) == Mesh::null_face())
        return false;
    return true;
  }

  std::size_t number_of_triangles() const { return triangles_.size(); }
};

} // namespace

std::size_t triangulate_in_parts(Mesh& mesh, Halfedge border, const Stop& stop)
{
  Border_triangulation triangulation(mesh, border, stop);
  if (!triangulation.find())
    return 0;
  Mesh filled = mesh;
  if (!triangulation.add_to(filled))
    return 0;
  mesh = std::move(filled);
  return triangulation.number_of_triangles();
}

} // namespace coarsen_mesh_tool
