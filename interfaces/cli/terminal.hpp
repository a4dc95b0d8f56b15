// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What people read on a terminal: small tables, and how far long work has come.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace stickslip {

/// Numbers go to the right, words to the left.
enum class Align { kLeft, kRight };

/// Lines of aligned columns, two blanks apart; the first row is the heading.
std::string format_table(const std::vector<std::vector<std::string>>& rows,
                         Align align = Align::kRight);

/// What takes a terminal's cursor to the start of its line and clears it.
inline constexpr const char* kClearLine = "\r\033[K";

/// Writes to standard error if that is a terminal, else nothing: first after a second, then a
/// few times a second, over its own line. The destructor clears it.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const std::string& text);
  void clear();

 private:
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace stickslip
