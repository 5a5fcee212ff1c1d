// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_EXPORT_FORMAT_H
#define COARSENING_SUPPORT_EXPORT_FORMAT_H

#include <optional>
#include <string>

namespace coarsening_support {

// The name by which Assimp writes files with this ending: of several, the newest version, and binary rather than text.
std::optional<std::string> export_format(const std::string& type);

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_EXPORT_FORMAT_H
