// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SAME_FILE_H
#define COARSENING_SUPPORT_SAME_FILE_H

#include <filesystem>

namespace coarsening_support {

// Returns the file at the end of a chain of symbolic links, whether it exists or not.
std::filesystem::path end_of_links(const std::filesystem::path& file);

// Returns whether two names denote one file, now or after it has been written.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SAME_FILE_H
