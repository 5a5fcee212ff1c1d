// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_STOPWATCH_H
#define COARSENING_BENCHMARK_STOPWATCH_H

#include <ctime>

namespace benchmark_support {

// Processor seconds since its construction.
class Stopwatch
{
public:
  double seconds() const { return double(std::clock() - begin_) / CLOCKS_PER_SEC; }

private:
  std::clock_t begin_ = std::clock();
};

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_STOPWATCH_H
