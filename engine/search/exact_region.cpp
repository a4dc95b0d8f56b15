// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_region.hpp"

#include <utility>
#include <vector>

#include "relaxed_region.hpp"

namespace stickslip {
namespace {

/// Returns the points of a region with the law's load. Solutions are where each strict function
/// of the region is positive: that is said of the points where it is not 0.
std::vector<LoadedGenerator> points_with_load(const Law& law, const MotionRegion& region) {
  std::vector<LoadedGenerator> result;
  for (const Row& x : region.points()) {
    LoadedGenerator& g = result.emplace_back();
    g.x.assign(x.begin(), x.end());
    for (const Interval& component : law.wrench) {
      g.load.push_back(g.x[law.motions] * component.low);
    }
  }
  for (const std::vector<std::size_t>& strict : region.strict_points()) {
    for (LoadedGenerator& g : result) g.positive.emplace_back(0);
    for (const std::size_t g : strict) result[g].positive.back() = 1;
  }
  return result;
}

/// Returns the points of a region, each with all loads of a hull.
std::vector<LoadedGenerator> points_with_hull(const Law& law, const MotionRegion& region) {
  std::vector<LoadedGenerator> result;
  const auto add = [&](const Row& x, const LoadGenerator& load, const Rational& times) {
    LoadedGenerator& g = result.emplace_back();
    g.x.assign(x.begin(), x.end());
    for (const Rational& component : load.load) g.load.push_back(times * component);
    for (const Rational& value : load.strict) g.positive.push_back(times * value);
    g.positive.push_back(g.x[law.motions]);
  };
  for (const Row& x : region.points()) {
    for (const LoadGenerator& corner : law.hull->corners) {
      add(x, corner, Rational(x[law.motions]));
      if (x[law.motions].is_zero()) break;
    }
  }
  for (const LoadGenerator& direction : law.hull->directions) {
    add(Row(law.coordinates()), direction, 1);
  }
  return result;
}

}  // namespace

std::variant<TreeNode, ShareWitness> decide_exactly(const Law& law,
                                                    const MotionRegion& region) {
  const std::vector<LoadedGenerator> generators =
      law.hull ? points_with_hull(law, region) : points_with_load(law, region);
  RelaxedRegion program(law.motions, generators);
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    if (region.separation(i) == Separation::kOpen) continue;
    const LawContact& contact = law.contacts[i];
    const CornerRow& row = contact.corners.front();
    const Rational& friction = contact.friction.low;
    RelaxedContact added{ContactId(i)};
    added.is_mixed = region.separation(i) == Separation::kMixed;
    added.slip = friction.is_zero() ? Sign::kPositive : region.slip_sign(i);
    for (const LoadedGenerator& g : generators) {
      added.separations.push_back(contact.separation_factors.front() *
                                  dot(contact.separations.front(), g.x));
    }
    added.edges = {row.push_with({friction}), row.push_with({-friction})};
    added.stiffness = contact.stiffness.low;
    program.add(std::move(added));
  }
  LpWork work;
  auto outcome = program.solve(work);
  if (const auto* twist = std::get_if<RationalRow>(&outcome)) {
    return TreeNode(TwistLeaf{primitive_multiple(*twist)});
  }
  const auto& found = std::get<RelaxedSum>(outcome);
  if (found.broken) {
    return std::visit([](const auto& split) { return TreeNode(split); }, *found.broken);
  }
  ShareWitness witness{
      RationalRow(found.x.begin(), found.x.begin() + static_cast<std::ptrdiff_t>(law.motions)),
      {}};
  for (const RelaxedSum::Push& push : found.pushes) {
    const Rational used = push.along[0] - push.along[1];
    if (!push.sticks || used.is_zero()) continue;
    witness.shares.emplace_back(push.contact,
                                RationalRow{used / (push.along[0] + push.along[1])});
  }
  return witness;
}

}  // namespace stickslip
