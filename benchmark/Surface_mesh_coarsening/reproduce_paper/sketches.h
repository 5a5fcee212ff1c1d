// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REPRODUCE_PAPER_SKETCHES_H
#define REPRODUCE_PAPER_SKETCHES_H

#include <string>
#include <vector>

namespace reproduce_paper {

// Writes figures 1a and 4 of the paper, which show small patches, into the directory and returns their names. The captions of
// figure 4 state the answers of this package: of the check in section 7, and of the test whether both clusters remain discs.
std::vector<std::string> write_sketches(const std::string& directory);

} // namespace reproduce_paper

#endif // REPRODUCE_PAPER_SKETCHES_H
