// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_comments.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace coarsening_support {
namespace {

constexpr std::string_view blanks = " \t\v\f", line_ends = "\r\n";

// Returns the text between the # signs and blanks around it.
std::string_view text_of_comment(std::string_view line)
{
  const std::size_t first = line.find_first_not_of("# \t\v\f");
  return first == std::string_view::npos ? "" : line.substr(first, line.find_last_not_of("# \t\v\f") + 1 - first);
}

bool has_comment(std::string_view text)
{
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1))
    if (at == 0 || blanks.find(text[at - 1]) != std::string_view::npos || line_ends.find(text[at - 1]) != std::string_view::npos)
      return true;
  return false;
}

} // namespace

void read_comments(std::string_view content, std::string_view elements, Soup& soup)
{
  while (!content.empty()) {
    const std::string_view line = content.substr(0, content.find_first_of(line_ends));
    const std::size_t first = line.find_first_not_of(blanks);
    if (first != std::string_view::npos && elements.find(line[first]) != std::string_view::npos)
      break;
    if (first != std::string_view::npos && line[first] == '#' && !text_of_comment(line).empty())
      soup.notes.comments.emplace_back(text_of_comment(line));
    content.remove_prefix((std::min)(content.size(), line.size() + 1));
  }
  if (has_comment(content))
    soup.leave_out("comments below the first vertex");
}

} // namespace coarsening_support
