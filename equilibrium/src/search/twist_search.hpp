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
#include "stickslip/equilibrium/search/degree.hpp"
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
  /// With a direction its rule is asked for as well (degree.hpp).
  explicit TwistSearch(const DoubleModel& model, const Direction<3>* direction = nullptr)
      : model_(model), direction_(direction) {}

  SearchResult search(const Node& node, const RayTable& table, ConeWork& work);

  /// The separation, else the slip, whose law the relaxed equilibrium breaks with the most
  /// energy; nothing if it breaks none noticeably.
  std::optional<ContactSplit> widest_gap(const Node& node, const SearchResult& found) const;

  /// The twist rounded to the smallest integers that still refute the node's region; where
  /// error bounds do not decide, exactly or, unless `exactly`, not.
  std::optional<VirtualWorkLeaf> confirm(const Problem& problem, const Node& node,
                                         const RayTable& table, const Double3& twist,
                                         ConeWork& work, bool exactly = true);

 private:
  /// The undecided contacts on a twist y, by blocks: the most work per unit of normal
  /// coefficient, alpha = y.N + sigma y.mu T on an edge of the friction cone.
  struct Work {
    BlockDoubles sigma;
    BlockDoubles alpha;
    BlockDoubles bound;  ///< alpha if closed, else max(0, alpha)
    BlockDoubles share;  ///< of max(0, v) that counts: 1, or 0 if not closed and alpha <= 0
  };
  void find_work(const RayTable& table, const Double3& twist);
  /// By a block of undecided contacts: the normal coefficients that count at a ray in the last
  /// find_work.
  BlockDoubles coefficients(const Node& node, const RayTable& table, std::size_t block,
                            std::size_t ray) const;
  /// A wrench that entered the hull: that of a ray, on the twist on which it was the worst.
  struct Support {
    double work;
    Double3 wrench;
    std::size_t ray;
    Double3 twist;
    bool against = false;  ///< it is what the direction excludes there
  };
  void scale_rays(const Node& node, const RayTable& table);
  std::pair<std::size_t, double> worst_ray(const Node& node, const RayTable& table,
                                           const Double3& twist);
  void combine(const Node& node, const RayTable& table,
               const std::vector<std::pair<double, Support>>& parts, SearchResult& result);
  void add_undecided_bounds(const RayTable& table, const Double3& twist);
  Double3 wrench_at(const Node& node, const RayTable& table, std::size_t ray) const;
  /// Whether g <= 0 with zeros only where nothing acts, if error bounds decide.
  std::optional<bool> certain_refutation(const Node& node, const RayTable& table,
                                         const Double3& twist);

  const DoubleModel& model_;
  const Direction<3>* direction_;
  std::vector<Work> work_;      ///< of find_work
  std::vector<double> bounds_;  ///< g(r)
  std::vector<double> forces_;  ///< sum of the undecided' normal coefficients at r
  std::vector<double> errors_;  ///< magnitudes of g(r)'s terms
  std::vector<double> scales_;  ///< by ray: comparable sizes of wrenches
};

}  // namespace stickslip::equilibrium_detail
