// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/branch_and_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "crowd_forces.hpp"
#include "engine/equilibrium/search_end.hpp"
#include "engine/motion/tree_walk.hpp"
#include "few_shares.hpp"
#include "find_flaw.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/verdict.hpp"
#include "witness_search.hpp"

namespace stickslip {

using namespace planar_detail;

namespace {

using CrowdSearch = TreeSearch<CrowdForces>;

/// Looks for a tree or an equilibrium.
class Explorer {
 public:
  Explorer(const Problem& problem, const DoubleModel& model, const SearchOptions& options)
      : problem_(problem),
        model_(model),
        most_nodes_(options.node_limit != 0 ? options.node_limit : SIZE_MAX),
        root_(Region::root(problem)),
        search_(CrowdForces(problem, model, nullptr, true, work_), most_nodes_) {
    follow(search_);
  }

  const BranchWork& work() const { return work_; }
  std::optional<Witness>& witness() { return witness_; }
  /// Returns the multiple of the load that the witness is of.
  const Rational& multiple() const { return multiple_; }

  /// Returns a tree, made depth first, in preorder. Returns nothing if it ended early: at a
  /// witness, or at the limit.
  std::optional<Trees> explore() {
    Trees tree;
    const auto step = [&](const Region& region, std::size_t depth) {
      // Small trees find equilibria in less time, and with simpler numbers.
      constexpr std::size_t kFirst = 64;
      if (search_.nodes() >= kFirst && near_) {
        search_within(*std::exchange(near_, std::nullopt));
        if (witness_) return std::optional<CrowdSearch::Branch>();
      }
      return search_.examine(region, depth);
    };
    if (!append_tree(root_, tree, step)) return std::nullopt;
    return tree;
  }

  /// Tries the two places where equilibria mostly are: at rest with friction holding, which the
  /// search finds in the all-stick state if it exists, and where Newton's method leads from
  /// rest.
  bool try_witness_from_rest() {
    const Region rest =
        root_.with_slip_state(problem_, std::vector<Sign>(problem_.size(), Sign::kZero));
    if (!rest.is_barred()) {
      const auto found = search_.forces().relaxation(rest);
      if (found && try_witness_of(*found, search_.forces())) return true;
    }
    ++work_.witness_attempts;
    witness_ = find_witness_from_rest(problem_, model_, near_);
    return witness_.has_value();
  }

 private:
  /// Tries the equilibria that a search comes near, and decides exactly what it does not.
  void follow(CrowdSearch& search) {
    if (!problem_.is_family()) {
      search.on_candidate([&](const CrowdRelaxation& relaxed) {
        return relaxed.gap == 0 ? try_witness_of(relaxed.found, search.forces())
                                : try_witness_near(relaxed.found.motion);
      });
    }
    search.on_doubt([&](const Region& region) { return solve_exactly(region); });
  }

  /// Explores a tree of a few motions, for a witness only. Its nodes are not counted: they are
  /// in no refutation.
  void search_within(const MotionBox& box) {
    Region region = root_;
    for (std::size_t j = 0; j < 3; ++j) {
      for (const int side : {-1, 1}) {
        Vector5 face{};
        face[j] = -side;
        face[3] =
            side * rational_from_double(box.middle[j]) + rational_from_double(box.reach[j]);
        region = std::move(region).plane_child(primitive_multiple(face), Side::kPositive);
      }
    }
    constexpr std::size_t kMostNodes = 200;  // mostly one will do if an equilibrium is near
    BranchWork here;
    CrowdSearch search(CrowdForces(problem_, model_, nullptr, true, here),
                       std::min(kMostNodes, most_nodes_));
    follow(search);
    Trees tree;
    search.refute(std::move(region), tree);
    work_.searches += here.searches;
    work_.support_points += here.support_points;
    work_.visits += here.visits;
  }

  /// Tries Newton's method from the motion of a relaxed equilibrium.
  bool try_witness_near(const Double5& motion) {
    if (!(motion[3] > 0)) return false;
    ++work_.witness_attempts;
    witness_ = find_witness_near(
        problem_, model_, {motion[0] / motion[3], motion[1] / motion[3], motion[2] / motion[3]},
        &failed_modes_);
    return witness_.has_value();
  }

  /// Tries the relaxed equilibrium itself, taken at its word: its motion says which contacts
  /// are closed and which slip, its forces how much friction there is where they stick.
  bool try_witness_of(const SearchResult& found, const CrowdForces& forces) {
    if (!(found.motion[3] > 0)) return false;
    ++work_.witness_attempts;
    std::vector<double> slips;
    double fastest = 0;
    for (const ContactDoubles& c : model_.contacts) {
      slips.push_back(dot(c.slip, found.motion));
      fastest = std::max(fastest, std::fabs(slips.back()));
    }
    std::vector<ModeGuess> guesses;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      constexpr double kStill = 1e-9;  // part of the fastest slip; exact numbers judge it
      const bool closed = dot(model_.contacts[i].separation, found.motion) > 0;
      const bool sticks = std::fabs(slips[i]) <= kStill * fastest;
      guesses.push_back({closed, sticks, slips[i] > 0 ? -1 : 1});
    }
    forces.for_each_share(
        found, [&](std::uint32_t contact) { return guesses[contact].sticks; },
        [&](std::uint32_t contact, double share) {
          guesses[contact].share = rounded_share(share);
        });
    witness_ = complete_exactly(problem_, guesses);
    return witness_.has_value();
  }

  /// Solves the exact program of the region. Returns a leaf, or the split that its point asks
  /// for; nothing if the point is an equilibrium, which becomes the witness.
  std::optional<TreeNode> solve_exactly(const Region& region) {
    ++work_.exact_programs;
    auto outcome = solve_region(problem_, region, nullptr);
    if (auto* leaf = std::get_if<TwistLeaf>(&outcome)) return std::move(*leaf);
    auto& point = std::get<RelaxedPoint>(outcome);
    if (point.broken) {
      return std::visit([](const auto& split) { return TreeNode(split); }, *point.broken);
    }
    witness_ = std::move(point.witness);
    multiple_ = std::move(point.multiple);
    const Problem there = problem_.at(multiple_);
    if (auto with_few = find_forces(there, witness_->twist)) witness_ = std::move(with_few);
    require(!find_violation(there, *witness_), "an unbroken point is not an equilibrium");
    return std::nullopt;
  }

  const Problem& problem_;
  const DoubleModel& model_;
  std::size_t most_nodes_;
  Region root_;
  BranchWork work_;
  CrowdSearch search_;
  std::optional<MotionBox> near_;  ///< a place where an equilibrium may be; not yet searched
  std::vector<ModeGuess> failed_modes_;  ///< the last modes that failed
  std::optional<Witness> witness_;
  Rational multiple_ = 0;
};

}  // namespace

BranchWork& BranchWork::operator+=(const BranchWork& part) {
  nodes += part.nodes;
  leaves += part.leaves;
  voids += part.voids;
  slip_splits += part.slip_splits;
  separation_splits += part.separation_splits;
  depth = std::max(depth, part.depth);
  searches += part.searches;
  support_points += part.support_points;
  visits += part.visits;
  filter_hits += part.filter_hits;
  filter_misses += part.filter_misses;
  exact_programs += part.exact_programs;
  witness_attempts += part.witness_attempts;
  largest_twist_bits = std::max(largest_twist_bits, part.largest_twist_bits);
  return *this;
}

Verdict branch_and_bound(const Problem& problem, const SearchOptions& options,
                         BranchWork* work) {
  require(!problem.is_family(), "a verdict is on one member of a family");
  const DoubleModel model(problem);
  Explorer explorer(problem, model, options);
  std::optional<Trees> tree;
  if (!explorer.try_witness_from_rest()) tree = explorer.explore();
  if (work != nullptr) *work = explorer.work();
  Verdict verdict;
  if (explorer.witness()) {
    verdict = Stable{std::move(*explorer.witness())};
  } else if (tree) {
    verdict = Unstable{std::move(*tree)};
  } else {
    verdict = limit_reached(options.node_limit);
  }
#ifdef STICKSLIP_VALIDATE
  validate(problem, verdict);
#endif
  return verdict;
}

std::vector<Witness> find_equilibria(const Problem& problem, std::size_t starts) {
  require(!problem.is_family(), "equilibria are those of one member of a family");
  return find_witnesses_around(problem, DoubleModel(problem), starts);
}

std::variant<MarginPoint, Unstable, Undecided> search_family(const Problem& family,
                                                             const SearchOptions& options,
                                                             BranchWork* work) {
  const DoubleModel model(family);
  Explorer explorer(family, model, options);
  auto tree = explorer.explore();
  if (work != nullptr) *work = explorer.work();
  if (auto& witness = explorer.witness()) {
    return MarginPoint{explorer.multiple(), std::move(*witness)};
  }
  if (!tree) return limit_reached(options.node_limit);
  return Unstable{std::move(*tree)};
}

std::vector<std::pair<std::string, std::size_t>> counters(const BranchWork& work) {
  return {{"nodes", work.nodes},
          {"leaves", work.leaves},
          {"void_leaves", work.voids},
          {"slip_splits", work.slip_splits},
          {"separation_splits", work.separation_splits},
          {"depth", work.depth},
          {"searches", work.searches},
          {"support_points", work.support_points},
          {"visits", work.visits},
          {"filter_hits", work.filter_hits},
          {"filter_misses", work.filter_misses},
          {"exact_programs", work.exact_programs},
          {"witness_attempts", work.witness_attempts},
          {"largest_twist_bits", work.largest_twist_bits}};
}

}  // namespace stickslip
