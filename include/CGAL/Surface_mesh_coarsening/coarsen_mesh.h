// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_H

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Output_maps.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {
namespace internal {

// Writes the output and the maps of the caller. `run(clustering, placement, coordinates)` computes the clusters of a `Clustering`,
// which is an `Mwcvd_clustering`, and returns their dual.
template <class Clustering, class FaceGraph, class Output, class NPIn, class NPOut, class Run>
Coarsening_report coarsen_with_fitting_maps(const FaceGraph& input, Output& output, const NPIn& np_in, const NPOut& np_out,
                                            const Run& run)
{
  typedef Parameter_type<internal_np::vertex_placement_t, NPIn, Fitted_placement> Placement;
  typedef typename GetGeomTraits<Output, NPOut>::type Traits;
  check_input_stays<NPOut>(input, output);
  Clustering clustering(typename Clustering::Accepted(), input, np_in);
  const Placement placement = choose_parameter<Placement>(get_parameter(np_in, internal_np::vertex_placement_p));
  const Minimization_end end = chosen_minimization_end(np_in);
  clustering.choose_items_for(placement, end.max_rounds, end.tolerance);
  Clustering_state& state = clustering.state();
  const Placed_dual dual = run(clustering, placement_model(placement), output_coordinates<Traits>(state.frame));
  std::vector<Surface_location<FaceGraph> > sources; // on the input, before the output changes
  emit(state, dual, output, np_out, [&](const std::vector<Vector>& positions) {
    const bool are_wanted = has_parameter<internal_np::vertex_source_t, NPOut> ||
                            has_parameter<internal_np::vertex_to_cluster_t, NPIn>;
    const std::vector<Index> clusters = are_wanted ? clusters_of_base_faces(state) : std::vector<Index>();
    if constexpr (has_parameter<internal_np::vertex_source_t, NPOut>)
      sources = surface_locations(input, clustering.numbering(), state.base_input(), clusters, positions, state.context);
    if constexpr (has_parameter<internal_np::face_cluster_t, NPIn>)
      clustering.write_clusters(get_parameter(np_in, internal_np::face_cluster));
    if constexpr (has_parameter<internal_np::vertex_boundary_count_t, NPIn>)
      clustering.write_boundary_counts(get_parameter(np_in, internal_np::vertex_boundary_count));
    write_vertex_clusters(clustering.numbering(), state.base_input(), clusters, state.number_of_clusters(),
                          get_parameter(np_in, internal_np::vertex_to_cluster));
  });
  write_sources(output, std::move(sources), get_parameter(np_out, internal_np::vertex_source));
  return clustering.report();
}

template <class ConcurrencyTag, class FaceGraph, class Output, class NPIn, class NPOut, class Seed>
Coarsening_report coarsen_mesh(const FaceGraph& input, Output& output, const NPIn& np_in, const NPOut& np_out,
                               const Seed& seed)
{
  if constexpr (!fits_maps_of_clusters<FaceGraph, NPIn>()) // the errors that would follow hide the sentence
    return Coarsening_report();
  else
    return coarsen_with_fitting_maps<Mwcvd_clustering<FaceGraph, Energy_choice<NPIn>, ConcurrencyTag> >(
      input, output, np_in, np_out, [&](auto& clustering, const auto& placement, const auto& coordinates) {
        const Minimization_end end = chosen_minimization_end(np_in);
        seed(clustering);
        clustering.grow();
        clustering.minimize(end.max_rounds, end.tolerance);
        clustering.state().minimization.reset(); // frees memory
        return place_embedded(clustering.state(), placement, coordinates);
      });
}

} // namespace internal

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a polygon mesh to a given number of vertices by a clustering of its faces.
///
/// The output is a triangle mesh, a 2-manifold without isolated vertices, with exactly `number_of_vertices` vertices. Each
/// component of the output has the genus, the number of border loops and the orientation of its component of the input. The
/// input is not modified. The same input and parameters give the same output.
///
/// By default, clusters are merged by the residuals of their quadrics, and the vertices are fitted to the surface. If
/// `number_of_vertices` exceeds 0.09 times the number of vertices of the input, the dual cells of vertices are clustered instead
/// of faces (see `Mwcvd_clustering::seed_faces_or_cells()`). With the number of all vertices, the output is the surface of the
/// input, triangulated. With another energy or weight, other densities, another placement, and with another `number_of_iterations`
/// or `convergence_tolerance` than the default, the clusters form a multiplicatively weighted centroidal Voronoi diagram, as in the
/// paper; clusters of faces also do so without error feedback.
///
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`. `Parallel_tag`
/// needs oneTBB. The result depends neither on the tag nor on the number of threads. In parallel, several threads read `input` at
/// a time, and one thread reads property maps
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam OutputFaceGraph a model of `MutableFaceGraph`
/// \tparam NamedParametersIn a sequence of \ref bgl_namedparameters "Named Parameters"
/// \tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param input a 2-manifold polygon mesh: any number of components, borders, faces of any number of sides
/// \param number_of_vertices the number of vertices of the output, at least the minimum for the topology of the
/// input and at most the number of vertices of the input
/// \param output is cleared and filled; its `i`-th vertex is the vertex of cluster `i`. The output may be the input. Then the
/// maps of `np_in` are written before it is replaced, and `vertex_source_map` cannot be used.
/// \param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
/// \param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{cluster_weight}
///     \cgalParamDescription{the weight of a cluster in the energy}
///     \cgalParamType{a model of `ClusterWeight`}
///     \cgalParamDefault{`Weighted_area_weight()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{cluster_energy}
///     \cgalParamDescription{the energy that the minimization lowers, instead of a weight}
///     \cgalParamType{a model of `ClusterEnergy`}
///     \cgalParamDefault{`Weighted_inertia_energy`, with the weight}
///     \cgalParamExtra{Only one of `cluster_weight` and `cluster_energy` can be given.}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_density}
///     \cgalParamDescription{the density of the face whose normal deviates most from the normals around it, the
///                           paper's \f$ \rho_{new} \f$, in \f$ [1, 10^{20}] \f$}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`Coarsening_defaults::maximum_density`, which is `10`}
///     \cgalParamExtra{not used if `face_density_map` is given}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_density_map}
///     \cgalParamDescription{densities that replace the result of `compute_face_densities()`, in
///                           \f$ [10^{-20}, 10^{20}] \f$}
///     \cgalParamType{a model of `ReadablePropertyMap` with the faces as keys and values that `CGAL::to_double()` accepts}
///     \cgalParamDefault{densities from the deviation of normals}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the maximum number of rounds of the minimization; with 0, the minimization is omitted}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`1000`, which is rarely reached: `convergence_tolerance` ends the rounds earlier}
///   \cgalParamNEnd
///   \cgalParamNBegin{convergence_tolerance}
///     \cgalParamDescription{the relative gain of a round at which the minimization ends: it ends with the first round that
///     lowers the energy by at most this fraction. With 0, it ends with the first round that changes nothing, as in the paper}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.001`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_placement}
///     \cgalParamDescription{the position of the vertex of a cluster}
///     \cgalParamType{a model of `VertexPlacement` or `GlobalVertexPlacement`}
///     \cgalParamDefault{`Fitted_placement()`}
///     \cgalParamExtra{clusters on the border have their vertex on the border, unless `paper_rules` is `true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{paper_rules}
///     \cgalParamDescription{whether to follow the rules of the paper where the package replaces them: densities are not raised
///                           near borders, clusters are merged to the number of vertices by their area (section 6) instead of by
///                           mass and number of faces, moves in the minimization must also pass the check of section 7, and the
///                           placement computes the vertices of clusters on the border, too (section 8.3). The check is defined
///                           for triangle meshes; with it, the rounds run over the whole mesh, and the report counts the tests of
///                           moves that fail it, and of moves that pass it but fail the check of this package.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{`paper()` sets this parameter and the other parameters of the paper.}
///   \cgalParamNEnd
///   \cgalParamNBegin{repair_output}
///     \cgalParamDescription{whether to repair the output: vertices are moved and edges are flipped where triangles intersect
///     that do not intersect in the input, or where triangles face away from the input. If this does not suffice, the mesh is
///     reclustered (see `Mwcvd_clustering::extract_embedded_dual_mesh()`). The report counts the faults found and the remaining
///                           faults.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_feedback}
///     \cgalParamDescription{the largest number of rounds of `Fitted_placement` that relocate vertices from regions where they
///                           hardly lower the distance to regions where the distance is large. The rounds end earlier when they
///                           hardly lower the distance any more. The clusters are relocated too, and keep their number. The
///                           relocation is undone unless the result is closer to the input than the fit without these rounds, and
///                           its mean smallest angle reaches the goal or is no smaller. Further vertices are relocated to pairs of
///                           triangles that intersect after the repair. With 0, the densities alone distribute the vertices.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`Coarsening_defaults::error_feedback`, which is `12`; `0` if `face_density_map` is given}
///     \cgalParamExtra{not used with other placements, with 0 rounds of the minimization, or if clusters are given, edited or
///                     frozen. Faces on features and borders remain in their clusters.}
///   \cgalParamNEnd
///   \cgalParamNBegin{feature_angle}
///     \cgalParamDescription{the angle of features in degrees, in \f$ [0, 180] \f$. Edges between two faces whose normals differ
///     by this angle or more are kept as lines of edges of the output. The corners where lines end or meet are kept as vertices.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`180`: the angle of an edge does not make it a feature}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{additional edges to keep; border edges need no mark}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edges as keys and `bool` as value type}
///     \cgalParamDefault{no edge is marked}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{additional vertices to keep at their points, as corners}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertices as keys and `bool` as value type}
///     \cgalParamDefault{no vertex is marked}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_patch_map}
///     \cgalParamDescription{the number of the region of each face; edges between faces of different regions are kept}
///     \cgalParamType{a model of `ReadablePropertyMap` with the faces as keys and an integral value type}
///     \cgalParamDefault{there are no regions}
///   \cgalParamNEnd
///   \cgalParamNBegin{subdivide_input}
///     \cgalParamDescription{whether to subdivide the faces of an internal copy into one quadrilateral per corner,
///                           repeatedly, until there are 20 faces for each vertex of the output. This makes clusters of few faces
///                           rounder, and removes the upper limit of `number_of_vertices`. If features are kept, long edges are
///                           halved first.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{the cluster of a face is the cluster of its largest part}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_cluster_map}
///     \cgalParamDescription{receives the cluster of each face of `input`}
///     \cgalParamType{a model of `WritablePropertyMap` with the faces as keys and an integral value type}
///     \cgalParamDefault{the clusters are not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_to_cluster_map}
///     \cgalParamDescription{receives a cluster for each vertex of `input`: among the clusters of the incident faces, the cluster
///                           of largest area there}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertices as keys and an integral value type}
///     \cgalParamDefault{the clusters are not written}
///     \cgalParamExtra{isolated vertices get the number of clusters}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_boundary_count_map}
///     \cgalParamDescription{receives the boundary-edge count of each vertex of `input`: the number of incident edges that lie
///                           between two clusters or on the border}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertices as keys and an integral value type}
///     \cgalParamDefault{the counts are not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `input`}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertices as keys and a point type as value}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, input)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_index_map}
///     \cgalParamDescription{a property map associating to each face of `input` a unique index between `0` and
///                           `num_faces(input) - 1`; faces are traversed in this order}
///     \cgalParamType{a model of `ReadablePropertyMap` with the faces as keys and `std::size_t` as value}
///     \cgalParamDefault{the order of `faces(input)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an object that provides the coordinates of points}
///     \cgalParamType{a class with functors `Compute_x_3`, `Compute_y_3`, `Compute_z_3` and the functions that return
///                    them, as every \cgal kernel has}
///     \cgalParamDefault{a kernel deduced from the point type}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of the progress and may cancel; it is copied unless it is passed as `std::ref(visitor)`}
///     \cgalParamType{a model of `CoarseningVisitor`}
///     \cgalParamDefault{`Coarsening_visitor_base`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `output`}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertices as keys and a point type as value}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an object that constructs points}
///     \cgalParamType{a class with the functor `Construct_point_3` and the function that returns it, as every \cgal
///                    kernel has}
///     \cgalParamDefault{a kernel deduced from the point type}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_source_map}
///     \cgalParamDescription{receives the source of each vertex of `output`: the nearest point of the surface of `input`}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertices of `output` as keys and `Surface_location<FaceGraph>` as
///                    value}
///     \cgalParamDefault{no sources are computed}
///     \cgalParamExtra{faces of more than three sides are triangulated as fans}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{receives, for each edge, whether it belongs to a feature line}
///     \cgalParamType{a model of `WritablePropertyMap` with the edges as keys and `bool` as value type}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{receives, for each vertex, whether it is a feature corner}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertices as keys and `bool` as value type}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_patch_map}
///     \cgalParamDescription{receives, for each face, the number of its region, as in the `face_patch_map` of the input. If the
///                           input has no such map, the regions between feature lines are numbered from 0.}
///     \cgalParamType{a model of `WritablePropertyMap` with the faces as keys and an integral value type}
///     \cgalParamDefault{not written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return statistics of the coarsening.
///
/// \throws Unreachable_number_of_vertices if the number of vertices cannot be reached; the exception carries the nearest
/// attainable number.
/// \throws Invalid_input if the input has no faces, is not a 2-manifold or has a coordinate that is not finite, or if a
/// parameter is out of range.
/// \throws Coarsening_cancelled if the visitor cancels.
///
/// The output does not change if an exception is thrown.
///
/// Seeds, growth and each round of the minimization take time linear in the number of faces.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Coarsening_report coarsen_mesh(const FaceGraph& input, std::size_t number_of_vertices, OutputFaceGraph& output,
                               const NamedParametersIn& np_in = parameters::default_values(),
                               const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace internal;
  accept_parameters<NamedParametersIn, Coarsening_parameters,
                    Parameter_list<internal_np::vertex_boundary_count_t, internal_np::neighborhood_level_t> >();
  accept_parameters<NamedParametersOut, Output_parameters>();
  return internal::coarsen_mesh<ConcurrencyTag>(input, output, np_in, np_out, [&](auto& clustering) {
    if constexpr (has_parameter<internal_np::neighborhood_level_t, NamedParametersIn>)
      clustering.seed_from_level(get_parameter(np_in, internal_np::neighborhood_level_p), number_of_vertices);
    else
      clustering.seed_faces_or_cells(number_of_vertices);
  });
}

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a polygon mesh to a fraction of its vertices, to a number of faces, or to the number of seeds of a level.
///
/// One of the following parameters in `np_in` replaces the number of vertices; `keep_small_components` goes with `vertex_ratio`.
/// Otherwise the function behaves as the overload with a number of vertices.
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_ratio}
///     \cgalParamDescription{the number of vertices of the output divided by the number of vertices of `input`, for example
///                           `0.1`. The resulting number is rounded, and at least 1. Isolated vertices do not count.}
///     \cgalParamType{`double`}
///   \cgalParamNEnd
///   \cgalParamNBegin{keep_small_components}
///     \cgalParamDescription{whether components whose topology needs more vertices than `vertex_ratio` gives them stay as they are,
///                           triangulated, instead of `Unreachable_number_of_vertices` being thrown. The ratio then applies to the
///                           other components.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{The maps of `np_out` contain the vertices and edges of these components as corners and lines.}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_faces}
///     \cgalParamDescription{the number of triangles of the output. A closed surface has an even number of triangles. If the input
///                           has borders, the mesh is clustered for up to 8 numbers of vertices. The result has the nearest
///                           number of triangles found.}
///     \cgalParamType{`std::size_t`}
///   \cgalParamNEnd
///   \cgalParamNBegin{neighborhood_level}
///     \cgalParamDescription{the level of the neighborhoods of the seeds. The number of vertices is the number of seeds whose
///                           neighborhoods of this many steps are disjoint (see `neighborhood_seeds()`), unless the topology of
///                           the input needs more vertices. In the overload with a number of vertices, the clusters of these
///                           seeds are merged to the number.}
///     \cgalParamType{`std::size_t`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          , std::enable_if_t<!std::is_integral<OutputFaceGraph>::value && // an `int` is a number of vertices
                             !std::is_arithmetic<NamedParametersIn>::value>* = nullptr
#endif
          >
Coarsening_report coarsen_mesh(const FaceGraph& input, OutputFaceGraph& output,
                               const NamedParametersIn& np_in = parameters::default_values(),
                               const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace internal;
  constexpr bool has_ratio = has_parameter<internal_np::vertex_ratio_t, NamedParametersIn>,
                 has_faces = has_parameter<internal_np::number_of_faces_t, NamedParametersIn>,
                 has_level = has_parameter<internal_np::neighborhood_level_t, NamedParametersIn>;
  static_assert(has_ratio || has_faces || has_level,
                "how many vertices? Give a number, or one of the parameters vertex_ratio, number_of_faces and neighborhood_level");
  static_assert(int(has_ratio) + int(has_faces) + int(has_level) < 2,
                "the parameters vertex_ratio, number_of_faces and neighborhood_level exclude each other");
  accept_parameters<NamedParametersIn, Coarsening_parameters,
                    Parameter_list<internal_np::vertex_boundary_count_t, internal_np::vertex_ratio_t,
                                   internal_np::keep_small_components_t, internal_np::number_of_faces_t,
                                   internal_np::neighborhood_level_t> >();
  accept_parameters<NamedParametersOut, Output_parameters>();
  return internal::coarsen_mesh<ConcurrencyTag>(input, output, np_in, np_out, [&](auto& clustering) {
    if constexpr (has_ratio)
      clustering.seed_from_ratio(get_parameter(np_in, internal_np::vertex_ratio_p),
                                 choose_parameter(get_parameter(np_in, internal_np::keep_small_components_p), false));
    else if constexpr (has_faces) {
      const Minimization_end end = chosen_minimization_end(np_in);
      clustering.seed_from_number_of_faces(get_parameter(np_in, internal_np::number_of_faces_p), end.max_rounds, end.tolerance);
    } else if constexpr (has_level)
      clustering.seed_from_level(get_parameter(np_in, internal_np::neighborhood_level_p));
  });
}

/// \cond SKIP_IN_MANUAL
// The arguments in the order of other functions of CGAL, which gets one sentence instead of the errors of both functions above.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class OutputFaceGraph, class Number, class... NamedParameters,
          std::enable_if_t<!std::is_integral<OutputFaceGraph>::value && std::is_arithmetic<Number>::value>* = nullptr>
Coarsening_report coarsen_mesh(const FaceGraph&, OutputFaceGraph&, const Number&, const NamedParameters&...)
{
  static_assert(std::is_void<Number>::value,
                "the number of vertices precedes the output: coarsen_mesh(input, number_of_vertices, output)");
  return Coarsening_report();
}
/// \endcond

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_COARSEN_MESH_H
