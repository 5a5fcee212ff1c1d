// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_MUTED_STREAMS_H
#define COARSENING_SUPPORT_MUTED_STREAMS_H

#include "io/Failure.h"

#include <iostream>
#include <sstream>
#include <string>

namespace coarsening_support {

// Captures std::cout and std::cerr during its lifetime.
class Muted_streams
{
  std::ostringstream said, complained;
  std::streambuf* out;
  std::streambuf* err;

public:
  Muted_streams() : out(std::cout.rdbuf(said.rdbuf())), err(std::cerr.rdbuf(complained.rdbuf())) {}
  Muted_streams(const Muted_streams&) = delete;
  Muted_streams& operator=(const Muted_streams&) = delete;

  ~Muted_streams()
  {
    std::cout.rdbuf(out);
    std::cerr.rdbuf(err);
  }

  // Returns the first nonempty line of std::cerr, without a leading "error".
  std::string first_complaint() const
  {
    std::istringstream lines(complained.str());
    for (std::string line; std::getline(lines, line);) {
      line = one_line(line);
      for (const char* prefix : {"Error: ", "error: "})
        if (line.compare(0, std::char_traits<char>::length(prefix), prefix) == 0) {
          line.erase(0, std::char_traits<char>::length(prefix));
          break;
        }
      if (!line.empty())
        return line;
    }
    return "";
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_MUTED_STREAMS_H
