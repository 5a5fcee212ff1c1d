// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/file_bytes.h"

#include "io/Descriptor.h"
#include "io/Failure.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include <fcntl.h>

namespace coarsening_support {

namespace {

// Throws Failure if the name stands for nothing that can be read. Returns the size of a regular file in bytes, 0 of a stream.
std::size_t size_of_file(const std::string& file)
{
  if (file == standard_stream)
    return 0;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (error)
    throw Failure(file, error.message());
  if (std::filesystem::is_directory(status))
    throw Failure(file, "is a directory");
  if (std::filesystem::is_fifo(status))
    return 0;
  if (!std::filesystem::is_regular_file(status))
    throw Failure(file, "is neither a regular file nor a pipe");
  const auto size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<std::size_t>(size);
}

} // namespace

std::string file_bytes(const std::string& file, const Stop& stop)
{
  const std::string name = file == standard_stream ? "standard input" : file;
  constexpr std::size_t least_room = 1 << 16, most_at_a_time = 1 << 22;
  std::size_t room = (std::max)(size_of_file(file) + 1, least_room); // the end is found when there is room left
  std::error_code error;
  Descriptor descriptor(file, O_RDONLY, stop, error);
  if (error)
    throw Failure(name, error.message());
  std::string content;
  for (std::size_t size = 0;; room = (std::max)(size, least_room)) {
    content.resize(size + room);
    while (size < content.size()) {
      const std::size_t read = descriptor.read(&content[size], (std::min)(content.size() - size, most_at_a_time), stop, error);
      if (stop)
        stop();
      if (error)
        throw Failure(name, error.message());
      size += read;
      if (read > 0)
        continue;
      content.resize(size);
      if (content.empty())
        throw Failure(name, "is empty");
      return content;
    }
  }
}

} // namespace coarsening_support
