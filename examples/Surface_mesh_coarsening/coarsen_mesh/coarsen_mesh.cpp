// SPDX-License-Identifier: GPL-3.0-or-later
//
// coarsen_mesh: coarsens the mesh in a file. `coarsen_mesh --help` shows its usage.

#include "Interruption.h"
#include "run_and_report.h"

#include <csignal>

int main(int argc, char* argv[])
{
  // A closed pipe and a file above the size limit are failures to write, and must not end the program by a signal.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  coarsen_mesh_tool::Interruption::install();
  return coarsen_mesh_tool::run_and_report(argc, argv);
}
