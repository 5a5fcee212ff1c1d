// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FILE_BYTES_H
#define COARSENING_SUPPORT_FILE_BYTES_H

#include "io/Failure.h"

#include <cerrno>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace coarsening_support {

// Reads a regular file or a pipe to its end. `stop`, if there is one, is asked when a signal has interrupted the reading, and
// between pieces; it throws to give up.
inline std::string file_bytes(const std::string& file, const std::function<void()>& stop = nullptr)
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
  if (!is_pipe) {
    const auto size = std::filesystem::file_size(file, error);
    if (!error)
      content.reserve(static_cast<std::size_t>(size) + 1);
  }
  std::string piece(1 << 16, '\0');
  for (;;) {
    const ssize_t read = ::read(descriptor.number, &piece[0], piece.size());
    const int reason = errno;
    if (stop)
      stop();
    if (read < 0 && reason != EINTR)
      throw failure(reason);
    if (read == 0)
      break;
    if (read > 0)
      content.append(piece, 0, static_cast<std::size_t>(read));
  }
  if (content.empty())
    throw Failure(file, "is empty");
  return content;
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FILE_BYTES_H
