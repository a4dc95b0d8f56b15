// SPDX-License-Identifier: MIT
#include "work.hpp"

#include <algorithm>
#include <cmath>

#include "answer.hpp"

namespace stickslip_check {
namespace {

struct Work {
  bool is_limited = false;
  std::uint64_t bytes = 0;
  std::uint64_t steps = 0;
  std::uint64_t products = 0;
};
thread_local Work work;

/// The multiple of 10^8 (1 + (bytes / 10,000)^2).
std::uint64_t most_for(std::uint64_t bytes, std::uint64_t multiple) {
  constexpr std::uint64_t kLeast = 100'000'000;
  constexpr std::uint64_t kMostBytes = 1'000'000'000;
  const std::uint64_t counted = std::min(bytes, kMostBytes);
  return multiple * (kLeast + counted * counted);
}

/// Returns the products of words that numbers of so many words take, the longer one first: long
/// ones cost less than they have digits
/// (Karatsuba and others).
std::uint64_t products_of(std::uint64_t most, std::uint64_t least) {
  constexpr std::uint64_t kShort = 64;
  if (least <= kShort) return most * least;
  return static_cast<std::uint64_t>(std::sqrt(static_cast<double>(kShort * least)) *
                                    static_cast<double>(most));
}

void refuse_beyond(std::uint64_t count, std::uint64_t multiple, const char* what) {
  const std::uint64_t most = most_for(work.bytes, multiple);
  if (!work.is_limited || count <= most) return;
  throw NotJudged{"it takes more than " + std::to_string(most) + " " + what +
                  ", the most for the " + std::to_string(work.bytes) + " bytes read"};
}

}  // namespace

LimitedWork::LimitedWork() {
  work = {};
  work.is_limited = true;
}

LimitedWork::~LimitedWork() {
  work = {};
}

void note_byte() {
  ++work.bytes;
}

void spend(std::uint64_t steps) {
  constexpr std::uint64_t kMultiple = 4;
  work.steps += steps;
  refuse_beyond(work.steps, kMultiple, "steps");
}

void spend(std::uint64_t operations, std::uint64_t words, std::uint64_t by_words) {
  spend(operations);
  if (words == 1 && by_words == 1) return;
  constexpr std::uint64_t kMultiple = 5;
  work.products +=
      operations * products_of(std::max(words, by_words), std::min(words, by_words));
  refuse_beyond(work.products, kMultiple, "products of words");
}

std::uint64_t words(const Form& x) {
  std::size_t most = 1;
  for (const Integer& c : x) most = std::max(most, mpz_size(c.get_mpz_t()));
  return most;
}

}  // namespace stickslip_check
