// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Certificates as JSON values, for editing. Exact: certificate_text writes what does not fit
/// into a double as strings.
#pragma once

#include <nlohmann/json.hpp>

#include "mutations.hpp"

namespace stickslip::test {

using Json = nlohmann::ordered_json;

inline Rational number_of(const Json& value) {
  return value.is_string() ? parse_rational(value.get<std::string>())
                           : Rational(value.get<std::int64_t>());
}

inline Json json_of(const Rational& value) {
  if (denominator(value) == 1 && abs(numerator(value)) < (Integer(1) << 53)) {
    return numerator(value).convert_to<std::int64_t>();
  }
  return to_string(value);
}

inline Mutant mutant(const std::string& kind, const Certified& original, const Json& edited,
                     Expectation expected = {}) {
  CheckerInput input = original.input();
  input.certificate = edited.dump();
  return {kind, original.name(), std::move(input), std::move(expected)};
}

/// A random index of a list that is not empty.
inline std::size_t any_of(RandomSource& random, const Json& list) {
  return static_cast<std::size_t>(random.between(0, static_cast<int>(list.size()) - 1));
}

}  // namespace stickslip::test
