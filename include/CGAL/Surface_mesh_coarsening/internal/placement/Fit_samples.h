// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_SAMPLES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_SAMPLES_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Input_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/placement/Foot_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Samples of the input and of a coarse mesh, each with its closest point on the other surface, its foot. The search for a
// foot descends from the previous foot, so feet remain on the same side of thin parts, and vertices of high valence do not
// slow down a search.
class Fit_samples
{
public:
  // Only the marked clusters and the triangles around their vertices have samples.
  Fit_samples(const Clustered_faces& surface, const Flippable_triangulation& coarse, const std::vector<Vector>& positions,
              const std::vector<char>& is_marked)
    : surface_(surface), coarse_(coarse), positions_(positions), back_search_(surface, positions),
      search_(coarse, positions), back_(coarse.triangles().size()),
      squares_(coarse.triangles().size()), back_cost_(coarse.triangles().size())
  {
    const auto is_marked_corner = [&](Index v) -> bool { return is_marked[v]; };
    for (Index t = 0; t < coarse.triangles().size(); ++t)
      if (std::any_of(coarse.triangles()[t].begin(), coarse.triangles()[t].end(), is_marked_corner))
        triangles_.push_back(t);
    add_samples(is_marked);
    next_on_.assign(samples_.size(), NONE);
    use_every(1);
  }

  // The number of triangles with samples.
  std::size_t number_of_triangles() const { return triangles_.size(); }

  // The area of the input.
  double area() const { return area_; }
  // Returns the area that a sample of the input represents.
  double weight() const { return weight_; }

  // Uses every `step`-th sample of the input.
  void find_feet(std::size_t step) { find_feet(step, false); }

  // Finds the feet among all triangles. After a repair, a descent from the vertex of a cluster may end far from the nearest point.
  void find_feet_everywhere() { find_feet(1, true); }
  // Calls `visit(sample)` for each sample of the input whose foot lies on a triangle.
  template <class Visit>
  void for_each_on(Index t, const Visit& visit) const
  {
    for (Index i = first_on_[t]; i != NONE; i = next_on_[i])
      visit(samples_[i]);
  }

  const Back_samples& of_triangle(Index t) const { return back_[t]; }

  // Returns the component of the input that some triangles of one component approximate; NONE if they have no samples.
  Index component(const std::vector<Index>& triangles) const
  {
    for (const Index t : triangles)
      if (first_on_[t] != NONE)
        return surface_.input().mesh.component[samples_[first_on_[t]].face];
    return NONE;
  }

  // Returns the sum over the samples of the input of area times squared distance.
  double sum_of_squared_distances() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < samples_.size(); i += step_)
      sum += samples_[i].foot.squared_distance;
    return weight() * sum;
  }

  // Returns the mean squared distance of the direction in which it is larger.
  double squared_distance() const
  {
    double back = 0, area = 0;
    for (std::size_t t = 0; t < back_.size(); ++t) {
      back += back_cost_[t];
      for (const Back_sample& s : back_[t])
        area += s.weight;
    }
    return (std::max)(area_ > 0 ? sum_of_squared_distances() / area_ : 0, area > 0 ? back / area : 0);
  }

  // Returns the contribution of a triangle to the sums of both directions.
  double cost(Index t) const { return cost_of_input(t) + back_cost_[t]; }

  // Returns the contribution of two other triangles that replace `t` and `u`. Returns a value above `limit` as soon as the
  // contribution is known to exceed it: after a triangle, or with `at_once` after each sample.
  double cost_instead(Index t, Index u, const Triangle& first, const Triangle& second, double limit, bool at_once) const
  {
    const double limit_at_once = at_once ? limit : std::numeric_limits<double>::infinity(), each = weight();
    const Prepared_triangle to_first(positions_, first), to_second(positions_, second);
    double sum = 0;
    for (const Index old : {t, u})
      for (Index i = first_on_[old]; i != NONE; i = next_on_[i]) {
        const Vector& p = samples_[i].position;
        Foot_point foot = to_first.closest(p);
        to_second.improve(p, foot);
        sum += foot.squared_distance;
        if (each * sum > limit_at_once)
          return each * sum;
      }
    sum *= each;
    if (sum > limit)
      return sum;
    const Search_starts starts = starts_between(t, u);
    sum += back_search_.cost(first, starts, limit_at_once - sum);
    return sum > limit ? sum : sum + back_search_.cost(second, starts, limit_at_once - sum);
  }

  // Updates the feet on two changed triangles, and the feet of their samples.
  void redistribute(Index t, Index u)
  {
    const Search_starts starts = starts_between(t, u);
    const std::vector<Index> samples = unlinked_samples({t, u});
    for (const Index changed : {t, u})
      search_.update(changed);
    for (std::size_t k = samples.size(); k-- > 0;) {
      Input_sample& s = samples_[samples[k]];
      const Foot_point on_t = search_.triangle(t).closest(s.position), on_u = search_.triangle(u).closest(s.position);
      const bool nearer = on_u.squared_distance < on_t.squared_distance;
      s.foot = nearer ? on_u : on_t;
      s.triangle = nearer ? u : t;
      link(samples[k]);
    }
    for (const Index changed : {t, u}) {
      set_back(changed, back_search_(coarse_.triangles()[changed], starts));
      add_up_squares(changed);
    }
  }

  // Returns the cost of a triangle from the samples of the input.
  double cost_of_input(Index t) const { return weight_ * squares_[t]; }

  // Forgets the feet of the samples of triangles that move to another component: the next search would begin there.
  void forget_feet(const std::vector<Index>& triangles)
  {
    for (const Index t : triangles)
      set_back(t, Back_samples());
  }

  // Finds the feet of the samples of replaced triangles on the new triangles, and the feet of the samples of the new triangles.
  // Returns the number of comparisons of samples with triangles.
  std::size_t redistribute(const std::vector<Index>& old_triangles, const std::vector<Index>& new_triangles)
  {
    const std::vector<Index> samples = unlinked_samples(old_triangles);
    for (const Index t : new_triangles)
      search_.update(t);
    for (std::size_t k = samples.size(); k-- > 0;) {
      Input_sample& s = samples_[samples[k]];
      s.triangle = new_triangles.front();
      s.foot = search_.triangle(s.triangle).closest(s.position);
      for (const Index t : new_triangles)
        search_.improve_foot(s, t);
      link(samples[k]);
    }
    for (const Index t : new_triangles) {
      set_back(t, back_search_(coarse_.triangles()[t], starts_around(t)));
      add_up_squares(t);
    }
    return samples.size() * new_triangles.size();
  }

private:
  static constexpr std::size_t samples_per_triangle = 16;

  // Adds the samples of the marked clusters.
  void add_samples(const std::vector<char>& is_marked)
  {
    std::size_t number = samples_per_triangle * coarse_.triangles().size();
    if (surface_.has_cells())
      number = (std::min)(number, surface_.input().mesh.number_of_faces());
    samples_.reserve((std::min)(number, samples_per_triangle * triangles_.size()));
    const Input_surface pieces(surface_.input().mesh);
    area_ = pieces.area(surface_.context());
    pieces.for_each_sample(number, area_, surface_.context(), [&](const Input_point& p) {
      ++number_on_input_;
      if (is_marked[surface_.labels()[p.face]])
        samples_.push_back({p.position, p.face});
    });
  }

  void find_feet(std::size_t step, bool everywhere)
  {
    use_every(step);
    const std::vector<Triangle>& triangles = coarse_.triangles();
    const Run_context& context = surface_.context();
    for_each_number(context, triangles.size(), [this](Index t) { search_.update(t); });
    for_each_chunk(context, number_of_used(), 64, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        search_.find_foot(samples_[i * step_], surface_.labels()[samples_[i * step_].face]);
    });
    correct_feet_at_hubs();
    if (everywhere)
      search_all_triangles(used_samples([](const Input_sample&) { return true; }), Coarse_mesh_search(triangles, positions_));
    else if (surface_.has_cells())
      correct_far_feet();
    first_on_.assign(triangles.size(), NONE);
    for (std::size_t i = number_of_used(); i-- > 0;)
      link(Index(i * step_));
    constexpr std::size_t at_a_time = 1024, steps_of_triangle = 16;
    for (std::size_t first = 0; first < triangles_.size(); first += at_a_time) {
      context.poll(steps_of_triangle * at_a_time);
      for_each_chunk(context.uninterrupted(), (std::min)(at_a_time, triangles_.size() - first), 16,
                     [&](std::size_t, std::size_t begin, std::size_t end) {
                       for (std::size_t i = first + begin; i < first + end; ++i) {
                         const Index t = triangles_[i];
                         set_back(t, back_search_.again(triangles[t], back_[t], [&]() { return starts_around(t); }));
                         add_up_squares(t);
                       }
                     });
    }
  }

  template <class Is_chosen>
  std::vector<Index> used_samples(const Is_chosen& is_chosen) const
  {
    std::vector<Index> chosen;
    for (std::size_t i = 0; i < samples_.size(); i += step_)
      if (is_chosen(samples_[i]))
        chosen.push_back(Index(i));
    return chosen;
  }

  // A descent around a vertex of many triangles does not test all of them.
  void correct_feet_at_hubs()
  {
    std::size_t hub = 0;
    while (hub < positions_.size() && !search_.is_hub(Index(hub)))
      ++hub;
    if (hub == positions_.size())
      return;
    const std::vector<Index> at_hubs = used_samples([this](const Input_sample& s) { return is_at_hub(s); });
    if (!at_hubs.empty())
      search_all_triangles(at_hubs, Coarse_mesh_search(coarse_.triangles(), positions_));
  }

  // A foot nearly at its sample cannot be improved.
  bool is_at_hub(const Input_sample& s) const
  {
    constexpr double nearly_zero = 1e-20; // of the area that the sample represents
    const Triangle& t = coarse_.triangles()[s.triangle];
    return s.foot.squared_distance > nearly_zero * weight() && !search_.triangle(s.triangle).is_far_from_sides(s.foot) &&
           std::any_of(t.begin(), t.end(), [this](Index v) { return search_.is_hub(v); });
  }

  // Descents between the narrow triangles of long clusters can end far from the nearest point. Few such samples would dominate all
  // sums. Between round clusters they do not occur: one of 299,744 samples of the Fandisk with 648 vertices.
  void correct_far_feet()
  {
    constexpr double far_part = 64; // of the mean squared distance
    std::optional<Coarse_mesh_search> search;
    double before = std::numeric_limits<double>::infinity(), sum = sum_of_squared_distances() / weight();
    while (sum < 0.5 * before) {
      before = sum;
      const std::vector<Index> far = used_samples([&](const Input_sample& s) {
        return s.foot.squared_distance * double(number_of_used()) > far_part * sum;
      });
      if (far.empty())
        return;
      if (!search)
        search.emplace(coarse_.triangles(), positions_);
      search_all_triangles(far, *search);
      sum = sum_of_squared_distances() / weight();
    }
  }

  // Replaces the feet of some samples by their nearest points on the side of the surface on which the samples lie.
  void search_all_triangles(const std::vector<Index>& samples, const Coarse_mesh_search& search)
  {
    for_each_number(surface_.context(), samples.size(), [&](Index i) {
      Input_sample& s = samples_[samples[i]];
      const Nearest_point p = search(s.position, surface_.labels()[s.face]);
      if (!is_on_side_of(s, coarse_.triangles()[p.face]))
        return;
      s.triangle = p.face;
      s.foot = {p.barycentric, p.squared_distance};
    });
  }

  // Returns whether a triangle approximates the side of the component on which a sample lies.
  bool is_on_side_of(const Input_sample& s, const Triangle& t) const
  {
    const Flat_mesh& m = surface_.input().mesh;
    const Clustered_faces::Range faces = surface_.faces(t[0]);
    return (faces.empty() || m.component[*faces.begin()] == m.component[s.face]) &&
           dot(normal_of(positions_, t), vector_area(m, s.face)) > 0;
  }

  std::size_t number_of_used() const { return (samples_.size() + step_ - 1) / step_; }

  void use_every(std::size_t step)
  {
    step_ = step;
    weight_ = number_on_input_ == 0 ? 0 : area_ / double((number_on_input_ + step - 1) / step);
  }

  void set_back(Index t, const Back_samples& samples)
  {
    back_[t] = samples;
    back_cost_[t] = cost_of(samples);
  }

  // Adds up the squared distances of the samples whose feet lie on a triangle.
  void add_up_squares(Index t)
  {
    squares_[t] = 0;
    for_each_on(t, [&](const Input_sample& s) { squares_[t] += s.foot.squared_distance; });
  }

  // Removes the samples whose feet lie on some triangles from their lists, and returns them.
  std::vector<Index> unlinked_samples(const std::vector<Index>& triangles)
  {
    std::vector<Index> samples;
    for (const Index t : triangles) {
      for (Index i = first_on_[t]; i != NONE; i = next_on_[i])
        samples.push_back(i);
      first_on_[t] = NONE;
      squares_[t] = 0;
    }
    return samples;
  }

  void link(Index i)
  {
    next_on_[i] = first_on_[samples_[i].triangle];
    first_on_[samples_[i].triangle] = i;
  }

  // Returns the last feet of the triangle, and some of the samples on it; if it has none, some of the samples on its neighbors.
  Search_starts starts_around(Index t) const
  {
    Search_starts starts;
    add_feet(t, starts);
    add_samples(t, 8, starts);
    if (first_on_[t] == NONE)
      for (int i = 0; i < 3; ++i)
        if (coarse_.across(t, i) != NONE)
          add_samples(coarse_.across(t, i), 4, starts);
    return starts;
  }

  Search_starts starts_between(Index t, Index u) const
  {
    Search_starts starts;
    for (const Index old : {t, u}) {
      add_feet(old, starts);
      add_samples(old, 8, starts);
    }
    return starts;
  }

  void add_feet(Index t, Search_starts& starts) const
  {
    for (const Back_sample& s : back_[t])
      if (s.foot.face != NONE)
        starts.add(s.foot.position, s.foot.face);
  }

  void add_samples(Index t, std::size_t max_samples, Search_starts& starts) const
  {
    for (Index i = first_on_[t]; i != NONE && max_samples > 0; i = next_on_[i], --max_samples)
      starts.add(samples_[i].position, surface_.whole_face(samples_[i].face));
  }

  const Clustered_faces& surface_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  const Back_search back_search_;
  double area_;
  std::size_t number_on_input_ = 0, step_ = 1;
  double weight_ = 0;
  std::vector<Input_sample> samples_;
  std::vector<Index> triangles_; // with samples
  Foot_search search_;
  std::vector<Index> first_on_, next_on_; // the samples whose foot lies on each triangle, as linked lists
  std::vector<Back_samples> back_;          // of each triangle
  std::vector<double> squares_, back_cost_; // sums over the samples of the input and of `back_`, for each triangle
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_PLACEMENT_FIT_SAMPLES_H
