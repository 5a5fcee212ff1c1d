// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_FACE_GRAPHS_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_FACE_GRAPHS_H

#include "Reference_mesh.h"
#include "generate_meshes.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

// Converts soups to face graphs and back, keeping the order of vertices and faces.
namespace test {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

template <class Graph>
void to_face_graph(const generated::Soup& soup, Graph& graph)
{
  typedef typename boost::property_traits<typename boost::property_map<Graph, CGAL::vertex_point_t>::type>::value_type
    Graph_point;
  std::vector<Graph_point> points;
  for (const generated::Point& p : soup.points)
    points.push_back(Graph_point(p[0], p[1], p[2]));
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.polygons, graph);
}

inline Mesh to_mesh(const generated::Soup& soup)
{
  Mesh mesh;
  to_face_graph(soup, mesh);
  return mesh;
}

template <class Graph>
generated::Soup to_soup(const Graph& graph)
{
  generated::Soup soup;
  std::map<typename boost::graph_traits<Graph>::vertex_descriptor, std::size_t> number;
  const auto point_map = get(CGAL::vertex_point, graph);
  for (const auto v : vertices(graph)) {
    number[v] = soup.points.size();
    const auto& p = get(point_map, v);
    soup.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  for (const auto f : faces(graph)) {
    soup.polygons.emplace_back();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, graph), graph))
      soup.polygons.back().push_back(number[v]);
  }
  return soup;
}

inline generated::Soup read_soup(const std::string& file)
{
  std::vector<Point> points;
  generated::Soup soup;
  BOOST_REQUIRE(CGAL::IO::read_polygon_soup(file, points, soup.polygons));
  for (const Point& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  return soup;
}

inline std::vector<reference::Triangle> triangles_of(const generated::Soup& soup)
{
  std::vector<reference::Triangle> triangles;
  for (const generated::Polygon& p : soup.polygons) {
    BOOST_REQUIRE_EQUAL(p.size(), 3u);
    triangles.push_back({p[0], p[1], p[2]});
  }
  return triangles;
}

// Returns the sorted triangles, each from its smallest vertex on: a normal form of sets.
inline std::vector<reference::Triangle> normalized(std::vector<reference::Triangle> triangles)
{
  for (reference::Triangle& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

template <class Graph, class Map>
reference::Labels labels_of(const Graph& graph, const Map& map)
{
  reference::Labels labels;
  for (const auto f : faces(graph))
    labels.push_back(std::size_t(get(map, f)));
  return labels;
}

template <class Clustering, class Graph>
reference::Labels labels_in(const Clustering& clustering, const Graph& graph)
{
  reference::Labels labels;
  for (const auto f : faces(graph))
    labels.push_back(clustering.cluster(f));
  return labels;
}

// A precondition for test cases that need a model.
struct If_found
{
  std::string file;
  boost::test_tools::assertion_result operator()(boost::unit_test::test_unit_id) const
  {
    boost::test_tools::assertion_result found(!file.empty());
    found.message() << "the model was not found when the project was configured";
    return found;
  }
};

} // namespace test

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_FACE_GRAPHS_H
