// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLACEMENT_MODEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLACEMENT_MODEL_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/fit_vertices.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A placement with its type erased, so that the stages of the pipeline are compiled once for all placements. Refers to the
// original placement.
struct Placement_model
{
  // Exactly one of these two is set: `local` computes a position for each cluster; `global` computes all positions together, and
  // may flip edges of the triangles.
  std::function<Vector(const Clustered_faces&, std::size_t)> local;
  std::function<void(const Clustered_faces&, const Border_arcs&, std::vector<Triangle>&, std::vector<Vector>&)> global;
  // The same with vertex exchange between regions.
  std::function<void(const Clustered_faces&, const Border_arcs&, std::vector<Triangle>&, std::vector<Vector>&,
                     const Vertex_relocation&)>
    exchanging;
  // Set for some global placements: a position for each cluster, and the placement that begins with these positions.
  std::function<Vector(const Clustered_faces&, std::size_t)> start;
  std::function<void(const Clustered_faces&, const Border_arcs&, std::vector<Triangle>&, std::vector<Vector>&)> from_start;
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

template <class Placement, class = void>
constexpr bool exchanges_vertices = false;
template <class Placement>
constexpr bool exchanges_vertices<
  Placement, std::void_t<decltype(std::declval<const Placement&>().place_and_exchange(
               std::declval<const Clustered_faces&>(), std::declval<const Border_arcs&>(),
               std::declval<std::vector<Triangle>&>(), std::declval<std::vector<Vector>&>(),
               std::declval<const Vertex_relocation&>()))> > = true;

template <class Placement, class = void>
constexpr bool has_start = false;
template <class Placement>
constexpr bool has_start<Placement, std::void_t<decltype(std::declval<const Placement&>().place_from(
                                      std::declval<const Clustered_faces&>(), std::declval<const Border_arcs&>(),
                                      std::declval<std::vector<Triangle>&>(), std::declval<std::vector<Vector>&>()))> > = true;

template <class Placement>
Placement_model placement_model(const Placement& placement)
{
  Placement_model model;
  if constexpr (is_local_placement<Placement>)
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
  if constexpr (exchanges_vertices<Placement>)
    model.exchanging = [&placement](const Clustered_faces& clusters, const Border_arcs& border, std::vector<Triangle>& triangles,
                                    std::vector<Vector>& positions, const Vertex_relocation& relocation) {
      placement.place_and_exchange(clusters, border, triangles, positions, relocation);
    };
  if constexpr (has_start<Placement>) {
    model.start = [](const Clustered_faces& clusters, std::size_t cluster) -> Vector {
      return to_vector(typename Placement::Start()(Clustered_surface(clusters), cluster));
    };
    model.from_start = [&placement](const Clustered_faces& clusters, const Border_arcs& border,
                                    std::vector<Triangle>& triangles, std::vector<Vector>& positions) {
      placement.place_from(clusters, border, triangles, positions);
    };
  }
  model.may_run_in_parallel = may_run_in_parallel<Placement>;
  model.is_at_input_vertices = is_at_input_vertices<Placement>;
  return model;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_PLACEMENT_MODEL_H
