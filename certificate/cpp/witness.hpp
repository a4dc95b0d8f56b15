// SPDX-License-Identifier: MIT
/// \file
/// Equilibria: their forces are computed from what is stated (FORMAT.md §3), and must
/// balance the load. And segments between two (§5).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "question.hpp"

namespace stickslip_check {

/// A motion, and the shares of friction at contacts that stick.
struct Witness {
  /// The point (d, 1, lambda), or (d, 0, 1) for a ray; of a region (d, 1, s, t) or (d, 0, s,
  /// t).
  Vector x;
  std::vector<std::pair<Integer, Vector>> shares;  ///< of one number, in space three or four

  bool operator==(const Witness& other) const { return x == other.x && shares == other.shares; }
};

/// What follows for one contact; v and the slip up to one positive factor of the point, and
/// each up to one of its own.
struct ContactForce {
  Integer v;
  Form slip;     ///< T_i.d, or in space S_i d; 0 of what is no contact
  Vector share;  ///< friction over mu a, of which a = max(0, v), and v of a spring

  bool slips() const { return sign_of_dot(slip, slip) != 0; }
};

/// What load and forces add up to, at one point after another of one question: in the plane it
/// costs what changes in it.
class ForceSum {
 public:
  Vector total(const Box& box, const Form& x, const std::vector<ContactForce>& forces);

 private:
  std::vector<std::optional<int>> held_;  ///< the shares of contacts in the sum
  Vector sum_;                            ///< of the contacts held: a matrix, by rows
};

/// Gives a contact, until another is asked for.
using ContactAt = std::function<const ContactBox&(std::size_t)>;

/// `witness-box`
void check_grasp(const Question& question);

/// The rules between that and the balance: sets the shares of forces. Throws Rejected.
void take_shares(const Question& question, const ContactAt& contact_at, const Witness& witness,
                 std::vector<ContactForce>& forces);

/// `witness-balance`: x is (d, h) up to a factor, and `scale` times what is stated.
void check_balance(Vector total, const Rational& scale);

/// The rules `witness-...`. Throws Rejected, or returns the forces, one for each contact.
std::vector<ContactForce> check_witness(const Question& question, const Witness& witness,
                                        ForceSum& sum);

/// `segment-mode`: why two witnesses with these forces share no mode, or nothing.
std::optional<std::string> mode_refusal(const Question& question,
                                        const std::vector<ContactForce>& first,
                                        const std::vector<ContactForce>& second);

}  // namespace stickslip_check
