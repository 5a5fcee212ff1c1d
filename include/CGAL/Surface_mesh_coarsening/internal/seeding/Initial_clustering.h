// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_INITIAL_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_INITIAL_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/subdivision.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Component_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Component_plan.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Seeds and growth: computes a clustering with the required number of clusters. All clusters are closed discs, and their dual is
// a simplicial surface with the topology of the mesh.
//
// Apportions the number among the connected components; Component_clustering brings each component to its share. Components are
// subdivided if they have fewer faces than clusters, or if their faces do not suffice.
class Initial_clustering
{
public:
  // `merging`: which clusters are merged first. Cells of vertices are merged by quadrics in any case.
  Initial_clustering(const Featured_input& input, Merging merging, Coarsening_report& report, const Run_context& context)
    : uncut_input_(&input),
      input_(&input),
      merging_(merging),
      report_(report),
      context_(context),
      share_(input.items.mesh.components.size(), 0),
      plan_(share_.size()),
      cut_(share_.size(), false),
      state_(share_.size(), State::NEW),
      seeds_(share_.size()),
      grown_(share_.size())
  {
    for (const Component& c : input.items.mesh.components)
      min_.push_back(fewest_vertices(c));
    bound_by_vertices();
    for (std::size_t f = 0; f < input.items.mesh.number_of_faces(); ++f) {
      context_.poll();
      share_[input.items.mesh.component[f]] += input.items.mass(Index(f));
    }
  }

  // Subdivides all faces until there are at least `faces_each` faces for each cluster. At features, long edges are halved first:
  // clusters of long pieces would be narrow beside lines, and lines would have more vertices than the surface beside them.
  void subdivide(std::size_t clusters, std::size_t faces_each)
  {
    if (clusters > max_clusters_of_subdivided(faces_each))
      throw Invalid_input("faces subdivided for " + std::to_string(clusters) + " vertices are more than can be numbered");
    const std::size_t faces = clusters * faces_each;
    while (uncut_input_->items.mesh.number_of_faces() < faces) {
      std::optional<Featured_input> halved;
      if (uncut_input_->cells)
        halved = uncut_input_->cells->with_long_edges_halved(context_);
      subdivided_input_ = halved ? std::move(*halved) : subdivided(*uncut_input_, std::vector<bool>(cut_.size(), true));
      input_ = uncut_input_ = &*subdivided_input_;
    }
    bound_by_vertices();
  }

  // Returns the smallest and the largest attainable number of clusters.
  std::pair<std::size_t, std::size_t> range()
  {
    find_minimum();
    return {sum(min_), sum(max_)};
  }

  // Returns the smallest number of each component.
  std::vector<std::size_t> minima()
  {
    find_minimum();
    return min_;
  }

  // The largest number of clusters for which faces can be subdivided: the last subdivision has up to four times as many pieces,
  // with four corners each.
  static constexpr std::size_t max_clusters_of_subdivided(std::size_t faces_each) { return NONE / 2 / 16 / faces_each - 1; }

  // Finds enough seeds for `number` clusters. Throws if this number cannot be reached.
  void seed(std::size_t number)
  {
    number_ = number;
    const std::vector<Component>& components = uncut_input_->items.mesh.components;
    const auto may_need_more = [](const Component& c) { return c.max_clusters() < Component_plan::sufficient_clusters(c); };
    if (number_ > sum(max_) && std::any_of(components.begin(), components.end(), may_need_more))
      find_minimum();
    if (number_ > sum(max_))
      throw_unreachable("the input has only ", sum(max_));
    apportion_number();
    find_seeds();
  }

  // Takes all seeds of one level.
  void seed_from_level(Index level)
  {
    may_exceed_number_ = true;
    find_seeds_of(level);
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      wanted_[i] = std::clamp(seeds_[i].faces.size(), min_[i], max_[i]);
      plan_[i].begin(input_->items.mesh.components[i], wanted_[i], level, false);
    }
    number_ = sum(wanted_);
  }

  // Takes the seeds of one level, for `number` clusters after merging. Throws if there are fewer seeds.
  void seed_from_level(Index level, std::size_t number)
  {
    find_seeds_of(level);
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      max_[i] = std::clamp(seeds_[i].faces.size(), min_[i], max_[i]);
    number_ = number;
    if (number_ > sum(max_))
      throw_unreachable("the seeds of level " + std::to_string(level) + " give only ", sum(max_));
    merge_level_ = level;
    apportion_number();
    find_seeds();
  }

  // The faces of the seeds and clusters: the given faces or pieces of them.
  const Featured_input& input() const { return resolved_input_ ? *resolved_input_ : *input_; }

  // Returns whether clusters have been merged by quadrics, except in components that do not permit their number in this way.
  bool is_merged_by_quadrics() const
  {
    return has_vertex_cells(*input_) ||
           std::any_of(plan_.begin(), plan_.end(), [](const Component_plan& p) { return p.merges_by_quadrics(); });
  }

  // Returns the seeds; after growth, a face of each cluster.
  std::vector<Index> seeds() const
  {
    std::vector<Index> all = face_of_cluster_;
    if (all.empty())
      for (const Component_seeds& seeds : seeds_)
        all.insert(all.end(), seeds.faces.begin(), seeds.faces.end());
    return all;
  }

  // Grows the clusters from the seeds and brings them to the required number.
  Cluster_labels grow()
  {
    if (!labels_) { // again
      resolved_input_.reset();
      labels_.emplace(input_->items.mesh);
      std::fill(state_.begin(), state_.end(), State::SEEDED);
    }
    if (!pieces_are_up_to_date())
      find_seeds();
    while (!grow_components()) {
      apportion_number();
      find_seeds();
    }
    number_clusters();
    if (std::any_of(grown_.begin(), grown_.end(), [](const Component_growth& g) { return g.is_pinched; })) {
      std::vector<Index> new_labels;
      resolved_input_ = Featured_input{without_pinches(input_->items, *labels_, new_labels), nullptr};
      labels_.emplace(resolved_input_->items.mesh);
      for (std::size_t f = 0; f < new_labels.size(); ++f)
        labels_->set(Index(f), new_labels[f]);
    }
    labels_->recount();
    face_of_cluster_ = faces_of_clusters();
    Cluster_labels labels = std::move(*labels_);
    // Later stages need the memory. A repeated growth finds the same seeds.
    labels_.reset();
    clustering_.reset();
    faces_.reset();
    return labels;
  }

private:
  static std::size_t sum(const std::vector<std::size_t>& v) { return std::accumulate(v.begin(), v.end(), std::size_t(0)); }

  Featured_input subdivided(const Featured_input& input, const std::vector<bool>& chosen_component) const
  {
    if (input.cells)
      return input.cells->subdivided(chosen_component, context_);
    Quad_subdivision cutting(input.items.mesh, faces_of_components(input.items.mesh, chosen_component));
    return {cut_input(input.items, cutting.run(context_), cutting.old_face(), context_), nullptr};
  }

  void bound_by_vertices()
  {
    max_.clear();
    for (std::size_t i = 0; i < min_.size(); ++i)
      max_.push_back((std::max)(uncut_input_->items.mesh.components[i].max_clusters(), min_[i]));
  }

  void apportion_number()
  {
    if (may_exceed_number_)
      number_ = (std::max)(number_, sum(min_));
    if (number_ < sum(min_)) {
      find_minimum();
      throw_unreachable("the input, with " + needs_of_vertices(uncut_input_->items.mesh.components) + ", needs ", sum(min_));
    }
    begin_plans(apportion(number_, share_, min_, max_), merging_ == Merging::BY_QUADRICS);
  }

  void begin_plans(const std::vector<std::size_t>& wanted, bool by_quadrics)
  {
    wanted_.resize(wanted.size(), 0);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (wanted_[i] != wanted[i]) {
        wanted_[i] = wanted[i];
        plan_[i].begin(uncut_input_->items.mesh.components[i], wanted[i], merge_level_, by_quadrics);
        state_[i] = State::NEW;
      }
  }

  // The smallest attainable number is known after every component has reached its minimum. It does not depend on quadrics.
  void find_minimum()
  {
    do {
      begin_plans(min_, false);
      find_seeds();
    } while (!grow_components());
  }

  [[noreturn]] void throw_unreachable(const std::string& limit, std::size_t nearest) const
  {
    throw Unreachable_number_of_vertices(std::to_string(number_) + (number_ == 1 ? " vertex was" : " vertices were") +
                                           " asked for, but " + limit + std::to_string(nearest),
                                         nearest);
  }

  bool pieces_are_up_to_date() const
  {
    return faces_ && std::equal(plan_.begin(), plan_.end(), cut_.begin(),
                                [](const Component_plan& plan, bool is_cut) { return plan.from_pieces() == is_cut; });
  }

  // Subdivides the components that need it, and lists the faces component by component, in their order.
  void prepare()
  {
    if (pieces_are_up_to_date())
      return;
    for (std::size_t i = 0; i < plan_.size(); ++i)
      cut_[i] = plan_[i].from_pieces();
    const auto cut = std::size_t(std::count(cut_.begin(), cut_.end(), true));
    report_.subdivided_components = subdivided_input_ ? cut_.size() : cut;
    input_ = uncut_input_;
    if (cut > 0) {
      labels_.reset();
      clustering_.reset();
      cut_input_ = subdivided(*uncut_input_, cut_);
      input_ = &*cut_input_;
    }
    const Flat_mesh& m = input_->items.mesh;
    faces_.reset();
    faces_.emplace(numbers_below(Index(m.number_of_faces())), m.components.size(), [&](Index f) { return m.component[f]; },
                   context_);
    labels_.emplace(m);
    clustering_.emplace(*input_, merging_ == Merging::BY_AREA, context_);
    std::fill(state_.begin(), state_.end(), State::NEW);
  }

  Face_range faces_of(std::size_t i) const { return (*faces_)[i]; }

  void find_seeds_of(Index level)
  {
    wanted_.assign(min_.size(), 0);
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      plan_[i].begin(input_->items.mesh.components[i], 0, level, false);
    find_seeds();
  }

  void find_seeds()
  {
    prepare();
    report_.level = report_.seeds = 0;
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      if (state_[i] == State::NEW) {
        seeds_[i] = clustering_->seeds(faces_of(i), plan_[i]);
        state_[i] = State::SEEDED;
      }
      report_.level = (std::max)(report_.level, std::size_t(seeds_[i].level));
      report_.seeds += seeds_[i].faces.size();
    }
  }

  // Brings all components to their numbers of clusters. Returns false if the minimum of a component turns out to be larger.
  bool grow_components()
  {
    for (;;) {
      bool raised = false;
      for (std::size_t i = 0; i < plan_.size(); ++i)
        if (state_[i] != State::DONE && !grow_component(i))
          raised = true;
      if (raised)
        return false;
      if (pieces_are_up_to_date())
        return true;
      find_seeds();
    }
  }

  // Tries the attempts in the plan of a component until one succeeds, or until its faces must be subdivided first.
  bool grow_component(std::size_t i)
  {
    while (plan_[i].from_pieces() == cut_[i]) {
      grown_[i] = clustering_->grow(*labels_, faces_of(i), seeds_[i], plan_[i]);
      if (grown_[i].clusters == wanted_[i]) {
        state_[i] = State::DONE;
        return true;
      }
      if (!plan_[i].revise(seeds_[i].level, seeds_[i].faces.size() - seeds_[i].of_every_level, grown_[i].clusters)) {
        if (!plan_[i].has_nearest())
          throw Invalid_input("component " + std::to_string(i) + " of the input cannot be clustered");
        min_[i] = plan_[i].nearest();
        max_[i] = (std::max)(max_[i], min_[i]);
        return false;
      }
      if (plan_[i].from_pieces() == cut_[i])
        seeds_[i] = clustering_->seeds(faces_of(i), plan_[i]);
    }
    state_[i] = State::NEW;
    return true;
  }

  // Converts the numbers of clusters per component to consecutive numbers.
  void number_clusters()
  {
    Index offset = 0;
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      if (offset > 0)
        for (const Index f : faces_of(i))
          labels_->set(f, (*labels_)[f] + offset);
      offset += Index(wanted_[i]);
    }
    report_.clusters = offset;
    report_.splits = report_.merges = 0;
    for (const Component_growth& g : grown_) {
      report_.splits += g.splits;
      report_.merges += g.merges;
    }
  }

  // Returns a face of each cluster: the first of the seeds, or otherwise of all faces. The seeds of merged clusters come before
  // the seeds that were merged.
  std::vector<Index> faces_of_clusters() const
  {
    std::vector<Index> result(report_.clusters, NONE);
    const auto offer = [&](Index f) {
      Index& face = result[(*labels_)[f]];
      face = face == NONE ? f : face;
    };
    if (!resolved_input_) { // its faces have other numbers than the seeds
      for (const Component_growth& g : grown_)
        std::for_each(g.new_seeds.begin(), g.new_seeds.end(), offer);
      for (const Component_seeds& seeds : seeds_)
        std::for_each(seeds.faces.begin(), seeds.faces.end(), offer);
    }
    for (std::size_t f = 0; f < labels_->labels().size(); ++f) {
      context_.poll();
      offer(Index(f));
    }
    return result;
  }

  enum class State { NEW, SEEDED, DONE };

  const Featured_input* uncut_input_; // the given input, or a subdivision of it
  const Featured_input* input_;       // the same, or with subdivided components
  Merging merging_;
  std::optional<Featured_input> subdivided_input_, cut_input_;
  std::optional<Featured_input> resolved_input_; // after growth, if clusters are joined at vertices
  Coarsening_report& report_;
  const Run_context context_;
  std::size_t number_ = 0;
  Index merge_level_ = NONE;       // the level of the seeds that are merged to the number, if given
  bool may_exceed_number_ = false; // if the topology needs more
  std::optional<Bucketed_items<Index> > faces_; // per component
  std::optional<Component_clustering> clustering_;
  std::optional<Cluster_labels> labels_;
  std::vector<Index> face_of_cluster_;
  // Per component:
  std::vector<double> share_;                   // its mass
  std::vector<std::size_t> min_, max_, wanted_; // clusters
  std::vector<Component_plan> plan_;
  std::vector<bool> cut_;
  std::vector<State> state_;
  std::vector<Component_seeds> seeds_;
  std::vector<Component_growth> grown_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_INITIAL_CLUSTERING_H
