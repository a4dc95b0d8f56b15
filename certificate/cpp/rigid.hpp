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

/// Of a contact, a N and a force across n: in the plane b, of b t, in space a vector.
struct RigidForce {
  Integer contact;
  Rational normal;
  Vector friction;
};

struct RigidNode {
  enum class Kind { kTouch, kSlip, kLeaf };

  Kind kind = Kind::kLeaf;
  Integer contact;
  Vector direction;  ///< d of a slip in space
  Rational weight;   ///< t
  Vector twist;      ///< y
  std::vector<std::pair<Integer, Rational>> normal;
  std::vector<std::pair<Integer, Vector>> tangent;  ///< as RigidForce::friction
};

/// A contact: p, n, N and (mu |n|)^2.
struct RigidRow {
  Vector point;
  Vector direction;
  Vector normal;
  Rational square;

  Vector slip(const Vector& motion) const;      ///< S d, in the plane t (T.d) / |n|^2
  Vector across(const Vector& friction) const;  ///< b t of b; in space itself
  bool slips_like(const RigidRow& other) const;
  bool resists(const Vector& motion, const Vector& side) const;
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
  /// `class-slip`, `class-leaf`.
  void visit(const RigidNode& node);
  /// `tree-short`
  void finish() const;

  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }

 private:
  enum class Touch : std::int8_t { kUnknown, kTouching, kApart };
  /// Of a contact. Its slip, if it is known, is a sum of multiples of these, or without any 0:
  /// in the plane of one, in space of two.
  struct Label {
    Touch touch = Touch::kUnknown;
    std::optional<std::vector<Vector>> slip;
  };
  struct Cell {
    std::vector<Label> labels;
    std::vector<std::string> steps;

    std::string path() const;
  };

  Vector times_mass(const Vector& a) const;
  std::vector<Cell> children(const Cell& cell, const RigidNode& node) const;
  bool is_direction(const Cell& cell, const RigidNode& node) const;
  bool opposes(const RigidRow& row, const Label& label, const Vector& y) const;
  std::optional<std::string> refusal(const Cell& cell, const RigidNode& leaf) const;

  std::vector<RigidRow> rows_;
  Vector wrench_;
  Vector inertia_;
  std::vector<Cell> waiting_;  ///< whose nodes are still to come, the next one last
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
};

}  // namespace stickslip_check
