// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_DEFAULTS_H
#define CGAL_SURFACE_MESH_COARSENING_DEFAULTS_H

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The numbers that library, tool and viewer take where none are given. The default weight is `Weighted_area_weight`, the
/// default placement `Fitted_placement`.
struct Coarsening_defaults
{
  //! [defaults]
  /// of parameter `maximum_density`
  static constexpr double maximum_density = 10;
  /// of parameter `error_feedback`
  static constexpr std::size_t error_feedback = 7;
  /// of parameter `local_repairs`
  static constexpr std::size_t local_repairs = 5;
  /// of parameter `number_of_iterations`: rounds end by the tolerance long before
  static constexpr std::size_t number_of_iterations = 1000;
  /// of parameter `convergence_tolerance`: more rounds would lower the energy by about a percent, which neither distances nor
  /// angles show
  static constexpr double convergence_tolerance = 1e-3;
  /// of parameter `feature_angle`: no edge is kept for its angle
  static constexpr double feature_angle = 180;
  //! [defaults]
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_DEFAULTS_H
