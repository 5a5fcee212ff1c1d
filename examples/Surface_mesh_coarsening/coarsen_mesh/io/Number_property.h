// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_NUMBER_PROPERTY_H
#define COARSENING_SUPPORT_NUMBER_PROPERTY_H

#include "io/soup_properties.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

namespace coarsening_support {

// Calls `use` with the property map of this name, if it holds numbers of a type that files have; returns whether it does.
template <class Element, class Use>
bool use_numbers(const Mesh& mesh, const std::string& name, const Use& use)
{
  const auto try_type = [&](auto number) {
    const Found_property<Element, decltype(number)> found(mesh, name.c_str());
    if (found)
      use(found.map);
    return found.found;
  };
  return try_type(std::int8_t()) || try_type(std::uint8_t()) || try_type(std::int16_t()) || try_type(std::uint16_t()) ||
         try_type(std::int32_t()) || try_type(std::uint32_t()) || try_type(float()) || try_type(double());
}

// Numbers of vertices or faces, of any type; false if there are none.
template <class Element>
class Number_property
{
  std::function<double(Element)> read_;
  bool is_whole_ = false;

public:
  Number_property() = default;
  Number_property(const Mesh& mesh, const std::string& name)
  {
    use_numbers<Element>(mesh, name, [this](const auto& map) {
      typedef typename std::decay_t<decltype(map)>::value_type Number;
      is_whole_ = std::is_integral<Number>::value;
      read_ = [map](Element e) { return static_cast<double>(map[e]); };
    });
  }
  explicit operator bool() const { return bool(read_); }
  double operator()(Element e) const { return read_(e); }
  bool is_whole() const { return is_whole_; }

  // A part of a color, which runs to 255 in whole numbers and to 1 in others.
  int byte(Element e) const
  {
    const double x = is_whole_ ? read_(e) : 255 * read_(e);
    return static_cast<int>(std::lround((std::min)((std::max)(std::isnan(x) ? 0. : x, 0.), 255.)));
  }
};

// The property of the same kind of element with this name in a file.
template <class Element>
Number_property<Element> number_property(const Mesh& mesh, const std::string& name)
{
  return Number_property<Element>(mesh, (std::is_same<Element, Vertex>::value ? "v:" : "f:") + name);
}

template <class Element>
struct Color_properties
{
  Number_property<Element> red, green, blue, alpha;

  explicit Color_properties(const Mesh& mesh)
    : red(number_property<Element>(mesh, "red")),
      green(number_property<Element>(mesh, "green")),
      blue(number_property<Element>(mesh, "blue")),
      alpha(number_property<Element>(mesh, "alpha"))
  {}
  explicit operator bool() const { return red && green && blue; }
};

struct Normal_properties
{
  Number_property<Vertex> x, y, z;

  explicit Normal_properties(const Mesh& mesh)
    : x(number_property<Vertex>(mesh, "nx")),
      y(number_property<Vertex>(mesh, "ny")),
      z(number_property<Vertex>(mesh, "nz"))
  {}
  explicit operator bool() const { return x && y && z; }
};

// Texture coordinates of vertices, by the names that PLY files give them.
struct Texture_properties
{
  Number_property<Vertex> u, v;

  explicit Texture_properties(const Mesh& mesh)
  {
    static const char* const names[][2] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
    for (const auto& name : names)
      if (!*this) {
        u = number_property<Vertex>(mesh, name[0]);
        v = number_property<Vertex>(mesh, name[1]);
      }
  }
  explicit operator bool() const { return u && v; }
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_NUMBER_PROPERTY_H
