// SPDX-License-Identifier: MIT
#include "work.hpp"

#include <algorithm>

#include "answer.hpp"

namespace stickslip_check {
namespace {

struct Work {
  bool is_limited = false;
  std::uint64_t bytes = 0;
  std::uint64_t steps = 0;
};
thread_local Work work;

/// 4 * 10^8 (1 + (bytes / 10,000)^2)
std::uint64_t most_steps(std::uint64_t bytes) {
  constexpr std::uint64_t kLeast = 400'000'000;
  constexpr std::uint64_t kPerSquareByte = 4;
  constexpr std::uint64_t kMostBytes = 1'000'000'000;
  const std::uint64_t counted = std::min(bytes, kMostBytes);
  return kLeast + kPerSquareByte * counted * counted;
}

}  // namespace

LimitedWork::LimitedWork() {
  work = {true, 0, 0};
}

LimitedWork::~LimitedWork() {
  work = {};
}

void note_byte() {
  ++work.bytes;
}

void spend(std::uint64_t steps) {
  work.steps += steps;
  if (!work.is_limited || work.steps <= most_steps(work.bytes)) return;
  throw NotJudged{"it takes more than " + std::to_string(most_steps(work.bytes)) +
                  " steps, the most for the " + std::to_string(work.bytes) + " bytes read"};
}

std::uint64_t words(const Form& x) {
  std::size_t most = 1;
  for (const Integer& c : x) most = std::max(most, mpz_size(c.get_mpz_t()));
  return most;
}

}  // namespace stickslip_check
