// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Processor time and memory of a piece of work.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace stickslip::bench {

/// Processor time of this process per call: the best of `rounds` rounds, each of as many calls
/// as take `least_seconds` together, one at least.
double seconds_per_call(const std::function<void()>& work, int rounds, double least_seconds);

double median(std::vector<double> values);

struct Measurement {
  double seconds = 0;          ///< processor time, best of the rounds
  std::size_t peak_bytes = 0;  ///< how far resident memory rose above what it was before
  std::size_t cells = 0;       ///< what the work returned
};

/// Runs work() `rounds` times in a process of its own. Throws std::runtime_error if that
/// process fails. Linux only: the peak is VmHWM of /proc/self/status.
Measurement measure_in_child(const std::function<std::size_t()>& work, int rounds);

}  // namespace stickslip::bench
