// SPDX-License-Identifier: MIT
/// \file
/// The question (FORMAT.md §1): what the grasp file says, what whoever asks replaces, and the
/// rows that follow from it. The certificate plays no part here except that it may name
/// replacements for normals, which are checked (`question-normals`).
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

/// What whoever asks may choose. Unset members leave the grasp file's own values.
struct QuestionOptions {
  std::optional<Vector3> wrench;
  /// Asks for the margin along it; not 0. The wrench is then 0 unless given above.
  std::optional<Vector3> direction;
  std::optional<Rational> preload;         ///< for all contacts, >= 0
  bool bilateral = false;                  ///< the normal law
  std::optional<Rational> snap_tolerance;  ///< allows snapped normals; 0 < tolerance < 1
};

/// A contact as the grasp file gives it.
struct GraspContact {
  Vector2 position;
  Vector2 normal;
  Rational friction;
  Rational stiffness;
  Rational preload;
};

/// The grasp file with the options applied.
struct Question {
  std::vector<GraspContact> contacts;
  Vector3 wrench;
  std::optional<Vector3> direction;  ///< if the margin is asked for (FORMAT.md §10)
  std::optional<Rational> preload;   ///< if it replaced the file's
  bool bilateral = false;
  std::optional<Rational> snap_tolerance;
};

/// The rows of a contact (FORMAT.md §1, "Rows").
struct Row {
  Vector3 normal;      ///< N
  Vector3 tangent;     ///< T
  Rational friction;   ///< mu
  Rational preload;    ///< P' = P/L
  Rational stiffness;  ///< k' = k/L^2
};

/// Reads a grasp file ("stickslip-grasp/1") and applies the options. Throws Malformed with
/// `file`, or with "the question" for options that cannot be asked.
Question read_question(std::istream& in, const std::string& file,
                       const QuestionOptions& options);

/// FORMAT.md `question-normals`, for one entry: whether u may stand for the normal of
/// `contact`. If not, says why.
std::optional<std::string> snap_refusal(const GraspContact& contact, const Vector2& u,
                                        const Rational& tolerance);

/// An upper bound of |u - n/|n||^2 for a u that snap_refusal lets pass.
Rational snap_distance_squared(const GraspContact& contact, const Vector2& u);

/// The row of a contact, or nothing if it has a preload and a normal of irrational length.
std::optional<Row> make_row(const GraspContact& contact);

}  // namespace stickslip_check
