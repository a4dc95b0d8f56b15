// SPDX-License-Identifier: GPL-3.0-or-later
#include "measures/extent/in_parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "stickslip/core/cancellation.hpp"

namespace stickslip {
namespace {

TEST(InParallel, AllAreCalledOnce) {
  for (const bool may_be_asked : {false, true}) {
    std::optional<Cancellation> cancellation;
    if (may_be_asked) cancellation.emplace([] { return false; });
    std::vector<std::atomic<int>> called(1000);
    extent_detail::in_parallel(called.size(), [&](std::size_t k) { ++called[k]; });
    for (const std::atomic<int>& once : called) EXPECT_EQ(once, 1);
    EXPECT_THROW(extent_detail::in_parallel(
                     9, [](std::size_t k) { k == 7 ? throw std::out_of_range("7") : void(); }),
                 std::out_of_range);
  }
}

// One of them goes on until it is broken off, and all others are done: whoever is asked, is
// asked on the thread that waits.
TEST(InParallel, ALongOneIsBrokenOff) {
  const std::thread::id here = std::this_thread::get_id();
  std::atomic<bool> has_begun{false};
  const Cancellation cancellation([&] {
    EXPECT_EQ(std::this_thread::get_id(), here);
    return has_begun.load();
  });
  EXPECT_THROW(extent_detail::in_parallel(3,
                                          [&](std::size_t k) {
                                            has_begun = true;
                                            while (k == 1) throw_if_cancelled();
                                          }),
               Cancelled);
}

}  // namespace
}  // namespace stickslip
