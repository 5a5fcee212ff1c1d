// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_DEFERRED_INTERRUPTION_H
#define COARSEN_MESH_DEFERRED_INTERRUPTION_H

#include <csignal>

namespace coarsen_mesh_tool {

// Holds back the signals that users end programs with, as long as it lives, so that no half-written file is left. It acts
// on the calling thread, which must be the only one.
class Deferred_interruption
{
  sigset_t before;

public:
  Deferred_interruption()
  {
    sigset_t held_back;
    sigemptyset(&held_back);
    for (int signal : {SIGINT, SIGTERM, SIGHUP})
      sigaddset(&held_back, signal);
    pthread_sigmask(SIG_BLOCK, &held_back, &before);
  }

  ~Deferred_interruption() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }

  Deferred_interruption(const Deferred_interruption&) = delete;
  Deferred_interruption& operator=(const Deferred_interruption&) = delete;
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_DEFERRED_INTERRUPTION_H
