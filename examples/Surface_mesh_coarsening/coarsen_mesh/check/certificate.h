// SPDX-License-Identifier: GPL-3.0-or-later
//
// The topology of a mesh before and after coarsening, component by component. Everything is counted from the two meshes; only
// the labels, which tell the components' partners, are taken from the coarsening itself.

#ifndef COARSENING_SUPPORT_CERTIFICATE_H
#define COARSENING_SUPPORT_CERTIFICATE_H

#include "io/Mesh.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coarsening_support {

struct Component_counts
{
  std::size_t vertices = 0, edges = 0, faces = 0, border_loops = 0;

  long long euler_characteristic() const
  {
    return static_cast<long long>(vertices) - static_cast<long long>(edges) + static_cast<long long>(faces);
  }

  // Of an orientable surface, which every mesh with halfedges is.
  long long genus() const { return (2 - euler_characteristic() - static_cast<long long>(border_loops)) / 2; }
};

struct Mesh_components
{
  std::vector<Component_counts> counts; // in the order of their first faces
  std::vector<std::size_t> of_face, of_vertex;
};

// Counts a mesh without removed elements, component by component.
Mesh_components mesh_components(const Mesh& mesh);

Soup to_soup(const Mesh& mesh);

// Describes what keeps the mesh from being a simplicial, oriented 2-manifold triangle mesh without isolated vertices.
std::optional<std::string> triangle_mesh_fault(const Mesh& mesh);

struct Certificate
{
  struct Pair
  {
    Component_counts before;
    std::optional<Component_counts> after; // empty when nothing of the component is left
    bool dropped = false;                  // on purpose: its faces carry the label one past the last
    bool kept() const
    {
      return after && before.genus() == after->genus() && before.border_loops == after->border_loops;
    }
  };
  std::vector<Pair> components;
  bool one_to_one = true; // no component was split, joined or added, nor more or fewer dropped than should be
  bool orientation_kept = true;

  bool kept() const
  {
    return one_to_one && orientation_kept &&
           std::all_of(components.begin(), components.end(), [](const Pair& p) { return p.kept() || p.dropped; });
  }
};

// Compares the topology of the coarse mesh with the input's. Vertex `i` of the output stands for the label `i`; faces of
// components that were left out, `dropped_components` of them, have the number of vertices as their label. Where faces had
// to be cut, their labels are those of their largest parts; these do not say where three clusters meet.
Certificate certify(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& output,
                    std::size_t dropped_components = 0, bool faces_are_whole = true);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_CERTIFICATE_H
