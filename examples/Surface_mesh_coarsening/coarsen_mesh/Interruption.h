// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_INTERRUPTION_H
#define COARSEN_MESH_INTERRUPTION_H

#include <csignal>
#include <stdexcept>

namespace coarsen_mesh_tool {

// The user has asked the program to end.
class Interrupted : public std::runtime_error
{
  int number;

public:
  explicit Interrupted(int number);
  // The status that shells report for a program ended by the signal.
  int exit_status() const { return 128 + number; }
};

// Handles the signals by which users end programs: SIGINT, SIGTERM and SIGHUP. A signal is recorded, and the work ends at
// the next consistent state. A second one ends the program at once, unless it has begun to write files.
class Interruption
{
public:
  // Ignored signals, as of some background jobs, remain ignored.
  static void install();

  static bool is_requested();
  static void throw_if_requested();

  // From now on a second signal has no effect beyond the first.
  static void files_are_there();
};

// Blocks the signals during its lifetime, in the calling thread and in threads started by it.
class Deferred_interruption
{
  sigset_t before;

public:
  Deferred_interruption();
  ~Deferred_interruption();
  Deferred_interruption(const Deferred_interruption&) = delete;
  Deferred_interruption& operator=(const Deferred_interruption&) = delete;
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_INTERRUPTION_H
