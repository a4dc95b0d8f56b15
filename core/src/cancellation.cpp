// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/cancellation.hpp"

#include <utility>

namespace stickslip {
namespace {

thread_local Cancellation* in_force = nullptr;

}  // namespace

Cancellation::Cancellation(std::function<bool()> wanted)
    : wanted_(std::move(wanted)), outer_(std::exchange(in_force, this)) {}

Cancellation::~Cancellation() {
  in_force = outer_;
}

Cancellation* Cancellation::current() {
  return in_force;
}

void Cancellation::check() {
  if (!cancelled_ && std::this_thread::get_id() == asker_) {
    constexpr std::chrono::milliseconds kPause{50};
    const auto now = std::chrono::steady_clock::now();
    if (now >= next_) {
      cancelled_ = wanted_();
      next_ = now + kPause;
    }
  }
  if (cancelled_) throw Cancelled();
}

SharedCancellation::SharedCancellation(Cancellation* shared)
    : outer_(std::exchange(in_force, shared)) {}

SharedCancellation::~SharedCancellation() {
  in_force = outer_;
}

void throw_if_cancelled() {
  if (in_force != nullptr) in_force->check();
}

}  // namespace stickslip
