// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/number_list.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {

Rational rational_at(const std::string& place, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    throw InputError("", place, error.what(), "write it as 2, -0.25, 1e-3 or 3/5");
  }
}

std::vector<Rational> rationals_at(const std::string& place, const std::string& text) {
  std::vector<Rational> numbers;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    numbers.push_back(rational_at(place, text.substr(start, comma - start)));
    start = comma + 1;
  }
  return numbers;
}

}  // namespace stickslip
