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
// merging began are reached from there, too. This is tried from two levels of a ladder that is the same for every number
// wanted, then with the faces cut into pieces, from rung to rung down to single pieces. If nothing comes down to the number
// wanted, the best of the tries gives the nearest number that works: asked for, it comes by the same rung.
class Component_plan
{
public:
  // The level of the seeds; NONE: the largest that gives as many as are wanted, or the rung below if two_by_two().
  Index level() const { return level_; }

  // The highest rung of the ladder that is not above `level`.
  static Index rung(Index level)
  {
    Index below = 0;
    for (Index step = 1; step <= level && step != 0; step *= 2) {
      below = step;
      if (step + step / 2 <= level)
        below = step + step / 2;
    }
    return below;
  }

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
      nearest_level_ = level;
      nearest_from_pieces_ = from_pieces_;
    }
    // Going on to ever more clusters would take long on large components, and lead to no better end.
    const bool many = seeds > 16 * wanted + 1000 && has_nearest();
    if (from_pieces_ && (level == 0 || many)) {
      level_ = nearest_level_;
      from_pieces_ = nearest_from_pieces_;
      return false;
    }
    const bool whole_faces_will_not_do = !from_pieces_ && (reached == 0 || ++tries_ > 2 || level == 0);
    if (whole_faces_will_not_do) {
      from_pieces_ = true;
      level_ = NONE;
    } else {
      level_ = two_by_two_ ? rung(level - 1) : rung(level);
    }
    two_by_two_ = true;
    return true;
  }

private:
  Index level_ = NONE, nearest_level_ = NONE;
  int tries_ = 0;
  bool two_by_two_ = false, from_pieces_ = false, nearest_from_pieces_ = false;
  std::size_t nearest_ = (std::numeric_limits<std::size_t>::max)();
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H
