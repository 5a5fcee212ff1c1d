// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTERING_ACCESS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTERING_ACCESS_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What a clustering is made of, for the functions of the package that go on from it.
struct Clustering_access
{
  // The faces of the mesh, without the components that were left out.
  template <class Clustering>
  static const Clustering_input& input(const Clustering& c) { return c.input_.cells ? c.input_.cells->base() : c.input_; }
  // The faces that the clusters are made of: those, or pieces of them.
  template <class Clustering>
  static const auto& working_input(const Clustering& c) { return c.working_input(); }
  // The same for what does not follow the rules for features.
  template <class Clustering>
  static const auto& input_without_features(const Clustering& c)
  {
    if (working_input(c).cells)
      throw Invalid_input("clusters cannot be edited, nor merged to levels, where features are kept");
    return working_input(c);
  }
  template <class Clustering>
  static const auto& labels(const Clustering& c) { return c.labels(); }
  template <class Clustering>
  static auto& mutable_labels(Clustering& c)
  {
    labels(c);
    c.seeding_ = nullptr; // what is done to them by hand could not be done anew
    return *c.labels_;
  }
  template <class Clustering, class Step>
  static void all_or_nothing(Clustering& c, const Step& step) { c.all_or_nothing(step); }
  // Clusters have been added or removed.
  template <class Clustering>
  static void have_changed(Clustering& c, std::size_t clusters)
  {
    c.minimization_.reset();
    c.report_.clusters = clusters;
    c.report_.converged = false;
  }
  template <class Clustering>
  static bool can_recluster(const Clustering& c) { return Clustering::depends_on_densities && bool(c.seeding_); }
  // The densities of the faces of input().
  template <class Clustering>
  static const std::vector<double>& densities(const Clustering& c) { return input(c).density; }
  // Seeds, growth and minimization as before, with other densities.
  template <class Clustering>
  static void recluster(Clustering& c, const std::vector<double>& densities) { c.recluster(densities); }
  template <class Clustering>
  static Coarsening_report& report(const Clustering& c) { return c.report_; }
  template <class Clustering>
  static Execution execution(const Clustering&) { return Clustering::execution_; }
  template <class Clustering>
  static const auto& patches(const Clustering& c) { return c.patches_; }
  template <class Clustering>
  static const auto& numbering(const Clustering& c) { return c.numbering_; }
  template <class Clustering>
  static const auto& frame(const Clustering& c) { return c.frame_; }
  template <class Clustering>
  static const auto& weight(const Clustering& c) { return c.weight_; }
  template <class Clustering>
  static const auto& visitor(const Clustering& c) { return c.visitor_; }
  template <class Clustering>
  static bool repairs(const Clustering& c) { return c.repair_; }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PIPELINE_CLUSTERING_ACCESS_H
