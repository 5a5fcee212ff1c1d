// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common functions of the pictures of the manual.

#ifndef COARSENING_PICTURES_PICTURE_KIT_H
#define COARSENING_PICTURES_PICTURE_KIT_H

#include "Composition.h"

#include "render/Scene.h"
#include "render/render.h"

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_pictures {

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace coarsening_support;

typedef std::vector<std::size_t> Labels;

const std::size_t fandisk_vertices = 527;

struct Setting
{
  std::filesystem::path meshes, directory;
};

// Pictures by file name.
typedef std::vector<std::pair<std::string, std::function<void(const Setting&)> > > Pictures;

Pictures pictures_of_the_method();
Pictures pictures_of_features_and_borders();
Pictures pictures_of_what_comes_next();
Pictures pictures_of_refinement();
Pictures pictures_of_ranks();
Pictures plots();

inline Mesh read(const Setting& setting, const std::string& name)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh((setting.meshes / name).string(), mesh))
    throw std::runtime_error("cannot read " + (setting.meshes / name).string());
  return mesh;
}

inline std::string rounded(double value, int digits)
{
  std::ostringstream os;
  os.precision(digits);
  os << std::fixed << value;
  return os.str();
}

// With a space between thousands.
inline std::string counted(std::size_t number)
{
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3)
    digits.insert(i - 3, ",");
  return digits;
}

inline std::string vertices_of(const Mesh& mesh) { return counted(mesh.number_of_vertices()) + " vertices"; }

inline Camera camera_for(const Mesh& mesh, const Vector& view, const Vector& up, double panel_size = 300)
{
  return Camera(std::vector<Point>(mesh.points().begin(), mesh.points().end()), view, up, resolution * panel_size);
}

// Lines are as wide as on a picture of the panel's size.
inline Image drawn(Scene scene, const Camera& camera)
{
  for (Scene::Line& line : scene.lines)
    line.width *= resolution;
  return render(scene, camera);
}

inline Camera fandisk_camera(const Mesh& mesh, double panel_size = 300)
{
  return camera_for(mesh, Vector(1, 0.5, 0.8), Vector(0, 1, 0), panel_size);
}

template <class Clustering>
Labels labels_of(const Mesh& mesh, const Clustering& clustering)
{
  Labels labels;
  for (Face f : mesh.faces())
    labels.push_back(clustering.cluster(f));
  return labels;
}

// A result with its clusters.
struct Coarse
{
  Mesh mesh;
  Labels labels;
};

template <class Weight, class Placement = SMC::Centroid_placement>
Coarse coarsened(const Mesh& input, std::size_t vertices, double maximum_density, const Placement& placement = Placement())
{
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(input, SMC::parameters::maximum_density(maximum_density));
  clustering.seed(vertices);
  clustering.grow();
  clustering.minimize();
  Coarse result;
  clustering.extract_dual_mesh(result.mesh, placement);
  result.labels = labels_of(input, clustering);
  return result;
}

inline bool any_edge(Edge) { return true; }
inline bool no_edge(Edge) { return false; }

inline Rgb pale(Face) { return Rgb{{205, 212, 222}}; }
inline Rgb bluish(Face) { return Rgb{{190, 208, 228}}; }

// The edges of a polygon mesh, without the diagonals of its triangulation.
inline Image polygons(const Mesh& mesh, const Camera& camera)
{
  Labels faces;
  for (Face f : mesh.faces())
    faces.push_back(f);
  const Mesh triangles = triangulated(mesh, faces);
  const auto is_drawn = [&](Edge e) {
    return triangles.is_border(e) ||
           faces[triangles.face(triangles.halfedge(e, 0))] != faces[triangles.face(triangles.halfedge(e, 1))];
  };
  return drawn(make_scene(triangles, true, pale, is_drawn, 0.7, 0.55), camera);
}

// Draws further edges, bold and black.
inline void add_bold(Scene& scene, const Mesh& mesh, const std::function<bool(Edge)>& is_bold, double width = 2.6)
{
  for (Edge e : mesh.edges())
    if (is_bold(e))
      scene.lines.push_back({mesh.vertex(e, 0), mesh.vertex(e, 1), width, 1.});
}

} // namespace coarsening_pictures

#endif // COARSENING_PICTURES_PICTURE_KIT_H
