// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_TO_DISTANCE_H
#define CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_TO_DISTANCE_H

#include <CGAL/Surface_mesh_coarsening/Distance_report.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/number_text.h>
#include <CGAL/Surface_mesh_coarsening/internal/distance/find_within_distance.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Vertex_sources.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \cond SKIP_IN_MANUAL
namespace internal {

// The placement for the first estimates of the number of vertices: `Start` of the placement if it has this type, otherwise the
// placement itself.
template <class Placement, class = void>
struct Quick_placement
{
  typedef Placement type;
};
template <class Placement>
struct Quick_placement<Placement, std::void_t<typename Placement::Start> >
{
  typedef typename Placement::Start type;
};

} // namespace internal
/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a polygon mesh to as few vertices as a bound of the distance permits.
///
/// The output is the coarsest result found whose two-sided Hausdorff distance to the input is at most `maximum_distance`. The
/// function merges a fine clustering to levels of detail (see `Cluster_levels`), and brackets the number of vertices among these
/// levels. It estimates distances at points of both surfaces, first with the placement's `Start`, if it has one (see
/// `GlobalVertexPlacement`), then with the placement. The distance of the result is bounded over both surfaces, not only at points.
/// If the bound is too large, the search continues with a finer level.
/// If the placement exchanges vertices (parameter `error_feedback`), the levels only predict the number of vertices. The mesh is
/// clustered for up to four numbers, because the result of a clustering of its own is closer to the input than a level. Where
/// such a result is too far from the input, its vertices move toward the input. If none of these results is within the distance,
/// the levels are searched.
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
/// \smcParam{start_from_face_clusters}, \smcParam{neighborhood_level} and \smcParam{vertex_boundary_count_map}
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
          class NamedParametersOut = parameters::Default_named_parameters>
Distance_report coarsen_mesh_to_distance(const FaceGraph& input, double maximum_distance, OutputFaceGraph& output,
                                         const NamedParametersIn& np_in = parameters::default_values(),
                                         const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace internal;
  accept_parameters<NamedParametersIn, Coarsening_parameters>();
  accept_parameters<NamedParametersOut, Geometry_parameters, Parameter_list<internal_np::vertex_source_t> >();
  typedef Energy_choice<NamedParametersIn> Energy;
  typedef Parameter_type<internal_np::vertex_placement_t, NamedParametersIn, Fitted_placement> Placement;
  typedef Mwcvd_clustering<FaceGraph, Energy, ConcurrencyTag> Clustering;
  typedef typename GetGeomTraits<OutputFaceGraph, NamedParametersOut>::type Traits;
  if (!(maximum_distance > 0 && std::isfinite(maximum_distance)))
    throw Invalid_input("the maximum distance is " + number_text(maximum_distance));

  const auto source_map = get_parameter(np_out, internal_np::vertex_source);
  check_input_stays<std::decay_t<decltype(source_map)> >(input, output);
  Distance_report report;
  Clustering clustering(typename Clustering::Accepted(), input, np_in);
  const Minimization_end end{choose_parameter(get_parameter(np_in, CGAL::internal_np::number_of_iterations),
                                              Coarsening_defaults::number_of_iterations),
                             choose_parameter(get_parameter(np_in, internal_np::convergence_tolerance_p),
                                              Coarsening_defaults::convergence_tolerance)};
  if (!(end.tolerance >= 0))
    throw Invalid_input("the convergence tolerance is " + std::to_string(end.tolerance));
  const Placement placement = choose_parameter<Placement>(get_parameter(np_in, internal_np::vertex_placement_p));
  const typename Quick_placement<Placement>::type quick_placement{};
  constexpr bool has_quick_placement = !std::is_same<std::decay_t<decltype(quick_placement)>, Placement>::value;
  Clustering_state& state = clustering.state();
  state.may_cluster_cells = state.may_cluster_cells && exchanges_vertices<Placement>;
  const Dual_within_distance dual =
    find_within_distance(state, placement_model(placement),
                         has_quick_placement ? std::make_optional(placement_model(quick_placement)) : std::nullopt,
                         output_coordinates<Traits>(state.frame), maximum_distance, end, num_vertices(input), report);

  report.clustering = clustering.report();
  report.clustering.clusters = report.vertices;
  Vertex_sources<FaceGraph, std::decay_t<decltype(source_map)> > sources(source_map);
  Face_graph_filler<OutputFaceGraph, NamedParametersOut> filler(dual.positions, state.frame, dual.triangles, output,
                                                                np_out);
  state.visitor.throw_if_cancelled();
  const std::vector<Index>& clusters = dual.clusters_of_base_faces;
  sources.find(input, clustering.numbering(), state.base_input(), clusters, dual.positions, state.cancellation());
  write_face_clusters(clustering.numbering(), state.base_input(), clusters, report.vertices,
                      get_parameter(np_in, internal_np::face_cluster));
  write_vertex_clusters(clustering.numbering(), state.base_input(), clusters, report.vertices,
                        get_parameter(np_in, internal_np::vertex_to_cluster));
  filler.commit();
  sources.write(output);
  return report;
}

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_TO_DISTANCE_H
