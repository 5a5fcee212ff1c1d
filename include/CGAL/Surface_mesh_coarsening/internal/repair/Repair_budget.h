// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_BUDGET_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_BUDGET_H

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Bounds the work of all repairs of one output in proportion to the input, and the work of each repair by a constant. The unit is
// one exact test of two triangles, and steps that take as long. If sheets are too close everywhere, the remaining faults are not
// repaired.
class Repair_budget
{
public:
  // If several outputs are repaired, each receives one of so many parts.
  explicit Repair_budget(std::size_t faces, std::size_t parts = 1)
    : all_(tests_per_face * (std::max)(faces, min_faces) / parts), left_(all_), left_of_repair_(all_)
  {}

  // Returns the same budget as if nothing were spent.
  Repair_budget unspent() const
  {
    Repair_budget whole(*this);
    whole.left_ = whole.left_of_repair_ = all_;
    return whole;
  }

  void begin_repair() { left_of_repair_ = (std::min)(left_, max_tests_of_repair); }

  void spend(std::size_t tests)
  {
    left_ -= (std::min)(tests, left_);
    left_of_repair_ -= (std::min)(tests, left_of_repair_);
  }

  bool is_spent() const { return left_ == 0; }
  bool is_spent_for_repair() const { return left_of_repair_ == 0; }

private:
  // With half of these tests, intersections remain on bipyramids and uneven grids that are repaired otherwise. Meshes with fewer
  // faces than the second number have the budget of that number.
  static constexpr std::size_t tests_per_face = 3000, min_faces = 2000;
  static constexpr std::size_t max_tests_of_repair = 16000000; // one or two seconds

  std::size_t all_, left_, left_of_repair_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_REPAIR_BUDGET_H
