// SPDX-License-Identifier: MIT
/// \file
/// Equilibria: their forces are computed from what is stated (FORMAT.md §3), and must balance
/// the load. And segments between two (§5).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "question.hpp"

namespace stickslip_check {

/// A motion, and the shares of friction at contacts that stick.
struct Witness {
  Vector x;  ///< the point (d, 1, lambda); or (d, 0, 1) for a ray
  std::vector<std::pair<Integer, Rational>> shares;

  bool operator==(const Witness& other) const { return x == other.x && shares == other.shares; }
};

/// What follows for one contact; v and the slip up to one positive factor of the point.
struct ContactForce {
  Integer v;
  Integer slip;    ///< T_i.d
  Rational share;  ///< b / (mu a), of which a = max(0, v)
};

/// The rules `witness-...`. Throws Rejected, or returns the forces, one for each contact.
std::vector<ContactForce> check_witness(const Question& question, const Witness& witness);

/// `segment-mode`: why two witnesses with these forces share no mode, or nothing.
std::optional<std::string> mode_refusal(const Question& question,
                                        const std::vector<ContactForce>& first,
                                        const std::vector<ContactForce>& second);

}  // namespace stickslip_check
