// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearby.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/degree/exact_witness.hpp"
#include "engine/planar/nearby.hpp"
#include "solution.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip::crosscheck_detail {
namespace {

/// Returns the motion and forces alone.
NearbyEquilibrium equilibrium_of(const Grasp& grasp, const Witness& witness) {
  NearbyEquilibrium found;
  const auto& [x, y, r] = witness.twist;
  found.twist = {x, y, r};
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const Vector2 f = force_vector(grasp.contacts()[i].normal, witness.forces[i]);
    found.forces.push_back({f.x, f.y});
  }
  return found;
}

/// Returns the same in space.
NearbyEquilibrium equilibrium_of(const GraspBox& grasp, const ShareWitness& witness) {
  NearbyEquilibrium found;
  found.twist = {witness.twist.begin(), witness.twist.end()};
  for (const SpatialForce& f : forces_of(grasp, witness.twist, witness.shares)) {
    found.forces.emplace_back(f.force.begin(), f.force.end());
  }
  return found;
}

ApproximateEquilibrium approximate(const Grasp& grasp, const Claim& claim) {
  ApproximateEquilibrium result;
  if (const auto& d = claim.twist) result.twist = Twist{(*d)[0], (*d)[1], (*d)[2]};
  if (!claim.forces) return result;
  result.forces.emplace();
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const RationalRow& f = (*claim.forces)[i];
    const Vector2& n = grasp.contacts()[i].normal;
    const Rational square = n.x * n.x + n.y * n.y;
    result.forces->push_back(
        {(f[0] * n.x + f[1] * n.y) / square, (f[1] * n.x - f[0] * n.y) / square});
  }
  return result;
}

/// Returns the modes that a claim in space suggests, in doubles: a contact with more force than
/// `small` is closed, and sticks. If no motion is claimed nothing moves.
NearEquilibrium modes_of_claim(const GraspBox& grasp, const GraspLaw& law, const Claim& claim,
                               double small) {
  NearEquilibrium near;
  near.motion = Reals::Zero(static_cast<Eigen::Index>(law.motions));
  for (std::size_t j = 0; claim.twist && j < law.motions; ++j) {
    near.motion[static_cast<Eigen::Index>(j)] = to_double((*claim.twist)[j]);
  }
  law.scale(near.motion);
  const std::size_t m = grasp.contacts.size();
  near.normal.resize(m);
  near.friction.resize(m);
  near.sticks.assign(m, 1);
  for (std::size_t i = 0; i < m; ++i) {
    const ContactGeometry contact(grasp.contacts[i]);
    const double length = std::sqrt(to_double(contact.square()));
    if (claim.forces) {
      const RationalRow& f = (*claim.forces)[i];
      const RationalRow tangential = contact.across(f);
      near.normal[i] = to_double(contact.along(f));
      near.friction[i] = law.contacts[i].coordinates_of(tangential);
    } else {
      const auto [low, high] =
          contact.separation(contact.displacement(*claim.twist)).between(64);
      near.normal[i] = to_double(low) / length;
    }
    if (near.normal[i] * length <= small) near.normal[i] = 0;
    // The force is put back into the cone, with a little to spare.
    const double most = to_double(grasp.contacts[i].friction.low) * near.normal[i] * length;
    const double size = norm_of(near.friction[i]);
    if (size > most) {
      for (double& entry : near.friction[i]) entry *= most / size * (1 - 1.0 / 1024);
    }
  }
  return near;
}

/// Returns an exact equilibrium like the claim, in which no contact with friction slips.
std::optional<ShareWitness> find_spatial_witness_like(const Question& question,
                                                      const Claim& claim) {
  const GraspBox& grasp = *question.box();
  if (needs_enclosure(grasp)) return std::nullopt;
  const GraspLaw law(grasp, question.law);
  const double force = to_double(residual_scale(grasp, claim).force);
  for (const double small : {0.0, 1e-12, 1e-9, 1e-6}) {
    auto witness = exact_witness(law, modes_of_claim(grasp, law, claim, small * force));
    if (witness) return witness;
  }
  return std::nullopt;
}

std::optional<NearbyEquilibrium> find_like(const Answer& answer, const Claim& claim,
                                           bool is_its_own) {
  const Question& question = answer.question;
  std::optional<NearbyEquilibrium> found;
  if (is_its_own) {
    found.emplace();
    found->twist = *claim.twist;
    found->forces = *claim.forces;
  } else if (question.box() != nullptr) {
    if (const auto witness = find_spatial_witness_like(question, claim)) {
      found = equilibrium_of(*question.box(), *witness);
    }
  } else {
    const Grasp& grasp = question.loaded().grasp;
    if (const auto witness = find_witness_like(*answer.problem, approximate(grasp, claim))) {
      found = equilibrium_of(grasp, *witness);
    }
  }
  if (found) found->from_claim = true;
  return found;
}

std::optional<NearbyEquilibrium> equilibrium_of(const Answer& answer) {
  const auto& stable = std::get<Stable>(answer.verdict);
  if (const auto* witness = std::get_if<Witness>(&stable.proof)) {
    return equilibrium_of(answer.question.loaded().grasp, *witness);
  }
  if (const auto* witness = std::get_if<ShareWitness>(&stable.proof)) {
    return equilibrium_of(*answer.question.box(), *witness);
  }
  return std::nullopt;
}

Rational largest_difference(const RationalRow& a, const RationalRow& b) {
  return largest(sum(a, -1, b));
}

}  // namespace

std::vector<Sign> slip_of(const GraspBox& grasp, const RationalRow& twist) {
  std::vector<Sign> slip;
  for (const UncertainContact& c : grasp.contacts) {
    const ContactGeometry contact(c);
    slip.push_back(sign_of_int(contact.slip_sign(contact.displacement(twist))));
  }
  return slip;
}

bool is_equilibrium(const ClaimResiduals& residuals) {
  return residuals.dissipation && residuals.missed(0, {}).empty();
}

std::optional<Stable> verdict_by(const Question& question, const Claim& claim) {
  const GraspBox& grasp = *question.box();
  if (needs_enclosure(grasp)) return std::nullopt;
  ShareWitness witness{*claim.twist, {}};
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const ContactGeometry contact(grasp.contacts[i]);
    const RationalRow& force = (*claim.forces)[i];
    const RationalRow friction = contact.across(force);
    const bool slips = contact.slip_sign(contact.displacement(*claim.twist)) != 0;
    if (slips || largest(friction).is_zero()) continue;
    const Rational most = grasp.contacts[i].friction.low * contact.along(force);
    witness.shares.emplace_back(ContactId(i), sum(RationalRow(3), 1 / most, friction));
  }
  return Stable{std::move(witness), *claim.twist};
}

std::optional<NearbyEquilibrium> nearby_equilibrium(const GraspBox& grasp, const Answer& answer,
                                                    const Claim& claim, bool is_its_own) {
  std::optional<NearbyEquilibrium> found = find_like(answer, claim, is_its_own);
  if (!found) found = equilibrium_of(answer);
  if (!found) return found;
  if (claim.twist) {
    found->twist_distance = largest_difference(*claim.twist, found->twist);
    found->same_slip = slip_of(grasp, *claim.twist) == slip_of(grasp, found->twist);
  }
  if (claim.forces) found->force_distance = Rational(0);
  found->same_contacts = true;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const ContactGeometry contact(grasp.contacts[i]);
    const int bears = claim.forces
                          ? contact.along((*claim.forces)[i]).sign()
                          : contact.separation(contact.displacement(*claim.twist)).sign();
    if ((bears > 0) != (contact.along(found->forces[i]).sign() > 0)) {
      found->same_contacts = false;
    }
    if (!claim.forces) continue;
    found->force_distance = std::max(*found->force_distance,
                                     largest_difference((*claim.forces)[i], found->forces[i]));
  }
  return found;
}

}  // namespace stickslip::crosscheck_detail
