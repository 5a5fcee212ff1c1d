// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_FUZZ_BYTES_H
#define CGAL_SURFACE_MESH_COARSENING_FUZZ_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace fuzz {

// The bytes of a fuzzer's input, read one by one, and then zeros.
class Bytes
{
  const std::uint8_t* at;
  const std::uint8_t* end;

public:
  Bytes(const std::uint8_t* data, std::size_t size) : at(data), end(data + size) {}

  bool is_empty() const { return at == end; }
  std::size_t next() { return is_empty() ? 0 : *at++; }
  std::size_t next2() { return next() + 256 * next(); }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : (n <= 256 ? next() : next2()) % n; }
  std::string rest() const { return std::string(at, end); }
};

// Ends the fuzzer with a finding.
inline void require(bool condition, const std::string& what)
{
  if (condition)
    return;
  std::fprintf(stderr, "FINDING: %s\n", what.c_str());
  std::abort();
}

} // namespace fuzz

#endif // CGAL_SURFACE_MESH_COARSENING_FUZZ_BYTES_H
