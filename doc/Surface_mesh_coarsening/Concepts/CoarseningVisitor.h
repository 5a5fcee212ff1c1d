// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgSurfaceMeshCoarseningConcepts
/// \cgalConcept
///
/// The concept `CoarseningVisitor` describes objects that are told how far a coarsening has come, and that may cancel it.
///
/// A visitor is passed with named parameter `visitor`, as a copy or, in `std::ref()`, itself. All calls come from the thread
/// that called the library. The library reads no clock: a visitor that wants to know how long a stage takes reads one when
/// the stage begins and when it ends. Stages come again where the mesh is reclustered because triangles intersect
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

  /// is called when `stage` has ended. It is not called for a stage that ended with an exception.
  void stage_ends(CGAL::Surface_mesh_coarsening::Coarsening_stage stage);

  /// is called after each round of the minimization, or after some that are made together, where there are many clusters: `round` is the
  /// number of rounds so far, `moves` the number of faces that changed cluster since the last call, and `energy` the energy (8).
  void round_done(std::size_t round, std::size_t moves, double energy);

  /// is called within the stages `PLACEMENT`, `FEEDBACK` and `REPAIR`, where these take several steps: `done` of at most `total`
  /// rounds of the fit, rounds of the feedback, or faults to be repaired are done.
  void step_done(CGAL::Surface_mesh_coarsening::Coarsening_stage stage, std::size_t done, std::size_t total);

  /// is asked at the beginning and at the end of each stage and after each round of the minimization, and possibly at other
  /// times. If it returns `false`, `CGAL::Surface_mesh_coarsening::Coarsening_cancelled` is thrown.
  bool go_further();
};
