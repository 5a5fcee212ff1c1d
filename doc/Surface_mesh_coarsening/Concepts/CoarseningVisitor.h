// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `CoarseningVisitor` describes objects that are notified of the progress of a coarsening and may cancel it.
///
/// A visitor is passed with named parameter `visitor`. It is copied, unless it is passed in `std::ref()`. All calls come from
/// the thread that called the library. The library reads no clock: to measure the time of a stage, a visitor reads a clock in
/// `stage_begins()` and in `stage_ends()`. Stages are repeated if the mesh is reclustered because triangles intersect
/// (`Mwcvd_clustering::extract_embedded_dual_mesh()`).
///
/// \cgalRefines{`CopyConstructible`, unless it is passed in `std::ref()`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`CGAL::Surface_mesh_coarsening::Coarsening_visitor_base`}
/// \cgalHasModelsEnd
class CoarseningVisitor
{
public:
  /// is called when `stage` begins.
  void stage_begins(CGAL::Surface_mesh_coarsening::Coarsening_stage stage);

  /// is called when `stage` has ended, but not if it ended with an exception.
  void stage_ends(CGAL::Surface_mesh_coarsening::Coarsening_stage stage);

  /// is called after each round of the minimization; if there are many clusters, after several rounds that are run together.
  /// `round` is the number of rounds so far, `moves` the number of faces that changed cluster since the last call, `energy` the
  /// energy (8).
  void round_done(std::size_t round, std::size_t moves, double energy);

  /// is called within the stages `PLACEMENT`, `FEEDBACK` and `REPAIR`, if they take several steps. `done` of at most `total`
  /// steps are completed. A step is a round of the fit, a round of the feedback, or the repair of a fault.
  void step_done(CGAL::Surface_mesh_coarsening::Coarsening_stage stage, std::size_t done, std::size_t total);

  /// is called at the beginning and at the end of each stage, after each round of the minimization, and possibly at other
  /// times. If it returns `false`, `CGAL::Surface_mesh_coarsening::Coarsening_cancelled` is thrown.
  bool go_further();
};
