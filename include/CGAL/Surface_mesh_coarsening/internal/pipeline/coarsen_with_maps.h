// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_COARSEN_WITH_MAPS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_COARSEN_WITH_MAPS_H

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Typed_energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Output_maps.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages.h>

#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

template <class Clustering, class Map>
void write_clusters(const Clustering& clustering, const Map& map) { clustering.write_clusters(map); }
template <class Clustering>
void write_clusters(const Clustering&, const CGAL::internal_np::Param_not_found&) {}

template <class Clustering, class Map>
void write_boundary_counts(const Clustering& clustering, const Map& map) { clustering.write_boundary_counts(map); }
template <class Clustering>
void write_boundary_counts(const Clustering&, const CGAL::internal_np::Param_not_found&) {}

// Runs all steps of a `Clustering`, which is an `Mwcvd_clustering`, and writes the maps of the caller. Calls `seed` for the seeds.
template <class Clustering, class FaceGraph, class Output, class NPIn, class NPOut, class Seed>
Coarsening_report coarsen_with_fitting_maps(const FaceGraph& input, Output& output, const NPIn& np_in, const NPOut& np_out,
                                            const Seed& seed)
{
  typedef Parameter_type<internal_np::vertex_placement_t, NPIn, Fitted_placement> Placement;
  typedef typename GetGeomTraits<Output, NPOut>::type Traits;
  check_input_stays<NPOut>(input, output);
  Clustering clustering(typename Clustering::Accepted(), input, np_in);
  const Placement placement = choose_parameter<Placement>(get_parameter(np_in, internal_np::vertex_placement_p));
  const Minimization_end end = chosen_minimization_end(np_in);
  clustering.choose_items_for(placement, end.max_rounds, end.tolerance);
  seed(clustering);
  clustering.grow();
  clustering.minimize(end.max_rounds, end.tolerance);
  Clustering_state& state = clustering.state();
  state.minimization.reset(); // frees memory
  Vertex_sources<FaceGraph, NPOut> sources(np_out);
  const Placed_dual dual = place_embedded(state, placement_model(placement), output_coordinates<Traits>(state.frame));
  emit(state, dual, output, np_out, [&](const std::vector<Vector>& positions) {
    const bool are_wanted = has_parameter<internal_np::vertex_source_t, NPOut> ||
                            has_parameter<internal_np::vertex_to_cluster_t, NPIn>;
    const std::vector<Index> clusters = are_wanted ? clusters_of_base_faces(state) : std::vector<Index>();
    sources.find(input, clustering, clusters, positions);
    write_clusters(clustering, get_parameter(np_in, internal_np::face_cluster));
    write_boundary_counts(clustering, get_parameter(np_in, internal_np::vertex_boundary_count));
    write_vertex_clusters(clustering.numbering(), state.base_input(), clusters, state.number_of_clusters(),
                          get_parameter(np_in, internal_np::vertex_to_cluster));
  });
  sources.write(output);
  return clustering.report();
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_COARSEN_WITH_MAPS_H
