// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REPRODUCE_PAPER_PAPER_MODEL_H
#define REPRODUCE_PAPER_PAPER_MODEL_H

#include "io/Mesh.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reproduce_paper {

using namespace coarsening_support;

// The paper's three weights, in the order of its Table 1.
enum Paper_weight
{
  AREA,
  MAXIMUM,
  VARIANCE
};
constexpr std::array<Paper_weight, 3> paper_weights = {AREA, MAXIMUM, VARIANCE};
constexpr std::array<const char*, 3> weight_names = {"area", "maximum", "variance"};

// A column of Table 1: a model, its parameters, and the paper's results.
struct Paper_model
{
  std::string name;
  std::vector<std::string> files; // its possible names; none for the generated model
  std::size_t vertices;
  unsigned level;
  std::size_t seeds;
  std::string seeding_seconds;
  std::array<double, 3> maximum_density; // per weight
  std::array<double, 3> seconds;         // per weight, on a PC of 3 GHz
};

const std::vector<Paper_model>& paper_models();

// A cube of side 1 whose sides are `n` by `n` squares, each divided into two triangles.
Mesh triangulated_cube(std::size_t n);

// Finds the file of the model among files and in directories.
std::optional<std::string> find_model(const Paper_model& model, const std::vector<std::string>& places);

// Reads the model's file, without the points that no face uses, or generates the model. Throws Failure if the file does
// not hold an oriented 2-manifold.
Mesh load_model(const Paper_model& model, const std::string& file);

} // namespace reproduce_paper

#endif // REPRODUCE_PAPER_PAPER_MODEL_H
