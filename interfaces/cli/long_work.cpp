// SPDX-License-Identifier: GPL-3.0-or-later
#include "long_work.hpp"

#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/option_text.hpp"

namespace stickslip {

void add_time_limit_option(Command& command, std::string& seconds,
                           const std::string& description) {
  command
      .add_option("--time-limit", seconds,
                  description.empty() ? "Answer after so many seconds what is known and proved "
                                        "by then; 0 is no limit"
                                      : description)
      ->type_name("SECONDS")
      ->capture_default_str();
}

TimeLimit time_limit_option(const std::string& seconds) {
  if (seconds.empty()) return {};
  const Rational given = rational_at("--time-limit", seconds);
  constexpr int kDay = 86400;
  if (given.sign() < 0 || given > kDay) {
    throw InputError("", "--time-limit", "the value is " + seconds,
                     "give seconds, from 0, which is no limit, to 86400, as in 0.5");
  }
  return given.is_zero() ? TimeLimit() : TimeLimit(given);
}

std::chrono::milliseconds milliseconds_option(const std::string& seconds) {
  const TimeLimit limit = time_limit_option(seconds);
  if (!limit.seconds()) return {};
  return std::chrono::milliseconds(
      static_cast<std::int64_t>(std::ceil(1000 * to_double(*limit.seconds()))));
}

LongWork::LongWork(std::string what, TimeLimit limit)
    : what_(std::move(what)), limit_(std::move(limit)) {}

bool LongWork::finishes(const std::function<void()>& work) {
  bool is_done = true;
  if (limit_.seconds() || progress_.is_shown_somewhere()) {
    is_done = limit_.finishes(work, [&] { show(); });
  } else {
    work();
  }
  progress_.clear();
  is_ended_ = is_ended_ || !is_done;
  return is_done;
}

void LongWork::say(const std::string& known) {
  known_ = known;
  show();
}

std::string LongWork::ending() const {
  return is_ended_
             ? "Ended by " + limit_.in_words() + ": a longer one, or none, may tell more.\n"
             : "";
}

void LongWork::add_ending(Json& json) const {
  if (is_ended_) json["ended_by"] = limit_.in_words();
}

void LongWork::show() {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
      std::chrono::steady_clock::now() - begin_);
  progress_.show(
      what_ + (known_.empty() ? "" : ": " + known_) + ", " + std::to_string(seconds.count()) +
      (limit_.seconds() ? " of " + to_readable_string(*limit_.seconds()) : "") + " s");
}

}  // namespace stickslip
