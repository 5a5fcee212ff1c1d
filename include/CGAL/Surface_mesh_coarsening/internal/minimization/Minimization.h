// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_H

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The end of a minimization: after a number of rounds, or with the first round that lowers the energy by at most the
// relative amount `tolerance`.
struct Minimization_end
{
  std::size_t max_rounds = 0;
  double tolerance = 0;
};

// A minimization in progress, for any weight.
class Minimization
{
public:
  virtual ~Minimization() = default;
  // Runs one round. Returns the number of moves.
  virtual std::size_t round() = 0;
  virtual double energy() const = 0;
  // The number of edges tested so far.
  virtual std::size_t tests() const = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MINIMIZATION_MINIMIZATION_H
