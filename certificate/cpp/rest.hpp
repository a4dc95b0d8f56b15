// SPDX-License-Identifier: MIT
/// \file
/// Proofs that every grasp in a box is stable with all contacts at rest (FORMAT.md §6, "Stable:
/// at rest"); and what they have in common with those by sticking contacts (`sticking`).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "box.hpp"

namespace stickslip_check {

/// Contacts, each with so many friction forces: of one number, in space of three or four.
using ContactForces = std::vector<std::pair<Integer, std::vector<Vector>>>;

/// Friction forces that answer whatever load is left, as the certificate states them; only
/// their shape has been checked.
struct RestProof {
  ContactForces rest;     ///< f0: one force each
  ContactForces answers;  ///< G: D forces each
  Vector reach;           ///< Z
};

/// The rules `rest-...` of what is at `place`, for all multiples from range.low to *range.high.
/// Throws Rejected.
void check_rest(const RestProof& proof, const Box& box, const Range& range,
                const std::string& place);

/// The forces that are stated of one contact.
struct Stated {
  std::vector<Vector> friction;  ///< f0, and G_1 to G_D: 1 + D forces; or none
  Vector presses;                ///< H_1 to H_D, or none
};
using StatedForces = std::map<std::size_t, Stated>;

/// "contact 2: "
std::string contact_name(const Integer& contact);

/// `rest-share`, or another `rule`: takes a list, whose first force is number `first` of 1 + D.
void take_friction(const ContactForces& list, std::size_t first, const char* rule,
                   const Box& box, const std::string& place, StatedForces& stated);

/// P'_i for this multiple.
Bounds preload_of(const ContactBox& contact, const Rational& multiple);

/// The largest |W_k|, and |M_kl - delta_kl| by columns, where contacts press by so much.
Vector largest_left(const Box& box, const Rational& multiple, const StatedForces& stated,
                    const std::function<Bounds(const BoxContact&)>& push);
/// The sum over a row of these: of |W_k|, and of |M_kl - delta_kl| Z_l.
Rational most_left(const Vector& left, const Vector& reach, std::size_t k);

/// L_i, or where friction is one number 1.
Bounds length_of(const ContactBox& contact);
/// |f|, or what is not less.
Rational length_above(const ContactBox& contact, const Vector& f);
/// |f0| + sum |G_l| Z_l.
Rational most_friction(const ContactBox& contact, const std::vector<Vector>& friction,
                       const Vector& reach);

}  // namespace stickslip_check
