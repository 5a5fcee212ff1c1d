// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHOICE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHOICE_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Placement_model.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The energies of all clusters, for any weight.
typedef std::function<std::vector<double>(const Clustering_input&, const Cluster_labels&, std::size_t)> Cluster_energies;

// The choices of the caller. They are equal on all ranks, except the visitor and the scratch directory.
struct Distributed_choice
{
  static constexpr std::size_t default_faces_per_block = std::size_t(1) << 18, max_faces_per_task = std::size_t(1) << 21;
  static constexpr std::size_t clusters_per_task = 1000;

  std::size_t number_of_vertices = 0;
  std::optional<std::size_t> faces_per_block; // for blocks and tasks
  Minimization_end end;
  bool has_densities = false; // whether the caller passes densities
  double maximum_density = 0;
  Execution execution = Execution::SEQUENTIAL;
  Visitor_handle visitor;
  std::shared_ptr<const Energy_model> energy;
  Cluster_energies energies;
  Placement_model placement;
  Face_names face_names;
  std::function<Output_coordinates(const Local_frame&)> output_coordinates;
  bool merges_by_area = false, places_on_borders = true, repairs_output = false;
  bool wants_clusters = false, wants_output_everywhere = false;
  std::string scratch_directory; // if empty, all records are kept in memory
  std::uint64_t scratch_memory = 0; // the number of bytes of records that are kept in memory in spite of a scratch directory

  // Whether rank 0 places vertices on the surface of cells.
  bool places_on_cells() const { return placement.from_start || repairs_output; }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_CHOICE_H
