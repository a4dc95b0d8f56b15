// SPDX-License-Identifier: GPL-3.0-or-later
#include "moving_refuter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/engine/pull_rule.hpp"

namespace stickslip::degree_detail {
namespace {

using search_detail::MovingSubject;
using search_detail::MovingTwists;
using search_detail::MovingWork;

/// A piece that was cut so often is beside an equilibrium.
constexpr std::size_t kDeepest = 26;
/// \{ The rounds of the search for a leaf: on a piece, at a point, and for the best one there.
constexpr int kRounds = 40;
constexpr int kRoundsAtPoint = 60;
constexpr int kRoundsForBest = 150;
/// \}

/// Returns the middle of a body, in the law's units.
Reals middle_of(const Law& law, const DegreeProof& proof) {
  Reals middle(static_cast<Eigen::Index>(law.motions));
  for (std::size_t j = 0; j < law.motions; ++j) {
    middle[static_cast<Eigen::Index>(j)] = to_double(proof.twist[j]);
  }
  law.scale(middle);
  return middle;
}

/// Returns what a leaf for a single point (d, 1, 0) is about.
MovingSubject at_point(const Law& law, const Reals& middle, const Reals& way) {
  Reals point = Reals::Zero(static_cast<Eigen::Index>(law.coordinates()));
  point.head(middle.size()) = middle + way;
  point[middle.size()] = 1;
  MovingSubject about{
      middle, {point}, std::vector<Separation>(law.contacts.size(), Separation::kMixed)};
  const MovingWork work(law, about.points, about.separations);
  for (const MovingWork::Part& part : work.parts()) {
    Separation& separation = about.separations[part.contact];
    if (part.high[0] <= 0) separation = Separation::kOpen;
    if (part.low[0] >= 0 || law.contacts[part.contact].is_spring) {
      separation = Separation::kClosed;
    }
  }
  return about;
}

/// Returns what a leaf for a piece of a wall is about. Lines are left out: no force sees them.
MovingSubject on_piece(const Law& law, const Reals& middle, const MotionRegion& region,
                       const PullRule* pull) {
  MovingSubject about{middle, {}, {}};
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    about.separations.push_back(region.separation(i));
  }
  for (std::size_t r = 0; r < region.points().size(); ++r) {
    const Row& x = region.points()[r];
    if (x[law.motions].is_zero()) continue;
    const Reals& generator = region.generators()[r];
    about.points.emplace_back(generator / generator[middle.size()]);
    if (pull == nullptr) continue;
    Reals& along = about.pulls.emplace_back(middle.size());
    const Row exact = pull->at(x);
    for (std::size_t j = 0; j < exact.size(); ++j) {
      along[static_cast<Eigen::Index>(j)] = to_double(Rational(exact[j], x[law.motions]));
    }
    law.scale_function(along);
  }
  return about;
}

}  // namespace

bool MovingRefuter::refute(DegreeProof& proof, std::size_t wall, bool second,
                           std::size_t node_limit) {
  require(!proof.is_simplex, "a simplex is not cut along coordinates");
  const Law& law = second ? middle() : box();
  const PullRule pull(proof.direction, proof.twist);
  std::size_t nodes = 0;
  return append_tree(Piece{MotionRegion::wall(law, proof, wall), {}}, proof.trees,
                     [&](const Piece& piece, std::size_t depth) -> std::optional<Branch> {
                       if (++nodes > node_limit || depth > kDeepest) return std::nullopt;
                       return examine(proof, second ? &pull : nullptr, piece, depth);
                     });
}

std::optional<MovingRefuter::Branch> MovingRefuter::examine(const DegreeProof& proof,
                                                            const PullRule* pull,
                                                            const Piece& piece,
                                                            std::size_t depth) {
  const Law& law = pull != nullptr ? middle() : box();
  const MotionRegion& region = piece.region;
  ++work().pieces;
  if (region.is_barred()) {
    ++work().leaves;
    return Branch{TwistLeaf{Row(law.motions)}, {}};
  }
  const Reals centre = middle_of(law, proof);
  const MovingSubject about = on_piece(law, centre, region, pull);
  MovingTwists twists(law, about);
  std::optional<MovingLeaf> leaf;
  const auto found =
      twists.find(piece.guess, kRounds, [&](const MovingTwists::Coordinates& at) {
        for (const int bits : {7, 10, 14, 20, 30}) {
          leaf = twists.leaf(at, bits);
          ++work().exact_checks;
          if (region.is_refuted(*leaf, pull)) return true;
        }
        return false;
      });
  if (found.accepted) {
    ++work().leaves;
    return Branch{std::move(*leaf), {}};
  }
  if (found.pairs.empty()) return std::nullopt;
  // The point that matters most by itself may have an equilibrium: then no cut helps.
  const MovingTwists::Pair* alone = nullptr;
  for (const MovingTwists::Pair& pair : found.pairs) {
    if (pair.first == pair.other && (alone == nullptr || pair.weight > alone->weight)) {
      alone = &pair;
    }
  }
  const MovingTwists::Pair& worst = alone != nullptr ? *alone : found.pairs.front();
  lost_at_ = about.points[static_cast<std::size_t>(worst.first)].head(centre.size()) - centre;
  constexpr std::size_t kShallow = 2;
  if (alone != nullptr && depth >= kShallow) {
    MovingTwists at(law, at_point(law, centre, lost_at_));
    if (!at.find(found.coordinates, kRoundsAtPoint, [](const auto&) {
             return true;
           }).accepted) {
      return std::nullopt;
    }
  }
  // The places of the points, by coordinates of the parallelepiped.
  const auto rank = static_cast<Eigen::Index>(proof.walls.size());
  Eigen::MatrixXd places(rank, static_cast<Eigen::Index>(about.points.size()));
  for (Eigen::Index j = 0; j < rank; ++j) {
    Reals row(centre.size());
    for (Eigen::Index k = 0; k < row.size(); ++k) {
      row[k] = to_double(proof.walls[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)]);
    }
    law.scale_function(row);
    for (Eigen::Index r = 0; r < places.cols(); ++r) {
      const Reals& x = about.points[static_cast<std::size_t>(r)];
      places(j, r) = row.dot(x.head(centre.size()) - centre);
    }
  }
  Eigen::Index across = 0;
  double widest = -1;
  for (Eigen::Index j = 0; j < rank; ++j) {
    const double width = places.row(j).maxCoeff() - places.row(j).minCoeff();
    constexpr double kFlat = 1e-9;  // the wall itself
    if (!(width > kFlat)) continue;
    double mean = 0;
    double square = 0;
    for (const auto& [weight, first, other] : found.pairs) {
      const double a = places(j, first);
      const double b = places(j, other);
      mean += weight * (a + b) / 2;
      square += weight * (a * a + b * b) / 2;
    }
    constexpr double kLittle = 1e-4;
    const double spread = square - mean * mean + kLittle * width * width;
    if (!(spread > widest)) continue;
    widest = spread;
    across = j;
  }
  if (widest < 0) return std::nullopt;
  constexpr int kGrain = 27;
  const double half = (places.row(across).maxCoeff() + places.row(across).minCoeff()) / 2;
  const RationalRow& row = proof.walls[static_cast<std::size_t>(across)];
  RationalRow plane = row;
  plane.emplace_back(
      -dot(row, proof.twist) -
      rational_from_double(std::ldexp(std::round(std::ldexp(half, kGrain)), -kGrain)));
  plane.emplace_back(0);
  PlaneCut cut{primitive_multiple(plane)};
  Branch branch{cut, {}};
  for (MotionRegion& part : region.halves(cut.plane)) {
    branch.children.push_back({std::move(part), found.coordinates});
  }
  return branch;
}

double MovingRefuter::bound_at(const DegreeProof& proof, const Reals& way) const {
  MovingTwists twists(box(), at_point(box(), middle_of(box(), proof), way));
  return twists.find({}, kRoundsForBest).bound;
}

}  // namespace stickslip::degree_detail
