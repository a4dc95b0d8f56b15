// SPDX-License-Identifier: GPL-3.0-or-later
#include "limited.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace stickslip::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs `in_child` with the writing end of a pipe; returns what came out of it.
template <class InChild>
ProgramRun collect(double seconds, InChild in_child) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  const Clock::time_point start = Clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    close(ends[0]);
    in_child(ends[1]);
    _exit(1);
  }
  close(ends[1]);
  ProgramRun run;
  run.output.emplace();
  char buffer[4096];
  while (true) {
    const double left = seconds - seconds_since(start);
    pollfd ready{ends[0], POLLIN, 0};
    const int events = left > 0 ? poll(&ready, 1, static_cast<int>(left * 1000) + 1) : 0;
    if (events < 0 && errno == EINTR) continue;
    if (events <= 0) {
      run.output.reset();
      break;
    }
    const ssize_t count = read(ends[0], buffer, sizeof buffer);
    if (count <= 0) break;
    run.output->append(buffer, static_cast<std::size_t>(count));
  }
  run.seconds = seconds_since(start);
  close(ends[0]);
  if (!run.output) kill(child, SIGKILL);
  rusage usage{};
  wait4(child, &run.status, 0, &usage);
  run.peak_bytes = 1024 * static_cast<std::size_t>(usage.ru_maxrss);
  return run;
}

/// Ends every answer, so that one cut short is not taken for whole.
constexpr char kEnd = '\n';

}  // namespace

std::optional<std::string> run_limited(double seconds,
                                       const std::function<std::string()>& work) {
  const ProgramRun run = collect(seconds, [&](int out) {
    int failed = 1;
    try {
      const std::string text = work() + kEnd;
      std::size_t written = 0;
      while (written < text.size()) {
        const ssize_t count = write(out, text.data() + written, text.size() - written);
        if (count <= 0) _exit(1);
        written += static_cast<std::size_t>(count);
      }
      failed = 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(failed);
  });
  if (!run.output || run.output->empty() || run.output->back() != kEnd) return std::nullopt;
  return run.output->substr(0, run.output->size() - 1);
}

ProgramRun run_program(double seconds, const std::vector<std::string>& argv) {
  std::vector<char*> pointers;
  for (const std::string& argument : argv) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  return collect(seconds, [&](int out) {
    dup2(out, STDOUT_FILENO);
    close(out);
    execvp(pointers[0], pointers.data());
    _exit(127);
  });
}

}  // namespace stickslip::bench
