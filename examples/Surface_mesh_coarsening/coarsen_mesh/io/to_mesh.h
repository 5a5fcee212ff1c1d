// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TO_MESH_H
#define COARSENING_SUPPORT_TO_MESH_H

#include "io/Edge_pairing.h"
#include "io/Mesh.h"
#include "io/Text_scanner.h"

namespace coarsening_support {

// Makes a mesh of a soup without faults; faces and vertices keep their numbers, and the halfedge of a face is that of its first
// side. Adding face by face, as CGAL's functions do, takes quadratic time where very many faces are around a vertex, or a face has
// very many sides.
Mesh to_mesh(const Soup& soup);

// The same where the edges are paired already.
Mesh to_mesh(const Soup& soup, const Edge_pairing& pairing, const Stop& stop = nullptr);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_TO_MESH_H
