// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_OUTPUT_OF_PROCESS_H
#define COARSENING_SUPPORT_OUTPUT_OF_PROCESS_H

#include "io/Text_scanner.h"

#include <cstddef>
#include <functional>
#include <string>

namespace coarsening_support {

// What a process may use up.
struct Process_limits
{
  std::size_t seconds, bytes;
};

// Returns what `work` returns in a process of its own. Throws Format_fault, with `name` as the place, if the process crashes or
// reaches its limits, or with the text of what `work` throws.
std::string output_of_process(const std::string& name, const Process_limits& limits, const std::function<std::string()>& work,
                              const Stop& stop);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_OUTPUT_OF_PROCESS_H
