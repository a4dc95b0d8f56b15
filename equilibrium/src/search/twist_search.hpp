// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for a virtual twist in double precision, what it leaves when there is none, and
/// the confirmation of what it finds.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "node.hpp"
#include "stickslip/equilibrium/search/branch_and_bound.hpp"
#include "stickslip/equilibrium/search/nearest_wrench.hpp"
#include "stickslip/equilibrium/search/region_program.hpp"

namespace stickslip::equilibrium_detail {

/// A virtual twist along which every wrench of the region does negative work, or a relaxed
/// equilibrium.
struct SearchResult {
  bool separated = false;
  Double3 twist{};                 ///< if separated
  Double5 motion{};                ///< otherwise x ...
  std::vector<double> normal;      ///< ... and of the node's undecided a_i ...
  std::vector<double> tangential;  ///< ... and b_i / mu_i
};

class TwistSearch {
 public:
  explicit TwistSearch(const DoubleModel& model) : model_(model) {}

  SearchResult search(const Node& node, const RayTable& table, ConeWork& work);

  /// The separation, else the slip, whose law the relaxed equilibrium breaks with the most
  /// energy; nothing if it breaks none noticeably.
  std::optional<ContactSplit> widest_gap(const Node& node, const SearchResult& found) const;

  /// The twist rounded to the smallest integers that still refute the node's region.
  std::optional<VirtualWorkLeaf> confirm(const Problem& problem, const Node& node,
                                         const RayTable& table, const Double3& twist,
                                         ConeWork& work);

 private:
  /// An undecided contact on a twist: the most work per unit of normal coefficient, and the
  /// edge of the friction cone, N + sigma mu T, that does it.
  struct Edge {
    double alpha;
    double sigma;
  };
  Edge edge(const UndecidedContact& u, const Double3& twist) const;
  /// A wrench that entered the hull: that of a ray, on the twist on which it was the worst.
  struct Support {
    double work;
    Double3 wrench;
    std::size_t ray;
    Double3 twist;
  };
  void scale_rays(const Node& node, const RayTable& table);
  std::pair<std::size_t, double> worst_ray(const Node& node, const RayTable& table,
                                           const Double3& twist);
  void combine(const Node& node, const RayTable& table,
               const std::vector<std::pair<double, Support>>& parts,
               SearchResult& result) const;
  void add_undecided_bounds(const Node& node, const RayTable& table, const Double3& twist);
  Double3 wrench_at(const Node& node, const RayTable& table, std::size_t ray) const;
  /// Whether g <= 0 with zeros only where nothing acts, if error bounds decide.
  std::optional<bool> certain_refutation(const Node& node, const RayTable& table,
                                         const Double3& twist);

  const DoubleModel& model_;
  std::vector<Edge> edges_;     ///< by undecided contact
  std::vector<double> bounds_;  ///< g(r)
  std::vector<double> forces_;  ///< sum of the undecided' normal coefficients at r
  std::vector<double> errors_;  ///< magnitudes of g(r)'s terms
  std::vector<double> scales_;  ///< by ray: comparable sizes of wrenches
};

}  // namespace stickslip::equilibrium_detail
