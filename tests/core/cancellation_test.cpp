// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/cancellation.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "stickslip/core/time_limit.hpp"

namespace stickslip {
namespace {

TEST(Cancellation, NothingHappensWithoutOne) {
  EXPECT_EQ(Cancellation::current(), nullptr);
  EXPECT_NO_THROW(throw_if_cancelled());
}

TEST(Cancellation, WorkGoesOnUntilItIsNotWanted) {
  int asked = 0;
  const Cancellation cancellation([&] { return ++asked == 3; });
  EXPECT_NO_THROW(throw_if_cancelled());  // asks
  EXPECT_NO_THROW(throw_if_cancelled());  // too soon to ask again
  const auto work = [] {
    for (;;) throw_if_cancelled();
  };
  EXPECT_THROW(work(), Cancelled);
  EXPECT_EQ(asked, 3);
  EXPECT_THROW(throw_if_cancelled(), Cancelled);  // it stays so, unasked
  EXPECT_EQ(asked, 3);
}

TEST(Cancellation, TheInnermostCounts) {
  const Cancellation outer([] { return true; });
  {
    const Cancellation inner([] { return false; });
    EXPECT_NO_THROW(throw_if_cancelled());
  }
  EXPECT_THROW(throw_if_cancelled(), Cancelled);
}

TEST(Cancellation, OtherThreadsShareItAndDoNotAsk) {
  bool wanted = false;
  const std::thread::id asker = std::this_thread::get_id();
  Cancellation cancellation([&] {
    EXPECT_EQ(std::this_thread::get_id(), asker);
    return wanted;
  });
  const auto is_cancelled_there = [&](Cancellation* shared) {
    bool cancelled = false;
    std::thread other([&] {
      EXPECT_NO_THROW(throw_if_cancelled());
      const SharedCancellation scope(shared);
      try {
        throw_if_cancelled();
      } catch (const Cancelled&) {
        cancelled = true;
      }
    });
    other.join();
    return cancelled;
  };
  wanted = true;
  EXPECT_FALSE(is_cancelled_there(Cancellation::current()));  // nobody has asked yet
  EXPECT_THROW(throw_if_cancelled(), Cancelled);
  EXPECT_TRUE(is_cancelled_there(Cancellation::current()));
  EXPECT_FALSE(is_cancelled_there(nullptr));
}

TEST(TimeLimit, WorkInTimeIsDone) {
  int done = 0;
  EXPECT_TRUE(TimeLimit().finishes([&] { ++done; }));
  EXPECT_TRUE(TimeLimit(1000).finishes([&] {
    throw_if_cancelled();
    ++done;
  }));
  EXPECT_EQ(done, 2);
  EXPECT_EQ(Cancellation::current(), nullptr);
}

TEST(TimeLimit, WorkEndsWhenItIsOver) {
  const TimeLimit none_left(0);
  EXPECT_TRUE(none_left.is_over());
  int known = 0;
  EXPECT_FALSE(none_left.finishes([&] {
    for (;; ++known) throw_if_cancelled();
  }));
  EXPECT_EQ(known, 0);
  EXPECT_FALSE(TimeLimit(Rational(1, 100)).finishes([] {
    for (;;) throw_if_cancelled();
  }));
}

TEST(TimeLimit, TicksOnItsOwnThread) {
  int ticks = 0;
  EXPECT_TRUE(TimeLimit().finishes([] { throw_if_cancelled(); }, [&] { ++ticks; }));
  EXPECT_EQ(ticks, 1);
}

TEST(TimeLimit, WhoAskedBeforeEndsItAsWell) {
  const Cancellation outer([] { return true; });
  bool reached = false;
  EXPECT_THROW(TimeLimit(1000).finishes([&] {
    throw_if_cancelled();
    reached = true;
  }),
               Cancelled);
  EXPECT_FALSE(reached);
}

}  // namespace
}  // namespace stickslip
