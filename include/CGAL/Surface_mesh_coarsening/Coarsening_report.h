// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSENING_REPORT_H
#define CGAL_SURFACE_MESH_COARSENING_COARSENING_REPORT_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of a coarsening.
struct Coarsening_report
{
  /// the level \f$ k \f$ of the neighborhoods of the seeds; the largest if components were seeded separately.
  std::size_t level = 0;
  /// the number of seeds found, before splits and merges.
  std::size_t seeds = 0;
  /// the number of clusters, which is the number of vertices of the output.
  std::size_t clusters = 0;
  /// the number of clusters that were split because after growth two of them met twice.
  std::size_t splits = 0;
  /// the number of pairs of clusters that were merged to reach the requested number.
  std::size_t merges = 0;
  /// the number of rounds of the minimization.
  std::size_t rounds = 0;
  /// the number of faces that changed cluster.
  std::size_t moves = 0;
  /// the number of edges between two clusters whose energies were compared.
  std::size_t tests = 0;
  /// with parameter `boundary_count_check`, how often a move that would have lowered the energy was refused by the paper's check
  /// of boundary-edge counts.
  std::size_t refused_by_boundary_counts = 0;
  /// how often a move that would have lowered the energy was refused because a cluster would not have remained a disc, or the
  /// dual a surface; with parameter `boundary_count_check`, of the moves that pass this check.
  std::size_t refused_by_guarantee = 0;
  /// the energy (8) of the clustering before the minimization.
  double initial_energy = 0;
  /// the energy (8) of the clustering after the minimization.
  double final_energy = 0;
  /// whether the last round gained at most `convergence_tolerance`, or changed nothing.
  bool converged = false;
  /// the number of connected components whose faces were subdivided internally, because whole faces could not form the number
  /// of clusters, or because of parameter `subdivide_input`.
  std::size_t subdivided_components = 0;
  /// the number of connected components removed because of parameter `minimum_component_area`.
  std::size_t dropped_components = 0;
  /// the number of clusters relocated to places of large distance (parameter `error_feedback`).
  std::size_t exchanged_vertices = 0;
  /// the number of pairs of triangles that intersected after the placement of the vertices but not in the input. This
  /// number and the next four are 0, or empty, if parameter `repair_output` is `false`.
  std::size_t intersections_found = 0;
  /// the number of such pairs after the repair, the smallest if there were several clusterings.
  std::size_t intersections_left = 0;
  /// these pairs, as numbers of the faces of the output in the order in which they are added.
  std::vector<std::pair<std::size_t, std::size_t> > intersecting_faces;
  /// the number of triangles that were degenerate after the placement, or faced away from the surface that they approximate,
  /// if that has an area.
  std::size_t reversals_found = 0;
  /// the number of such triangles after the repair.
  std::size_t reversals_left = 0;
  /// the faces of the output, numbered likewise, with an angle of less than 10 degrees. `Fitted_placement` leaves such angles
  /// where borders, features, sheets near each other or sharp parts of the input ask for them.
  std::vector<std::size_t> narrow_faces;
  /// the number of clusterings: one, and more if triangles remained intersecting
  /// (`Mwcvd_clustering::extract_embedded_dual_mesh()`). The other numbers describe the selected clustering.
  std::size_t clusterings = 1;
  /// the number of feature lines that are kept, each from corner to corner or closed.
  std::size_t feature_lines = 0;
  /// the number of feature corners that are kept.
  std::size_t feature_corners = 0;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_COARSENING_REPORT_H
