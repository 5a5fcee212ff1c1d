// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_EXTRACT_DUAL_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_EXTRACT_DUAL_MESH_H

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Clustering_check.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

#include <boost/range/value_type.hpp>

#include <string>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {
namespace internal {

struct Dual_soup
{
  std::vector<Vector> positions;
  std::vector<Triangle> triangles;
  Local_frame frame;
};

template <class FaceGraph, class FaceClusterMap, class NamedParameters>
Dual_soup dual_of_clusters(const FaceGraph& mesh, const FaceClusterMap& clusters, const NamedParameters& np)
{
  accept_parameters<
    NamedParameters, Geometry_parameters, Order_parameters,
    Parameter_list<internal_np::vertex_placement_t, internal_np::repair_output_t, internal_np::face_density_t> >();
  typedef Parameter_type<internal_np::vertex_placement_t, NamedParameters, Fitted_placement> Placement;
  const Numbering<FaceGraph> n = numbering(mesh, np);
  Clustering_input input;
  Dual_soup dual;
  input.mesh = flat_connectivity(mesh, n);
  dual.frame = copy_points(mesh, np, n, input.mesh);
  if constexpr (has_parameter<internal_np::face_density_t, NamedParameters>)
    input.density = read_densities(n, get_parameter(np, internal_np::face_density));
  else
    input.density.assign(n.faces.size(), 1);
  compute_areas_and_centroids(input);
  Cluster_labels labels(input.mesh);
  const auto names = label_clusters(n, clusters, labels);
  const auto name = [&](std::size_t x) { return "cluster " + std::to_string(names[x]); };
  const std::string fault = Clustering_check(labels, names.size()).fault_of_clusters(name);
  if (!fault.empty())
    throw Invalid_input(fault);
  labels.recount();
  dual.triangles = simplicial_dual_triangles(labels, name);
  Repair_counts counts;
  const Placement placement = choose_parameter<Placement>(get_parameter(np, internal_np::vertex_placement_p));
  const Clustered_faces surface(input, labels, names.size());
  dual.positions = place_vertices({surface, Border_arcs(surface), placement_model(placement)},
                                  choose_parameter(get_parameter(np, internal_np::repair_output_p), true),
                                  output_coordinates<typename GetGeomTraits<FaceGraph, NamedParameters>::type>(dual.frame),
                                  dual.triangles, counts);
  return dual;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshCoarseningRef
/// constructs the dual triangulation of clusters of faces of any origin. The triangulation has one vertex per cluster, one
/// triangle where three clusters meet, and a fan of triangles where more than three clusters meet (section 8.3 of the paper).
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
/// \tparam OutputFaceGraph a model of `MutableFaceGraph`
/// \tparam NamedParametersIn a sequence of \ref bgl_namedparameters "Named Parameters"
/// \tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh a 2-manifold polygon mesh
/// \param clusters the labels of the faces, which may be any numbers; the vertices are in the order of the labels
/// \param output is cleared and filled
/// \param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map},
/// \smcParam{face_index_map}, \smcParam{geom_traits}, \smcParam{vertex_placement} and \smcParam{repair_output} as in
/// `coarsen_mesh()`, and \smcParam{face_density_map}, which is 1 by default
/// \param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
/// \smcParam{geom_traits} of `output`
///
/// \throws Invalid_input if the mesh is not a 2-manifold, if a cluster is not a closed disc, or if two clusters meet
/// such that the dual is not a simplicial surface. The output does not change if an exception is thrown.
template <class FaceGraph, class FaceClusterMap, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
void extract_dual_mesh(const FaceGraph& mesh, const FaceClusterMap& clusters, OutputFaceGraph& output,
                       const NamedParametersIn& np_in = parameters::default_values(),
                       const NamedParametersOut& np_out = parameters::default_values())
{
  internal::accept_parameters<NamedParametersOut, internal::Geometry_parameters>();
  const internal::Dual_soup dual = internal::dual_of_clusters(mesh, clusters, np_in);
  auto points = internal::output_points<OutputFaceGraph>(dual.positions, dual.frame, np_out);
  internal::Face_graph_filler<OutputFaceGraph, NamedParametersOut>(std::move(points), dual.triangles, output, np_out).commit();
}

/// \ingroup PkgSurfaceMeshCoarseningRef
/// constructs the dual triangulation of clusters of faces of any origin as a polygon soup. See `extract_dual_mesh()`.
///
/// \tparam PointRange a model of `BackInsertionSequence` of points that the geometry traits construct
/// \tparam PolygonRange a model of `BackInsertionSequence` of ranges of indices that can be constructed from three
/// indices in braces, such as `std::vector<std::size_t>` and `std::array<std::size_t, 3>`
///
/// \param mesh a 2-manifold polygon mesh
/// \param clusters the labels of the faces, which may be any numbers
/// \param points the points are appended to this range
/// \param triangles the triangles are appended to this range, with indices into `points`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": the parameters of `np_in` in
/// `extract_dual_mesh()`
template <class FaceGraph, class FaceClusterMap, class PointRange, class PolygonRange,
          class NamedParameters = parameters::Default_named_parameters>
void extract_dual_soup(const FaceGraph& mesh, const FaceClusterMap& clusters, PointRange& points, PolygonRange& triangles,
                       const NamedParameters& np = parameters::default_values())
{
  typedef typename GetGeomTraits<FaceGraph, NamedParameters>::type Traits;
  typedef typename PolygonRange::value_type Polygon;
  typedef typename boost::range_value<Polygon>::type Number;
  const internal::Dual_soup dual = internal::dual_of_clusters(mesh, clusters, np);
  const Traits traits =
    internal::choose_parameter<Traits>(internal::get_parameter(np, CGAL::internal_np::geom_traits));
  const std::size_t first = points.size();
  for (const auto& p : internal::to_points(dual.positions, dual.frame, traits))
    points.push_back(p);
  for (const internal::Triangle& t : dual.triangles)
    triangles.push_back(Polygon{{Number(first + t[0]), Number(first + t[1]), Number(first + t[2])}});
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_EXTRACT_DUAL_MESH_H
