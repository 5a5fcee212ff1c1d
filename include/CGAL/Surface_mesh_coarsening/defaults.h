// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_DEFAULTS_H
#define CGAL_SURFACE_MESH_COARSENING_DEFAULTS_H

#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The default values in the library, the tool and the viewer. The default weight is `Weighted_area_weight`, and the default
/// placement is `Fitted_placement`.
struct Coarsening_defaults
{
  //! [defaults]
  /// of parameter `maximum_density`
  static constexpr double maximum_density = 10;
  /// of parameter `error_feedback`
  static constexpr std::size_t error_feedback = 12;
  /// of parameter `number_of_iterations`: the tolerance ends the minimization much earlier
  static constexpr std::size_t number_of_iterations = 1000;
  /// of parameter `convergence_tolerance`: more rounds would lower the energy by about one percent, without an effect on
  /// distances or angles
  static constexpr double convergence_tolerance = 1e-3;
  /// of parameter `feature_angle`: the angle of an edge does not make it a feature
  static constexpr double feature_angle = 180;
  /// of the constructor of `Fitted_placement`, in degrees
  static constexpr double mean_angle = 40;
  //! [defaults]
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_DEFAULTS_H
