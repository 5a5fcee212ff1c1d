// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_RANDOM_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_RANDOM_H

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>

namespace attack {

// The random numbers of one case: seed and number of the case determine them on all platforms. Distributions differ between
// standard libraries, so only the bits of the engine are used.
class Random
{
public:
  Random(std::uint64_t seed, std::uint64_t case_number)
  {
    std::seed_seq numbers{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(case_number),
                          std::uint32_t(case_number >> 32)};
    engine_.seed(numbers);
  }

  std::mt19937& engine() { return engine_; }
  std::size_t below(std::size_t n) { return engine_() % n; }
  bool one_in(std::size_t n) { return below(n) == 0; }
  double between(double low, double high) { return low + (high - low) * (double(engine_()) / 4294967295.); }

  template <class Choice>
  Choice pick(std::initializer_list<Choice> choices)
  {
    return choices.begin()[below(choices.size())];
  }

  std::string bytes(std::size_t n)
  {
    std::string result;
    while (result.size() < n)
      result += char(below(256));
    return result;
  }

private:
  std::mt19937 engine_;
};

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_RANDOM_H
