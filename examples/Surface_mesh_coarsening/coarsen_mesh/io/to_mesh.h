// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TO_MESH_H
#define COARSENING_SUPPORT_TO_MESH_H

#include "io/Edge_pairing.h"
#include "io/Mesh.h"
#include "io/Text_scanner.h"

namespace coarsening_support {

// Builds a mesh from a valid soup; faces and vertices keep their numbers, and the halfedge of a face belongs to its first
// side. CGAL's functions add face by face, which takes quadratic time for vertices of very high valence and for faces with
// very many sides.
Mesh to_mesh(const Soup& soup);

// The same where the edges are paired already.
Mesh to_mesh(const Soup& soup, const Edge_pairing& pairing, const Stop& stop = nullptr);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_TO_MESH_H
