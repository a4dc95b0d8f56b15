// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/margin.hpp"

#include <algorithm>
#include <list>
#include <utility>

#include "margin_chain.hpp"
#include "short_segments.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// An open range of multiples; also its low end if `has_low`.
struct Gap {
  Rational low;
  std::optional<Rational> high;
  bool has_low;
};

class MarginSearch {
 public:
  MarginSearch(const Problem& problem, const Wrench& direction, const ConeOptions& options,
               MarginWork& work)
      : problem_(problem),
        direction_(direction),
        options_(options),
        work_(work),
        modes_(problem.with_load({problem.wrench(), direction, 0, std::nullopt, true})) {}

  std::variant<Margin, Undecided> run() {
    const Gap all{0, std::nullopt, true};
    // The load itself is where the engine for single loads is quick, and most often stable.
    ConeWork cone;
    ++work_.ranges;
    Verdict verdict = decide_by_cones(problem_, options_, &cone);
    work_.cone += cone;
    if (auto* stable = std::get_if<Stable>(&verdict)) {
      take({0, std::move(stable->witness)}, all);
    } else {
      open_.push_back(all);
    }
    std::vector<std::pair<Rational, Refutation>> refuted;
    while (!open_.empty()) {
      const Gap gap = std::move(open_.front());
      open_.pop_front();
      auto found = search(gap);
      if (auto* undecided = std::get_if<Undecided>(&found)) return std::move(*undecided);
      if (auto* refutation = std::get_if<Unstable>(&found)) {
        refuted.emplace_back(gap.low, std::move(refutation->refutation));
        continue;
      }
      take(std::get<LoadPoint>(found), gap);
    }
    work_.modes = modes_.programs();
    return assemble(std::move(refuted));
  }

 private:
  /// Follows the modes from an equilibrium within the gap; what they do not reach stays open.
  void take(const LoadPoint& point, const Gap& gap) {
    const std::vector<LoadSegment> chain = modes_.chain_through(point, gap.low, gap.high);
    const Rational& first = chain.front().start.multiple;
    if (first > gap.low) open_.push_back({gap.low, first, gap.has_low});
    const std::optional<Rational>& last = chain.back().high;
    if (last && (!gap.high || *last < *gap.high)) open_.push_back({*last, gap.high, false});
    segments_.insert(segments_.end(), chain.begin(), chain.end());
  }

  std::variant<LoadPoint, Unstable, Undecided> search(const Gap& gap) {
    ConeOptions options = options_;
    if (options.node_limit != 0) {
      if (work_.cone.nodes >= options.node_limit) {
        return Undecided{"the limit of " + std::to_string(options.node_limit) + " nodes"};
      }
      options.node_limit -= work_.cone.nodes;
    }
    ++work_.ranges;
    ConeWork cone;
    auto found = search_loads(
        problem_.with_load({problem_.wrench(), direction_, gap.low, gap.high, gap.has_low}),
        options, &cone);
    work_.cone += cone;
    return found;
  }

  /// A mode that resists one multiple alone adds nothing to a segment that begins or ends
  /// there.
  void drop_idle_points() {
    std::vector<LoadSegment> kept;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const Rational& start = segments_[k].start.multiple;
      const bool is_point = segments_[k].high == start;
      const bool after_another = !kept.empty() && kept.back().high == start;
      const bool before_another =
          k + 1 < segments_.size() && segments_[k + 1].start.multiple == start;
      if (is_point && (after_another || before_another)) continue;
      kept.push_back(std::move(segments_[k]));
    }
    segments_ = std::move(kept);
  }

  void require_equilibrium(const Rational& multiple, const Witness& witness) const {
    const Wrench load = problem_.wrench() + multiple * direction_;
    require(!find_violation(problem_.with_load(LoadRange(load)), witness),
            "the end of a segment is not an equilibrium");
  }

  Margin assemble(std::vector<std::pair<Rational, Refutation>> refuted) {
    Margin margin;
    margin.direction = direction_;
    std::sort(segments_.begin(), segments_.end(), [](const auto& a, const auto& b) {
      // A point that is alone comes before what may begin at it.
      if (a.start.multiple != b.start.multiple) return a.start.multiple < b.start.multiple;
      return a.high && (!b.high || *a.high < *b.high);
    });
    drop_idle_points();
    shorten(segments_, problem_, direction_);
    for (const LoadSegment& segment : segments_) {
      require_equilibrium(segment.start.multiple, segment.start.witness);
      if (segment.high) require_equilibrium(*segment.high, segment.end);
      const bool continues =
          !margin.resisted.empty() && margin.resisted.back().high == segment.start.multiple;
      if (!continues) margin.resisted.push_back({segment.start.multiple, std::nullopt});
      margin.resisted.back().high = segment.high;
    }
    margin.segments = std::move(segments_);
    std::sort(refuted.begin(), refuted.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [low, refutation] : refuted) margin.gaps.push_back(std::move(refutation));
    return margin;
  }

  const Problem& problem_;
  const Wrench& direction_;
  const ConeOptions& options_;
  MarginWork& work_;
  LoadModes modes_;
  std::list<Gap> open_;
  std::vector<LoadSegment> segments_;
};

}  // namespace

std::variant<Margin, Undecided> find_margin(const Problem& problem, const Wrench& direction,
                                            const ConeOptions& options, MarginWork* work) {
  require(!(direction == Wrench{}), "a margin needs a direction");
  MarginWork unused;
  MarginWork& counters = work != nullptr ? *work : unused;
  counters = {};
  return MarginSearch(problem, direction, options, counters).run();
}

}  // namespace stickslip
