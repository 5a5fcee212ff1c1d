// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_REPORT_H
#define COARSEN_MESH_REPORT_H

#include "support/Stage_times.h"
#include "support/certificate.h"
#include "Options.h"
#include "coarsening.h"
#include "input.h"

#include <optional>
#include <string>

namespace coarsen_mesh_tool {

// Returns the report as JSON text. `fault` is what keeps the result from being valid, if anything does.
std::string report_text(const Options& options, const Input& input, const Coarsening_result& result,
                        const std::optional<std::string>& fault, const Certificate& certificate,
                        const Stage_times& times);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_REPORT_H
