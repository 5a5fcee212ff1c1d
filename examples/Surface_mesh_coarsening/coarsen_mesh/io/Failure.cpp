// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Failure.h"

#include <cstddef>
#include <cstdint>

namespace coarsening_support {
namespace {

bool is_printable_ascii(char c) { return c >= ' ' && c <= '~'; }

void escape(char c, std::string& result)
{
  static constexpr char digits[] = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  result += "\\x";
  result += digits[byte / 16];
  result += digits[byte % 16];
}

// Returns the length of the printable multi-byte character at the begin of the text, or 0. Not printable are the control
// characters from U+0080 to U+009F, directions of writing, surrogates, and overlong forms.
std::size_t length_of_character(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) >= 0xf0 && byte(0) < 0xf5 ? 4 : byte(0) >= 0xe0 ? 3 : byte(0) >= 0xc2 ? 2 : 0;
  if (length == 0 || byte(0) >= 0xf5 || length > text.size())
    return 0;
  std::uint32_t code = byte(0) & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80)
      return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  const std::uint32_t least[] = {0, 0, 0xa0, 0x800, 0x10000};
  const bool is_direction = (code >= 0x200e && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
                            (code >= 0x2066 && code <= 0x2069);
  return code < least[length] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000) || is_direction ? 0 : length;
}

} // namespace

std::string escaped(std::string_view text)
{
  std::string result;
  for (const char c : text)
    if (is_printable_ascii(c))
      result += c;
    else
      escape(c, result);
  return result;
}

std::string escaped_utf8(std::string_view text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = is_printable_ascii(text[i]) ? 1 : length_of_character(text.substr(i));
    if (length == 0)
      escape(text[i++], result);
    else {
      result += text.substr(i, length);
      i += length;
    }
  }
  return result;
}

std::string one_line(const std::string& text)
{
  std::string line;
  for (const char c : text)
    if (c != '\n' && c != '\r' && c != '\t' && c != ' ')
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  while (!line.empty() && line.back() == ' ')
    line.pop_back();
  return escaped_utf8(line);
}

} // namespace coarsening_support
