// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/assimp/output_of_process.h"

#include "io/Failure.h"

#include <cerrno>
#include <csignal>
#include <exception>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace coarsening_support {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool bounds_memory = false; // the sanitizers map terabytes
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
constexpr bool bounds_memory = false;
#else
constexpr bool bounds_memory = true;
#endif
#else
constexpr bool bounds_memory = true;
#endif

[[noreturn]] void fail(const std::string& name, const char* what)
{
  throw Format_fault(name, std::string(what) + ": " + std::generic_category().message(errno));
}

void limit(int resource, std::size_t most)
{
  const rlimit both = {rlim_t(most), rlim_t(most)};
  setrlimit(decltype(RLIMIT_CPU)(resource), &both);
}

void write_all(int descriptor, const std::string& bytes)
{
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (written <= 0)
      return;
    done += std::size_t(written);
  }
}

// In the process: one letter tells whether a result or a message follows.
[[noreturn]] void run(int descriptor, const Process_limits& limits, const std::function<std::string()>& work)
{
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    std::signal(number, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    dup2(nowhere, standard);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
  if (bounds_memory)
    limit(RLIMIT_AS, limits.bytes);
  try {
    write_all(descriptor, "+" + work());
  } catch (const std::exception& e) {
    write_all(descriptor, std::string("-") + e.what());
  }
  _exit(0);
}

// A process that is killed at the end unless it has been waited for.
class Child
{
  pid_t number_;

public:
  explicit Child(pid_t number) : number_(number) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child()
  {
    if (number_ <= 0)
      return;
    kill(number_, SIGKILL);
    wait();
  }
  // Returns the status as of waitpid().
  int wait()
  {
    int status = 0;
    while (waitpid(number_, &status, 0) < 0 && errno == EINTR)
      ;
    number_ = 0;
    return status;
  }
};

class Reading_end
{
  int number_;

public:
  explicit Reading_end(int number) : number_(number) {}
  Reading_end(const Reading_end&) = delete;
  Reading_end& operator=(const Reading_end&) = delete;
  ~Reading_end() { close(number_); }

  std::string read_all(const std::string& name, const Stop& stop) const
  {
    constexpr int milliseconds = 50;
    std::string bytes;
    char some[1 << 16];
    for (;;) {
      if (stop)
        stop();
      pollfd ready = {number_, POLLIN, 0};
      if (poll(&ready, 1, milliseconds) <= 0)
        continue;
      const ssize_t size = read(number_, some, sizeof some);
      if (size < 0 && errno != EINTR)
        fail(name, "its result cannot be read");
      if (size == 0)
        return bytes;
      if (size > 0)
        bytes.append(some, std::size_t(size));
    }
  }
};

} // namespace

std::string output_of_process(const std::string& name, const Process_limits& limits, const std::function<std::string()>& work,
                              const Stop& stop)
{
  int ends[2];
  if (pipe(ends) != 0)
    fail(name, "cannot be run");
  const Reading_end reading_end(ends[0]);
  const pid_t number = fork();
  if (number == 0) {
    close(ends[0]);
    run(ends[1], limits, work);
  }
  close(ends[1]);
  if (number < 0)
    fail(name, "cannot be run");
  Child child(number);
  std::string bytes = reading_end.read_all(name, stop);
  const int status = child.wait();
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    throw Format_fault(name, "takes more than " + std::to_string(limits.seconds) + " seconds");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes.empty())
    throw Format_fault(name, "crashes" + (WIFSIGNALED(status) ? " with signal " + std::to_string(WTERMSIG(status)) : ""));
  if (bytes[0] == '-')
    throw Format_fault(name, one_line(bytes.substr(1)));
  bytes.erase(0, 1);
  return bytes;
}

} // namespace coarsening_support
