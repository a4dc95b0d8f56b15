// SPDX-License-Identifier: MIT
/// \file
/// The walk over the nodes of an unstable verdict's tree (FORMAT.md §4), or of the trees of a
/// margin's gaps (§10), in the order of the list. Memory grows with the depth, which is at most
/// 2m + 64, not with the tree.
///
/// What is known of a contact on a region (the sign of v_i, the sign of its slip) holds on
/// every sub-region, so a child re-examines only the contacts that its parent left undecided:
///  - v_i >= 0 (or <= 0) on all rays says so of the whole cone;
///  - a label is inherited;
///  - a sign without a label says that tau_i(x) is 0 only where some strict function is 0.
/// On a region whose rays are all barred a leaf is accepted whatever its y, so there the
/// statuses do not matter and are not kept up.
///
/// Of all this only a leaf's bound sees the load. g(r, l) = g(r, 0) + l (y.u) is largest at one
/// end of the range, where l = lambda h, and it is enough to look there:
///  - y.u = 0: it is the same at both ends, and on the ray along l it is 0.
///  - y.u < 0: it is largest at the low end, and below 0 on the ray along l.
///  - y.u > 0: it is largest at the high end; without one, it is above 0 on the ray along l.
/// In the last two cases g = 0 stands on generators of that end and with h = 0 only; the strict
/// function of an end that the range does not contain is zero on all of these.
/// And these strict functions bar no more regions: they are zero on all generators of a region
/// only where h is.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "bound.hpp"
#include "syntax.hpp"

namespace stickslip_check {

/// Multiples of a direction: between low and high, or above low if there is no high. Neither is
/// among them, except low if `contains_low`, and a range of one (low = high, `contains_low`).
struct LoadRange {
  Rational low;
  std::optional<Rational> high;
  bool contains_low = false;
};

/// The loads wrench + lambda direction; each range of lambda has a tree. By default the one
/// load `wrench`, and its one tree.
struct Loads {
  Vector3 wrench;
  Vector3 direction{};
  std::vector<LoadRange> ranges{{0, 0, true}};
};

class TreeWalk {
 public:
  TreeWalk(const std::vector<Row>& rows, Loads loads, bool bilateral);

  /// The next node of the list. Throws Rejected; after a rule for leaf or void nodes the walk
  /// may go on, as if the node were right.
  void visit(const Node& node);
  /// The list has ended. Throws Rejected (`tree-short`).
  void finish() const;

  /// Decides leaves by the rational sum alone, without the rounded one. Same answers, slower.
  void use_exact_bounds_only() { exact_only_ = true; }

  std::size_t trees() const { return trees_; }
  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }
  std::uint64_t voids() const { return voids_; }
  /// Rays on which a leaf needed the rational sum.
  std::uint64_t exact_bounds() const { return exact_bounds_; }

 private:
  /// An inner node whose children are not all done, with what holds on its region.
  struct Frame {
    NodeKind kind;
    std::size_t contact;
    Vector cut;  ///< tau_i, v_i or a
    Cone region;
    Aggregate decided;
    std::size_t undecided;  ///< size of undecided_
    std::size_t trail;      ///< size of trail_
    std::size_t strict;     ///< size of strict_
    unsigned children;
    unsigned next;  ///< child to come
  };

  void begin_tree(Cone& region);
  void go_back(std::size_t trail, std::size_t undecided, std::size_t strict);
  void enter_child(Cone& region, Aggregate& decided);
  void examine(const Cone& region, Aggregate& decided);
  void set_status(std::size_t contact, Status status);
  void close_finished();
  void push(const Node& node, Cone region, Aggregate decided);
  std::optional<std::string> theta_refusal(const Node& node) const;
  std::optional<std::string> leaf_refusal(const Node& node, const Cone& region,
                                          const Aggregate& decided);
  std::string path(unsigned ahead) const;
  Rejected rejection(const char* rule, std::string found) const;

  Problem problem_;
  Loads loads_;
  bool bilateral_;
  bool exact_only_ = false;
  std::vector<Frame> stack_;
  std::vector<Status> status_;
  std::vector<std::pair<std::size_t, Status>> trail_;  ///< what set_status overwrote
  /// The undecided contacts are the first so many of this list. Contacts are only exchanged
  /// within that part, so going back to an earlier size brings back the earlier set.
  std::vector<std::size_t> undecided_;
  std::size_t undecided_count_;
  std::vector<Vector> strict_;  ///< strict functions of the region, up to nonzero factors
  std::vector<bool> slip_on_path_;
  std::vector<bool> separation_on_path_;
  unsigned planes_on_path_ = 0;
  std::size_t trees_ = 0;  ///< begun
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
  std::uint64_t voids_ = 0;
  std::uint64_t exact_bounds_ = 0;
};

}  // namespace stickslip_check
