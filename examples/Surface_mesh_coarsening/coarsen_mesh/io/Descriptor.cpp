// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Descriptor.h"

#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace coarsening_support {
namespace {

std::error_code last_error() { return std::error_code(errno ? errno : EIO, std::generic_category()); }

// Calls `attempt` until it returns a number from 0 on, or fails for another reason than a signal.
template <class Attempt>
ssize_t retried(const Attempt& attempt, const Stop& stop, std::error_code& error)
{
  for (;;) {
    errno = 0;
    const ssize_t result = attempt();
    if (result >= 0)
      return result;
    if (errno != EINTR) {
      error = last_error();
      return result;
    }
    if (stop)
      stop();
  }
}

} // namespace

Descriptor::Descriptor(const std::string& file, int flags, const Stop& stop, std::error_code& error)
{
  constexpr mode_t for_all = 0666; // less what the user's mask takes away
  const int standard = (flags & O_ACCMODE) == O_RDONLY ? STDIN_FILENO : STDOUT_FILENO;
  number_ = static_cast<int>(retried(
    [&]() -> ssize_t {
      return file == standard_stream ? ::fcntl(standard, F_DUPFD_CLOEXEC, 3) : ::open(file.c_str(), flags | O_CLOEXEC, for_all);
    },
    stop, error));
}

Descriptor::~Descriptor()
{
  if (number_ >= 0)
    ::close(number_);
}

std::size_t Descriptor::read(char* bytes, std::size_t most, const Stop& stop, std::error_code& error)
{
  const ssize_t result = retried([&] { return ::read(number_, bytes, most); }, stop, error);
  return result < 0 ? 0 : static_cast<std::size_t>(result);
}

void Descriptor::write(const std::string& bytes, const Stop& stop, std::error_code& error)
{
  for (std::size_t done = 0; done < bytes.size() && !error;) {
    const ssize_t written = retried([&] { return ::write(number_, bytes.data() + done, bytes.size() - done); }, stop, error);
    if (written == 0)
      error = last_error();
    else if (written > 0)
      done += static_cast<std::size_t>(written);
  }
}

void Descriptor::close(std::error_code& error)
{
  const int number = std::exchange(number_, -1);
  errno = 0;
  if (::close(number) != 0 && errno != EINTR)
    error = last_error();
}

} // namespace coarsening_support
