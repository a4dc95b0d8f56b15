// SPDX-License-Identifier: MIT
/// \file
/// Proofs that every grasp in a box is stable (FORMAT.md §6, "Stable: by degree"), for every
/// multiple of a range (§5).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rest.hpp"
#include "sticking.hpp"
#include "tree.hpp"

namespace stickslip_check {

/// A part as the certificate states it; only its shape has been checked.
struct Part {
  bool cut = false;
  Node by;  ///< if cut

  std::optional<RestProof> at_rest;       ///< if not cut, but at rest
  std::optional<StickingProof> sticking;  ///< or sticking

  // If by degree:
  Vector twist;                   ///< d0, or of a segment that at its low end
  Vector end_twist;               ///< the same, or that at its high end
  std::vector<Integer> open;      ///< the contacts that are said to be open on K
  std::vector<Vector> walls;      ///< E
  bool simplex = false;           ///< K is one, else a parallelepiped
  std::vector<Vector> direction;  ///< A
  std::vector<Node> tree;
};

/// Checks a part by degree, at `place`, for all multiples from range.low to *range.high,
/// or from range.low > 0 on.
/// Throws Rejected, or returns the walk over its trees.
TreeWalk check_degree(const Part& part, const std::shared_ptr<const Box>& box,
                      const Range& range, const Options& asked, const std::string& place);

/// The walk over the list of parts, in their order.
class PartWalk {
 public:
  PartWalk(const Options& asked, const std::shared_ptr<const Box>& box);

  /// The next part of the list. Throws Rejected.
  void visit(const Part& part);
  /// The list has ended. Throws Rejected (`tree-short`).
  void finish() const;

  std::uint64_t rests() const { return rests_; }          ///< parts at rest
  std::uint64_t stickings() const { return stickings_; }  ///< sticking parts
  std::uint64_t proofs() const { return proofs_; }        ///< parts by degree
  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }

 private:
  /// A part that is to come.
  struct Awaited {
    std::shared_ptr<const Box> box;
    std::string path;  ///< empty, or ", friction 2 low" and so on
    std::size_t depth;
  };

  Options asked_;
  std::vector<Awaited> awaited_;  ///< the next one last
  std::uint64_t parts_ = 0;
  std::uint64_t rests_ = 0;
  std::uint64_t stickings_ = 0;
  std::uint64_t proofs_ = 0;
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
};

}  // namespace stickslip_check
