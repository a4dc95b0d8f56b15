// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Processor time and memory of a piece of work.
#pragma once

#include <cstddef>
#include <functional>

namespace stickslip::bench {

/// Processor time of this process per call: the best of `rounds` rounds, each of as many calls
/// as take `least_seconds` together, one at least.
double seconds_per_call(const std::function<void()>& work, int rounds, double least_seconds);

struct ChildMeasurement {
  double seconds = 0;          ///< processor time, best of the rounds
  double wall_seconds = 0;     ///< elapsed time, best of the rounds
  std::size_t peak_bytes = 0;  ///< how far resident memory rose above what it was before
  std::size_t result = 0;      ///< what the work returned
};

/// Runs work() `rounds` times in a process of its own. Throws std::runtime_error if that
/// process fails. Linux only: the peak is VmHWM of /proc/self/status.
ChildMeasurement measure_in_child(const std::function<std::size_t()>& work, int rounds);

}  // namespace stickslip::bench
