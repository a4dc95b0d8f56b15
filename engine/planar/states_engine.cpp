// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/states_engine.hpp"

#include <algorithm>
#include <set>

#include "few_shares.hpp"
#include "find_flaw.hpp"
#include "region_program.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/verdict.hpp"

namespace stickslip {

using namespace planar_detail;

namespace {

/// Slip states that a region has motions of.
using Group = std::vector<const SlipState*>;
struct GroupRegion {
  Region region;
  Group group;
};

/// Refutes the enumerated states in groups, as large as one virtual twist allows: all of them,
/// those with one sign of slip at some contact, and so on down to single states.
class StatesEngine {
 public:
  StatesEngine(const Problem& problem, StatesWork& work) : problem_(problem), work_(work) {}

  Verdict decide() {
    std::vector<Vector3> planes;
    for (const ContactRow& row : problem_.rows()) planes.push_back(coordinates(row.tangent));
    const SlipStates slip = enumerate_slip_states_cgal(planes);
    work_.states = slip.states.size();
    const Region root = Region::root(problem_);
    // All-stick sorts last, is the cheapest to solve, and often the answer.
    const SlipState& stick = slip.states.back();
    if (!refute(root.with_slip_state(problem_, stick), {&stick}, Coverage::kPart))
      return stable();
    Group all;
    for (const SlipState& state : slip.states) all.push_back(&state);
    std::optional<Trees> tree = refute(root, all, Coverage::kWhole);
    if (!tree) return stable();
    require(work_.states_refuted == work_.states, "a slip state is not refuted");
    return Unstable{std::move(*tree)};
  }

 private:
  /// Whether a region has all motions of its states, or those on one side of a separation.
  enum class Coverage { kWhole, kPart };

  /// Returns a tree that covers the region; nothing when an equilibrium was found.
  std::optional<Trees> refute(const Region& region, const Group& group, Coverage coverage) {
    if (region.is_barred()) return leaf(group, coverage, TwistLeaf{Row(3)});
    require(!group.empty(), "a region's slip state is missing from the enumeration");
    auto outcome = solve(region);
    if (group.size() == 1 && solved_.insert(group.front()).second) ++work_.states_solved;
    if (const auto* found = std::get_if<TwistLeaf>(&outcome)) {
      return leaf(group, coverage, *found);
    }
    auto& point = std::get<RelaxedPoint>(outcome);
    if (!point.broken) {
      witness_ = std::move(point.witness);
      return std::nullopt;
    }
    if (point.broken_separation) {
      return split_by_separation(region, group, coverage, point);
    }
    return split_by_slip(region, group, coverage, point);
  }

  Trees leaf(const Group& group, Coverage coverage, const TwistLeaf& twist) {
    if (coverage == Coverage::kWhole) work_.states_refuted += group.size();
    return {twist};
  }

  std::optional<Trees> split_by_slip(const Region& region, const Group& group,
                                     Coverage coverage, const RelaxedPoint& point) {
    const ContactId contact = std::get<SlipSplit>(*point.broken).contact;
    const Sign at = sign_of(power(problem_.row(contact).tangent, point.witness.twist));
    std::vector<GroupRegion> parts;
    std::size_t first = 0;
    for (const Sign sign : {Sign::kPositive, Sign::kZero, Sign::kNegative}) {
      if (sign == at) first = parts.size();
      parts.push_back({region.slip_child(problem_, contact, sign), {}});
      for (const SlipState* state : group)
        if ((*state)[contact.index()] == sign) parts.back().group.push_back(state);
    }
    return refute_parts(SlipSplit{contact}, parts, first, coverage);
  }

  std::optional<Trees> split_by_separation(const Region& region, const Group& group,
                                           Coverage coverage, const RelaxedPoint& point) {
    const ContactId contact = point.broken_separation->contact;
    const auto [x, y, r] = coordinates(point.witness.twist);
    const Rational v = dot(problem_.separation(contact), Vector5{x, y, r, 1, 0});
    auto tree =
        refute_parts(SeparationSplit{contact},
                     {{region.separation_child(problem_, contact, Separation::kClosed), group},
                      {region.separation_child(problem_, contact, Separation::kOpen), group}},
                     v.sign() < 0 ? 1 : 0, Coverage::kPart);
    if (tree && coverage == Coverage::kWhole) work_.states_refuted += group.size();
    return tree;
  }

  /// Refutes the parts from the first on, which is where the point of the relaxation lies: an
  /// equilibrium may be near.
  std::optional<Trees> refute_parts(const TreeNode& node, const std::vector<GroupRegion>& parts,
                                    std::size_t first, Coverage coverage) {
    std::vector<Trees> trees(parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::size_t p = (first + k) % parts.size();
      std::optional<Trees> tree = refute(parts[p].region, parts[p].group, coverage);
      if (!tree) return std::nullopt;
      trees[p] = std::move(*tree);
    }
    Trees whole{node};
    for (const Trees& tree : trees) whole.insert(whole.end(), tree.begin(), tree.end());
    return whole;
  }

  /// Solves the common system of the states in a region. The twist that refuted the last ones
  /// may do for these; if not, it is where to start from.
  std::variant<RelaxedPoint, TwistLeaf> solve(const Region& region) {
    LpWork lp;
    auto outcome = solve_region(problem_, region, &lp, last_ ? &*last_ : nullptr);
    const auto* found = std::get_if<TwistLeaf>(&outcome);
    if (found != nullptr && last_ && found->twist == last_->twist) {
      ++work_.twists_carried;
      return outcome;
    }
    ++work_.programs;
    work_.double_pivots += static_cast<std::size_t>(lp.double_pivots);
    work_.exact_pivots += static_cast<std::size_t>(lp.exact_pivots);
    work_.bases_confirmed += lp.basis_confirmed ? 1 : 0;
    work_.largest_bits =
        std::max(work_.largest_bits, static_cast<std::size_t>(lp.largest_bits));
    if (found != nullptr) last_ = *found;
    return outcome;
  }

  Stable stable() {
    if (auto with_few = find_forces(problem_, witness_.twist)) witness_ = std::move(*with_few);
    require(!find_violation(problem_, witness_),
            "a witness of a slip state is not an equilibrium");
    return {std::move(witness_)};
  }

  const Problem& problem_;
  StatesWork& work_;
  std::set<const SlipState*> solved_;  ///< states solved by themselves
  std::optional<TwistLeaf> last_;
  Witness witness_;
};

}  // namespace

Verdict decide_by_states(const Problem& problem, StatesWork* work) {
  require(!problem.is_family(), "a verdict is on one member of a family");
  StatesWork unused;
  StatesWork& counters = work != nullptr ? *work : unused;
  counters = {};
  Verdict verdict = StatesEngine(problem, counters).decide();
#ifdef STICKSLIP_VALIDATE
  validate(problem, verdict);
#endif
  return verdict;
}

std::vector<std::pair<std::string, std::size_t>> counters(const StatesWork& work) {
  return {{"states", work.states},
          {"states_refuted", work.states_refuted},
          {"states_solved", work.states_solved},
          {"linear_programs", work.programs},
          {"twists_carried", work.twists_carried},
          {"double_pivots", work.double_pivots},
          {"exact_pivots", work.exact_pivots},
          {"bases_confirmed", work.bases_confirmed},
          {"largest_bits", work.largest_bits}};
}

}  // namespace stickslip
