// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Grasps of which some numbers are known as intervals: all grasps in a box at once.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "stickslip/core/grasp.hpp"

namespace stickslip {

/// The numbers from low to high, both included; low <= high.
struct Interval {
  Rational low{0};   ///< the least
  Rational high{0};  ///< the greatest

  /// One number.
  bool is_point() const { return low == high; }
  /// (low + high) / 2.
  Rational middle() const { return (low + high) / 2; }
  /// low <= x <= high.
  bool contains(const Rational& x) const { return low <= x && x <= high; }
  /// The same two ends.
  friend bool operator==(const Interval& a, const Interval& b) {
    return a.low == b.low && a.high == b.high;
  }
};

/// The interval of one number.
inline Interval point_interval(const Rational& x) {
  return {x, x};
}

/// A Contact of which every number may be an interval. The normal has the direction of
/// n + e t for some |e| <= slope, with t = (-n_y, n_x).
struct UncertainContact {
  Interval x;                ///< of the position, as is y
  Interval y;                ///< of the position
  Vector2 normal;            ///< n, as Contact::normal
  Rational slope{0};         ///< of the normal, 0 <= slope < 1
  Interval friction;         ///< mu >= 0
  Interval stiffness{1, 1};  ///< k > 0
  Interval preload;          ///< P >= 0
};

/// The components (x, y, torque) of a wrench.
using WrenchBox = std::array<Interval, 3>;

/// How far numbers of a kind may be off: by t, or by t times their size.
struct Tolerance {
  Rational amount{0};     ///< t >= 0
  bool relative = false;  ///< t is a factor: 1/10 for 10 %

  /// The interval widened at both ends: [A - t, B + t] or [A - t|A|, B + t|B|].
  Interval widen(const Interval& interval) const;
  /// As it is spelled: of 10 %, 10.
  Rational spelled() const { return relative ? Rational(100 * amount) : amount; }
  /// The same meaning.
  friend bool operator==(const Tolerance& a, const Tolerance& b) {
    return a.amount == b.amount && a.relative == b.relative;
  }
};

/// A tolerance for each kind of number; nothing: as it stands. That of normals is a slope, and
/// not relative.
struct Tolerances {
  std::optional<Tolerance> friction{};   ///< of each coefficient
  std::optional<Tolerance> stiffness{};  ///< of each stiffness
  std::optional<Tolerance> preload{};    ///< of each preload
  std::optional<Tolerance> position{};   ///< of each coordinate
  std::optional<Tolerance> normal{};     ///< of each slope
  std::optional<Tolerance> wrench{};     ///< of each component

  /// Whether any is given.
  bool any() const { return friction || stiffness || preload || position || normal || wrench; }
  /// The same tolerances.
  friend bool operator==(const Tolerances& a, const Tolerances& b) {
    return a.friction == b.friction && a.stiffness == b.stiffness && a.preload == b.preload &&
           a.position == b.position && a.normal == b.normal && a.wrench == b.wrench;
  }
};

/// A tolerance and the kind of number that it is of: "friction".
struct NamedTolerance {
  const char* kind;     ///< as in parse_tolerances
  Tolerance tolerance;  ///< of each number of that kind
};

/// Those that are given, in the order of the members of Tolerances.
std::vector<NamedTolerance> given(const Tolerances& tolerances);

/// "friction=10%,normal=0.0175": decimals or fractions, each kind at most once. Throws
/// InputError with the place "uncertain".
Tolerances parse_tolerances(std::string_view text);

/// Contacts and a wrench with numbers in intervals.
struct GraspBox {
  std::vector<UncertainContact> contacts;  ///< by ContactId
  WrenchBox wrench;                        ///< w, applied to the object

  /// Whether every interval is one number and every slope 0.
  bool is_point() const;
  /// Widened by the tolerances, and checked: throws InputError naming "contacts[i].<member>" or
  /// "wrench[j]" for a friction coefficient or preload that may be below 0, a stiffness that
  /// may be 0 or below, a slope of 1 or more, or an interval whose ends are exchanged.
  GraspBox widened(const Tolerances& tolerances) const;
  /// Each interval shrunk or grown about the value in `centre` (inside it): its ends are
  /// centre + factor (end - centre); slopes times factor. factor >= 0. Throws as widened does.
  GraspBox scaled(const LoadedGrasp& centre, const Rational& factor) const;
  /// The grasp in the middle of every interval, with the normals n.
  LoadedGrasp middle(const GraspDescription& description = {}) const;
};

/// The wrench in the middle of every interval.
Wrench middle(const WrenchBox& wrench);

/// n + slope t, with t = (-n_y, n_x).
Vector2 turned(const Vector2& normal, const Rational& slope);

/// \{ The box of one grasp, contact or wrench.
GraspBox box_of(const LoadedGrasp& loaded);
UncertainContact box_of(const Contact& contact);
WrenchBox box_of(const Wrench& wrench);
/// \}

/// Whether 1/|n| of some contact that may have a preload is irrational, so that even the box of
/// one grasp is known by an enclosure only.
bool needs_enclosure(const GraspBox& box);

}  // namespace stickslip
