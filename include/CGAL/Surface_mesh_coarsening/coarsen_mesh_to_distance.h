// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_TO_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_TO_DISTANCE_H

#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance.h>

#include <cmath>
#include <type_traits>

namespace CGAL::Surface_mesh_coarsening {

namespace internal {

template <class ConcurrencyTag, class FaceGraph, class OutputFaceGraph, class NamedParametersIn, class NamedParametersOut>
Distance_report coarsen_to_goal(const FaceGraph& input, Distance_goal goal, OutputFaceGraph& output,
                                const NamedParametersIn& np_in, const NamedParametersOut& np_out)
{
  accept_parameters<NamedParametersIn, Coarsening_parameters>();
  accept_parameters<NamedParametersOut, Output_parameters>();
  typedef Mwcvd_clustering<FaceGraph, Energy_choice<NamedParametersIn>, ConcurrencyTag> Clustering;
  if (!(goal.distance > 0 && std::isfinite(goal.distance)))
    throw Invalid_input("the maximum distance is " + number_text(goal.distance));
  goal.end = chosen_minimization_end(np_in);
  Distance_report report;
  report.clustering = coarsen_with_fitting_maps<Clustering>(
    input, output, np_in, np_out, [&](auto& clustering, const auto& placement, const auto& coordinates) {
      return find_within_distance(clustering.state(), placement, coordinates, goal, report);
    });
  return report;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a polygon mesh to as few vertices as a bound of the distance permits.
///
/// The output is the coarsest result found whose two-sided Hausdorff distance to the input is at most `maximum_distance`. The
/// function bisects a list of numbers of vertices, from the least that the topology permits to the number of vertices of the
/// input, with a ratio of at most 1.08 between consecutive numbers. The list does not depend on the distance, so a larger distance
/// never leads to more vertices. For each number, the mesh is clustered, and the distance of the result is bounded over both
/// surfaces, not only at points. If the placement exchanges vertices (parameter `error_feedback`), it does so only where the
/// result without exchange is not close enough. Where a result is somewhat too far from the input, its vertices move toward the
/// input.
///
/// With the number of all vertices, `coarsen_mesh()` returns the surface of the input. Hence the function finds a result within
/// every distance above rounding errors, unless faces must be clustered (see `Mwcvd_clustering::seed_faces_or_cells()`), or the
/// placement is not `Fitted_placement`.
///
/// The distance is measured between surfaces: polygons of the input are triangulated as fans around the corner with the smallest
/// number, and degenerate triangles do not count. Otherwise the output has the properties of the output of
/// `coarsen_mesh()`.
///
/// \tparam ConcurrencyTag as in `coarsen_mesh()`
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam OutputFaceGraph a model of `MutableFaceGraph`
/// \tparam NamedParametersIn a sequence of \ref bgl_namedparameters "Named Parameters"
/// \tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param input a 2-manifold polygon mesh
/// \param maximum_distance the maximum distance, in the unit of length of the mesh
/// \param output is cleared and filled; its `i`-th vertex is the vertex of cluster `i`. The output may be the input. Then the
/// maps of `np_in` are written before it is replaced, and `vertex_source_map` cannot be used.
/// \param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters": all parameters of `coarsen_mesh()` except
/// \smcParam{neighborhood_level} and \smcParam{vertex_boundary_count_map}
/// \param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters": the parameters of
/// `coarsen_mesh()`
///
/// \return statistics of the search.
///
/// \throws Unreachable_distance if no result within the distance is found, even with as many vertices as the input has.
/// \throws Invalid_input if `maximum_distance` is not positive and finite, and as `coarsen_mesh()` does.
/// \throws Coarsening_cancelled if the visitor cancels.
///
/// The output does not change if an exception is thrown.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<!std::is_integral<OutputFaceGraph>::value>* = nullptr // an `int` is a number of vertices
#endif
          >
Distance_report coarsen_mesh_to_distance(const FaceGraph& input, double maximum_distance, OutputFaceGraph& output,
                                         const NamedParametersIn& np_in = parameters::default_values(),
                                         const NamedParametersOut& np_out = parameters::default_values())
{
  return internal::coarsen_to_goal<ConcurrencyTag>(input, {maximum_distance, {}}, output, np_in, np_out);
}

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a polygon mesh to as few vertices as a bound of the distance permits, but to at most `maximum_number_of_vertices`
/// vertices.
///
/// If this number of vertices is too small for the distance, the output has this number of vertices, and
/// `Distance_report::is_within_distance` is `false`. The bound of its distance is in the report. Otherwise the function behaves
/// as the overload without a number.
///
/// \throws Unreachable_number_of_vertices if the topology of the input needs more vertices.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Distance_report coarsen_mesh_to_distance(const FaceGraph& input, double maximum_distance,
                                         std::size_t maximum_number_of_vertices, OutputFaceGraph& output,
                                         const NamedParametersIn& np_in = parameters::default_values(),
                                         const NamedParametersOut& np_out = parameters::default_values())
{
  return internal::coarsen_to_goal<ConcurrencyTag>(input, {maximum_distance, {}, maximum_number_of_vertices}, output, np_in,
                                                   np_out);
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_TO_DISTANCE_H
