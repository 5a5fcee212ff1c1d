// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TIMING_VISITOR_H
#define COARSENING_SUPPORT_TIMING_VISITOR_H

#include "report/Stage_times.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>

#include <string>

namespace coarsening_support {

inline std::string stage_name(CGAL::Surface_mesh_coarsening::Coarsening_stage stage)
{
  using CGAL::Surface_mesh_coarsening::Coarsening_stage;
  switch (stage) {
  case Coarsening_stage::PREPARATION:
    return "preparation";
  case Coarsening_stage::SEEDING:
    return "seeding";
  case Coarsening_stage::GROWTH:
    return "growth";
  case Coarsening_stage::MINIMIZATION:
    return "minimization";
  case Coarsening_stage::TRIANGULATION:
    return "triangulation";
  case Coarsening_stage::PLACEMENT:
    return "placement";
  case Coarsening_stage::FEEDBACK:
    return "error feedback";
  case Coarsening_stage::REPAIR:
    return "repair of the result";
  }
  return "other";
}

// Measures the stages of a coarsening. The library itself reads no clock.
class Timing_visitor : public CGAL::Surface_mesh_coarsening::Coarsening_visitor_base
{
  Stage_times& times;

public:
  explicit Timing_visitor(Stage_times& times) : times(times) {}

  void stage_begins(CGAL::Surface_mesh_coarsening::Coarsening_stage stage) { times.begin(stage_name(stage)); }
  void stage_ends(CGAL::Surface_mesh_coarsening::Coarsening_stage) { times.end(); }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_TIMING_VISITOR_H
