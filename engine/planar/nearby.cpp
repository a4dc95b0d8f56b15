// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearby.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/error.hpp"
#include "witness_search.hpp"

namespace stickslip {

namespace {

/// One contact of the approximation in double precision, in units of force and length.
struct ContactEstimate {
  double normal = 0;  ///< its force, or without forces the normal law's
  double law = 0;     ///< v, the normal law's, as a force
  double ratio = 0;   ///< friction over its limit; 0 where there is no limit
  double slip = 0;
};

class Estimate {
 public:
  Estimate(const Problem& problem, const ApproximateEquilibrium& approximate)
      : problem_(problem), has_forces_(approximate.forces), has_twist_(approximate.twist) {
    near_.twist = approximate.twist.value_or(Twist{});
    near_.forces = approximate.forces.value_or(std::vector<ContactForce>(problem.size()));
    const Wrench& load = problem.wrench();
    force_ = to_double(std::max<Rational>(abs(load.x), abs(load.y)));
    for (std::size_t i = 0; i < problem.size(); ++i) {
      const ContactRow& row = problem.rows()[i];
      const double length = std::hypot(to_double(row.normal.x), to_double(row.normal.y));
      const ContactForce& force = near_.forces[i];
      ContactEstimate c;
      c.slip = to_double(power(row.tangent, near_.twist)) / length;
      const Rational limit = row.friction * force.normal;
      if (limit.sign() > 0) c.ratio = to_double(force.tangential / limit);
      c.law = to_double(row.normal_coefficient(near_.twist)) * length;
      c.normal = has_forces_ ? to_double(force.normal) * length : c.law;
      force_ = std::max({force_, std::fabs(c.normal), to_double(row.preload) * length});
      const double spring = to_double(row.stiffness) * length * length;
      travel_ = std::max({travel_, std::fabs(c.slip), std::fabs(c.normal) / spring});
      contacts_.push_back(c);
    }
  }

  const Witness& near() const { return near_; }

  /// Returns the distance between the forces or, if they are not known, between the twists.
  double distance_to(const Witness& witness) const {
    if (!has_forces_) {
      const Twist& a = witness.twist;
      const Twist& b = near_.twist;
      return to_double(std::max<Rational>({abs(a.x - b.x), abs(a.y - b.y), abs(a.r - b.r)}));
    }
    Rational largest = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const ContactForce& a = witness.forces[i];
      const ContactForce& b = near_.forces[i];
      largest = std::max<Rational>(
          {largest, abs(a.normal - b.normal), abs(a.tangential - b.tangential)});
    }
    return to_double(largest);
  }

  /// Returns the modes if all that is below `small` times the largest is 0. A contact without
  /// force is open, and one whose friction is at its limit slips; or, `on_borders`, they touch
  /// and stick where the twist says so.
  std::vector<ModeGuess> guesses(double small, bool on_borders) const {
    std::vector<ModeGuess> result;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const ContactEstimate& c = contacts_[i];
      const bool closed = problem_.law() == NormalLaw::kBilateral || c.normal > small * force_;
      const bool rests = has_twist_ && std::fabs(c.slip) <= small * travel_;
      ModeGuess guess{closed, true, 0, true, false};
      if (has_forces_) {
        const bool at_limit = std::fabs(c.ratio) >= 1 - small;
        guess.sticks = !at_limit || (on_borders && rests);
        guess.share = at_limit ? Rational(c.ratio > 0 ? 1 : -1) : ratio_of(i);
      } else if (!rests) {
        guess.sticks = false;
        guess.share = c.slip > 0 ? -1 : 1;
      }
      guess.touches = !closed && on_borders && has_twist_ && std::fabs(c.law) <= small * force_;
      result.push_back(std::move(guess));
    }
    return result;
  }

 private:
  Rational ratio_of(std::size_t contact) const {
    const ContactForce& force = near_.forces[contact];
    const Rational limit = problem_.rows()[contact].friction * force.normal;
    if (limit.sign() <= 0) return 0;
    return std::clamp<Rational>(force.tangential / limit, -1, 1);
  }

  const Problem& problem_;
  bool has_forces_;
  bool has_twist_;
  Witness near_;
  std::vector<ContactEstimate> contacts_;
  double force_ = 0;
  double travel_ = 0;
};

}  // namespace

std::optional<Witness> find_witness_like(const Problem& problem,
                                         const ApproximateEquilibrium& approximate) {
  require(approximate.twist || approximate.forces, "a twist or forces are needed");
  require(!approximate.forces || approximate.forces->size() == problem.size(),
          "one force per contact is needed");
  const Estimate estimate(problem, approximate);
  if (approximate.twist && approximate.forces && !find_violation(problem, estimate.near())) {
    return estimate.near();
  }
  std::optional<Witness> nearest;
  double distance = 0;
  const auto propose = [&](std::optional<Witness> witness) {
    if (!witness) return;
    const double d = estimate.distance_to(*witness);
    if (nearest && d >= distance) return;
    nearest = std::move(witness);
    distance = d;
  };
  for (const double small : {1e-12, 1e-9, 1e-6, 1e-3}) {
    for (const bool on_borders : {false, true}) {
      propose(complete_exactly(problem, estimate.guesses(small, on_borders), &estimate.near()));
    }
  }
  if (!nearest && approximate.twist) {
    const Twist& d = *approximate.twist;
    propose(find_witness_near(problem, DoubleModel(problem),
                              {to_double(d.x), to_double(d.y), to_double(d.r)}));
  }
  return nearest;
}

}  // namespace stickslip
