// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The problem of one grasp in the plane: is it stable under this wrench and this normal law?
///
/// Contact i has the rows N_i and T_i, the wrenches of a force along its normal and along its
/// tangent, and friction mu_i, stiffness k_i and preload P_i (ContactRow). An equilibrium is a
/// motion d and force coefficients (a_i, b_i), with which contact i exerts the wrench a_i N_i +
/// b_i T_i, such that (Haas-Heger et al., RSS 2018, Eqs. 1-7, preload in Eq. 4)
///
/// - balance: w + sum (a_i N_i + b_i T_i) = 0;
/// - normal law, with the separation v_i = P_i - k_i N_i.d: a_i = max(0, v_i) if unilateral,
///   a_i = v_i >= 0 if bilateral;
/// - cone: |b_i| <= mu_i a_i;
/// - dissipation: T_i.d > 0 implies b_i = -mu_i a_i, and T_i.d < 0 implies b_i = mu_i a_i.
///
/// The grasp is stable iff an equilibrium exists.
///
/// A problem may ask about a *family*: for which multiples l, in a range, is the grasp stable
/// under the wrench w + l u and the preloads P + l P^u?
///
/// Motions and multiples are homogenised to points x = (d, h, l) in Q^5 with h >= 0. Where h >
/// 0, d/h is the motion and l/h the multiple; without a family l = 0. So the separation v_i =
/// P_i h + P^u_i l - k_i N_i.d, the slip tau_i = T_i.d and the load w h + u l are linear in x.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/row.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip {

/// The multiples l of a family that are asked about: low < l < high, or low < l if there is no
/// high. If `has_low` is set, l = low is asked about as well.
struct MultipleRange {
  Rational low = 0;                             ///< >= 0
  std::optional<Rational> high = std::nullopt;  ///< above low
  bool has_low = true;                          ///< whether low is asked about
};

/// The growth of a margin: the load and preloads that it adds for each unit of the multiple.
struct Growth {
  RationalRow load{};  ///< u; empty: 0
  /// P^u, the growth of the preload of each contact, and then of the force of each spring;
  /// empty: none grows. For a Problem they are those of ContactRow::preload, each >= 0.
  std::vector<Rational> preloads{};
};

/// Contact rows, a load, a normal law, and perhaps a family: all that an engine needs.
class Problem {
 public:
  /// Makes a problem with no contacts and no load, under the unilateral law.
  Problem() = default;
  /// Makes the problem of a grasp under its load. Throws InputError if a preloaded contact has
  /// a normal of irrational length.
  Problem(const LoadedGrasp& loaded, NormalLaw law);
  /// Makes a problem of rows that may belong to no grasp file.
  Problem(std::vector<ContactRow> rows, const Wrench& wrench, NormalLaw law);

  const std::vector<ContactRow>& rows() const { return rows_; }  ///< the rows, by ContactId
  std::size_t size() const { return rows_.size(); }              ///< m, number of contacts
  /// Returns the row of a contact. Requires a contact of this problem, as do the other
  /// functions of one contact.
  const ContactRow& row(ContactId contact) const { return rows_[contact.index()]; }
  const Wrench& wrench() const { return wrench_; }  ///< w; for a family, that of the multiple 0
  NormalLaw law() const { return law_; }            ///< the law of every contact

  /// Returns a positive multiple of tau_i, as a function of points, in coprime integers. It has
  /// the signs of tau_i.
  const IntegerVector5& slip_plane(ContactId contact) const {
    return slip_planes_[contact.index()];
  }
  /// Returns v_i as a function of points.
  const Vector5& separation(ContactId contact) const { return separations_[contact.index()]; }
  /// Returns a positive multiple of v_i, as a function of points, in coprime integers.
  const IntegerVector5& separation_plane(ContactId contact) const {
    return separation_planes_[contact.index()];
  }

  const Wrench& load_growth() const { return load_growth_; }     ///< u; 0 without a family
  bool preloads_grow() const { return preloads_grow_; }          ///< whether some P^u is not 0
  bool is_family() const;                                        ///< whether something grows
  const MultipleRange& multiples() const { return multiples_; }  ///< the family's range

  /// Returns the problem of the same grasp and law under another wrench. Throws ContractError
  /// if this problem is a family. O(m).
  Problem with_wrench(const Wrench& wrench) const;
  /// Returns the family that begins with this problem, for all l >= 0. Throws ContractError if
  /// this problem is a family, if nothing grows, if a preload would fall, or if preloads grow
  /// and are not as many as the contacts. O(m).
  Problem along(const Growth& growth) const;
  /// Returns the same family for other multiples. Throws ContractError if this problem is no
  /// family, or if the range is empty inside. O(m).
  Problem within(MultipleRange multiples) const;
  /// Returns the family's member with this multiple, which is no family. O(m).
  Problem at(const Rational& multiple) const;

  /// Returns N + sigma mu T, for sigma = -1, 0 or 1: the wrench of a contact with a = 1 whose
  /// friction is the largest against the tangent, none, or the largest along it.
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
