// SPDX-License-Identifier: MIT
/// \file
/// The class of a load under rigid contacts (FORMAT.md §13).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answer.hpp"

namespace stickslip_check {

/// Of a contact, a N + b T.
struct RigidForce {
  Integer contact;
  Rational normal;
  Rational friction;
};

struct RigidNode {
  enum class Kind { kTouch, kSlip, kLeaf };
  using Multipliers = std::vector<std::pair<Integer, Rational>>;

  Kind kind = Kind::kLeaf;
  Integer contact;
  Rational weight;  ///< t
  Vector twist;     ///< y
  Multipliers normal;
  Multipliers tangent;
};

/// N and T of a contact, and its friction.
struct RigidRow {
  Vector normal;
  Vector tangent;
  Rational friction;
};

/// The rules of a class. The question must ask for one. All throw Rejected.
class RigidProof {
 public:
  explicit RigidProof(const Question& question);

  /// `class-twist`
  void check_twist(const Vector& twist) const;
  /// `class-force`, `class-balance`; `place` is "rest" or "forces".
  void check_forces(const std::vector<RigidForce>& forces, const Vector& acceleration,
                    const std::string& place) const;
  /// `class-motion`, after check_forces.
  void check_motion(const std::vector<RigidForce>& forces, const Vector& acceleration) const;
  /// The nodes of the tree in their order: `tree-long`, `node-depth`, `node-contact`,
  /// `class-leaf`.
  void visit(const RigidNode& node);
  /// `tree-short`
  void finish() const;

  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }

 private:
  enum class Touch : std::int8_t { kUnknown, kTouching, kApart };
  /// Of a contact; its slip, if it is known, has that sign.
  struct Label {
    Touch touch = Touch::kUnknown;
    std::optional<int> slip;
  };
  struct Cell {
    std::vector<Label> labels;
    std::vector<std::string> steps;

    std::string path() const;
  };

  Vector times_mass(const Vector& a) const;
  std::vector<Cell> children(const Cell& cell, const RigidNode& node) const;
  std::optional<std::string> refusal(const Cell& cell, const RigidNode& leaf) const;

  std::vector<RigidRow> rows_;
  Vector wrench_;
  Vector inertia_;
  std::vector<Cell> waiting_;  ///< whose nodes are still to come, the next one last
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
};

}  // namespace stickslip_check
