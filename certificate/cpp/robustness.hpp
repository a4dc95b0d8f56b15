// SPDX-License-Identifier: MIT
/// \file
/// Bounds of PCR and PGR (FORMAT.md §18): forces that show the lower one, and a tree that shows
/// the upper one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"

namespace stickslip_check {

/// The force of a contact that is not detached.
struct RobustForce {
  Integer contact;
  bool sticks = false;  ///< else it slips
  Vector force;
};

/// The member `combination`.
struct RobustCombination {
  Rational distance;
  Rational inverse_square;
  std::vector<RobustForce> forces;
};

enum class RobustNodeKind : std::int8_t { kState, kDistance, kLeaf, kCombination, kNone };

/// A node of `tree`.
struct RobustNode {
  RobustNodeKind kind = RobustNodeKind::kNone;
  Integer contact = 0;    ///< of kState
  Rational distance = 0;  ///< of kDistance
  Vector y = {};          ///< of leaves
  Vector z = {};          ///< of kLeaf Z, its upper triangle; of kCombination z
};

/// A symmetric matrix.
using Square = std::vector<Vector>;

/// The rules of bounds. The question must ask for them. All throw Rejected.
class RobustnessProof {
 public:
  RobustnessProof(const Question& question, const Rational& lower, const Rational& upper);

  /// `robust-forces`, `robust-distance`, `robust-balance`, `robust-stiffness`, `robust-lower`
  void check(const std::optional<RobustCombination>& combination) const;
  /// The next node of the list: `tree-long`, `robust-split`, `robust-leaf`
  void visit(const RobustNode& node);
  /// The list has ended: `tree-short`
  void finish();

  std::uint64_t nodes() const { return nodes_; }
  std::uint64_t leaves() const { return leaves_; }

 private:
  /// A set of states, as bits.
  using States = std::uint8_t;
  struct Row {
    Vector point;
    Vector normal;             ///< the unit normal
    Vector wrench;             ///< W(normal)
    std::vector<Vector> axes;  ///< W of all axes
    Rational friction;
    Rational stiffness;
    Rational most;    ///< f
    Rational offset;  ///< o, from below, if there is friction
  };
  /// A change that leads to a child, and how many changes are above it.
  struct Step {
    std::size_t above;
    std::string name;
    std::optional<std::size_t> contact;
    States states = 0;
    Rational low;  ///< the distances, unless a state is chosen
    Rational high;
  };
  /// Bounds of the work of a contact on a twist.
  struct Work {
    Rational along;    ///< y.W(normal)
    Rational against;  ///< h
  };

  Vector wrench(const Vector& point, const Vector& force) const;
  Work work(const Row& row, const Vector& y, bool sticks) const;
  void add_squares(Square& to, const Row& row, bool sticks, const Rational& factor) const;
  bool is_leaf(const Vector& y, const Square& z) const;
  bool is_combination(const std::vector<States>& states, const Vector& y,
                      const std::optional<Vector>& z) const;
  void enter();
  std::string path() const;
  [[noreturn]] void reject_node(const char* rule, const std::string& found) const;

  std::vector<Row> rows_;
  Vector load_;  ///< w'
  Rational length_;
  Rational lower_;
  Rational upper_;
  bool of_grasp_;
  bool equally_stiff_ = true;
  std::vector<States> states_;  ///< at the node
  Rational low_ = 0;            ///< the distances there
  Rational high_ = 0;
  std::vector<Step> open_;  ///< children to come, the next one last
  /// Changes on the way to the node, with what was there before.
  std::vector<Step> path_;
  std::uint64_t nodes_ = 0;
  std::uint64_t leaves_ = 0;
};

}  // namespace stickslip_check
