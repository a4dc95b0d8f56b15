// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Branch and bound over regions of motions. What doubles propose is confirmed exactly.
///
/// **Method.** A region is refuted by the point of least norm of the wrenches that it allows
/// (Wolfe's method): if that is not 0, minus it is a virtual twist. Else the wrenches that add
/// up to 0 are a relaxed equilibrium. The region is then cut where that breaks a law with the
/// most energy.
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
/// - `motions()`, the number of coordinates of a motion, and `deepest()`, the largest depth of
///   a node;
/// - `enter(region, depth)`: reads a region, which all that follows is about; returns false if
///   no solution lies there;
/// - `nearest(again)`: returns what nearest_wrench() finds, `again` with more effort;
///   `may_try_again()`: returns whether that may find something else;
/// - `confirm(twist)`: returns a twist near this one that refutes the region, exactly;
/// - `relaxed(found)`: returns the relaxed equilibrium, and `escapes(relaxed)` whether it leads
///   nowhere, so that the search ends;
/// - `candidate(relaxed)`: returns an optional Candidate;
/// - `split(relaxed)`: splits where it breaks a law noticeably; `split_anywhere(relaxed)`:
///   splits where else that may lead on;
/// - `branch(node)`: returns a node that was decided exactly, with its children;
///   `keep_to_contacts()`: allows splits at contacts only.
template <class Forces>
class TreeSearch {
 public:
  using Region = typename Forces::Region;     ///< a node's region
  using Relaxed = typename Forces::Relaxed;   ///< a relaxed equilibrium
  using Branch = BranchOf<TreeNode, Region>;  ///< a node with the regions of its children

  /// Makes one search, or several that share a limit of nodes.
  TreeSearch(Forces forces, std::size_t node_limit)
      : forces_(std::move(forces)), node_limit_(node_limit) {}

  /// A function that tries a relaxed equilibrium; it returns true to end the search.
  using Candidate = std::function<bool(const typename Forces::Candidate&)>;
  /// Sets the function to call with those that may be near real ones.
  void on_candidate(Candidate candidate) { candidate_ = std::move(candidate); }

  /// A function that returns a leaf that refutes the region, or the contact to split; nothing
  /// ends the search.
  using Exact = std::function<std::optional<TreeNode>(const Region&)>;
  /// Sets the function to ask where doubles do not decide, as beside an equilibrium. Then
  /// contacts alone are split, so that the search ends.
  void on_doubt(Exact exact) {
    exact_ = std::move(exact);
    forces_.keep_to_contacts();
  }

  /// Appends a tree that refutes the region. Returns false if none was found; then `trees` has
  /// some nodes more.
  bool refute(Region region, Trees& trees) {
    end_ = SearchEnd::kNone;
    const bool found =
        append_tree(std::move(region), trees,
                    [&](const Region& at, std::size_t depth) { return examine(at, depth); });
    if (!found && end_ == SearchEnd::kNone) end_ = SearchEnd::kPoints;
    return found;
  }

  /// Returns one node of a tree, a leaf or a split; nothing if the search ends.
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

  /// Returns why the last search ended.
  SearchEnd end() const { return end_; }
  std::size_t nodes() const { return nodes_; }  ///< how many were looked at
  Forces& forces() { return forces_; }          ///< the supplier of forces

 private:
  std::optional<Branch> stop(SearchEnd end) {
    end_ = end;
    return std::nullopt;
  }

  /// Tries a relaxed equilibrium; returns true to end the search. Trying costs as much as many
  /// nodes, so it is done only at counts 1, 2, 4, 8, ..., and where the relaxed one is ten
  /// times nearer than before, or breaks no law.
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
  double least_gap_ = 1e-3;  ///< the least gap so far
  Candidate candidate_;
  Exact exact_;
};

}  // namespace stickslip
