// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORDS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORDS_H

#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The data that ranks exchange: numbers of 64 bits, which include the bits of coordinates.
typedef std::vector<std::uint64_t> Words;

inline std::uint64_t to_word(double x)
{
  std::uint64_t word;
  std::memcpy(&word, &x, sizeof word);
  return word;
}

inline double to_double(std::uint64_t word)
{
  double x;
  std::memcpy(&x, &word, sizeof x);
  return x;
}

inline std::uint64_t packed(std::uint32_t high, std::uint32_t low) { return (std::uint64_t(high) << 32) | low; }
inline std::uint32_t high_half(std::uint64_t word) { return std::uint32_t(word >> 32); }
inline std::uint32_t low_half(std::uint64_t word) { return std::uint32_t(word & 0xffffffffu); }

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORDS_H
