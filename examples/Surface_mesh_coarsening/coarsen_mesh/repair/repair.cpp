// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/repair.h"

#include "repair/carry_over_repair.h"
#include "repair/weld.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace coarsen_mesh_tool {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// Degenerate triangles need exact predicates.
using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_point = Exact_kernel::Point_3;
using Exact_mesh = CGAL::Surface_mesh<Exact_point>;

class Repair
{
  std::vector<Repair_step> steps;
  std::vector<Exact_point> points;
  std::vector<std::vector<std::size_t> > polygons;
  Exact_mesh mesh;

  void note(const std::string& action, std::size_t count)
  {
    if (count > 0)
      steps.push_back({action, count, false});
  }

  // A step that may not be what the user expects.
  void note_change(const std::string& action, std::size_t count)
  {
    if (count > 0)
      steps.push_back({action, count, true});
  }

  // The number of parts that are connected by points.
  static std::size_t number_of_components(std::size_t points, const std::vector<std::vector<std::size_t> >& polygons)
  {
    std::vector<std::size_t> parent(points);
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto root = [&parent](std::size_t v) {
      while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    std::vector<bool> is_used(points, false);
    for (const auto& polygon : polygons)
      for (const std::size_t v : polygon) {
        parent[root(v)] = root(polygon.front());
        is_used[v] = true;
      }
    std::size_t result = 0;
    for (std::size_t v = 0; v < points; ++v)
      result += is_used[v] && parent[v] == v;
    return result;
  }

  void note_components(std::size_t before, std::size_t after)
  {
    if (after > before)
      note_change("separated connected components from others", after - before);
    else
      note_change("removed connected components", before - after);
  }

  // CGAL's functions require numbers in range and finite coordinates.
  void drop_meaningless_polygons()
  {
    const auto is_meaningless = [this](const std::vector<std::size_t>& polygon) {
      return std::any_of(polygon.begin(), polygon.end(), [this](std::size_t v) {
        return v >= points.size() || !std::isfinite(points[v].x()) || !std::isfinite(points[v].y()) ||
               !std::isfinite(points[v].z());
      });
    };
    const auto end = std::remove_if(polygons.begin(), polygons.end(), is_meaningless);
    note_change("removed faces with vertices that do not exist or are not finite",
                static_cast<std::size_t>(polygons.end() - end));
    polygons.erase(end, polygons.end());
    note("removed unused points", PMP::remove_isolated_points_in_polygon_soup(points, polygons));
  }

  void repair_soup()
  {
    const std::size_t before = polygons.size();
    PMP::repair_polygon_soup(points, polygons);
    if (polygons.size() < before)
      note_change("removed repeated faces and faces without three different vertices", before - polygons.size());
    else
      note("split faces that touch themselves", polygons.size() - before);
  }

  void orient_soup()
  {
    struct Counter : PMP::Default_orientation_visitor
    {
      std::size_t* reversed;
      void polygon_orientation_reversed(std::size_t) { ++*reversed; }
    };
    std::size_t reversed = 0;
    Counter counter;
    counter.reversed = &reversed;
    const std::size_t before = points.size();
    PMP::orient_polygon_soup(points, polygons, CGAL::parameters::visitor(counter));
    note("reversed faces", reversed);
    note_change("duplicated points to separate what is not a manifold or cannot be oriented", points.size() - before);
  }

  void repair_mesh()
  {
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    note("stitched pairs of border edges", PMP::stitch_borders(mesh));
    note_change("duplicated non-manifold vertices", PMP::duplicate_non_manifold_vertices(mesh));
    if (CGAL::is_triangle_mesh(mesh)) {
      std::vector<Exact_mesh::Face_index> degenerate;
      PMP::degenerate_faces(mesh, std::back_inserter(degenerate));
      if (!degenerate.empty()) {
        PMP::remove_degenerate_faces(mesh);
        note_change("removed degenerate faces", degenerate.size());
        note_change("duplicated non-manifold vertices", PMP::duplicate_non_manifold_vertices(mesh));
      }
    }
    note("removed isolated vertices", PMP::remove_isolated_vertices(mesh));
    mesh.collect_garbage();
  }

public:
  std::vector<Repair_step> operator()(Soup& soup, double tolerance)
  {
    if (tolerance > 0)
      note("moved points to others within the tolerance", weld(soup.points, tolerance));
    for (const Point& p : soup.points)
      points.emplace_back(p.x(), p.y(), p.z());
    polygons = soup.polygons.lists();
    drop_meaningless_polygons();
    note("merged coincident points", PMP::merge_duplicate_points_in_polygon_soup(points, polygons));
    const std::size_t components = number_of_components(points.size(), polygons);
    repair_soup();
    orient_soup();
    repair_mesh();
    Soup repaired;
    for (const Exact_point& p : mesh.points())
      repaired.points.emplace_back(p.x(), p.y(), p.z());
    for (auto f : mesh.faces()) {
      for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        repaired.polygons.add_corner(v);
      repaired.polygons.end_polygon();
    }
    note_components(components, number_of_components(repaired.points.size(), repaired.polygons.lists()));
    carry_over_repair(soup, repaired);
    soup = std::move(repaired);
    return steps;
  }
};

} // namespace

std::vector<Repair_step> repair(Soup& soup, double tolerance) { return Repair()(soup, tolerance); }

} // namespace coarsen_mesh_tool
