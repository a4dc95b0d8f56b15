// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The output of `stickslip crosscheck` about each line and about all of them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip {

/// A line that was read, and its judgement.
struct JudgedLine {
  std::size_t number;
  ClaimLine line;
  ClaimReport report;
  std::vector<std::string> saved;  ///< the files saved
};

struct ClaimCounts {
  std::array<std::size_t, 4> judged{};  ///< by ClaimClass
  std::size_t inaccurate = 0;           ///< the inaccurate ones among the right ones
  std::size_t unreadable = 0;

  void add(const ClaimReport& report);
  std::size_t of(ClaimClass c) const { return judged[static_cast<std::size_t>(c)]; }
  std::size_t claims() const;
  int exit_code() const;
};

/// Returns one JSON object, without the newline.
std::string to_json_line(const JudgedLine& judged, bool floats);
std::string to_json_line(std::size_t number, const InputError& error);
std::string to_json_line(const ClaimCounts& counts);

/// Returns text for people, ending in a newline; empty for a right claim without a remark.
std::string to_text(const JudgedLine& judged, const ClaimOptions& options, NumberText& number);
std::string to_text(std::size_t number, const InputError& error);
std::string to_text(const ClaimCounts& counts);

}  // namespace stickslip
