// SPDX-License-Identifier: GPL-3.0-or-later
//
// The topology of a mesh before and after coarsening, component by component. All counts come from the two meshes; the
// coarsening contributes only the labels, which map components to each other.

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

// Describes why the mesh is no simplicial, oriented 2-manifold triangle mesh without isolated vertices.
std::optional<std::string> triangle_mesh_fault(const Mesh& mesh);

struct Certificate
{
  struct Pair
  {
    Component_counts before;
    std::optional<Component_counts> after; // empty if the component is missing
    bool orientation_kept = true;
    bool kept() const
    {
      return after && orientation_kept && before.genus() == after->genus() && before.border_loops == after->border_loops;
    }
  };
  std::vector<Pair> components; // in the order of their first faces
  bool one_to_one = true;       // components correspond one to one

  // Describes the first change of the topology.
  std::optional<std::string> change() const;
  bool kept() const { return !change(); }
  bool orientation_kept() const
  {
    return std::all_of(components.begin(), components.end(), [](const Pair& p) { return p.orientation_kept; });
  }
};

// Compares the topology of the coarse mesh with the input's. Vertex `i` of the output represents label `i`. A face divided
// between clusters has the label of its largest part; such labels do not show the order of neighbors, so the orientation is not
// compared then.
Certificate certify(const Mesh& input, const std::vector<std::size_t>& labels, const Mesh& output,
                    bool faces_are_whole = true);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_CERTIFICATE_H
