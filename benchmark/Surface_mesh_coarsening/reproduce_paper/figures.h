// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REPRODUCE_PAPER_FIGURES_H
#define REPRODUCE_PAPER_FIGURES_H

#include "run_clustering.h"

#include "render/Image.h"

#include <string>
#include <vector>

namespace reproduce_paper {

// Writes the panels as a file into the directory and returns its name.
std::string write_picture(const std::string& directory, const std::string& name, const std::vector<std::vector<Image> >& rows);

// Writes the figures of this model into the directory and returns their names: 1b, 1c, 2, 3, 5 and 6 for the Bunny, 7 for the
// Fandisk. `runs` holds the run of each of the paper's weights. `write_sketches()` draws the figures 1a and 4.
std::vector<std::string> write_figures(const Paper_model& model, const Mesh& mesh, const std::vector<Clustering_run>& runs,
                                       const std::string& directory);

} // namespace reproduce_paper

#endif // REPRODUCE_PAPER_FIGURES_H
