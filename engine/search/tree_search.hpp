// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Branch and bound over regions of motions. What doubles propose is confirmed exactly.
///
/// **Method.** A region is refuted by the point of least norm of the wrenches that it allows
/// (Wolfe's method): if that is not 0, it is a virtual twist. Else the wrenches that add up to
/// 0 are a relaxed equilibrium, and the region is cut where that breaks a law with the most
/// energy.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "engine/equilibrium/search_end.hpp"
#include "engine/motion/tree_walk.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip {

/// The search, whatever supplies the forces: contacts one by one, of any law (law_forces.hpp),
/// or crowds of them in the plane (engine/planar/crowd_forces.hpp). `Forces` has
///
/// - `Region`, `Relaxed` with a `gap` (the widest breach of a law, over the energy), and
///   `Candidate`: what a relaxed equilibrium says to those who look for a real one;
/// - `motions()`, and `deepest()`: the depth of a tree that is not to be exceeded;
/// - `enter(region, depth)`: reads a region, which all that follows is about; false if no
///   solution lies there;
/// - `nearest(again)`: what nearest_wrench() finds, `again` with more effort;
///   `may_try_again()`: whether that may find something else;
/// - `confirm(twist)`: a twist near this one that refutes the region, exactly;
/// - `relaxed(found)`, and `escapes(relaxed)`: it leads nowhere;
/// - `candidate(relaxed)`, an optional;
/// - `split(relaxed)` where it breaks a law noticeably, and `split_anywhere(relaxed)`: what
///   else may lead on;
/// - `branch(node)`: a node that was decided exactly, with its children;
///   `keep_to_contacts()`: only such are to be split.
template <class Forces>
class TreeSearch {
 public:
  using Region = typename Forces::Region;     ///< that of the forces
  using Relaxed = typename Forces::Relaxed;   ///< likewise
  using Branch = BranchOf<TreeNode, Region>;  ///< a node with the regions of its children

  /// One search, or several that share a limit.
  TreeSearch(Forces forces, std::size_t node_limit)
      : forces_(std::move(forces)), node_limit_(node_limit) {}

  /// Tries a relaxed equilibrium; true ends the search.
  using Candidate = std::function<bool(const typename Forces::Candidate&)>;
  /// To be called with those that may be near real ones.
  void on_candidate(Candidate candidate) { candidate_ = std::move(candidate); }

  /// A leaf that refutes the region, or the contact to split; nothing ends the search.
  using Exact = std::function<std::optional<TreeNode>(const Region&)>;
  /// To be asked where doubles do not decide, as beside an equilibrium. Then contacts alone are
  /// split, so that the search ends.
  void on_doubt(Exact exact) {
    exact_ = std::move(exact);
    forces_.keep_to_contacts();
  }

  /// Appends a tree that refutes the region; false if none was found, and then `trees` has some
  /// nodes more.
  bool refute(Region region, Trees& trees) {
    end_ = SearchEnd::kNone;
    return append_tree(std::move(region), trees,
                       [&](const Region& at, std::size_t depth) { return examine(at, depth); });
  }

  /// One node of a tree: a leaf or a split; nothing where the search ends.
  std::optional<Branch> examine(const Region& region, std::size_t depth) {
    if (nodes_ == node_limit_) return stop(SearchEnd::kNodes);
    if (depth > forces_.deepest()) return stop(SearchEnd::kDepth);
    ++nodes_;
    if (!forces_.enter(region, depth)) {
      return Branch{TwistLeaf{Row(forces_.motions())}, {}};
    }
    std::optional<Relaxed> relaxed;
    for (bool again = false;; again = true) {
      const auto found = forces_.nearest(again);
      if (found.separated) {
        if (auto y = forces_.confirm(found.twist)) return Branch{TwistLeaf{*y}, {}};
      } else {
        relaxed = forces_.relaxed(found);
        if (forces_.escapes(*relaxed)) return stop(SearchEnd::kUnbounded);
        if (is_taken(*relaxed)) return stop(SearchEnd::kCandidate);
        if (auto branch = forces_.split(*relaxed)) return branch;
      }
      if (again || !forces_.may_try_again()) break;
    }
    if (exact_) {
      const std::optional<TreeNode> node = exact_(region);
      if (!node) return stop(SearchEnd::kCandidate);
      return forces_.branch(*node);
    }
    if (!relaxed) return stop(SearchEnd::kTwist);
    auto branch = forces_.split_anywhere(*relaxed);
    return branch ? branch : stop(SearchEnd::kPlane);
  }

  /// Of the last search.
  SearchEnd end() const { return end_; }
  std::size_t nodes() const { return nodes_; }  ///< looked at
  Forces& forces() { return forces_; }          ///< what supplies them

 private:
  std::optional<Branch> stop(SearchEnd end) {
    end_ = end;
    return std::nullopt;
  }

  /// Trying an equilibrium costs as much as many nodes: it is done at counts 1, 2, 4, 8, ...
  /// and where the relaxed one is nearer than before, or breaks no law.
  bool is_taken(const Relaxed& relaxed) {
    const bool is_near = relaxed.gap < least_gap_ / 10 || relaxed.gap == 0;
    if (is_near) least_gap_ = relaxed.gap;
    const bool is_due = (nodes_ & (nodes_ - 1)) == 0;
    if (!candidate_ || !(is_near || is_due)) return false;
    const auto candidate = forces_.candidate(relaxed);
    return candidate && candidate_(*candidate);
  }

  Forces forces_;
  std::size_t node_limit_;
  std::size_t nodes_ = 0;
  SearchEnd end_ = SearchEnd::kNone;
  double least_gap_ = 1e-3;  ///< of relaxed equilibria that were tried
  Candidate candidate_;
  Exact exact_;
};

}  // namespace stickslip
