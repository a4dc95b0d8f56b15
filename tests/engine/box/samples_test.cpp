// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand grasps are drawn from fifty boxes that are proved stable, in the plane and in
// space. Each is decided by itself, and the checker judges its proof: none contradicts its box.
// Other checkers take minutes for these, and see such proofs in box_test and cli_tolerances.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>

#include "box_cases.hpp"
#include "stickslip/interfaces/samples_answer.hpp"

namespace stickslip {
namespace {

using test::BoxCase;
using test::RandomSource;

/// \{ Samples of each box; those of the few are of grasps that take long to decide.
constexpr std::size_t kOfMany = 23;
constexpr std::size_t kOfFew = 8;
/// \}

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Returns a cube with contacts on its faces, under a load that they balance up to rounding: at
/// rest with a part of their friction, or while all slip along a random motion.
GraspBox cube(RandomSource& random, int contacts, bool slips) {
  const auto tenths = [&](int low, int high) {
    return Rational(random.between(low, high), 10);
  };
  Vector step{};
  Vector turn{};
  for (Vector* part : {&step, &turn}) {
    for (double& entry : *part) entry = slips ? random.between(-9, 9) / 40.0 : 0;
  }
  GraspBox box;
  Vector force{};
  Vector torque{};
  for (int i = 0; i < contacts; ++i) {
    UncertainContact& c = box.contacts.emplace_back();
    const auto axis = static_cast<std::size_t>((i / 2) % 3);
    const int side = i % 2 == 0 ? 1 : -1;
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational beside = tenths(-8, 8);
      c.position.push_back(point_interval(j == axis ? Rational(side) : beside));
      c.normal.emplace_back(j == axis ? -side : 0);
    }
    c.friction = point_interval(tenths(3, 9));
    c.stiffness = point_interval(tenths(5, 20));
    c.preload = point_interval(tenths(10, 30));
    Vector p{};
    Vector n{};
    for (std::size_t j = 0; j < 3; ++j) {
      p[j] = to_double(c.position[j].low);
      n[j] = to_double(c.normal[j]);
    }
    const Vector swung = cross(turn, p);
    Vector slip{};
    for (std::size_t j = 0; j < 3; ++j) slip[j] = step[j] + swung[j];
    const double rise = dot(slip, n);
    for (std::size_t j = 0; j < 3; ++j) slip[j] -= rise * n[j];
    const double pressed =
        std::max(0.0, to_double(c.preload.low) - to_double(c.stiffness.low) * rise);
    const double most = to_double(c.friction.low) * pressed;
    Vector at{};
    for (std::size_t j = 0; j < 3; ++j) {
      const double held = j == axis ? 0 : most * random.between(-4, 4) / 8;
      at[j] = pressed * n[j] + (slips ? -most * slip[j] / std::sqrt(dot(slip, slip)) : held);
    }
    const Vector moment = cross(p, at);
    for (std::size_t j = 0; j < 3; ++j) {
      force[j] += at[j];
      torque[j] += moment[j];
    }
  }
  constexpr int kGrain = 10000;
  for (const Vector& part : {force, torque}) {
    for (const double entry : part) {
      box.wrench.push_back(point_interval(Rational(-std::lround(kGrain * entry), kGrain)));
    }
  }
  return box;
}

class ThousandSamples : public ::testing::Test {
 protected:
  /// Draws so many grasps from the box if it is proved stable; returns whether it is.
  bool draw_from(const BoxCase& about, std::size_t count) {
    const BoxDecision decision = about.decide();
    const auto* stable = std::get_if<Stable>(&decision.verdict);
    if (stable == nullptr) return false;
    const test::CheckerAnswer answer =
        test::ask_cpp_checker(test::input_of(about.grasp, about.options, decision));
    EXPECT_EQ(answer.result, "accepted") << describe(about);
    for (const auto& part : std::get<StabilityProof>(stable->proof)) {
      if (std::holds_alternative<RestProof>(part)) ++proofs_["at rest"];
      if (std::holds_alternative<StickingProof>(part)) ++proofs_["sticking"];
      if (const auto* degree = std::get_if<DegreeProof>(&part)) {
        const bool moves = std::any_of(
            degree->trees.begin(), degree->trees.end(),
            [](const TreeNode& node) { return std::holds_alternative<MovingLeaf>(node); });
        ++proofs_[moves ? "by twists that move" : "by degree"];
      }
    }
    Samples samples;
    samples.seed = ++boxes_;
    decide_samples(about.question(), count, {}, samples);
    EXPECT_EQ(samples.stable, count) << describe(about);
    samples_ += samples.stable;
    return true;
  }

  std::size_t boxes_ = 0;
  std::size_t samples_ = 0;
  std::map<std::string, std::size_t> proofs_;
};

TEST_F(ThousandSamples, AreStableInsideFiftyProvedBoxes) {
  RandomSource random(61);
  for (const test::Uncertain uncertain : {test::Uncertain::kFriction, test::Uncertain::kAll,
                                          test::Uncertain::kWrench, test::Uncertain::kInFile}) {
    for (int found = 0; found < 7;) {
      found += draw_from(test::random_box(random, uncertain), kOfMany) ? 1 : 0;
    }
  }
  for (int found = 0; found < 14;) {
    const bool slips = found >= 12;
    const int contacts = slips ? 4 : 1 + found % 8;
    BoxCase about{test::file_of(cube(random, contacts, slips))};
    Tolerances& asked = about.options.uncertain;
    const Rational size = random.pick<Rational>({1, 3, 10});
    asked.friction = asked.stiffness = asked.preload = Tolerance{size / 1000, true};
    // Fewer contacts cannot take up every load.
    if (contacts > 3) asked.wrench = Tolerance{size / 10000};
    if (contacts > 3 && !slips) asked.position = asked.normal = asked.wrench;
    found += draw_from(about, slips ? kOfFew : kOfMany) ? 1 : 0;
  }
  for (const char* name : {"jaws", "jaws-unbalanced", "feet", "corner"}) {
    std::ifstream file(STICKSLIP_CORPUS "/tolerances/" + std::string(name) + ".json");
    const std::string grasp{std::istreambuf_iterator<char>(file), {}};
    for (const char* asked : {"normal=0.035,friction=5%,position=1/60",
                              "normal=0.001,friction=1%,position=1/1000,wrench=0.1%"}) {
      BoxCase about{grasp};
      about.options.uncertain = parse_tolerances(asked);
      EXPECT_TRUE(draw_from(about, kOfFew)) << name << ' ' << asked;
    }
  }
  EXPECT_GE(samples_, 1000U);
  EXPECT_EQ(boxes_, 50U);
  for (const auto& [kind, count] : proofs_) std::cout << count << ' ' << kind << '\n';
  for (const char* kind : {"at rest", "by degree", "by twists that move"}) {
    EXPECT_GE(proofs_[kind], 4U) << kind;
  }
}

}  // namespace
}  // namespace stickslip
