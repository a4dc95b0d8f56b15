// SPDX-License-Identifier: MIT
#include "margin.hpp"

#include <string>
#include <utility>

namespace stickslip_check {

void check_order(const std::vector<Interval>& resisted) {
  std::optional<Rational> above;  // the high end of the interval before
  for (std::size_t k = 0; k < resisted.size(); ++k) {
    const auto& [low, high] = resisted[k];
    const auto reject = [&](const std::string& found) {
      throw Rejected{"resisted-order", std::nullopt, "interval " + std::to_string(k), found};
    };
    if (k == 0 && low < 0) reject("begins at " + show(low) + ", below 0");
    if (k > 0 && !above) reject("follows an interval without an end");
    if (k > 0 && low <= *above) {
      reject("begins at " + show(low) + ", not above " + show(*above));
    }
    if (high && *high < low) reject("ends at " + show(*high) + ", below " + show(low));
    above = high;
  }
}

std::vector<LoadRange> gaps(const std::vector<Interval>& resisted) {
  std::vector<LoadRange> result;
  LoadRange gap{0, std::nullopt, true};  // from the last high end on, or from 0
  for (const auto& [low, high] : resisted) {
    gap.high = low;
    // Above 0, or the high end before: there is something between.
    if (gap.low < low) result.push_back(gap);
    if (!high) return result;
    gap = {*high, std::nullopt, false};
  }
  result.push_back(gap);
  return result;
}

void Segments::visit(const MarginPoint& first, const MarginPoint& second) {
  check_chain(first, second);
  check_point(first, "first");
  check_point(second, "second");
  if (const auto refusal = mode_refusal(rows_, first.witness, second.witness)) {
    throw rejection("segment-mode", *refusal);
  }
  if (second.lambda == resisted_[interval_].high) {
    ++interval_;
    end_.reset();
  } else {
    end_ = second.lambda;
  }
  ++visited_;
}

void Segments::finish() const {
  if (interval_ < resisted_.size()) {
    throw rejection("segment-chain", "the list ends before this segment");
  }
}

void Segments::check_chain(const MarginPoint& first, const MarginPoint& second) const {
  const auto reject = [&](const std::string& found) {
    throw rejection("segment-chain", found);
  };
  if (interval_ == resisted_.size()) reject("the intervals were complete before this segment");
  const auto& [low, high] = resisted_[interval_];
  const Rational& from = *first.lambda;
  if (from != end_.value_or(low)) {
    reject("begins at " + show(from) + ", not at " + show(end_.value_or(low)));
  }
  if (!second.lambda) {
    if (high) reject("a ray, but the interval ends at " + show(*high));
    return;
  }
  if (*second.lambda < from) reject("goes down, to " + show(*second.lambda));
  if (high && *second.lambda > *high) {
    reject("goes to " + show(*second.lambda) + ", beyond " + show(*high));
  }
}

void Segments::check_point(const MarginPoint& point, const char* which) const {
  const Vector3& u = *question_.direction;
  const Vector3 load = point.lambda ? sum(question_.wrench, *point.lambda, u) : u;
  try {
    check_witness(rows_, load, question_.bilateral, point.witness);
  } catch (Rejected& rejected) {
    rejected.path = rejection("", "").path + ", " + which + " point";
    throw;
  }
}

Rejected Segments::rejection(const char* rule, std::string found) const {
  return {rule, std::nullopt, "segment " + std::to_string(visited_), std::move(found)};
}

}  // namespace stickslip_check
