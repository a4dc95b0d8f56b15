// SPDX-License-Identifier: GPL-3.0-or-later
#include "double_model.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip {
namespace {

double sum_of_sizes(const Double5& a) {
  double sum = 0;
  for (const double entry : a) sum += std::fabs(entry);
  return sum;
}

}  // namespace

double DoubleModel::read(const Rational& value) {
  constexpr double kLargest = 0x1p200;
  const double rounded = to_double(value);
  const double size = std::fabs(rounded);
  is_moderate = is_moderate && (value.is_zero() || (size <= kLargest && size >= 1 / kLargest));
  return rounded;
}

DoubleModel::DoubleModel(const Problem& problem) {
  double arms = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactId id(i);
    ContactDoubles c{};
    c.normal = read(row.normal);
    c.friction = read(row.friction * row.tangent);
    const Double3 tangent = read(row.tangent);
    c.slip = {tangent[0], tangent[1], tangent[2], 0, 0};
    const Vector5& v = problem.separation(id);
    for (std::size_t j = 0; j < 5; ++j) c.separation[j] = read(v[j]);
    c.stiffness = read(row.stiffness);
    stiffness += c.stiffness;
    c.frictionless = row.friction.is_zero();
    c.slip_error = rounding_bound(sum_of_sizes(c.slip));
    c.separation_error = rounding_bound(sum_of_sizes(c.separation));
    arms += std::hypot(c.normal[2], tangent[2]) / std::hypot(c.normal[0], c.normal[1]);
    contacts.push_back(c);
  }
  load = read(problem.wrench());
  growth = read(problem.load_growth());
  const double count = std::max<double>(1, static_cast<double>(problem.size()));
  length = arms > 0 ? arms / count : 1;
  const auto add_end = [&](double h, double l) {
    for (std::size_t j = 0; j < 3; ++j) start[j] = h * load[j] + l * growth[j];
    force += std::hypot(start[0], start[1]) + std::fabs(start[2]) / length;
    for (const ContactDoubles& c : contacts) {
      const double preload = h * c.separation[3] + l * c.separation[4];
      force += preload * std::hypot(c.normal[0], c.normal[1]) / count;
    }
  };
  const MultipleRange& range = problem.multiples();
  add_end(1, to_double(range.low));
  if (problem.is_family()) range.high ? add_end(1, to_double(*range.high)) : add_end(0, 1);
  if (!(force > 0) || !std::isfinite(force)) force = 1;
  if (!std::isfinite(length)) length = 1;
  // Reading all contacts costs little where they are few; then single ones are told apart.
  constexpr std::size_t kFew = 64;
  constexpr std::size_t kSmallestGroup = 16;
  groups =
      ContactGroups(problem, contacts, length, contacts.size() < kFew ? 1 : kSmallestGroup);
}

}  // namespace stickslip
