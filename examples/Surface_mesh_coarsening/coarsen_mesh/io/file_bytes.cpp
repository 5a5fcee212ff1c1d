// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/file_bytes.h"

#include "io/Failure.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace coarsening_support {

std::string file_bytes(const std::string& file, const Stop& stop)
{
  const auto failure = [&file](int error) { return Failure(file, std::generic_category().message(error)); };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (error)
    throw Failure(file, error.message());
  if (std::filesystem::is_directory(status))
    throw Failure(file, "is a directory");
  const bool is_pipe = std::filesystem::is_fifo(status);
  if (!std::filesystem::is_regular_file(status) && !is_pipe)
    throw Failure(file, "is neither a regular file nor a pipe");

  struct Descriptor
  {
    int number = -1;
    ~Descriptor()
    {
      if (number >= 0)
        ::close(number);
    }
  } descriptor;
  while ((descriptor.number = ::open(file.c_str(), O_RDONLY | O_CLOEXEC)) < 0) { // waits for the other end of a pipe
    const int reason = errno;
    if (reason != EINTR)
      throw failure(reason);
    if (stop)
      stop();
  }

  std::string content;
  std::size_t size = 0, room = 1 << 16; // in bytes
  if (!is_pipe) {
    const auto known = std::filesystem::file_size(file, error);
    if (!error)
      room = static_cast<std::size_t>(known) + 1; // the end is found if there is room left
  }
  for (;;) {
    content.resize(size + room);
    while (size < content.size()) {
      constexpr std::size_t most = 1 << 22;
      const ssize_t read = ::read(descriptor.number, &content[size], (std::min)(content.size() - size, most));
      const int reason = errno;
      if (stop)
        stop();
      if (read < 0 && reason != EINTR)
        throw failure(reason);
      if (read > 0)
        size += static_cast<std::size_t>(read);
      if (read == 0) {
        content.resize(size);
        if (content.empty())
          throw Failure(file, "is empty");
        return content;
      }
    }
    room = (std::max)(size, std::size_t(1) << 16);
  }
}

} // namespace coarsening_support
