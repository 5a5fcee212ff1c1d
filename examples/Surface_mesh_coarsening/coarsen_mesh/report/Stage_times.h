// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_STAGE_TIMES_H
#define COARSENING_SUPPORT_STAGE_TIMES_H

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_support {

// Adds up wall-clock seconds per named stage, in the order in which the stages first began.
class Stage_times
{
  using Clock = std::chrono::steady_clock;
  std::vector<std::pair<std::string, double> > stages;
  std::string current;
  Clock::time_point since, birth = Clock::now();

  static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

  double& entry(const std::string& stage)
  {
    for (auto& s : stages)
      if (s.first == stage)
        return s.second;
    stages.emplace_back(stage, 0.);
    return stages.back().second;
  }

public:
  // Begins a stage and ends the previous one.
  void begin(const std::string& stage)
  {
    end();
    entry(stage);
    current = stage;
    since = Clock::now();
  }

  void end()
  {
    if (!current.empty())
      entry(current) += seconds(Clock::now() - since);
    current.clear();
  }

  const std::vector<std::pair<std::string, double> >& all() const { return stages; }

  // Returns the seconds since the construction of this object.
  double total() const { return seconds(Clock::now() - birth); }

  // Returns the sum over the named stages.
  double sum(const std::vector<std::string>& names) const
  {
    double result = 0;
    for (const auto& s : stages)
      for (const std::string& name : names)
        if (s.first == name)
          result += s.second;
    return result;
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_STAGE_TIMES_H
