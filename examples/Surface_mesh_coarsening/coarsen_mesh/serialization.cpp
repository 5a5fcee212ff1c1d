// SPDX-License-Identifier: GPL-3.0-or-later

#include "serialization.h"

#include "support/Failure.h"
#include "support/cluster_colors.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/STL.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>
#include <CGAL/boost/graph/IO/PLY.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <ios>
#include <sstream>

namespace coarsen_mesh_tool {

std::string mesh_bytes(const Mesh& mesh, const std::string& type)
{
  std::ostringstream os(std::ios::out | std::ios::binary);
  os.precision(17);
  const auto np = CGAL::parameters::stream_precision(17);
  bool done = false;
  if (type == "off")
    done = CGAL::IO::write_OFF(os, mesh, np);
  else if (type == "obj")
    done = CGAL::IO::write_OBJ(os, mesh, np);
  else {
    CGAL::IO::set_binary_mode(os);
    done = type == "ply" ? CGAL::IO::write_PLY(os, mesh) : CGAL::IO::write_STL(os, mesh);
  }
  if (!done || !os)
    throw Failure("the result", "cannot be written as " + type);
  return os.str();
}

std::string cluster_bytes(const Mesh& mesh, const std::vector<std::size_t>& labels)
{
  Mesh painted = mesh; // CGAL writes the properties that belong to the mesh
  auto color = painted.add_property_map<Face, CGAL::IO::Color>("f:color").first;
  auto label = painted.add_property_map<Face, std::uint32_t>("f:label").first;
  const std::vector<std::size_t> colors = color_clusters(mesh, labels);
  for (Face f : painted.faces()) {
    const Rgb c = palette_color(colors[labels[f]]);
    color[f] = CGAL::IO::Color(c[0], c[1], c[2]);
    label[f] = static_cast<std::uint32_t>(labels[f]);
  }
  return mesh_bytes(painted, "ply");
}

} // namespace coarsen_mesh_tool
