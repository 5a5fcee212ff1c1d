// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_INITIAL_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_INITIAL_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/Component_plan.h>
#include <CGAL/Surface_mesh_coarsening/internal/merge_clusters.h>
#include <CGAL/Surface_mesh_coarsening/internal/seed_walk.h>
#include <CGAL/Surface_mesh_coarsening/internal/share_out_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/split_clusters.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Seeds and growth: a clustering with the number of clusters asked for, all of them closed discs, whose dual is a
// simplicial surface of the topology of the mesh.
//
// Clusters that meet twice after growth are split, and clusters are merged down to the number wanted; Component_plan says
// how, component by component. Components of fewer faces than clusters are cut into pieces.
class Initial_clustering
{
public:
  Initial_clustering(const Clustering_input& input, Coarsening_report& report)
    : uncut_input_(&input), input_(&input), report_(report)
  {
    const std::vector<Component>& components = input.mesh.components;
    for (const Component& c : components)
      least_.push_back(fewest_vertices(c));
    bound_by_vertices();
    share_.assign(components.size(), 0);
    for (std::size_t f = 0; f < input.mesh.number_of_faces(); ++f)
      share_[input.mesh.component[f]] += input.mass(Index(f));
    cut_.assign(components.size(), false);
    plan_.resize(components.size());
  }

  // Cuts all faces into pieces, as often as it takes to have `faces` of them.
  void subdivide(std::size_t faces)
  {
    while (uncut_input_->mesh.number_of_faces() < faces) {
      if (!subdivided_input_)
        subdivided_input_ = *uncut_input_;
      subdivided_input_->subdivide(std::vector<bool>(cut_.size(), true));
      input_ = uncut_input_ = &*subdivided_input_;
    }
    bound_by_vertices();
  }

  // Finds seeds, as many as give `number` clusters or more. Throws if that number cannot be had.
  void seed(std::size_t number)
  {
    number_ = number;
    if (number_ > sum(most_))
      throw Unreachable_number_of_vertices(std::to_string(number_) + " vertices were asked for, but the input has only " +
                                             std::to_string(sum(most_)), sum(most_));
    share_out_number();
    seed_components();
  }

  // Takes all seeds of one level.
  void seed_from_level(Index level)
  {
    seeds_.clear();
    Seed_walk walk(input_->mesh);
    walk.run(all_faces(), level, seeds_);
    wanted_.assign(input_->mesh.components.size(), 0);
    for (const Index f : seeds_)
      ++wanted_[input_->mesh.component[f]];
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      wanted_[i] = (std::min)((std::max)(wanted_[i], least_[i]), most_[i]);
    number_ = sum(wanted_);
    may_exceed_number_ = true;
    report_.level = level;
    report_.seeds = seeds_.size();
    level_used_.assign(wanted_.size(), level);
    seeds_used_ = wanted_;
    if (cut_where_needed())
      seed_components();
  }

  const std::vector<Index>& seeds() const { return seeds_; }

  // The faces that the seeds and the clusters are made of: those given, or pieces of them.
  const Clustering_input& input() const { return *input_; }

  // Grows the clusters from the seeds and brings them to the number asked for.
  Cluster_labels grow()
  {
    for (;;) {
      Cluster_labels labels(input_->mesh);
      const std::vector<Failure> failed = try_to_grow(labels);
      if (failed.empty())
        return labels;
      for (const Failure& failure : failed)
        revise_plan(failure);
      if (finding_least_)
        wanted_ = least_;
      else
        share_out_number();
      seed_components();
    }
  }

private:
  struct Failure
  {
    Index component;
    std::size_t reached; // clusters; 0 if the faces are too few
  };

  // A component that is out of plans has its minimum raised.
  void revise_plan(const Failure& failure)
  {
    const Index i = failure.component;
    if (plan_[i].revise(level_used_[i], seeds_used_[i], failure.reached, wanted_[i]))
      return;
    if (!plan_[i].has_nearest())
      throw Invalid_input("component " + std::to_string(i) + " of the input cannot be clustered");
    least_[i] = plan_[i].nearest();
    most_[i] = (std::max)(most_[i], least_[i]);
  }

  static std::size_t sum(const std::vector<std::size_t>& v)
  {
    return std::accumulate(v.begin(), v.end(), std::size_t(0));
  }

  void share_out_number()
  {
    if (may_exceed_number_)
      number_ = (std::max)(number_, sum(least_));
    if (number_ < sum(least_))
      throw_too_small();
    wanted_ = share_out(number_, share_, least_, most_);
  }

  // The smallest number that works is known once every component has been brought down to its own.
  [[noreturn]] void throw_too_small()
  {
    if (!finding_least_ && may_look_further_down_) {
      finding_least_ = true;
      wanted_ = least_;
      seed_components();
      grow();
    }
    std::size_t least = sum(least_);
    while (may_look_further_down_ && works(least - 1))
      --least;
    throw Unreachable_number_of_vertices(
      std::to_string(number_) + (number_ == 1 ? " vertex was" : " vertices were") + " asked for, but the input, with " +
        std::to_string(least_.size()) + " connected components, needs " + std::to_string(least), least);
  }

  // Whether a call for `number` clusters would succeed, which may be by another way than the one taken here.
  bool works(std::size_t number) const
  {
    if (number <= number_)
      return false;
    Coarsening_report report;
    Initial_clustering other(*uncut_input_, report);
    other.may_look_further_down_ = false;
    try {
      other.seed(number);
      other.grow();
    } catch (const Unreachable_number_of_vertices&) {
      return false;
    }
    return true;
  }

  std::vector<Index> all_faces() const
  {
    std::vector<Index> faces(input_->mesh.number_of_faces());
    std::iota(faces.begin(), faces.end(), Index(0));
    return faces;
  }

  // Returns whether the faces have changed.
  bool cut_where_needed()
  {
    std::vector<bool> chosen(wanted_.size(), false);
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      chosen[i] = plan_[i].from_pieces() || uncut_input_->mesh.components[i].faces < wanted_[i];
    if (chosen == cut_)
      return false;
    cut_.swap(chosen);
    report_.subdivided_components = std::count(cut_.begin(), cut_.end(), true);
    input_ = uncut_input_;
    if (report_.subdivided_components > 0) {
      cut_input_ = *uncut_input_;
      cut_input_->subdivide(cut_);
      input_ = &*cut_input_;
    }
    return true;
  }

  void bound_by_vertices()
  {
    most_.clear();
    for (std::size_t i = 0; i < least_.size(); ++i)
      most_.push_back((std::max)(uncut_input_->mesh.components[i].vertices, least_[i]));
  }

  void seed_components()
  {
    cut_where_needed();
    // The faces component by component, in their order.
    const Flat_mesh& m = input_->mesh;
    std::vector<std::size_t> end(m.components.size() + 1, 0);
    for (std::size_t i = 0; i + 1 < end.size(); ++i)
      end[i + 1] = end[i] + m.components[i].faces;
    std::vector<Index> faces(m.number_of_faces());
    for (std::size_t f = 0; f < m.number_of_faces(); ++f)
      faces[end[m.component[f]]++] = Index(f);

    Seed_walk walk(m);
    seeds_.clear();
    report_.level = 0;
    level_used_.assign(wanted_.size(), 0);
    seeds_used_.assign(wanted_.size(), 0);
    const Index* first = faces.data();
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const Face_range range{first, faces.data() + end[i]};
      const std::size_t before = seeds_.size();
      if (plan_[i].level() != NONE)
        walk.run(range, level_used_[i] = plan_[i].level(), seeds_);
      else {
        level_used_[i] = seed_component(walk, range, wanted_[i]);
        if (plan_[i].two_by_two()) {
          level_used_[i] = Component_plan::rung(level_used_[i]);
          seeds_.resize(before);
          walk.forget(range);
          walk.run(range, level_used_[i], seeds_);
        }
      }
      seeds_used_[i] = seeds_.size() - before;
      report_.level = (std::max)(report_.level, std::size_t(level_used_[i]));
      first = range.last;
    }
    report_.seeds = seeds_.size();
  }

  struct Face_range
  {
    const Index *first, *last;
    const Index* begin() const { return first; }
    const Index* end() const { return last; }
  };

  // Takes the seeds of the largest level, near the one expected, that gives enough of them. Returns the level.
  Index seed_component(Seed_walk& walk, const Face_range& faces, std::size_t wanted)
  {
    // On a regular mesh the neighborhood of level k has 1 + 3 k (k + 1) / 2 faces, and some three quarters of all
    // faces lie in one.
    const double faces_each = 0.75 * double(faces.last - faces.first) / double(wanted);
    Index level = faces_each <= 1 ? 0 : Index(std::sqrt((faces_each - 1) / 1.5 + 0.25) + 0.5);
    std::vector<Index> found;
    const auto seeds_at = [&](Index k) {
      walk.forget(faces);
      found.clear();
      walk.run(faces, k, found);
      return found.size();
    };
    std::vector<Index> best;
    while (seeds_at(level) >= wanted && found.size() > 1) {
      best.swap(found);
      ++level;
    }
    if (best.empty()) {
      while (found.size() < wanted && level > 0)
        seeds_at(--level);
      best.swap(found);
    } else {
      --level;
    }
    seeds_.insert(seeds_.end(), best.begin(), best.end());
    return level;
  }

  // Returns the components where it did not come to the number wanted.
  std::vector<Failure> try_to_grow(Cluster_labels& labels)
  {
    Cluster_growth growth(labels);
    Index clusters = 0;
    for (const Index f : seeds_)
      growth.plant(f, clusters++);
    growth.run();
    clusters = growth.cover(all_faces(), clusters);

    std::vector<Failure> failed;
    Cluster_splitting splitting(labels, clusters);
    report_.splits = splitting.run();
    for (const Index i : splitting.fruitless_components())
      failed.push_back({i, 0});
    if (!failed.empty())
      return failed;
    labels.recount();

    std::vector<bool> two_by_two;
    for (const Component_plan& plan : plan_)
      two_by_two.push_back(plan.two_by_two());
    Cluster_merging merging(labels, splitting.number_of_clusters(), input_->area, wanted_, two_by_two);
    report_.merges = merging.run();
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      if (merging.number_of_clusters(i) != wanted_[i])
        failed.push_back({Index(i), merging.number_of_clusters(i)});
    if (failed.empty())
      seeds_ = merging.compact();
    report_.clusters = seeds_.size();
    return failed;
  }

  const Clustering_input* uncut_input_; // the one given, or a subdivision of it
  const Clustering_input* input_;       // the same, or with components cut into pieces
  std::optional<Clustering_input> subdivided_input_, cut_input_;
  Coarsening_report& report_;
  std::size_t number_ = 0;
  bool may_exceed_number_ = false; // where topology needs more
  bool finding_least_ = false;
  bool may_look_further_down_ = true;
  std::vector<std::size_t> least_, most_, wanted_; // clusters per component
  std::vector<double> share_;                      // mass per component
  std::vector<Component_plan> plan_;
  std::vector<bool> cut_;                          // components that are cut into pieces
  std::vector<Index> level_used_;                  // per component, of its seeds
  std::vector<std::size_t> seeds_used_;
  std::vector<Index> seeds_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_INITIAL_CLUSTERING_H
