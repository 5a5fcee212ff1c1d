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

// What was found out about a result.
struct Findings
{
  std::optional<Hole_filling> holes; // if they were to be filled
  std::optional<std::string> fault;  // what keeps the result from being valid, if anything does
  Certificate certificate;
  std::optional<Coarsening_quality> quality; // if it was to be measured
};

// Returns the report as JSON text.
std::string report_text(const Options& options, const Input& input, const Coarsening_result& result,
                        const Findings& findings, const Stage_times& times);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_REPORT_H
