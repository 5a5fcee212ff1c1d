// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Computes the faces around each vertex and the border loops.
class Star_completion
{
public:
  Star_completion(Flat_mesh& m, const Run_context& context) : m_(m), context_(context) {}

  void run(std::size_t number_of_vertices)
  {
    const std::size_t wrong_face = first_of(context_, m_.number_of_faces(), [&](Index f) { return has_fault(f); });
    if (wrong_face < m_.number_of_faces())
      throw Invalid_input("face " + std::to_string(wrong_face) + fault_of(Index(wrong_face)));
    m_.first_in_star.assign(number_of_vertices + 1, 0);
    for (const Index v : m_.corner_vertex)
      ++m_.first_in_star[v + 1];
    std::partial_sum(m_.first_in_star.begin(), m_.first_in_star.end(), m_.first_in_star.begin());
    m_.star.resize(m_.corner_vertex.size());
    const std::vector<Index> start = first_faces_of_stars();
    const std::size_t wrong = first_of(context_, number_of_vertices, [&](Index v) { return !walk_star(v, start[v]); });
    if (wrong < number_of_vertices)
      throw Invalid_input("vertex " + std::to_string(wrong) +
                          " is not a manifold vertex: the faces around it form more than one fan");
    Index loops = 0;
    for_each_border_loop(m_, context_, [&](const std::vector<Index>& loop) {
      for (const Index v : loop)
        m_.loop[v] = loops;
      ++loops;
    });
  }

private:
  bool is_own_neighbor(Index f) const
  {
    const auto across = m_.face_across.begin() + m_.first_corner[f], end = across + m_.degree(f);
    return std::find(across, end, f) != end;
  }

  bool has_fault(Index f) const { return m_.degree(f) < 3 || is_own_neighbor(f) || vertex_visited_twice(f) != NONE; }

  // Returns the fault as the end of a sentence.
  std::string fault_of(Index f) const
  {
    if (m_.degree(f) < 3)
      return " has " + std::to_string(m_.degree(f)) + " sides";
    if (is_own_neighbor(f))
      return " is its own neighbor across an edge";
    return " visits vertex " + std::to_string(vertex_visited_twice(f)) + " twice";
  }

  // Returns NONE if there is none.
  Index vertex_visited_twice(Index f) const
  {
    const auto begin = m_.corner_vertex.begin() + m_.first_corner[f], end = begin + m_.degree(f);
    if (end - begin <= 8) {
      for (auto i = begin; i != end; ++i)
        if (std::find(i + 1, end, *i) != end)
          return *i;
      return NONE;
    }
    std::vector<Index> sorted(begin, end);
    std::sort(sorted.begin(), sorted.end());
    const auto pair = std::adjacent_find(sorted.begin(), sorted.end());
    return pair == sorted.end() ? NONE : *pair;
  }

  // Returns the face where each star begins; NONE for isolated vertices.
  std::vector<Index> first_faces_of_stars()
  {
    std::vector<Index> start(m_.number_of_vertices(), NONE);
    m_.loop.assign(m_.number_of_vertices(), NONE);
    for (std::size_t f = m_.number_of_faces(); f-- > 0;) {
      context_.poll();
      for (const Index c : m_.corners(f)) {
        const Index v = m_.corner_vertex[c];
        if (m_.face_across[c] == NONE) {
          if (m_.loop[v] != NONE)
            throw Invalid_input("vertex " + std::to_string(v) + " lies on the border twice");
          m_.loop[v] = 0; // on a loop, which is numbered later
          start[v] = Index(f);
        } else if (m_.loop[v] == NONE) {
          start[v] = Index(f);
        }
      }
    }
    return start;
  }

  // Returns whether the faces around the vertex form one fan, closed or from border to border.
  bool walk_star(Index v, Index f)
  {
    const Index begin = m_.first_in_star[v], end = m_.first_in_star[v + 1];
    if (begin == end)
      return true;
    const Index first = f;
    Index i = begin;
    do {
      m_.star[i++] = f;
      f = m_.face_across[m_.previous_corner(f, m_.corner_of(f, v))];
    } while (f != NONE && f != first && i != end);
    const bool closed = m_.loop[v] == NONE;
    return i == end && (closed ? f == first : f == NONE);
  }

  Flat_mesh& m_;
  const Run_context& context_;
};

// Raises the deviations of faces near the border in proportion to the curvature of the border, at most to four times the
// largest deviation. The largest deviation scales the densities and does not change.
//
// Where the border has the radius of curvature R, its parallel curve at distance s on the outer side has radius R + s. The raised
// deviation is proportional to the angle by which this parallel curve turns between neighboring faces.
class Border_deviations
{
public:
  explicit Border_deviations(const Flat_mesh& m, const Run_context& context = Run_context())
    : mesh_(m), context_(context), radius_(m.number_of_vertices(), std::numeric_limits<double>::infinity()),
      reach_(m.number_of_vertices(), 0)
  {}

  void raise(std::vector<double>& deviations)
  {
    for_each_border_loop(mesh_, context_, [this](const std::vector<Index>& loop) { measure_loop(loop); });
    spread();
    const double most = max_raised * largest_of(deviations);
    for (std::size_t f = 0; f < deviations.size(); ++f) {
      context_.poll();
      double radius = std::numeric_limits<double>::infinity();
      for (const Index c : mesh_.corners(f))
        radius = (std::min)(radius, radius_[mesh_.corner_vertex[c]]);
      if (!(radius < std::numeric_limits<double>::infinity()))
        continue;
      const double turn = strength * std::sqrt(face_area(mesh_, Index(f)));
      if (turn > deviations[f] * radius)
        deviations[f] = turn < most * radius ? turn / radius : most;
    }
  }

private:
  // The number of border edges on each side of a vertex between which the turning angle is measured; with fewer edges, the zigzag
  // of triangles contributes.
  //! [border]
  static constexpr std::size_t edges_aside = 3;
  // The range of a border relative to the length of its loop: a small hole needs few vertices, even if it has a large
  // curvature.
  static constexpr double far = 0.1;
  // In a regular mesh of triangles of area 1, the distance between two faces around a vertex is 1.09 on average, and
  // the distance of a circle from an inscribed polygon is sqrt(6) times the distance from the best polygon. This gives
  // 2.7. But the remaining distance of the border extends over the whole border, and the distance of the surface occurs
  // mostly where densities are low. With these two constants, measured on open meshes, both distances are about equal.
  static constexpr double strength = 32;
  static constexpr double max_raised = 4;
  //! [border]

  void measure_loop(const std::vector<Index>& loop)
  {
    const std::size_t n = loop.size(), k = (std::max)(std::size_t(1), (std::min)(edges_aside, n / 4));
    double perimeter = 0;
    for (std::size_t i = 0; i < n; ++i)
      perimeter += distance(loop[i], loop[(i + 1) % n]);
    for (std::size_t i = 0; i < n; ++i) {
      const Index before = loop[(i + n - k) % n], at = loop[i], after = loop[(i + k) % n];
      const double a = distance(before, at), b = distance(at, after);
      if (!(a > 0 && b > 0))
        continue;
      const Vector d = (1 / a) * (mesh_.points[at] - mesh_.points[before]) - (1 / b) * (mesh_.points[after] - mesh_.points[at]);
      const double turn = length(d);
      if (!(turn > straight))
        continue;
      radius_[at] = 0.5 * (a + b) / turn;
      reach_[at] = radius_[at] + far * perimeter;
    }
  }

  // Computes for each vertex near the border the smallest radius of the parallels through it: Dijkstra's algorithm with
  // the lengths of edges and of face diagonals.
  void spread()
  {
    typedef std::pair<double, Index> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    for (std::size_t v = 0; v < radius_.size(); ++v)
      if (radius_[v] < reach_[v])
        queue.push({radius_[v], Index(v)});
    while (!queue.empty()) {
      const Entry entry = queue.top();
      queue.pop();
      const Index v = entry.second;
      if (entry.first > radius_[v])
        continue;
      context_.poll(mesh_.valence(v));
      for (const Index f : mesh_.faces_around(v)) {
        // These are all other vertices of a triangle or quadrilateral. Of a larger face, only the two adjacent vertices are
        // visited, which keeps the time linear.
        const Index c = mesh_.corner_of(f, v), before = mesh_.previous_corner(f, c), after = mesh_.next_corner(f, c);
        for (const Index corner : {before, after, mesh_.degree(f) == 4 ? mesh_.next_corner(f, after) : after}) {
          const Index w = mesh_.corner_vertex[corner];
          const double radius = entry.first + distance(v, w);
          if (radius <= reach_[v] && radius < radius_[w]) {
            radius_[w] = radius;
            reach_[w] = reach_[v];
            queue.push({radius, w});
          }
        }
      }
    }
  }

  double distance(Index v, Index w) const { return length(mesh_.points[w] - mesh_.points[v]); }

  static constexpr double straight = 1e-6;
  const Flat_mesh& mesh_;
  const Run_context context_;
  std::vector<double> radius_, reach_; // per vertex; the largest radius to propagate
};

CGAL_SURFACE_MESH_COARSENING_INLINE void complete_stars(Flat_mesh& mesh, std::size_t number_of_vertices,
                                                        const Run_context& context)
{
  Star_completion(mesh, context).run(number_of_vertices);
}

CGAL_SURFACE_MESH_COARSENING_INLINE void complete_topology(Flat_mesh& mesh, std::size_t number_of_vertices,
                                                           const Run_context& context)
{
  complete_stars(mesh, number_of_vertices, context);
  std::vector<Index> number(mesh.number_of_faces(), NONE);
  const auto all = numbers_below(Index(number.size()));
  mesh.components.assign(number_parts(mesh, all, number, context, [](Index, Index) { return true; }), Component());
  for (const Index f : all) {
    Component& component = mesh.components[number[f]];
    ++component.faces;
    for (const Index c : mesh.corners(f))
      component.edges += mesh.face_across[c] == NONE || f < mesh.face_across[c];
  }
  mesh.component.set(std::move(number), mesh.components.size());
  Index loops = 0; // they are numbered in the order of their first vertices
  for (std::size_t v = 0; v < mesh.number_of_vertices(); ++v) {
    if (mesh.valence(v) == 0)
      continue;
    Component& component = mesh.components[mesh.component[mesh.star[mesh.first_in_star[v]]]];
    ++component.vertices;
    if (mesh.loop[v] == loops) {
      ++component.loops;
      ++loops;
    }
  }
}

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<double> compute_densities(const Flat_mesh& mesh, double maximum, bool at_borders,
                                                                          const Run_context& context)
{
  std::vector<double> densities = mean_normal_deviations(mesh, context);
  const double largest = largest_of(densities);
  const auto is_loop = [](Index loop) { return loop != NONE; };
  if (at_borders && std::any_of(mesh.loop.begin(), mesh.loop.end(), is_loop))
    Border_deviations(mesh, context).raise(densities);
  map_to_densities(densities, largest, maximum);
  return densities;
}

CGAL_SURFACE_MESH_COARSENING_INLINE void compute_areas_and_centroids(Clustering_input& input, const Run_context& context)
{
  const Flat_mesh& m = input.mesh;
  input.area.resize(m.number_of_faces());
  for_each_number(context, input.area.size(), [&](Index f) { input.area[f] = face_area(m, f); });
  // Centroids are stored if one face has a large part of all corners. In other meshes, computing them takes less time than
  // reading.
  constexpr std::size_t many_corners = 64, part = 64;
  std::size_t most = 0;
  for (std::size_t f = 0; f < m.number_of_faces(); ++f)
    most = (std::max)(most, std::size_t(m.degree(Index(f))));
  if (most < many_corners || part * most < m.corner_vertex.size())
    return;
  std::vector<Vector> centroids(m.number_of_faces());
  for_each_number(context, centroids.size(), [&](Index f) { centroids[f] = input.centroid(f); });
  input.item_centroid.swap(centroids);
}

CGAL_SURFACE_MESH_COARSENING_INLINE Clustering_input cut_input(const Clustering_input& whole, Flat_mesh pieces,
                                                               const std::vector<Index>& whole_face, const Run_context& context)
{
  Clustering_input result;
  result.mesh = std::move(pieces);
  result.density.reserve(whole_face.size());
  result.parent.reserve(whole_face.size());
  for (const Index f : whole_face) {
    result.density.push_back(whole.density[f]);
    result.parent.push_back(whole.parent_of(f));
  }
  compute_areas_and_centroids(result, context);
  return result;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_CLUSTERING_INPUT_IMPL_H
