// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <unistd.h>

#include <iostream>

namespace stickslip {

Progress::Progress()
    : on_terminal_(isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now() + std::chrono::seconds(1)) {}

void Progress::clear() {
  if (shown_) std::cerr << kClearLine << std::flush;
  shown_ = false;
}

void Progress::show(const std::string& text) {
  if (!on_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(200);
  shown_ = true;
  std::cerr << kClearLine << text << std::flush;
}

}  // namespace stickslip
