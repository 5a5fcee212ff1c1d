// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FAILURE_H
#define COARSENING_SUPPORT_FAILURE_H

#include <stdexcept>
#include <string>

namespace coarsening_support {

// Puts a text of several lines, such as the ones of CGAL's checks, on one line without control characters.
inline std::string one_line(const std::string& text)
{
  std::string line;
  for (char c : text)
    if (c == '\n' || c == '\r' || c == '\t' || c == ' ') {
      if (!line.empty() && line.back() != ' ')
        line += ' ';
    } else
      line += (static_cast<unsigned char>(c) < 32 || c == 127) ? '?' : c;
  while (!line.empty() && line.back() == ' ')
    line.pop_back();
  return line;
}

// Says which file could not be treated as asked, and why.
class Failure : public std::runtime_error
{
public:
  Failure(const std::string& file, const std::string& reason) : std::runtime_error(file + ": " + reason) {}
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FAILURE_H
