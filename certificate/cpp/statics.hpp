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
#include "work.hpp"

namespace stickslip_check {

/// An element of STAND; without direction and plane the point is (1).
struct StandPoint {
  Vector point;
  std::vector<RigidForce> forces;  ///< friction as F of §2
};

/// About what a contact costs in a sum.
inline constexpr std::uint64_t kStepsOfSum = 20 * kStepsOfRational;

/// How the point of a contact moves, and how what it is on turns, with a motion of this.
struct MotionAt {
  Vector point;
  Vector turn;
};
MotionAt motion_at(const Contact& contact, const Vector& local);

/// a N + S^T f of a contact, on the one body, or between the two.
Vector wrench_of(const RigidForce& force, const Contact& contact);

/// The rules of statics. All throw Rejected.
class StaticsProof {
 public:
  /// All friction is multiplied by the factor.
  StaticsProof(const Question& question, const Rational& factor);

  /// `static-point`, `static-force`, `static-balance`
  void check(const StandPoint& stand, const std::string& place);
  /// `static-motion` of MOVE
  void check(const Vector& twist, const std::string& place);
  /// `static-motion` of `twist`
  void check_twist(const Vector& twist) const;

  /// The multiples of a margin that may stand, if there are any, and those that must move.
  const Standing& standing() const { return standing_; }

 private:
  bool is_lawful(const RigidForce& force, const Contact& contact, const Rational& h) const;
  bool opposes(const Contact& contact, const Vector& local, const Rational& price) const;
  Rational work_of_load(const Vector& twist) const;
  void check_unopposed(const Vector& twist, const std::string& place) const;

  const Mechanism* mechanism() const {
    return question_.several ? question_.several->mechanism.get() : nullptr;
  }

  const Question& question_;
  Rational square_;            ///< phi^2
  std::vector<Vector> loads_;  ///< of each coordinate of a load point
  Vector limits_;              ///< A of each limited element
  Standing standing_;
  bool has_point_ = false;  ///< with h > 0
};

}  // namespace stickslip_check
