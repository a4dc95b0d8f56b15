// SPDX-License-Identifier: GPL-3.0-or-later
#include "search_end.hpp"

#include <string>

namespace stickslip {
namespace {

constexpr const char* kMoreNodes = "a higher node limit may decide it";

}  // namespace

Undecided limit_reached(std::size_t node_limit) {
  return {"the search reached the limit of " + std::to_string(node_limit) + " nodes", "nodes",
          kMoreNodes};
}

Undecided undecided_by(const SearchReport& report) {
  const std::string limit = std::to_string(report.node_limit);
  const std::string beside =
      "its margin shows whether the load is near a threshold: ask about one a little "
      "smaller or larger then";
  const auto answer = [&]() -> Undecided {
    if (report.is_far) {
      return {
          "what is left are motions far beyond those that a load of this size explains, and "
          "rounding of the data decides what holds there",
          "far", "a max_motion of 1000x asks about motions of the size of the problem"};
    }
    if (report.is_spent) {
      return {"all trees together reached their limit, a few times " + limit + " nodes",
              "nodes", kMoreNodes};
    }
    if (report.end == SearchEnd::kNodes) {
      return {"a tree reached the limit of " + limit + " nodes", "nodes", kMoreNodes};
    }
    if (report.is_wide) {
      return {"no proof was found for all of the box", "box",
              "smaller tolerances may be decided"};
    }
    if (!report.near.empty() && report.is_free) {
      return {
          "beside an equilibrium in doubles a motion changes no force: equilibria lie side by "
          "side there, and proofs are about one that stands alone",
          "free", "a weight or a spring for what nothing presses there, or leave it out"};
    }
    if (!report.near.empty()) {
      return {"near an equilibrium in doubles no proof by degree was found", "degree", beside};
    }
    switch (report.end) {
      case SearchEnd::kDepth:
        return {"a tree grew as deep as a certificate may be", "depth", beside};
      case SearchEnd::kTwist:
        return {
            "a virtual twist that refutes a region in doubles could not be rounded to an "
            "exact one",
            "twist", beside};
      case SearchEnd::kPoints:
        return {"a region had more corners than checkers take", "corners", beside};
      default:
        return {"the forces on a region balance in doubles, and no plane cuts it", "plane",
                beside};
    }
  };
  Undecided result = answer();
  if (report.is_wide) result.limit += ", and no two grasps that differ were found";
  result.near = report.near;
  return result;
}

}  // namespace stickslip
