// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boxes that a `Box_hierarchy` and a `Box_list` find are the boxes that a loop over all finds, also after boxes have changed.


#include <CGAL/Surface_mesh_coarsening/internal/geometry/Box_hierarchy.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
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

BOOST_AUTO_TEST_SUITE_END()
