// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Limits on the time that work may take. At its limit work is broken off (cancellation.hpp),
/// and whoever asked for it answers what is known by then.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "stickslip/core/number.hpp"

namespace stickslip {

/// A time by which work is to end, or none.
class TimeLimit {
 public:
  TimeLimit() = default;  ///< takes no limit
  /// Takes a limit of so many seconds from now on, at least 0 and at most a day.
  explicit TimeLimit(Rational seconds);

  /// The seconds that were given; nothing if there is no limit.
  const std::optional<Rational>& seconds() const { return seconds_; }
  /// Returns whether the time is over.
  bool is_over() const { return seconds_ && std::chrono::steady_clock::now() >= end_; }
  /// Returns "the time limit of 5 s".
  std::string in_words() const;

  /// Does the work. Returns false if the time was over first: the work has then ended by
  /// Cancelled. Calls `tick` on this thread meanwhile, up to 20 times a second, wherever work
  /// calls throw_if_cancelled(). Throws Cancelled if a Cancellation that was in force already
  /// ends the work.
  bool finishes(const std::function<void()>& work,
                const std::function<void()>& tick = {}) const;

 private:
  std::optional<Rational> seconds_;
  std::chrono::steady_clock::time_point end_{};
};

}  // namespace stickslip
