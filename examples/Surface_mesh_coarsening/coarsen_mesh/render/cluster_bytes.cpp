// SPDX-License-Identifier: GPL-3.0-or-later

#include "render/cluster_bytes.h"

#include "io/write_ply.h"
#include "render/cluster_colors.h"

#include <CGAL/IO/Color.h>

#include <cstdint>

namespace coarsen_mesh_tool {

std::string cluster_bytes(const Mesh& mesh, const std::vector<std::size_t>& labels, const std::vector<double>& densities)
{
  Mesh painted = mesh;
  painted.remove_all_property_maps();
  auto red = painted.add_property_map<Face, std::uint8_t>("f:red").first;
  auto green = painted.add_property_map<Face, std::uint8_t>("f:green").first;
  auto blue = painted.add_property_map<Face, std::uint8_t>("f:blue").first;
  painted.add_property_map<Face, std::uint8_t>("f:alpha", 255);
  auto label = painted.add_property_map<Face, std::uint32_t>("f:label").first;
  auto density = painted.add_property_map<Face, double>("f:density").first;
  const std::vector<std::size_t> colors = color_clusters(mesh, labels);
  for (Face f : painted.faces()) {
    const Rgb c = palette_color(colors[labels[f]]);
    red[f] = c[0];
    green[f] = c[1];
    blue[f] = c[2];
    label[f] = static_cast<std::uint32_t>(labels[f]);
    density[f] = densities[f];
  }
  return ply_bytes(painted, File_notes());
}

} // namespace coarsen_mesh_tool
