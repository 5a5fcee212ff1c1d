// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FAILURE_H
#define COARSENING_SUPPORT_FAILURE_H

#include <stdexcept>
#include <string>
#include <string_view>

namespace coarsening_support {

// Names a file that could not be processed, and the reason.
class Failure : public std::runtime_error
{
public:
  Failure(const std::string& file, const std::string& reason) : std::runtime_error(file + ": " + reason) {}
};

// Writes bytes other than printable ASCII characters as \xNN, so that a file cannot control a terminal.
std::string escaped(std::string_view text);

// The same for the user's own text, such as names of files: keeps characters of other languages in UTF-8.
std::string escaped_utf8(std::string_view text);

// Joins the lines of a text, such as messages of CGAL's checks, and escapes it.
std::string one_line(const std::string& text);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FAILURE_H
