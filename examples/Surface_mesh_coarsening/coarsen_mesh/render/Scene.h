// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SCENE_H
#define COARSENING_SUPPORT_SCENE_H

#include "io/Mesh.h"
#include "render/Camera.h"
#include "render/Rgb.h"
#include "render/cluster_colors.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace coarsening_support {

// The content of a picture: shaded triangles, and dark lines on them.
struct Scene
{
  struct Triangle
  {
    std::array<std::size_t, 3> vertices;
    std::array<Vector, 3> normals; // unit length, one per corner
    Rgb color;
  };
  struct Line
  {
    std::size_t from, to;
    double width; // in pixels
    double ink;   // 1 is black
  };
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Line> lines;
  bool inside_out = false; // whether the triangles are oriented inwards
};

inline Vector face_normal(const Mesh& mesh, Face f)
{
  const Halfedge h = mesh.halfedge(f);
  const Point& p = mesh.point(mesh.target(h));
  const Point& q = mesh.point(mesh.target(mesh.next(h)));
  const Point& r = mesh.point(mesh.source(h));
  return CGAL::cross_product(q - p, r - p); // its length is twice the area
}

// Computes the unit normal of every halfedge at its target in its face. With `smooth`, normals are averaged around the
// vertex up to edges of more than 40 degrees, so that creases remain sharp.
inline std::vector<Vector> corner_normals(const Mesh& mesh, bool smooth)
{
  std::vector<Vector> of_face(mesh.num_faces()), result(mesh.num_halfedges());
  for (Face f : mesh.faces())
    of_face[f] = face_normal(mesh, f);
  const auto is_crease = [&](Halfedge h) {
    return mesh.is_border(mesh.edge(h)) ||
           unit(of_face[mesh.face(h)]) * unit(of_face[mesh.face(mesh.opposite(h))]) < std::cos(40. * CGAL_PI / 180.);
  };
  std::vector<bool> done(mesh.num_halfedges(), false);
  for (Halfedge h : mesh.halfedges()) {
    if (mesh.is_border(h) || done[h])
      continue;
    std::vector<Halfedge> fan;
    Halfedge first = h; // moves back to the crease where the fan begins, or once around
    while (smooth && !is_crease(first) && mesh.prev_around_target(first) != h)
      first = mesh.prev_around_target(first);
    Vector sum = CGAL::NULL_VECTOR;
    for (Halfedge g = first;;) {
      fan.push_back(g);
      sum = sum + of_face[mesh.face(g)];
      if (!smooth || is_crease(mesh.next(g)) || mesh.next_around_target(g) == first)
        break;
      g = mesh.next_around_target(g);
    }
    for (Halfedge g : fan) {
      done[g] = true;
      result[g] = unit(sum);
    }
  }
  return result;
}

// Returns whether the faces enclose a negative volume, as far as they enclose one.
inline bool is_inside_out(const Mesh& mesh)
{
  double volume = 0;
  for (Face f : mesh.faces()) {
    const Vector arm = mesh.point(mesh.target(mesh.halfedge(f))) - mesh.point(*mesh.vertices().begin());
    volume += arm * face_normal(mesh, f);
  }
  return volume < 0;
}

// Builds the scene of a triangle mesh; the given functions color faces and draw edges.
inline Scene make_scene(const Mesh& mesh, bool smooth, const std::function<Rgb(Face)>& color,
                        const std::function<bool(Edge)>& is_drawn, double width, double ink)
{
  Scene scene;
  scene.points.assign(mesh.points().begin(), mesh.points().end());
  scene.inside_out = is_inside_out(mesh);
  const std::vector<Vector> normals = corner_normals(mesh, smooth);
  for (Face f : mesh.faces()) {
    Scene::Triangle t;
    Halfedge h = mesh.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      t.vertices[i] = mesh.target(h);
      t.normals[i] = normals[h];
    }
    t.color = color(f);
    scene.triangles.push_back(t);
  }
  for (Edge e : mesh.edges())
    if (is_drawn(e))
      scene.lines.push_back({mesh.vertex(e, 0), mesh.vertex(e, 1), width, ink});
  return scene;
}

// Shows a mesh, by default in one color, flat and with its edges.
inline Scene mesh_scene(const Mesh& mesh)
{
  return make_scene(
    mesh, false,
    [](Face) {
      return Rgb{{190, 208, 228}};
    },
    [](Edge) { return true; }, 1.1, 0.8);
}

// A triangulated copy of a polygon mesh, with the faces' labels.
inline Mesh triangulated(const Mesh& mesh, std::vector<std::size_t>& labels)
{
  struct Label_keeper : CGAL::Polygon_mesh_processing::Triangulate_faces::Default_visitor<Mesh>
  {
    std::vector<std::size_t>* labels;
    std::size_t current = 0;
    void before_subface_creations(Face f) { current = (*labels)[f]; }
    void after_subface_created(Face f)
    {
      if (f >= labels->size())
        labels->resize(f + 1);
      (*labels)[f] = current;
    }
  };
  Mesh copy = mesh;
  Label_keeper keeper;
  keeper.labels = &labels;
  CGAL::Polygon_mesh_processing::triangulate_faces(copy, CGAL::parameters::visitor(keeper));
  return copy;
}

// Shows a mesh with a color per cluster and lines between clusters.
inline Scene cluster_scene(const Mesh& polygon_mesh, std::vector<std::size_t> labels)
{
  const std::vector<std::size_t> colors = color_clusters(polygon_mesh, labels);
  const Mesh mesh = CGAL::is_triangle_mesh(polygon_mesh) ? polygon_mesh : triangulated(polygon_mesh, labels);
  return make_scene(
    mesh, true, [&](Face f) { return palette_color(colors[labels[f]]); },
    [&](Edge e) {
      return mesh.is_border(e) || labels[mesh.face(mesh.halfedge(e, 0))] != labels[mesh.face(mesh.halfedge(e, 1))];
    },
    1.2, 0.75);
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SCENE_H
