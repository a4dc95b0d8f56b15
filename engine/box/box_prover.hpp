// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs about a box as a whole or cut into parts, without a search for counterexamples.
///
/// **Method.** Newton's method in doubles seeks an equilibrium of the grasp in the middle, and
/// every grasp of the box is proved to have one near it. If there is none, a branch and bound
/// over regions of motions refutes them one by one. Doubles propose; what is proved is
/// confirmed exactly.
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

/// The limits of a search for proofs.
struct ProverLimits {
  std::size_t node_limit;  ///< nodes of a tree that is about all motions
  std::size_t wall_limit;  ///< nodes of the tree of a wall
  std::size_t most_nodes;  ///< nodes of all together, beyond which a box is cut no more
  std::size_t most_parts;  ///< the most cuts
  bool is_wide;            ///< the user gave intervals; the box is not just rounding of lengths
  bool rest_first;         ///< equilibria near rest are tried before others are sought
  bool is_default;  ///< nobody asked for more: far motions get a part of what near ones took
  /// Counterexamples are sought between prove() and prove_in_parts(). Proofs around an
  /// equilibrium that Newton's method misses, as it is far away, take long and wait for that.
  bool examples_next = false;
};

/// Proofs about a box and its parts, until one fails or two parts seem to differ.
class BoxProver {
 public:
  /// `work` must outlive this.
  BoxProver(GraspLaw box, const ProverLimits& limits, SearchWork& work);
  /// Tries an exact equilibrium before other proofs, and asks exact programs where doubles do
  /// not decide. The box must be one grasp, all of whose lengths are rational.
  void try_exact_equilibria() { is_exact_ = true; }

  using Verdict = std::variant<Stable, Unstable>;  ///< what may be proved

  /// Returns the verdict, or nothing if there is no proof.
  std::optional<Verdict> prove();
  /// Goes on where prove() failed: tries what waits, and then cuts the box, at most so many
  /// times.
  std::optional<Verdict> prove_in_parts(std::size_t most_parts);
  /// Returns an equilibrium of the middle, in doubles, if prove() found one.
  const std::optional<NearEquilibrium>& middle() const { return middle_; }
  /// Returns why there is no proof.
  SearchReport report() const;
  /// Returns, if there is no proof, a tree that refutes all motions within natural_bound(box,
  /// kFarMotion), for a question with that bound; or nothing.
  const std::optional<Trees>& near_tree() const { return near_tree_; }
  /// Returns where the middles of parts lie that seem to be stable, and unstable: a number from
  /// 0 to 1 for each parameter of the box. Each is the last one of its kind, or nothing.
  const std::array<std::optional<RationalRow>, 2>& suspects() const { return suspects_; }

 private:
  Verdict verdict();
  bool prove(const GraspLaw& box, std::optional<NearEquilibrium>& middle);
  bool prove_halves(const GraspLaw& box, const std::optional<NearEquilibrium>& middle);
  bool prove_whole(const GraspLaw& box, std::optional<NearEquilibrium>& middle);
  bool prove_exactly(const GraspLaw& box, const NearEquilibrium& near);
  bool prove_near(const GraspLaw& box, const GraspLaw& middle, const NearEquilibrium& near);
  bool refute_near_first(const GraspLaw& box, LawSearch& near);
  std::optional<PartSplit> widest(const GraspLaw& box,
                                  const std::optional<NearEquilibrium>& near) const;
  RationalRow place_of(const GraspLaw& part) const;

  GraspLaw whole_;
  std::optional<NearEquilibrium> middle_;
  ProverLimits limits_;
  SearchWork& work_;
  std::size_t last_node_;  ///< the count of nodes at which all work ends
  bool is_exact_ = false;
  std::optional<NearEquilibrium> far_middle_;  ///< one of the middle whose proof waits
  std::array<std::optional<RationalRow>, 2> suspects_;
  std::optional<bool> stable_;  ///< whether the first part was proved stable
  std::optional<ShareWitness> witness_;
  RationalRow motion_;
  StabilityProof parts_;
  Trees tree_;
  std::optional<Trees> near_tree_;
  SearchEnd end_ = SearchEnd::kNone;
  RationalRow near_;      ///< an equilibrium in doubles without a proof
  bool is_free_ = false;  ///< whether a motion beside that changes no force
};

}  // namespace stickslip
