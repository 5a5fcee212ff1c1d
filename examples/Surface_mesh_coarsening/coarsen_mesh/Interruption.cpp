// SPDX-License-Identifier: GPL-3.0-or-later

#include "Interruption.h"

#include <string>

namespace coarsen_mesh_tool {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t requested = 0; // the number of the signal
volatile std::sig_atomic_t has_files = 0;

extern "C" void note_signal(int number)
{
  if (requested != 0 && has_files == 0) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
  requested = number;
}

std::string name_of(int number) { return number == SIGINT ? "SIGINT" : number == SIGTERM ? "SIGTERM" : "SIGHUP"; }

} // namespace

Interrupted::Interrupted(int number)
  : std::runtime_error("interrupted by " + name_of(number) + ", no file was written"),
    number(number)
{}

void Interruption::install()
{
  for (int number : signals) {
    struct sigaction before, action = {};
    action.sa_handler = note_signal; // without SA_RESTART: waiting for a pipe ends
    sigemptyset(&action.sa_mask);
    if (sigaction(number, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      sigaction(number, &action, nullptr);
  }
}

bool Interruption::is_requested() { return requested != 0; }

void Interruption::throw_if_requested()
{
  if (is_requested())
    throw Interrupted(requested);
}

void Interruption::files_are_there() { has_files = 1; }

Deferred_interruption::Deferred_interruption()
{
  sigset_t held_back;
  sigemptyset(&held_back);
  for (int number : signals)
    sigaddset(&held_back, number);
  pthread_sigmask(SIG_BLOCK, &held_back, &before);
}

Deferred_interruption::~Deferred_interruption() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }

} // namespace coarsen_mesh_tool
