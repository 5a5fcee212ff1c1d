// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_TOOL_VISITOR_H
#define COARSEN_MESH_TOOL_VISITOR_H

#include "report/Timing_visitor.h"
#include "Interruption.h"
#include "Progress_line.h"

#include <cstddef>
#include <string>

namespace coarsen_mesh_tool {

// Measures the stages, shows the progress, and ends the work when the user interrupts it.
class Tool_visitor : public coarsening_support::Timing_visitor
{
  using Stage = CGAL::Surface_mesh_coarsening::Coarsening_stage;
  Progress_line& progress;

public:
  Tool_visitor(coarsening_support::Stage_times& times, Progress_line& progress)
    : Timing_visitor(times),
      progress(progress)
  {}

  void stage_begins(Stage stage)
  {
    progress.say(coarsening_support::stage_name(stage));
    Timing_visitor::stage_begins(stage);
  }

  bool go_further() { return !Interruption::is_requested(); }

  void round_done(std::size_t round, std::size_t moves, double)
  {
    progress.say("minimization: round " + std::to_string(round) + ", " + std::to_string(moves) + " moves");
  }

  void step_done(Stage stage, std::size_t done, std::size_t total)
  {
    progress.say(coarsening_support::stage_name(stage) + ": " + std::to_string(done) + " of " + std::to_string(total) +
                 (stage == Stage::REPAIR ? " faults repaired" : " rounds"));
  }
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_TOOL_VISITOR_H
