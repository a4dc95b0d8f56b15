// SPDX-License-Identifier: GPL-3.0-or-later
#include "terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace stickslip {

std::string format_table(const std::vector<std::vector<std::string>>& rows, Align align) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c > 0) text += "  ";
      const std::string blanks(widths[c] - row[c].size(), ' ');
      text += align == Align::kRight ? blanks + row[c] : row[c] + blanks;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

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
  std::cerr << kClearLine + text << std::flush;  // one write, which a reader gets whole
}

void say_nothing_written(const std::string& option, const std::string& why) {
  std::cerr << "stickslip: " << option << ": nothing is written: " << why << '\n';
}

}  // namespace stickslip
