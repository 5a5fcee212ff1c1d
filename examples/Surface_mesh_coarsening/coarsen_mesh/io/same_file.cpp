// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/same_file.h"

#include <system_error>

namespace coarsening_support {

namespace fs = std::filesystem;

fs::path end_of_links(const fs::path& file)
{
  fs::path end = file;
  std::error_code error;
  for (int links = 0; fs::is_symlink(end, error); ++links) {
    const fs::path target = fs::read_symlink(end, error);
    constexpr int most_links = 40; // the system's limit
    if (error || links == most_links)
      return file; // which the system refuses to open
    end = target.is_absolute() ? target : end.parent_path() / target;
  }
  return end;
}

bool is_same_file(const fs::path& a, const fs::path& b)
{
  std::error_code error;
  if (fs::equivalent(a, b, error))
    return true;
  const auto name = [](const fs::path& file) {
    std::error_code failed;
    const fs::path result = fs::weakly_canonical(fs::absolute(end_of_links(file), failed), failed);
    return failed ? file.lexically_normal() : result;
  };
  return name(a) == name(b);
}

} // namespace coarsening_support
