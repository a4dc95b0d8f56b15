// SPDX-License-Identifier: MIT
#include "margin.hpp"

#include <utility>

namespace stickslip_check {
namespace {

/// The multiple that a point is about; nothing for a ray.
std::optional<Rational> multiple(const Witness& point) {
  if (point.x[kPlanar] == 0) return std::nullopt;
  return point.x[kPlanar + 1];
}

}  // namespace

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

std::vector<Range> gaps(const std::vector<Interval>& resisted) {
  std::vector<Range> result;
  Range gap{0, std::nullopt, false, true};  // from the last high end on, or from 0
  for (const auto& [low, high] : resisted) {
    gap.high = low;
    if (gap.low < low) result.push_back(gap);
    if (!high) return result;
    gap = {*high, std::nullopt, true, true};
  }
  result.push_back(gap);
  return result;
}

void Segments::visit(const Witness& first, const Witness& second) {
  if (interval_ == resisted_.size()) {
    throw rejection("segment-chain", "the intervals were complete before this segment");
  }
  const auto& [low, high] = resisted_[interval_];
  const Rational from = *multiple(first);
  const std::optional<Rational> to = multiple(second);
  if (from != end_.value_or(low)) {
    throw rejection("segment-chain",
                    "begins at " + show(from) + ", not at " + show(end_.value_or(low)));
  }
  if (high && (!to || *to > *high)) {
    throw rejection("segment-chain",
                    (to ? "goes to " + show(*to) : "a ray") + ", beyond " + show(*high));
  }
  if (to && *to < from) throw rejection("segment-chain", "goes down, to " + show(*to));
  if (!(first == last_)) last_forces_ = check_point(first, ", first point");
  std::vector<ContactForce> forces = check_point(second, ", second point");
  if (const auto refusal = mode_refusal(question_, last_forces_, forces)) {
    throw rejection("segment-mode", *refusal);
  }
  last_ = second;
  last_forces_ = std::move(forces);
  const bool complete = to == high;
  if (complete) ++interval_;
  end_ = complete ? std::nullopt : to;
  ++visited_;
}

void Segments::finish() const {
  if (interval_ < resisted_.size()) {
    throw rejection("segment-chain", "the list ends before this segment");
  }
}

std::vector<ContactForce> Segments::check_point(const Witness& point, const char* which) const {
  try {
    return check_witness(question_, point);
  } catch (const Rejected& rejected) {
    throw rejection(rejected.rule.c_str(), rejected.found, which);
  }
}

Rejected Segments::rejection(const char* rule, std::string found, const char* which) const {
  return {rule, std::nullopt, "segment " + std::to_string(visited_) + which, std::move(found)};
}

}  // namespace stickslip_check
