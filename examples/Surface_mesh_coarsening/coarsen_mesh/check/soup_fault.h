// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SOUP_FAULT_H
#define COARSENING_SUPPORT_SOUP_FAULT_H

#include "io/Edge_pairing.h"
#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <optional>
#include <string>

namespace coarsening_support {

// Describes the first violation of an oriented 2-manifold in the soup, by the numbers of the elements in the file, from 0. If
// there is none, pairs the edges.
std::optional<std::string> soup_fault(const Soup& soup, std::optional<Edge_pairing>& pairing, const Stop& stop = nullptr);

std::optional<std::string> soup_fault(const Soup& soup);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SOUP_FAULT_H
