// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_ATTACK_MUTATE_FILE_H
#define CGAL_SURFACE_MESH_COARSENING_ATTACK_MUTATE_FILE_H

#include "Random.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

namespace attack {

// Returns the begin and end of a word near a random place.
inline std::pair<std::size_t, std::size_t> random_word(const std::string& file, Random& random)
{
  const auto is_space = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(file[i])) != 0; };
  std::size_t begin = random.below(file.size());
  while (begin > 0 && !is_space(begin - 1))
    --begin;
  std::size_t end = begin;
  while (end < file.size() && !is_space(end))
    ++end;
  return {begin, end};
}

inline std::pair<std::size_t, std::size_t> random_line(const std::string& file, Random& random)
{
  std::size_t begin = random.below(file.size());
  while (begin > 0 && file[begin - 1] != '\n')
    --begin;
  return {begin, (std::min)(file.find('\n', begin), file.size() - 1) + 1};
}

// Changes the bytes of a file once, as a faulty disk, program or person would.
inline void mutate(std::string& file, Random& random)
{
  if (file.empty())
    return;
  const std::size_t at = random.below(file.size());
  switch (random.below(14)) {
  case 0: file[at] = char(file[at] ^ (1 << random.below(8))); break;
  case 1: file[at] = char(random.below(256)); break;
  case 2: file.erase(at, 1 + random.below(8)); break;
  case 3: file.insert(at, random.bytes(1 + random.below(8))); break;
  case 4: file.resize(at); break;
  case 5: { // a number at its ends
    const auto word = random_word(file, random);
    file.replace(
      word.first, word.second - word.first,
      random.pick<const char*>({"0", "-1", "1", "nan", "inf", "-inf", "1e400", "1e-400", "1e308", "2147483648", "4294967295",
                                "4294967296", "18446744073709551616", "99999999999999999999999", "0x10", "1,5", "-", "."}));
    break;
  }
  case 6: { // a line twice
    const auto line = random_line(file, random);
    file.insert(line.first, file.substr(line.first, line.second - line.first));
    break;
  }
  case 7: { // without a line
    const auto line = random_line(file, random);
    file.erase(line.first, line.second - line.first);
    break;
  }
  case 8: { // a word in the place of another
    const auto from = random_word(file, random);
    const std::string text = file.substr(from.first, from.second - from.first);
    const auto to = random_word(file, random);
    file.replace(to.first, to.second - to.first, text);
    break;
  }
  case 9: { // four bytes that are a number at its ends
    const std::string number =
      random.pick<std::string>({std::string(4, '\0'), std::string(4, '\xff'), std::string("\xff\xff\xff\x7f", 4),
                                std::string("\x7f\x80\x00\x00", 4), std::string("\x00\x00\xc0\x7f", 4)});
    file.replace(at, (std::min)(number.size(), file.size() - at), number);
    break;
  }
  case 10: file += random.bytes(random.below(40)); break;
  case 11: file += file.substr(at); break;
  case 12:
    file.replace(at, 1, random.pick<std::string>({"\r\n", "\r", "\t", "#", std::string(1, '\0'), "\x1b[31m", "\xff"}));
    break;
  default: { // a part in another place
    const std::string part = file.substr(at, random.below(60));
    file.insert(random.below(file.size()), part);
  }
  }
}

} // namespace attack

#endif // CGAL_SURFACE_MESH_COARSENING_ATTACK_MUTATE_FILE_H
