// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// One instance decided as `stickslip decide` does, its certificate written and checked.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "loads.hpp"

namespace stickslip::bench {

struct Measurement {
  std::string verdict;
  double read_ms = 0;         ///< reading the grasp from its file's text
  double decide_ms = 0;       ///< from the question to the verdict, on one core
  double certificate_ms = 0;  ///< writing the certificate into memory
  double file_ms = 0;         ///< writing that into a file
  double check_ms = 0;        ///< the C++ checker, reading both texts
  double certificate_bytes = 0;
  bool is_accepted = false;      ///< by the checker
  bool is_reproducible = false;  ///< two runs gave the same counters and the same certificate
  std::vector<std::pair<std::string, double>> counters;  ///< of what decided, by name

  double total_ms() const { return decide_ms + certificate_ms; }
  /// What has to be done to have a certificate from a grasp file; the checker reads it too.
  double from_file_ms() const { return read_ms + total_ms(); }
  double counter(const std::string& name) const;  ///< 0 if there is none of the name
};

/// Short runs are repeated for at most about `patience_ms` and the fastest counts.
Measurement measure(const Question& question, double patience_ms);

/// `make` and measure in a process of its own; nothing beyond the limit.
std::optional<Measurement> measure_limited(double seconds, double patience_ms,
                                           const std::function<Instance()>& make);

/// Decides by branch and bound.
bool is_stable_by_cones(const Question& question);

}  // namespace stickslip::bench
