// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "spatial_cells.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/engine/strict_cone.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// The normal law of a contact, as a coefficient of n: a = max(0, v), v = preload - stiffness
/// N.d.
struct NormalSpring {
  Rational preload;
  Rational stiffness;
};

struct MotionAndForces {
  RationalRow motion;
  SpatialForces forces;
};

class SpatialConesSearch {
 public:
  enum class Outcome { kRefuted, kFound, kLimit, kBorder };
  using Region = std::vector<Separation>;

  SpatialConesSearch(const GraspBox& grasp, NormalLaw law, std::size_t most_programs)
      : discs_(discs_of(grasp)), load_(load_of(grasp)), law_(law), left_(most_programs) {
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const UncertainContact& c = grasp.contacts[i];
      springs_.push_back(
          {preload_over_length(c, i), c.stiffness.low / dot(c.normal, c.normal)});
    }
  }

  Outcome run() {
    const bool may_open = law_ == NormalLaw::kUnilateral;
    return run(Region(discs_.size(), may_open ? Separation::kMixed : Separation::kClosed));
  }

  std::size_t refuted() const { return refuted_; }

  SpatialConesWitness witness() const {
    SpatialConesWitness result{found_.motion, {}};
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const auto& [normal, friction] = found_.forces[i];
      result.forces.push_back(plus(friction, normal, discs_[i].normal()));
    }
    return result;
  }

 private:
  Outcome run(const Region& region) {
    for (;;) {
      if (left_ < 2) return Outcome::kLimit;
      const auto outer = solved(region, DiscPolygon::kOuter);
      if (!outer) {
        ++refuted_;
        return Outcome::kRefuted;
      }
      if (accept(*outer)) return Outcome::kFound;
      if (const auto contact = most_in_excess(*outer)) return split(region, *contact);
      const auto inner = solved(closed_as_in(*outer), DiscPolygon::kInner);
      if (inner && accept(*inner)) return Outcome::kFound;
      if (!refine(*outer)) return Outcome::kBorder;
    }
  }

  Outcome split(const Region& region, std::size_t contact) {
    Region part = region;
    for (const Separation side : {Separation::kClosed, Separation::kOpen}) {
      part[contact] = side;
      const Outcome outcome = run(part);
      if (outcome != Outcome::kRefuted) return outcome;
    }
    return Outcome::kRefuted;
  }

  /// Returns motions and forces of a region. A contact that may be open or closed may have more
  /// normal force than its law says.
  std::optional<MotionAndForces> solved(const Region& region, DiscPolygon polygon) {
    --left_;
    LinearProgram program;
    program.add_variables(6, VariableKind::kFree);
    struct Edge {
      std::size_t contact;
      Vector3 friction;
    };
    std::vector<Edge> edges;
    std::array<RationalRow, 6> balance;
    balance.fill(RationalRow(6));
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const FrictionDisc& disc = discs_[i];
      RationalRow law = spring_row(i);
      if (region[i] == Separation::kOpen) {
        program.add_row(std::move(law), Relation::kGreaterEqual, springs_[i].preload);
        continue;
      }
      law.resize(6 + edges.size());
      for (const Vector3& f : polygon == DiscPolygon::kOuter ? disc.outer() : disc.inner()) {
        edges.push_back({i, f});
        program.add_variable(VariableKind::kNonNegative);
        law.emplace_back(1);
        const Vector6 wrench = plus(disc.normal_row(), 1, disc.wrench(f));
        for (std::size_t j = 0; j < 6; ++j) balance[j].push_back(wrench[j]);
      }
      program.add_row(
          std::move(law),
          region[i] == Separation::kClosed ? Relation::kEqual : Relation::kGreaterEqual,
          springs_[i].preload);
    }
    for (std::size_t j = 0; j < 6; ++j) {
      program.add_row(std::move(balance[j]), Relation::kEqual, -load_[j]);
    }
    const LpResult result = solve(program);
    const auto* optimal = std::get_if<Optimal>(&result);
    if (optimal == nullptr) return std::nullopt;
    const RationalRow& x = optimal->point;
    MotionAndForces found{{x.begin(), x.begin() + 6}, SpatialForces(discs_.size())};
    for (std::size_t e = 0; e < edges.size(); ++e) {
      SpatialContactForce& force = found.forces[edges[e].contact];
      force.normal += x[6 + e];
      force.friction = plus(force.friction, x[6 + e], edges[e].friction);
    }
    return found;
  }

  /// Returns stiffness N.d, by the coordinates of d.
  RationalRow spring_row(std::size_t contact) const {
    RationalRow row;
    for (const Rational& n : discs_[contact].normal_row()) {
      row.push_back(springs_[contact].stiffness * n);
    }
    return row;
  }

  Rational separation(std::size_t contact, const RationalRow& motion) const {
    return springs_[contact].preload - dot(spring_row(contact), motion);
  }

  Rational normal_law(std::size_t contact, const RationalRow& motion) const {
    const Rational v = separation(contact, motion);
    return law_ == NormalLaw::kUnilateral && v.sign() < 0 ? Rational(0) : v;
  }

  bool is_in_cone(std::size_t contact, const SpatialContactForce& force) const {
    return dot(force.friction, force.friction) <=
           discs_[contact].square() * force.normal * force.normal;
  }

  /// Keeps the point if it obeys all laws exactly.
  bool accept(const MotionAndForces& found) {
    Vector6 sum = load_;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const SpatialContactForce& force = found.forces[i];
      const bool is_lawful =
          force.normal.sign() >= 0 && force.normal == normal_law(i, found.motion) &&
          dot(force.friction, discs_[i].normal()).is_zero() && is_in_cone(i, force);
      if (!is_lawful) return false;
      sum = plus(plus(sum, force.normal, discs_[i].normal_row()), 1,
                 discs_[i].wrench(force.friction));
    }
    require(sum == Vector6{}, "the forces do not balance the load");
    found_ = found;
    return true;
  }

  std::optional<std::size_t> most_in_excess(const MotionAndForces& found) const {
    std::optional<std::size_t> worst;
    Rational most = 0;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const Rational excess = found.forces[i].normal - normal_law(i, found.motion);
      if (excess <= most) continue;
      most = excess;
      worst = i;
    }
    return worst;
  }

  Region closed_as_in(const MotionAndForces& found) const {
    Region region;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const bool is_open =
          law_ == NormalLaw::kUnilateral && separation(i, found.motion).sign() < 0;
      region.push_back(is_open ? Separation::kOpen : Separation::kClosed);
    }
    return region;
  }

  bool refine(const MotionAndForces& found) {
    bool finer = false;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const Vector3& friction = found.forces[i].friction;
      if (!is_in_cone(i, found.forces[i])) finer = discs_[i].refine(friction) || finer;
    }
    return finer;
  }

  std::vector<FrictionDisc> discs_;
  Vector6 load_;
  NormalLaw law_;
  std::size_t left_;
  std::vector<NormalSpring> springs_;
  MotionAndForces found_;
  std::size_t refuted_ = 0;
};

}  // namespace

std::variant<SpatialConesWitness, NoSpatialCones, Undecided> friction_cones_alone(
    const GraspBox& grasp, NormalLaw law, std::size_t most_programs) {
  SpatialConesSearch search(grasp, law, most_programs);
  switch (search.run()) {
    case SpatialConesSearch::Outcome::kFound:
      return search.witness();
    case SpatialConesSearch::Outcome::kRefuted:
      return NoSpatialCones{search.refuted()};
    case SpatialConesSearch::Outcome::kLimit:
      return Undecided{"it takes more than " + std::to_string(most_programs) +
                       " linear programs"};
    default:
      return Undecided{
          "forces are at the border of the friction cones, to all digits of "
          "doubles",
          "border",
          "ask about a load or friction a little off",
          {}};
  }
}

}  // namespace stickslip
