// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_EDGES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_EDGES_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Finds the sharp turns of lines between patches. These lines follow the edges of faces, so they zigzag at any resolution. The
// direction on each side of a vertex is therefore the regression line of several edges. The turn at a corner does not depend on
// the number of edges, but the turn of a round line does: a corner turns sharply over some edges and over half of them.
class Smoothed_turns
{
public:
  // `neighbors` are the vertices before and after each vertex of a line; lines end at corners.
  Smoothed_turns(const Flat_mesh& m, const std::vector<std::vector<Index> >& neighbors, const std::vector<char>& is_corner)
    : m_(m), neighbors_(neighbors), is_corner_(is_corner) {}

  // Returns the vertices where a line turns by more than 60 degrees, and more than at the vertices around. `is_candidate(v)` returns
  // whether `v` is a vertex inside a line between patches.
  template <class Is_candidate>
  std::vector<Index> run(const Is_candidate& is_candidate)
  {
    cosine_.assign(neighbors_.size(), 1);
    for (std::size_t v = 0; v < neighbors_.size(); ++v)
      if (is_candidate(Index(v)))
        cosine_[v] = cosine_of_turn(Index(v));
    std::vector<Index> result;
    for (std::size_t v = 0; v < neighbors_.size(); ++v)
      if (cosine_[v] < 0.5 && is_sharpest(Index(v)))
        result.push_back(Index(v));
    return result;
  }

private:
  // Zigzags turn the direction of 8 edges by less than 30 degrees.
  static constexpr std::size_t edges_aside = 8;
  // Fewer edges before the end of a line have no direction but that of the zigzag.
  static constexpr std::size_t min_edges_aside = 2;

  // Returns the vertices from `v` along at most `edges` edges of the line, up to a corner or around a loop.
  std::vector<Index> walk(Index v, std::size_t side, std::size_t edges) const
  {
    std::vector<Index> vertices(1, v);
    Index previous = v, at = neighbors_[v][side];
    vertices.push_back(at);
    while (vertices.size() <= edges && !is_corner_[at] && at != v) {
      const Index next = neighbors_[at][neighbors_[at][0] == previous];
      previous = at;
      at = next;
      vertices.push_back(at);
    }
    return vertices;
  }

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

  bool is_sharpest(Index v) const
  {
    const std::size_t edges = edges_beside(v);
    for (const std::size_t side : {0, 1})
      for (const Index w : walk(v, side, edges))
        if (cosine_[w] < cosine_[v] || (cosine_[w] == cosine_[v] && w < v))
          return false;
    return true;
  }

  const Flat_mesh& m_;
  const std::vector<std::vector<Index> >& neighbors_;
  const std::vector<char>& is_corner_;
  std::vector<double> cosine_; // of the turn at each vertex
};

// The feature edges inside a mesh, and the corners, where feature lines end or meet.
struct Feature_edges
{
  std::vector<char> is_feature; // for the edge after each corner of a face; equal for both faces of the edge
  std::vector<char> is_corner;  // per vertex

  explicit Feature_edges(const Flat_mesh& m)
    : is_feature(m.corner_vertex.size(), false), is_corner(m.number_of_vertices(), false) {}

  bool empty() const
  {
    const auto is_set = [](char c) { return c != 0; };
    return std::none_of(is_feature.begin(), is_feature.end(), is_set) && std::none_of(is_corner.begin(), is_corner.end(), is_set);
  }

  // Calls `visit(v, w, f, c)` for each feature edge: its ends, a face, and its corner before the edge.
  template <class Visit>
  void for_each_edge(const Flat_mesh& m, const Visit& visit) const
  {
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f))
        if (is_feature[c] && f < m.face_across[c])
          visit(m.corner_vertex[c], m.corner_vertex[m.next_corner(Index(f), c)], Index(f), c);
  }

  // Returns the ends of the feature edges at each vertex.
  std::vector<std::vector<Index> > neighbors(const Flat_mesh& m) const
  {
    std::vector<std::vector<Index> > neighbors(m.number_of_vertices());
    for_each_edge(m, [&](Index v, Index w, Index, Index) {
      neighbors[v].push_back(w);
      neighbors[w].push_back(v);
    });
    return neighbors;
  }

  // Returns the features after star_subdivision() of chosen faces.
  Feature_edges in_fans(const Flat_mesh& m, const std::vector<char>& is_cut, const Flat_mesh& fans) const
  {
    Feature_edges result(fans);
    std::copy(is_corner.begin(), is_corner.end(), result.is_corner.begin());
    std::size_t i = 0;
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c, i += is_cut[f] ? 3 : 1)
        result.is_feature[i] = is_feature[c];
    return result;
  }

  // Returns the features after Quad_subdivision of the faces of the chosen components.
  Feature_edges subdivided(const Flat_mesh& m, const std::vector<bool>& chosen, const Flat_mesh& subdivision) const
  {
    Feature_edges result(subdivision);
    std::copy(is_corner.begin(), is_corner.end(), result.is_corner.begin());
    std::size_t i = 0;
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      for (const Index c : m.corners(f)) {
        result.is_feature[i++] = is_feature[c];
        if (!chosen[m.component[f]])
          continue;
        i += 2;
        result.is_feature[i++] = is_feature[m.previous_corner(Index(f), c)];
      }
    return result;
  }

  // Returns the features after Long_edge_cutting. `old_corner` is the corner before the edge of each new corner, or NONE.
  Feature_edges cut(const Flat_mesh& pieces, const std::vector<Index>& old_corner) const
  {
    Feature_edges result(pieces);
    std::copy(is_corner.begin(), is_corner.end(), result.is_corner.begin());
    for (std::size_t i = 0; i < old_corner.size(); ++i)
      result.is_feature[i] = old_corner[i] != NONE && is_feature[old_corner[i]];
    return result;
  }
};

// Finds feature edges and corners. Omits border edges, because the border is always kept.
class Feature_detection
{
public:
  explicit Feature_detection(const Flat_mesh& m) : m_(m), result_(m), is_marked_(m.number_of_vertices(), false) {}

  // Adds the edge after corner `c` of face `f`.
  void add_edge(Index f, Index c)
  {
    if (m_.face_across[c] == NONE)
      return;
    add_inner_edge(f, c);
    is_marked_[m_.corner_vertex[c]] = is_marked_[m_.corner_vertex[m_.next_corner(f, c)]] = true;
  }

  void add_corner(Index v)
  {
    if (m_.first_in_star[v] != m_.first_in_star[v + 1])
      result_.is_corner[v] = true;
  }

  // Adds the edges where the normals of the two faces differ by `degrees` or more. The corners beside the edge define
  // the normals, as in CGAL's detect_sharp_edges().
  void add_sharp_edges(double degrees)
  {
    const double cosine = std::cos(degrees * CGAL_PI / 180);
    for_each_inner_edge([&](Index f, Index c) {
      const Index g = m_.face_across[c];
      const Vector n = normal_beside(f, c), m = normal_beside(g, m_.corner_of(g, m_.corner_vertex[m_.next_corner(f, c)]));
      if (dot(n, n) == 0 || dot(m, m) == 0)
        return;
      const double product = dot(n, m), bound = cosine * cosine * dot(n, n) * dot(m, m);
      if (degrees == 0 || (cosine < 0 ? product < 0 && product * product >= bound : product < 0 || product * product <= bound))
        add_edge(f, c);
    });
  }

  // Adds as corners the tips: vertices without sharp edges where the normals of faces on opposite sides differ by `degrees` or
  // more, such as the apex of a cone.
  void add_tips(double degrees)
  {
    const double cosine = std::cos(0.5 * degrees * CGAL_PI / 180);
    for (std::size_t v = 0; v < m_.number_of_vertices(); ++v)
      if (!is_marked_[v] && !m_.is_on_border(Index(v)) && is_tip(Index(v), cosine))
        add_corner(Index(v));
  }

  // Adds the edges between faces of different patches. `patch(f)` is the patch of face `f`.
  template <class Patch>
  void add_patch_borders(const Patch& patch)
  {
    for_each_inner_edge([&](Index f, Index c) {
      if (patch(f) != patch(m_.face_across[c]))
        add_inner_edge(f, c);
    });
  }

  // Adds as corners the vertices whose number of feature edges is not two, and where lines reach the border or turn
  // sharply. Lines that only separate patches are smoothed.
  Feature_edges result()
  {
    neighbors_ = result_.neighbors(m_);
    for (std::size_t v = 0; v < m_.number_of_vertices(); ++v)
      if (!neighbors_[v].empty() && (neighbors_[v].size() != 2 || m_.is_on_border(Index(v))))
        result_.is_corner[v] = true;
    std::vector<Index> turns;
    for (std::size_t v = 0; v < m_.number_of_vertices(); ++v)
      if (is_marked_[v] && neighbors_[v].size() == 2 && !result_.is_corner[v] && turns_sharply(Index(v)))
        turns.push_back(Index(v));
    add_corners(turns);
    add_corners(Smoothed_turns(m_, neighbors_, result_.is_corner).run([&](Index v) {
      return !is_marked_[v] && neighbors_[v].size() == 2 && !result_.is_corner[v];
    }));
    std::vector<Index> halfway;
    result_.for_each_edge(m_, [&](Index v, Index w, Index, Index) {
      if (m_.is_on_border(v) && m_.is_on_border(w))
        for (const auto& ends : {std::make_pair(v, w), std::make_pair(w, v)})
          add_halfway(ends.first, ends.second, halfway);
    });
    add_corners(halfway);
    return result_;
  }

private:
  template <class Visit>
  void for_each_inner_edge(const Visit& visit)
  {
    for (std::size_t f = 0; f < m_.number_of_faces(); ++f)
      for (const Index c : m_.corners(f))
        if (m_.face_across[c] != NONE && f < m_.face_across[c])
          visit(Index(f), c);
  }

  void add_inner_edge(Index f, Index c)
  {
    result_.is_feature[c] = true;
    result_.is_feature[m_.corner_of(m_.face_across[c], m_.corner_vertex[m_.next_corner(f, c)])] = true;
  }

  void add_corners(const std::vector<Index>& vertices)
  {
    for (const Index v : vertices)
      result_.is_corner[v] = true;
  }

  // Returns the normal of face `f` beside the edge after corner `c`. A face of zero area has the normal of the face across its longest
  // edge, so a sharp line beside such faces is found once. Returns a null vector if there is no face across.
  Vector normal_beside(Index f, Index c) const
  {
    constexpr double tiny = 1e-6; // the height in units of the longest edge: slivers of rounded coordinates have no normal
    constexpr int max_faces = 8;
    for (int i = 0; i < max_faces; ++i) {
      const Index next = m_.next_corner(f, c), longest = longest_edge(f);
      const double square = squared_length(f, longest), bound = tiny * tiny * square * square;
      const Vector n = cross(point(next) - point(c), point(m_.next_corner(f, next)) - point(c));
      if (dot(n, n) > bound)
        return n;
      const Vector whole = vector_area(m_, f); // some corners of a polygon may be collinear
      if (dot(whole, whole) > bound)
        return whole;
      const Index across = m_.face_across[longest];
      if (across == NONE)
        break;
      c = m_.corner_of(across, m_.corner_vertex[m_.next_corner(f, longest)]);
      f = across;
    }
    return {{0, 0, 0}};
  }

  double squared_length(Index f, Index c) const
  {
    const Vector d = point(m_.next_corner(f, c)) - point(c);
    return dot(d, d);
  }

  // Returns the corner before the longest edge of a face.
  Index longest_edge(Index f) const
  {
    Index longest = m_.first_corner[f];
    for (const Index c : m_.corners(f))
      if (squared_length(f, c) > squared_length(f, longest))
        longest = c;
    return longest;
  }

  // Returns whether each face around is inclined against the mean normal by at least the angle.
  bool is_tip(Index v, double cosine) const
  {
    Vector mean{{0, 0, 0}};
    std::vector<Vector> normals;
    for (const Index f : m_.faces_around(v)) {
      const Index c = m_.corner_of(f, v);
      const Vector a = point(m_.next_corner(f, c)) - point(c), b = point(m_.previous_corner(f, c)) - point(c), n = cross(a, b);
      const double size = length(n);
      if (!(size > 0))
        continue;
      normals.push_back((1 / size) * n);
      mean = mean + std::atan2(size, dot(a, b)) * normals.back();
    }
    const double bound = cosine * length(mean);
    return normals.size() > 2 && std::all_of(normals.begin(), normals.end(), [&](const Vector& n) { return dot(n, mean) <= bound; });
  }

  const Vector& point(Index corner) const { return m_.points[m_.corner_vertex[corner]]; }

  // Adds a corner in the middle of a part of the border without corners that connects the ends of a line of one edge.
  // The corner separates this part from the line.
  void add_halfway(Index begin, Index end, std::vector<Index>& halfway) const
  {
    std::vector<Index> between(1, m_.next_on_border(begin));
    while (!result_.is_corner[between.back()])
      between.push_back(m_.next_on_border(between.back()));
    if (between.back() == end && between.size() > 1)
      halfway.push_back(between[between.size() / 2 - 1]);
  }

  // Returns whether a line turns by more than 60 degrees, measured both between adjacent edges and between chords of several
  // edges: on regular meshes, marked edges may zigzag without turning.
  bool turns_sharply(Index v) const
  {
    return turns_between(neighbors_[v][0], v, neighbors_[v][1]) && turns_between(some_edges_on(v, 0), v, some_edges_on(v, 1));
  }

  Index some_edges_on(Index v, std::size_t side) const
  {
    Index previous = v, at = neighbors_[v][side];
    for (int i = 1; i < 3 && !result_.is_corner[at] && at != v; ++i) {
      const Index next = neighbors_[at][neighbors_[at][0] == previous];
      previous = at;
      at = next;
    }
    return at;
  }

  bool turns_between(Index before, Index v, Index after) const
  {
    const Vector a = m_.points[v] - m_.points[before], b = m_.points[after] - m_.points[v];
    return dot(a, b) < 0.5 * std::sqrt(dot(a, a) * dot(b, b));
  }

  const Flat_mesh& m_;
  Feature_edges result_;
  std::vector<char> is_marked_;                // per vertex, whether it has feature edges other than borders of patches
  std::vector<std::vector<Index> > neighbors_; // per vertex, along feature edges
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_EDGES_H
