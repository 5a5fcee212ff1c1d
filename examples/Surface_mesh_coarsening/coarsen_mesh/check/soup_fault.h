// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SOUP_FAULT_H
#define COARSENING_SUPPORT_SOUP_FAULT_H

#include "io/Edge_pairing.h"
#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <optional>
#include <string>

namespace coarsening_support {

// Describes the first fault of the soup as an oriented 2-manifold. Elements are named by their numbers in the file, which count
// from 0, so that a user can find them there. If there is none, the edges are paired.
std::optional<std::string> soup_fault(const Soup& soup, std::optional<Edge_pairing>& pairing, const Stop& stop = nullptr);

std::optional<std::string> soup_fault(const Soup& soup);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SOUP_FAULT_H
