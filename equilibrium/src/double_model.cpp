// SPDX-License-Identifier: GPL-3.0-or-later
#include "double_model.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip {

double DoubleModel::read(const Rational& value) {
  constexpr double kLargest = 0x1p200;
  const double rounded = to_double(value);
  const double size = std::fabs(rounded);
  is_moderate = is_moderate && (value.is_zero() || (size <= kLargest && size >= 1 / kLargest));
  return rounded;
}

DoubleModel::DoubleModel(const Problem& problem) {
  double arms = 0;
  double preloads = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    ContactDoubles c{};
    c.normal = read(row.normal);
    c.friction = read(row.friction * row.tangent);
    const Double3 tangent = read(row.tangent);
    c.slip = {tangent[0], tangent[1], tangent[2], 0};
    const Vector4& v = problem.separation(ContactId(i));
    for (std::size_t j = 0; j < 4; ++j) c.separation[j] = read(v[j]);
    c.stiffness = read(row.stiffness);
    c.frictionless = row.friction.is_zero();
    arms += std::hypot(c.normal[2], tangent[2]) / std::hypot(c.normal[0], c.normal[1]);
    preloads += c.separation[3] * std::hypot(c.normal[0], c.normal[1]);
    contacts.push_back(c);
  }
  for (const LoadRange::End& end : problem.load().ends()) {
    loads.push_back(read(end.wrench));
    multiples.push_back(read(end.multiple));
  }
  if (const auto& direction = problem.load().recession()) recession = read(*direction);
  const double count = std::max<double>(1, static_cast<double>(problem.size()));
  length = arms > 0 ? arms / count : 1;
  force = preloads / count;
  const auto add = [&](const Double3& load) {
    force += std::hypot(load[0], load[1]) + std::fabs(load[2]) / length;
  };
  std::for_each(loads.begin(), loads.end(), add);
  if (recession) add(*recession);
  if (!(force > 0) || !std::isfinite(force)) force = 1;
  if (!std::isfinite(length)) length = 1;
}

std::size_t DoubleModel::hardest_load(const Double3& twist) const {
  return loads.size() > 1 && dot(loads[1], twist) > dot(loads[0], twist) ? 1 : 0;
}

Double4 to_doubles(const IntegerVector4& x) {
  std::array<double, 4> mantissa{};
  std::array<long, 4> exponent{};
  long largest = 0;
  bool any = false;
  for (std::size_t j = 0; j < 4; ++j) {
    if (x[j].is_zero()) continue;
    mantissa[j] = mpz_get_d_2exp(&exponent[j], x[j].backend().data());
    largest = any ? std::max(largest, exponent[j]) : exponent[j];
    any = true;
  }
  Double4 result{};
  for (std::size_t j = 0; j < 4; ++j) {
    const long shift = std::max<long>(exponent[j] - largest, -2000);
    result[j] = std::ldexp(mantissa[j], static_cast<int>(shift));
  }
  return result;
}

}  // namespace stickslip
