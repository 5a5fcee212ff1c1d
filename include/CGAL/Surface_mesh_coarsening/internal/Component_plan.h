// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H

#include <CGAL/Surface_mesh_coarsening/internal/Flat_mesh.h>

#include <limits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// How a connected component is brought to its number of clusters.
//
// The first way is the paper's: seeds of the largest level that gives enough, growth, and merging, three clusters at a
// time. It may end too high, where topology leaves little freedom. Then clusters are merged two by two, in an order that
// does not depend on the number wanted: whatever number is reached from seeds of some level, all between it and where
// merging began are reached from there, too. This is tried from lower and lower levels, in the end from pieces of faces.
// If nothing comes down to the number wanted, the best of the tries gives the nearest number that works.
class Component_plan
{
public:
  // The level of the seeds; NONE: the largest that gives as many as are wanted.
  Index level() const { return level_; }
  bool two_by_two() const { return two_by_two_; }
  bool from_pieces() const { return from_pieces_; }

  // The number of clusters that the best try has come down to.
  std::size_t nearest() const { return nearest_; }
  bool has_nearest() const { return nearest_ != (std::numeric_limits<std::size_t>::max)(); }

  // Takes note of a try that failed: with `seeds` seeds of level `level`, it ended with `reached` clusters instead of
  // `wanted`, or without any, reached = 0, because the faces are too few. Returns whether there is something else to
  // try; if not, the plan is the one that reaches nearest() from now on.
  bool revise(Index level, std::size_t seeds, std::size_t reached, std::size_t wanted)
  {
    if (two_by_two_ && reached > wanted && reached < nearest_) {
      nearest_ = reached;
      nearest_level_ = level_;
      nearest_from_pieces_ = from_pieces_;
    }
    // Going on to ever more clusters would take long on large components, and lead to no better end.
    const bool many = seeds > 64 * wanted + 1000 && has_nearest();
    if (from_pieces_ || many) {
      level_ = nearest_level_;
      from_pieces_ = nearest_from_pieces_;
      return false;
    }
    if (!two_by_two_)
      level_ = level;
    else if (level_ > 0)
      level_ = level_ * 2 / 3;
    else
      from_pieces_ = true;
    if (reached == 0)
      from_pieces_ = true;
    two_by_two_ = true;
    return true;
  }

private:
  Index level_ = NONE, nearest_level_ = NONE;
  bool two_by_two_ = false, from_pieces_ = false, nearest_from_pieces_ = false;
  std::size_t nearest_ = (std::numeric_limits<std::size_t>::max)();
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H
