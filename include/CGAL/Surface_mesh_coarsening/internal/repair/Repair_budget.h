// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_BUDGET_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_BUDGET_H

#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The numbers of faults before and after a repair.
struct Repair_counts
{
  std::size_t intersections_found = 0, reversals_found = 0, reversals_left = 0;
  std::vector<std::pair<Index, Index> > intersections_left; // pairs of triangles
};

// Bounds the work of all repairs of one output in proportion to the input, and the work of each repair. The unit is a test of two
// triangles that needs no exact numbers, and steps that take as long. If sheets are too close everywhere, the remaining faults
// are not repaired.
class Repair_budget
{
public:
  // If several outputs are repaired, each receives one of so many parts.
  explicit Repair_budget(std::size_t faces, std::size_t parts = 1)
    : all_((tests_per_face * faces + tests_of_output) / parts), left_(all_)
  {}

  // A repair takes at most three quarters of what is left, so that other clusterings can be tried, too.
  void begin_repair()
  {
    left_of_repair_ = (std::min)(left_ - left_ / 4, max_tests_of_repair);
    left_for_input_ = all_ / 3;
  }

  void spend(std::size_t tests)
  {
    left_ -= (std::min)(tests, left_);
    left_of_repair_ -= (std::min)(tests, left_of_repair_);
  }

  // The same for tests whether the input intersects itself, which have a budget of their own in each repair: without them,
  // intersections of the input would be reported as faults.
  void spend_on_input(std::size_t tests)
  {
    left_ -= (std::min)(tests, left_);
    left_for_input_ -= (std::min)(tests, left_for_input_);
  }

  bool is_spent() const { return left_ == 0; }
  bool is_spent_for_repair() const { return left_of_repair_ == 0 || is_spent(); }
  bool is_spent_for_input() const { return left_for_input_ == 0; }

private:
  // With 2,500 tests a face, six thin plates keep 32 pairs of intersecting triangles in 30 runs; with these, 12.
  static constexpr std::size_t tests_per_face = 3000, tests_of_output = 250000;
  static constexpr std::size_t max_tests_of_repair = 16000000; // one or two seconds

  std::size_t all_, left_, left_of_repair_ = 0, left_for_input_ = 0;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_BUDGET_H
