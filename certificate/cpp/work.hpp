// SPDX-License-Identifier: MIT
/// \file
/// The work of one question, in steps of about 10 ns and in products of words, and its limits
/// (FORMAT.md §8, "not judged"): a short file can ask for more than any machine has. Both are
/// counted, not timed, so an answer does not depend on the machine. All of it is the thread's
/// own.
#pragma once

#include <cstdint>

#include "number.hpp"

namespace stickslip_check {

/// While one exists, the work of this thread is that of one question, and is limited.
class LimitedWork {
 public:
  LimitedWork();
  LimitedWork(const LimitedWork&) = delete;
  LimitedWork& operator=(const LimitedWork&) = delete;
  ~LimitedWork();
};

/// Another byte of either file has been read: the limit grows with the square of their number.
void note_byte();
/// Throws NotJudged beyond the limit, if there is one.
void spend(std::uint64_t steps);
/// So many operations with numbers, or vectors, of so many words: each is a step, and if one of
/// them is long, its products of words count too, with the limit that all checkers have.
void spend(std::uint64_t operations, std::uint64_t words, std::uint64_t by_words);

/// Of a product or a sum of two short rationals.
inline constexpr std::uint64_t kStepsOfRational = 20;

/// The words of its longest coordinate, 1 or more: products cost those of one factor times
/// those of the other.
std::uint64_t words(const Form& x);

}  // namespace stickslip_check
