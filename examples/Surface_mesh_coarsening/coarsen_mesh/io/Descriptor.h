// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_DESCRIPTOR_H
#define COARSENING_SUPPORT_DESCRIPTOR_H

#include "io/Text_scanner.h"

#include <cstddef>
#include <string>
#include <system_error>

namespace coarsening_support {

// The name that stands for standard input and standard output.
constexpr const char* standard_stream = "-";

// An open file. What a signal interrupts is tried again, unless `stop` throws.
class Descriptor
{
  int number_ = -1;

public:
  // `flags` are those of open(). The standard stream is that for reading, or that for writing. Waits for the other end of a pipe.
  Descriptor(const std::string& file, int flags, const Stop& stop, std::error_code& error);
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();

  // Reads some bytes, none at the end.
  std::size_t read(char* bytes, std::size_t most, const Stop& stop, std::error_code& error);

  void write(const std::string& bytes, const Stop& stop, std::error_code& error);
  void close(std::error_code& error);
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_DESCRIPTOR_H
