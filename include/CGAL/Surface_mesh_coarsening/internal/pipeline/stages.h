// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_STAGES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_STAGES_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/find_features.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Output_maps.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_budget.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

class Cluster_editing;
class Initial_clustering;

// The number of faces per cluster that the subdivision provides. A cluster of this many faces can be round.
//! [faces]
constexpr std::size_t faces_per_cluster = 20;
//! [faces]

// If more than this part of the vertices of the mesh is requested, the dual cells of vertices are clustered instead of faces.
// With cells, the Horse at 10, 20, 60 and 80 % of its vertices has an RMS distance of 0.0104, 0.0060, 0.0013 and 0.0005 % of the
// diagonal; with faces 0.0110, 0.0068, 0.0034 and 0.0026 (`coarsen_mesh horse.off out.off -n 10% --measure`). With fewer
// clusters, cells are closer on some models, and faces on others.
//! [cells]
constexpr double min_share_of_cells = 0.09;
//! [cells]

// The origin of the clusters.
struct Seeding
{
  enum Kind { BY_CALLER, FOR_NUMBER, AT_LEVEL };
  Kind kind = BY_CALLER;         // BY_CALLER: the caller gave, edited or froze clusters
  std::size_t value = 0;         // the number, or the level
  bool may_use_quadrics = false; // whether clusters may be merged by quadrics, and cells of vertices used instead of faces
  std::size_t number = 0;        // AT_LEVEL: the number of clusters after merging; 0 for a cluster of each seed
};

// The data that the stages of the pipeline share, in arrays, independent of the types of mesh, weight and placement.
struct Clustering_state
{
  Clustering_state();
  ~Clustering_state();

  // Set by the preparation:
  Run_context context;
  bool may_use_quadrics = false; // whether weight and densities are the default
  bool subdivides_input = false, repairs_output = true;
  bool follows_paper = false; // parameter `paper_rules`
  std::size_t exchange_rounds = 0; // the number of rounds that relocate vertices to regions of large error
  Local_frame frame;
  Featured_input input;
  std::vector<long long> patches; // per face of the caller's mesh, if given; only one if all are equal
  std::shared_ptr<const Energy_model> energy;

  // Set by seeding and growth:
  Seeding seeding;
  std::unique_ptr<Initial_clustering> initial;
  std::unique_ptr<Cluster_labels> labels; // none before growth

  // Minimization and editing; each restarts after the other has changed the clusters:
  std::unique_ptr<Minimization> minimization;
  std::unique_ptr<Cluster_editing> editing;
  Minimization_end minimization_end; // as requested by the caller

  Coarsening_report report;

  // The faces of the mesh.
  const Clustering_input& base_input() const;
  // The labelled faces: the faces of the input, or pieces of them.
  const Featured_input& featured_input() const;
  const Clustering_input& working_input() const { return featured_input().items; }
  std::size_t number_of_clusters() const { return report.clusters; }
};

// Returns the same input with the cells of all vertices as items, or with faces as items, except at features.
inline Featured_input with_items(const Featured_input& input, Feature_cells::Extent extent, const Run_context& context)
{
  const Clustering_input& base = input.cells ? input.cells->base() : input.items;
  const Feature_edges edges = input.cells ? input.cells->edges() : Feature_edges(base.mesh);
  if (extent == Feature_cells::AT_FEATURES && edges.empty())
    return {base, nullptr};
  return Feature_cells::run(base, edges, context, extent);
}

// Other placements than the fit do not return the vertices of single cells, and place the vertices of long clusters worse. Other
// limits than the defaults request a minimization.
template <class Placement>
void choose_items_for(const Placement&, const Minimization_end& end, Clustering_state& state)
{
  if (!is_fitted_placement<Placement> || end.max_rounds != Coarsening_defaults::number_of_iterations ||
      end.tolerance != Coarsening_defaults::convergence_tolerance)
    state.may_use_quadrics = false;
}

// The pipeline: prepare -> seed -> grow -> minimize -> place (with repair) -> emit. Each stage is one function over the same
// state. Only the first and the last stage depend on the types of the meshes: `prepare()` and `Face_graph_filler`. All entry
// points call these functions.

// Discards the clusters.
void forget_clusters(Clustering_state& state);

// Finds seeds (section 6) and discards earlier clusters.
void seed(Clustering_state& state, const Seeding& seeding);

// Makes faces the items of the clustering, if the last seeds were cells of vertices.
void cluster_faces(Clustering_state& state);

// Returns the smallest and the largest attainable number of clusters.
std::pair<std::size_t, std::size_t> vertex_number_range(const Clustering_state& state);

// Returns `ratio` times the number of vertices of the mesh.
std::size_t number_of_vertices(const Clustering_state& state, double ratio);

// Keeps the components whose topology needs more than `ratio` times their vertices as they are. Returns `ratio` times the number of
// vertices of the other components, and all vertices of these.
std::size_t keep_small_components(Clustering_state& state, double ratio);

// Returns the number of vertices whose result has a number of faces, or nearly this number.
std::size_t vertices_for_faces(Clustering_state& state, std::size_t faces, const Minimization_end& end);

// Grows the clusters from the seeds to the requested number (section 8.1) and starts the minimization.
void grow(Clustering_state& state);

// Adopts given clusters; throws if they are not valid.
void set_clusters(Clustering_state& state, std::unique_ptr<Cluster_labels> labels, std::size_t number);

// Runs one round of the minimization (sections 5.1 and 8.2). Returns whether a face has moved.
bool minimize_round(Clustering_state& state);

// Runs rounds until the requested end.
void minimize(Clustering_state& state, const Minimization_end& end);

// Returns the energy (8).
double energy(const Clustering_state& state);

// Returns the labels; throws if there are none.
const Cluster_labels& labels(const Clustering_state& state);

// Throws if there is no cluster with this number.
void check_cluster(const Clustering_state& state, std::size_t cluster);

// Returns faces of the caller's mesh: before growth the seeds, after it one face of each cluster.
std::vector<Index> seeds(const Clustering_state& state);

// Returns the cluster of a face of the caller's mesh.
std::size_t cluster_of_face(const Clustering_state& state, Index face);

// Returns the clusters of the faces of `state.base_input()`.
std::vector<Index> clusters_of_base_faces(const Clustering_state& state);

// Steering: changes of one cluster between rounds. The functions throw if the cluster does not exist.
void freeze_cluster(Clustering_state& state, std::size_t cluster, bool is_frozen);
bool is_frozen(const Clustering_state& state, std::size_t cluster);
bool split_cluster(Clustering_state& state, std::size_t cluster);
bool remove_cluster(Clustering_state& state, std::size_t cluster);

// Returns the statistics of the clusters of a mesh with `faces` faces.
std::vector<Cluster_report> cluster_reports(const Clustering_state& state, std::size_t faces);

// The answers of the two checks whether a face of the caller's mesh may join a cluster: the paper's check of boundary-edge counts
// and the guarantee. They throw if the items of the clustering are not faces.
bool boundary_counts_allow_move(const Clustering_state& state, Index face, std::size_t cluster);
bool guarantee_allows_move(Clustering_state& state, Index face, std::size_t cluster);

// The dual of the clusters (section 8.3) with its positions.
struct Placed_dual
{
  std::unique_ptr<const Labelled_pieces> pieces;
  std::vector<Triangle> triangles;
  std::vector<Vector> positions;
  Repair_counts counts;
  std::size_t clusterings = 1;

  std::size_t number_left() const { return counts.intersections_left.size(); }
};

// Places the vertices and repairs the placement.
Placed_dual place(const Clustering_state& state, const Placement_model& placement, const Output_coordinates& output_coordinates);

// Places the vertices, repairs the placement, and reclusters if intersecting triangles remain.
Placed_dual place_embedded(Clustering_state& state, const Placement_model& placement,
                           const Output_coordinates& output_coordinates);

// Records the result in the report.
void report_placement(Coarsening_report& report, const std::vector<Triangle>& triangles, const std::vector<Vector>& positions,
                      const Repair_counts& counts, std::size_t clusterings = 1);

// The first stage: checks the mesh, copies it to arrays, and computes or reads densities and features (section 5.2).
template <class ConcurrencyTag, class FaceGraph, class NamedParameters>
void prepare(const FaceGraph& mesh, const NamedParameters& np, Numbering<FaceGraph>& elements, Clustering_state& state)
{
  state.context = Run_context(ConcurrencyTag(), get_parameter(np, CGAL::internal_np::visitor));
  state.context.stage_begins(Coarsening_stage::PREPARATION);
  elements = numbering(mesh, np, state.context);
  state.input.items = clustering_input(mesh, np, elements, state.frame, state.context);
  state.subdivides_input = choose_parameter(get_parameter(np, internal_np::subdivide_input_p), false);
  state.follows_paper = choose_parameter(get_parameter(np, internal_np::paper_rules_p), false);
  state.repairs_output = choose_parameter(get_parameter(np, internal_np::repair_output_p), true);
  constexpr bool has_densities = has_parameter<internal_np::face_density_t, NamedParameters>;
  const std::size_t default_feedback = has_densities ? 0 : Coarsening_defaults::error_feedback;
  state.exchange_rounds = choose_parameter(get_parameter(np, internal_np::error_feedback_p), default_feedback);
  Feature_request features = read_features(mesh, np, elements, state.input.items.mesh);
  const std::vector<Index> corners = keep_features(state.input, features, state.context);
  if (!corners.empty())
    state.frame.exact = exact_points(mesh, np, elements, corners, state.input.items.mesh);
  state.patches = std::move(features.patches);
  if (std::adjacent_find(state.patches.begin(), state.patches.end(), std::not_equal_to<>()) == state.patches.end() &&
      !state.patches.empty())
    state.patches = std::vector<long long>{state.patches[0]};
  state.context.stage_ends(Coarsening_stage::PREPARATION);
}

// The last stage: fills the output. Calls `before` after all steps that can fail, while the output is still unchanged.
template <class Output, class NamedParameters, class Before>
void emit(Clustering_state& state, const Placed_dual& dual, Output& output, const NamedParameters& np, const Before& before)
{
  report_placement(state.report, dual.triangles, dual.positions, dual.counts, dual.clusterings);
  Face_graph_filler<Output, NamedParameters> filler(output_points<Output>(dual.positions, state.frame, np), dual.triangles,
                                                    output, np, state.context);
  state.context.throw_if_cancelled();
  before(dual.positions);
  filler.commit();
  write_features(output, np, {dual.triangles, dual.pieces->features(), state.featured_input(), labels(state), state.patches});
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#ifndef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/stages_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_STAGES_H
