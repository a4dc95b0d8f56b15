// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_cells.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// The most rounds of refinement: polygons are then within about a billionth of the disc.
constexpr int kMostRounds = 40;

/// Returns true if the load does work along y, and no force in a cone opposes y.
bool is_unopposed(const std::vector<FrictionDisc>& discs, const Vector6& load,
                  const Vector6& y) {
  for (const FrictionDisc& disc : discs) {
    const Rational normal = dot(disc.normal_row(), y);
    const Vector3 slip = disc.slip(y);
    if (normal.sign() < 0 || normal * normal < disc.square() * dot(slip, slip)) return false;
  }
  return dot(load, y).sign() > 0;
}

/// Adds corners to the inner polygons in directions in which they may just balance the load:
/// against the pull of the load along the contact.
void add_corners_against(std::vector<FrictionDisc>& discs, const Vector6& load) {
  const Vector3 force{load[0], load[1], load[2]};
  for (FrictionDisc& disc : discs) {
    const Vector3& n = disc.normal();
    const Vector3 along = plus(force, -dot(force, n) / dot(n, n), n);
    if (disc.has_friction()) disc.add_corner(plus(Vector3{}, -1, along));
  }
}

RigidForces as_rows(const SpatialForces& forces) {
  RigidForces result;
  for (const auto& [normal, friction] : forces) {
    result.push_back({normal, {friction.begin(), friction.end()}});
  }
  return result;
}

LoadClass forces_at_rest(std::vector<FrictionDisc>& discs, const Vector6& load) {
  const SpatialCell cell(discs.size());
  const Inertia any = Inertia::of_length(1, true);  // nothing moves
  add_corners_against(discs, load);
  for (int round = 0; round < kMostRounds; ++round) {
    Vector6 twist;
    if (auto forces =
            SpatialProgram(discs, load, nullptr, cell, DiscPolygon::kInner).at_rest(twist)) {
      require(is_solution(discs, load, any, {{}, *forces}), "forces do not balance the load");
      return as_rows(*forces);
    }
    auto forces =
        SpatialProgram(discs, load, nullptr, cell, DiscPolygon::kOuter).at_rest(twist);
    if (!forces) {
      require(is_unopposed(discs, load, twist), "a contact force opposes the motion");
      return UnopposedMotion{{twist.begin(), twist.end()}};
    }
    if (is_solution(discs, load, any, {{}, *forces})) return as_rows(*forces);
    bool finer = false;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const auto& [normal, friction] = (*forces)[i];
      if (dot(friction, friction) > discs[i].square() * normal * normal) {
        finer = discs[i].refine(friction) || finer;
      }
    }
    if (!finer) break;
  }
  return Undecided{
      "forces that balance the load are at the border of the friction cones, to all "
      "digits of doubles",
      "border",
      "ask about a load or friction a little off",
      {}};
}

}  // namespace

LoadClass weakly_stable_load(const GraspBox& grasp) {
  std::vector<FrictionDisc> discs = discs_of(grasp);
  return forces_at_rest(discs, load_of(grasp));
}

RigidVerdict rigid_verdict(const GraspBox& grasp, const Inertia& inertia,
                           std::size_t most_programs) {
  std::vector<FrictionDisc> discs = discs_of(grasp);
  const Vector6 load = load_of(grasp);
  LoadClass weak = forces_at_rest(discs, load);
  if (auto* motion = std::get_if<UnopposedMotion>(&weak)) return std::move(*motion);
  if (auto* undecided = std::get_if<Undecided>(&weak)) return std::move(*undecided);
  auto& rest = std::get<RigidForces>(weak);
  SpatialSearchResult search =
      search_spatial_accelerations(discs, load, inertia, most_programs);
  if (search.undecided) return std::move(*search.undecided);
  if (search.found) {
    const Vector6& a = search.found->acceleration;
    return OpenLoad{std::move(rest), {{a.begin(), a.end()}, as_rows(search.found->forces)}};
  }
  return StronglyStable{std::move(rest), std::move(search.tree)};
}

const GraspBox& point_in_space(const Question& question) {
  require(question.in_space(), "the question is about the plane");
  if (question.box()->is_point()) return *question.box();
  throw InputError("", "", "some numbers are uncertain, and this needs one grasp",
                   "give one number for each");
}

}  // namespace stickslip
