// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FOOT_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FOOT_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Input_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Prepared_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A point of the input, and its foot, the closest point on a coarse mesh. Fills one cache line.
struct Input_sample
{
  Vector position;
  Index face;
  Index triangle = NONE; // of the foot; NONE before the first search
  Foot_point foot{};
};

// Finds the feet of samples of the input. A search begins at the previous foot or around a vertex.
class Foot_search
{
public:
  Foot_search(const Flippable_triangulation& coarse, const std::vector<Vector>& positions)
    : coarse_(coarse), positions_(positions), prepared_(coarse.triangles().size())
  {}

  // Must be called before the first search, and when a triangle has changed.
  void update(Index t) { prepared_[t] = Prepared_triangle(positions_, coarse_.triangles()[t]); }

  const Prepared_triangle& triangle(Index t) const { return prepared_[t]; }

  // Proceeds to the triangles around the corner nearest to the foot, and across the opposite side.
  void find_foot(Input_sample& s, Index vertex) const
  {
    constexpr int max_steps = 64;
    if (s.triangle == NONE)
      s.triangle = triangle_near(s.position, vertex);
    s.foot = prepared_[s.triangle].closest(s.position);
    for (int step = 0; step < max_steps; ++step) {
      const Index from = s.triangle;
      if (prepared_[from].is_far_from_sides(s.foot))
        break;
      const Vector& b = s.foot.barycentric;
      const int nearest = int(std::max_element(b.begin(), b.end()) - b.begin());
      improve_around(s, from, nearest);
      improve_foot(s, coarse_.neighbor(from, (nearest + 1) % 3));
      if (s.triangle == from)
        break;
    }
  }

  // Replaces a foot by the closest point of a triangle if it is nearer.
  void improve_foot(Input_sample& s, Index t) const
  {
    if (t != NONE && prepared_[t].improve(s.position, s.foot))
      s.triangle = t;
  }

  // Returns whether a search around a vertex does not test all triangles there.
  bool is_hub(Index v) const { return coarse_.around(v).size() > max_around; }

private:
  static constexpr std::size_t max_around = 16;

  // Returns the nearest triangle around a vertex; around a hub, the nearest of some of them, in order.
  Index triangle_near(const Vector& p, Index vertex) const
  {
    const std::vector<Index>& around = coarse_.around(vertex);
    const std::size_t step = is_hub(vertex) ? std::size_t(std::sqrt(double(around.size()))) : 1;
    Index triangle = NONE;
    double nearest = 0;
    for (std::size_t i = 0; i < around.size(); i += step) {
      const double square = prepared_[around[i]].closest(p).squared_distance;
      if (triangle == NONE || square < nearest) {
        nearest = square;
        triangle = around[i];
      }
    }
    return triangle;
  }

  void improve_around(Input_sample& s, Index t, int corner) const
  {
    const Index v = coarse_.triangles()[t][std::size_t(corner)];
    if (!is_hub(v)) {
      for (const Index u : coarse_.around(v))
        if (u != t)
          improve_foot(s, u);
    } else {
      improve_foot(s, coarse_.neighbor(t, corner));
      improve_foot(s, coarse_.neighbor(t, (corner + 2) % 3));
    }
  }

  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  std::vector<Prepared_triangle> prepared_;
};

// A point of a coarse triangle, and its foot, the closest point on the input. The weight is an area.
struct Back_sample
{
  Vector barycentric;
  Input_point foot{{{0, 0, 0}}, NONE};
  double weight = 0;
  double squared_distance = 0;
};

// The points of the quadrature of degree 4 on a triangle.
typedef std::array<Back_sample, 6> Back_samples;

inline double cost_of(const Back_samples& samples)
{
  double sum = 0;
  for (const Back_sample& s : samples)
    sum += s.weight * s.squared_distance;
  return sum;
}

// At most 32 points of the input with their faces. A search for a closest point begins at one of them. Refers to the points.
class Search_starts
{
public:
  void add(const Vector& p, Index face) { points_[number_++] = {&p, face}; }

  // Returns NONE if there are no points.
  Index face_of_nearest(const Vector& p) const
  {
    Index face = NONE;
    double nearest = 0;
    for (std::size_t i = 0; i < number_; ++i) {
      const Vector d = *points_[i].position - p;
      if (face == NONE || dot(d, d) < nearest) {
        nearest = dot(d, d);
        face = points_[i].face;
      }
    }
    return face;
  }

private:
  struct Start
  {
    const Vector* position;
    Index face;
  };

  std::array<Start, 32> points_;
  std::size_t number_ = 0;
};

// Finds the feet of the samples of coarse triangles. A search begins at the face of the nearest of some given points.
class Back_search
{
public:
  // `positions` are the positions of the vertices of the triangles.
  Back_search(const Clustered_faces& surface, const std::vector<Vector>& positions)
    : input_(surface.whole_mesh()), positions_(positions)
  {
    if (!input_.has_hubs())
      return;
    label_.resize(surface.whole_mesh().number_of_faces());
    for (std::size_t f = 0; f < surface.input().mesh.number_of_faces(); ++f)
      label_[surface.whole_face(Index(f))] = surface.labels()[Index(f)];
    search_.emplace(surface.whole_mesh(), label_, surface.number_of_clusters());
  }

  Back_samples operator()(const Triangle& t, const Search_starts& starts) const
  {
    Back_samples samples = without_feet(t);
    for (Back_sample& s : samples)
      find_foot(s, point_in(positions_, t, s.barycentric), starts);
    return samples;
  }

  // Finds the feet on a moved triangle. Most remain inside their faces, and need no search; `starts()` is called for the others.
  template <class Starts>
  Back_samples again(const Triangle& t, const Back_samples& before, const Starts& starts) const
  {
    Back_samples samples = without_feet(t);
    std::optional<Search_starts> found;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      Back_sample& s = samples[i];
      const Vector p = point_in(positions_, t, s.barycentric);
      const Index face = before[i].foot.face;
      Input_surface::Closest closest;
      if (face != NONE && input_.is_closest_inside(p, face, closest)) {
        set_foot(s, closest);
        continue;
      }
      if (!found)
        found = starts();
      find_foot(s, p, *found);
    }
    return samples;
  }

  // Returns the cost of the samples of a triangle; stops when the cost exceeds `limit`.
  double cost(const Triangle& t, const Search_starts& starts, double limit) const
  {
    Back_samples samples = without_feet(t);
    double sum = 0;
    for (std::size_t i = 0; i < samples.size() && !(sum > limit); ++i) {
      find_foot(samples[i], point_in(positions_, t, samples[i].barycentric), starts);
      sum += samples[i].weight * samples[i].squared_distance;
    }
    return sum;
  }

private:
  Back_samples without_feet(const Triangle& t) const
  {
    constexpr double near[2] = {0.445948490915965, 0.091576213509771}, part[2] = {0.223381589678011, 0.109951743655322};
    const double area = 0.5 * length(normal_of(positions_, t));
    Back_samples samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].barycentric = {{near[i / 3], near[i / 3], near[i / 3]}};
      samples[i].barycentric[i % 3] = 1 - 2 * near[i / 3];
      samples[i].weight = area * part[i / 3];
    }
    return samples;
  }

  // Without a start there is no foot, and the sample does not count.
  void find_foot(Back_sample& s, const Vector& p, const Search_starts& starts) const
  {
    constexpr int max_steps = 20;
    const Index start = starts.face_of_nearest(p);
    if (start == NONE) {
      s.weight = 0;
      return;
    }
    Input_surface::Closest closest = input_.closest_from(p, start, max_steps);
    if (search_ && closest.is_partial)
      closest = input_.closest_from(p, (*search_)(p, label_[closest.point.face]).face, max_steps);
    set_foot(s, closest);
  }

  static void set_foot(Back_sample& s, const Input_surface::Closest& closest)
  {
    s.foot = closest.point;
    s.squared_distance = closest.squared_distance;
  }

  const Input_surface input_;
  const std::vector<Vector>& positions_;
  // If descents do not visit all faces around some vertices. The group of a face is the cluster of one of its parts.
  std::optional<Nearest_point_search> search_;
  std::vector<Index> label_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FOOT_SEARCH_H
