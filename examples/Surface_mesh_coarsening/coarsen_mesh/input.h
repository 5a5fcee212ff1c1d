// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_INPUT_H
#define COARSEN_MESH_INPUT_H

#include "io/Mesh.h"
#include "repair/repair.h"
#include "report/Stage_times.h"
#include "Options.h"
#include "Progress_line.h"

#include <cstddef>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

struct Input
{
  Mesh mesh;
  std::size_t points_in_file = 0, polygons_in_file = 0;
  std::size_t unused_points = 0; // removed unconditionally: they belong to no surface
  std::vector<Repair_step> repairs;
  std::size_t dropped_components = 0; // because they are small
  File_notes notes;
  std::vector<std::string> left_out; // fields of the file, in words
};

// Reads the input, repairs it and drops small components on request, and throws Failure unless it is an oriented 2-manifold.
Input read_input(const Options& options, Stage_times& times, Progress_line& progress);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_INPUT_H
