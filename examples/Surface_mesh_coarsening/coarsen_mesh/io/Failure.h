// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FAILURE_H
#define COARSENING_SUPPORT_FAILURE_H

#include <stdexcept>
#include <string>
#include <string_view>

namespace coarsening_support {

// Says which file could not be treated as asked, and why.
class Failure : public std::runtime_error
{
public:
  Failure(const std::string& file, const std::string& reason) : std::runtime_error(file + ": " + reason) {}
};

// Writes bytes that are no printable ASCII character as \xNN, so that a file cannot tell a terminal what to do.
std::string escaped(std::string_view text);

// The same for what users write themselves, such as names of files: characters of other languages in UTF-8 stay.
std::string escaped_utf8(std::string_view text);

// Puts a text of several lines, such as the ones of CGAL's checks, on one line, and escapes it.
std::string one_line(const std::string& text);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FAILURE_H
