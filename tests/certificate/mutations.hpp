// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Certificates made wrong, or spelled otherwise, one mutation at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "random_grasps.hpp"

namespace stickslip::test {

/// What follows from how a mutant was made.
struct Expectation {
  enum class Sort {
    kAccepted,   ///< the meaning is the same
    kRule,       ///< this rule fails first, at this node if it is given
    kRejected,   ///< no rule in particular
    kMalformed,  ///< by syntax
    kNothing,    ///< it may have become another proof of the same: for the third opinion
  };
  Sort sort = Sort::kNothing;
  std::string rule;
  std::optional<std::uint64_t> node;

  static Expectation accepted() { return {Sort::kAccepted, "", {}}; }
  static Expectation of_rule(std::string rule, std::optional<std::uint64_t> node = {}) {
    return {Sort::kRule, std::move(rule), node};
  }
  static Expectation rejected() { return {Sort::kRejected, "", {}}; }
  static Expectation malformed() { return {Sort::kMalformed, "", {}}; }
};

struct Mutant {
  std::string kind;
  std::string of;  ///< the name of the certificate
  CheckerInput input;
  Expectation expected;
};

using Mutants = std::vector<Mutant>;

/// Each adds several mutants of one certificate, what it can of its kinds.
void mutate_tree(RandomSource& random, const Certified& original, Mutants& mutants);
void mutate_witness(RandomSource& random, const Certified& original, Mutants& mutants);
void mutate_question(RandomSource& random, const Certified& original, Mutants& mutants);
void mutate_grasp(RandomSource& random, const Certified& original, Mutants& mutants);
void mutate_syntax(RandomSource& random, const Certified& original, Mutants& mutants);
void mutate_bytes(RandomSource& random, const Certified& original, Mutants& mutants);

/// Of all_margins: of each what suits it.
void mutate_margins(RandomSource& random, Mutants& mutants);

/// The certificate of one about the grasp and question of another.
void swap_grasps(const Certified& one, const Certified& other, Mutants& mutants);

}  // namespace stickslip::test
