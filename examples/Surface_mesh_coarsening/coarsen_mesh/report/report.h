// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_REPORT_H
#define COARSEN_MESH_REPORT_H

#include "check/certificate.h"
#include "repair/fill_holes.h"
#include "report/Stage_times.h"
#include "report/quality.h"
#include "Options.h"
#include "coarsening.h"
#include "input.h"

#include <optional>
#include <string>

namespace coarsen_mesh_tool {

// The checks and measurements of a result.
struct Findings
{
  std::optional<Hole_filling> holes; // if requested
  std::optional<std::string> fault;  // the reason if the result is not valid
  Certificate certificate;
  std::optional<Measured_quality> quality; // if it was to be measured
  std::vector<std::string> warnings;
};

// Returns the report as JSON text.
std::string report_text(const Options& options, const Input& input, const Coarsening_result& result,
                        const Findings& findings, const Stage_times& times);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_REPORT_H
