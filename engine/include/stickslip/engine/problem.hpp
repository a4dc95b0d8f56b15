// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The question: is this grasp stable under this wrench and this normal law?
///
/// An equilibrium is a motion d and force coefficients (a_i, b_i), standing for the contact
/// wrenches a_i N_i + b_i T_i, with (Haas-Heger et al., RSS 2018, Eqs. 1-7, preload in Eq. 4)
///
/// - balance: w + sum (a_i N_i + b_i T_i) = 0;
/// - normal law, with v_i = P_i - k_i N_i.d: a_i = max(0, v_i) unilateral, a_i = v_i >= 0
/// bilateral;
/// - cone: |b_i| <= mu_i a_i;
/// - dissipation: T_i.d > 0 implies b_i = -mu_i a_i, and T_i.d < 0 implies b_i = mu_i a_i.
///
/// The grasp is stable iff an equilibrium exists.
///
/// A problem may ask about a *family*: for which multiples l, in a range, is the grasp stable
/// under the wrench w + l u and the preloads P + l P^u?
///
/// Motions and multiples are homogenised: x = (d, h, l) in Q^5 with h >= 0, so that v_i, the
/// slip tau_i = T_i.d and the load w h + u l are linear in x; where h > 0, d/h is the motion
/// and l/h the multiple. Without a family l = 0.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip {

/// The multiples l of a family that are asked about: low < l < high, or low < l if there is no
/// high; with `has_low` also l = low.
struct MultipleRange {
  Rational low = 0;                             ///< >= 0
  std::optional<Rational> high = std::nullopt;  ///< above low
  bool has_low = true;                          ///< whether low is asked about
};

/// What a family adds to a problem for each unit of the multiple.
struct Growth {
  Wrench load;  ///< u
  /// As ContactRow::preload, by contact, each >= 0; or empty: preloads do not grow.
  std::vector<Rational> preloads = {};
};

/// Contact rows, a load, a normal law, and perhaps a family: all that an engine needs.
class Problem {
 public:
  /// No contacts, no load, unilateral.
  Problem() = default;
  /// Throws InputError when a preloaded contact has a normal of irrational length.
  Problem(const LoadedGrasp& loaded, NormalLaw law);
  /// The same by rows that may belong to no grasp file.
  Problem(std::vector<ContactRow> rows, const Wrench& wrench, NormalLaw law);

  const std::vector<ContactRow>& rows() const { return rows_; }  ///< by ContactId
  std::size_t size() const { return rows_.size(); }              ///< m, number of contacts
  /// Requires a contact of this problem, as do the other functions of one contact.
  const ContactRow& row(ContactId contact) const { return rows_[contact.index()]; }
  const Wrench& wrench() const { return wrench_; }  ///< w, of a family at the multiple 0
  NormalLaw law() const { return law_; }            ///< of every contact

  /// A positive multiple of tau_i, primitive: for signs and for cutting.
  const IntegerVector5& slip_plane(ContactId contact) const {
    return slip_planes_[contact.index()];
  }
  /// v_i itself.
  const Vector5& separation(ContactId contact) const { return separations_[contact.index()]; }
  /// A positive multiple of v_i, primitive.
  const IntegerVector5& separation_plane(ContactId contact) const {
    return separation_planes_[contact.index()];
  }

  const Wrench& load_growth() const { return load_growth_; }     ///< u; 0 without a family
  bool preloads_grow() const { return preloads_grow_; }          ///< some P^u is not 0
  bool is_family() const;                                        ///< something grows
  const MultipleRange& multiples() const { return multiples_; }  ///< of a family

  /// The same grasp and law under one other wrench. O(m).
  Problem with_wrench(const Wrench& wrench) const;
  /// The family that begins with this problem, which is none, for all l >= 0. Throws
  /// ContractError if nothing grows, or if a preload would fall. O(m).
  Problem along(const Growth& growth) const;
  /// The same family for other multiples. O(m).
  Problem within(MultipleRange multiples) const;
  /// The family's member with this multiple: no family. O(m).
  Problem at(const Rational& multiple) const;

  /// N + sigma mu T, for sigma = -1, 0 or 1: the wrench of a unit normal coefficient with
  /// friction on that edge of the cone.
  Wrench edge_wrench(ContactId contact, int sigma) const;

 private:
  std::vector<ContactRow> rows_;
  Wrench wrench_;
  Wrench load_growth_;
  bool preloads_grow_ = false;
  MultipleRange multiples_;
  NormalLaw law_ = NormalLaw::kUnilateral;
  std::vector<IntegerVector5> slip_planes_;
  std::vector<Vector5> separations_;
  std::vector<IntegerVector5> separation_planes_;
};

}  // namespace stickslip
