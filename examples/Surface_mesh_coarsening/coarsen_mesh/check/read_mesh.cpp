// SPDX-License-Identifier: GPL-3.0-or-later

#include "check/read_mesh.h"

#include "check/soup_fault.h"
#include "io/Failure.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"

namespace coarsening_support {

Mesh read_mesh(const std::string& file)
{
  Soup soup = read_soup(file);
  if (const auto fault = soup_fault(soup))
    throw Failure(file, "is not an oriented 2-manifold: " + *fault);
  drop_unused_points(soup);
  return to_mesh(soup);
}

} // namespace coarsening_support
