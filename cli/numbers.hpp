// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The numbers of the answers: how the subcommands print them, for people and for programs.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "stickslip/core/integer_vector.hpp"
#include "stickslip/equilibrium/question.hpp"

namespace CLI {
class App;
}

namespace stickslip {

using Json = nlohmann::ordered_json;

/// --json, --floats and --exact, of every subcommand that answers in numbers.
struct NumberOptions {
  bool json = false;
  bool floats = false;
  bool exact = false;

  void add_to(CLI::App& command, const std::string& json_description =
                                     "Print one JSON object; rationals are strings");
};

/// Numbers in text: readable, or with all digits. It remembers what needs a word of
/// explanation.
class NumberText {
 public:
  explicit NumberText(const NumberOptions& options) : exact_(options.exact) {}

  /// As to_readable_string, or to_string.
  std::string operator()(const Rational& value);
  /// factor * sqrt(radicand); with all digits, an enclosure "a..b" unless it is rational.
  std::string root(const Rational& factor, const Rational& radicand);
  /// "(1, -1/2)".
  std::string operator()(const Vector2& v) { return tuple({v.x, v.y}); }
  std::string operator()(const Vector3& v) { return tuple({v.begin(), v.end()}); }
  std::string operator()(const Twist& d) { return (*this)(coordinates(d)); }
  std::string operator()(const std::array<Rational, 2>& v) {
    return tuple({v.begin(), v.end()});
  }
  std::string operator()(const std::vector<Rational>& v) { return tuple(v); }
  /// A vector of which only the direction has a meaning: small integers, or scaled to a largest
  /// entry of 1; with all digits as it is.
  std::string direction(const Vector3& v) { return scaled_tuple({v.begin(), v.end()}); }
  std::string direction(const Twist& d) { return direction(coordinates(d)); }
  template <std::size_t n>
  std::string direction(const IntegerVector<n>& v) {
    return scaled_tuple({v.begin(), v.end()});
  }

  /// What ~ and a..b mean, a line each, if they were printed.
  std::string note() const;

 private:
  std::string tuple(const std::vector<Rational>& v);
  std::string scaled_tuple(std::vector<Rational> v);

  bool exact_;
  bool has_rounded_ = false;
  bool has_enclosed_ = false;
};

/// \{ \brief An exact number, or several, in a JSON tree that finished() is to finish.
Json number_json(const Rational& value);
Json decimal_json(const std::string& decimal);  ///< as it is spelled
Json number_json(const DecimalEnclosure& enclosure);
Json number_json(const Vector2& v);
template <class Number, std::size_t n>
Json number_json(const std::array<Number, n>& v) {
  Json json = Json::array();
  for (const Number& entry : v) json.push_back(number_json(Rational(entry)));
  return json;
}
/// \}

/// The tree with its exact numbers as strings, such as "-1/2". With `floats`, each member X
/// that is such numbers, in arrays of any depth, is followed by a member X_float of the same
/// shape: the nearest doubles, null beyond their range.
Json finished(const Json& tree, bool floats);

}  // namespace stickslip
