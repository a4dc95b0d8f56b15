// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts in space on random grasps, with the load just before and just beyond a threshold:
// the time to decide and to write the certificate, and the work. A threshold is where the
// answer stops being stable as the load grows, by bisection.
//
//     space_bench [--contacts M, default 4] [--on sphere|box] [--grasps N, default 6]
//                 [--gap PART, default 0.01] [--digits D] [--seed S] [--node-limit N]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "random_source.hpp"
#include "statistics.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip::bench {
namespace {

struct SpaceBenchOptions {
  int contacts = 4;
  std::string on = "sphere";
  std::size_t grasps = 6;
  double gap = 0.01;
  int digits = 0;
  std::uint64_t seed = 1;
  std::size_t node_limit = 0;
};

/// A rational point of the unit sphere.
Vector3 unit_vector(RandomSource& random) {
  const Rational a(random.between(-8, 8), 8);
  const Rational b(random.between(-8, 8), 8);
  const Rational s = 1 + a * a + b * b;
  Vector3 n{2 * a / s, 2 * b / s, (1 - a * a - b * b) / s};
  if (random.one_in(2)) n[2] = -n[2];
  std::swap(n[0], n[static_cast<std::size_t>(random.between(0, 2))]);
  return n;
}

/// Contacts on the unit sphere, or on the faces of the cube around it, and the load's
/// direction.
std::pair<GraspBox, Vector6> random_grasp(const SpaceBenchOptions& options,
                                          RandomSource& random) {
  const auto ragged = [&](Rational value) {  // to so many digits
    if (options.digits > 0) {
      int most = 1;
      for (int k = 0; k < options.digits; ++k) most *= 10;
      value += Rational(random.between(-most / 100, most / 100), most);
    }
    return value;
  };
  GraspBox grasp{{}, WrenchBox(6)};
  for (int i = 0; i < options.contacts; ++i) {
    Vector3 normal{};
    Vector3 position{};
    if (options.on == "sphere") {
      normal = unit_vector(random);
      for (std::size_t j = 0; j < 3; ++j) position[j] = ragged(-normal[j]);
    } else {
      const auto axis = static_cast<std::size_t>(random.between(0, 2));
      const int side = random.one_in(2) ? 1 : -1;
      for (Rational& x : position) x = ragged(Rational(random.between(-8, 8), 8));
      position[axis] = side;
      normal[axis] = -side;
    }
    UncertainContact contact{{},
                             {normal.begin(), normal.end()},
                             point_interval(Rational(random.between(4, 18), 20))};
    for (const Rational& x : position) contact.position.push_back(point_interval(x));
    contact.friction = point_interval(ragged(contact.friction.low));
    contact.preload = point_interval(Rational(random.between(0, 8), 4));
    grasp.contacts.push_back(std::move(contact));
  }
  Vector6 direction;
  for (Rational& u : direction) u = ragged(Rational(random.between(-8, 8), 8));
  return {std::move(grasp), direction};
}

class Measurement {
 public:
  Measurement(const SpaceBenchOptions& options, GraspBox grasp, Vector6 direction)
      : options_(options), grasp_(std::move(grasp)), direction_(std::move(direction)) {}

  BoxDecision decide_at(double multiple) {
    constexpr double kSteps = 1e6;
    const Rational l(std::llround(multiple * kSteps), std::llround(kSteps));
    for (std::size_t j = 0; j < 6; ++j) {
      grasp_.wrench[j] = point_interval(Rational(l * direction_[j]));
    }
    question_ = ask({grasp_}, {});
    return decide_box(*question_.box(), question_.law, {options_.node_limit});
  }
  bool is_stable(double multiple) {
    return std::holds_alternative<Stable>(decide_at(multiple).verdict);
  }
  /// Below and above; nothing if there is none between 0.01 and 20.
  std::optional<std::pair<double, double>> threshold() {
    constexpr double kLeast = 0.01;
    constexpr double kMost = 20;
    if (!is_stable(kLeast)) return std::nullopt;
    double high = 2 * kLeast;
    while (high < kMost && is_stable(high)) high *= 2;
    if (high >= kMost) return std::nullopt;
    double low = high / 2;
    while (high - low > options_.gap / 20 * high) {
      const double middle = (low + high) / 2;
      (is_stable(middle) ? low : high) = middle;
    }
    return std::pair(low, high);
  }
  const Question& question() const { return question_; }

 private:
  const SpaceBenchOptions& options_;
  GraspBox grasp_;
  Vector6 direction_;
  Question question_;
};

int run(const SpaceBenchOptions& options) {
  RandomSource random(options.seed);
  std::vector<double> seconds;
  std::vector<double> bytes;
  std::vector<double> nodes;
  std::size_t undecided = 0;
  std::size_t wrong_side = 0;
  SearchWork total;
  for (std::size_t count = 0; count < options.grasps;) {
    auto [grasp, direction] = random_grasp(options, random);
    Measurement measurement(options, std::move(grasp), direction);
    const auto threshold = measurement.threshold();
    if (!threshold) continue;
    ++count;
    for (const bool beyond : {false, true}) {
      const double at =
          beyond ? threshold->second * (1 + options.gap) : threshold->first * (1 - options.gap);
      const auto start = std::chrono::steady_clock::now();
      const BoxDecision decision = measurement.decide_at(at);
      std::size_t size = 0;
      if (std::holds_alternative<Undecided>(decision.verdict)) {
        ++undecided;
      } else {
        size =
            certificate_text(measurement.question(), decision.verdict, "bench", decision.bits)
                .size();
      }
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      seconds.push_back(time.count());
      bytes.push_back(static_cast<double>(size));
      nodes.push_back(static_cast<double>(decision.work.nodes));
      total += decision.work;
      // Verdicts are not monotone: this is possible, and rare.
      if (std::holds_alternative<Stable>(decision.verdict) == beyond) ++wrong_side;
      std::printf("  load %.6f %s %.3f s nodes %zu rays %zu checks %zu proofs %zu bytes %zu\n",
                  at, name_of(decision.verdict), time.count(), decision.work.nodes,
                  decision.work.rays, decision.work.exact_checks, decision.work.proofs, size);
      std::fflush(stdout);
    }
  }
  std::puts(
      "\n| m | on | gap | verdicts | undecided | not as before and beyond | s, median | "
      "slowest "
      "| nodes, median | most | bytes, median | most | rays a region | most | bits of rays |");
  std::puts("|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  const auto most = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  std::printf(
      "| %d | %s | %g %% | %zu | %zu | %zu | %.3f | %.3f | %.0f | %.0f | %.0f | %.0f | %.1f | "
      "%zu "
      "| %zu |\n",
      options.contacts, options.on.c_str(), 100 * options.gap, seconds.size(), undecided,
      wrong_side, median(seconds), most(seconds), median(nodes), most(nodes), median(bytes),
      most(bytes),
      static_cast<double>(total.rays) /
          static_cast<double>(std::max<std::size_t>(total.nodes, 1)),
      total.most_rays, total.ray_bits);
  return 0;
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  stickslip::bench::Arguments arguments("space_bench", "Verdicts in space near thresholds");
  stickslip::Command& app = arguments.described();
  stickslip::bench::SpaceBenchOptions options;
  app.add_option("--contacts", options.contacts, "of each grasp")->capture_default_str();
  app.add_option("--on", options.on, "where contacts are")
      ->choices({"sphere", "box"})
      ->capture_default_str();
  app.add_option("--grasps", options.grasps, "how many")->capture_default_str();
  app.add_option("--gap", options.gap, "from the threshold, relative")->capture_default_str();
  app.add_option("--digits", options.digits,
                 "of positions, friction and load beyond small fractions")

      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the grasps")->capture_default_str();
  app.add_option("--node-limit", options.node_limit, "of each verdict")->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  return stickslip::bench::run(options);
}
