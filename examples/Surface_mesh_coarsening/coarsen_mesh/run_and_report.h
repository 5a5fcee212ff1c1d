// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_RUN_AND_REPORT_H
#define COARSEN_MESH_RUN_AND_REPORT_H

namespace coarsen_mesh_tool {

// Runs the program. Returns its exit status.
int run_and_report(int argc, char* argv[]);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_RUN_AND_REPORT_H
