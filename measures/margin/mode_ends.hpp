// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One mode of a family: the multiples that it resists, and its equilibria at both ends of
/// them.
///
/// **Method.** In a mode the force of a closed contact is v_i(x) (N_i + sigma mu_i T_i), with
/// sigma = -1, 0 or 1 as it slips. Contacts that stick and share one circle T_c.d = 0 push
/// along one wrench T_c, with friction F_c together. Balance is
///
///     w h + u l + S x + sum F_c T_c = 0,  T_c.d = 0,  S = sum (N_i + sigma mu_i T_i) (x) v_i
///
/// Usually these 3 + c equations have one solution (d, F) for each multiple: the motions are a
/// *line*, on which every condition of the mode (v_i >= 0, v_i <= 0, tau_i >= 0, tau_i <= 0,
/// |F_c| <= sum mu_i v_i) is linear in l and bounds it on one side. A ratio test finds the
/// ends: doubles propose the condition that fails first, exact signs (point_signs.hpp) say
/// whether another fails before. S changes from mode to mode only by the contacts that do, so a
/// mode costs O(m) operations in double and a few tens of exact ones. If the motions are no
/// line, the region's linear program serves (region_program.hpp).
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "point_signs.hpp"
#include "stickslip/engine/contact_mode.hpp"

namespace stickslip::margin_detail {

/// A mode as a set of motions: closed means v >= 0 on all of it, and a contact with friction
/// has one sign of slip throughout.
using FamilyMode = std::vector<ContactMode>;

/// An equilibrium of a mode with its multiple; or a ray, any multiple of which may be added to
/// one.
struct ModePoint {
  Vector5 x;  ///< with h = 1; or h = 0, l = 1
  /// The friction b of sticking contacts, by contact; all other forces follow from x.
  std::vector<std::pair<std::size_t, Rational>> friction;
};

struct ModeEnds {
  ModePoint low;
  ModePoint high;  ///< h = 0 if there is no highest multiple
};

/// Returns true if the contact sticks as long as the mode lasts.
inline bool sticks(const Problem& family, const FamilyMode& mode, std::size_t contact) {
  return mode[contact].closed && mode[contact].slip == Sign::kZero &&
         !family.row(ContactId(contact)).friction.is_zero();
}

/// The matrix S of one mode after another. From mode to mode it changes only by the contacts
/// that do.
class ForceSum {
 public:
  explicit ForceSum(const Problem& family) : family_(family) {}

  /// Returns S: the forces at x have the wrench S x, without friction of contacts that stick.
  const std::array<Vector5, 3>& of(const FamilyMode& mode);

 private:
  const Problem& family_;
  FamilyMode mode_;  ///< the mode of sum_
  std::array<Vector5, 3> sum_{};
};

/// Returns the ends of a mode by two linear programs over its region; nothing if it resists
/// nothing.
std::optional<ModeEnds> ends_by_programs(const Problem& family, const FamilyMode& mode);

/// Finds the ends of one mode after another; it is fastest if they are alike.
class ModeLines {
 public:
  /// A family for all l >= 0, which has to outlive this.
  explicit ModeLines(const Problem& family)
      : family_(family), signs_(family), forces_(family) {}

  std::optional<ModeEnds> ends(const FamilyMode& mode);

  /// Returns true if the mode that was last asked for is a line.
  bool was_line() const { return was_line_; }

 private:
  /// Contacts that stick, whose T_i are multiples of the same vector.
  struct Circle {
    IntegerVector5 plane;
    std::vector<std::size_t> contacts;
    Vector5 limit{};                   ///< sum of mu_i |T_i| / |plane| v_i
    Rational friction, friction_rate;  ///< F = friction + l friction_rate
  };
  struct Line {
    Vector5 start{};  ///< the point at h = 1, l = 0
    Vector5 rate{};   ///< the change, with h = 0, l = 1
    std::vector<Circle> circles;
  };
  struct Condition {
    FilteredFunction function;
    Sign failing;  ///< the sign that it must not have
  };

  std::optional<Line> line_of(const FamilyMode& mode);
  std::optional<Vector5> within(const std::vector<Condition>& conditions, const Line& line,
                                bool from_above);
  std::optional<ModeEnds> ends_of(const FamilyMode& mode, const Line& line);
  ModePoint point_at(const Line& line, const Vector5& x) const;

  const Problem& family_;
  PointSigns signs_;
  ForceSum forces_;
  bool was_line_ = false;
};

}  // namespace stickslip::margin_detail
