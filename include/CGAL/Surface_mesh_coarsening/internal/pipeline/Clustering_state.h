// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTERING_STATE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTERING_STATE_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>

#include <cstddef>
#include <memory>
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
  std::vector<long long> patches; // per face of the caller's mesh, if given
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

// Other placements than the fit do not return the vertices of single cells, and place the vertices of long clusters worse.
template <class Placement>
void choose_items_for(const Placement&, bool minimizes, Clustering_state& state)
{
  if (!is_fitted_placement<Placement> || minimizes)
    state.may_use_quadrics = false;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTERING_STATE_H
