// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_PROPOSALS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_PROPOSALS_H

#include <CGAL/Surface_mesh_coarsening/Border_arcs.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/rounding.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

struct Vertex_move
{
  Index vertex;
  Vector to;
};

// A change of a placement: moves of vertices, or the flip of an edge.
struct Placement_change
{
  std::vector<Vertex_move> moves;
  Index flipped = NONE;
  int corner = 0;
};

// Returns the square root of the area of the triangles around a vertex.
inline double size_around(const Flippable_triangulation& coarse, const std::vector<Vector>& positions, Index v)
{
  double area = 0;
  for (const Index t : coarse.around(v)) {
    const Vector n = normal_of(positions, coarse.triangles()[t]);
    area += 0.5 * std::sqrt(dot(n, n));
  }
  return std::sqrt(area);
}

// Proposes the changes that a repair tries at a few triangles.
class Repair_proposals
{
public:
  // `at_input_vertices`: whether vertices may move only to input vertices of their clusters.
  Repair_proposals(const Clustered_faces& surface, const Border_arcs& border, const Flippable_triangulation& coarse,
                   const Input_oracle& reference, const std::vector<Vector>& positions, bool at_input_vertices)
    : surface_(surface), border_(border), coarse_(coarse), reference_(reference), positions_(positions),
      at_input_vertices_(at_input_vertices)
  {}

  // `vertices` are the corners of the triangles `faulty`.
  std::vector<Placement_change> at(const std::vector<Index>& faulty, const std::vector<Index>& vertices) const
  {
    std::vector<Placement_change> changes;
    for (const Index v : vertices)
      for (const Vector& to : border_.is_on_border(v) ? places_on_line(v) : places_for(v))
        changes.push_back({{{v, to}}, NONE, 0});
    for (const Index t : faulty)
      for (int i = 0; i < 3; ++i) {
        const Index u = coarse_.across(t, i);
        if (u != NONE && coarse_.may_flip(t, i, u))
          changes.push_back({{}, t, i});
      }
    if (at_input_vertices_)
      return changes;
    add_common_moves(faulty, vertices, changes);
    for (Placement_change& change : changes)
      for (Vertex_move& move : change.moves)
        move.to = surface_.within_bounds(move.vertex, without_last_digits(move.to));
    return changes;
  }

private:
  static constexpr std::size_t max_input_vertices = 24;

  // Returns possible positions of a vertex.
  std::vector<Vector> places_for(Index v) const
  {
    std::vector<Vector> places;
    if (at_input_vertices_) {
      for (const Index f : surface_.faces(v))
        for (const Index w : surface_.vertices(f))
          if (!surface_.is_on_cluster_boundary(w) &&
              std::find(places.begin(), places.end(), surface_.point(w)) == places.end() && places.size() < max_input_vertices)
            places.push_back(surface_.point(w));
      return places;
    }
    const Vector from = positions_[v], centroid = surface_.cluster_centroid(v),
                 middle = coarse_.mean_of_neighbors(v, positions_);
    for (const double part : {0.03, 0.1, 0.3, 0.6, 1.}) {
      places.push_back(from + part * (centroid - from));
      places.push_back(from + part * (middle - from));
    }
    for (const double part : {0.01, 0.03, 0.1, 0.25}) {
      const Vector out = part * size_around(coarse_, positions_, v) * reference_.normal(v);
      places.push_back(from + out);
      places.push_back(from - out);
    }
    return places;
  }

  // Returns positions towards the middle of the vertex's part of a feature line, where it was before the fit. Vertices on borders
  // that are no features are still there.
  std::vector<Vector> places_on_line(Index v) const
  {
    std::vector<Vector> places;
    const Vector from = positions_[v], middle = border_.place(v);
    if (!at_input_vertices_ && from != middle)
      for (const double part : {0.1, 0.3, 0.6, 1.})
        places.push_back(from + part * (middle - from));
    return places;
  }

  // Adds changes that move several vertices: all vertices towards their centroids; the vertices of two triangles apart or towards
  // each other, each along the normals of its own surface.
  void add_common_moves(const std::vector<Index>& faulty, const std::vector<Index>& vertices,
                        std::vector<Placement_change>& changes) const
  {
    for (const double part : {0.1, 0.3, 0.6, 1.}) {
      Placement_change change;
      for (const Index v : vertices)
        if (!border_.is_on_border(v))
          change.moves.push_back({v, positions_[v] + part * (surface_.cluster_centroid(v) - positions_[v])});
      changes.push_back(change);
    }
    for (const double part : {0.01, -0.01, 0.03, -0.03, 0.1, -0.1, 0.25, -0.25})
      for (std::size_t chosen = 0; chosen <= faulty.size(); ++chosen) { // one of the triangles, or all
        Placement_change change;
        for (const Index v : vertices)
          if (!border_.is_on_border(v) && (chosen == faulty.size() || coarse_.corner(faulty[chosen], v) >= 0))
            change.moves.push_back({v, positions_[v] + part * size_around(coarse_, positions_, v) * reference_.normal(v)});
        changes.push_back(change);
      }
  }

  const Clustered_faces& surface_;
  const Border_arcs& border_;
  const Flippable_triangulation& coarse_;
  const Input_oracle& reference_;
  const std::vector<Vector>& positions_;
  const bool at_input_vertices_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_PROPOSALS_H
