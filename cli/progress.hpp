// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One line that says how far long work has come, for people who watch.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace stickslip {

/// Writes to standard error if that is a terminal, else nothing: first after a second, then a
/// few times a second, over its own line. The destructor clears it.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done, std::size_t all);

 private:
  std::string what_;
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace stickslip
