// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/pull_rule.hpp"

namespace stickslip {

PullRule::PullRule(const std::vector<RationalRow>& rows) {
  Integer common = 1;
  for (const RationalRow& row : rows) {
    for (const Rational& entry : row) common = lcm(common, denominator(entry));
  }
  for (const RationalRow& row : rows) {
    Row& whole = rows_.emplace_back();
    for (const Rational& entry : row) {
      whole.emplace_back(numerator(entry) * (common / denominator(entry)));
    }
  }
}

namespace {

std::vector<RationalRow> from_twist(std::vector<RationalRow> rows, const RationalRow& twist) {
  for (RationalRow& row : rows) row.emplace_back(-dot(row, twist));
  return rows;
}

}  // namespace

PullRule::PullRule(const std::vector<RationalRow>& matrix, const RationalRow& twist)
    : PullRule(from_twist(matrix, twist)) {}

}  // namespace stickslip
