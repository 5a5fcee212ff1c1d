// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_MEASURE_COARSENING_H
#define CGAL_SURFACE_MESH_COARSENING_MEASURE_COARSENING_H

#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The error of a surface with respect to another surface, at samples of the first: the distances to the closest points of the
/// second surface, and the angles in degrees between the normals at these pairs of points.
struct Surface_error
{
  /// The root of the mean squared distance.
  double rms_distance = 0;
  /// The mean distance.
  double mean_distance = 0;
  /// The largest distance.
  double maximum_distance = 0;
  /// The root of the mean squared angle between the normals.
  double rms_normal_deviation = 0;
  /// The mean angle between the normals.
  double mean_normal_deviation = 0;
  /// The largest angle between the normals.
  double maximum_normal_deviation = 0;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The distance between two meshes, the deviation of their normals, and the shape of the triangles of the second mesh. Lengths
/// are in the unit of the meshes, angles in degrees. The members of the base class are the larger values of the two directions.
struct Coarsening_quality : Surface_error
{
  /// The error at samples of the first mesh, with respect to the second.
  Surface_error from_mesh;
  /// The error at samples of the second mesh, with respect to the first.
  Surface_error from_coarse;
  /// The mean, over the triangles of the second mesh, of the smallest angle of a triangle.
  double mean_smallest_angle = 0;
  /// The smallest angle of all triangles of the second mesh.
  double smallest_angle = 0;
  /// The fraction of the triangles of the second mesh with an angle of less than 30 degrees.
  double part_below_30_degrees = 0;
  /// The number of pairs of faces of the second mesh that intersect.
  std::size_t self_intersections = 0;
  /// The root of the mean squared distance between the borders as curves, the larger value of the two directions; 0 without
  /// borders, and infinity if one mesh has a border and the other has none.
  double border_rms_distance = 0;
  /// The mean distance between the borders, defined in the same way.
  double border_mean_distance = 0;
  /// The largest distance of a sample between the borders, defined in the same way.
  double border_maximum_distance = 0;
  /// The diagonal of the bounding box of the first mesh.
  double diagonal = 0;
};

/// \cond SKIP_IN_MANUAL

namespace internal {

typedef Exact_predicates_inexact_constructions_kernel Measuring_kernel;
typedef CGAL::Surface_mesh<Measuring_kernel::Point_3> Triangle_mesh;
typedef std::vector<Measuring_kernel::Segment_3> Segments;
typedef AABB_face_graph_triangle_primitive<Triangle_mesh> Triangle_primitive;
#if CGAL_VERSION_NR >= 1060000000
typedef AABB_segment_primitive_3<Measuring_kernel, Segments::const_iterator> Segment_primitive;
template <class Primitive>
using Aabb_tree = AABB_tree<AABB_traits_3<Measuring_kernel, Primitive> >;
#else
typedef AABB_segment_primitive<Measuring_kernel, Segments::const_iterator> Segment_primitive;
template <class Primitive>
using Aabb_tree = AABB_tree<AABB_traits<Measuring_kernel, Primitive> >;
#endif

template <class FaceGraph, class NamedParameters>
Triangle_mesh triangulated_copy(const FaceGraph& mesh, const NamedParameters& np)
{
  const Numbering<FaceGraph> n = numbering(mesh, np);
  Flat_mesh m = flat_connectivity(mesh, n);
  if (n.faces.empty())
    throw Invalid_input("a mesh without faces cannot be measured");
  const Local_frame frame = copy_points(mesh, np, n, m);
  std::vector<std::array<std::size_t, 3> > triangles;
  for (std::size_t f = 0; f < m.number_of_faces(); ++f)
    for (Index c = m.first_corner[f] + 2; c != m.first_corner[f + 1]; ++c)
      triangles.push_back({{m.corner_vertex[m.first_corner[f]], m.corner_vertex[c - 1], m.corner_vertex[c]}});
  Triangle_mesh copy;
  Polygon_mesh_processing::polygon_soup_to_polygon_mesh(to_points(m.points, frame, Measuring_kernel()), triangles, copy);
  return copy;
}

// Scales the meshes by a power of two, such that coordinates are at most about 1, and sets coordinates below 1e-40 to zero.
// Returns the exponent of the inverse scaling. The square of a normal, by which CGAL projects points onto triangles, stays in the
// range of double between these coordinates.
inline int scale_to_unit_size(Triangle_mesh& a, Triangle_mesh& b)
{
  double largest = 0;
  for (const Triangle_mesh* mesh : {&a, &b})
    for (const auto v : mesh->vertices())
      for (int i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::abs(mesh->point(v)[i]));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const auto scaled = [exponent](double x) {
    const double result = std::ldexp(x, -exponent);
    return std::abs(result) < 1e-40 ? 0 : result;
  };
  for (Triangle_mesh* mesh : {&a, &b})
    for (const auto v : mesh->vertices()) {
      auto& p = mesh->point(v);
      p = Measuring_kernel::Point_3(scaled(p.x()), scaled(p.y()), scaled(p.z()));
    }
  return exponent;
}

inline double diagonal(const Triangle_mesh& mesh)
{
  Bbox_3 box;
  for (const auto v : mesh.vertices())
    if (!mesh.is_isolated(v))
      box += mesh.point(v).bbox();
  return std::sqrt(squared_diagonal(box));
}

inline std::array<Measuring_kernel::Point_3, 3> corners(const Triangle_mesh& mesh, Triangle_mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
}

inline Measuring_kernel::Vector_3 normal(const Triangle_mesh& mesh, Triangle_mesh::Face_index f)
{
  const auto p = corners(mesh, f);
  return cross_product(p[1] - p[0], p[2] - p[0]);
}

// Returns the angle in degrees; 0 if a vector is zero.
inline double angle(const Measuring_kernel::Vector_3& a, const Measuring_kernel::Vector_3& b)
{
  const double product = std::sqrt(a.squared_length() * b.squared_length());
  return product > 0 ? 180 / CGAL_PI * std::acos(std::clamp(a * b / product, -1., 1.)) : 0;
}

inline double smallest_angle(const Triangle_mesh& mesh, Triangle_mesh::Face_index f)
{
  const auto p = corners(mesh, f);
  double smallest = 180;
  for (int i = 0; i < 3; ++i)
    smallest = (std::min)(smallest, angle(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]));
  return smallest;
}

struct Statistics
{
  double sum = 0, sum_of_squares = 0, maximum = 0;
  std::size_t samples = 0;

  void add(double value, double squared_value)
  {
    sum += value;
    sum_of_squares += squared_value;
    maximum = (std::max)(maximum, value);
    ++samples;
  }
  double rms() const { return samples == 0 ? 0 : std::sqrt(sum_of_squares / double(samples)); }
  double mean() const { return samples == 0 ? 0 : sum / double(samples); }
};

// Calls `visit(i, u, v)` for `samples` samples that are distributed over elements by size: the number of the element, and a point
// of the unit square. Samples lie at equal steps of the cumulated size. The points follow the additive recurrence of the plastic
// number, which fills the square evenly.
template <class Visit>
void for_each_sample(const std::vector<double>& sizes, std::size_t samples, const Visit& visit)
{
  const double total = std::accumulate(sizes.begin(), sizes.end(), 0.);
  const double plastic = 1.32471795724474602596;
  double cumulated = 0;
  std::size_t sample = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    cumulated += sizes[i];
    for (; sample < samples && (double(sample) + 0.5) * total < cumulated * double(samples); ++sample) {
      const double u = double(sample + 1) / plastic, v = double(sample + 1) / (plastic * plastic);
      visit(i, u - std::floor(u), v - std::floor(v));
    }
  }
}

inline Segments border_segments(const Triangle_mesh& mesh)
{
  Segments segments;
  for (const auto h : mesh.halfedges())
    if (mesh.is_border(h))
      segments.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  return segments;
}

inline Statistics border_distances(const Triangle_mesh& from, const Triangle_mesh& to, std::size_t samples)
{
  const Segments border = border_segments(from), other = border_segments(to);
  Statistics statistics;
  if (border.empty() || other.empty())
    return statistics;
  Aabb_tree<Segment_primitive> tree(other.begin(), other.end());
  tree.accelerate_distance_queries();
  std::vector<double> lengths;
  for (const auto& s : border)
    lengths.push_back(std::sqrt(s.squared_length()));
  for_each_sample(lengths, samples, [&](std::size_t i, double u, double) {
    const double d = tree.squared_distance(border[i].source() + u * border[i].to_vector());
    statistics.add(std::sqrt(d), d);
  });
  return statistics;
}

inline Surface_error surface_error(const Triangle_mesh& from, const Triangle_mesh& to, std::size_t samples)
{
  Aabb_tree<Triangle_primitive> tree(to.faces().begin(), to.faces().end(), to);
  tree.accelerate_distance_queries();
  std::vector<double> areas;
  std::vector<Triangle_mesh::Face_index> faces(from.faces().begin(), from.faces().end());
  areas.reserve(faces.size());
  for (const auto f : faces)
    areas.push_back(0.5 * std::sqrt(normal(from, f).squared_length()));
  Statistics distances, angles;
  for_each_sample(areas, samples, [&](std::size_t i, double u, double v) {
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto p = corners(from, faces[i]);
    const auto sample = p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]);
    const auto closest = tree.closest_point_and_primitive(sample);
    const double d = squared_distance(sample, closest.first), a = angle(normal(from, faces[i]), normal(to, closest.second));
    distances.add(std::sqrt(d), d);
    angles.add(a, square(a));
  });
  return {distances.rms(), distances.mean(), distances.maximum, angles.rms(), angles.mean(), angles.maximum};
}

inline void measure_borders(const Triangle_mesh& a, const Triangle_mesh& b, std::size_t samples, Coarsening_quality& quality)
{
  if (is_closed(a) != is_closed(b)) {
    quality.border_rms_distance = quality.border_mean_distance = quality.border_maximum_distance =
      std::numeric_limits<double>::infinity();
    return;
  }
  const Statistics forth = border_distances(a, b, samples), back = border_distances(b, a, samples);
  quality.border_rms_distance = (std::max)(forth.rms(), back.rms());
  quality.border_mean_distance = (std::max)(forth.mean(), back.mean());
  quality.border_maximum_distance = (std::max)(forth.maximum, back.maximum);
}

inline void scale_lengths(Coarsening_quality& quality, int exponent)
{
  for (Surface_error* e : {static_cast<Surface_error*>(&quality), &quality.from_mesh, &quality.from_coarse})
    for (double* length : {&e->rms_distance, &e->mean_distance, &e->maximum_distance})
      *length = std::ldexp(*length, exponent);
  for (double* length : {&quality.border_rms_distance, &quality.border_mean_distance, &quality.border_maximum_distance,
                         &quality.diagonal})
    *length = std::ldexp(*length, exponent);
}

} // namespace internal

/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningRef
/// measures how well a mesh approximates another mesh.
///
/// The function measures distances, and angles between normals, from samples on each mesh to the other mesh. Along the borders it
/// measures distances. Samples are distributed over the faces by area, at points that depend only on the mesh. Polygons are
/// triangulated as fans.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam CoarseFaceGraph a model of `FaceListGraph`
/// \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
/// \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the first mesh, for example the input of `coarsen_mesh()`
/// \param coarse the second mesh, for example its output
/// \param number_of_samples the number of samples in each direction
/// \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
/// \smcParam{geom_traits} of `mesh`
/// \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
/// \smcParam{geom_traits} of `coarse`
///
/// \pre Both meshes have a face.
/// \throws Invalid_input if a mesh has no face, or if a coordinate is not finite.
template <class FaceGraph, class CoarseFaceGraph,
          class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters>
Coarsening_quality measure_coarsening(const FaceGraph& mesh, const CoarseFaceGraph& coarse,
                                      std::size_t number_of_samples = 100000,
                                      const NamedParameters1& np1 = parameters::default_values(),
                                      const NamedParameters2& np2 = parameters::default_values())
{
  internal::Triangle_mesh a = internal::triangulated_copy(mesh, np1), b = internal::triangulated_copy(coarse, np2);
  const int exponent = internal::scale_to_unit_size(a, b);
  Coarsening_quality quality;
  quality.diagonal = internal::diagonal(a);
  quality.from_mesh = internal::surface_error(a, b, number_of_samples);
  quality.from_coarse = internal::surface_error(b, a, number_of_samples);
  for (const auto value : {&Surface_error::rms_distance, &Surface_error::mean_distance, &Surface_error::maximum_distance,
                           &Surface_error::rms_normal_deviation, &Surface_error::mean_normal_deviation,
                           &Surface_error::maximum_normal_deviation})
    quality.*value = (std::max)(quality.from_mesh.*value, quality.from_coarse.*value);
  internal::measure_borders(a, b, number_of_samples, quality);
  quality.smallest_angle = 180;
  for (const auto f : faces(b)) {
    const double angle = internal::smallest_angle(b, f);
    quality.smallest_angle = (std::min)(quality.smallest_angle, angle);
    quality.mean_smallest_angle += angle / double(num_faces(b));
    quality.part_below_30_degrees += angle < 30 - 1e-9 ? 1 / double(num_faces(b)) : 0;
  }
  std::vector<std::pair<internal::Triangle_mesh::Face_index, internal::Triangle_mesh::Face_index> > pairs;
  Polygon_mesh_processing::self_intersections(b, std::back_inserter(pairs));
  quality.self_intersections = pairs.size();
  internal::scale_lengths(quality, exponent);
  return quality;
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_MEASURE_COARSENING_H
