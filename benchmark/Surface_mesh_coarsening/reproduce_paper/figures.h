// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REPRODUCE_PAPER_FIGURES_H
#define REPRODUCE_PAPER_FIGURES_H

#include "run_clustering.h"

#include <string>
#include <vector>

namespace reproduce_paper {

// Writes the figures for which this model stands into the directory and returns their names: 1b, 1c, 2, 3, 5 and 6 for the
// Bunny, 7 for the Fandisk. Figures 1a and 4 of the paper are sketches. `runs` holds the run of each of the paper's weights.
std::vector<std::string> write_figures(const Paper_model& model, const Mesh& mesh,
                                       const std::vector<Clustering_run>& runs, const std::string& directory);

} // namespace reproduce_paper

#endif // REPRODUCE_PAPER_FIGURES_H
