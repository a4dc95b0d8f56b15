// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds and memory of the sweep: counts, all cells visited with their signs, the structure;
// and the ratio to the CGAL enumerator. Exact signs by the stage that decided them.
//
//     sweep_bench [rounds, default 3]
//
// Each measurement runs in a process of its own: best wall-clock time of the rounds, and how
// far the peak of its resident memory lies above that of a process that does nothing. Making
// the planes is not timed. One thread, unless the row says otherwise.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "stickslip/arrangement/arrangement_structure.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip::bench {
namespace {

using Planes = std::vector<Vector3>;

Planes random_planes(std::size_t m, const std::function<Rational(std::mt19937&)>& entry) {
  std::mt19937 random(1);
  Planes planes(m);
  for (Vector3& n : planes) {
    for (Rational& x : n) x = entry(random);
  }
  return planes;
}

int between(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

Planes integer_planes(std::size_t m) {
  return random_planes(m, [](std::mt19937& r) { return between(r, -1000000, 1000000); });
}

/// Doubles as rationals.
Planes double_planes(std::size_t m) {
  return random_planes(m, [](std::mt19937& r) {
    return rational_from_double(between(r, -1000000000, 1000000000) / 999999937.0);
  });
}

/// Full of concurrent circles: contacts at integer points of a square, axis-aligned normals
/// and diagonal ones.
Planes grid_planes(std::size_t m) {
  std::mt19937 random(1);
  Planes planes;
  while (planes.size() < m) {
    const int x = between(random, -1, 1);
    const int y = between(random, -1, 1);
    if (x == 0 && y == 0) continue;
    planes.push_back({x, y, between(random, -500, 500)});
  }
  return planes;
}

struct Measurement {
  double seconds = 0;
  double megabytes = 0;
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Runs `work` in a child process.
Measurement measure_raw(int rounds, const std::function<void()>& work) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) std::abort();
  if (child == 0) {
    double best = 1e300;
    for (int round = 0; round < rounds; ++round) {
      const double start = now();
      work();
      best = std::min(best, now() - start);
    }
    const bool is_written = write(ends[1], &best, sizeof best) == sizeof best;
    _exit(is_written ? 0 : 1);
  }
  Measurement result;
  if (read(ends[0], &result.seconds, sizeof result.seconds) != sizeof result.seconds) {
    std::abort();
  }
  rusage usage{};
  int status = 0;
  if (wait4(child, &status, 0, &usage) != child || status != 0) std::abort();
  close(ends[0]);
  close(ends[1]);
  result.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  return result;
}

Measurement measure(int rounds, const std::function<void()>& work) {
  const Measurement nothing = measure_raw(1, [] {});
  Measurement result = measure_raw(rounds, work);
  result.megabytes = std::max(0.0, result.megabytes - nothing.megabytes);
  return result;
}

/// Reads all packed signs of every cell.
std::uint64_t visit_all(const Planes& planes) {
  std::uint64_t sum = 0;
  visit_cells(planes, [&sum](CellKind kind, const PackedSigns& signs) {
    std::uint64_t hash = static_cast<std::uint64_t>(kind);
    for (std::size_t w = 0; w < signs.word_count(); ++w) {
      hash += signs.words()[w] * (2 * w + 0x9e3779b97f4a7c15);
    }
    sum += (hash ^ (hash >> 32)) * 0x2545f4914f6cdd1d;
  });
  return sum;
}

void print(const char* family, std::size_t m, const char* what, const Measurement& result) {
  std::printf("%-9s %5zu  %-26s %9.4f s %8.1f MB\n", family, m, what, result.seconds,
              result.megabytes);
}

void against_cgal(int rounds) {
  for (const std::size_t m : {4u, 9u, 20u, 50u, 100u, 200u}) {
    const Planes planes = integer_planes(m);
    const Measurement cgal = measure(rounds, [&] { enumerate_slip_states_cgal(planes); });
    const Measurement states = measure(rounds, [&] { enumerate_slip_states_sweep(planes); });
    const Measurement visit = measure(rounds, [&] { visit_all(planes); });
    print("integers", m, "states, cgal", cgal);
    print("integers", m, "states, sweep", states);
    print("integers", m, "visit", visit);
    std::printf("          cgal / sweep: %.1f for sorted states, %.1f for visits\n",
                cgal.seconds / states.seconds, cgal.seconds / visit.seconds);
  }
}

void at_scale(const char* family, const Planes& planes, int rounds, bool only_counts) {
  const std::size_t m = planes.size();
  SweepWork work;
  const ArrangementCounts counts = count_cells(planes, 1, &work);
  std::printf(
      "%-9s %5zu  %zu cells on %zu circles; signs by double %llu, 128 bits %llu, GMP "
      "%llu; exact sorts %llu\n",
      family, m, counts.cells(), counts.circles,
      static_cast<unsigned long long>(work.by_double),
      static_cast<unsigned long long>(work.by_int128),
      static_cast<unsigned long long>(work.by_gmp),
      static_cast<unsigned long long>(work.exact_sorts));
  print(family, m, "counts", measure(rounds, [&] { count_cells(planes); }));
  print(family, m, "counts, all threads", measure(rounds, [&] { count_cells(planes, 0); }));
  if (only_counts) return;
  print(family, m, "visit", measure(rounds, [&] { visit_all(planes); }));
  print(family, m, "structure", measure(rounds, [&] { ArrangementStructure{planes}; }));
  print(family, m, "structure, all threads",
        measure(rounds, [&] { ArrangementStructure(planes, 0); }));
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  using namespace stickslip::bench;
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
  against_cgal(rounds);
  at_scale("integers", integer_planes(1000), rounds, false);
  at_scale("doubles", double_planes(1000), rounds, false);
  at_scale("grid", grid_planes(1000), rounds, false);
  at_scale("integers", integer_planes(3000), rounds, true);
}
