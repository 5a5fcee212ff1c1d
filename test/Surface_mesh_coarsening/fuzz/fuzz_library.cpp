// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts bytes to a call of the library, see Library_input.h.

#include "Library_input.h"

#include <CGAL/assertions_behaviour.h>

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  fuzz::Library_input input(data, size);
  if (input.soup.points.size() > 400)
    return 0;
  if (std::getenv("FUZZ_PRINT"))
    fuzz::print(input.soup, input.parameters);
  input.check(input.parameters.number);
  return 0;
}
