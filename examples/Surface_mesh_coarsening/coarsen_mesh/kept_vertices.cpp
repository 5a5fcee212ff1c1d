// SPDX-License-Identifier: GPL-3.0-or-later

#include "kept_vertices.h"

#include "io/Failure.h"
#include "io/Number_property.h"

namespace coarsen_mesh_tool {

std::vector<char> kept_vertices(const Mesh& input, const Options& options)
{
  if (!options.keep_borders && options.keep.empty())
    return {};
  std::vector<char> result(input.number_of_vertices(), false);
  if (options.keep_borders)
    for (const Halfedge h : input.halfedges())
      if (input.is_border(h))
        result[input.target(h)] = true;
  if (options.keep.empty())
    return result;
  const Number_property<Vertex> of_vertices = number_property<Vertex>(input, options.keep);
  const Number_property<Face> of_faces = number_property<Face>(input, options.keep);
  if (!of_vertices && !of_faces)
    throw Failure(options.input, "has no numbers '" + options.keep + "' of vertices or faces, which --keep names");
  if (of_vertices)
    for (const Vertex v : input.vertices())
      result[v] |= of_vertices(v) != 0;
  if (of_faces)
    for (const Face f : input.faces())
      for (const Vertex v : input.vertices_around_face(input.halfedge(f)))
        result[v] |= of_faces(f) != 0;
  return result;
}

} // namespace coarsen_mesh_tool
