// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The results of a batch that is to go on after an interruption.
#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <vector>

namespace stickslip {

/// Those that stand in whole lines; what an interruption left unfinished behind them does not
/// count.
struct FinishedResults {
  std::vector<std::string> keys;  ///< of the questions, one a line
  std::uintmax_t bytes = 0;       ///< of the lines
};

/// Throws InputError naming `file` and the line that is not a result of a batch.
FinishedResults read_results(std::istream& in, const std::string& file);

}  // namespace stickslip
