// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_FILE_TYPE_H
#define COARSENING_SUPPORT_FILE_TYPE_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace coarsening_support {

inline std::string lower_case(std::string s)
{
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

inline std::string upper_case(std::string s)
{
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return s;
}

// Returns the file name's extension in lower case, without its dot.
inline std::string file_type(const std::string& file)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  return extension.empty() ? "" : lower_case(extension.substr(1));
}

// Of the formats that the program reads and writes by itself.
inline bool is_own_file_type(const std::string& type)
{
  return type == "off" || type == "obj" || type == "ply" || type == "stl";
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_FILE_TYPE_H
