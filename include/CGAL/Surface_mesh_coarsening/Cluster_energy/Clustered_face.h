// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_CLUSTERED_FACE_H
#define CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_CLUSTERED_FACE_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningEnergies
///
/// A face of a cluster, as passed to a `ClusterEnergy`. If features are kept, if parameter `subdivide_input` is set, or if whole
/// faces could not form the number of clusters, the face may be a part of a face of the mesh, or a polygon that joins parts of
/// several faces.
///
/// Coordinates are relative to a local origin near the center of the mesh. If the extent of the mesh is not in
/// \f$ [2^{-128}, 2^{128}] \f$, they are scaled by a power of two. Each function computes its value when it is called.
class Clustered_face
{
public:
  /// the kernel of points and vectors, independent of the kernel of the mesh
  typedef Simple_cartesian<double> Kernel;
  /// the type of points
  typedef Kernel::Point_3 Point_3;
  /// the type of vectors
  typedef Kernel::Vector_3 Vector_3;

  /// \cond SKIP_IN_MANUAL
  Clustered_face(const internal::Clustering_input& input, internal::Index face) : input_(input), face_(face) {}
  internal::Vector plain_centroid() const { return input_.centroid(face_); }
  internal::Vector plain_normal() const
  {
    const internal::Vector n = internal::vector_area(input_.mesh, face_);
    const double length = std::sqrt(internal::dot(n, n));
    if (!(length > 0))
      return {{0, 0, 0}};
    return {{n[0] / length, n[1] / length, n[2] / length}};
  }
  /// \endcond

  /// returns the number of the face of the mesh that contains this face, in the order of `faces(mesh)` or of parameter
  /// `face_index_map`. For a polygon that joins parts of several faces, the function returns the number of the first of these
  /// faces. In `coarsen_distributed_mesh()` the number has no meaning.
  std::size_t index() const { return input_.parent_of(face_); }
  /// returns the density.
  double density() const { return input_.density[face_]; }
  /// returns the area.
  double area() const { return input_.area[face_]; }
  /// returns the mass, which is density times area.
  double mass() const { return input_.mass(face_); }
  /// returns the centroid.
  Point_3 centroid() const
  {
    const internal::Vector p = plain_centroid();
    return Point_3(p[0], p[1], p[2]);
  }
  /// returns the unit normal; zero for a face without area.
  Vector_3 normal() const
  {
    const internal::Vector n = plain_normal();
    return Vector_3(n[0], n[1], n[2]);
  }

private:
  const internal::Clustering_input& input_;
  internal::Index face_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_CLUSTER_ENERGY_CLUSTERED_FACE_H
