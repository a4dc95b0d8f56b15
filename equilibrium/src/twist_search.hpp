// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for a virtual twist in double precision, what it leaves when there is none, and
/// the confirmation of what it finds.
#pragma once

#include <optional>
#include <vector>

#include "cone_node.hpp"
#include "stickslip/equilibrium/cone_engine.hpp"
#include "stickslip/equilibrium/region_system.hpp"

namespace stickslip {

/// A virtual twist along which every wrench of the region does negative work, or a relaxed
/// equilibrium.
struct SearchResult {
  bool separated = false;
  Double3 twist{};                 ///< if separated
  Double4 motion{};                ///< otherwise x ...
  std::vector<double> normal;      ///< ... and of the node's questions a_i ...
  std::vector<double> tangential;  ///< ... and b_i / mu_i
};

class TwistSearch {
 public:
  explicit TwistSearch(const DoubleModel& model) : model_(model) {}

  SearchResult search(const Node& node, const RayTable& table, ConeWork& work);

  /// The separation, else the slip, whose law the relaxed equilibrium breaks with the most
  /// energy; nothing if it breaks none noticeably.
  std::optional<ContactSplit> widest_gap(const Node& node, const SearchResult& found) const;

  /// The twist rounded to the smallest integers that still refute the node's region. `verify`
  /// false takes the first rounding that is not certainly wrong.
  std::optional<VirtualWorkLeaf> confirm(const Problem& problem, const Node& node,
                                         const RayTable& table, const Double3& twist,
                                         bool verify, ConeWork& work);

 private:
  /// A question's contact on a twist: the most work per unit of normal coefficient, and the
  /// edge of the friction cone, N + sigma mu T, that does it.
  struct Edge {
    double alpha;
    double sigma;
  };
  Edge edge(const OpenQuestion& question, const Double3& twist) const;
  void add_question_bounds(const Node& node, const RayTable& table, const Double3& twist);
  Double3 wrench_at(const Node& node, const RayTable& table, std::size_t ray,
                    const Double3& load) const;
  /// Whether g <= 0 with zeros only where nothing acts, if error bounds decide.
  std::optional<bool> certain_refutation(const Node& node, const RayTable& table,
                                         const Double3& twist);

  const DoubleModel& model_;
  std::vector<Edge> edges_;     ///< by question
  std::vector<double> bounds_;  ///< g(r)
  std::vector<double> forces_;  ///< sum of the questions' normal coefficients at r
  std::vector<double> errors_;  ///< magnitudes of g(r)'s terms
  std::vector<double> scales_;  ///< by ray: comparable sizes of wrenches
};

}  // namespace stickslip
