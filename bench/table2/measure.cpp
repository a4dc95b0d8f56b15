// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace stickslip::bench {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A line of /proc/self/status, which gives KiB.
std::size_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key + ":", 0) == 0) return 1024 * std::stoul(line.substr(key.size() + 1));
  }
  throw std::runtime_error("/proc/self/status has no " + key);
}

Measurement measure_here(const std::function<std::size_t()>& work, int rounds) {
  const std::size_t before = status_bytes("VmRSS");
  Measurement result;
  result.seconds = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double start = cpu_seconds();
    result.cells = work();
    result.seconds = std::min(result.seconds, cpu_seconds() - start);
  }
  const std::size_t peak = status_bytes("VmHWM");
  result.peak_bytes = peak > before ? peak - before : 0;
  return result;
}

}  // namespace

double seconds_per_call(const std::function<void()>& work, int rounds, double least_seconds) {
  double best = 1e300;
  std::size_t calls = 1;
  for (int round = 0; round < rounds;) {
    const double start = cpu_seconds();
    for (std::size_t i = 0; i < calls; ++i) work();
    const double elapsed = cpu_seconds() - start;
    if (elapsed < least_seconds) {
      calls *= 2;
      continue;
    }
    best = std::min(best, elapsed / static_cast<double>(calls));
    ++round;
  }
  return best;
}

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("median: no values");
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

Measurement measure_in_child(const std::function<std::size_t()>& work, int rounds) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    close(ends[0]);
    int status = 1;
    try {
      const Measurement result = measure_here(work, rounds);
      if (write(ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result)) {
        status = 0;
      }
    } catch (const std::exception& error) {
      std::fprintf(stderr, "table2: %s\n", error.what());
    }
    _exit(status);
  }
  close(ends[1]);
  Measurement result;
  const bool is_read =
      read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!is_read || status != 0) throw std::runtime_error("a measurement failed");
  return result;
}

}  // namespace stickslip::bench
