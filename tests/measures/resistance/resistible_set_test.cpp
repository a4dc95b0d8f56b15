// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/resistible_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "all_modes.hpp"
#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip {
namespace {

using test::degenerate_grasp;
using test::fig1_grasp;
using test::fig4_grasp;
using test::generic_grasp;
using test::near_degenerate_grasp;
using test::RandomSource;

using Points = std::vector<PlanePoint>;
using Pieces = std::vector<ResistiblePiece>;

const Rational kTiny(1, 1000000000);
constexpr int kTwinRounds = 400;

PlaneUnion united(const Pieces& pieces) {
  std::vector<PlaneCell> cells;
  for (const ResistiblePiece& piece : pieces) cells.push_back(piece.cell);
  return unite(cells);
}

/// Of one walk.
ResistibleSet set_of(const Problem& problem, const WrenchPlane& plane,
                     const ResistibleOptions& options = {}, ResistibleWork* work = nullptr) {
  return std::get<ResistibleSet>(resistible_set(problem, plane, options, work));
}

/// The naive twin: all pieces, united.
PlaneUnion union_of_pieces(const Problem& problem, const WrenchPlane& plane) {
  return united(test::pieces_of_all_modes(problem, plane));
}

/// Which is that of all pieces.
PlaneUnion region_of(const Grasp& grasp, NormalLaw law,
                     const WrenchPlane& plane = WrenchPlane::forces()) {
  const Problem problem({grasp, {0, 0, 0}}, law);
  ResistibleOptions options;
  options.pieces = true;
  const auto [region, walked] = set_of(problem, plane, options);
  const std::string question = test::describe({{grasp, {0, 0, 0}}, law});
  EXPECT_EQ(region, union_of_pieces(problem, plane)) << question;
  EXPECT_EQ(region, united(walked)) << question;
  EXPECT_EQ(region, set_of(problem, plane).region) << question;
  // And its part in a box is the union of theirs.
  const PlanePoint low{-2, -1};
  const PlanePoint high{1, Rational(3, 2)};
  std::vector<PlaneCell> parts;
  for (const ResistiblePiece& piece : walked) {
    if (auto part = clip_to_box(piece.cell, low, high)) parts.push_back(std::move(*part));
  }
  EXPECT_EQ(clip_to_box(region, low, high).areas, unite(parts).areas) << question;
  return region;
}

bool is_stable(const Grasp& grasp, NormalLaw law, const Wrench& wrench, Engine engine) {
  const Decision decision = decide(Problem({grasp, wrench}, law), by(engine));
  EXPECT_FALSE(std::holds_alternative<Undecided>(decision.verdict));
  return std::holds_alternative<Stable>(decision.verdict);
}

/// Points where the region could be wrong: a grid, all vertices, and points on and just beside
/// each edge.
Points critical_points(const PlaneUnion& region) {
  Points points = region.points;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) points.push_back({Rational(x, 2), Rational(3 * y, 4)});
  }
  std::vector<PlaneEdge> edges;
  for (const PlaneArea& area : region.areas) {
    for (const Outline& outline : area.outlines) {
      for (const PlaneEdge& edge : outline.edges()) edges.push_back(edge);
    }
  }
  for (const PlaneCell& curve : region.curves) {
    edges.insert(edges.end(), curve.edges().begin(), curve.edges().end());
  }
  for (const PlaneEdge& edge : edges) {
    for (const HomogeneousPoint& end : {edge.from, edge.to}) {
      if (is_at_infinity(end)) continue;
      const PlanePoint p = point_of(end);
      points.push_back(p);
      for (const int x : {-1, 1}) {
        for (const int y : {-1, 1}) points.push_back({p[0] + x * kTiny, p[1] + y * kTiny});
      }
    }
    HomogeneousPoint sum;
    for (std::size_t j = 0; j < 3; ++j) sum[j] = edge.from[j] + edge.to[j];
    const PlanePoint middle = point_of(sum);
    const PlaneDirection d = edge.direction();
    const Rational step = kTiny / Rational(abs(d[0]) + abs(d[1]));
    points.push_back(middle);
    for (const Rational& by : {step, Rational(-step)}) {
      points.push_back({middle[0] - by * Rational(d[1]), middle[1] + by * Rational(d[0])});
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// A wrench is in the region iff both engines say stable. Returns how many are.
std::size_t expect_verdicts(const Grasp& grasp, NormalLaw law, const WrenchPlane& plane) {
  SCOPED_TRACE(test::describe({{grasp, {0, 0, 0}}, law}));
  const PlaneUnion region = region_of(grasp, law, plane);
  std::size_t stable = 0;
  for (const PlanePoint& p : critical_points(region)) {
    const Wrench w = plane.at(p);
    const bool inside = region.contains(p);
    stable += inside ? 1 : 0;
    for (const Engine engine : {Engine::kStates, Engine::kBranchAndBound}) {
      EXPECT_EQ(inside, is_stable(grasp, law, w, engine))
          << (engine == Engine::kStates ? "states" : "branch-and-bound") << " at ("
          << to_string(w.x) << ", " << to_string(w.y) << ", " << to_string(w.torque) << ")";
    }
    if (::testing::Test::HasFailure()) break;
  }
  return stable;
}

WrenchPlane random_plane(RandomSource& random) {
  if (random.one_in(2)) return WrenchPlane::forces(Rational(random.between(-2, 2), 2));
  while (true) {
    try {
      return {test::small_wrench(random), test::small_wrench(random),
              test::small_wrench(random)};
    } catch (const InputError&) {  // dependent directions
    }
  }
}

Outline open_outline(const PlaneDirection& from, const Points& vertices,
                     const PlaneDirection& to) {
  return {vertices, from, to};
}

TEST(ResistibleRegion, Figure7b) {
  EXPECT_EQ(region_of(fig1_grasp(0), NormalLaw::kUnilateral),
            (PlaneUnion{{{{open_outline({1, 0}, {{0, 0}}, {-1, 0})}}}, {}, {}}));
}

/// w_y <= max(0, 1 - |w_x|/2)
TEST(ResistibleRegion, Figure7c) {
  EXPECT_EQ(
      region_of(fig1_grasp(1), NormalLaw::kUnilateral),
      (PlaneUnion{{{{open_outline({1, 0}, {{2, 0}, {0, 1}, {-2, 0}}, {-1, 0})}}}, {}, {}}));
}

/// On the line of w_y it is |w_y| <= 4 mu = 2 with P = 1, and nothing but 0 without.
TEST(ResistibleRegion, Figure4) {
  const PlaneUnion preloaded = region_of(fig4_grasp(1), NormalLaw::kUnilateral);
  EXPECT_TRUE(preloaded.contains({0, 2}));
  EXPECT_TRUE(preloaded.contains({0, -2}));
  EXPECT_FALSE(preloaded.contains({0, 2 + kTiny}));
  const PlaneUnion bare = region_of(fig4_grasp(0), NormalLaw::kUnilateral);
  EXPECT_EQ(bare.areas.size(), 2u);
  EXPECT_TRUE(bare.contains({0, 0}));
  EXPECT_FALSE(bare.contains({0, kTiny}));
  // Table III: torques need contacts that open.
  const WrenchPlane torques({0, 0, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_TRUE(region_of(fig4_grasp(0), NormalLaw::kUnilateral, torques).contains({0, 3}));
  EXPECT_FALSE(region_of(fig4_grasp(0), NormalLaw::kBilateral, torques).contains({0, 3}));
}

Contact contact(const Vector2& position, const Vector2& normal, const Rational& friction,
                const Rational& preload) {
  return {position, normal, friction, 1, preload};
}

TEST(ResistibleRegion, DegenerateGraspsAgreeWithTheEngines) {
  const Rational half(1, 2);
  const std::vector<Grasp> grasps{
      Grasp(), Grasp({contact({0, -1}, {0, 1}, half, 1)}),
      Grasp({contact({1, -1}, {0, 1}, 0, 0)}),
      // Two contacts at one point: one circle, and two.
      Grasp({contact({0, 0}, {0, 1}, half, 1), contact({0, 0}, {0, 1}, 1, 0)}),
      Grasp({contact({0, 0}, {0, 1}, half, 1), contact({0, 0}, {1, 0}, 1, 1)}),
      // All normals parallel; opposite ones on one line.
      Grasp({contact({-1, 0}, {0, 1}, half, 1), contact({0, 0}, {0, 1}, half, 0),
             contact({1, 0}, {0, 1}, half, 1)}),
      Grasp({contact({-1, 0}, {1, 0}, half, 1), contact({1, 0}, {-1, 0}, half, 1)}),
      Grasp({contact({-1, 0}, {1, 0}, 0, 1), contact({1, 0}, {-1, 0}, 0, 1)}), fig1_grasp(0),
      fig1_grasp(1), fig4_grasp(0), fig4_grasp(1)};
  for (const Grasp& grasp : grasps) {
    for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
      for (const WrenchPlane& plane : {WrenchPlane::forces(), WrenchPlane::forces(half),
                                       WrenchPlane({0, -1, 0}, {1, 1, 0}, {0, 1, 1})}) {
        expect_verdicts(grasp, law, plane);
        if (HasFailure()) return;
      }
    }
  }
}

TEST(ResistibleRegion, RandomGraspsAgreeWithTheEngines) {
  RandomSource random(5);
  std::size_t stable = 0;
  for (int round = 0; round < 150; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, 4));
    const Grasp grasp = round % 3 == 0 ? degenerate_grasp(random, m)
                        : round % 3 == 1
                            ? generic_grasp(random, m)
                            : near_degenerate_grasp(random, m, Rational(1, 1000000));
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    stable += expect_verdicts(grasp, law, random_plane(random));
    if (HasFailure()) return;
  }
  EXPECT_GT(stable, 1000u);
}

/// Regions of all kinds of grasps, with and without preload, are the unions of all pieces.
TEST(ResistibleRegion, IsTheUnionOfAllPieces) {
  RandomSource random(23);
  std::size_t areas = 0;
  std::size_t thin = 0;
  for (int round = 0; round < kTwinRounds; ++round) {
    const auto m = static_cast<std::size_t>(random.between(1, round % 16 == 0 ? 8 : 6));
    Grasp grasp = round % 4 == 0   ? generic_grasp(random, m)
                  : round % 4 == 1 ? near_degenerate_grasp(random, m, Rational(1, 1000000))
                                   : degenerate_grasp(random, m);
    if (random.one_in(2)) {
      std::vector<Contact> contacts = grasp.contacts();
      for (Contact& c : contacts) {
        if (random.one_in(2)) c.preload = 0;
        if (random.one_in(6)) c.friction = 0;
      }
      grasp = Grasp(contacts);
    }
    const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const PlaneUnion region = region_of(grasp, law, random_plane(random));
    areas += region.areas.size();
    thin += region.curves.size() + region.points.size();
    if (HasFailure()) return;
  }
  EXPECT_GT(areas, 100u);
  EXPECT_GT(thin, 20u);
}

/// What is nearly degenerate, badly scaled or symmetric.
TEST(ResistibleRegion, HardGrasps) {
  std::size_t grasps = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STICKSLIP_HARD_CASES)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() != ".json" || name.find("24") != name.npos) continue;
    const LoadedGrasp loaded = read_grasp_file(entry.path()).loaded();
    if (loaded.grasp.size() > 12) continue;
    SCOPED_TRACE(name);
    ++grasps;
    const NormalLaw law =
        name.find("bilateral") != name.npos ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
    const Problem problem(loaded, law);
    const WrenchPlane plane = WrenchPlane::forces(loaded.wrench.torque);
    EXPECT_EQ(set_of(problem, plane).region, union_of_pieces(problem, plane));
  }
  EXPECT_GE(grasps, 10u);
}

/// Preloaded contacts all round a body, with normals of length 1.
Grasp ring(int contacts) {
  std::vector<Contact> all_round;
  for (int i = 0; i < contacts; ++i) {
    const int n = i - contacts / 2;
    const int d = contacts / 2 + 1;
    const int side = i % 2 == 0 ? -1 : 1;
    const Rational c(side * (d * d - n * n), d * d + n * n);
    const Rational s(side * 2 * n * d, d * d + n * n);
    all_round.push_back({{2 * c, s}, {-c, -s}, Rational(1, 3), 1, Rational(17 + i % 5, 10)});
  }
  return Grasp(all_round);
}

/// Of m^3 modes those are visited that are near the plane, and little of them is exact.
TEST(ResistibleRegion, WorkGrowsWithTheSquare) {
  const WrenchPlane plane({0, 0, 40}, {1, 0, 0}, {0, 1, 0});
  for (const int m : {8, 12, 24, 36}) {
    SCOPED_TRACE(m);
    const Problem problem({ring(m), {0, 0, 0}}, NormalLaw::kUnilateral);
    ResistibleWork work;
    const PlaneUnion region = set_of(problem, plane, {}, &work).region;
    if (m <= 12) {
      EXPECT_EQ(region, union_of_pieces(problem, plane));
    }
    const auto square = static_cast<std::size_t>(m * m);
    EXPECT_LT(work.modes, 6 * square);
    EXPECT_GT(work.modes, square);
    EXPECT_LT(work.nodes, 10 * work.modes);
    EXPECT_LE(work.pieces, work.modes);
    EXPECT_LT(work.borders, work.pieces);
    EXPECT_LT(work.exact_sections + work.exact_turns, work.pieces / 5);
  }
}

TEST(ResistibleRegion, PiecesNameTheirModes) {
  const Problem problem({fig1_grasp(1), {0, 0, 0}}, NormalLaw::kUnilateral);
  ResistibleOptions options;
  options.pieces = true;
  ResistibleWork work;
  const Pieces pieces = set_of(problem, WrenchPlane::forces(), options, &work).pieces;
  EXPECT_LE(pieces.size(), work.pieces + 2);  // all at rest, and all without a force
  for (const ResistiblePiece& piece : pieces) {
    EXPECT_EQ(std::count_if(pieces.begin(), pieces.end(),
                            [&](const auto& other) { return other.modes == piece.modes; }),
              1);
  }
  // All stick at d = 0: P = 1 at each contact, friction anywhere in the cones.
  const auto still = std::find_if(pieces.begin(), pieces.end(), [](const auto& piece) {
    return piece.modes == std::vector<ContactMode>(3, {true, Sign::kZero});
  });
  ASSERT_NE(still, pieces.end());
  const Rational half(1, 2);
  EXPECT_EQ(still->cell.vertices(), (Points{{-half, -3 * half},
                                            {0, -2},
                                            {half, -3 * half},
                                            {half, -half},
                                            {0, 0},
                                            {-half, -half}}));
  // Slips + are to the left, where T points.
  const Problem floor({Grasp({contact({0, 0}, {0, 1}, half, 1)}), {0, 0, 0}},
                      NormalLaw::kUnilateral);
  const Pieces of_floor = set_of(floor, WrenchPlane::forces(), options).pieces;
  const auto has = [&](const ContactMode& mode, const PlaneCell& cell) {
    return std::any_of(of_floor.begin(), of_floor.end(), [&](const ResistiblePiece& piece) {
      return piece.modes == std::vector{mode} && piece.cell == cell;
    });
  };
  const HomogeneousPoint none{0, 0, 1};
  EXPECT_TRUE(has({false, Sign::kZero}, PlaneCell::hull({none})));
  EXPECT_TRUE(has({true, Sign::kPositive}, PlaneCell::hull({none, {-1, -2, 0}})));
  EXPECT_TRUE(has({true, Sign::kNegative}, PlaneCell::hull({none, {1, -2, 0}})));
  EXPECT_TRUE(has({true, Sign::kZero}, PlaneCell::hull({none, {1, -2, 0}, {-1, -2, 0}})));
}

TEST(ResistibleRegion, LimitOnModes) {
  const Problem problem({fig1_grasp(1), {0, 0, 0}}, NormalLaw::kUnilateral);
  ResistibleWork work;
  ResistibleOptions options;
  std::size_t calls = 0;
  options.progress = [&](std::size_t modes) { EXPECT_EQ(modes, ++calls); };
  const PlaneUnion all = set_of(problem, WrenchPlane::forces(), options, &work).region;
  EXPECT_EQ(calls, work.modes);
  options.progress = nullptr;
  options.mode_limit = work.modes;
  EXPECT_EQ(all, set_of(problem, WrenchPlane::forces(), options).region);
  options.mode_limit = work.modes - 1;
  const auto given_up = resistible_set(problem, WrenchPlane::forces(), options);
  ASSERT_TRUE(std::holds_alternative<Undecided>(given_up));
  EXPECT_EQ(std::get<Undecided>(given_up).limit, "there are more than 56 contact modes");
}

TEST(WrenchPlane, Coordinates) {
  const WrenchPlane plane({1, 2, 3}, {1, 1, 0}, {0, 1, 2});
  const Wrench w = plane.at({Rational(3, 2), Rational(-1, 3)});
  EXPECT_EQ(plane.coordinates({2 * w.x, 2 * w.y, 2 * w.torque}, 2),
            (Vector4{3, Rational(-2, 3), 0, 2}));
  EXPECT_NE(plane.coordinates({w.x, w.y, w.torque + 1}, 1)[2], 0);
  EXPECT_THROW(WrenchPlane({0, 0, 0}, {1, 2, 0}, {-2, -4, 0}), InputError);
  EXPECT_THROW(WrenchPlane({0, 0, 0}, {1, 2, 0}, {0, 0, 0}), InputError);
}

}  // namespace
}  // namespace stickslip
