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
  // What shells report for a program that the signal ended.
  int exit_status() const { return 128 + number; }
};

// The signals that users end programs with: SIGINT, SIGTERM and SIGHUP. They are noted, and the work ends at the next place
// where nothing is left half done. A second one ends the program on the spot, as long as it has not begun to write files.
class Interruption
{
public:
  // Signals that were ignored, as those of background jobs may be, stay so.
  static void install();

  static bool is_requested();
  static void throw_if_requested();

  // From now on a second signal does no more than the first.
  static void files_are_there();
};

// Holds the signals back as long as it lives, from the calling thread and from threads that it starts.
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
