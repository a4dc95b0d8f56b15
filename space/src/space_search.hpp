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
#include "stickslip/equilibrium/search/search_end.hpp"
#include "stickslip/equilibrium/search/tree_walk.hpp"

namespace stickslip::space_detail {

/// Motion and forces of a region whose wrenches add up to 0, in the model's units.
struct SpaceRelaxation {
  ScaledPoint<6> motion{};
  std::vector<double> normal;       ///< a by contact
  std::vector<Double3> friction;    ///< f by contact
  std::vector<std::size_t> points;  ///< generators that take part, of largest weight first
};

/// A function of points that a contact's uncertain position makes uncertain: it lies between
/// low h + middle - far.|omega| and high h + middle + far.|omega| (of the rotation omega of a
/// point).
struct Wedge {
  Vector6 middle;  ///< a function of motions
  Rational low;    ///< of the height
  Rational high;   ///< of the height
  Vector3 far;     ///< >= 0
};

/// One search, or several that share a limit.
class SpaceSearch {
 public:
  /// `direction` is that of list 2, or null. All must outlive this.
  SpaceSearch(const SpaceModel& model, const Direction<6>* direction, std::size_t node_limit,
              SpatialWork& work)
      : model_(model), direction_(direction), nodes_left_(node_limit), work_(work) {}

  /// Takes an equilibrium of the multiple, which is 0 unless the model is a margin.
  using Candidate = std::function<bool(const NearEquilibrium&, double multiple)>;
  /// To be called with relaxed equilibria that may be near real ones; true ends the search.
  void on_candidate(Candidate candidate) { candidate_ = std::move(candidate); }

  /// Appends a tree that refutes the region; false if none was found, and then `trees` has some
  /// nodes more.
  bool refute(const SpaceRegion& region, SpatialTrees& trees);
  /// Of the last search.
  SearchEnd end() const { return end_; }

 private:
  using SpaceBranch = equilibrium_detail::Branch<SpatialNode, SpaceRegion>;

  std::optional<SpaceBranch> examine(const SpaceRegion& region, std::size_t depth);
  std::optional<IntegerVector<6>> confirm(const SpaceRegion& region, const Double6& twist);
  std::optional<SpaceBranch> split(const SpaceRegion& region, const SpaceRelaxation& found);
  std::optional<SpaceBranch> split_separation(const SpaceRegion& region,
                                              const SpaceRelaxation& found,
                                              std::size_t contact) const;
  std::optional<SpaceBranch> split_slip(const SpaceRegion& region, const SpaceRelaxation& found,
                                        std::size_t contact) const;
  std::optional<SpaceBranch> split_wedge(const SpaceRegion& region,
                                         const SpaceRelaxation& found,
                                         const Wedge& wedge) const;
  bool is_candidate(const SpaceRegion& region, const SpaceRelaxation& found) const;
  bool escapes(const SpaceRelaxation& found, double energy) const;

  const SpaceModel& model_;
  const Direction<6>* direction_;
  std::size_t nodes_left_;
  SearchEnd end_ = SearchEnd::kNone;
  std::size_t nodes_ = 0;
  double least_gap_ = 1e-3;  ///< of relaxed equilibria that were tried, over the energy
  Candidate candidate_;
  SpatialWork& work_;
};

}  // namespace stickslip::space_detail
