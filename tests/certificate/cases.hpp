// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions of every sort, as a user asks them: a grasp file and options; and the certificates
/// of both engines about them.
#pragma once

#include <string>
#include <vector>

#include "both_checkers.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip::test {

struct Case {
  std::string name;
  std::string grasp;  ///< the text of the file
  QuestionOptions options;

  Question question() const;
};

/// The grasps of Figs. 1 and 4 with and without preload, at and beyond their thresholds, under
/// both laws; no contact; mu = 0; normals of length 5 and of irrational length;
/// random grasps of 1 to 4 contacts of all
/// families.
std::vector<Case> all_cases();

struct Certified {
  Case about;
  Engine engine;
  std::string verdict;
  std::string text;

  CheckerInput input() const { return {about.grasp, text, about.options}; }
  std::string name() const;
  /// Nodes of the tree; 0 for a witness.
  std::size_t size() const;
};

/// A certificate of tests/corpus/certificates, sorted by name. Those of margins are by hand.
struct CommittedCertificate {
  std::string name;
  CheckerInput input;
};
std::vector<CommittedCertificate> committed_certificates();
std::vector<CommittedCertificate> all_margins();

/// By kStates and kCone for each case; they must agree, or this throws.
std::vector<Certified> all_certificates();

}  // namespace stickslip::test
