// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "solution.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/measures/claim.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

using namespace crosscheck_detail;

namespace {

/// Lowers the distance to this value, if that is less.
void lower(std::optional<DistanceBounds>& distance, const Rational& value) {
  if (!distance || value < *distance->high) distance = DistanceBounds{value, value};
}

/// The size of the load in units of force, and the length that makes torques comparable.
struct Scale {
  Rational force;
  Rational length;
};

Scale scale_of(const GraspBox& grasp) {
  Scale scale{0, largest_coordinate(grasp)};
  scale.force = size_of(components(grasp.wrench), scale.length);
  if (scale.force.is_zero()) {
    for (const UncertainContact& c : grasp.contacts) {
      scale.force = std::max(scale.force, c.preload.low);
    }
  }
  if (scale.force.is_zero()) scale.force = 1;
  return scale;
}

bool has_preload(const GraspBox& grasp) {
  return std::any_of(grasp.contacts.begin(), grasp.contacts.end(),
                     [](const UncertainContact& c) { return !c.preload.low.is_zero(); });
}

/// Returns the bounds in space by a margin along the load, as far as that is known.
std::optional<DistanceBounds> bounds_along_load(const Question& question, bool stable,
                                                std::size_t node_limit) {
  const RationalRow load = components(question.box()->wrench);
  if (largest(load).is_zero()) return std::nullopt;
  Question family{question.grasp, question.law};
  GraspBox& base = *family.grasp.box();
  base.wrench = WrenchBox(load.size());
  family.direction = load;
  SpatialMarginOptions options;
  // The class of a claim does not depend on this margin: it may take a second or two, and not
  // half a minute.
  constexpr std::size_t kFewNodes = 100;
  options.search.node_limit = node_limit != 0 ? node_limit : kFewNodes;
  const SpatialMargin margin = find_spatial_margin(family, options);

  DistanceBounds bounds;
  // `same` is how far the verdict is known to be the same, on both sides of 1.
  std::optional<Rational> same;
  bool is_known = false;
  for (const MarginInterval& known : stable ? margin.resisted() : margin.refuted()) {
    if (known.low > 1 || (known.high && *known.high < 1)) continue;
    is_known = true;
    // No multiples below 0 are asked about; but no load at all is held without preload.
    const bool has_change_below = !known.low.is_zero() || (!stable && !has_preload(base));
    if (has_change_below) same = 1 - known.low;
    if (known.high && (!same || *known.high - 1 < *same)) same = *known.high - 1;
    if (!stable && known.low.is_zero() && has_change_below) bounds.high = 1;
  }
  if (is_known && !same) return std::nullopt;
  bounds.low = same.value_or(0);
  for (const MarginInterval& other : stable ? margin.refuted() : margin.resisted()) {
    const Rational distance = other.low > 1                   ? Rational(other.low - 1)
                              : other.high && *other.high < 1 ? Rational(1 - *other.high)
                                                              : Rational(0);
    if (!bounds.high || distance < *bounds.high) bounds.high = distance;
  }
  return bounds;
}

/// The box of all loads beside that of the grasp.
class LoadsBeside {
 public:
  /// Takes the loads whose forces differ by at most the tie distance times the size of the
  /// load, and whose torques by at most as much times the length.
  LoadsBeside(const Question& question, bool stable, const ClaimOptions& options)
      : grasp_(*question.box()), law_(question.law), stable_(stable), options_(options) {
    const auto [force, length] = scale_of(grasp_);
    const std::size_t forces = grasp_.wrench.size() / 2;
    for (std::size_t j = 0; j < grasp_.wrench.size(); ++j) {
      reach_.push_back(options.tie_distance * force * (j < forces ? Rational(1) : length));
    }
  }

  /// Returns true if any of the loads has the other verdict; nothing if that is not known, and
  /// then `limit` says why.
  std::optional<bool> differ(std::optional<std::string>& limit) const {
    if (options_.tie_distance.is_zero()) return false;
    GraspBox all = grasp_;
    for (std::size_t j = 0; j < reach_.size(); ++j) {
      all.wrench[j].low -= reach_[j];
      all.wrench[j].high += reach_[j];
    }
    const Verdict verdict = decide(all);
    if (std::holds_alternative<Fragile>(verdict)) return true;
    if (const auto all_stable = is_stable(verdict)) {
      require(*all_stable == stable_, "a box of loads has the verdict of its middle");
      return false;
    }
    if (differs_at_some()) return true;
    limit = "whether all loads within the tie distance have the same verdict is open: " +
            in_words(std::get<Undecided>(verdict));
    return std::nullopt;
  }

 private:
  Verdict decide(const GraspBox& grasp) const {
    SearchOptions search;
    search.node_limit = options_.node_limit;
    return decide_box(grasp, law_, search).verdict;
  }

  bool differs_with(const RationalRow& change) const {
    GraspBox other = grasp_;
    for (std::size_t j = 0; j < change.size(); ++j) {
      other.wrench[j] = point_interval(other.wrench[j].low + change[j]);
    }
    return is_stable(decide(other)) == !stable_;
  }

  /// Returns true if a load along the load or along an axis has the other verdict.
  bool differs_at_some() const {
    std::vector<RationalRow> changes{
        sum(RationalRow(reach_.size()), options_.tie_distance, components(grasp_.wrench))};
    for (std::size_t j = 0; j < reach_.size(); ++j) {
      changes.emplace_back(reach_.size());
      changes.back()[j] = reach_[j];
    }
    return std::any_of(changes.begin(), changes.end(), [&](const RationalRow& change) {
      return differs_with(change) || differs_with(sum(RationalRow(change.size()), -1, change));
    });
  }

  const GraspBox& grasp_;
  NormalLaw law_;
  bool stable_;
  const ClaimOptions& options_;
  RationalRow reach_;
};

}  // namespace

std::optional<DistanceBounds> ThresholdDistance::smallest() const {
  std::optional<DistanceBounds> result;
  for (const auto& way : {along_load, along_axes, all_at_once}) {
    if (!way) continue;
    if (!result) result = way;
    result->low = std::min(result->low, way->low);
    if (way->high && (!result->high || *way->high < *result->high)) result->high = way->high;
  }
  if (all_at_once) {
    result->low = all_at_once->low;  // bounds the other ways as well
  } else if (limit) {
    result = DistanceBounds{0, result ? result->high : std::nullopt};
  }
  return result;
}

ThresholdDistance threshold_distance(const Problem& problem, const Grasp& grasp,
                                     std::size_t node_limit) {
  ThresholdDistance result;
  SearchOptions options;
  options.node_limit = node_limit;
  /// Returns the margin, or nothing at the limit.
  const auto margin = [&](const Problem& base, const Wrench& direction) {
    auto found = find_margin(base.along({row_of(direction)}), options);
    if (auto* undecided = std::get_if<Undecided>(&found)) {
      result.limit = std::move(undecided->limit);
      return std::optional<Margin>();
    }
    return std::optional<Margin>(std::get<Margin>(std::move(found)));
  };
  const Wrench& load = problem.wrench();
  if (!(load == Wrench{})) {
    if (const auto found = margin(problem.with_wrench({}), load)) {
      for (const MarginInterval& interval : found->resisted) {
        // Multiples begin at 0; this is no end of what is resisted.
        if (interval.low.sign() > 0) lower(result.along_load, abs(interval.low - 1));
        if (interval.high) lower(result.along_load, abs(*interval.high - 1));
      }
    }
  }
  const auto [force, length] = scale_of(box_of(LoadedGrasp{grasp, load}));
  for (const int sign : {1, -1}) {
    for (const Wrench& axis :
         {Wrench{force, 0, 0}, Wrench{0, force, 0}, Wrench{0, 0, force * length}}) {
      const Wrench direction = Rational(sign) * axis;
      const auto found = margin(problem, direction);
      if (!found || found->resisted.empty()) continue;
      const MarginInterval& first = found->resisted.front();
      // The nearest change is the end of what holds, or the beginning of what would.
      const bool holds = first.low.is_zero();
      if (holds && !first.high) continue;
      const Rational& change = holds ? *first.high : first.low;
      if (!result.along_axes || change < *result.along_axes->high) {
        result.along_axes = DistanceBounds{change, change};
        result.axis = row_of(direction);
      }
    }
  }
  return result;
}

ThresholdDistance threshold_distance(const Question& question, bool stable,
                                     const ClaimOptions& options) {
  if (question.box() == nullptr) {
    return threshold_distance(problem_of(question), question.loaded().grasp,
                              options.node_limit);
  }
  ThresholdDistance result;
  result.along_load = bounds_along_load(question, stable, options.node_limit);
  const auto differ = LoadsBeside(question, stable, options).differ(result.limit);
  const Rational& distance = options.tie_distance;
  result.all_at_once = DistanceBounds{differ == false ? distance : Rational(0),
                                      differ == true ? std::optional(distance) : std::nullopt};
  return result;
}

}  // namespace stickslip
