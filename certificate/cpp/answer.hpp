// SPDX-License-Identifier: MIT
/// \file
/// What the checker answers (FORMAT.md §8).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "question.hpp"

namespace stickslip_check {

/// Multiples of a direction: [low, high], or [low, oo).
struct Interval {
  Rational low;
  std::optional<Rational> high;
};

/// Values of lambda: from low to high, or from low on.
struct Range {
  Rational low;
  std::optional<Rational> high;
  bool open_low = false;   ///< low itself is not among them
  bool open_high = false;  ///< nor is high
};

/// The multiples of a margin of statics that may stand, and those that must move.
struct Standing {
  bool any = false;  ///< whether multiples from low to high may stand
  Rational low;
  Rational high;
  bool low_end = true;  ///< if not, all below do as well; likewise above
  bool high_end = true;
  std::optional<Rational> below;  ///< those below it must move
  std::optional<Rational> above;  ///< those above it must move
  bool always_moves = false;      ///< all must
};

/// The certificate proves `verdict` about the question.
struct Accepted {
  Question question;
  std::string verdict;             ///< "stable", "unstable", "margin", "region", a class, of
                                   ///< statics, "complete" or "bounds"
  std::vector<Interval> resisted;  ///< of a margin: exactly these multiples, of claims at least
  std::vector<Range> refuted;      ///< of claims: none of these
  std::uint64_t segments = 0;      ///< of a margin by segments
  std::uint64_t pieces = 0;        ///< of a region, whose union it is
  std::uint64_t stands = 0;        ///< load points of statics, whose sums may stand
  std::uint64_t moves = 0;         ///< twists of statics
  std::optional<Standing> standing = {};
  std::vector<Integer> by_dimension = {};  ///< numbers of states
  std::uint64_t listed = 0;                ///< states with a motion
  std::optional<Bounds> bounds = {};       ///< of a robustness
  std::size_t trees = 0;        ///< of a margin, one for each range without a multiple
  std::uint64_t rests = 0;      ///< proofs at rest
  std::uint64_t stickings = 0;  ///< proofs by sticking
  std::uint64_t parts = 0;      ///< proofs by degree
  std::uint64_t nodes = 0;      ///< of all trees; 0 for a witness
  std::uint64_t leaves = 0;
};

/// A rule of FORMAT.md does not hold. Also thrown inside the checker.
struct Rejected {
  std::string rule;                   ///< as FORMAT.md spells it
  std::optional<std::uint64_t> node;  ///< its number in the list, for trees
  std::string path;                   ///< from the root, such as "slip 3 +, separation 0 open";
                                      ///< or such as "segment 3, first point", "interval 0",
                                      ///< "part 0, wall 1 +, slip 3 -"
  std::string found;
};

/// Throws a Rejected that is of no tree; `place` is its path.
[[noreturn]] inline void reject(const char* rule, const std::string& place,
                                const std::string& found) {
  throw Rejected{rule, std::nullopt, place, found};
}

/// The grasp or the certificate cannot be read, or the question cannot be asked. Also thrown
/// inside the checker.
struct Malformed {
  std::string file;
  std::string place;
  std::string problem;  ///< what is wrong, and what would be right
};

/// The proof may be right, but takes more work than this checker does. Also thrown inside the
/// checker.
struct NotJudged {
  std::string why;
};

using Answer = std::variant<Accepted, Rejected, Malformed, NotJudged>;

}  // namespace stickslip_check
