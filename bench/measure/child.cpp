// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.hpp"

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

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
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

ChildMeasurement measure_here(const std::function<std::size_t()>& work, int rounds) {
  const std::size_t before = status_bytes("VmRSS");
  ChildMeasurement result;
  result.seconds = result.wall_seconds = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double start = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    const double wall_start = seconds_of(CLOCK_MONOTONIC);
    result.result = work();
    result.seconds = std::min(result.seconds, seconds_of(CLOCK_PROCESS_CPUTIME_ID) - start);
    result.wall_seconds =
        std::min(result.wall_seconds, seconds_of(CLOCK_MONOTONIC) - wall_start);
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
    const double start = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    for (std::size_t i = 0; i < calls; ++i) work();
    const double elapsed = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - start;
    if (elapsed < least_seconds) {
      calls *= 2;
      continue;
    }
    best = std::min(best, elapsed / static_cast<double>(calls));
    ++round;
  }
  return best;
}

ChildMeasurement measure_in_child(const std::function<std::size_t()>& work, int rounds) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    close(ends[0]);
    int status = 1;
    try {
      const ChildMeasurement result = measure_here(work, rounds);
      if (write(ends[1], &result, sizeof result) == static_cast<ssize_t>(sizeof result)) {
        status = 0;
      }
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(status);
  }
  close(ends[1]);
  ChildMeasurement result;
  const bool is_read =
      read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!is_read || status != 0) throw std::runtime_error("a measurement failed");
  return result;
}

}  // namespace stickslip::bench
