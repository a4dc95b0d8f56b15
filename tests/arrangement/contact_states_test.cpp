// SPDX-License-Identifier: GPL-3.0-or-later
// Slip states and contact modes in space: known numbers, and closed forms.
#include "stickslip/arrangement/contact_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "error_of.hpp"
#include "faces_by_programs.hpp"
#include "families.hpp"
#include "rounds.hpp"
#include "stickslip/arrangement/state_graph.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/number_text.hpp"

namespace stickslip {
namespace {

using test::Random;
using Lists = std::vector<std::vector<RationalRow>>;

GraspBox grasp_in_space() {
  GraspBox grasp;
  grasp.wrench.resize(6);
  return grasp;
}

void add_contact(GraspBox& grasp, const RationalRow& position, const RationalRow& normal) {
  UncertainContact contact;
  for (const Rational& x : position) contact.position.push_back(point_interval(x));
  contact.normal = normal;
  grasp.contacts.push_back(std::move(contact));
}

FaceCounts count(const GraspBox& grasp, StateSet set, const SlipLines& lines = {}) {
  const auto rows = contact_rows_for_states(grasp, lines);
  const StatePlanes planes = state_planes(motion_coordinates(grasp), rows, set);
  return count_faces(planes.coordinates, planes.planes);
}

std::uint64_t total(const GraspBox& grasp, StateSet set, const SlipLines& lines = {}) {
  return count(grasp, set, lines).total();
}

/// Contacts with random positions, normals and directions of lines.
GraspBox random_grasp(Random& random, std::size_t contacts, std::size_t lines,
                      SlipLines& directions) {
  GraspBox grasp = grasp_in_space();
  directions = {lines, false, Lists()};
  for (std::size_t i = 0; i < contacts; ++i) {
    const Vector3 p = random.vector(1000);
    const Vector3 n = random.vector(1000);
    add_contact(grasp, {p[0], p[1], p[2]}, {n[0], n[1], n[2]});
    std::vector<RationalRow> given;
    for (std::size_t j = 0; j < lines; ++j) {
      const Vector3 v = cross(n, random.vector(1000));
      given.push_back({v[0], v[1], v[2]});
    }
    directions.given->push_back(std::move(given));
  }
  return grasp;
}

using Numbers = std::vector<std::uint64_t>;

Numbers product(const Numbers& a, const Numbers& b) {
  Numbers result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

Numbers power(const Numbers& a, std::size_t exponent) {
  Numbers result{1};
  for (std::size_t i = 0; i < exponent; ++i) result = product(result, a);
  return result;
}

std::uint64_t choose(std::size_t n, std::size_t k) {
  std::uint64_t result = 1;
  for (std::size_t i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

/// The cells of a generic arrangement with these numbers of Whitney, cut at dimension d > 0.
std::uint64_t cells(const Numbers& w, std::size_t d) {
  std::uint64_t sum = 0;
  if (w.size() <= d + 1) {
    for (const std::uint64_t x : w) sum += x;
    return sum;
  }
  for (std::size_t j = d; j-- > 0;) {
    if ((d - 1 - j) % 2 == 0) sum += 2 * w[j];
  }
  return sum;
}

/// Numbers of slip states by dimension in general position: a contacts stick, b slip along a
/// line, and c of the normals' planes, if these count, contain the motion.
Numbers general_position(std::size_t m, std::size_t k, bool normals) {
  Numbers result(7);
  result[0] = 1;
  const Numbers pencil{1, k, k - 1};
  for (std::size_t a = 0; a <= m; ++a) {
    for (std::size_t b = 0; a + b <= m; ++b) {
      for (std::size_t c = 0; c <= (normals ? m : 0); ++c) {
        const std::size_t codimension = 2 * a + b + c;
        if (codimension >= 6) continue;
        std::uint64_t ways = choose(m, a) * choose(m - a, b) * choose(m, c);
        for (std::size_t i = 0; i < b; ++i) ways *= k;
        Numbers w = product(power({1, 1}, b), power(pencil, m - a - b));
        if (normals) w = product(w, power({1, 1}, m - c));
        result[6 - codimension] += ways * cells(w, 6 - codimension);
      }
    }
  }
  return result;
}

TEST(ContactStates, GeneralPosition) {
  Random random(1);
  std::size_t compared = 0;
  for (std::size_t m = 3; m <= 8; ++m) {
    for (std::size_t k = 2; k <= 8; ++k) {
      const Numbers expected = general_position(m, k, false);
      std::uint64_t sum = 0;
      for (const std::uint64_t x : expected) sum += x;
      if (sum > 1000000) continue;
      SlipLines lines;
      const GraspBox grasp = random_grasp(random, m, k, lines);
      EXPECT_EQ(count(grasp, StateSet::kSlip, lines).by_dimension, expected) << m << " " << k;
      ++compared;
    }
  }
  EXPECT_GE(compared, 20u);
}

TEST(ContactStates, CountsOfTheContract) {
  Random random(2);
  SlipLines lines;
  const auto slip = [&](std::size_t m, std::size_t k) {
    const GraspBox grasp = random_grasp(random, m, k, lines);
    return total(grasp, StateSet::kSlip, lines);
  };
  EXPECT_EQ(slip(4, 2), 4513u);
  EXPECT_EQ(slip(6, 2), 54257u);
  EXPECT_EQ(slip(8, 2), 288577u);
  EXPECT_EQ(slip(10, 2), 1010577u);
  EXPECT_EQ(slip(4, 4), 50753u);
  EXPECT_EQ(slip(6, 4), 970593u);
  if (test::kSanitized) return;
  EXPECT_EQ(slip(12, 2), 2752737u);
  EXPECT_EQ(slip(8, 4), 6200449u);
}

TEST(ContactStates, DefaultLinesAcrossOneAxisAreDependent) {
  // The first lines of seven contacts are across x, so that any six of their rows have rank 5.
  Random random(6);
  GraspBox grasp = grasp_in_space();
  for (std::size_t i = 0; i < 10; ++i) {
    const Vector3 p = random.vector(1000);
    Vector3 n = random.vector(1000);
    for (Rational& x : n) x += x.sign() < 0 ? -1000 : 1000;
    n[i < 7 ? 0 : i < 9 ? 1 : 2] = random.between(1, 999);
    add_contact(grasp, {p[0], p[1], p[2]}, {n[0], n[1], n[2]});
  }
  EXPECT_EQ(total(grasp, StateSet::kSlip), 1009937u);
}

TEST(ContactStates, TurningAboutTheLineThroughTwoContactsIsADependencyOfFullStates) {
  Random random(3);
  for (const std::size_t m : {3, 4, 5}) {
    SlipLines lines;
    const GraspBox grasp = random_grasp(random, m, 2, lines);
    Numbers expected = general_position(m, 2, true);
    const Numbers lost{0, 10, 30, 40, 30, 12, 2};
    for (std::size_t j = 0; j < 7; ++j) expected[j] -= choose(m, 2) * lost[j];
    EXPECT_EQ(count(grasp, StateSet::kFull, lines).by_dimension, expected) << m;
  }
}

/// A cube of edge 2 about the origin, with a contact in each corner of the first of six walls:
/// below, two beside that one and each other, and those across.
GraspBox cube(std::size_t walls) {
  GraspBox grasp = grasp_in_space();
  const std::vector<std::pair<std::size_t, int>> order{{2, -1}, {0, -1}, {1, -1},
                                                       {0, 1},  {1, 1},  {2, 1}};
  for (std::size_t w = 0; w < walls; ++w) {
    const auto [axis, side] = order[w];
    for (const int s : {-1, 1}) {
      for (const int t : {-1, 1}) {
        RationalRow position(3);
        RationalRow normal(3);
        position[axis] = side;
        position[(axis + 1) % 3] = s;
        position[(axis + 2) % 3] = t;
        normal[axis] = -side;
        add_contact(grasp, position, normal);
      }
    }
  }
  return grasp;
}

TEST(ContactStates, ACubeAtOneToSixWalls) {
  const Numbers opening{10, 46, 136, 10, 2, 1};
  const Numbers contact{196, 228, 136, 10, 2, 1};
  for (std::size_t walls = 1; walls <= 6; ++walls) {
    EXPECT_EQ(total(cube(walls), StateSet::kOpening), opening[walls - 1]) << walls;
    EXPECT_EQ(total(cube(walls), StateSet::kContact), contact[walls - 1]) << walls;
  }
}

TEST(ContactStates, APegInItsHoleMovesAlongIt) {
  GraspBox grasp = grasp_in_space();
  for (const int z : {-3, 3}) {
    for (const int s : {-1, 1}) {
      for (const int t : {-1, 1}) {
        add_contact(grasp, {s, t, z}, {-s, 0, 0});
        add_contact(grasp, {s, t, z}, {0, -t, 0});
      }
    }
  }
  EXPECT_EQ(total(grasp, StateSet::kOpening), 1u);
  EXPECT_EQ(total(grasp, StateSet::kContact), 3u);
  EXPECT_EQ(count(grasp, StateSet::kClosed).by_dimension, (Numbers{1, 2, 0, 0, 0, 0, 0}));
}

TEST(ContactStates, ATiltOfAMillionthMakesModesOfItsOwn) {
  GraspBox grasp = cube(1);
  EXPECT_EQ(total(grasp, StateSet::kOpening), 10u);
  grasp.contacts[0].normal[0] = Rational(1, 1000000);
  const FaceCounts tilted = count(grasp, StateSet::kOpening);
  EXPECT_EQ(tilted.total(), 16u);
}

TEST(ContactStates, SlipsOfOpenContactsDoNotSplit) {
  // One contact: open, or closed and one of 4k + 1.
  GraspBox grasp = grasp_in_space();
  add_contact(grasp, {0, 0, 0}, {0, 0, 1});
  for (const std::size_t k : {1, 2, 3, 5}) {
    const SlipLines lines{k, true, {}};
    EXPECT_EQ(total(grasp, StateSet::kContact, lines), 1 + (k == 1 ? 3 : 4 * k + 1));
    EXPECT_EQ(total(grasp, StateSet::kFull, lines), 3 * (k == 1 ? 3 : 4 * k + 1));
  }
}

TEST(ContactStates, ModesAreThoseOfLinearPrograms) {
  Random random(4);
  for (int round = 0; round < 6; ++round) {
    GraspBox grasp = grasp_in_space();
    for (int i = 0; i < 2; ++i) {
      const Vector3 p = random.vector(1);
      const Vector3 n = random.vector(1);
      add_contact(grasp, {p[0], p[1], p[2]}, {n[0], n[1], n[2]});
    }
    const auto rows = contact_rows_for_states(grasp, {});
    for (const StateSet set : {StateSet::kSlip, StateSet::kFull, StateSet::kClosed,
                               StateSet::kOpening, StateSet::kContact}) {
      const StatePlanes planes = state_planes(6, rows, set);
      EXPECT_EQ(test::checked_faces(6, planes.planes),
                test::faces_by_programs(6, planes.planes));
    }
  }
}

/// Checks that facets join cells that differ where they are 0, and all of these.
void expect_graph(const StatePlanes& planes, std::size_t facets, std::size_t cells) {
  const StateGraph graph = state_graph(planes);
  EXPECT_TRUE(graph.complete);
  EXPECT_EQ(graph.cells.size(), cells);
  ASSERT_EQ(graph.facets.size(), facets);
  std::vector<std::size_t> root(cells);
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto root_of = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  std::size_t parts = cells;
  for (const StateGraph::Facet& facet : graph.facets) {
    ASSERT_LT(facet.first, facet.second);
    const std::string& a = graph.cells.at(facet.first);
    const std::string& b = graph.cells.at(facet.second);
    for (std::size_t j = 0; j < facet.state.size(); ++j) {
      if (facet.state[j] != '0') {
        EXPECT_EQ(a[j], facet.state[j]);
        EXPECT_EQ(b[j], facet.state[j]);
      } else if (a[j] != '0') {
        EXPECT_NE(a[j], b[j]);
        EXPECT_NE(b[j], '0');
      }
    }
    const std::size_t one = root_of(facet.first);
    const std::size_t other = root_of(facet.second);
    if (one == other) continue;
    root[one] = other;
    --parts;
  }
  EXPECT_EQ(parts, 1u);
}

TEST(ContactStates, FacetsJoinCells) {
  Random random(15);
  std::vector<GraspBox> grasps{cube(1), cube(2), grasp_in_space()};
  SlipLines directions;
  for (int round = 0; round < 3; ++round) {
    grasps.push_back(random_grasp(random, 4, 2, directions));
  }
  for (const GraspBox& grasp : grasps) {
    for (const StateSet set : {StateSet::kSlip, StateSet::kFull, StateSet::kClosed}) {
      const StatePlanes planes = state_planes(6, contact_rows_for_states(grasp, {}), set);
      const auto numbers = count_faces(6, planes.planes).by_dimension;
      std::size_t top = 6;
      while (numbers[top] == 0) --top;
      expect_graph(planes, top > 0 ? numbers[top - 1] : 0, numbers[top]);
    }
  }
  // The planes of a cube on a wall are four lines that bound a square: 14 cells, 24 edges.
  expect_graph(state_planes(6, contact_rows_for_states(cube(1), {}), StateSet::kSlip), 24, 14);
  const StatePlanes modes =
      state_planes(6, contact_rows_for_states(cube(1), {}), StateSet::kContact);
  EXPECT_THROW(state_graph(modes), InputError);
  EXPECT_FALSE(
      state_graph(state_planes(6, contact_rows_for_states(grasps[3], {}), StateSet::kFull),
                  [](std::uint64_t) { return false; })
          .complete);
}

TEST(ContactStates, TheStateOfAMotion) {
  const GraspBox grasp = cube(1);
  const StatePlanes planes =
      state_planes(6, contact_rows_for_states(grasp, {}), StateSet::kSlip);
  visit_faces(6, planes.planes, [&](const Face& face) {
    const Row motion = face.motion();
    std::string text;
    for (const std::string& slip : slips_at(grasp, RationalRow(motion.begin(), motion.end()))) {
      text += (text.empty() ? "" : " ") + slip;
    }
    EXPECT_EQ(text, planes.text(face));
    return true;
  });
}

TEST(ContactStates, Texts) {
  const GraspBox grasp = cube(1);
  const auto rows = contact_rows_for_states(grasp, {});
  const auto texts = [&](StateSet set) {
    const StatePlanes planes = state_planes(6, rows, set);
    std::vector<std::string> result;
    visit_faces(6, planes.planes, [&](const Face& face) {
      result.push_back(planes.text(face));
      return true;
    });
    return result;
  };
  EXPECT_THAT(texts(StateSet::kOpening), testing::Contains("o o c c"));
  EXPECT_THAT(texts(StateSet::kContact), testing::Contains("o o 00 00"));
  EXPECT_THAT(texts(StateSet::kClosed), testing::Contains("++ ++ ++ ++"));
  EXPECT_THAT(texts(StateSet::kFull), testing::Contains("0|00 0|00 0|00 0|00"));
}

TEST(ContactStates, DefaultLinesAreAcrossTheNormalAtEqualAngles) {
  Random random(5);
  for (const std::size_t k : {1, 2, 3, 4, 6, 8}) {
    for (int round = 0; round < 20; ++round) {
      const Vector3 n = random.vector(9);
      const auto lines = default_slip_lines({n[0], n[1], n[2]}, k, true);
      ASSERT_EQ(lines.size(), k);
      for (std::size_t j = 0; j < k; ++j) {
        EXPECT_EQ(dot(n, lines[j]), 0);
        const double cosine =
            to_double(dot(lines[0], lines[j])) /
            std::sqrt(to_double(dot(lines[0], lines[0])) * to_double(dot(lines[j], lines[j])));
        const double angle = 3.14159265358979 * static_cast<double>(j) / static_cast<double>(k);
        EXPECT_NEAR(std::acos(std::min(1.0, cosine)), angle, 1.0 / 500);
      }
    }
  }
  // A rational length makes diagonals rational: at exactly 45 degrees.
  const auto lines = default_slip_lines({2, -1, 2}, 4, false);
  EXPECT_EQ(2 * dot(lines[0], lines[1]) * dot(lines[0], lines[1]),
            dot(lines[0], lines[0]) * dot(lines[1], lines[1]));
}

TEST(ContactStates, ErrorsNameTheRemedy) {
  GraspBox grasp = grasp_in_space();
  add_contact(grasp, {0, 0, 0}, {1, 1, 1});
  const auto error = [&](const SlipLines& lines) {
    return std::string(test::error_of([&] { contact_rows_for_states(grasp, lines); }).what());
  };
  using testing::HasSubstr;
  EXPECT_THAT(error({3, false, {}}),
              HasSubstr("lines: contact 0: 3 lines of slip have irrational"));
  EXPECT_THAT(error({4, false, {}}), HasSubstr("snap them"));
  EXPECT_THAT(error({2, false, Lists{{{1, -1, 0}}, {}}}), HasSubstr("1 contacts of the grasp"));
  EXPECT_THAT(
      error({2, false, Lists{{{1, -1, 0}, {1, 0, 0}}}}),
      HasSubstr("[0][1]: the direction is not across the normal of contact 0, (1, 1, 1); "
                "the nearest that is, is (2/3, -1/3, -1/3)"));
  EXPECT_THAT(error({2, false, Lists{{{1, -1, 0}, {-2, 2, 0}}}}), HasSubstr("leave out one"));
  EXPECT_THAT(error({2, false, Lists{{{0, 0, 0}}}}), HasSubstr("a direction that is 0"));
  EXPECT_THAT(error({2, false, Lists{{{1, 0}}}}),
              HasSubstr("give as many as the normal has, 3"));
  EXPECT_THAT(error({2, false, Lists{{}}}), HasSubstr("a contact has 0 directions"));
  EXPECT_THAT(test::error_of([] { state_planes(18, {}, StateSet::kSlip); }).what(),
              HasSubstr("motions have 18 coordinates"));
}

/// A box of edge 2 on the ground, another on it, and perhaps a wall that both stand at; contacts
/// in all corners.
GraspBox box_on_box(bool at_wall) {
  auto mechanism = std::make_shared<Mechanism>();
  mechanism->in_space = true;
  mechanism->bodies = {{"lower"}, {"upper"}};
  GraspBox grasp = grasp_in_space();
  grasp.mechanism = mechanism;
  const auto add = [&](std::size_t body, const RationalRow& position, const RationalRow& normal) {
    add_contact(grasp, position, normal);
    grasp.contacts.back().of = body;
  };
  for (const std::size_t body : {0, 1}) {
    const int height = 2 * static_cast<int>(body);
    for (const int s : {-1, 1}) {
      for (const int t : {-1, 1}) {
        add(body, {s, t, height}, {0, 0, 1});
        if (body == 1) grasp.contacts.back().by = 0;
        if (at_wall) add(body, {-1, s, height + 1 + t}, {1, 0, 0});
      }
    }
  }
  return grasp;
}

TEST(ContactStates, ABoxOnABox) {
  const auto planes_of = [](const GraspBox& grasp, StateSet set) {
    return state_planes(motion_coordinates(grasp), contact_rows_for_states(grasp, {}), set);
  };
  for (const bool at_wall : {false, true}) {
    const StatePlanes planes = planes_of(box_on_box(at_wall), StateSet::kOpening);
    EXPECT_EQ(planes.coordinates, 12u);
    const std::vector<std::string> modes = test::checked_faces(12, planes.planes);
    EXPECT_EQ(modes, test::faces_by_programs(12, planes.planes));
    EXPECT_EQ(modes.size(), at_wall ? 2710u : 100u);
  }
  // Without a wall the boxes move beside each other as the lower one does beside the ground, so
  // that each has the modes of a cube on a floor, whatever those of the other are.
  const StatePlanes floor = planes_of(cube(1), StateSet::kContact);
  EXPECT_EQ(test::checked_faces(6, floor.planes), test::faces_by_programs(6, floor.planes));
  EXPECT_EQ(total(box_on_box(false), StateSet::kContact), 196u * 196u);
}

}  // namespace
}  // namespace stickslip
