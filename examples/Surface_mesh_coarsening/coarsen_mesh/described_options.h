// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_DESCRIBED_OPTIONS_H
#define COARSEN_MESH_DESCRIBED_OPTIONS_H

#include <boost/program_options/options_description.hpp>

#include <string>
#include <vector>

namespace coarsen_mesh_tool {

// The angle of --features without a number.
constexpr const char* default_feature_angle = "30";

std::string joined(const std::vector<std::string>& names);

// All options in groups, with their defaults and their descriptions.
boost::program_options::options_description described_options();

// Prints the usage and the most important options in 25 lines, or all options.
void print_short_help();
void print_help(const boost::program_options::options_description& described);

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_DESCRIBED_OPTIONS_H
