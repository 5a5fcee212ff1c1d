// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Row_numbers.h"

#include <algorithm>
#include <cmath>

namespace coarsening_support {

void Row_numbers::read_row(Text_scanner& text)
{
  double row[16];
  std::size_t width = 0;
  while (is_regular_ && !text.next_word().empty()) {
    is_regular_ = width < 16 && text.try_number(row[width]);
    ++width;
  }
  add_row(row, row + (is_regular_ ? width : 0));
  text.skip_line();
}

void Row_numbers::add_row(const double* begin, const double* end)
{
  const auto width = static_cast<std::size_t>(end - begin);
  if (rows_++ == 0)
    width_ = width;
  is_regular_ = is_regular_ && width == width_ && std::all_of(begin, end, [](double x) { return std::isfinite(x); });
  if (is_regular_)
    values_.insert(values_.end(), begin, end);
}

std::vector<double> Row_numbers::column(std::size_t i) const
{
  std::vector<double> result;
  result.reserve(rows_);
  for (std::size_t k = i; k < values_.size(); k += width_)
    result.push_back(values_[k]);
  return result;
}

void Row_numbers::add_colors(std::size_t first, std::size_t number, std::vector<Soup_property>& properties, Soup& soup) const
{
  static const char* const names[] = {"red", "green", "blue", "alpha"};
  double largest = 0;
  for (std::size_t k = 0; k < values_.size(); ++k)
    if (k % width_ >= first && k % width_ < first + number)
      largest = (std::max)(largest, values_[k]);
  const double scale = largest > 1 ? 1 : 255;
  constexpr double tolerance = 0.2; // of colors of 8 bits that are written with three digits
  for (std::size_t i = first; i < first + number; ++i) {
    Soup_property color{names[i - first], Number_type::UINT8, column(i)};
    for (double& x : color.values) {
      const double part = scale * x;
      x = std::round((std::min)((std::max)(part, 0.), 255.));
      if (std::abs(part - x) > tolerance)
        soup.leave_out("the digits of colors beyond 8 bits");
    }
    const auto is_full = [](double x) { return x == 255; };
    const bool is_alpha = i == first + 3;
    if (!is_alpha || !std::all_of(color.values.begin(), color.values.end(), is_full))
      properties.push_back(std::move(color));
  }
}

void Row_numbers::add_numbers(std::size_t first, const std::vector<std::string>& names,
                              std::vector<Soup_property>& properties) const
{
  for (std::size_t i = 0; i < names.size(); ++i)
    properties.push_back({names[i], Number_type::FLOAT64, column(first + i)});
}

} // namespace coarsening_support
