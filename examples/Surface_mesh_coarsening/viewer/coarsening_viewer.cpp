// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows a mesh, its clusters, the result and the error side by side, for a number of vertices, a weight and a placement that are
// chosen in the window:
//   coarsening_viewer [FILE [VERTICES]]

#include "Viewer_window.h"

#include "check/read_mesh.h"

#include <CGAL/Surface_mesh.h>

#include <QApplication>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  QApplication application(argc, argv);
  try {
    if (argc > 3)
      throw std::runtime_error("usage: coarsening_viewer [FILE [VERTICES]]");
    const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
    const coarsening_support::Mesh input = coarsening_support::read_mesh(file);
    const std::size_t vertices = argc > 2 ? std::stoul(argv[2]) : 0;
    coarsening_viewer::Viewer_window window(input, std::filesystem::path(file).filename().string(), vertices);
    window.show();
    return application.exec();
  } catch (const std::exception& e) {
    std::cerr << "coarsening_viewer: " << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
