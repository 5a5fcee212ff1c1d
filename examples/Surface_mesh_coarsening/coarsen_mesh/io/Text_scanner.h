// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_TEXT_SCANNER_H
#define COARSENING_SUPPORT_TEXT_SCANNER_H

#include "io/Failure.h"
#include "io/Polygons.h"

#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace coarsening_support {

// An error at a position in a mesh file.
class Format_fault : public std::runtime_error
{
public:
  Format_fault(const std::string& place, const std::string& reason) : std::runtime_error(place + ": " + reason) {}
};

// Throws if the user interrupts; called regularly during reading. Empty if nobody can interrupt.
typedef std::function<void()> Stop;

// Calls `stop` for the first and then every few thousand elements.
inline void stop_at(std::size_t element, const Stop& stop)
{
  if (element % 16384 == 0 && stop)
    stop();
}

// The text of a message, possibly as a function: so that reading millions of numbers formats none.
template <class Words>
std::string words_of(const Words& words)
{
  if constexpr (std::is_invocable<const Words&>::value)
    return words();
  else
    return std::string(words);
}

// Reads the words of a text line by line. A zero character has to follow the text, as in a `std::string`.
class Text_scanner
{
  const char* at;
  const char* end;
  std::size_t line = 1;
  char comment; // its first character, to the end of the line; 0 if there are none
  bool continued; // whether a backslash at the end of a line joins the next one

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  bool is_continuation() const { return continued && *at == '\\' && at + 1 != end && is_line_end(at[1]); }

  void take_line_end()
  {
    if (*at == '\r' && at + 1 != end && at[1] == '\n')
      ++at;
    ++at;
    ++line;
  }

  bool is_end_of_word(const char* p) const
  {
    return p == end || is_blank(*p) || is_line_end(*p) || (continued && *p == '\\' && p + 1 != end && is_line_end(p[1]));
  }

  void skip_blanks()
  {
    while (at != end && (is_blank(*at) || is_continuation())) {
      const bool joins_lines = !is_blank(*at++);
      if (joins_lines)
        take_line_end();
    }
    if (comment && at != end && *at == comment)
      while (at != end && !is_line_end(*at))
        ++at;
  }

public:
  Text_scanner(const char* begin, const char* end, char comment = 0, bool continued = false)
    : at(begin),
      end(end),
      comment(comment),
      continued(continued)
  {}

  const char* position() const { return at; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end - at); }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Format_fault("line " + std::to_string(line), reason);
  }

  // Advances to the next nonempty line; returns whether there is one.
  bool find_line()
  {
    for (skip_blanks(); at != end && is_line_end(*at); skip_blanks())
      take_line_end();
    return at != end;
  }

  // The same; the file must not end before `what`.
  template <class Words>
  void need_line(const Words& what)
  {
    if (!find_line())
      fail("the file ends before " + words_of(what));
  }

  // Returns the next word of the line, empty if there is none left.
  std::string_view word()
  {
    skip_blanks();
    const char* const begin = at;
    while (!is_end_of_word(at))
      ++at;
    return std::string_view(begin, static_cast<std::size_t>(at - begin));
  }

  // Returns the next word without advancing.
  std::string_view next_word()
  {
    const char* const before = at;
    const std::size_t line_before = line;
    const std::string_view result = word();
    at = before;
    line = line_before;
    return result;
  }

  // What is left of the line, without the blanks around it.
  std::string_view rest_of_line()
  {
    skip_blanks();
    const char* const begin = at;
    while (at != end && !is_line_end(*at))
      ++at;
    const char* last = at;
    while (last != begin && is_blank(last[-1]))
      --last;
    return std::string_view(begin, static_cast<std::size_t>(last - begin));
  }

  void skip_line()
  {
    while (!word().empty())
      ;
  }

  template <class Words>
  void end_line(const Words& what)
  {
    const std::string_view rest = word();
    if (!rest.empty())
      fail("there is more on the line than " + words_of(what) + ": " + shown(rest));
  }

  // Formats a word for a message.
  static std::string shown(std::string_view text)
  {
    constexpr std::size_t most = 30;
    return "'" + escaped(text.substr(0, most)) + (text.size() > most ? "...'" : "'");
  }

  // Takes the next word; returns whether it is a number. Numbers too large for a double become infinite, those too small zero.
  bool try_number(double& value)
  {
    if (take_number(value))
      return true;
    const std::string_view text = word();
    char* stop = nullptr;
    value = text.empty() ? 0 : std::strtod(text.data(), &stop);
    return !text.empty() && stop == text.data() + text.size();
  }

  template <class Words>
  double number(const Words& what)
  {
    const char* const before = at;
    const std::size_t line_before = line;
    double value = 0;
    if (try_number(value))
      return value;
    at = before;
    line = line_before;
    fail_at(word(), what);
  }

  template <class Words>
  long long integer(const Words& what)
  {
    long long value = 0;
    if (!take_number(value))
      fail_at(word(), what);
    return value;
  }

  // Reads the number of following elements, which take at least `bytes_each`. The file has to have room for them, so
  // that a header cannot make the caller allocate more than a small multiple of the file's size.
  std::size_t count(const std::string& what, std::size_t bytes_each)
  {
    const long long value = integer("the number of " + what);
    check_count(value, what, bytes_each, bytes_left());
    return static_cast<std::size_t>(value);
  }

  void check_count(long long value, const std::string& what, std::size_t bytes_each, std::size_t bytes) const
  {
    if (value < 0)
      fail("the number of " + what + " is " + std::to_string(value));
    // The last line may lack its line end.
    const std::size_t room = bytes_each == 0 ? 0 : (bytes + 1) / bytes_each;
    if (static_cast<unsigned long long>(value) > room)
      fail(std::to_string(value) + " " + what + " are announced, but the rest of the file has room for " +
           std::to_string(room) + " at the most");
  }

  // Reads the number of a vertex; the check of the surface reports invalid ones.
  Vertex_number vertex_number()
  {
    const long long value = integer("the number of a vertex");
    return value < 0 ? no_vertex : to_vertex_number(static_cast<std::size_t>(value));
  }

private:
  // Reads the next word if it is a number in C++ syntax.
  template <class Number>
  bool take_number(Number& value)
  {
    skip_blanks();
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc() || !is_end_of_word(read.ptr))
      return false;
    at = read.ptr;
    return true;
  }

  template <class Words>
  [[noreturn]] void fail_at(std::string_view text, const Words& what) const
  {
    fail(text.empty() ? words_of(what) + " is missing" : shown(text) + " stands where " + words_of(what) + " was expected");
  }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_TEXT_SCANNER_H
