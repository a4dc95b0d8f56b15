// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/spatial_margin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/degree/exact_witness.hpp"
#include "engine/degree/prove_stable.hpp"
#include "engine/search/law_forces.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/force_span.hpp"

namespace stickslip {

namespace {

/// An equilibrium of the member of the family with this multiple.
struct Member {
  Rational multiple;
  NearEquilibrium near;
  std::optional<ShareWitness> witness;  ///< where nothing that has friction slips
};

/// Returns the friction of this contact at a witness in the plane, over the most that it may
/// be.
Rational share_of(const LawContact& c, const ShareWitness& witness, std::size_t contact) {
  const Row& slip = c.corners.front().slip.front();
  const int sign = dot(slip, primitive_multiple(witness.twist)).sign();
  if (sign != 0) return -sign;
  for (const auto& [at, share] : witness.shares) {
    if (at.index() == contact) return share.front();
  }
  return 0;
}

/// Returns true if two equilibria in the plane agree at a contact: neither slips, or they slip
/// one way at most, and each that presses there has all its friction against that slip.
bool slip_alike(const LawContact& c, const ShareWitness& a, const ShareWitness& b,
                std::size_t contact, const int (&presses)[2]) {
  const Row& slip = c.corners.front().slip.front();
  const int signs[] = {dot(slip, primitive_multiple(a.twist)).sign(),
                       dot(slip, primitive_multiple(b.twist)).sign()};
  if (signs[0] * signs[1] < 0) return false;
  const int sign = signs[0] + signs[1] > 0 ? 1 : signs[0] + signs[1] < 0 ? -1 : 0;
  if (sign == 0) return true;
  return (presses[0] <= 0 || share_of(c, a, contact) == -sign) &&
         (presses[1] <= 0 || share_of(c, b, contact) == -sign);
}

/// Returns true if all combinations of the two are equilibria.
bool are_of_one_mode(const GraspLaw& family, const Member& a, const Member& b) {
  for (std::size_t i = 0; i < family.contacts.size(); ++i) {
    const LawContact& c = family.contacts[i];
    if (c.is_spring) continue;  // its force is linear
    const CornerRow& row = c.corners.front();
    const auto separation = [&](const Member& at) -> Rational {
      return c.preload.low + at.multiple * c.rate.low -
             c.stiffness.low * dot(row.normal, at.witness->twist);
    };
    const int signs[] = {separation(a).sign(), separation(b).sign()};
    if (signs[0] * signs[1] < 0) return false;
    if (c.friction.high.is_zero() || (signs[0] <= 0 && signs[1] <= 0)) continue;
    if (c.slip_dimension() == 1) {
      if (!slip_alike(c, *a.witness, *b.witness, i, signs)) return false;
      continue;
    }
    for (const Member* at : {&a, &b}) {
      const Row twist = primitive_multiple(at->witness->twist);
      for (const Row& s : row.slip) {
        if (!dot(s, twist).is_zero()) return false;
      }
    }
  }
  return true;
}

const Rational& low_end(const MultiplesClaim& claim) {
  return std::visit([](const auto& c) -> const Rational& { return c.low; }, claim);
}

class SpatialMarginSearch {
 public:
  SpatialMarginSearch(const Question& question, const SpatialMarginOptions& options,
                      const std::function<void(const SpatialMargin&)>& progress)
      : model_(law_of(question, options.search.bits)),
        accuracy_(options.accuracy),
        node_limit_(options.search.node_limit != 0 ? options.search.node_limit : kNodeLimit),
        progress_(progress) {
    margin_.bits = options.search.bits;
    double growth = 0;
    if (model_.growing.size() > 0) growth = model_.growing.lpNorm<Eigen::Infinity>();
    for (const LawContact& c : model_.contacts) {
      growth = std::max(growth, std::fabs(c.rates[1]) * c.size);
    }
    is_rational_ = std::all_of(
        model_.contacts.begin(), model_.contacts.end(),
        [](const LawContact& c) { return c.preload.is_point() && c.rate.is_point(); });
    const double typical = model_.force / growth;
    if (std::isfinite(typical) && typical > 0) {
      unit_ = rational_from_double(std::ldexp(1.0, std::ilogb(typical)));
    }
    may_be_far_ =
        model_.max_motion.empty() && !model_.far_motion.empty() && model_.may_be_rounded();
    const bool scales = model_.max_motion.empty();
    is_homogeneous_ =
        scales && std::all_of(model_.contacts.begin(), model_.contacts.end(),
                              [](const LawContact& c) { return c.preload.high.is_zero(); });
    for (const Interval& w : model_.wrench) {
      is_homogeneous_ = is_homogeneous_ && w.low.is_zero();
    }
  }

  SpatialMargin run() {
    try {
      search();
    } catch (const Cancelled&) {
      if (progress_ && !margin_.claims.empty()) progress_(in_order(std::move(margin_)));
      throw;
    }
    return in_order(std::move(margin_));
  }

 private:
  void search() {
    if (is_homogeneous_) {
      settle_at_once();
    } else if (!settle_unopposed()) {
      Rational end = follow_from_zero();
      if (!margin_.claims.empty() && end < most() && !refuted_at_once(end)) {
        takes_long_ = !margin_.ended_far;
        end = follow_on(end);
      }
      if (margin_.claims.empty()) {
        takes_long_ = true;
        searches_ = kMostSearches / 2;  // the others are for what is refuted
        for (const Rational& multiple : seeds()) look_at(multiple);
        searches_ = kMostSearches;
        claim_between();
      } else if (end < most() && takes_long_) {
        claim_all({end + least_step(end), {}, false, end, most()});
      }
    }
  }

  static constexpr std::size_t kNodeLimit = 4000;
  static constexpr std::size_t kMostSearches = 10;
  static constexpr std::size_t kStarts = 3;
  static constexpr std::size_t kLittle = 400;  // nodes

  /// Returns true if all searches together have spent their nodes.
  bool is_spent() const { return margin_.work.nodes > searches_ * node_limit_; }
  /// Returns the node limit of the tree of one wall.
  std::size_t wall_limit() const { return std::max<std::size_t>(node_limit_ / 24, 1); }
  /// Returns the multiple beyond which no equilibrium is followed.
  Rational most() const { return 1024 * unit_; }
  Rational least_step(const Rational& multiple) const {
    return accuracy_ * std::max(multiple, Rational(unit_ / 16)) / 2;
  }

  /// Settles homogeneous laws: all multiples above 0 have one verdict.
  void settle_at_once() {
    const GraspLaw there = model_.middle(1);
    const auto holds = [&](const NearEquilibrium& near) {
      if (auto witness = witness_at(1, near)) {
        claim_resisted(0, {}, SpatialSegment{std::move(*witness), {}});
      } else if (auto still = prove_still({1, 1}, near)) {
        claim_resisted(0, {}, std::move(*still));
      } else if (auto proof = prove({1, 1}, there, near, wall_limit())) {
        claim_resisted(0, {}, std::move(*proof));
      }
      return !margin_.claims.empty();
    };
    for (const NearEquilibrium& near : equilibria_of(there)) {
      if (holds(near)) return;
    }
    Trees tree;
    LawSearch search(there, nullptr, node_limit_, margin_.work);
    search.on_candidate([&](const NearEquilibrium& relaxed) {
      const auto found = polished(there, relaxed);
      return found && holds(*found);
    });
    if (may_be_far_) search.forces().keep_near();
    if (!search.refute(MotionRegion::root(there), tree)) {
      margin_.ended_far = may_be_far_ && search.end() == SearchEnd::kUnbounded;
      return;
    }
    // l takes the place of h, which is in none of the laws.
    for (TreeNode& node : tree) {
      if (auto* split = std::get_if<PlaneCut>(&node)) {
        std::swap(split->plane[model_.motions], split->plane[model_.motions + 1]);
      }
    }
    margin_.claims.emplace_back(RefutedMultiples{0, {}, std::move(tree)});
  }

  /// Tries to refute all multiples above 0 by one leaf, which it can if the load grows along a
  /// free motion. (Often the load does so by rounding alone: see margin_within().) Returns
  /// false if it cannot.
  bool settle_unopposed() {
    const std::optional<Row> twist = unopposed_twist(model_.middle(1));
    const GraspLaw above = model_.within({0, {}, false});
    if (!twist || !MotionRegion::root(above).is_refuted(*twist, nullptr)) return false;
    for (const NearEquilibrium& near : equilibria_of(model_.middle(0))) {
      if (claim_one(member(0, near))) break;
    }
    // A proof by degree about 0 needs one about other multiples, so 0 may be resisted without a
    // claim; the refuted range then begins above it.
    const Rational low = margin_.claims.empty() ? least_step(0) : Rational(0);
    margin_.claims.emplace_back(RefutedMultiples{low, {}, Trees{TwistLeaf{*twist}}});
    return true;
  }

  /// Returns the multiples at which to look for what is resisted, if that does not begin at 0.
  std::vector<Rational> seeds() const {
    std::vector<Rational> result{0};
    for (Rational multiple = unit_ / 8; multiple <= 64 * unit_; multiple *= 2) {
      result.push_back(multiple);
    }
    return result;
  }

  /// Follows an equilibrium of this multiple up and down, if no claim is about it.
  void look_at(const Rational& multiple) {
    if (is_spent()) return;
    Rational floor = 0;
    Rational ceiling = most();
    for (const MultiplesClaim& claim : margin_.claims) {
      const auto& resisted = std::get<ResistedMultiples>(claim);
      if (resisted.low <= multiple && multiple <= *resisted.high) return;
      if (*resisted.high < multiple) floor = std::max(floor, *resisted.high);
      if (resisted.low > multiple) ceiling = std::min(ceiling, resisted.low);
    }
    for (const NearEquilibrium& near : equilibria_of(model_.middle(multiple))) {
      const Member start = member(multiple, near);
      const Rational up = follow(start, ceiling);
      const Rational down = follow(start, floor);
      if (up != down || claim_one(start)) return;
    }
  }

  /// Claims that this one multiple is resisted. Returns false if no proof is found.
  bool claim_one(const Member& at) {
    if (at.witness) {
      claim_resisted(at.multiple, at.multiple, SpatialSegment{*at.witness, {}});
      return true;
    }
    const MultipleRange one{at.multiple, at.multiple};
    if (auto still = prove_still(one, at.near)) {
      claim_resisted(at.multiple, at.multiple, std::move(*still));
      return true;
    }
    auto proof = prove(one, model_.middle(at.multiple), at.near, wall_limit());
    if (proof) claim_resisted(at.multiple, at.multiple, std::move(*proof));
    return proof.has_value();
  }

  /// Claims what it can between the resisted ranges, below and above them.
  void claim_between() {
    std::vector<std::pair<Rational, Rational>> known;
    for (const MultiplesClaim& claim : margin_.claims) {
      const auto& resisted = std::get<ResistedMultiples>(claim);
      known.emplace_back(resisted.low, *resisted.high);
    }
    std::sort(known.begin(), known.end());
    // The range above all others comes first, as it is mostly refuted at once.
    std::vector<Range> gaps;
    Range gap{0, {}, true, 0, most()};
    for (const auto& [from, to] : known) {
      gap.high = from - least_step(from);
      gap.ceiling = from;
      gaps.push_back(gap);
      gap = {to + least_step(to), {}, false, to, most()};
    }
    if (gap.floor < most()) gaps.push_back(gap);
    for (auto range = gaps.rbegin(); range != gaps.rend(); ++range) claim_all(*range);
  }

  /// Returns the multiple that it came to.
  Rational follow_from_zero() {
    for (const NearEquilibrium& near : equilibria_of(model_.middle(0))) {
      const Rational end = follow(member(0, near), most());
      if (!margin_.claims.empty()) return end;
    }
    return 0;
  }

  /// Follows the equilibria at the multiple `end` farther, if it can; returns how far it came.
  Rational follow_on(const Rational& end) {
    for (const NearEquilibrium& near : equilibria_of(model_.middle(end))) {
      const Rational farther = follow(member(end, near), most());
      if (farther > end) return farther;
    }
    return end;
  }

  /// Returns true if a short search refutes all that is a little above a multiple: then nothing
  /// is followed there. Records as well whether far motions ended the search.
  bool refuted_at_once(const Rational& end) {
    for (const int steps : {1, 5}) {
      const Rational low = end + steps * least_step(end);
      const GraspLaw above = model_.within({low, {}, false});
      LawSearch search(above, nullptr, std::min(node_limit_, kLittle), margin_.work);
      if (may_be_far_) search.forces().keep_near();
      Trees tree;
      if (search.refute(MotionRegion::root(above), tree)) {
        margin_.claims.emplace_back(RefutedMultiples{low, {}, std::move(tree)});
        return true;
      }
      margin_.ended_far = may_be_far_ && search.end() == SearchEnd::kUnbounded;
    }
    return false;
  }

  /// The range (low, high), and low as well if has_low. Equilibria in it may be followed down
  /// to the floor and up to the ceiling.
  struct Range {
    Rational low;
    std::optional<Rational> high;
    bool has_low;
    Rational floor;
    Rational ceiling;
  };

  /// Claims as much of a range as it can.
  void claim_all(const Range& range) {
    if (range.high && *range.high <= range.low) return;
    if (auto tree = settle(range)) {
      margin_.claims.emplace_back(RefutedMultiples{range.low, range.high, std::move(*tree)});
      report();
    }
  }

  /// Returns a tree that refutes all of a range; or else claims what it can of its parts, and
  /// returns nothing.
  std::optional<Trees> settle(const Range& range) {
    const auto& [low, high, has_low, floor, ceiling] = range;
    if (high && *high - low <= 2 * least_step(*high)) return std::nullopt;
    if (is_spent()) return std::nullopt;
    std::optional<std::pair<Rational, Rational>> resisted;
    const GraspLaw whole = model_.within({low, high, has_low});
    LawSearch search(whole, nullptr, node_limit_, margin_.work);
    if (may_be_far_) search.forces().keep_near();
    search.on_candidate([&](const NearEquilibrium& relaxed) {
      if (!std::isfinite(relaxed.multiple)) return false;
      const Rational grain = least_step(0);
      const Rational steps = rational_from_double(relaxed.multiple) / grain;
      const Rational at = Rational(numerator(steps) / denominator(steps)) * grain;
      if (at <= range.low || at >= range.ceiling) return false;
      const auto found = polished(model_.middle(at), relaxed);
      if (!found) return false;
      const Member start = member(at, *found);
      const Rational up = follow(start, range.ceiling);
      const Rational down = follow(start, range.floor);
      if (up == down) return false;
      resisted = {down, up};
      return true;
    });
    Trees tree;
    if (search.refute(MotionRegion::root(whole), tree)) return tree;
    if (resisted) {
      const auto& [down, up] = *resisted;
      claim_all({low, down - least_step(down), has_low, floor, down});
      if (high || up < most()) {
        claim_all({up + least_step(up), high, false, up, ceiling});
      }
      return std::nullopt;
    }
    if (may_be_far_ && search.end() == SearchEnd::kUnbounded) {
      margin_.ended_far = true;  // so too in all parts of the range
      return std::nullopt;
    }
    const Rational middle = high ? (low + *high) / 2 : std::max(Rational(2 * low), unit_);
    if (!high && middle >= most()) return std::nullopt;
    auto below = settle({low, middle, has_low, floor, middle});
    auto above = settle({middle, high, true, middle, ceiling});
    if (below && above) return joined(middle, *below, *above);
    if (below) margin_.claims.emplace_back(RefutedMultiples{low, middle, std::move(*below)});
    if (above) margin_.claims.emplace_back(RefutedMultiples{middle, high, std::move(*above)});
    return std::nullopt;
  }

  /// Returns the tree of both sides of a multiple, which belongs to the upper side.
  Trees joined(const Rational& multiple, const Trees& below, const Trees& above) const {
    Row plane(model_.coordinates());
    plane[model_.motions] = -numerator(multiple);
    plane[model_.motions + 1] = denominator(multiple);
    Trees both{PlaneCut{plane}};
    both.insert(both.end(), above.begin(), above.end());
    both.insert(both.end(), below.begin(), below.end());
    return both;
  }

  /// Puts claims in order, and joins refuted ranges that touch: the upper one was refuted with
  /// its low end.
  SpatialMargin in_order(SpatialMargin margin) const {
    std::sort(margin.claims.begin(), margin.claims.end(),
              [](const auto& a, const auto& b) { return low_end(a) < low_end(b); });
    std::vector<MultiplesClaim> claims;
    for (auto& claim : margin.claims) {
      auto* next = std::get_if<RefutedMultiples>(&claim);
      auto* last = claims.empty() ? nullptr : std::get_if<RefutedMultiples>(&claims.back());
      if (next != nullptr && last != nullptr && last->high == next->low) {
        last->tree = joined(next->low, last->tree, next->tree);
        last->high = std::move(next->high);
      } else {
        claims.push_back(std::move(claim));
      }
    }
    margin.claims = std::move(claims);
    return margin;
  }

  /// Follows an equilibrium towards a multiple, and claims the ranges on the way; returns how
  /// far it came.
  Rational follow(Member from, const Rational& to) {
    while (from.multiple != to) {
      const Rational before = from.multiple;
      from = follow_by_witnesses(std::move(from), to);
      from = follow_at_rest(std::move(from), to);
      from = follow_by_degree(std::move(from), to);
      if (from.multiple == before) break;
    }
    return from.multiple;
  }

  /// Returns a multiple from one towards another, by at most a step.
  static Rational towards(const Rational& from, const Rational& to, const Rational& step) {
    return from < to ? std::min(Rational(from + step), to)
                     : std::max(Rational(from - step), to);
  }

  /// Follows by witnesses as far as their mode goes, if nothing slips in it.
  Member follow_by_witnesses(Member from, const Rational& to) {
    Member last = from;
    Rational step = abs(to - from.multiple);
    while (from.witness && last.multiple != to && step >= least_step(last.multiple) / 8) {
      throw_if_cancelled();
      const Rational next = towards(last.multiple, to, step);
      auto near = equilibrium_at(next, last.near);
      if (near) {
        Member there = member(next, *near);
        if (there.witness && are_of_one_mode(model_, from, there)) {
          last = std::move(there);
          continue;
        }
      }
      step /= 2;
    }
    if (last.multiple != from.multiple) {
      const bool up = last.multiple > from.multiple;
      const Member& low = up ? from : last;
      const Member& high = up ? last : from;
      claim_resisted(low.multiple, high.multiple, SpatialSegment{*low.witness, *high.witness});
    }
    return last;
  }

  /// Follows as far as friction holds all contacts that are closed.
  Member follow_at_rest(Member from, const Rational& to) {
    Rational step = abs(to - from.multiple);
    constexpr int kMostProofs = 64;  // where small steps alone are proved, others serve better
    for (int proofs = 0; from.multiple != to && proofs < kMostProofs;) {
      throw_if_cancelled();
      if (step < least_step(from.multiple) / 8) break;
      const Rational next = towards(from.multiple, to, step);
      const MultipleRange range{std::min(from.multiple, next), std::max(from.multiple, next)};
      const auto between = equilibrium_at((range.low + *range.high) / 2, from.near);
      auto proof = between ? prove_still(range, *between) : std::nullopt;
      const auto there = proof ? equilibrium_at(next, *between) : std::nullopt;
      if (there) {
        claim_resisted(range.low, range.high, std::move(*proof));
        from = member(next, *there);
        ++proofs;
      } else {
        step /= 2;
      }
    }
    return from;
  }

  /// Returns a proof that takes no tree, for all multiples of a range.
  std::optional<decltype(ResistedMultiples::proof)> prove_still(
      const MultipleRange& range, const NearEquilibrium& middle) const {
    const GraspLaw members = model_.within(range);
    if (auto rest = prove_at_rest(members, middle)) return std::move(*rest);
    if (auto sticking = prove_sticking(members, middle)) return std::move(*sticking);
    return std::nullopt;
  }

  /// Follows by degree, in steps that are small first, until there is a witness. Proofs that
  /// take long are tried only if this leads nowhere.
  Member follow_by_degree(Member from, const Rational& to) {
    const Rational begin = from.multiple;
    const Rational first = 4 * least_step(begin);
    Rational step = first;
    std::size_t limit = 0;
    bool grows = true;  // a step that has failed seldom serves a little farther on
    while (from.multiple != to && !is_spent()) {
      throw_if_cancelled();
      if (step < least_step(from.multiple)) {
        if (limit != 0 || from.multiple != begin || !takes_long_) break;
        limit = wall_limit();
        step = first;
      }
      const Rational next = towards(from.multiple, to, step);
      const MultipleRange range{std::min(from.multiple, next), std::max(from.multiple, next)};
      const auto there = equilibrium_at(next, from.near);
      const Rational middle = (range.low + *range.high) / 2;
      const auto between = there ? equilibrium_at(middle, from.near) : std::nullopt;
      std::optional<DegreeProof> proof;
      if (between) {
        proof = prove(range, model_.middle(middle), *between, limit);
      }
      if (!proof) {
        step /= 2;
        grows = false;
        continue;
      }
      claim_resisted(range.low, range.high, std::move(*proof));
      from = member(next, *there);
      if (from.witness) break;
      if (grows) step *= 2;
      grows = true;
    }
    return from;
  }

  static std::vector<NearEquilibrium> equilibria_of(const GraspLaw& law) {
    const RoundedGrasp rounded = rounded_middle(law);
    return Newton(rounded).solve_from(kStarts);
  }
  static std::optional<NearEquilibrium> polished(const GraspLaw& law,
                                                 const NearEquilibrium& near) {
    const RoundedGrasp rounded = rounded_middle(law);
    return Newton(rounded).polish(near);
  }

  Member member(const Rational& multiple, const NearEquilibrium& near) const {
    return {multiple, near, witness_at(multiple, near)};
  }

  std::optional<ShareWitness> witness_at(const Rational& multiple,
                                         const NearEquilibrium& near) const {
    auto witness = is_rational_ ? exact_witness(model_.middle(multiple), near) : std::nullopt;
    if (witness && !model_.allows(witness->twist)) witness.reset();
    return witness;
  }

  std::optional<NearEquilibrium> equilibrium_at(const Rational& multiple,
                                                const NearEquilibrium& start) const {
    const RoundedGrasp there = rounded_middle(model_.middle(multiple));
    const Newton newton(there);
    if (auto found = newton.polish(start)) return found;
    auto found = newton.solve(start.motion);  // perhaps another one
    return found ? newton.polish(std::move(*found)) : std::nullopt;
  }

  std::optional<DegreeProof> prove(const MultipleRange& range, const GraspLaw& middle,
                                   const NearEquilibrium& near, std::size_t limit) {
    const bool is_wide = range.low != range.high;
    return prove_by_degree(model_.within(range), middle, near,
                           {limit, kMostSearches * node_limit_, is_wide}, margin_.work);
  }

  void claim_resisted(const Rational& low, const std::optional<Rational>& high,
                      decltype(ResistedMultiples::proof) proof) {
    margin_.claims.emplace_back(ResistedMultiples{low, high, std::move(proof)});
    report();
  }

  void report() const {
    if (progress_) progress_(margin_);
  }

  GraspLaw model_;
  bool is_rational_ = true;  ///< all lengths that matter are rational, so that there may be
                             ///< witnesses
  Rational accuracy_;
  std::size_t node_limit_;
  const std::function<void(const SpatialMargin&)>& progress_;
  Rational unit_ = 1;  ///< a typical multiple, a power of 2
  bool is_homogeneous_ = true;
  bool takes_long_ = false;  ///< proofs that take many nodes are tried
  bool may_be_far_ = false;  ///< far motions may take all time, and rounding decides them
  std::size_t searches_ = kMostSearches;  ///< searches whose nodes may be spent by now
  SpatialMargin margin_;
};

}  // namespace

std::vector<MarginInterval> SpatialMargin::resisted() const {
  std::vector<MarginInterval> intervals;
  for (const auto& claim : claims) {
    const auto* part = std::get_if<ResistedMultiples>(&claim);
    if (part == nullptr) continue;
    if (!intervals.empty() && intervals.back().high == part->low) {
      intervals.back().high = part->high;
    } else {
      intervals.push_back({part->low, part->high});
    }
  }
  return intervals;
}

std::vector<MarginInterval> SpatialMargin::refuted() const {
  std::vector<MarginInterval> intervals;
  for (const auto& claim : claims) {
    if (const auto* part = std::get_if<RefutedMultiples>(&claim)) {
      intervals.push_back({part->low, part->high});
    }
  }
  return intervals;
}

SpatialMargin find_spatial_margin(const Question& question, const SpatialMarginOptions& options,
                                  const std::function<void(const SpatialMargin&)>& progress) {
  require(question.has_claims(), "a margin that is a list of claims");
  return SpatialMarginSearch(question, options, progress).run();
}

}  // namespace stickslip
