// SPDX-License-Identifier: GPL-3.0-or-later

#include "render/picture.h"

#include "render/png_bytes.h"
#include "render/render.h"

namespace coarsen_mesh_tool {

std::string picture_bytes(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& result,
                          const Vector& view, const Vector& up)
{
  const Camera camera(std::vector<Point>(input.points().begin(), input.points().end()), view, up, 900);
  return png_bytes(in_rows({{render(mesh_scene(result), camera), render(cluster_scene(input, labels), camera)}}));
}

} // namespace coarsen_mesh_tool
