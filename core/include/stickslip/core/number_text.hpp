// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Writes exact numbers in answers: text for people, JSON for programs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "stickslip/core/grasp.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/json_value.hpp"
#include "stickslip/core/root_sum.hpp"

namespace stickslip {

/// Writes numbers in text: readable, or with all digits. It remembers which marks need a word
/// of explanation.
class NumberText {
 public:
  /// Makes a writer, of all digits if `exact` is set. `remedy`, if given, ends the sentence of
  /// note() on rounded numbers.
  explicit NumberText(bool exact, std::string remedy = {})
      : exact_(exact), remedy_(std::move(remedy)) {}

  /// Returns the number as to_readable_string() writes it, or with all digits as to_string()
  /// does.
  std::string operator()(const Rational& value);
  /// \{ Returns a root or a sum of roots. With all digits it is an enclosure "a..b" unless it
  /// is rational.
  std::string root(const Rational& factor, const Rational& radicand) {
    return (*this)(RootSum::root(factor, radicand));
  }
  std::string operator()(const RootSum& value);
  /// \}
  /// Returns two numbers as decimals that are rounded outward and differ, as enclose() gives
  /// them, or with all digits. Requires 0 <= low < high.
  DecimalEnclosure around(const Rational& low, const Rational& high) const {
    return exact_ ? DecimalEnclosure{to_string(low), to_string(high)} : enclose(low, high);
  }
  /// \{ Returns "(1, -1/2)" or the like.
  std::string operator()(const Vector2& v) { return tuple({v.x, v.y}); }
  std::string operator()(const Twist& d) { return (*this)(coordinates(d)); }
  template <class Number, std::size_t n>
  std::string operator()(const std::array<Number, n>& v) {
    return tuple({v.begin(), v.end()});
  }
  std::string operator()(const std::vector<Rational>& v) { return tuple(v); }
  /// \}
  /// \{ Returns a vector of which only the direction has a meaning, as small integers, or
  /// scaled to a largest entry of 1. With all digits it is not scaled.
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

  /// Returns a line on the meaning of each of the marks ~ and a..b that was printed.
  std::string note() const;

 private:
  std::string tuple(const std::vector<Rational>& v);
  std::string scaled_tuple(std::vector<Rational> v);

  bool exact_;
  std::string remedy_;
  bool has_rounded_ = false;
  bool has_enclosed_ = false;
};

/// \{ \brief Returns one exact number, or several, in a JSON tree for finished(). A decimal
/// stays as it is spelled, and an irrational number becomes the two ends of an interval around
/// it.
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

/// Adds what a reader has to know of the numbers of a grasp, as far as there is any of it:
/// "units", "gravity" for masses, and "rounded_normals", which were given by an angle.
void add_conventions(Json& json, const GraspDescription& description);

/// Returns the tree with its exact numbers as strings, such as "-1/2". With `floats`, each
/// member X that is such numbers, in arrays of any depth, is followed by a member X_float of
/// the same shape: the nearest doubles, null beyond their range.
Json finished(const Json& tree, bool floats);

}  // namespace stickslip
