// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/margin.hpp"

#include <algorithm>
#include <list>
#include <utility>

#include "engine/equilibrium/search_end.hpp"
#include "margin_chain.hpp"
#include "margin_degree.hpp"
#include "short_segments.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/newton_equilibria.hpp"

namespace stickslip {

using namespace margin_detail;

namespace {

/// The bits of numbers from which a margin's many equilibria take longer than its proofs by
/// degree.
constexpr std::size_t kLongDenominator = 1000;

/// Checks one end of a segment after another.
class FamilyJudge {
 public:
  explicit FamilyJudge(const Problem& family)
      : family_(family), signs_(family), forces_(family) {}

  /// Requires an equilibrium of the member with the multiple; without one, a ray.
  void require_equilibrium(const std::optional<Rational>& multiple,
                           const ShortWitness& witness) {
    const Twist& d = witness.twist;
    const Vector5 x{d.x, d.y, d.r, multiple ? 1 : 0, multiple.value_or(Rational(1))};
    signs_.go_to(x);
    FamilyMode mode;
    for (std::size_t i = 0; i < family_.size(); ++i) {
      const Sign v = signs_.of(signs_.separation(i));
      require(v != Sign::kNegative || family_.law() == NormalLaw::kUnilateral,
              "a contact pulls at the end of a segment");
      mode.push_back({v == Sign::kPositive, signs_.of(signs_.slip(i))});
    }
    Vector3 total = coordinates(x[3] * family_.wrench() + x[4] * family_.load_growth());
    const std::array<Vector5, 3>& forces = forces_.of(mode);
    for (std::size_t j = 0; j < 3; ++j) total[j] += dot(forces[j], x);
    for (const auto& [contact, share] : witness.shares) {
      const ContactMode& at = mode[contact.index()];
      require(at.closed && at.slip == Sign::kZero && abs(share) <= 1,
              "no share of friction is that of a contact at the end of a segment");
      const ContactRow& row = family_.row(contact);
      const Rational b = share * row.friction * dot(family_.separation(contact), x);
      const Vector3 friction = coordinates(b * row.tangent);
      for (std::size_t j = 0; j < 3; ++j) total[j] += friction[j];
    }
    require(total == Vector3{}, "the end of a segment is not an equilibrium");
  }

 private:
  const Problem& family_;
  PointSigns signs_;
  ForceSum forces_;
};

class MarginSearch {
 public:
  using Progress = std::function<void(const MarginWork&)>;

  MarginSearch(const Problem& family, const SearchOptions& options, MarginWork& work,
               const Progress& progress, SegmentForm form)
      : family_(family),
        form_(form),
        options_(options),
        work_(work),
        progress_(progress),
        modes_(family.within({}), [this] { count(work_.modes); }) {}

  std::variant<Margin, Undecided> run() {
    const MultipleRange all;
    if (form_ == SegmentForm::kDegree ||
        (form_ == SegmentForm::kByLength && has_long_equilibria(family_, kLongDenominator))) {
      DegreeChain chain(family_);
      segments_ = chain.find();
      work_.proofs += chain.work().proofs;
      work_.cone += chain.work().cone;
    }
    if (!segments_.empty()) {
      open_between_segments();
      return search_all();
    }
    // The engine for single loads is quick at the multiple 0, which is most often stable.
    BranchWork cone;
    count(work_.ranges);
    Verdict verdict = branch_and_bound(family_.at(0), options_, &cone);
    work_.cone += cone;
    if (auto* stable = std::get_if<Stable>(&verdict)) {
      take({0, std::move(std::get<Witness>(stable->proof))}, all);
    } else {
      open_.push_back(all);
    }
    return search_all();
  }

 private:
  std::variant<Margin, Undecided> search_all() {
    std::vector<std::pair<Rational, Trees>> refuted;
    while (!open_.empty()) {
      const MultipleRange gap = std::move(open_.front());
      open_.pop_front();
      auto found = search(gap);
      if (auto* undecided = std::get_if<Undecided>(&found)) return std::move(*undecided);
      if (auto* refutation = std::get_if<Unstable>(&found)) {
        refuted.emplace_back(gap.low, std::move(refutation->tree));
        continue;
      }
      take(std::get<MarginPoint>(found), gap);
    }
    return assemble(std::move(refuted));
  }

  /// Opens the ranges that the segments, which are increasing, leave.
  void open_between_segments() {
    Rational low = 0;
    bool has_low = true;
    for (const MarginSegment& segment : segments_) {
      if (low < segment.low) open_.push_back({low, segment.low, has_low});
      if (!segment.high) return;
      low = *segment.high;
      has_low = false;
    }
    open_.push_back({low, {}, has_low});
  }

  void count(std::size_t& counter) {
    ++counter;
    if (progress_) progress_(work_);
  }

  /// Follows the modes from an equilibrium within the gap; what they do not reach stays open.
  void take(const MarginPoint& point, const MultipleRange& gap) {
    const std::vector<MarginSegment> chain = modes_.chain_through(point, gap.low, gap.high);
    const Rational& first = chain.front().low;
    if (first > gap.low) open_.push_back({gap.low, first, gap.has_low});
    const std::optional<Rational>& last = chain.back().high;
    if (last && (!gap.high || *last < *gap.high)) open_.push_back({*last, gap.high, false});
    segments_.insert(segments_.end(), chain.begin(), chain.end());
  }

  std::variant<MarginPoint, Unstable, Undecided> search(const MultipleRange& gap) {
    SearchOptions options = options_;
    if (options.node_limit != 0) {
      if (work_.cone.nodes >= options.node_limit) {
        return limit_reached(options.node_limit);
      }
      options.node_limit -= work_.cone.nodes;
    }
    count(work_.ranges);
    BranchWork cone;
    auto found = search_family(family_.within(gap), options, &cone);
    work_.cone += cone;
    // Names the limit for all nodes, not the part of it that was left for this search.
    if (std::holds_alternative<Undecided>(found)) {
      return limit_reached(options_.node_limit);
    }
    return found;
  }

  /// A mode that resists one multiple alone adds nothing to a segment that begins or ends
  /// there.
  void drop_idle_points() {
    std::vector<MarginSegment> kept;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const Rational& start = segments_[k].low;
      const bool is_point = segments_[k].high == start;
      const bool after_another = !kept.empty() && kept.back().high == start;
      const bool before_another = k + 1 < segments_.size() && segments_[k + 1].low == start;
      if (is_point && (after_another || before_another)) continue;
      kept.push_back(std::move(segments_[k]));
    }
    segments_ = std::move(kept);
  }

  Margin assemble(std::vector<std::pair<Rational, Trees>> refuted) {
    Margin margin;
    std::sort(segments_.begin(), segments_.end(), [](const auto& a, const auto& b) {
      // A segment of one multiple comes before any that begins at it.
      if (a.low != b.low) return a.low < b.low;
      return a.high && (!b.high || *a.high < *b.high);
    });
    drop_idle_points();
    shorten(segments_, family_);
    FamilyJudge judge(family_);
    for (const MarginSegment& segment : segments_) {
      if (!segment.proof) {
        judge.require_equilibrium(segment.low, segment.start);
        judge.require_equilibrium(segment.high, segment.end);
      }
      const bool continues =
          !margin.resisted.empty() && margin.resisted.back().high == segment.low;
      if (!continues) margin.resisted.push_back({segment.low, std::nullopt});
      margin.resisted.back().high = segment.high;
    }
    margin.segments = std::move(segments_);
    std::sort(refuted.begin(), refuted.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [low, refutation] : refuted) margin.gaps.push_back(std::move(refutation));
    return margin;
  }

  const Problem& family_;
  const SegmentForm form_;
  const SearchOptions& options_;
  MarginWork& work_;
  const Progress& progress_;
  FamilyModes modes_;
  std::list<MultipleRange> open_;
  std::vector<MarginSegment> segments_;
};

}  // namespace

std::variant<Margin, Undecided> find_margin(
    const Problem& family, const SearchOptions& options, MarginWork* work,
    const std::function<void(const MarginWork&)>& progress, SegmentForm form) {
  require(family.is_family(), "a margin is of a family");
  MarginWork unused;
  MarginWork& counters = work != nullptr ? *work : unused;
  counters = {};
  return MarginSearch(family, options, counters, progress, form).run();
}

}  // namespace stickslip
