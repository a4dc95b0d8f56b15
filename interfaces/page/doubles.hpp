// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact numbers as doubles, for drawing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "stickslip/core/number.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip::page_detail {

template <std::size_t n>
Json in_doubles_json(const std::array<Rational, n>& v) {
  Json json = Json::array();
  for (const Rational& x : v) json.push_back(to_double(x));
  return json;
}

inline Json in_doubles_json(const RationalRow& v) {
  Json json = Json::array();
  for (const Rational& x : v) json.push_back(to_double(x));
  return json;
}

/// Returns a vector of length 1. The entries, of which one is not 0, may be beyond the doubles.
template <std::size_t n>
std::array<double, n> unit(const std::array<Rational, n>& v) {
  Rational largest = 0;
  for (const Rational& x : v) largest = std::max(largest, Rational(abs(x)));
  std::array<double, n> result{};
  double square = 0;
  for (std::size_t j = 0; j < n; ++j) {
    result[j] = to_double(v[j] / largest);
    square += result[j] * result[j];
  }
  for (double& x : result) x /= std::sqrt(square);
  return result;
}

/// Returns a vector of length 1, each entry with nine digits: the page is shorter, and a
/// drawing the same.
template <std::size_t n>
Json drawn_unit(const std::array<Rational, n>& v) {
  Json json = Json::array();
  for (const double x : unit(v)) {
    const double scale = x == 0 ? 1 : std::pow(10, 9 - std::ceil(std::log10(std::abs(x))));
    json.push_back(std::round(x * scale) / scale);
  }
  return json;
}

}  // namespace stickslip::page_detail
