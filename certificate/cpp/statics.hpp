// SPDX-License-Identifier: MIT
/// \file
/// Statics: forces that let bodies stand, and twists along which they must move (FORMAT.md
/// §16). Time and memory are linear in the number of elements.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "rigid.hpp"

namespace stickslip_check {

/// An element of STAND; without direction and plane the point is (1).
struct StandPoint {
  Vector point;
  std::vector<RigidForce> forces;  ///< friction as F of §2
};

/// The rules of statics. The question must ask for it. All throw Rejected.
class StaticsProof {
 public:
  explicit StaticsProof(const Question& question);

  /// `static-point`, `static-force`, `static-balance`
  void check(const StandPoint& stand, const std::string& place);
  /// `static-motion` of MOVE
  void check(const Vector& twist, const std::string& place);
  /// `static-motion` of `twist`
  void check_twist(const Vector& twist) const;

  /// The multiples of a margin that may stand, if there are any, and those that must move.
  const Standing& standing() const { return standing_; }

 private:
  bool is_lawful(const RigidForce& force, const Contact& contact) const;
  bool opposes(const Contact& contact, const Vector& local) const;
  void check_unopposed(const Vector& twist, const std::string& place) const;

  const Question& question_;
  Rational square_;            ///< phi^2
  std::vector<Vector> loads_;  ///< of each coordinate of a load point
  Standing standing_;
  bool has_point_ = false;  ///< with h > 0
};

}  // namespace stickslip_check
