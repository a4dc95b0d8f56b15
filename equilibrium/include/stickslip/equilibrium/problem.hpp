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
/// Motions are homogenised: x = (d, h) in Q^4 with h >= 0, so that v_i and the slip
/// tau_i = T_i.d are linear in x, and d/h is the motion when h > 0.
#pragma once

#include <optional>
#include <vector>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip {

/// \{ Coefficients of a linear function of x = (d_x, d_y, d_r, h), or a point x itself.
using IntegerVector4 = IntegerVector<4>;
using Vector4 = std::array<Rational, 4>;
/// \}

/// The loads that a problem asks about: one wrench, or the wrenches w + l u for all l in an
/// interval (certificate/FORMAT.md, section 5).
///
/// In a range the multiple l is one more homogeneous unknown beside x = (d, h): l/h is the
/// multiple when h > 0. Over a region of motions the points (x, l) are the combinations of
/// - (r, l h_r) for each ray r and each end l of the range, and
/// - the recession (0, 1) if the range has no upper end.
class LoadRange {
 public:
  /// A load at an end of the range.
  struct End {
    Rational multiple;  ///< l
    Wrench wrench;      ///< w + multiple u
  };

  /// One wrench; its multiple is 0.
  explicit LoadRange(const Wrench& wrench = {});
  /// w + l u for low < l < high, or low < l if there is no high; with `has_low` also l = low.
  /// Requires low < high.
  LoadRange(const Wrench& wrench, const Wrench& direction, const Rational& low,
            const std::optional<Rational>& high, bool has_low);

  /// w + multiple u
  Wrench wrench_at(const Rational& multiple) const { return wrench_ + multiple * direction_; }

  /// The low end, and the high end if there is one.
  const std::vector<End>& ends() const { return ends_; }
  /// The direction u, if the range has no high end.
  std::optional<Wrench> recession() const;
  bool is_single() const { return ends_.size() == 1 && has_high_; }  ///< one wrench
  /// \{ Whether l > low, or l < high, is asked: l - low h (or high h - l) is a strict function.
  bool low_is_strict() const { return low_is_strict_; }
  bool high_is_strict() const { return ends_.size() == 2; }
  /// \}

 private:
  Wrench wrench_;
  Wrench direction_;
  std::vector<End> ends_;
  bool has_high_ = true;
  bool low_is_strict_ = false;
};

/// Contact rows, a load or a range of loads, and a normal law: all that an engine needs.
class Problem {
 public:
  /// No contacts, no load, unilateral.
  Problem() = default;
  /// Throws InputError when a preloaded contact has a normal of irrational length.
  Problem(const LoadedGrasp& loaded, NormalLaw law);

  const std::vector<ContactRow>& rows() const { return rows_; }  ///< by ContactId
  std::size_t size() const { return rows_.size(); }              ///< m, number of contacts
  /// Requires a contact of this problem, as do the other functions of one contact.
  const ContactRow& row(ContactId contact) const { return rows_[contact.index()]; }
  const LoadRange& load() const { return load_; }  ///< what is applied to the object
  /// The load, which must be a single one.
  const Wrench& wrench() const;
  NormalLaw law() const { return law_; }  ///< of every contact

  /// A positive multiple of tau_i, primitive: for signs and for cutting.
  const IntegerVector4& slip_plane(ContactId contact) const {
    return slip_planes_[contact.index()];
  }
  /// v_i itself.
  const Vector4& separation(ContactId contact) const { return separations_[contact.index()]; }
  /// A positive multiple of v_i, primitive.
  const IntegerVector4& separation_plane(ContactId contact) const {
    return separation_planes_[contact.index()];
  }

  /// The same grasp and law under other loads. O(m).
  Problem with_load(LoadRange load) const;
  /// Under the one load of the problem's range with this multiple. O(m).
  Problem at(const Rational& multiple) const;

  /// N + sigma mu T, for sigma = -1, 0 or 1: the wrench of a unit normal coefficient with
  /// friction on that edge of the cone.
  Wrench edge_wrench(ContactId contact, int sigma) const;

 private:
  std::vector<ContactRow> rows_;
  LoadRange load_;
  NormalLaw law_ = NormalLaw::kUnilateral;
  std::vector<IntegerVector4> slip_planes_;
  std::vector<Vector4> separations_;
  std::vector<IntegerVector4> separation_planes_;
};

}  // namespace stickslip
