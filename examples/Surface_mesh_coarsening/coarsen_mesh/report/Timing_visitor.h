// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TIMING_VISITOR_H
#define COARSENING_SUPPORT_TIMING_VISITOR_H

#include "report/Stage_times.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>

#include <string>
#include <vector>

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
  }
  return "other";
}

// The names of the stages of the coarsening itself, without reading, checking and writing.
inline const std::vector<std::string>& coarsening_stages()
{
  static const std::vector<std::string> names = {"preparation", "seeding", "growth", "minimization", "triangulation"};
  return names;
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
