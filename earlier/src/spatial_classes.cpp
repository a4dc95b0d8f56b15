// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/spatial_classes.hpp"

#include "spatial_cells.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/equilibrium/option_text.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// Rounds of refinement: polygons are then within about a billionth of the disc.
constexpr int kMostRounds = 40;

/// Along y the load does work, and no force in a cone opposes it.
bool is_unopposed(const std::vector<FrictionDisc>& discs, const Vector6& load,
                  const Vector6& y) {
  for (const FrictionDisc& disc : discs) {
    const Rational normal = dot(disc.normal_row(), y);
    const Vector3 slip = disc.slip(y);
    if (normal.sign() < 0 || normal * normal < disc.square() * dot(slip, slip)) return false;
  }
  return dot(load, y).sign() > 0;
}

/// Directions in which a corner of the inner polygon may just balance the load: against what it
/// pulls along the contact.
void add_corners_against(std::vector<FrictionDisc>& discs, const Vector6& load) {
  const Vector3 force{load[0], load[1], load[2]};
  for (FrictionDisc& disc : discs) {
    const Vector3& n = disc.normal();
    const Vector3 along = plus(force, -dot(force, n) / dot(n, n), n);
    if (disc.has_friction()) disc.add_corner(plus(Vector3{}, -1, along));
  }
}

SpatialLoadClass forces_at_rest(std::vector<FrictionDisc>& discs, const Vector6& load) {
  const SpatialCell cell(discs.size());
  add_corners_against(discs, load);
  for (int round = 0; round < kMostRounds; ++round) {
    Vector6 twist;
    if (auto forces = SpatialProgram(discs, load, nullptr, cell, Side::kInner).at_rest(twist)) {
      require(is_solution(discs, load, {}, {{}, *forces}), "forces do not balance the load");
      return std::move(*forces);
    }
    auto forces = SpatialProgram(discs, load, nullptr, cell, Side::kOuter).at_rest(twist);
    if (!forces) {
      require(is_unopposed(discs, load, twist), "a contact force opposes the motion");
      return SpatialUnopposedMotion{twist};
    }
    if (is_solution(discs, load, {}, {{}, *forces})) return std::move(*forces);
    bool finer = false;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const auto& [normal, friction] = (*forces)[i];
      if (dot(friction, friction) > discs[i].square() * normal * normal) {
        finer = discs[i].refine(friction) || finer;
      }
    }
    if (!finer) break;
  }
  return Undecided{"forces that balance the load are at the border of the friction cones, to all "
                   "digits of doubles",
                   "border", "ask about a load or friction a little off", {}};
}

}  // namespace

SpatialLoadClass weakly_stable_load(const GraspBox& grasp) {
  std::vector<FrictionDisc> discs = discs_of(grasp);
  return forces_at_rest(discs, load_of(grasp));
}

SpatialRigidVerdict rigid_verdict(const GraspBox& grasp, const SpatialInertia& inertia,
                                  std::size_t most_programs) {
  std::vector<FrictionDisc> discs = discs_of(grasp);
  const Vector6 load = load_of(grasp);
  SpatialLoadClass weak = forces_at_rest(discs, load);
  if (auto* motion = std::get_if<SpatialUnopposedMotion>(&weak)) return std::move(*motion);
  if (auto* undecided = std::get_if<Undecided>(&weak)) return std::move(*undecided);
  auto& rest = std::get<SpatialForces>(weak);
  SpatialSearchResult search =
      search_spatial_accelerations(discs, load, inertia, most_programs);
  if (search.undecided) return std::move(*search.undecided);
  if (search.found) {
    return SpatialOpenLoad{std::move(rest), search.found->acceleration,
                           std::move(search.found->forces)};
  }
  return SpatialStronglyStable{std::move(rest), std::move(search.tree)};
}

std::string name_of(const SpatialRigidVerdict& verdict) {
  constexpr const char* kNames[] = {"must move", "must hold", "open", "undecided"};
  return kNames[verdict.index()];
}

RationalRow inertia_numbers(const std::string& value) {
  if (value.empty()) return {};
  RationalRow numbers = numbers_option("--inertia", value);
  if (numbers.size() <= 3) {
    inertia_of("--inertia", numbers);
  } else {
    spatial_inertia_of("--inertia", numbers);
  }
  return numbers;
}

const GraspBox& point_in_space(const Question& question) {
  require(question.in_space(), "the question is about the plane");
  if (question.box()->is_point()) return *question.box();
  throw InputError("", "", "some numbers are uncertain, and this needs one grasp",
                   "give one number for each");
}

Vector6 times_mass(const SpatialInertia& inertia, const Vector6& a) {
  const Vector3 turn{a[3], a[4], a[5]};
  const Vector3 force = plus(Vector3{a[0], a[1], a[2]}, 1, cross(turn, inertia.centre));
  const Vector3 moment = cross(inertia.centre, force);
  Vector6 result{force[0], force[1], force[2]};
  for (std::size_t j = 0; j < 3; ++j) {
    result[3 + j] = moment[j] + dot(inertia.gyration[j], turn);
  }
  return result;
}

Json inertia_json(const SpatialInertia& inertia) {
  Json tensor = Json::array();
  for (const Vector3& row : inertia.gyration) tensor.push_back(number_json(row));
  return {{"centre", number_json(inertia.centre)}, {"gyration", std::move(tensor)}};
}

SpatialInertia spatial_inertia_of(const std::string& place,
                                  const std::vector<Rational>& numbers) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError("", place, problem,
                     "give the centre of mass, x, y and z, and of the tensor of inertia about it, "
                     "over the mass, xx, yy, zz, and xy, xz, yz if they are not 0, as in "
                     "0,0,1/2,1/6,1/6,1/6");
  };
  if (numbers.size() != 6 && numbers.size() != 9) {
    refuse("there are " + std::to_string(numbers.size()) + " numbers, and the grasp is in space");
  }
  const auto at = [&](std::size_t j) { return j < numbers.size() ? numbers[j] : Rational(0); };
  SpatialInertia result{{at(0), at(1), at(2)},
                        {{{at(3), at(6), at(7)}, {at(6), at(4), at(8)}, {at(7), at(8), at(5)}}}};
  const auto& [x, y, z] = result.gyration;
  if (x[0].sign() <= 0 || (x[0] * y[1] - x[1] * y[0]).sign() <= 0 ||
      dot(x, cross(y, z)).sign() <= 0) {
    refuse("the tensor is not positive definite");
  }
  return result;
}

}  // namespace stickslip
