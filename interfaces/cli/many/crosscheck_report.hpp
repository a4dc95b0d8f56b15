// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What `stickslip crosscheck` prints of each line and of all of them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/interfaces/claim.hpp"

namespace stickslip {

/// A line that was read.
struct JudgedLine {
  std::size_t number;
  ClaimLine line;
  ClaimReport report;
  std::vector<std::string> saved;  ///< files
};

struct ClaimCounts {
  std::array<std::size_t, 4> judged{};  ///< by ClaimClass
  std::size_t inaccurate = 0;           ///< of the right ones
  std::size_t unreadable = 0;

  void add(const ClaimReport& report);
  std::size_t of(ClaimClass c) const { return judged[static_cast<std::size_t>(c)]; }
  std::size_t claims() const;
  int exit_code() const;
};

/// One JSON object, without the newline.
std::string to_json_line(const JudgedLine& judged, bool floats);
std::string to_json_line(std::size_t number, const InputError& error);
std::string to_json_line(const ClaimCounts& counts);

/// For people, ending in a newline; empty for a right claim about which there is nothing to
/// say.
std::string to_text(const JudgedLine& judged, const ClaimOptions& options, NumberText& number);
std::string to_text(std::size_t number, const InputError& error);
std::string to_text(const ClaimCounts& counts);

}  // namespace stickslip
