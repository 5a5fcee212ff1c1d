// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_VALUE_COMPONENTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_VALUE_COMPONENTS_H

#include <CGAL/IO/Color.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_coarsening::internal {

template <class Number>
Number to_number(double x)
{
  if constexpr (std::is_integral<Number>::value) {
    // The ends of a range of 64 bits are not doubles; values beyond them must not be converted.
    if (!(x > double((std::numeric_limits<Number>::min)())))
      return (std::numeric_limits<Number>::min)();
    if (x >= double((std::numeric_limits<Number>::max)()))
      return (std::numeric_limits<Number>::max)();
    return Number(std::nearbyint(x));
  } else {
    return Number(x);
  }
}

template <class Value>
constexpr bool is_number = std::is_arithmetic<Value>::value && !std::is_same<Value, bool>::value;

// The numbers of a value, if its type has means.
template <class Value, class = void>
struct Value_components
{
  static constexpr std::size_t size = 0;
};

template <class Value>
struct Value_components<Value, std::enable_if_t<is_number<Value> > >
{
  static constexpr std::size_t size = 1;
  static double get(const Value& value, std::size_t) { return double(value); }
  static Value make(const std::array<double, 1>& x) { return to_number<Value>(x[0]); }
};

template <>
struct Value_components<CGAL::IO::Color>
{
  static constexpr std::size_t size = 4;
  static double get(const CGAL::IO::Color& c, std::size_t i) { return double(c[i]); }
  static CGAL::IO::Color make(const std::array<double, 4>& x)
  {
    return CGAL::IO::Color(to_number<unsigned char>(x[0]), to_number<unsigned char>(x[1]),
                           to_number<unsigned char>(x[2]), to_number<unsigned char>(x[3]));
  }
};

template <class Number, std::size_t n>
struct Value_components<std::array<Number, n>, std::enable_if_t<is_number<Number> > >
{
  static constexpr std::size_t size = n;
  static double get(const std::array<Number, n>& value, std::size_t i) { return double(value[i]); }
  static std::array<Number, n> make(const std::array<double, n>& x)
  {
    std::array<Number, n> value;
    std::transform(x.begin(), x.end(), value.begin(), to_number<Number>);
    return value;
  }
};

// Points and vectors of a kernel.
template <class Value>
struct Value_components<Value, std::void_t<typename Value::R, decltype(std::declval<const Value&>().cartesian(0)),
                                           typename Value::Ambient_dimension> >
{
  static constexpr std::size_t size = Value::Ambient_dimension::value;
  typedef typename Value::R::FT FT;

  static double get(const Value& value, std::size_t i) { return CGAL::to_double(value.cartesian(int(i))); }
  static Value make(const std::array<double, size>& x)
  {
    if constexpr (size == 2)
      return Value(FT(x[0]), FT(x[1]));
    else
      return Value(FT(x[0]), FT(x[1]), FT(x[2]));
  }
};

template <class Value>
constexpr bool has_means = Value_components<Value>::size != 0;

// A weighted sum of values.
template <class Value>
class Weighted_sum
{
  typedef Value_components<Value> Components;

public:
  void add(double weight, const Value& value)
  {
    for (std::size_t i = 0; i < sum_.size(); ++i)
      sum_[i] += weight * Components::get(value, i);
  }
  void add(double weight, const Weighted_sum& other)
  {
    for (std::size_t i = 0; i < sum_.size(); ++i)
      sum_[i] += weight * other.sum_[i];
  }
  Value value() const { return Components::make(sum_); }

private:
  std::array<double, Components::size> sum_{};
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_VALUE_COMPONENTS_H
