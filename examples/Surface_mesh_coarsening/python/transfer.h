// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_TRANSFER_H
#define SURFACE_MESH_COARSENING_PYTHON_TRANSFER_H

#include "io/Mesh.h"

#include <CGAL/Surface_mesh_coarsening/Property_resampler.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coarsening_python {

using namespace coarsening_support;

enum class Element { VERTEX, FACE, CORNER };

// Values of elements of a mesh and of its coarse mesh, row by row. The rows of corners are in the order of the faces.
template <class Number>
struct Rows
{
  Element element;
  std::size_t columns;
  const Number* from;
  Number* to;
};

// Transfers values of the vertices, faces and corners of a mesh to its coarse mesh.
class Transfer
{
public:
  // `labels` has the cluster of each face. The meshes have to outlive the object.
  Transfer(const Mesh& mesh, const std::int64_t* labels, const Mesh& coarse);

  void interpolate(const Rows<double>& rows, CGAL::Surface_mesh_coarsening::Transfer_policy policy);

  // Labels of corners come from the nearest corner, others go by majority. They have one column.
  void vote(const Rows<std::int64_t>& rows);

  // Returns the nearest point of the mesh for each vertex of the coarse mesh. Coordinates begin at the first corner.
  std::vector<CGAL::Surface_mesh_coarsening::Surface_location<Mesh> > sources();

private:
  template <class Value, class Number>
  void transfer_corners(const Rows<Number>& rows);

  const Mesh& mesh_;
  const Mesh& coarse_;
  CGAL::Surface_mesh_coarsening::Property_resampler<Mesh, Mesh> resampler_;
};

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_TRANSFER_H
