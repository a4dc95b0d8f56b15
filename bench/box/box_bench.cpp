// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes about planar grasps of 3 to 10 contacts under loads at 50 to 120 % of their margin: the
// largest proved and the smallest refuted factor of the tolerances, and the answers of the box
// itself. Exit code 1 if a proved factor is not below a refuted one.
//
//     box_bench [--grasps N, default 20] [--seed S]
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <optional>
#include <vector>

#include "arguments.hpp"
#include "random_source.hpp"
#include "statistics.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/radius.hpp"

namespace stickslip::bench {
namespace {

double milliseconds(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from)
      .count();
}

/// Contacts about a disc of radius 5, as fingers would be placed by hand; loaded along some
/// direction of which the margin is an interval from 0 on.
std::optional<LoadedGrasp> random_load(RandomSource& random) {
  constexpr int kTriples[8][3] = {{3, 4, 5},   {4, 3, 5},   {5, 12, 13}, {12, 5, 13},
                                  {8, 15, 17}, {15, 8, 17}, {1, 0, 1},   {0, 1, 1}};
  const auto tenths = [&](int low, int high) {
    return Rational(random.between(low, high), 10);
  };
  std::vector<Contact> contacts(static_cast<std::size_t>(random.between(3, 10)));
  for (Contact& c : contacts) {
    const auto& triple = kTriples[random.between(0, 7)];
    c.normal = {Rational((2 * random.between(0, 1) - 1) * triple[0], triple[2]),
                Rational((2 * random.between(0, 1) - 1) * triple[1], triple[2])};
    c.position = {-5 * c.normal.x + tenths(-20, 20), -5 * c.normal.y + tenths(-20, 20)};
    c.friction = tenths(1, 10);
    c.stiffness = tenths(5, 20);
    if (random.between(0, 5) > 0) c.preload = tenths(1, 20);
  }
  LoadedGrasp loaded{Grasp(std::move(contacts)), {}};
  const Wrench direction{random.between(-10, 10), random.between(-10, 10),
                         random.between(-20, 20)};
  const Rational part(random.between(50, 120), 100);
  if (direction == Wrench{}) return std::nullopt;
  const auto found =
      find_margin(Problem(loaded, NormalLaw::kUnilateral).along({row_of(direction)}));
  const auto& resisted = std::get<Margin>(found).resisted;
  const bool is_interval = !resisted.empty() && resisted[0].low.is_zero() && resisted[0].high &&
                           !resisted[0].high->is_zero();
  // Exactly on a threshold there is no box.
  if (!is_interval || part == 1) return std::nullopt;
  loaded.wrench = (part * *resisted[0].high) * direction;
  return loaded;
}

struct Summary {
  std::vector<double> ratios;
  std::vector<double> answer_ms;
  std::vector<double> radius_ms;
  std::size_t undecided = 0;
  bool contradiction = false;
};

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

Summary measure(const char* tolerances, std::size_t grasps, std::uint64_t seed) {
  Summary summary;
  RandomSource random(seed);
  while (summary.ratios.size() < grasps) {
    const auto loaded = random_load(random);
    if (!loaded) continue;
    const GraspBox centre = box_of(*loaded);
    const GraspBox box = centre.widened(parse_tolerances(tolerances));
    auto start = std::chrono::steady_clock::now();
    const BoxDecision decision = decide_box(box, NormalLaw::kUnilateral);
    summary.answer_ms.push_back(milliseconds(start));
    if (std::holds_alternative<Undecided>(decision.verdict)) ++summary.undecided;
    start = std::chrono::steady_clock::now();
    const Radius radius = find_radius(centre, box, NormalLaw::kUnilateral);
    summary.radius_ms.push_back(milliseconds(start));
    const Rational edge = radius.refuted.value_or(radius.limit);
    const double ratio = to_double(radius.proved / edge);
    summary.ratios.push_back(ratio);
    summary.contradiction =
        summary.contradiction || (radius.refuted && radius.proved >= *radius.refuted);
    std::printf(
        "  m=%zu %s proved %.4g %s %.4g ratio %.3f; answer %s %.0f ms, radius %.0f ms\n",
        loaded->grasp.size(), radius.stable.value_or(false) ? "stable" : "unstable",
        to_double(radius.proved), radius.refuted ? "refuted" : "limit", to_double(edge), ratio,
        name_of(decision.verdict), summary.answer_ms.back(), summary.radius_ms.back());
    std::fflush(stdout);
  }
  return summary;
}

int run(std::size_t grasps, std::uint64_t seed) {
  bool contradiction = false;
  constexpr std::array<const char*, 2> kTolerances{
      "friction=10%",
      "friction=10%,stiffness=10%,preload=5%,position=0.001,normal=0.0175,wrench=2%"};
  std::vector<Summary> summaries;
  for (const char* tolerances : kTolerances) {
    std::printf("%s\n", tolerances);
    summaries.push_back(measure(tolerances, grasps, seed));
    contradiction = contradiction || summaries.back().contradiction;
  }
  std::puts(
      "\n| tolerances | grasps | proved / refuted, median | lower quartile | least | undecided "
      "| "
      "answer, ms | slowest | radius, ms | slowest |");
  std::puts("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  for (std::size_t k = 0; k < kTolerances.size(); ++k) {
    const Summary& s = summaries[k];
    std::printf("| %s | %zu | %.3f | %.3f | %.3f | %zu | %.0f | %.0f | %.0f | %.0f |\n",
                kTolerances[k], s.ratios.size(), median(s.ratios), quantile(s.ratios, 0.25),
                quantile(s.ratios, 0), s.undecided, median(s.answer_ms),
                quantile(s.answer_ms, 1), median(s.radius_ms), quantile(s.radius_ms, 1));
  }
  return contradiction ? 1 : 0;
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  stickslip::bench::Arguments arguments(
      "box_bench", "Boxes: how much of the tolerance that can be proved is proved");
  stickslip::Command& app = arguments.described();
  std::size_t grasps = 20;
  app.add_option("--grasps", grasps, "for each set of tolerances")->capture_default_str();
  std::uint64_t seed = 1;
  app.add_option("--seed", seed, "of the grasps")->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  return stickslip::bench::run(grasps, seed);
}
