// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Work in a process of its own, ended at a deadline: so that a program or a measurement that
/// does not end costs its limit and no more, and no measurement inherits another's heap.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::bench {

/// What `work` returns, or nothing if it took longer, threw, or died.
std::optional<std::string> run_limited(double seconds,
                                       const std::function<std::string()>& work);

struct ProgramRun {
  std::optional<std::string> output;  ///< standard output; nothing beyond the limit
  double seconds = 0;
  int status = 0;              ///< as waitpid gives it
  std::size_t peak_bytes = 0;  ///< resident memory
};

/// Runs argv[0], found in PATH. A program that cannot be started has empty output.
ProgramRun run_program(double seconds, const std::vector<std::string>& argv);

}  // namespace stickslip::bench
