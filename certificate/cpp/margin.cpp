// SPDX-License-Identifier: MIT
#include "margin.hpp"

#include <algorithm>
#include <utility>

namespace stickslip_check {
namespace {

/// The multiple that a point is about; nothing for a ray.
std::optional<Rational> multiple(const Witness& point) {
  if (point.x[kPlanar] == 0) return std::nullopt;
  return point.x[kPlanar + 1];
}

const char* const kFirst = ", first point";
const char* const kSecond = ", second point";

/// The rules `witness-...` of a point of what is at `place`.
std::vector<ContactForce> check_point(const Question& question, const Witness& point,
                                      const std::string& place, ForceSum& sum) {
  try {
    return check_witness(question, point, sum);
  } catch (const Rejected& rejected) {
    throw Rejected{rejected.rule, std::nullopt, place, rejected.found};
  }
}

/// `segment-mode`.
void check_mode(const Question& question, const std::vector<ContactForce>& first,
                const std::vector<ContactForce>& second, const std::string& place) {
  if (const auto refusal = mode_refusal(question, first, second)) {
    throw Rejected{"segment-mode", std::nullopt, place, *refusal};
  }
}

void count(const TreeWalk& walk, Accepted& accepted) {
  accepted.nodes += walk.nodes();
  accepted.leaves += walk.leaves();
}

}  // namespace

bool at_rest(const Question& question) {
  const auto zero = [](const Bounds& bounds) { return bounds == Bounds(0); };
  for (std::size_t i = 0; i < question.contacts.size(); ++i) {
    if (!zero(question.contacts[i].preload)) return false;
  }
  return std::all_of(question.wrench.begin(), question.wrench.end(), zero);
}

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

void Segments::visit(const Segment& segment) {
  if (interval_ == resisted_.size()) {
    throw out_of_chain("the intervals were complete before this segment");
  }
  const bool by_degree = segment.points.empty();
  const auto& [low, high] = resisted_[interval_];
  const Rational here = end_.value_or(low);
  const Rational from = by_degree ? here : *multiple(segment.points.front());
  const std::optional<Rational> to = by_degree ? segment.to : multiple(segment.points.back());
  if (from != here) {
    throw out_of_chain("begins at " + show(from) + ", not at " + show(here));
  }
  if (high && (!to || *to > *high)) {
    throw out_of_chain((to ? "goes to " + show(*to) : "a ray") + ", beyond " + show(*high));
  }
  if (to && *to < from) throw out_of_chain("goes down, to " + show(*to));
  if (by_degree) {
    if (to == from) throw out_of_chain("by degree, but ends where it begins");
    const bool stands_for_all = !to && from == 0 && at_rest(question_);
    if (!to && from == 0 && !stands_for_all) {
      throw out_of_chain("by degree from 0 on, but the wrench or a preload is not 0");
    }
    check_by_degree(segment.part, {stands_for_all ? Rational(1) : from, to});
  } else {
    check_points(segment.points.front(), segment.points.back());
  }
  const bool complete = to == high;
  if (complete) ++interval_;
  end_ = complete ? std::nullopt : to;
  ++visited_;
}

void Segments::check_points(const Witness& first, const Witness& second) {
  if (!(first == last_)) last_forces_ = check_point(question_, first, place() + kFirst, sum_);
  std::vector<ContactForce> forces = check_point(question_, second, place() + kSecond, sum_);
  check_mode(question_, last_forces_, forces, place());
  last_ = second;
  last_forces_ = std::move(forces);
}

void Segments::check_by_degree(const Part& part, const Range& range) {
  count(check_degree(part, question_.box, range, question_.asked, place()), accepted_);
  ++accepted_.parts;
}

void Segments::finish() const {
  if (interval_ < resisted_.size()) {
    throw out_of_chain("the list ends before this segment");
  }
}

std::string Segments::place() const {
  return "segment " + std::to_string(visited_);
}

Rejected Segments::out_of_chain(const std::string& found) const {
  return {"segment-chain", std::nullopt, place(), found};
}

void RangeProofs::visit(const RangeProof& claim) {
  const std::string place = "interval " + std::to_string(visited_);
  check_order(claim, place);
  if (claim.stable) {
    check_resisted(claim, place);
  } else {
    check_refuted(claim, place);
  }
  end_ = claim.range.high;
  ++visited_;
}

/// `interval-order`, `interval-whole`.
void RangeProofs::check_order(const RangeProof& claim, const std::string& place) const {
  const auto& [low, high] = claim.range;
  const auto require = [&](bool good, const char* rule, const std::string& found) {
    if (!good) throw Rejected{rule, std::nullopt, place, found};
  };
  const char* const order = "interval-order";
  require(low >= 0, order, "begins at " + show(low) + ", below 0");
  require(visited_ == 0 || end_, order, "follows an interval without an end");
  require(visited_ == 0 || low >= *end_, order,
          "begins at " + show(low) + ", before the one before ends");
  require(!high || (claim.stable ? low <= *high : low < *high), order,
          "begins at " + show(low) + ", and ends at " + show(high.value_or(0)));
  require(!claim.stable || high || (rests_ && low == 0), "interval-whole",
          "a proof about all multiples, but the wrench, a preload or the low end is not 0");
  require(!claim.stable || high || !question_.asked.max_motion, "interval-whole",
          "a proof about all multiples, but motions are bounded");
}

void RangeProofs::check_resisted(const RangeProof& claim, const std::string& place) {
  const auto& [low, high] = claim.range;
  // Without an end the laws are homogeneous, and 1 stands for all.
  const Range range = high ? Range{low, high} : Range{1, 1};
  if (claim.part.at_rest) {
    check_rest(*claim.part.at_rest, *question_.box, range, place);
    ++accepted_.rests;
  } else if (claim.part.sticking) {
    check_sticking(*claim.part.sticking, *question_.box, range, question_.asked, place);
    ++accepted_.stickings;
  } else if (claim.points.empty()) {
    count(check_degree(claim.part, question_.box, range, question_.asked, place), accepted_);
    ++accepted_.parts;
  } else {
    ForceSum sum;
    const auto first = check_point(question_, claim.points.front(), place + kFirst, sum);
    if (claim.points.size() == 2) {
      const auto second = check_point(question_, claim.points.back(), place + kSecond, sum);
      check_mode(question_, first, second, place);
    }
  }
  std::vector<Interval>& resisted = accepted_.resisted;
  if (resisted.empty() || resisted.back().high != low) {
    resisted.push_back({low, high});
  } else {
    resisted.back().high = high;
  }
}

void RangeProofs::check_refuted(const RangeProof& claim, const std::string& place) {
  const auto& [low, high] = claim.range;
  const Range range{low, high, low > 0 || rests_ || visited_ > 0, true};
  std::vector<Root> roots = roots_of(question_, {range});
  roots[0].path = place;
  TreeWalk walk(std::move(roots), place);
  for (const Node& node : claim.tree) walk.visit(node);
  walk.finish();
  count(walk, accepted_);
  ++accepted_.trees;
  accepted_.refuted.push_back(range);
}

}  // namespace stickslip_check
