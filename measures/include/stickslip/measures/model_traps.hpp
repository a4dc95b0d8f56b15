// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rules of the model's warnings (model_warnings.hpp) as far as the plane and space share
/// them: they see only sizes, lengths, forces and verdicts. A wrench has D components; its
/// force is the first two in the plane and the first three in space.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/core/ids.hpp"
#include "stickslip/core/number.hpp"

namespace stickslip {

/// \{ Thresholds.
inline constexpr int kLargestRotation = 1;  ///< in radians
inline constexpr int kLeastPartOfPreload =
    100;  ///< a preload is lost below one part in so many
inline constexpr int kStiffnessFactor = 10;
inline constexpr std::size_t kMostContactsToVary = 16;
/// How many nodes verdicts with other stiffnesses may take beyond the nodes of the verdict
/// itself.
inline constexpr std::size_t kNodesToVary = 64;
/// \}

/// The sorts of warning, in the order in which they are given.
enum class ModelTrap {
  kLargeMotion,
  kUnbalancedPreload,
  kLostPreload,
  kAssumedStiffness,
  kReversedContact,
  kEdgeBalance
};

/// Returns "large-motion", "unbalanced-preload", "lost-preload", "assumed-stiffness",
/// "reversed-contact" or "edge-balance".
const char* to_string(ModelTrap trap);

/// A warning: one way in which the answer may mislead.
struct ModelWarning {
  ModelTrap trap;    ///< for programs
  std::string text;  ///< one line for people, with rounded numbers
};

/// A list of warnings with at most one of each sort.
class ModelWarnings {
 public:
  /// Adds a warning, unless there is no text or the list has one of the sort.
  void add(ModelTrap trap, std::optional<std::string> text);
  bool has(ModelTrap trap) const;  ///< whether the list has one of the sort
  /// Returns all warnings in the order in which they were added.
  std::vector<ModelWarning> take() && { return std::move(all_); }

 private:
  std::vector<ModelWarning> all_;
};

/// The sizes of a motion, as squares; all but the width are also times scale^2, so that they
/// need no division.
struct MotionSizes {
  Rational scale = 1;                          ///< the factor
  Rational turn;                               ///< the square of the rotation
  std::size_t contacts;                        ///< the number of contacts
  std::function<Rational(std::size_t)> moved;  ///< the square of the displacement of each
                                               ///< contact
  Rational width;                              ///< squared_width() of the grasp, not scaled
};

/// Returns the square of the diagonal of the box, parallel to the axes, around points.
template <std::size_t n>
Rational squared_width(const std::vector<std::array<Rational, n>>& points) {
  Rational sum = 0;
  for (std::size_t j = 0; j < n && !points.empty(); ++j) {
    Rational low = points.front()[j];
    Rational high = low;
    for (const auto& p : points) {
      if (p[j] < low) low = p[j];
      if (p[j] > high) high = p[j];
    }
    sum += (high - low) * (high - low);
  }
  return sum;
}

/// \{ The text of the warning, or nothing if all is well.
std::optional<std::string> large_motion(const MotionSizes& motion, bool stiffness_was_assumed);
/// `preload_and_kept` returns a contact's preload and its normal force now.
std::optional<std::string> lost_preload(
    std::size_t contacts,
    const std::function<std::pair<Rational, Rational>(std::size_t)>& preload_and_kept);
std::string unbalanced_preload();
/// \}

/// Returns the factor of friction at which doubles propose whether a verdict may differ from
/// this one. The small difference from 1 leaves what is near a threshold to exact arithmetic.
inline Rational friction_to_tell_by(bool stable) {
  return Rational(stable ? 9999 : 10001, 10000);
}

/// The stiffnesses to try, and how to try them.
struct StiffnessTrial {
  std::vector<Rational> stiffness;  ///< the stiffness by contact
  std::vector<ContactId> assumed;   ///< the contacts for which 1 was taken
  bool stable;                      ///< the verdict
  std::size_t nodes;                ///< the nodes that the verdict took
  /// Whether the verdict may be the other one with this stiffness of this contact: a proposal.
  std::function<bool(ContactId, const Rational&)> may_differ;
  /// Whether the grasp is stable with this stiffness of this contact; nothing if the number of
  /// nodes that is passed does not suffice. Subtracts the nodes that it took from that number.
  std::function<std::optional<bool>(ContactId, const Rational&, std::size_t&)> is_stable;
};

/// Returns the text of the warning, or nothing if all is well.
std::optional<std::string> assumed_stiffness(const StiffnessTrial& trial);

/// The wrenches that a preloaded contact can exert at the motion 0, in doubles.
template <std::size_t D>
struct RestingContact {
  std::array<double, D> push;  ///< the wrench of the preload
  /// The wrench of the most friction along a tangent; in space, along two at right angles.
  std::array<std::array<double, D>, D == 3 ? 1 : 2> friction;
  /// The error bound, by component, of push and any friction together.
  std::array<double, D> error;
};

/// Returns true if `value` is 0 or between 2^-200 and 2^200 in size, so that no product of a
/// few such numbers overflows or vanishes.
inline bool is_moderate(double value) {
  constexpr double kLargest = 0x1p200;
  const double size = std::fabs(value);
  return value == 0 || (size <= kLargest && size >= 1 / kLargest);
}

/// Returns true if nearest_wrench() finds a virtual twist along which everything that the
/// contacts can exert certainly does negative work: then no friction balances the preloads.
/// Requires moderate numbers. O(m) for each of at most a hundred steps, mostly fewer than ten.
template <std::size_t D>
bool is_certainly_unbalanced(std::vector<RestingContact<D>> contacts);

/// \{ The instances for the plane and for space.
extern template bool is_certainly_unbalanced<3>(std::vector<RestingContact<3>>);
extern template bool is_certainly_unbalanced<6>(std::vector<RestingContact<6>>);
/// \}

}  // namespace stickslip
