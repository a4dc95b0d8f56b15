// SPDX-License-Identifier: GPL-3.0-or-later
// All grasps of one and of two contacts with positions on the grid {-1, 0, 1}^2 and axis
// normals, under all wrenches in {-1, 0, 1}^3, P in {0, 1} and both normal laws (k = 1; mu =
// 1/2, for one contact also 0 and 1), one grasp for each class under the symmetries of the
// square and the exchange of the contacts. Each verdict is judged by its evidence, and many are
// put to Z3. And the margins along preloads of the same grasps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <set>
#include <utility>

#include "both_checkers.hpp"
#include "family.hpp"
#include "judged.hpp"
#include "smt_oracle.hpp"

namespace stickslip {
namespace {

using test::LoadCase;

/// p_x, p_y, n_x, n_y.
using GridContact = std::array<int, 4>;
using Pair = std::pair<GridContact, GridContact>;

std::vector<GridContact> grid_contacts() {
  std::vector<GridContact> result;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (const auto& [nx, ny] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
        result.push_back({x, y, nx, ny});
      }
    }
  }
  return result;
}

GridContact quarter_turn(const GridContact& c) {
  return {-c[1], c[0], -c[3], c[2]};
}
GridContact mirrored(const GridContact& c) {
  return {-c[0], c[1], -c[2], c[3]};
}

/// The least of the pair's images.
Pair representative(Pair pair) {
  Pair least = pair;
  for (int mirror = 0; mirror < 2; ++mirror) {
    for (int turn = 0; turn < 4; ++turn) {
      least = std::min({least, pair, Pair{pair.second, pair.first}});
      pair = {quarter_turn(pair.first), quarter_turn(pair.second)};
    }
    pair = {mirrored(pair.first), mirrored(pair.second)};
  }
  return least;
}

Contact contact(const GridContact& c, const Rational& friction, int preload) {
  return {{c[0], c[1]}, {c[2], c[3]}, friction, 1, preload};
}

constexpr std::size_t kLoads = 54;  ///< of a grasp

void add_all_loads(const Grasp& grasp, std::vector<LoadCase>& load_cases) {
  for (int w = 0; w < 27; ++w) {
    const Wrench wrench{w % 3 - 1, w / 3 % 3 - 1, w / 9 - 1};
    for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
      load_cases.push_back({{grasp, wrench}, law});
    }
  }
}

/// Every `stride`-th verdict is compared with Z3's.
void expect_right(const std::vector<LoadCase>& load_cases, std::size_t stride) {
  std::vector<LoadCase> sample;
  for (std::size_t i = 0; i < load_cases.size(); i += stride) sample.push_back(load_cases[i]);
  const std::vector<std::string> expected = test::ask_z3(sample);
  std::size_t stable = 0;
  for (std::size_t i = 0; i < load_cases.size(); ++i) {
    const std::string verdict = test::judged_verdict(load_cases[i]);
    if (i % stride == 0) {
      ASSERT_EQ(verdict, expected[i / stride]) << describe(load_cases[i]);
    }
    stable += verdict == "stable" ? 1 : 0;
  }
  std::cout << load_cases.size() << " questions, " << stable << " stable, "
            << load_cases.size() - stable << " unstable; " << sample.size() << " put to z3\n";
  EXPECT_GT(20 * stable, load_cases.size());
  EXPECT_LT(stable, load_cases.size());
}

TEST(SmallWorld, OneContactOnAGrid) {
  std::set<Pair> classes;
  for (const GridContact& c : grid_contacts()) classes.insert(representative({c, c}));
  std::vector<LoadCase> load_cases;
  for (const auto& [c, same] : classes) {
    for (const Rational& friction : {Rational(0), Rational(1, 2), Rational(1)}) {
      for (const int preload : {0, 1}) {
        add_all_loads(Grasp({contact(c, friction, preload)}), load_cases);
      }
    }
  }
  expect_right(load_cases, 1);
}

TEST(SmallWorld, TwoContactsOnAGrid) {
  std::set<Pair> classes;
  for (const GridContact& a : grid_contacts()) {
    for (const GridContact& b : grid_contacts()) classes.insert(representative({a, b}));
  }
  std::vector<LoadCase> load_cases;
  for (const auto& [a, b] : classes) {
    for (const int preload : {0, 1}) {
      const Rational friction(1, 2);
      add_all_loads(Grasp({contact(a, friction, preload), contact(b, friction, preload)}),
                    load_cases);
    }
  }
  expect_right(load_cases, 13);  // no multiple of what the loads repeat in
}

/// Margins of these grasps along preload directions, which take turns: every end against
/// verdicts at it and next to it, every gap and all of l >= 0 against Z3.
void expect_margins_right(const std::vector<LoadCase>& load_cases,
                          const std::vector<PreloadDirection>& directions) {
  const Rational tiny = parse_rational("1e-15");
  std::vector<test::FamilyCase> families;
  std::vector<std::string> expected;
  std::size_t ends = 0;
  for (std::size_t i = 0; i < load_cases.size(); ++i) {
    const LoadCase& load_case = load_cases[i];
    // Another one for the same load of the next grasp.
    const PreloadDirection& direction = directions[(i + i / kLoads) % directions.size()];
    const Question question =
        test::margin_question(load_case.loaded, load_case.law, std::nullopt, direction);
    const auto margin = std::get<Margin>(find_margin(problem_of(question)));
    test::expect_accepted_by_both(question, margin);
    const auto expect_verdict = [&](const Rational& multiple, const char* verdict) {
      EXPECT_EQ(test::judged_verdict({test::member(question, multiple), question.law}), verdict)
          << describe(load_case) << " at " << to_string(multiple);
      ++ends;
    };
    for (const auto& [low, high] : margin.resisted) {
      expect_verdict(low, "stable");
      if (low > 0) expect_verdict(low - tiny, "unstable");
      expect_verdict(high.value_or(1000000), "stable");
      if (high) expect_verdict(*high + tiny, "unstable");
    }
    families.push_back({question, {}});
    expected.emplace_back(margin.resisted.empty() ? "unstable" : "stable");
    for (const MultipleRange& gap : test::gaps_of(margin)) {
      families.push_back({question, gap});
      expected.emplace_back("unstable");
    }
  }
  EXPECT_EQ(test::ask_z3(families), expected);
  std::cout << load_cases.size() << " margins, " << ends << " verdicts at their ends; "
            << families.size() << " ranges put to z3\n";
  EXPECT_GT(10 * ends, load_cases.size());
}

TEST(SmallWorld, PreloadOfOneContactGrows) {
  std::set<Pair> classes;
  for (const GridContact& c : grid_contacts()) classes.insert(representative({c, c}));
  std::vector<LoadCase> load_cases;
  for (const auto& [c, same] : classes) {
    for (const int preload : {0, 1}) {
      add_all_loads(Grasp({contact(c, Rational(1, 2), preload)}), load_cases);
    }
  }
  expect_margins_right(load_cases, {{false, {1}}});
}

/// Contacts that press against each other, whose preloads may balance.
TEST(SmallWorld, PreloadsOfTwoContactsGrow) {
  std::set<Pair> classes;
  for (const GridContact& a : grid_contacts()) {
    for (const GridContact& b : grid_contacts()) {
      if (a[2] == -b[2] && a[3] == -b[3]) classes.insert(representative({a, b}));
    }
  }
  std::vector<LoadCase> load_cases;
  for (const auto& [a, b] : classes) {
    const Rational friction(1, 2);
    add_all_loads(Grasp({contact(a, friction, 0), contact(b, friction, 0)}), load_cases);
  }
  expect_margins_right(load_cases, {{false, {1, 1}}, {false, {1, 0}}, {false, {1, 2}}});
}

}  // namespace
}  // namespace stickslip
