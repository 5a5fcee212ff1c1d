// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_BYTE_SCANNER_H
#define COARSENING_SUPPORT_BYTE_SCANNER_H

#include "io/Text_scanner.h"

#include <boost/endian/conversion.hpp>
#include <boost/integer.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace coarsening_support {

// Reads numbers in the binary part of a file, in either byte order.
class Byte_scanner
{
  const char* begin;
  const char* at;
  const char* end;
  bool big_endian;

public:
  Byte_scanner(const char* begin, const char* at, const char* end, bool big_endian)
    : begin(begin),
      at(at),
      end(end),
      big_endian(big_endian)
  {}

  std::size_t bytes_left() const { return static_cast<std::size_t>(end - at); }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Format_fault("byte " + std::to_string(at - begin), reason);
  }

  template <class Words>
  void skip(std::uint64_t bytes, const Words& what)
  {
    if (bytes > bytes_left())
      fail("the file ends within " + words_of(what));
    at += static_cast<std::size_t>(bytes);
  }

  template <class Number, class Words>
  Number read(const Words& what)
  {
    typename boost::uint_t<8 * sizeof(Number)>::exact bits;
    if (sizeof bits > bytes_left())
      fail("the file ends within " + words_of(what));
    std::memcpy(&bits, at, sizeof bits);
    at += sizeof bits;
    bits = big_endian ? boost::endian::big_to_native(bits) : boost::endian::little_to_native(bits);
    Number number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  // As Text_scanner::count() checks it.
  void check_count(long long value, const std::string& what, std::uint64_t bytes_each) const
  {
    if (value < 0)
      fail("the number of " + what + " is " + std::to_string(value));
    const std::uint64_t room = bytes_each == 0 ? 0 : bytes_left() / bytes_each;
    if (static_cast<std::uint64_t>(value) > room)
      fail(std::to_string(value) + " " + what + " are announced, but the rest of the file has room for " +
           std::to_string(room) + " at the most");
  }

  void expect_end(const std::string& what) const
  {
    if (at != end)
      fail("the file goes on for " + std::to_string(bytes_left()) + " bytes after " + what);
  }
};

// The bytes behind the line of a header that has been read.
inline Byte_scanner bytes_behind_line(const Text_scanner& header, const std::string& content, bool big_endian)
{
  const char* at = header.position();
  const char* const end = content.data() + content.size();
  if (at != end && *at == '\r')
    ++at;
  if (at != end && *at == '\n')
    ++at;
  return Byte_scanner(content.data(), at, end, big_endian);
}

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_BYTE_SCANNER_H
