// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_ROW_NUMBERS_H
#define COARSENING_SUPPORT_ROW_NUMBERS_H

#include "io/Mesh.h"
#include "io/Text_scanner.h"

#include <cstddef>
#include <string>
#include <vector>

namespace coarsening_support {

// Numbers that follow what a line of a text file has to have, such as colors: the same number of them on each line, or they mean
// nothing.
class Row_numbers
{
  std::vector<double> values_;
  std::size_t rows_ = 0, width_ = 0;
  bool is_regular_ = true;

public:
  // Takes what is left of the line.
  void read_row(Text_scanner& text);
  void add_row(const double* begin, const double* end);

  std::size_t width() const { return width_; }
  bool is_regular() const { return is_regular_; }
  bool empty() const { return is_regular_ && width_ == 0; }

  std::vector<double> column(std::size_t i) const;

  // Three or four columns become the properties red, green, blue and alpha. They run to 255, or to 1 if none is above.
  // Where all are opaque, there is no alpha. Digits beyond 8 bits are left out of the soup, which has the properties.
  void add_colors(std::size_t first, std::size_t number, std::vector<Soup_property>& properties, Soup& soup) const;
  void add_numbers(std::size_t first, const std::vector<std::string>& names, std::vector<Soup_property>& properties) const;
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_ROW_NUMBERS_H
