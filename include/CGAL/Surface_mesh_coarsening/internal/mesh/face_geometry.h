// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FACE_GEOMETRY_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FACE_GEOMETRY_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

struct Face_geometry
{
  double area;
  Vector centroid;
};

// Half the sum of the cross products of a fan: its length is the area of a planar polygon, its direction the normal.
inline Vector vector_area(const Flat_mesh& m, Index f)
{
  const Index begin = m.first_corner[f], end = m.first_corner[f + 1];
  const Vector& p = m.points[m.corner_vertex[begin]];
  Vector sum{{0, 0, 0}};
  Vector side = m.points[m.corner_vertex[begin + 1]] - p;
  for (Index c = begin + 2; c != end; ++c) {
    const Vector next = m.points[m.corner_vertex[c]] - p;
    sum = sum + cross(side, next);
    side = next;
  }
  return 0.5 * sum;
}

inline Vector mean_of_corners(const Flat_mesh& m, Index f)
{
  Vector sum{{0, 0, 0}};
  for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c)
    sum = sum + m.points[m.corner_vertex[c]];
  return (1. / m.degree(f)) * sum;
}

inline double face_area(const Flat_mesh& m, Index f)
{
  const Vector normal = vector_area(m, f);
  return std::sqrt(dot(normal, normal));
}

inline Face_geometry face_geometry(const Flat_mesh& m, Index f)
{
  const Vector normal = vector_area(m, f);
  const double area = std::sqrt(dot(normal, normal));
  const Index begin = m.first_corner[f], end = m.first_corner[f + 1];
  if (end - begin == 3 || !(area > 0))
    return {area, mean_of_corners(m, f)};
  // Triangles of the fan that lie on the other side of the polygon's boundary count negative.
  const Vector& p = m.points[m.corner_vertex[begin]];
  Vector sum{{0, 0, 0}};
  for (Index c = begin + 2; c != end; ++c) {
    const Vector a = m.points[m.corner_vertex[c - 1]] - p, b = m.points[m.corner_vertex[c]] - p;
    sum = sum + (dot(cross(a, b), normal) / (6 * area * area)) * (a + b);
  }
  return {area, p + sum};
}

// The unit normal of each face, zero where a face has no area.
inline std::vector<Vector> unit_normals(const Flat_mesh& m, const Cancellation_point& cancellation = Cancellation_point(),
                                        Execution execution = Execution::SEQUENTIAL)
{
  std::vector<Vector> normals(m.number_of_faces());
  for_each_number(execution, normals.size(), cancellation, [&](Index f) {
    const Vector n = vector_area(m, f);
    const double length = std::sqrt(dot(n, n));
    normals[f] = length > 0 ? (1 / length) * n : Vector{{0, 0, 0}};
  });
  return normals;
}

// Section 5.2 of the paper before the mapping: for each face the mean length of the difference of its normal and the
// normals of the faces around its vertices. A pair counts once for each vertex that its faces share; faces without a
// normal deviate from nothing. Around a vertex of very many faces every one is compared with a fixed number of faces,
// evenly spread, which keeps the work linear.
class Normal_deviation
{
public:
  Normal_deviation(const Flat_mesh& mesh, const std::vector<Vector>& normals) : mesh_(mesh), normals_(normals) {}

  double operator()(Index f) const
  {
    const Vector& n = normals_[f];
    double sum = 0;
    std::size_t pairs = 0;
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c) {
      const Index v = mesh_.corner_vertex[c], begin = mesh_.first_in_star[v];
      const Index valence = mesh_.first_in_star[v + 1] - begin, compared = (std::min)(valence, max_compared);
      pairs += compared;
      for (Index j = 0; j < compared; ++j)
        sum += difference(n, normals_[mesh_.star[begin + place(j, valence)]]);
    }
    return n == none ? 0 : sum / double(pairs);
  }

private:
  static constexpr Index max_compared = 256;
  static constexpr Vector none{{0, 0, 0}};

  static Index place(Index j, Index valence)
  {
    return valence <= max_compared ? j : Index(std::uint64_t(j) * valence / max_compared);
  }

  static double difference(const Vector& n, const Vector& other)
  {
    const Vector d = n - other;
    const double length = std::sqrt(dot(d, d));
    return other == none ? 0 : length;
  }

  const Flat_mesh& mesh_;
  const std::vector<Vector>& normals_;
};

inline std::vector<double> mean_normal_deviations(const Flat_mesh& m,
                                                  const Cancellation_point& cancellation = Cancellation_point(),
                                                  Execution execution = Execution::SEQUENTIAL)
{
  const std::vector<Vector> normals = unit_normals(m, cancellation, execution);
  const Normal_deviation deviation(m, normals);
  std::vector<double> deviations(m.number_of_faces());
  for_each_number(execution, deviations.size(), cancellation, [&](Index f) { deviations[f] = deviation(f); });
  return deviations;
}

inline double largest_of(const std::vector<double>& deviations)
{
  return deviations.empty() ? 0 : *std::max_element(deviations.begin(), deviations.end());
}

// The linear mapping of section 5.2 from [0, maximum] to [1, maximum_density]. Where no normal deviates by more than the
// rounding of coordinates may make it, the mesh is flat.
inline void map_to_densities(std::vector<double>& deviations, double maximum, double maximum_density)
{
  constexpr double flat = 1e-6;
  for (double& d : deviations)
    d = maximum > flat ? 1 + (maximum_density - 1) * (d / maximum) : 1;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_FACE_GEOMETRY_H
