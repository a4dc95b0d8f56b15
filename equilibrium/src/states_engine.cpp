// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "few_shares.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/decide.hpp"
#include "stickslip/equilibrium/search/region_program.hpp"
#include "stickslip/equilibrium/verdict.hpp"

namespace stickslip {

using namespace equilibrium_detail;

namespace {

class StatesEngine {
 public:
  StatesEngine(const Problem& problem, StatesWork& work) : problem_(problem), work_(work) {}

  Verdict decide() {
    std::vector<Vector3> planes;
    for (const ContactRow& row : problem_.rows()) planes.push_back(coordinates(row.tangent));
    const SlipStates slip = enumerate_slip_states_cgal(planes);
    work_.states = slip.states.size();
    const Region root = Region::root(problem_);
    // From the end: all-stick sorts last, is the cheapest to solve, and often the answer.
    for (auto state = slip.states.rbegin(); state != slip.states.rend(); ++state) {
      ++work_.states_solved;
      Refutation& refutation = refutations_[*state];
      if (solve_separations(root.with_slip_state(problem_, *state), refutation)) {
        return Stable{std::move(witness_)};
      }
    }
    Refutation tree;
    assemble(root, tree);
    return Unstable{std::move(tree)};
  }

 private:
  /// Depth first over separation patterns. True when an equilibrium was found; otherwise
  /// `refutation` has grown by a tree that covers the region.
  bool solve_separations(const Region& region, Refutation& refutation) {
    if (region.is_void()) {
      refutation.emplace_back(VirtualWorkLeaf{});
      return false;
    }
    LpWork lp;
    auto outcome = solve_region(problem_, region, &lp);
    ++work_.programs;
    work_.double_pivots += static_cast<std::size_t>(lp.double_pivots);
    work_.exact_pivots += static_cast<std::size_t>(lp.exact_pivots);
    work_.bases_confirmed += lp.basis_confirmed ? 1 : 0;
    work_.largest_bits =
        std::max(work_.largest_bits, static_cast<std::size_t>(lp.largest_bits));
    if (auto* leaf = std::get_if<VirtualWorkLeaf>(&outcome)) {
      ++work_.patterns;
      refutation.emplace_back(std::move(*leaf));
      return false;
    }
    auto& point = std::get<RelaxedPoint>(outcome);
    if (!point.broken) {
      witness_ = std::move(point.witness);
      if (auto with_few = find_forces(problem_, witness_.twist))
        witness_ = std::move(*with_few);
      const std::optional<std::string> violation = find_violation(problem_, witness_);
      require(!violation, "a witness of a slip state is not an equilibrium");
      return true;
    }
    // Slip is labelled throughout the state, so only a separation can be broken.
    const ContactId contact = std::get<SeparationSplit>(*point.broken).contact;
    refutation.emplace_back(SeparationSplit{contact});
    return solve_separations(region.separation_child(problem_, contact, Separation::kClosed),
                             refutation) ||
           solve_separations(region.separation_child(problem_, contact, Separation::kOpen),
                             refutation);
  }

  /// Splits by slip until every contact's friction is known as in a slip state, then appends
  /// that state's refutation. Only contacts whose plane cuts the region need a split, or
  /// touches it where no strict function excludes touching; so the tree follows the
  /// arrangement.
  void assemble(const Region& region, Refutation& tree) const {
    if (region.is_void()) {
      tree.emplace_back(VirtualWorkLeaf{});
      return;
    }
    SlipState state;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const ContactId contact(i);
      const std::optional<Sign> sign = region.slip_sign(problem_, contact);
      if (!sign && !signs_on(region.cone(), problem_.slip_plane(contact)).is_zero()) {
        tree.emplace_back(SlipSplit{contact});
        for (const Sign child : {Sign::kPositive, Sign::kZero, Sign::kNegative}) {
          assemble(region.slip_child(problem_, contact, child), tree);
        }
        return;
      }
      state.push_back(sign.value_or(Sign::kZero));
    }
    const auto found = refutations_.find(state);
    require(found != refutations_.end(),
            "a region's slip state is missing from the enumeration");
    tree.insert(tree.end(), found->second.begin(), found->second.end());
  }

  const Problem& problem_;
  StatesWork& work_;
  std::map<SlipState, Refutation> refutations_;
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

}  // namespace stickslip
