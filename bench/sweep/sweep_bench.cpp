// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds and memory of the sweep: counts, all cells visited with their signs, the structure;
// and the ratio to the CGAL enumerator. Exact signs by the stage that decided them.
//
//     sweep_bench [rounds, default 3]
//
// Each measurement runs in a process of its own: best elapsed time of the rounds, and how far
// the peak of its resident memory lies above what it was before. Making
// the planes is not timed. One thread, unless the row says otherwise.
#include <cstdint>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "arguments.hpp"
#include "child.hpp"
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

void print(const char* family, std::size_t m, const char* what,
           const ChildMeasurement& result) {
  std::printf("%-9s %5zu  %-26s %9.4f s %8.1f MB\n", family, m, what, result.wall_seconds,
              static_cast<double>(result.peak_bytes) / (1 << 20));
}

void against_cgal(int rounds) {
  for (const std::size_t m : {4u, 9u, 20u, 50u, 100u, 200u}) {
    const Planes planes = integer_planes(m);
    const ChildMeasurement cgal = measure_in_child(
        [&] { return enumerate_slip_states_cgal(planes).states.size(); }, rounds);
    const ChildMeasurement states = measure_in_child(
        [&] { return enumerate_slip_states_sweep(planes).states.size(); }, rounds);
    const ChildMeasurement visit = measure_in_child([&] { return visit_all(planes); }, rounds);
    print("integers", m, "states, cgal", cgal);
    print("integers", m, "states, sweep", states);
    print("integers", m, "visit", visit);
    std::printf("          cgal / sweep: %.1f for sorted states, %.1f for visits\n",
                cgal.wall_seconds / states.wall_seconds,
                cgal.wall_seconds / visit.wall_seconds);
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
  print(family, m, "counts",
        measure_in_child([&] { return count_cells(planes).cells(); }, rounds));
  print(family, m, "counts, all threads",
        measure_in_child([&] { return count_cells(planes, 0).cells(); }, rounds));
  if (only_counts) return;
  print(family, m, "visit", measure_in_child([&] { return visit_all(planes); }, rounds));
  print(
      family, m, "structure",
      measure_in_child([&] { return ArrangementStructure(planes).counts().cells(); }, rounds));
  print(family, m, "structure, all threads",
        measure_in_child([&] { return ArrangementStructure(planes, 0).counts().cells(); },
                         rounds));
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  using namespace stickslip::bench;
  stickslip::bench::Arguments arguments(
      "sweep_bench", "Seconds and memory of the sweep, against CGAL's arrangement.");
  stickslip::Command& app = arguments.described();
  int rounds = 3;
  app.add_option("ROUNDS", rounds, "Times that each is measured")->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  against_cgal(rounds);
  at_scale("integers", integer_planes(1000), rounds, false);
  at_scale("doubles", double_planes(1000), rounds, false);
  at_scale("grid", grid_planes(1000), rounds, false);
  at_scale("integers", integer_planes(3000), rounds, true);
}
