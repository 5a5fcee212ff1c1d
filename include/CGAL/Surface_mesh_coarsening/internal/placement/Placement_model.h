// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLACEMENT_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLACEMENT_MODEL_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A placement with its type erased, so that the stages of the pipeline are compiled once for all placements. Refers to the
// original placement.
struct Placement_model
{
  // Exactly one of these is set: `local` computes a position for each cluster; `global` computes all positions together, and may
  // flip edges of the triangles; `fitted` is the choice of a `Fitted_placement`, which can also exchange vertices between regions.
  std::function<Vector(const Clustered_faces&, std::size_t)> local;
  std::function<void(const Clustered_faces&, const Border_arcs&, std::vector<Triangle>&, std::vector<Vector>&)> global;
  std::optional<Fit_choice> fitted;
  bool may_run_in_parallel = false;
  bool is_at_input_vertices = false;
};

template <class Placement>
constexpr bool is_local_placement =
  std::is_invocable_r<Clustered_surface::Point_3, const Placement&, const Clustered_surface&, std::size_t>::value;

// The optional members of the concept `VertexPlacement`.
template <class Placement, class = void>
constexpr bool may_run_in_parallel = false;
template <class Placement>
constexpr bool may_run_in_parallel<Placement, std::void_t<decltype(Placement::may_run_in_parallel)> > =
  Placement::may_run_in_parallel;
template <class Placement, class = void>
constexpr bool is_at_input_vertices = false;
template <class Placement>
constexpr bool is_at_input_vertices<Placement, std::void_t<decltype(Placement::is_at_input_vertices)> > =
  Placement::is_at_input_vertices;

template <class Placement>
constexpr bool is_fitted_placement = std::is_base_of<Fitted_placement, Placement>::value;

template <class Placement>
Placement_model placement_model(const Placement& placement)
{
  Placement_model model;
  if constexpr (is_fitted_placement<Placement>)
    model.fitted = placement.choice();
  else if constexpr (is_local_placement<Placement>)
    model.local = [&placement](const Clustered_faces& clusters, std::size_t cluster) -> Vector {
      return to_vector(placement(Clustered_surface(clusters), cluster));
    };
  else
    model.global = [&placement](const Clustered_faces& clusters, const Border_arcs& border, std::vector<Triangle>& triangles,
                                std::vector<Vector>& positions) {
      std::vector<Clustered_surface::Point_3> points = to_points(positions);
      placement(Clustered_surface(clusters), border, triangles, points);
      positions = to_vectors(points);
    };
  model.may_run_in_parallel = may_run_in_parallel<Placement>;
  model.is_at_input_vertices = is_at_input_vertices<Placement>;
  return model;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLACEMENT_MODEL_H
