// SPDX-License-Identifier: GPL-3.0-or-later

#include "repair/repair.h"

#include "repair/carry_over_repair.h"

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
      steps.push_back({action, count});
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
    note("removed faces with vertices that do not exist or are not finite",
         static_cast<std::size_t>(polygons.end() - end));
    polygons.erase(end, polygons.end());
    note("removed unused points", PMP::remove_isolated_points_in_polygon_soup(points, polygons));
  }

  void repair_soup()
  {
    note("merged coincident points", PMP::merge_duplicate_points_in_polygon_soup(points, polygons));
    const std::size_t before = polygons.size();
    PMP::repair_polygon_soup(points, polygons);
    if (polygons.size() < before)
      note("removed repeated faces and faces without three different vertices", before - polygons.size());
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
    note("duplicated points to separate what is not a manifold or cannot be oriented", points.size() - before);
  }

  void repair_mesh()
  {
    PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
    note("stitched pairs of border edges", PMP::stitch_borders(mesh));
    note("duplicated non-manifold vertices", PMP::duplicate_non_manifold_vertices(mesh));
    if (CGAL::is_triangle_mesh(mesh)) {
      std::vector<Exact_mesh::Face_index> degenerate;
      PMP::degenerate_faces(mesh, std::back_inserter(degenerate));
      if (!degenerate.empty()) {
        PMP::remove_degenerate_faces(mesh);
        note("removed degenerate faces", degenerate.size());
        note("duplicated non-manifold vertices", PMP::duplicate_non_manifold_vertices(mesh));
      }
    }
    note("removed isolated vertices", PMP::remove_isolated_vertices(mesh));
    mesh.collect_garbage();
  }

public:
  std::vector<Repair_step> operator()(Soup& soup)
  {
    for (const Point& p : soup.points)
      points.emplace_back(p.x(), p.y(), p.z());
    polygons = soup.polygons.lists();
    drop_meaningless_polygons();
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
    carry_over_repair(soup, repaired);
    soup = std::move(repaired);
    return steps;
  }
};

} // namespace

std::vector<Repair_step> repair(Soup& soup) { return Repair()(soup); }

} // namespace coarsen_mesh_tool
