// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_STOWED_HALFEDGES_H
#define COARSEN_MESH_STOWED_HALFEDGES_H

#include "io/Mesh.h"

#include <cstddef>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace coarsen_mesh_tool {

using namespace coarsening_support;

// Keeps the halfedges of a mesh in a quarter of their memory, from `stow()` until it is destroyed. Meanwhile the mesh only has
// faces and vertices with points. It must be a manifold without garbage and without properties of halfedges and edges.
class Stowed_halfedges
{
public:
  explicit Stowed_halfedges(Mesh& mesh) : mesh_(mesh) {}
  Stowed_halfedges(const Stowed_halfedges&) = delete;
  Stowed_halfedges& operator=(const Stowed_halfedges&) = delete;

  void stow()
  {
    next_.reserve(mesh_.number_of_halfedges());
    for (const Halfedge h : mesh_.halfedges())
      next_.push_back(mesh_.next(h));
    resize(0);
    mesh_.shrink_to_fit();
  }

  // Faces and vertices still know one of their halfedges.
  ~Stowed_halfedges()
  {
    if (next_.empty())
      return;
#ifdef __GLIBC__
    malloc_trim(0); // otherwise, arrays freed before would remain in memory besides
#endif
    resize(next_.size() / 2);
    for (const Halfedge h : mesh_.halfedges())
      mesh_.set_next(h, next_[h]);
    for (const Face f : mesh_.faces())
      for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f)))
        mesh_.set_face(h, f);
    for (const Vertex v : mesh_.vertices())
      if (!mesh_.is_isolated(v))
        for (const Halfedge h : mesh_.halfedges_around_target(mesh_.halfedge(v)))
          mesh_.set_target(h, v);
  }

private:
  void resize(std::size_t edges)
  {
    mesh_.resize(mesh_.number_of_vertices(), Mesh::size_type(edges), mesh_.number_of_faces());
  }

  Mesh& mesh_;
  std::vector<Halfedge> next_; // of each halfedge
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_STOWED_HALFEDGES_H
