// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_IMPL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_IMPL_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Finds feature edges and corners. Omits border edges, because the border is always kept.
class Feature_detection
{
public:
  explicit Feature_detection(const Flat_mesh& m) : m_(m), result_(m), is_marked_(m.number_of_vertices(), false) {}

  Feature_edges run(const Feature_request& request)
  {
    if (request.angle < 180) {
      add_sharp_edges(request.angle);
      add_tips(request.angle);
    }
    if (!request.patches.empty())
      for_each_inner_edge([&](Index f, Index c) {
        if (request.patches[f] != request.patches[m_.face_across[c]])
          add_inner_edge(f, c);
      });
    for (const Feature_request::Edge& e : request.edges)
      if (m_.face_across[e.corner] != NONE)
        mark_edge(e.face, e.corner);
    for (const Index v : request.corners)
      if (m_.valence(v) > 0)
        result_.is_corner[v] = true;
    add_ends_and_turns();
    add_corners_beside_border();
    return std::move(result_);
  }

private:
  template <class Visit>
  void for_each_inner_edge(const Visit& visit) const
  {
    for (std::size_t f = 0; f < m_.number_of_faces(); ++f)
      for (const Index c : m_.corners(f))
        if (m_.face_across[c] != NONE && f < m_.face_across[c])
          visit(Index(f), c);
  }

  void add_inner_edge(Index f, Index c) { result_.is_feature[c] = result_.is_feature[m_.opposite_corner(f, c)] = true; }

  void mark_edge(Index f, Index c)
  {
    add_inner_edge(f, c);
    is_marked_[m_.corner_vertex[c]] = is_marked_[m_.corner_vertex[m_.next_corner(f, c)]] = true;
  }

  // Adds the edges where the normals of the two faces differ by `degrees` or more. The corners beside the edge define
  // the normals, as in CGAL's detect_sharp_edges().
  void add_sharp_edges(double degrees)
  {
    const double cosine = std::cos(degrees * CGAL_PI / 180);
    for_each_inner_edge([&](Index f, Index c) {
      const Vector n = normal_beside(f, c), m = normal_beside(m_.face_across[c], m_.opposite_corner(f, c));
      if (dot(n, n) == 0 || dot(m, m) == 0)
        return;
      const double product = dot(n, m), bound = cosine * cosine * dot(n, n) * dot(m, m);
      if (degrees == 0 || (cosine < 0 ? product < 0 && product * product >= bound : product < 0 || product * product <= bound))
        mark_edge(f, c);
    });
  }

  // Adds as corners the tips: vertices without sharp edges where the normals of faces on opposite sides differ by `degrees` or
  // more, such as the apex of a cone.
  void add_tips(double degrees)
  {
    const double cosine = std::cos(0.5 * degrees * CGAL_PI / 180);
    for (std::size_t v = 0; v < m_.number_of_vertices(); ++v)
      if (!is_marked_[v] && !m_.is_on_border(Index(v)) && is_tip(Index(v), cosine))
        result_.is_corner[v] = true;
  }

  // Adds as corners the vertices whose number of feature edges is not two, and where lines reach the border or turn
  // sharply. Lines that only separate patches are smoothed.
  void add_ends_and_turns()
  {
    neighbors_ = result_.neighbors(m_);
    for (std::size_t v = 0; v < m_.number_of_vertices(); ++v)
      if (!neighbors_[v].empty() && (neighbors_[v].size() != 2 || m_.is_on_border(Index(v))))
        result_.is_corner[v] = true;
    std::vector<Index> turns;
    for (std::size_t v = 0; v < m_.number_of_vertices(); ++v)
      if (is_marked_[v] && is_inside_line(Index(v)) && turns_sharply(Index(v)))
        turns.push_back(Index(v));
    add_corners(turns);
    add_corners(turns_of_patch_borders());
  }

  bool is_inside_line(Index v) const { return neighbors_[v].size() == 2 && !result_.is_corner[v]; }

  void add_corners(const std::vector<Index>& vertices)
  {
    for (const Index v : vertices)
      result_.is_corner[v] = true;
  }

  // Returns the normal of face `f` beside the edge after corner `c`. A face of zero area has the normal of the face across its
  // longest edge, so a sharp line beside such faces is found once. Returns a null vector if there is no face across.
  Vector normal_beside(Index f, Index c) const
  {
    constexpr double tiny = 1e-6; // the height in units of the longest edge: slivers of rounded coordinates have no normal
    constexpr int max_faces = 8;
    for (int i = 0; i < max_faces; ++i) {
      const Index next = m_.next_corner(f, c);
      Index longest = NONE; // the corner before the longest edge
      double square = -1;
      for (const Index corner : m_.corners(f))
        if (const double s = squared_length(m_.edge_vector(f, corner)); s > square) {
          longest = corner;
          square = s;
        }
      const double bound = tiny * tiny * square * square;
      const Vector n = cross(m_.edge_vector(f, c), m_.point_at(m_.next_corner(f, next)) - m_.point_at(c));
      if (dot(n, n) > bound)
        return n;
      const Vector whole = vector_area(m_, f); // some corners of a polygon may be collinear
      if (dot(whole, whole) > bound)
        return whole;
      const Index across = m_.face_across[longest];
      if (across == NONE)
        break;
      c = m_.opposite_corner(f, longest);
      f = across;
    }
    return {{0, 0, 0}};
  }

  // Returns whether each face around is inclined against the mean normal by at least the angle.
  bool is_tip(Index v, double cosine) const
  {
    Vector mean{{0, 0, 0}};
    std::vector<Vector> normals;
    for (const Index f : m_.faces_around(v)) {
      const Index c = m_.corner_of(f, v);
      const Vector a = m_.edge_vector(f, c), b = m_.point_at(m_.previous_corner(f, c)) - m_.point_at(c), n = cross(a, b);
      const double size = length(n);
      if (!(size > 0))
        continue;
      normals.push_back((1 / size) * n);
      mean = mean + std::atan2(size, dot(a, b)) * normals.back();
    }
    const double bound = cosine * length(mean);
    return normals.size() > 2 &&
           std::all_of(normals.begin(), normals.end(), [&](const Vector& n) { return dot(n, mean) <= bound; });
  }

  // Adds a corner in the middle of each part of the border without corners that connects the ends of a line of one edge.
  // The corner separates this part from the line.
  void add_corners_beside_border()
  {
    std::vector<Index> halfway;
    const auto add_between = [&](Index begin, Index end) {
      std::vector<Index> between(1, m_.next_on_border(begin));
      while (!result_.is_corner[between.back()])
        between.push_back(m_.next_on_border(between.back()));
      if (between.back() == end && between.size() > 1)
        halfway.push_back(between[between.size() / 2 - 1]);
    };
    result_.for_each_edge(m_, [&](Index v, Index w) {
      if (m_.is_on_border(v) && m_.is_on_border(w)) {
        add_between(v, w);
        add_between(w, v);
      }
    });
    add_corners(halfway);
  }

  // Returns the vertices from `v` along at most `edges` edges of the line, up to a corner or around a loop.
  std::vector<Index> walk(Index v, std::size_t side, std::size_t edges) const
  {
    std::vector<Index> vertices{v, neighbors_[v][side]};
    while (vertices.size() <= edges && !result_.is_corner[vertices.back()] && vertices.back() != v) {
      const std::vector<Index>& next = neighbors_[vertices.back()];
      vertices.push_back(next[next[0] == vertices[vertices.size() - 2]]);
    }
    return vertices;
  }

  // Returns whether a line turns by more than 60 degrees, measured both between adjacent edges and between chords of several
  // edges: on regular meshes, marked edges may zigzag without turning.
  bool turns_sharply(Index v) const
  {
    constexpr std::size_t edges_of_chord = 3;
    return turns_between(neighbors_[v][0], v, neighbors_[v][1]) &&
           turns_between(walk(v, 0, edges_of_chord).back(), v, walk(v, 1, edges_of_chord).back());
  }

  bool turns_between(Index before, Index v, Index after) const
  {
    const Vector a = m_.points[v] - m_.points[before], b = m_.points[after] - m_.points[v];
    return dot(a, b) < 0.5 * std::sqrt(dot(a, a) * dot(b, b));
  }

  // Returns the sharp turns of lines between patches: where they turn by more than 60 degrees, and more than at the vertices
  // around. These lines follow the edges of faces, so they zigzag at any resolution. The direction on each side of a vertex is
  // therefore the regression line of several edges. The turn at a corner does not depend on the number of edges, but the turn of
  // a round line does: a corner turns sharply over some edges and over half of them.
  std::vector<Index> turns_of_patch_borders() const
  {
    std::vector<double> cosine(neighbors_.size(), 1); // of the turn at each vertex
    for (std::size_t v = 0; v < neighbors_.size(); ++v)
      if (!is_marked_[v] && is_inside_line(Index(v)))
        cosine[v] = cosine_of_turn(Index(v));
    std::vector<Index> result;
    for (std::size_t v = 0; v < neighbors_.size(); ++v)
      if (cosine[v] < 0.5 && is_sharpest(Index(v), cosine))
        result.push_back(Index(v));
    return result;
  }

  // Zigzags turn the direction of 8 edges by less than 30 degrees.
  static constexpr std::size_t edges_aside = 8;
  // Fewer edges before the end of a line have no direction but that of the zigzag.
  static constexpr std::size_t min_edges_aside = 2;

  // Returns the number of edges that determine the direction on each side: at most a quarter of a loop.
  std::size_t edges_beside(Index v) const
  {
    const std::vector<Index> around = walk(v, 0, 4 * edges_aside);
    return around.back() == v ? (std::max)((around.size() - 1) / 4, std::size_t(1)) : edges_aside;
  }

  double cosine_of_turn(Index v) const
  {
    const std::size_t edges = edges_beside(v);
    const std::vector<Index> before = walk(v, 0, edges), after = walk(v, 1, edges);
    const std::size_t m = before.size() - 1, n = after.size() - 1;
    if ((std::min)(m, n) < (std::min)(edges, min_edges_aside))
      return 1;
    const auto cosine = [&](std::size_t i, std::size_t j) {
      const Vector a = direction(before, i), b = direction(after, j);
      return -dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
    };
    return (std::max)(cosine(m, n), cosine((m + 1) / 2, (n + 1) / 2));
  }

  // Returns the direction of the regression line of the vertices on the first edges of a walk.
  Vector direction(const std::vector<Index>& vertices, std::size_t edges) const
  {
    Vector sum{{0, 0, 0}};
    for (std::size_t i = 0; i <= edges; ++i)
      sum = sum + (double(i) - 0.5 * double(edges)) * m_.points[vertices[i]];
    return sum;
  }

  bool is_sharpest(Index v, const std::vector<double>& cosine) const
  {
    const std::size_t edges = edges_beside(v);
    for (const std::size_t side : {0, 1})
      for (const Index w : walk(v, side, edges))
        if (cosine[w] < cosine[v] || (cosine[w] == cosine[v] && w < v))
          return false;
    return true;
  }

  const Flat_mesh& m_;
  Feature_edges result_;
  std::vector<char> is_marked_; // per vertex, whether it has feature edges other than borders of patches
  Feature_edges::Neighbors neighbors_;
};

CGAL_SURFACE_MESH_COARSENING_INLINE std::vector<Index> keep_features(Featured_input& input, const Feature_request& request,
                                                                     const Run_context& context)
{
  std::vector<Index> corners;
  if (request.angle == 180 && request.patches.empty() && request.edges.empty() && request.corners.empty())
    return corners;
  const Feature_edges edges = Feature_detection(input.items.mesh).run(request);
  if (edges.empty())
    return corners;
  for (std::size_t v = 0; v < edges.is_corner.size(); ++v)
    if (edges.is_corner[v])
      corners.push_back(Index(v));
  input = Feature_cells::run(Clustering_input(std::move(input.items)), edges, context);
  return corners;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FIND_FEATURES_IMPL_H
