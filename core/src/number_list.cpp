// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/number_list.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {

Rational rational_at(const std::string& place, const std::string& text) {
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    const bool is_list = text.find_first_of("0123456789") < text.find_last_of(' ') &&
                         text.find_last_of(' ') < text.find_last_of("0123456789");
    throw InputError("", place, error.what(),
                     is_list ? "separate numbers by commas, without blanks, as in 0,1,-3/5"
                             : "write it as 2, -0.25, 1e-3 or 3/5");
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
