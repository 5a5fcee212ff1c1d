// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSENING_REPORT_H
#define CGAL_SURFACE_MESH_COARSENING_COARSENING_REPORT_H

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of a coarsening.
struct Coarsening_report
{
  /// the level \f$ k \f$ of the neighborhoods of the seeds; the largest level if components were seeded separately.
  std::size_t level = 0;
  /// the number of seeds found, before splits and merges.
  std::size_t seeds = 0;
  /// the number of clusters, which is the number of vertices of the output.
  std::size_t clusters = 0;
  /// the number of clusters that were split because two clusters met twice after the growth.
  std::size_t splits = 0;
  /// the number of merges of two clusters that were needed to reach the requested number.
  std::size_t merges = 0;
  /// the number of rounds of the minimization.
  std::size_t rounds = 0;
  /// the number of faces that changed cluster.
  std::size_t moves = 0;
  /// the number of edges between two clusters whose energies were compared.
  std::size_t tests = 0;
  /// with parameter `paper_rules`, the number of tests at which a move would have lowered the energy, but did not pass
  /// the paper's check of boundary-edge counts. A move counts at each test, so it often counts several times.
  std::size_t refused_by_boundary_counts = 0;
  /// the number of tests at which a move would have lowered the energy, but after which a cluster would not be a disc, or the
  /// dual no surface. With parameter `paper_rules`, only moves that pass the check are counted.
  std::size_t refused_by_guarantee = 0;
  /// the energy of the clustering before the minimization, formula (8) of the paper: the sum of the weighted moments of the clusters.
  double initial_energy = 0;
  /// the energy of the clustering after the minimization, formula (8) of the paper: the sum of the weighted moments of the clusters.
  double final_energy = 0;
  /// whether the relative gain of the last round was at most `convergence_tolerance`, or the round changed nothing.
  bool converged = false;
  /// the number of connected components whose faces were subdivided internally, either because whole faces could not form the
  /// number of clusters, or because of parameter `subdivide_input`.
  std::size_t subdivided_components = 0;
  /// the number of clusters that were relocated to regions of large distance (parameter `error_feedback`).
  std::size_t exchanged_vertices = 0;
  /// the number of pairs of triangles that intersected after the placement of the vertices, but not in the input. This
  /// number and the next four members are 0, or empty, if parameter `repair_output` is `false`.
  std::size_t intersections_found = 0;
  /// the number of intersecting pairs after the repair; with several clusterings, the smallest number.
  std::size_t intersections_left = 0;
  /// the intersecting pairs after the repair, as numbers of faces of the output in the order of their creation.
  std::vector<std::pair<std::size_t, std::size_t> > intersecting_faces;
  /// the number of triangles that were degenerate after the placement, or faced away from the surface that they approximate,
  /// if that surface has an area.
  std::size_t reversals_found = 0;
  /// the number of degenerate or reversed triangles after the repair.
  std::size_t reversals_left = 0;
  /// the faces of the output with an angle of less than 10 degrees, numbered in the order of their creation. `Fitted_placement`
  /// leaves small angles where borders, features, close sheets or sharp parts of the input require them.
  std::vector<std::size_t> narrow_faces;
  /// the number of clusterings. It is one, or larger if triangles still intersected after the repair
  /// (`Mwcvd_clustering::extract_embedded_dual_mesh()`). The other members describe the selected clustering.
  std::size_t clusterings = 1;
  /// the number of feature lines that are kept. A line is closed, or connects two corners.
  std::size_t feature_lines = 0;
  /// the number of feature corners that are kept.
  std::size_t feature_corners = 0;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of one cluster, see `Mwcvd_clustering::cluster_reports()`.
struct Cluster_report
{
  /// the number of faces `f` of the mesh for which `Mwcvd_clustering::cluster(f)` returns the cluster.
  std::size_t faces = 0;
  /// the centroid (7): the mean of the centroids of the faces, weighted by density times area, or unweighted if the faces have no
  /// area. Coordinates are rounded to 43 binary digits relative to the largest one.
  Simple_cartesian<double>::Point_3 centroid = Simple_cartesian<double>::Point_3(0, 0, 0);
  /// the weight in the energy (8); 1 if a `ClusterEnergy` without a weight was chosen.
  double weight = 1;
  /// the energy of the cluster, a summand of `Mwcvd_clustering::energy()`.
  double energy = 0;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of `coarsen_mesh_to_distance()`.
struct Distance_report
{
  /// the number of vertices of the output.
  std::size_t vertices = 0;
  /// whether the bound of the distance is at most the requested distance. If not, the maximum number of vertices ended the search.
  bool is_within_distance = true;
  /// an upper bound of the two-sided Hausdorff distance between the input and the output.
  double distance_bound = 0;
  /// the report of the clustering of which the output is the dual.
  Coarsening_report clustering;
  /// the number of clusterings that were minimized.
  std::size_t clusterings = 0;
  /// the number of times that a distance was bounded.
  std::size_t bounds = 0;
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// Statistics of the coarsening of a distributed mesh. The members of the base class are equal on all ranks. Its numbers of
/// seeds, splits, merges, moves and tests, and its initial energy, describe the clustering of cells. Unless the cells are the
/// faces, all intersecting pairs are counted, also where the input intersects itself, and reversed triangles face away from an
/// approximation of the input.
struct Distributed_report
  : Coarsening_report
{
  /// the number of bytes that this rank has sent to other ranks.
  std::uint64_t bytes_sent = 0;
  /// the number of bytes that this rank has written to its scratch file.
  std::uint64_t bytes_of_scratch = 0;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_COARSENING_REPORT_H
