// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFERENCE_SURFACE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFERENCE_SURFACE_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/Bounding_box.h>
#include <CGAL/Surface_mesh_coarsening/internal/Coarse_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/Input_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/face_geometry.h>
#include <CGAL/Surface_mesh_coarsening/internal/sort_unique.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What the input says of coarse triangles: how the surface that they stand for faces, and whether it intersects itself there.
class Reference_surface
{
public:
  explicit Reference_surface(const Clustered_surface& surface)
    : surface_(surface), input_(surface.input().mesh), normals_(surface.number_of_clusters(), Vector{{0, 0, 0}}),
      boxes_(surface.number_of_clusters())
  {
    for_each_chunk(surface.execution(), normals_.size(), 16, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x) {
        normals_[x] = mean_normal(x);
        boxes_[x] = boxes_of_blocks(x);
      }
    });
  }

  // The mean normal of the faces of a cluster, the shorter the more they are bent. It is zero where they have no area.
  const Vector& normal(Index cluster) const { return normals_[cluster]; }

  // Whether any of the clusters of a coarse triangle has an area.
  bool has_area(const Triangle& t) const
  {
    constexpr Vector none{{0, 0, 0}};
    return std::any_of(t.begin(), t.end(), [&](Index x) { return normals_[x] != none; });
  }

  // Whether a coarse triangle looks away from the surface at the closest point of its clusters. That is looked for only where
  // the mean normals are not enough. Where the point lies on an edge, or several are as close, roundings do not choose: all
  // faces there count.
  bool is_against(const Triangle& t, const std::vector<Vector>& positions) const
  {
    const Vector n = normal_of(positions, t), mean = normals_[t[0]] + normals_[t[1]] + normals_[t[2]];
    const double size = std::sqrt(dot(n, n));
    if (dot(n, mean) > 0.5 * size * std::sqrt(dot(mean, mean)))
      return false;
    const Vector middle = (1. / 3) * (positions[t[0]] + positions[t[1]] + positions[t[2]]);
    double nearest = squared_distance_from_nearest_block(middle, t);
    std::vector<std::pair<double, Index> > faces;
    for (const Index x : t)
      for (std::size_t i = 0; i < surface_.faces(x).size(); ++i) {
        if (i % block == 0 && !boxes_[x].empty() &&
            boxes_[x][i / block].squared_distance(middle) > same_as(nearest, size)) {
          i += block - 1;
          continue;
        }
        const Index f = surface_.faces(x).begin()[i];
        const double squared_distance = input_.closest_on_face(middle, f).squared_distance;
        if (squared_distance <= same_as(nearest, size))
          faces.emplace_back(squared_distance, f);
        nearest = (std::min)(nearest, squared_distance);
      }
    Vector there{{0, 0, 0}};
    for (const auto& [squared_distance, f] : faces)
      if (squared_distance <= same_as(nearest, size))
        there = there + vector_area(surface_.input().mesh, f);
    return dot(n, there) < -1e-9 * size * std::sqrt(dot(there, there));
  }

  // The sum over some clusters of about their area times their mean squared distance from coarse triangles. Stops where it
  // has reached `limit`.
  double squared_distance(const std::vector<Index>& clusters, const std::vector<Triangle>& triangles,
                          const std::vector<Vector>& positions, double limit) const
  {
    constexpr std::size_t most_samples = 24;
    std::vector<Ball> balls;
    balls.reserve(triangles.size());
    for (const Triangle& t : triangles)
      balls.push_back(ball_around(t, positions));
    std::size_t last = 0; // the triangle nearest to the sample before
    double sum = 0;
    for (const Index x : clusters) {
      const Clustered_surface::Range faces = surface_.faces(x);
      const std::size_t step = 1 + faces.size() / most_samples;
      for (std::size_t i = 0; i < faces.size(); i += step) {
        const Index f = faces.begin()[i];
        sum += double(step) * surface_.area(f) * squared_distance(surface_.centroid(f), triangles, balls, positions, last);
        if (sum >= limit)
          return sum;
      }
    }
    return sum;
  }

  // Whether faces of the clusters of one coarse triangle intersect those of another's. Faces with a common vertex are not
  // looked at: there are many of them, and they hardly ever have more than that in common.
  bool intersects_itself(const Triangle& t, const Triangle& u)
  {
    for (const Index x : t)
      for (const Index y : u)
        if (clusters_intersect((std::min)(x, y), (std::max)(x, y)))
          return true;
    return false;
  }

private:
  // Up to where squared distances are the same but for rounding, in a triangle of about that squared size.
  static double same_as(double squared_distance, double squared_size)
  {
    return 1.000000001 * squared_distance + 1e-18 * squared_size;
  }

  Vector mean_normal(std::size_t cluster) const
  {
    constexpr double rounding = 1e-13; // what the rounding of coordinates makes of the area of points on a line
    Vector sum{{0, 0, 0}};
    double area = 0, reach = 0;
    const Vector& first = surface_.point(*surface_.vertices(*surface_.faces(cluster).begin()).begin());
    for (const Index f : surface_.faces(cluster)) {
      sum = sum + vector_area(surface_.input().mesh, f);
      area += surface_.area(f);
      for (const Index v : surface_.vertices(f)) {
        const Vector d = surface_.point(v) - first;
        reach = (std::max)(reach, dot(d, d));
      }
    }
    return area > rounding * reach ? (1 / area) * sum : Vector{{0, 0, 0}};
  }

  // Clusters of many faces have boxes of blocks of them, so that not all are looked at where the nearest is looked for.
  static constexpr std::size_t block = 32, many = 256;

  std::vector<Bounding_box> boxes_of_blocks(std::size_t cluster) const
  {
    const Clustered_surface::Range faces = surface_.faces(cluster);
    if (faces.size() < many)
      return {};
    std::vector<Bounding_box> boxes((faces.size() + block - 1) / block);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const Index v : surface_.vertices(faces.begin()[i]))
        boxes[i / block].add(surface_.point(v));
    return boxes;
  }

  // The squared distance of the block whose box is nearest; infinite where there are no boxes.
  double squared_distance_from_nearest_block(const Vector& p, const Triangle& t) const
  {
    double least = std::numeric_limits<double>::infinity(), nearest = least;
    Index cluster = NONE;
    std::size_t number = 0;
    for (const Index x : t)
      for (std::size_t i = 0; i < boxes_[x].size(); ++i) {
        const double d = boxes_[x][i].squared_distance(p);
        if (d < least) {
          least = d;
          cluster = x;
          number = i;
        }
      }
    if (cluster == NONE)
      return nearest;
    const Clustered_surface::Range faces = surface_.faces(cluster);
    for (std::size_t i = number * block; i < (std::min)((number + 1) * block, faces.size()); ++i)
      nearest = (std::min)(nearest, input_.closest_on_face(p, faces.begin()[i]).squared_distance);
    return nearest;
  }

  struct Ball
  {
    Vector center;
    double radius;
  };

  static Ball ball_around(const Triangle& t, const std::vector<Vector>& positions)
  {
    Ball ball{(1. / 3) * (positions[t[0]] + positions[t[1]] + positions[t[2]]), 0};
    for (const Index v : t) {
      const Vector d = positions[v] - ball.center;
      ball.radius = (std::max)(ball.radius, dot(d, d));
    }
    ball.radius = std::sqrt(ball.radius);
    return ball;
  }

  // From the nearest of some triangles. Those whose balls are farther away than the nearest so far are passed over.
  static double squared_distance(const Vector& p, const std::vector<Triangle>& triangles, const std::vector<Ball>& balls,
                                 const std::vector<Vector>& positions, std::size_t& last)
  {
    const auto to = [&](std::size_t i) {
      const Triangle& t = triangles[i];
      return closest_on_triangle(p, positions[t[0]], positions[t[1]], positions[t[2]]).squared_distance;
    };
    const std::size_t first = last;
    double nearest = to(first), distance = std::sqrt(nearest);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Vector d = p - balls[i].center;
      const double reach = 1.000001 * (balls[i].radius + distance);
      if (i == first || dot(d, d) > reach * reach)
        continue;
      const double square = to(i);
      if (square < nearest) {
        nearest = square;
        distance = std::sqrt(square);
        last = i;
      }
    }
    return nearest;
  }

  bool clusters_intersect(Index x, Index y)
  {
    const auto known = intersecting_.find({x, y});
    if (known != intersecting_.end())
      return known->second;
    std::vector<Triangle> all = pieces_at(x, box_of(y));
    const std::ptrdiff_t of_x = std::ptrdiff_t(all.size());
    const std::vector<Triangle> of_y = pieces_at(y, box_of(x));
    all.insert(all.end(), of_y.begin(), of_y.end());
    std::vector<Exact_point> points;
    const std::vector<Triangle> named = name_common_points(all, points);
    const Triangle_conflict conflict(points);
    std::vector<Triangle_box> boxes = triangle_boxes(named, conflict);
    const auto middle = boxes.begin() + of_x;
    bool found = false;
    box_intersection_d(boxes.begin(), middle, middle, boxes.end(), [&](const Triangle_box& a, const Triangle_box& b) {
      const Triangle &f = named[a.info()], &g = named[b.info()];
      found = found || (!have_common_corner(f, g) && conflict(f, g));
    });
    return intersecting_[{x, y}] = found;
  }

  static bool have_common_corner(const Triangle& t, const Triangle& u)
  {
    return std::find_first_of(t.begin(), t.end(), u.begin(), u.end()) != t.end();
  }

  Bounding_box box_of(Index x) const
  {
    Bounding_box box;
    for (const Index f : surface_.faces(x))
      for (const Index v : surface_.vertices(f))
        box.add(surface_.point(v));
    return box;
  }

  // The faces of a cluster, as fans, as far as they may have to do with what is in a box.
  std::vector<Triangle> pieces_at(Index x, const Bounding_box& box) const
  {
    std::vector<Triangle> triangles;
    for (const Index f : surface_.faces(x)) {
      const Clustered_surface::Range v = surface_.vertices(f);
      for (std::size_t i = 2; i < v.size(); ++i) {
        const Triangle t{v.begin()[0], v.begin()[i - 1], v.begin()[i]};
        Bounding_box around;
        for (const Index corner : t)
          around.add(surface_.point(corner));
        if (around.overlaps(box))
          triangles.push_back(t);
      }
    }
    return triangles;
  }

  // Numbers the corners from 0, and makes their points.
  std::vector<Triangle> name_common_points(std::vector<Triangle> triangles, std::vector<Exact_point>& points) const
  {
    std::vector<Index> used;
    for (const Triangle& t : triangles)
      used.insert(used.end(), t.begin(), t.end());
    sort_unique(used);
    for (const Index v : used) {
      const Vector& p = surface_.point(v);
      points.emplace_back(p[0], p[1], p[2]);
    }
    for (Triangle& t : triangles)
      for (Index& v : t)
        v = Index(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    return triangles;
  }

  const Clustered_surface& surface_;
  Input_surface input_;
  std::vector<Vector> normals_;
  std::vector<std::vector<Bounding_box> > boxes_; // of each cluster, in the order of its faces
  std::map<std::pair<Index, Index>, bool> intersecting_; // pairs of clusters that were looked at
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REFERENCE_SURFACE_H
