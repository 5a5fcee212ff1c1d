// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boxes that a `Box_hierarchy` and a `Box_list` find are the boxes that a loop over all finds, also after boxes have changed.
// Triangles are in conflict if CGAL's exact predicates say so. The work of repairs is bounded.

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Triangle_conflicts.h>
#include <CGAL/Surface_mesh_coarsening/internal/repair/Repair_budget.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_box_hierarchy)

using CGAL::Bbox_3;
using CGAL::Surface_mesh_coarsening::internal::Box_hierarchy;
using CGAL::Surface_mesh_coarsening::internal::Box_list;
using CGAL::Surface_mesh_coarsening::internal::Index;

namespace {

// Random boxes with corners on a grid, so that many touch, coincide or have no extent.
class Random_boxes
{
public:
  explicit Random_boxes(int cells) : cells_(cells) {}

  Bbox_3 operator()(int max_size)
  {
    const int x = below(cells_), y = below(cells_), z = below(cells_);
    return Bbox_3(x, y, z, x + below(max_size), y + below(max_size), z + below(max_size));
  }

  int below(int n) { return int(random_() % unsigned(n)); }

private:
  std::mt19937 random_;
  int cells_;
};

template <class Boxes>
std::vector<Index> found_by(const Boxes& boxes, const Bbox_3& region)
{
  std::vector<Index> found;
  boxes.for_each_overlapping(region, [&](std::size_t i) { found.push_back(Index(i)); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> found_by_loop(const std::vector<Bbox_3>& boxes, const Bbox_3& region)
{
  std::vector<Index> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (CGAL::do_overlap(boxes[i], region))
      found.push_back(Index(i));
  return found;
}

} // namespace

BOOST_AUTO_TEST_CASE(finds_what_a_loop_finds)
{
  constexpr int regions = 50;
  for (const int cells : {1, 10, 1000})
    for (const std::size_t number : {0, 1, 2, 3, 7, 64, 500}) {
      Random_boxes random(cells);
      std::vector<Bbox_3> boxes;
      for (std::size_t i = 0; i < number; ++i)
        boxes.push_back(random(cells / 5 + 1));
      Box_hierarchy hierarchy;
      hierarchy.build(boxes);
      Box_list list;
      list.resize(number);
      for (std::size_t i = 0; i < number; ++i)
        list.set(i, boxes[i]);
      for (int i = 0; i < regions; ++i) {
        const Bbox_3 region = random(cells / 2 + 1);
        BOOST_TEST(found_by(hierarchy, region) == found_by_loop(boxes, region), boost::test_tools::per_element());
        BOOST_TEST(found_by(list, region) == found_by_loop(boxes, region), boost::test_tools::per_element());
      }
    }
}

BOOST_AUTO_TEST_CASE(finds_boxes_that_have_grown)
{
  constexpr int cells = 100, growths = 300;
  Random_boxes random(cells);
  std::vector<Bbox_3> boxes;
  for (int i = 0; i < 200; ++i)
    boxes.push_back(random(5));
  Box_hierarchy hierarchy;
  hierarchy.build(boxes);
  for (int i = 0; i < growths; ++i) {
    const std::size_t grown = std::size_t(random.below(int(boxes.size())));
    const Bbox_3 by = random(5), region = random(30);
    boxes[grown] += by;
    hierarchy.grow(Index(grown), by);
    BOOST_TEST(found_by(hierarchy, region) == found_by_loop(boxes, region), boost::test_tools::per_element());
    BOOST_TEST(found_by(hierarchy, by) == found_by_loop(boxes, by), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(finds_boxes_that_have_been_replaced)
{
  constexpr int cells = 100, changes = 300;
  Random_boxes random(cells);
  std::vector<Bbox_3> boxes(200);
  Box_list list;
  list.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    list.set(i, boxes[i] = random(5));
  for (int i = 0; i < changes; ++i) {
    const std::size_t changed = std::size_t(random.below(int(boxes.size())));
    list.set(changed, boxes[changed] = random(5));
    const Bbox_3 region = random(30);
    BOOST_TEST(found_by(list, region) == found_by_loop(boxes, region), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(builds_again)
{
  Box_hierarchy hierarchy;
  hierarchy.build({Bbox_3(0, 0, 0, 1, 1, 1), Bbox_3(2, 2, 2, 3, 3, 3)});
  hierarchy.build({Bbox_3(5, 5, 5, 6, 6, 6)});
  BOOST_TEST(found_by(hierarchy, Bbox_3(0, 0, 0, 9, 9, 9)).size() == 1u);
  hierarchy.build({});
  BOOST_TEST(found_by(hierarchy, Bbox_3(0, 0, 0, 9, 9, 9)).empty());
}

BOOST_AUTO_TEST_CASE(conflicts_are_exact)
{
  using namespace CGAL::Surface_mesh_coarsening::internal;
  typedef std::function<Vector(double, double, double)> Change;
  const std::vector<Change> changes{
    [](double x, double y, double z) { return Vector{{x, y, z}}; },
    [](double x, double y, double z) { return Vector{{x, y, 1e-9 * z}}; },
    [](double x, double y, double z) { return Vector{{std::round(2 * x), std::round(2 * y), std::round(2 * z)}}; },
    [](double x, double y, double z) { return Vector{{x, 1e-6 * y, 1e-12 * z}}; },
    [](double x, double y, double z) { return Vector{{x + 1e6, y + 1e6, z + 1e6}}; },
    [](double x, double y, double z) { return Vector{{1e-100 * x, 1e-100 * y, 1e-100 * z}}; },
    [](double x, double y, double z) { return Vector{{std::pow(1e40, x) * y, std::pow(1e40, y) * z, std::pow(1e40, z) * x}}; }};
  constexpr std::size_t number = 30, pairs = 2000;
  std::mt19937 random(3);
  const auto below = [&](std::size_t n) { return Index(random() % n); };
  const auto coordinate = [&] { return 2 * double(random() % 100000) / 100000 - 1; };
  for (const Change& change : changes) {
    std::vector<Vector> points;
    while (points.size() < number) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      points.push_back(change(x, y, z));
    }
    const Triangle_conflict conflict(points);
    const auto point = [&](Index v) { return Exact_point(points[v][0], points[v][1], points[v][2]); };
    const auto exact = [&](const Triangle& t) { return Exact_tests::Triangle_3(point(t[0]), point(t[1]), point(t[2])); };
    std::size_t conflicts = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
      const Triangle t{{below(10), 10 + below(10), 20 + below(10)}};
      const bool have_common = i % 2 == 0;
      const Triangle u{{have_common ? t[0] : (t[0] + 1 + below(9)) % 10, 10 + (t[1] - 10 + 1 + below(9)) % 10,
                        20 + (t[2] - 20 + 1 + below(9)) % 10}};
      if (conflict.is_flat(t) || conflict.is_flat(u))
        continue;
      const auto meets_opposite_side = [&](const Triangle& one, const Triangle& other) {
        return points[other[1]] != points[other[2]] &&
               CGAL::do_intersect(exact(one), Exact_tests::Segment_3(point(other[1]), point(other[2])));
      };
      const bool expected = have_common ? meets_opposite_side(t, u) || meets_opposite_side(u, t)
                                        : CGAL::do_intersect(exact(t), exact(u));
      BOOST_TEST(conflict(t, u) == expected);
      conflicts += expected;
    }
    BOOST_TEST(conflicts > 0u);
  }
}

// The repair's budget counts what exact numbers cost: nothing where rounding errors do not matter, and more where exponents
// differ.
BOOST_AUTO_TEST_CASE(exact_numbers_count_as_work)
{
  using namespace CGAL::Surface_mesh_coarsening::internal;
  const auto work_of = [](const std::vector<Vector>& points) {
    const Triangle_conflict conflict(points);
    conflict({{0, 1, 2}}, {{3, 4, 5}});
    const std::size_t work = conflict.take_work();
    BOOST_TEST(conflict.take_work() == 0u);
    return work;
  };
  const auto plane_through = [](double size) {
    return std::vector<Vector>{{{0, 0, 0}}, {{size, 0, 0}}, {{0, 1, 0}}, {{0.2, 0.2, 0}}, {{1, 1, 0}}, {{0.2, 1, 0}}};
  };
  BOOST_TEST(work_of({{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0.2, 0.2, -1}}, {{0.2, 0.3, 1}}, {{1, 1, 1}}}) == 1u);
  const std::size_t in_plane = work_of(plane_through(1));
  BOOST_TEST(in_plane > 1u);
  BOOST_TEST(work_of(plane_through(1e200)) > 4 * in_plane);
}

// Tests whether the input intersects itself leave less for the repair.
BOOST_AUTO_TEST_CASE(a_repair_ends_with_the_budget_of_all)
{
  CGAL::Surface_mesh_coarsening::internal::Repair_budget budget(100);
  budget.begin_repair();
  budget.spend_on_input(1000);
  BOOST_TEST(!budget.is_spent_for_repair());
  budget.spend_on_input(100000000);
  BOOST_TEST(budget.is_spent_for_input());
  BOOST_TEST(budget.is_spent_for_repair());
}

BOOST_AUTO_TEST_SUITE_END()
