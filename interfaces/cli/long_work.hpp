// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Long work of commands: its progress on a terminal, and the option --time-limit.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "command_line.hpp"
#include "stickslip/core/json_value.hpp"
#include "stickslip/core/time_limit.hpp"
#include "terminal.hpp"

namespace stickslip {

/// Adds --time-limit with these words, or with those that suit a command that answers what it
/// knows when the time is over.
void add_time_limit_option(Command& command, std::string& seconds,
                           const std::string& description = "");
/// Returns the limit from now on; none for "0" and for nothing. Throws InputError unless
/// `seconds` is a number up to a day.
TimeLimit time_limit_option(const std::string& seconds);
/// Returns the same in milliseconds, rounded up, of a limit that holds for each part of a page.
std::chrono::milliseconds milliseconds_option(const std::string& seconds);

/// The work of a command, or a part of it that is done at one go. While it lasts, a terminal
/// shows what is done, what is known so far, and for how long the work has gone on.
class LongWork {
 public:
  /// `what` says what is done: "deciding".
  explicit LongWork(std::string what, TimeLimit limit = {});

  /// Does the work. Returns false if the time limit ended it.
  bool finishes(const std::function<void()>& work);
  /// Says how far it is and what is known so far.
  void say(const std::string& known);
  /// Ends the display, whose next text may be about other work.
  void clear() { progress_.clear(); }

  const TimeLimit& limit() const { return limit_; }
  /// Returns a line that says that the limit ended the work, or nothing if it did not.
  std::string ending() const;
  /// Adds "ended_by" to the answer if the limit ended the work.
  void add_ending(Json& json) const;

 private:
  void show();

  std::string what_;
  TimeLimit limit_;
  std::string known_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Progress progress_;
  bool is_ended_ = false;
};

}  // namespace stickslip
