// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSENING_VISITOR_BASE_H
#define CGAL_SURFACE_MESH_COARSENING_COARSENING_VISITOR_BASE_H

#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The stages of a coarsening, in order. If the mesh is reclustered, the stages from `SEEDING` on are repeated. `REPAIR` and
/// `FEEDBACK` may also alternate.
enum class Coarsening_stage
{
  PREPARATION,   ///< checks of the input, flat copies, face densities
  SEEDING,       ///< selection of the seeds
  GROWTH,        ///< growth of the clusters, and splits and merges to the requested number
  MINIMIZATION,  ///< rounds of moves that lower the energy
  TRIANGULATION, ///< the triangles of the dual mesh
  PLACEMENT,     ///< vertex placement
  FEEDBACK,      ///< error feedback: relocation of vertices to regions of large distance, or to remaining intersections
  REPAIR         ///< repair of triangles that intersect or are reversed
};

/// \ingroup PkgSurfaceMeshCoarseningRef
/// \cgalModels `CoarseningVisitor`
///
/// A base class for visitors, which does nothing and never cancels.
struct Coarsening_visitor_base
{
  /// is called when `stage` begins.
  void stage_begins(Coarsening_stage /* stage */) {}
  /// is called when `stage` has ended.
  void stage_ends(Coarsening_stage /* stage */) {}
  /// is called after each round of the minimization, or after several rounds that are run together if there are many clusters,
  /// with the number of rounds so far, the number of faces that changed cluster since the last call, and the energy.
  void round_done(std::size_t /* round */, std::size_t /* moves */, double /* energy */) {}
  /// is called within `PLACEMENT`, `FEEDBACK` and `REPAIR`: `done` of at most `total` steps are completed. A step is a round of
  /// the fit, a round of the feedback, or the repair of a fault.
  void step_done(Coarsening_stage /* stage */, std::size_t /* done */, std::size_t /* total */) {}
  /// is called when a stage begins, after each round, before the output changes, and within the stages about every 16,000
  /// elementary steps. The return value `false` ends the coarsening with `Coarsening_cancelled`.
  bool go_further() { return true; }
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_COARSENING_VISITOR_BASE_H
