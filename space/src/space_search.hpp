// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Trees about a box in space, found by branch and bound as those in the plane are
/// (equilibrium/search/branch_and_bound.hpp). What doubles propose is confirmed exactly.
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "equilibria.hpp"
#include "space_region.hpp"

namespace stickslip::space_detail {

/// The result of a search for a virtual twist.
struct SpatialSearchResult {
  bool separated = false;
  Double6 twist{};  ///< if separated
  // Otherwise a relaxed equilibrium:
  Double6 motion{};                 ///< d, times height
  double height = 0;                ///< h
  std::vector<double> normal;       ///< a by contact
  std::vector<Double3> friction;    ///< f by contact
  std::vector<std::size_t> points;  ///< generators that take part, of largest weight first
};

/// One search, or several that share a limit.
class SpaceSearch {
 public:
  /// `direction` is that of list 2, or null. All must outlive this.
  SpaceSearch(const SpaceModel& model, const SpatialDirection* direction,
              std::size_t node_limit, SpatialWork& work)
      : model_(model), direction_(direction), nodes_left_(node_limit), work_(work) {}

  /// To be called with relaxed equilibria that may be near real ones; true ends the search.
  void on_candidate(std::function<bool(const NearEquilibrium&)> candidate) {
    candidate_ = std::move(candidate);
  }

  /// Appends a tree that refutes the region; false if none was found, and then `trees` has some
  /// nodes more.
  bool refute(const SpaceRegion& region, SpatialTrees& trees) {
    return visit(region, trees, 0);
  }

 private:
  bool visit(const SpaceRegion& region, SpatialTrees& trees, std::size_t depth);
  bool is_candidate(const SpaceRegion& region, const SpatialSearchResult& found) const;
  bool cut(const SpaceRegion& region, const Point& plane, SpatialTrees& trees,
           std::size_t depth);
  bool split(const SpaceRegion& region, const SpatialSearchResult& found, SpatialTrees& trees,
             std::size_t depth);
  bool split_slip(const SpaceRegion& region, const SpatialSearchResult& found,
                  std::size_t contact, SpatialTrees& trees, std::size_t depth);
  SpatialSearchResult search(const SpaceRegion& region) const;
  std::optional<IntegerVector<6>> confirm(const SpaceRegion& region, const Double6& twist);

  const SpaceModel& model_;
  const SpatialDirection* direction_;
  std::size_t nodes_left_;
  std::size_t nodes_ = 0;
  double least_gap_ = 1e-3;  ///< of relaxed equilibria that were tried, over the energy
  std::function<bool(const NearEquilibrium&)> candidate_;
  SpatialWork& work_;
};

}  // namespace stickslip::space_detail
