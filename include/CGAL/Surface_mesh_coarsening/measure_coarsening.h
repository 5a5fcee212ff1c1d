// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_MEASURE_COARSENING_H
#define CGAL_SURFACE_MESH_COARSENING_MEASURE_COARSENING_H

#include <CGAL/Surface_mesh_coarsening/internal/distance/Surface_sampling.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

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

inline Surface_error surface_error(const Triangle_mesh& from, const Triangle_mesh& to, std::size_t samples)
{
  const Distance_statistics s = distances(from, to, samples);
  return {s.rms(),         s.mean(), s.maximum, s.rms_normal_deviation(), s.mean_normal_deviation(), s.maximum_normal_deviation};
}

inline Surface_error larger_of(const Surface_error& a, const Surface_error& b)
{
  return {(std::max)(a.rms_distance, b.rms_distance),
          (std::max)(a.mean_distance, b.mean_distance),
          (std::max)(a.maximum_distance, b.maximum_distance),
          (std::max)(a.rms_normal_deviation, b.rms_normal_deviation),
          (std::max)(a.mean_normal_deviation, b.mean_normal_deviation),
          (std::max)(a.maximum_normal_deviation, b.maximum_normal_deviation)};
}

inline void measure_surfaces(const Triangle_mesh& a, const Triangle_mesh& b, std::size_t samples, Coarsening_quality& quality)
{
  quality.from_mesh = surface_error(a, b, samples);
  quality.from_coarse = surface_error(b, a, samples);
  static_cast<Surface_error&>(quality) = larger_of(quality.from_mesh, quality.from_coarse);
}

inline void measure_borders(const Triangle_mesh& a, const Triangle_mesh& b, std::size_t samples, Coarsening_quality& quality)
{
  if (is_closed(a) != is_closed(b)) {
    quality.border_rms_distance = quality.border_mean_distance = quality.border_maximum_distance =
      std::numeric_limits<double>::infinity();
    return;
  }
  const Distance_statistics forth = border_distances(a, b, samples), back = border_distances(b, a, samples);
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
  internal::measure_surfaces(a, b, number_of_samples, quality);
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

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_MEASURE_COARSENING_H
