// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rules of the model's warnings (model_warnings.hpp) by what the plane and space have in
/// common: sizes, lengths, forces and verdicts. A wrench has D components, the first half or,
/// in the plane, two of them a force.
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
inline constexpr int kLargestRotation = 1;       ///< in radians
inline constexpr int kLeastPartOfPreload = 100;  ///< one part in so many
inline constexpr int kStiffnessFactor = 10;
inline constexpr std::size_t kMostContactsToVary = 16;
/// Nodes of verdicts with other stiffnesses, beyond as many as the verdict itself took.
inline constexpr std::size_t kNodesToVary = 64;
/// \}

/// The sorts of warning, in the order in which they are given.
enum class ModelTrap {
  kLargeMotion,
  kUnbalancedPreload,
  kLostPreload,
  kAssumedStiffness,
  kReversedContact
};

/// "large-motion", "unbalanced-preload", "lost-preload", "assumed-stiffness",
/// "reversed-contact".
const char* to_string(ModelTrap trap);

/// At most one of each sort.
struct ModelWarning {
  ModelTrap trap;    ///< for programs
  std::string text;  ///< one line for people, with rounded numbers
};

/// At most one of each sort.
class ModelWarnings {
 public:
  /// Unless there is no text, or a warning of the sort.
  void add(ModelTrap trap, std::optional<std::string> text);
  bool has(ModelTrap trap) const;  ///< whether there is one of the sort
  /// All, in the order in which they were added.
  std::vector<ModelWarning> take() && { return std::move(all_); }

 private:
  std::vector<ModelWarning> all_;
};

/// A motion by its sizes.
struct MotionSizes {
  Rational scale = 1;    ///< what follows is squared, and times its square but for the width
  Rational turn;         ///< of the rotation
  std::size_t contacts;  ///< their number
  std::function<Rational(std::size_t)> moved;  ///< of the displacement of each contact
  Rational width;                              ///< of the grasp: squared_width()
};

/// The square of the diagonal of the box, parallel to the axes, around points.
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

/// \{ What is wrong, if anything.
std::optional<std::string> large_motion(const MotionSizes& motion, bool stiffness_was_assumed);
/// `preload_and_kept`, by contact: what it was preloaded with, and pushes with now.
std::optional<std::string> lost_preload(
    std::size_t contacts,
    const std::function<std::pair<Rational, Rational>(std::size_t)>& preload_and_kept);
std::string unbalanced_preload();
/// \}

/// Times which friction is taken where doubles tell whether a verdict may differ from this one:
/// what is so near to a threshold is left to exact arithmetic.
inline Rational friction_to_tell_by(bool stable) {
  return Rational(stable ? 9999 : 10001, 10000);
}

/// Which stiffnesses to try, and how.
struct StiffnessTrial {
  std::vector<Rational> stiffness;  ///< by contact
  std::vector<ContactId> assumed;   ///< those for which 1 was taken
  bool stable;                      ///< the verdict
  std::size_t nodes;                ///< that it took
  /// Whether the verdict may be the other one with this stiffness of this contact: a proposal.
  std::function<bool(ContactId, const Rational&)> may_differ;
  /// Whether it is stable, if that is found within so many nodes, from which those are taken
  /// that it took.
  std::function<std::optional<bool>(ContactId, const Rational&, std::size_t&)> is_stable;
};

/// What is wrong, if anything.
std::optional<std::string> assumed_stiffness(const StiffnessTrial& trial);

/// What a preloaded contact exerts at the motion 0, in doubles.
template <std::size_t D>
struct RestingContact {
  std::array<double, D> push;  ///< the wrench of the preload
  /// That of the most friction along a tangent; in space, along two at right angles.
  std::array<std::array<double, D>, D == 3 ? 1 : 2> friction;
  /// Bounds, by component, what push and any friction together are off by.
  std::array<double, D> error;
};

/// Whether `value` is 0 or between 2^-200 and 2^200, so that no product of a few such numbers
/// overflows or vanishes.
inline bool is_moderate(double value) {
  constexpr double kLargest = 0x1p200;
  const double size = std::fabs(value);
  return value == 0 || (size <= kLargest && size >= 1 / kLargest);
}

/// Whether some virtual twist, found by nearest_wrench(), certainly is one along which all that
/// the contacts can exert does negative work: then no friction balances the preloads. Requires
/// moderate numbers. O(m) for each of at most a hundred steps, mostly fewer than ten.
template <std::size_t D>
bool is_certainly_unbalanced(std::vector<RestingContact<D>> contacts);

/// \{ For the plane and for space.
extern template bool is_certainly_unbalanced<3>(std::vector<RestingContact<3>>);
extern template bool is_certainly_unbalanced<6>(std::vector<RestingContact<6>>);
/// \}

}  // namespace stickslip
