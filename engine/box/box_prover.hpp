// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs about a box as a whole or cut into parts, without a search for counterexamples.
///
/// **Method.** An equilibrium of the grasp in the middle is sought by Newton's method in
/// doubles, and every grasp of the box proved to have one near it. If there is none, a branch
/// and bound over regions of motions refutes them one by one. Doubles propose; what is proved
/// is confirmed exactly.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "engine/degree/newton.hpp"
#include "engine/equilibrium/search_end.hpp"
#include "engine/search/law_forces.hpp"
#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {

/// What a search for proofs may take.
struct ProverLimits {
  std::size_t node_limit;  ///< of a tree that is about all motions
  std::size_t wall_limit;  ///< of the tree of a wall
  std::size_t most_nodes;  ///< of all together, beyond which a box is cut no more
  std::size_t most_parts;  ///< cuts
  bool is_wide;            ///< the box is more than what encloses lengths
  bool is_default;  ///< nobody asked for more: far motions take a part of what near ones took
};

/// Proofs about a box and its parts, until one fails or two parts seem to differ.
class BoxProver {
 public:
  /// `work` must outlive this.
  BoxProver(GraspLaw box, const ProverLimits& limits, SearchWork& work);
  /// Of one grasp, all of whose lengths are rational: an exact equilibrium is tried before
  /// other proofs, and where doubles do not decide, exact programs are asked.
  void try_exact_equilibria() { is_exact_ = true; }

  /// The verdict, if there is one.
  std::optional<std::variant<Stable, Unstable>> prove();
  /// If that failed.
  SearchReport report() const;
  /// If that failed: a tree that refutes all motions within natural_bound(box, kFarMotion), for
  /// a question with that bound; or nothing.
  const std::optional<Trees>& near_tree() const { return near_tree_; }
  /// Where the middles of parts lie that seem to be stable, and unstable: of each parameter of
  /// the box, from 0 to 1. Nothing, or the last one of a kind.
  const std::array<std::optional<RationalRow>, 2>& suspects() const { return suspects_; }

 private:
  bool prove(const GraspLaw& box);
  bool prove_whole(const GraspLaw& box, std::optional<NearEquilibrium>& middle);
  bool prove_exactly(const GraspLaw& box, const NearEquilibrium& near);
  bool prove_near(const GraspLaw& box, const GraspLaw& middle, const NearEquilibrium& near);
  bool refute_near_first(const GraspLaw& box, LawSearch& near);
  std::optional<PartSplit> widest(const GraspLaw& box,
                                  const std::optional<NearEquilibrium>& near) const;
  RationalRow place_of(const GraspLaw& part) const;

  GraspLaw whole_;
  ProverLimits limits_;
  SearchWork& work_;
  std::size_t last_node_;  ///< where the work of all is to end
  bool is_exact_ = false;
  std::array<std::optional<RationalRow>, 2> suspects_;
  std::optional<bool> stable_;  ///< what was proved of the first part
  std::optional<ShareWitness> witness_;
  RationalRow motion_;
  StabilityProof parts_;
  Trees tree_;
  std::optional<Trees> near_tree_;
  SearchEnd end_ = SearchEnd::kNone;
  RationalRow near_;  ///< an equilibrium in doubles without a proof
};

}  // namespace stickslip
