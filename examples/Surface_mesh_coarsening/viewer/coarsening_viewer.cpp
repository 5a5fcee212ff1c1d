// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows clusters and result of a mesh in a window, where keys change weight, level of the seeds and placement:
//   coarsening_viewer [--try] [FILE]
// With --try it simulates its keys one after the other, prints the state, and ends.

#include "io/Mesh.h"
#include "render/cluster_colors.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <QApplication>
#include <QKeyEvent>
#include <QTimer>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace coarsening_support;

const std::array<const char*, 4> weight_names = {{"uniform", "area", "maximum", "variance"}};
const std::array<const char*, 4> placement_names = {{"centroid", "closest vertex", "quadric", "fitted"}};

struct Choice
{
  std::size_t weight = 1, placement = 3;
  std::size_t level = 5;
};

struct Coarse
{
  std::vector<std::size_t> labels;
  Mesh mesh;
};

template <class Weight>
Coarse coarsened_with(const Mesh& input, const Choice& choice, double maximum_density)
{
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(input, SMC::parameters::maximum_density(maximum_density));
  clustering.seed_from_level(choice.level);
  clustering.grow();
  clustering.minimize();
  Coarse result;
  switch (choice.placement) {
  case 0: clustering.extract_embedded_dual_mesh(result.mesh, SMC::Centroid_placement()); break;
  case 1: clustering.extract_embedded_dual_mesh(result.mesh, SMC::Closest_vertex_placement()); break;
  case 2: clustering.extract_embedded_dual_mesh(result.mesh, SMC::Quadric_placement()); break;
  default: clustering.extract_embedded_dual_mesh(result.mesh, SMC::Fitted_placement());
  }
  for (Face f : input.faces())
    result.labels.push_back(clustering.cluster(f));
  return result;
}

Coarse coarsened(const Mesh& input, const Choice& choice)
{
  switch (choice.weight) {
  case 0: return coarsened_with<SMC::Uniform_weight>(input, choice, 1);
  case 1: return coarsened_with<SMC::Weighted_area_weight>(input, choice, SMC::Coarsening_defaults::maximum_density);
  case 2: return coarsened_with<SMC::Maximum_density_weight>(input, choice, SMC::Coarsening_defaults::maximum_density);
  default: return coarsened_with<SMC::Density_variance_weight>(input, choice, 3);
  }
}

class Coarsening_viewer : public CGAL::Basic_viewer_qt
{
  typedef CGAL::Basic_viewer_qt Base;

  const Mesh& input;
  Choice choice;
  Coarse coarse;
  bool shows_clusters = true;

public:
  explicit Coarsening_viewer(const Mesh& input)
    : Base(nullptr, "Surface mesh coarsening"),
      input(input)
  {
    coarsen();
    fill();
  }

  std::string description() const
  {
    return std::string(shows_clusters ? "clusters" : "result") + ", " + std::to_string(coarse.mesh.number_of_vertices()) +
           " vertices, weight " + weight_names[choice.weight] + ", level " + std::to_string(choice.level) + ", placement " +
           placement_names[choice.placement];
  }

private:
  void coarsen() { coarse = coarsened(input, choice); }

  void fill()
  {
    clear();
    if (shows_clusters)
      add_clusters();
    else
      add_mesh(coarse.mesh, [](Face) { return Rgb{{190, 208, 228}}; }, [](Edge) { return true; });
    setWindowTitle(QString::fromStdString(description()));
  }

  void add_clusters()
  {
    const std::vector<std::size_t> colors = color_clusters(input, coarse.labels);
    const auto label = [&](Edge e, unsigned side) { return coarse.labels[input.face(input.halfedge(e, side))]; };
    add_mesh(input, [&](Face f) { return palette_color(colors[coarse.labels[f]]); },
             [&](Edge e) { return input.is_border(e) || label(e, 0) != label(e, 1); });
  }

  template <class Color, class Drawn>
  void add_mesh(const Mesh& mesh, const Color& color, const Drawn& is_drawn)
  {
    for (Face f : mesh.faces()) {
      const Rgb c = color(f);
      face_begin(CGAL::IO::Color(c[0], c[1], c[2]));
      for (Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        add_point_in_face(mesh.point(v));
      face_end();
    }
    for (Edge e : mesh.edges())
      if (is_drawn(e))
        add_segment(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  }

  // Returns whether the key is bound.
  bool change(int key, Choice& changed)
  {
    switch (key) {
    case ::Qt::Key_D: shows_clusters = !shows_clusters; return true;
    case ::Qt::Key_W: changed.weight = (choice.weight + 1) % weight_names.size(); return true;
    case ::Qt::Key_P: changed.placement = (choice.placement + 1) % placement_names.size(); return true;
    case ::Qt::Key_L: changed.level = choice.level + 1; return true;
    case ::Qt::Key_K: changed.level = choice.level > 0 ? choice.level - 1 : 0; return true;
    default: return false;
    }
  }

protected:
  void keyPressEvent(QKeyEvent* e) override
  {
    Choice changed = choice;
    if (e->modifiers() != ::Qt::NoModifier || !change(e->key(), changed)) {
      Base::keyPressEvent(e);
      return;
    }
    std::swap(choice, changed);
    try {
      if (e->key() != ::Qt::Key_D)
        coarsen();
      fill();
      redraw();
    } catch (const SMC::Invalid_input& fault) { // keeps its state
      std::swap(choice, changed);
      displayMessage(fault.what());
    }
  }

  QString helpString() const override
  {
    return QString("<h2>Surface mesh coarsening</h2><b>D</b>: clusters or result<br/><b>W</b>: next weight<br/>"
                   "<b>L</b>, <b>K</b>: higher or lower level of the seeds, so fewer or more vertices<br/>"
                   "<b>P</b>: next placement<br/>") +
           Base::helpString();
  }
};

// Simulates the keys one after the other, each after the window has been drawn, and ends.
void press(QApplication& app, Coarsening_viewer& viewer, std::string keys)
{
  std::cout << viewer.description() << std::endl;
  if (keys.empty()) {
    app.quit();
    return;
  }
  QKeyEvent event(QEvent::KeyPress, keys.front(), ::Qt::NoModifier);
  QApplication::sendEvent(&viewer, &event);
  QTimer::singleShot(100, &viewer, [&app, &viewer, keys] { press(app, viewer, keys.substr(1)); });
}

} // namespace

int main(int argc, char* argv[])
{
  CGAL::Qt::init_ogl_context(4, 3);
  QApplication app(argc, argv);
  const bool is_trial = argc > 1 && std::string(argv[1]) == "--try";
  const int at = is_trial ? 2 : 1;
  const std::string name = argc > at ? argv[at] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  try {
    Coarsening_viewer viewer(input);
    viewer.show();
    if (is_trial)
      QTimer::singleShot(500, &viewer, [&] { press(app, viewer, "DPPPWWLK"); });
    return app.exec();
  } catch (const std::exception& e) {
    std::cerr << "coarsening_viewer: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
