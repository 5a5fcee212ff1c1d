// SPDX-License-Identifier: GPL-3.0-or-later
//
// coarsen_mesh: coarsens the mesh in a file. `coarsen_mesh --help` tells how it is used.

#include "Interruption.h"
#include "run_and_report.h"

#include <csignal>

int main(int argc, char* argv[])
{
  // A reader that goes away and a file that grows too large are failures to write, and no reason to die on the spot.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  coarsen_mesh_tool::Interruption::install();
  return coarsen_mesh_tool::run_and_report(argc, argv);
}
