// SPDX-License-Identifier: GPL-3.0-or-later

#include "repairing.h"

#include "check/soup_fault.h"
#include "repair/fill_holes.h"
#include "repair/repair.h"
#include "Signal_check.h"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_python {
namespace {

using coarsen_mesh_tool::Hole_state;
typedef std::vector<coarsen_mesh_tool::Repair_step> Steps;

std::pair<Soup, Steps> repaired(Soup soup)
{
  return run_interruptibly<std::pair<Soup, Steps> >([soup = std::move(soup)]() mutable {
    Steps steps = coarsen_mesh_tool::repair(soup);
    return std::make_pair(std::move(soup), std::move(steps));
  });
}

void fill(Soup& soup, double hole_length, py::dict& report)
{
  Mesh mesh = checked_mesh(soup);
  coarsen_mesh_tool::Hole_filling filling;
  {
    const py::gil_scoped_release unlock;
    Signal_check check;
    filling = coarsen_mesh_tool::fill_holes(mesh, hole_length, std::ref(check));
  }
  report["filled holes"] = filling.number(Hole_state::FILLED);
  report["holes left"] = filling.holes.size() - filling.number(Hole_state::FILLED);
  soup = to_soup(mesh);
}

} // namespace

py::tuple repair_arrays(const Number_array& points, const Index_array& sizes, const Index_array& indices, double hole_length)
{
  auto [soup, steps] = repaired(to_soup({points, sizes, indices}));
  py::dict report;
  for (const coarsen_mesh_tool::Repair_step& step : steps) {
    const py::str action(step.action);
    report[action] = step.count + (report.contains(action) ? report[action].cast<std::size_t>() : 0);
  }
  if (hole_length > 0)
    fill(soup, hole_length, report);
  else if (const auto fault = soup_fault(soup))
    throw std::invalid_argument("the mesh is not an oriented 2-manifold even after the repair: " + *fault);
  const Mesh_arrays arrays = to_arrays(soup);
  return py::make_tuple(arrays.points, arrays.sizes, arrays.indices, report);
}

} // namespace coarsening_python
