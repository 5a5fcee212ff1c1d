// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Flippable_triangulation.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Input_oracle.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

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
  static constexpr std::size_t tests_per_face = 3000, min_faces = 1000;
  static constexpr std::size_t max_tests_of_repair = 16000000; // one or two seconds

  std::size_t all_, left_, left_of_repair_;
};

// The faults of a coarse mesh: triangles that intersect where the input does not, and triangles that face away from the surface
// that they approximate.
class Placement_faults
{
public:
  // Maps a position to its coordinates in the output.
  typedef std::function<Vector(const Vector&)> Output_coordinates;

  Placement_faults(const Clustered_faces& surface, Input_oracle& reference, const Flippable_triangulation& coarse,
                   const std::vector<Vector>& positions, const Output_coordinates& output, Repair_budget& budget,
                   const Cancellation_point& cancellation)
    : budget_(budget), cancellation_(cancellation), execution_(surface.execution()), surface_(surface), reference_(reference),
      coarse_(coarse), positions_(positions), output_(output), exponent_(exponent_of_unit()),
      points_(positions.size())
  {}

  // Finds all faults of the current positions.
  void find()
  {
    for (std::size_t v = 0; v < positions_.size(); ++v)
      follow(Index(v));
    has_wide_exponents_ = have_wide_exponents(points_);
    has_coarse_coordinates_ = have_coarse_coordinates();
    const Triangle_conflict conflict = exact_test();
    std::vector<Bbox_3> boxes;
    boxes.reserve(coarse_.triangles().size());
    for (const Triangle& t : coarse_.triangles())
      boxes.push_back(conflict.box(t));
    boxes_.build(std::move(boxes));
    pairs_.clear();
    std::size_t tests = 0;
    for (const Triangle_pair& pair : conflicting_pairs(coarse_.triangles(), conflict, execution_, cancellation_, tests))
      if (!is_in_input(pair))
        pairs_.push_back(pair);
    budget_.spend(tests * work_of_test());
    find_reversed();
  }

  const std::vector<Triangle_pair>& pairs() const { return pairs_; }
  const std::vector<Index>& reversed() const { return reversed_; }
  std::size_t number() const { return pairs_.size() + reversed_.size(); }

  bool are_in_conflict(const Triangle_pair& p) const
  {
    return exact_test()(coarse_.triangles()[p.first], coarse_.triangles()[p.second]);
  }

  // Returns whether a triangle is reversed or has no area. Where the input has no area, no triangle is reversed.
  bool is_reversed(Index t)
  {
    std::size_t visited = 0;
    const bool result = is_reversed(t, visited);
    budget_.spend(visited / 4); // the distance from a face takes a fraction of the time of an exact test
    return result;
  }

  // Updates the position of a vertex. The change may be undone if no search has begun since.
  void follow(Index v)
  {
    const Vector q = output_(positions_[v]);
    points_[v] = Exact_point(in_unit(q[0]), in_unit(q[1]), in_unit(q[2]));
  }

  // Updates the data of triangles after a permanent change.
  void update(const std::vector<Index>& triangles)
  {
    const Triangle_conflict conflict = exact_test();
    for (const Index t : triangles)
      boxes_.grow(t, conflict.box(coarse_.triangles()[t]));
  }

  // Finds the triangles that changes at some vertices may affect.
  void look_around(const std::vector<Index>& vertices)
  {
    const Triangle_conflict conflict = exact_test();
    Bbox_3 region;
    for (const Index v : vertices)
      for (const Index t : coarse_.around(v))
        region += conflict.box(coarse_.triangles()[t]);
    for (const Index v : vertices) {
      const Vector q = output_(surface_.cluster_centroid(v));
      region += Exact_point(in_unit(q[0]), in_unit(q[1]), in_unit(q[2])).bbox();
    }
    region = grown(region, 0.25 * (std::max)({region.x_span(), region.y_span(), region.z_span()}));
    near_.clear();
    boxes_.for_each_overlapping(region, [this](Index t) { near_.push_back(t); });
    cancellation_.poll(near_.size());
    std::sort(near_.begin(), near_.end());
    near_boxes_.resize(near_.size());
    for (std::size_t i = 0; i < near_.size(); ++i)
      near_boxes_.set(i, conflict.box(coarse_.triangles()[near_[i]]));
    last_altered_.clear();
  }

  // Returns the number of faults of some of these triangles, and remembers them.
  long number_of(const std::vector<Index>& altered)
  {
    known_pairs_.clear();
    known_reversed_.clear();
    for_each_fault(
      altered,
      [this](Index t) {
        known_reversed_.push_back(t);
        return true;
      },
      [this](Index t, Index u) {
        known_pairs_.push_back({t, u});
        return true;
      });
    return long(known_pairs_.size() + known_reversed_.size());
  }

  // The same after a change of these triangles; stops when the number reaches `limit`. Most changes do not remove the faults that
  // were there before, so these are tested first.
  long number_after_change(const std::vector<Index>& altered, long limit)
  {
    long faults = 0;
    for (std::size_t i = 0; i < known_pairs_.size() && faults < limit; ++i) {
      budget_.spend(work_of_test());
      faults += is_fault(known_pairs_[i].first, known_pairs_[i].second);
    }
    for (std::size_t i = 0; i < known_reversed_.size() && faults < limit; ++i)
      faults += is_reversed(known_reversed_[i]);
    if (faults >= limit)
      return faults;
    faults = 0;
    for_each_fault(
      altered, [&](Index) { return ++faults < limit; }, [&](Index, Index) { return ++faults < limit; });
    return faults;
  }

private:
  // Returns the exponent of the power of two by which coordinates are divided, since the filters of exact tests fail far from 1.
  // The division does not round the smallest coordinates.
  int exponent_of_unit() const
  {
    constexpr int usual = 128, least_normal = -1000;
    int least = (std::numeric_limits<int>::max)(), largest = (std::numeric_limits<int>::min)();
    for (const Vector& p : positions_)
      for (const double x : output_(p))
        if (x != 0) {
          least = (std::min)(least, std::ilogb(x));
          largest = (std::max)(largest, std::ilogb(x));
        }
    if (least > largest || std::abs(largest) <= usual)
      return 0;
    return (std::min)(largest, least - least_normal);
  }

  double in_unit(double x) const { return exponent_ == 0 ? x : std::ldexp(x, -exponent_); }

  Triangle_conflict exact_test() const { return Triangle_conflict(points_, has_wide_exponents_); }

  // Returns whether so many triangles have collinear corners that coordinates seem to be rounded. The filters of exact tests
  // often fail then.
  bool have_coarse_coordinates() const
  {
    constexpr std::size_t usual_share = 32;
    const Triangle_conflict conflict = exact_test();
    const auto& triangles = coarse_.triangles();
    const auto flat =
      std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) { return conflict.is_flat(t); });
    return usual_share * std::size_t(flat) > triangles.size();
  }

  // In units of a usual test. At faults, the quick filters decide few tests.
  std::size_t work_of_test() const
  {
    constexpr std::size_t work_with_wide_exponents = 32, work_with_coarse_coordinates = 8;
    return has_wide_exponents_ ? work_with_wide_exponents : has_coarse_coordinates_ ? work_with_coarse_coordinates : 1;
  }

  bool is_fault(Index t, Index u) { return are_in_conflict({t, u}) && !is_in_input({t, u}); }

  // Calls `note_reversed(t)` and `note_pair(t, u)` for the faults of some triangles near the place of the search, until one of
  // them returns false.
  template <class Note_reversed, class Note_pair>
  void for_each_fault(const std::vector<Index>& altered, const Note_reversed& note_reversed, const Note_pair& note_pair)
  {
    const Triangle_conflict conflict = exact_test();
    update_near_boxes(last_altered_); // their changes may have been undone
    update_near_boxes(altered);
    last_altered_ = altered;
    bool goes_on = true;
    for (std::size_t i = 0; i < altered.size() && goes_on; ++i) {
      const Index t = altered[i];
      cancellation_.poll(near_.size());
      budget_.spend(near_.size() / 16); // a comparison of boxes takes a fraction of the time of an exact test
      near_boxes_.for_each_overlapping(conflict.box(coarse_.triangles()[t]), [&](std::size_t n) {
        const Index u = near_[n];
        if (!goes_on || u == t || (u < t && std::binary_search(altered.begin(), altered.end(), u)))
          return;
        budget_.spend(work_of_test());
        if (is_fault(t, u))
          goes_on = note_pair(t, u);
      });
    }
    for (std::size_t i = 0; i < altered.size() && goes_on; ++i)
      if (is_reversed(altered[i]))
        goes_on = note_reversed(altered[i]);
  }

  void update_near_boxes(const std::vector<Index>& triangles)
  {
    const Triangle_conflict conflict = exact_test();
    for (const Index t : triangles) {
      const auto place = std::lower_bound(near_.begin(), near_.end(), t);
      if (place != near_.end() && *place == t)
        near_boxes_.set(std::size_t(place - near_.begin()), conflict.box(coarse_.triangles()[t]));
    }
  }

  // The same, for several threads. Adds the number of visited faces of the input to `visited`.
  bool is_reversed(Index t, std::size_t& visited) const
  {
    const Triangle& triangle = coarse_.triangles()[t];
    return reference_.has_area(triangle) &&
           (exact_test().is_flat(triangle) || reference_.is_against(triangle, positions_, visited));
  }

  void find_reversed()
  {
    reversed_.clear();
    std::vector<char> reversed(coarse_.triangles().size());
    for_each_chunk(execution_, reversed.size(), 256, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t visited = 0;
      for (std::size_t t = begin; t < end; ++t)
        reversed[t] = is_reversed(Index(t), visited);
    });
    for (std::size_t t = 0; t < reversed.size(); ++t)
      if (reversed[t])
        reversed_.push_back(Index(t));
  }

  bool is_in_input(const Triangle_pair& pair)
  {
    return reference_.intersects_itself(coarse_.triangles()[pair.first], coarse_.triangles()[pair.second]);
  }

  Repair_budget& budget_;
  const Cancellation_point cancellation_;
  const Execution execution_;
  const Clustered_faces& surface_;
  Input_oracle& reference_;
  const Flippable_triangulation& coarse_;
  const std::vector<Vector>& positions_;
  const Output_coordinates output_;
  const int exponent_;
  std::vector<Exact_point> points_; // of the vertices, with the coordinates of the output in this unit
  bool has_wide_exponents_ = false, has_coarse_coordinates_ = false;
  Box_hierarchy boxes_;
  std::vector<Triangle_pair> pairs_;
  std::vector<Index> reversed_;
  std::vector<Index> near_;
  Box_list near_boxes_;                    // of these triangles
  std::vector<Index> last_altered_;        // the triangles of the last count
  std::vector<Triangle_pair> known_pairs_; // the faults of the last count before a change
  std::vector<Index> known_reversed_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_PLACEMENT_FAULTS_H
