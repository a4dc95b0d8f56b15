// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact numbers as answers show them: text for people, JSON for programs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/json_value.hpp"
#include "stickslip/core/root_sum.hpp"

namespace stickslip {

/// Numbers in text: readable, or with all digits. It remembers what needs a word of
/// explanation.
class NumberText {
 public:
  /// `remedy`, if given, ends the sentence of note() on rounded numbers.
  explicit NumberText(bool exact, std::string remedy = {})
      : exact_(exact), remedy_(std::move(remedy)) {}

  /// As to_readable_string, or to_string.
  std::string operator()(const Rational& value);
  /// \{ Roots; with all digits, an enclosure "a..b" unless it is rational.
  std::string root(const Rational& factor, const Rational& radicand) {
    return (*this)(RootSum::root(factor, radicand));
  }
  std::string operator()(const RootSum& value);
  /// \}
  /// \{ "(1, -1/2)".
  std::string operator()(const Vector2& v) { return tuple({v.x, v.y}); }
  std::string operator()(const Twist& d) { return (*this)(coordinates(d)); }
  template <class Number, std::size_t n>
  std::string operator()(const std::array<Number, n>& v) {
    return tuple({v.begin(), v.end()});
  }
  std::string operator()(const std::vector<Rational>& v) { return tuple(v); }
  /// \}
  /// \{ A vector of which only the direction has a meaning: small integers, or scaled to a
  /// largest entry of 1; with all digits as it is.
  std::string direction(const Twist& d) { return direction(coordinates(d)); }
  template <class Number, std::size_t n>
  std::string direction(const std::array<Number, n>& v) {
    return scaled_tuple({v.begin(), v.end()});
  }
  template <class Number>
  std::string direction(const std::vector<Number>& v) {
    return scaled_tuple({v.begin(), v.end()});
  }
  /// \}

  /// What ~ and a..b mean, a line each, if they were printed.
  std::string note() const;

 private:
  std::string tuple(const std::vector<Rational>& v);
  std::string scaled_tuple(std::vector<Rational> v);

  bool exact_;
  std::string remedy_;
  bool has_rounded_ = false;
  bool has_enclosed_ = false;
};

/// \{ \brief An exact number, or several, in a JSON tree that finished() is to finish; a
/// decimal as it is spelled; an irrational number as what encloses it.
Json number_json(const Rational& value);
Json decimal_json(const std::string& decimal);
Json number_json(const DecimalEnclosure& enclosure);
Json number_json(const RootSum& value);
Json number_json(const Vector2& v);
template <class Number, std::size_t n>
Json number_json(const std::array<Number, n>& v) {
  Json json = Json::array();
  for (const Number& entry : v) json.push_back(number_json(Rational(entry)));
  return json;
}
Json number_json(const std::vector<Rational>& v);
Json number_json(const std::vector<Integer>& v);
/// \}

/// \{ A member "units" of an answer about this grasp, if they are known.
void add_units(Json& json, const Grasp& grasp);
void add_units(Json& json, const std::optional<Units>& units);
/// \}

/// The tree with its exact numbers as strings, such as "-1/2". With `floats`, each member X
/// that is such numbers, in arrays of any depth, is followed by a member X_float of the same
/// shape: the nearest doubles, null beyond their range.
Json finished(const Json& tree, bool floats);

}  // namespace stickslip
