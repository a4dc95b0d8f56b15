// SPDX-License-Identifier: MIT
/// \file
/// The member `question` of a certificate, and whether it is the question that was asked
/// (FORMAT.md §3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "question.hpp"
#include "syntax.hpp"

namespace stickslip_check {

/// A replaced normal.
struct NewNormal {
  Integer contact;
  Vector2 u;
};

struct Claim {
  Integer contacts;
  Vector3 wrench;
  std::optional<Rational> preload;
  bool bilateral = false;
  std::optional<std::vector<NewNormal>> normals;
};

/// Throws Malformed.
Claim read_claim(const Syntax& syntax, const Value& value);

/// The rules `question-...` of §3. Throws Rejected; else puts the replaced normals into the
/// question and returns an upper bound of the largest |u - n/|n||^2.
Rational check_claim(const Claim& claim, Question& question);

/// Throws Rejected by a rule about what was asked.
[[noreturn]] void reject_question(const char* rule, const std::string& stated,
                                  const std::string& asked);

/// "unilateral" or "bilateral".
std::string law_name(bool bilateral);

}  // namespace stickslip_check
