// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/time_limit.hpp"

#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {

TimeLimit::TimeLimit(Rational seconds) : seconds_(std::move(seconds)) {
  constexpr int kDay = 86400;
  require(seconds_->sign() >= 0 && *seconds_ <= kDay, "a time limit of at most a day");
  end_ = std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
             std::chrono::duration<double>(to_double(*seconds_)));
}

std::string TimeLimit::in_words() const {
  return seconds_ ? "the time limit of " + to_readable_string(*seconds_) + " s"
                  : "no time limit";
}

bool TimeLimit::finishes(const std::function<void()>& work,
                         const std::function<void()>& tick) const {
  Cancellation* const outer = Cancellation::current();
  bool is_late = false;
  const Cancellation ending([&] {
    if (tick) tick();
    try {
      if (outer != nullptr) outer->check();
    } catch (const Cancelled&) {
      return true;
    }
    return is_late = is_over();
  });
  try {
    work();
  } catch (const Cancelled&) {
    if (!is_late) throw;
    return false;
  }
  return true;
}

}  // namespace stickslip
