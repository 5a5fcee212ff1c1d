// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H

#include <CGAL/Surface_mesh_coarsening/internal/Flat_mesh.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// How a connected component is brought to its number of clusters.
//
// The usual way is the paper's: seeds of the largest level that gives twice as many, growth, and merging, three clusters at a
// time. It may end too high where the faces or the topology leave little freedom. Then, and always where fewer clusters are
// wanted than are `always_enough()`, there is a ladder of levels, the same for every number of clusters below that.
//
// From the seeds of a rung clusters are merged two by two, in an order that does not depend on the number wanted, either:
// the rung gives every number from the one where its merging ends up to the one where it begins. The first rung is the
// highest from which merging begins with always_enough(), or the lowest; then come those above it, as long as one begins
// where those before have ended, or higher, then those below, and then the same with the faces cut into pieces, of which any
// clusters can be made. So the numbers that can be had are all those from the smallest that a rung comes to. Of rungs in
// a row that come no lower, as many are tried as keeps the work on large components in proportion to their faces: with
// clusters of many faces all rungs end near the same number.
class Component_plan
{
public:
  // Merging until no two clusters may be merged leads to an irreducible triangulation. Those of closed surfaces of genus g
  // have at most 26 g - 4 vertices (Joret and Wood: Irreducible triangulations are small, 2010); with b border loops their
  // number is linear in g and b, too (Boulch, Colin de Verdiere, Nakamoto: Irreducible triangulations of surfaces with
  // boundary, 2013).
  // Features keep clusters apart; how many more there have to be, they do not tell.
  static std::size_t always_enough(const Component& c)
  {
    return 8 + 26 * c.genus() + 8 * c.loops + 4 * c.feature_clusters;
  }

  // Begins anew for `wanted` clusters.
  void begin(const Component& component, std::size_t wanted)
  {
    aim_at(component, wanted);
    if (has_nearest() && wanted >= nearest_ && wanted < enough_) {
      go_to_nearest();
      return;
    }
    on_ladder_ = wanted < enough_;
    from_pieces_ = component.faces < wanted;
    go_to_first();
  }

  // The same, beginning with the seeds of level `level` in the paper's way.
  void begin(const Component& component, std::size_t wanted, Index level)
  {
    aim_at(component, wanted);
    on_ladder_ = false;
    from_pieces_ = component.faces < wanted;
    go_to_first();
    level_ = level;
  }

  // The level of the seeds; NONE: the largest that gives least_seeds(), or the rung below it.
  Index level() const { return level_; }
  std::size_t least_seeds() const { return on_ladder_ ? (std::max)(wanted_, enough_) : seeds_per_cluster * wanted_; }
  bool is_on_ladder() const { return on_ladder_; }
  bool from_pieces() const { return from_pieces_; }
  std::size_t wanted() const { return wanted_; }

  // Whether merging may begin with `clusters`.
  bool may_begin_with(std::size_t clusters) const { return !is_climbing_ || clusters >= lowest_end_; }

  // The highest rung of the ladder that is not above `level`.
  static Index rung(Index level)
  {
    Index below = 0;
    while (rung_above(below) <= level)
      below = rung_above(below);
    return below;
  }

  // The number of clusters that the best try has come down to.
  std::size_t nearest() const { return nearest_; }
  bool has_nearest() const { return nearest_ != (std::numeric_limits<std::size_t>::max)(); }

  // Takes note of a try that failed: with `seeds` seeds of level `level` it ended with `reached` clusters, or without any,
  // reached = 0, because merging may not begin there. Returns whether there is something else to try; if not, nearest() is
  // the smallest number there is.
  bool revise(Index level, std::size_t seeds, std::size_t reached)
  {
    if (on_ladder_ && reached > wanted_ && reached < nearest_) {
      nearest_ = reached;
      nearest_level_ = level;
      nearest_from_pieces_ = from_pieces_;
    }
    if (!on_ladder_)
      return leave_usual_way(level, reached);
    const bool is_in_vain = reached == 0 || reached >= lowest_end_;
    rungs_in_vain_ = is_in_vain ? rungs_in_vain_ + 1 : 0;
    if (!is_in_vain)
      lowest_end_ = reached;
    if (first_rung_ == NONE) {
      first_rung_ = level;
      lowest_has_failed_ = level == 0 || seeds > most_seeds();
      is_climbing_ = reached > wanted_ && wanted_ < enough_ && seeds > 1;
    } else if (is_climbing_) {
      is_climbing_ = reached != 0 && seeds > 1 && rungs_in_vain_ < most_in_vain();
      if (!is_climbing_)
        rungs_in_vain_ = 0;
    } else {
      lowest_has_failed_ = level == 0 || reached == 0 || seeds > most_seeds() || rungs_in_vain_ >= most_in_vain();
    }
    if (is_climbing_)
      level_ = rung_above(level);
    else if (!lowest_has_failed_)
      level_ = rung((std::min)(level, first_rung_) - 1);
    else
      return take_pieces();
    return true;
  }

private:
  // Seeds are spread by the number of faces alone: with more of them than clusters, merging can even out what they have of the
  // mass.
  static constexpr std::size_t seeds_per_cluster = 2;

  static Index rung_above(Index level)
  {
    if (level < 2)
      return level + 1;
    const bool is_power_of_two = (level & (level - 1)) == 0;
    return is_power_of_two ? level + level / 2 : level / 3 * 4;
  }

  // From ever more seeds merging takes long on large components, and leads to no better end.
  std::size_t most_seeds() const { return 16 * enough_; }

  std::size_t most_in_vain() const
  {
    const std::size_t faces_of_all_rungs = 2000000, faces = from_pieces_ ? 3 * faces_ : faces_;
    return (std::max)(std::size_t(2), faces_of_all_rungs / faces);
  }

  void aim_at(const Component& component, std::size_t wanted)
  {
    enough_ = always_enough(component);
    faces_ = component.faces;
    wanted_ = wanted;
    lowest_end_ = (std::numeric_limits<std::size_t>::max)();
  }

  void go_to_first()
  {
    rungs_in_vain_ = 0;
    level_ = first_rung_ = NONE;
    is_climbing_ = lowest_has_failed_ = false;
  }

  void go_to_nearest()
  {
    go_to_first();
    on_ladder_ = true;
    level_ = nearest_level_;
    from_pieces_ = nearest_from_pieces_;
  }

  bool leave_usual_way(Index level, std::size_t reached)
  {
    if (reached == 0 && !from_pieces_)
      return take_pieces();
    on_ladder_ = true;
    go_to_first();
    if (wanted_ >= enough_)
      level_ = rung(level);
    return true;
  }

  bool take_pieces()
  {
    if (from_pieces_) {
      if (has_nearest())
        go_to_nearest();
      return false;
    }
    from_pieces_ = true;
    on_ladder_ = wanted_ < enough_;
    go_to_first();
    return true;
  }

  std::size_t enough_ = 0, faces_ = 0, wanted_ = 0;
  std::size_t rungs_in_vain_ = 0, lowest_end_ = 0; // of the rungs since begin()
  Index level_ = NONE, first_rung_ = NONE, nearest_level_ = NONE;
  bool on_ladder_ = false, is_climbing_ = false, lowest_has_failed_ = false;
  bool from_pieces_ = false, nearest_from_pieces_ = false;
  std::size_t nearest_ = (std::numeric_limits<std::size_t>::max)();
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_COMPONENT_PLAN_H
