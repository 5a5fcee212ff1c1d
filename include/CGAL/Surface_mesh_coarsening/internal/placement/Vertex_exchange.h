// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_EXCHANGE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_EXCHANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Coarse_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Exchange_candidates.h>
#include <CGAL/Surface_mesh_coarsening/internal/refinement/Cluster_editing.h>

#include <algorithm>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Moves vertices of a coarse mesh, one at a time, from regions where their removal costs little to regions where the distance
// from the input is large: collapses an edge and splits another one. The numbers of vertices and triangles and the topology do
// not change. In an optimal mesh the error is evenly distributed over the vertices; the exchange approaches this distribution.
class Vertex_exchange
{
public:
  explicit Vertex_exchange(Coarse_mesh& mesh) : mesh_(mesh), candidates_(mesh) {}

  // Exchanges vertices as long as an exchange between two untouched regions is profitable, and while this does not take long.
  // Returns the number of exchanged vertices. `bonus` may have an additional gain for each triangle that receives a vertex.
  std::size_t run(const Angle_worth& worth, const std::vector<double>& bonus = {})
  {
    worth_ = worth;
    compared_ = 0;
    is_touched_.assign(mesh_.positions().size(), false);
    candidates_.measure_triangles(worth, bonus);
    removals_ = std::priority_queue<Vertex_removal>();
    insertions_ = std::priority_queue<Vertex_insertion>();
    candidates_.for_each_removal([this](const Vertex_removal& r) { removals_.push(r); });
    candidates_.for_each_insertion([this](const Vertex_insertion& x) { insertions_.push(x); });
    std::size_t exchanged = 0;
    const std::size_t max_compared = comparisons_of_vertex * mesh_.positions().size();
    while (compared_ < max_compared && find_best(removals_) && find_best(insertions_)) {
      const Vertex_removal removal = removals_.top();
      const Vertex_insertion insertion = insertions_.top();
      if (!(insertion.gain() > min_ratio * removal.loss()))
        break;
      removals_.pop();
      if (do_overlap(removal, insertion))
        continue;
      insertions_.pop();
      const Relocation outcome = exchange(removal, insertion);
      exchanged += outcome == Relocation::DONE;
      if (outcome == Relocation::NOT_THERE)
        removals_.push(removal);
      else if (outcome == Relocation::NOT_FROM_HERE)
        insertions_.push(insertion);
    }
    return exchanged;
  }

private:
  // Gain and loss are estimated before other vertices adapt, which reduces the loss more than the gain.
  static constexpr double min_ratio = 0.6;
  // Where a few faces are much larger than all others, their few triangles have most of the samples. The runs of
  // compare_quality need less: their results are the same without this limit.
  static constexpr std::size_t comparisons_of_vertex = 500;
  static constexpr std::size_t at_a_time = 16, steps_of_candidate = 64;

  template <class Visit>
  bool any_around(Index v, const Visit& visit) const
  {
    for (const Index t : mesh_.around(v))
      for (const Index x : mesh_.triangle(t))
        if (visit(x))
          return true;
    return false;
  }

  bool is_touched(const Vertex_removal& r) const
  {
    const auto is_touched = [this](Index x) { return bool(is_touched_[x]); };
    return is_touched(r.vertex) || is_touched(r.into) || any_around(r.vertex, is_touched) || any_around(r.into, is_touched);
  }

  bool is_touched(const Vertex_insertion& x) const
  {
    return std::any_of(x.corners.begin(), x.corners.end(), [this](Index v) { return is_touched_[v]; });
  }

  // Measures candidates until the best candidate is measured. Returns whether a candidate exists.
  template <class Candidate>
  bool find_best(std::priority_queue<Candidate>& candidates)
  {
    while (!candidates.empty()) {
      Candidate best = candidates.top();
      if (is_touched(best)) {
        candidates.pop();
      } else if (best.is_measured) {
        return true;
      } else if (best.measured) {
        candidates.pop();
        best.take_measured();
        if (best.may_pay())
          candidates.push(best);
      } else {
        measure_best(candidates);
      }
    }
    return false;
  }

  // Measures several of the best candidates in parallel. They remain in their places in the queue, so their number does not
  // affect the result.
  template <class Candidate>
  void measure_best(std::priority_queue<Candidate>& candidates)
  {
    std::vector<Candidate> best, measured;
    while (best.size() < at_a_time && !candidates.empty() && !candidates.top().is_measured) {
      if (!is_touched(candidates.top()))
        (candidates.top().measured ? measured : best).push_back(candidates.top());
      candidates.pop();
    }
    mesh_.context().poll(steps_of_candidate * best.size());
    candidates_.measure(best);
    for (const std::vector<Candidate>& some : {best, measured})
      for (const Candidate& c : some)
        candidates.push(c);
  }

  bool do_overlap(const Vertex_removal& r, const Vertex_insertion& x) const
  {
    const auto is_corner = [&](Index v) { return std::find(x.corners.begin(), x.corners.end(), v) != x.corners.end(); };
    return any_around(r.vertex, is_corner) || any_around(r.into, is_corner);
  }

  // Returns the faces of the samples on the two triangles and their neighbors, the nearest first.
  std::vector<Index> faces_around(const Vertex_insertion& x) const
  {
    std::vector<Index> triangles{x.t, x.u};
    for (const Index t : {x.t, x.u})
      for (int i = 0; i < 3; ++i)
        if (mesh_.across(t, i) != NONE)
          triangles.push_back(mesh_.across(t, i));
    sort_unique(triangles);
    std::vector<std::pair<double, Index> > near;
    for (const Index t : triangles)
      mesh_.samples().for_each_on(t, [&](const Input_sample& s) {
        const Vector d = s.position - x.place;
        near.emplace_back(dot(d, d), s.face);
      });
    std::sort(near.begin(), near.end());
    std::vector<Index> faces;
    for (const auto& f : near)
      faces.push_back(f.second);
    return faces;
  }

  // Fails if the cost in both directions would grow by more than the estimated gain, or if the clusters cannot be relocated.
  Relocation exchange(const Vertex_removal& r, const Vertex_insertion& x)
  {
    const Index v = r.vertex;
    const std::vector<Index> faces = faces_around(x);
    std::vector<Index> around = mesh_.around(v), changed, split{x.t, x.u};
    std::vector<Triangle> now, before;
    for (const Index t : mesh_.around(v))
      if (mesh_.corner(t, r.into) >= 0) {
        split.push_back(t);
      } else {
        changed.push_back(t);
        now.push_back(with_corner(mesh_.triangle(t), v, r.into));
      }
    for (const Index t : mesh_.around(r.into))
      if (mesh_.corner(t, v) < 0)
        around.push_back(t);
    changed.insert(changed.end(), split.begin(), split.end());
    const auto [a, b, c, d] = x.corners;
    now.insert(now.end(), {{a, v, c}, {v, b, c}, {b, v, d}, {v, a, d}});
    for (const Index t : changed)
      before.push_back(mesh_.triangle(t));
    std::vector<Index> all = around;
    all.insert(all.end(), {x.t, x.u});
    const double max_cost = mesh_.cost_of(all, worth_) + x.gain();
    Fit_samples& samples = mesh_.samples();
    std::vector<Vector>& positions = mesh_.positions();
    const bool is_one_component = samples.component(around) == samples.component({x.t, x.u});
    const Vector place = std::exchange(positions[r.into], r.place), place_of_v = std::exchange(positions[v], x.place);
    mesh_.replace(changed, now);
    const std::vector<Index> collapsed = mesh_.around(r.into);
    if (!is_one_component)
      samples.forget_feet(split);
    compared_ += samples.redistribute(around, collapsed) + samples.redistribute({x.t, x.u}, split);
    const Relocation outcome =
      mesh_.cost_of(all, worth_) < max_cost ? mesh_.clusters().relocate(v, r.into, faces, positions) : Relocation::TOO_FAR;
    if (outcome == Relocation::DONE) {
      touch(r, x);
    } else {
      positions[r.into] = place;
      positions[v] = place_of_v;
      mesh_.replace(changed, before);
      if (is_one_component) {
        compared_ += samples.redistribute(all, all);
      } else { // the components may be close to each other, so each receives its own samples
        samples.forget_feet(split);
        compared_ += samples.redistribute(split, {x.t, x.u}) + samples.redistribute(collapsed, around);
      }
    }
    return outcome;
  }

  // Marks the old and the new neighbors of the vertices as touched.
  void touch(const Vertex_removal& r, const Vertex_insertion& x)
  {
    is_touched_[r.into] = true;
    const auto touch = [this](Index y) {
      is_touched_[y] = true;
      return false;
    };
    any_around(r.into, touch);
    any_around(r.vertex, touch);
    std::for_each(x.corners.begin(), x.corners.end(), touch);
  }

  Coarse_mesh& mesh_;
  Exchange_candidates candidates_;
  Angle_worth worth_;
  std::size_t compared_ = 0; // samples with triangles, in this run
  std::vector<char> is_touched_; // of each vertex, in this run
  std::priority_queue<Vertex_removal> removals_;
  std::priority_queue<Vertex_insertion> insertions_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_VERTEX_EXCHANGE_H
