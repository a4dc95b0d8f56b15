// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Output for people on a terminal: small tables, and the progress of long work.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace stickslip {

/// The alignment of columns: numbers go to the right, words to the left.
enum class Align { kLeft, kRight };

/// Returns lines of aligned columns, two blanks apart; the first row is the heading.
std::string format_table(const std::vector<std::vector<std::string>>& rows,
                         Align align = Align::kRight);

/// The codes that take a terminal's cursor to the start of its line and clear the line.
inline constexpr const char* kClearLine = "\r\033[K";

/// Shows progress on standard error if that is a terminal, else nothing: first after a second,
/// then a few times a second, over its own line. The destructor clears it.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Returns whether there is a terminal to show it on.
  bool is_shown_somewhere() const { return on_terminal_; }
  void show(const std::string& text);
  void clear();

 private:
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

/// Says on standard error that an option which names a file or folder wrote nothing, and why.
void say_nothing_written(const std::string& option, const std::string& why);

}  // namespace stickslip
