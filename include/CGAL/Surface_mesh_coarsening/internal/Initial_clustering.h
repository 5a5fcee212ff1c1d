// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_INITIAL_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_INITIAL_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/merge_clusters.h>
#include <CGAL/Surface_mesh_coarsening/internal/seed_walk.h>
#include <CGAL/Surface_mesh_coarsening/internal/share_out_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/split_clusters.h>

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
// The usual way for a component is the paper's: seeds, growth, merging down to the number wanted, with splits where
// clusters meet twice. Where that does not reach the number, the faces of the component are cut into pieces, and the
// clusters are merged two by two from single pieces in an order that does not depend on the number wanted. Whatever
// number this second way reaches, it reaches all larger ones too.
class Initial_clustering
{
public:
  Initial_clustering(const Clustering_input& input, Coarsening_report& report) : input_(&input), report_(report)
  {
    const std::vector<Component>& components = input.mesh.components;
    for (const Component& c : components)
      least_.push_back(fewest_vertices(c));
    bound_by_vertices();
    share_.assign(components.size(), 0);
    for (std::size_t f = 0; f < input.mesh.number_of_faces(); ++f)
      share_[input.mesh.component[f]] += input.mass(Index(f));
    cut_.assign(components.size(), false);
    from_pieces_.assign(components.size(), false);
  }

  // Cuts all faces into pieces, as often as it takes to have `faces` of them.
  void subdivide(std::size_t faces)
  {
    while (input_->mesh.number_of_faces() < faces)
      cut(std::vector<bool>(cut_.size(), true));
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
      const std::vector<Index> failed = try_to_grow(labels);
      if (failed.empty())
        return labels;
      // A component fails twice at the most: the first time it goes over to the second way, the second time its
      // minimum is raised to what that way reaches.
      for (const Index i : failed)
        from_pieces_[i] = true;
      if (finding_least_)
        wanted_ = least_;
      else
        share_out_number();
      seed_components();
    }
  }

private:
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
    finding_least_ = true;
    wanted_ = least_;
    seed_components();
    grow();
    const std::size_t least = sum(least_);
    throw Unreachable_number_of_vertices(
      std::to_string(number_) + (number_ == 1 ? " vertex was" : " vertices were") + " asked for, but the input, with " +
        std::to_string(least_.size()) + " connected components, needs " + std::to_string(least), least);
  }

  std::vector<Index> all_faces() const
  {
    std::vector<Index> faces(input_->mesh.number_of_faces());
    std::iota(faces.begin(), faces.end(), Index(0));
    return faces;
  }

  bool cut_where_needed()
  {
    std::vector<bool> chosen(wanted_.size(), false);
    bool any = false;
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      if (!cut_[i] && (from_pieces_[i] || input_->mesh.components[i].faces < wanted_[i])) {
        chosen[i] = cut_[i] = any = true;
        ++report_.subdivided_components;
      }
    if (any)
      cut(chosen);
    return any;
  }

  void cut(const std::vector<bool>& chosen_components)
  {
    if (!cut_input_)
      cut_input_ = *input_;
    cut_input_->subdivide(chosen_components);
    input_ = &*cut_input_;
  }

  void bound_by_vertices()
  {
    most_.clear();
    for (std::size_t i = 0; i < least_.size(); ++i)
      most_.push_back((std::max)(input_->mesh.components[i].vertices, least_[i]));
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
    const Index* first = faces.data();
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      const Index* last = faces.data() + end[i];
      if (from_pieces_[i])
        seeds_.insert(seeds_.end(), first, last);
      else
        report_.level = (std::max)(report_.level, seed_component(walk, Face_range{first, last}, wanted_[i]));
      first = last;
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
  std::size_t seed_component(Seed_walk& walk, const Face_range& faces, std::size_t wanted)
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
  std::vector<Index> try_to_grow(Cluster_labels& labels)
  {
    Cluster_growth growth(labels);
    Index clusters = 0;
    for (const Index f : seeds_)
      growth.plant(f, clusters++);
    growth.run();
    clusters = growth.cover(all_faces(), clusters);

    Cluster_splitting splitting(labels, clusters);
    report_.splits = splitting.run();
    std::vector<Index> failed = splitting.fruitless_components();
    for (const Index i : failed)
      if (from_pieces_[i])
        throw Invalid_input("the faces of component " + std::to_string(i) + " do not form a surface");
    if (!failed.empty())
      return failed;
    labels.recount();

    Cluster_merging merging(labels, splitting.number_of_clusters(), input_->area, wanted_, from_pieces_);
    report_.merges = merging.run();
    for (std::size_t i = 0; i < wanted_.size(); ++i)
      if (merging.number_of_clusters(i) != wanted_[i]) {
        failed.push_back(Index(i));
        if (from_pieces_[i]) {
          least_[i] = merging.number_of_clusters(i);
          most_[i] = (std::max)(most_[i], least_[i]);
        }
      }
    if (failed.empty())
      seeds_ = merging.compact();
    report_.clusters = seeds_.size();
    return failed;
  }

  const Clustering_input* input_;
  std::optional<Clustering_input> cut_input_;
  Coarsening_report& report_;
  std::size_t number_ = 0;
  bool may_exceed_number_ = false; // where topology needs more
  bool finding_least_ = false;
  std::vector<std::size_t> least_, most_, wanted_; // clusters per component
  std::vector<double> share_;                      // mass per component
  std::vector<bool> cut_, from_pieces_;            // per component: faces cut into pieces; the second way
  std::vector<Index> seeds_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_INITIAL_CLUSTERING_H
