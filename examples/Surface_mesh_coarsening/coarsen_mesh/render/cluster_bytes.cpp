// SPDX-License-Identifier: GPL-3.0-or-later

#include "render/cluster_bytes.h"

#include "io/write_mesh.h"
#include "render/cluster_colors.h"

#include <CGAL/IO/Color.h>

#include <cstdint>

namespace coarsen_mesh_tool {

std::string cluster_bytes(const Mesh& mesh, const std::vector<std::size_t>& labels)
{
  Mesh painted = mesh; // CGAL writes the properties that belong to the mesh
  painted.remove_all_property_maps();
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
