// SPDX-License-Identifier: GPL-3.0-or-later
// Steps 1 to 3 of the paper against the arrangement: cell by cell where they agree, and what
// comes out where they do not. The cases are numbered in docs/paper_enumerator.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "families.hpp"
#include "stickslip/arrangement/arrangement_structure.hpp"
#include "stickslip/arrangement/paper_enumerator.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::describe;
using test::texts;
using ::testing::ElementsAre;

std::vector<std::string> sorted(std::vector<std::string> texts) {
  std::sort(texts.begin(), texts.end());
  return texts;
}

std::vector<std::string> facet_texts(const PaperEnumeration& found) {
  std::vector<std::string> result;
  for (const PaperFacet& facet : found.facets) result.push_back(to_string(facet.state));
  return result;
}

std::vector<std::string> line_texts(const PaperEnumeration& found) {
  std::vector<std::string> result;
  for (const PaperLine& line : found.lines.basis) result.push_back(to_string(line.state));
  if (found.lines.last) result.push_back(to_string(found.lines.last->state));
  return result;
}

template <class CellId>
std::vector<std::string> cell_texts(const ArrangementStructure& structure, std::size_t count) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(to_string(structure.signs(CellId(i))));
  }
  return sorted(std::move(result));
}

/// Cases 1 to 3: the same cells of each kind, each once, and the states of the reference but
/// for all-stick at rank 3.
void expect_agrees_with_arrangement(const std::vector<Vector3>& planes) {
  SCOPED_TRACE(describe(planes));
  const PaperEnumeration found = enumerate_slip_states_paper(planes);
  const SlipStates expected = enumerate_slip_states_cgal(planes);
  ASSERT_EQ(expected.counts.circles, planes.size()) << "the planes are not distinct";

  EXPECT_EQ(found.cells(), expected.counts.cells());
  EXPECT_EQ(found.lines.components, 1u);
  EXPECT_EQ(found.lines.last_is_one_cycle, planes.size() >= 2);

  const ArrangementStructure structure(planes);
  EXPECT_EQ(sorted(texts(found.regions)), cell_texts<FaceId>(structure, structure.faces()));
  EXPECT_EQ(sorted(facet_texts(found)), cell_texts<EdgeId>(structure, structure.edges()));
  EXPECT_EQ(sorted(line_texts(found)), cell_texts<VertexId>(structure, structure.vertices()));

  std::vector<SlipState> states = expected.states;
  if (expected.counts.rank == 3) states.pop_back();  // all-stick is the last
  EXPECT_EQ(found.states, states);
}

std::vector<Vector3> merged(const std::vector<Vector3>& planes) {
  std::vector<Vector3> result;
  for (const IntegerVector3& n : merge_planes(planes).normals) {
    result.push_back({n[0], n[1], n[2]});
  }
  return result;
}

/// Case 4.
void expect_falls_apart(const std::vector<Vector3>& planes) {
  SCOPED_TRACE(describe(planes));
  const GreatCircles circles = merge_planes(planes);
  std::vector<std::size_t> contacts_on(circles.normals.size(), 0);
  for (const CircleId c : circles.circle) ++contacts_on[c.index()];
  std::vector<Vector3> shared;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (contacts_on[circles.circle[p].index()] > 1) shared.push_back(planes[p]);
  }
  ASSERT_FALSE(shared.empty());
  const auto is_on_shared_plane = [&](const SlipState& state) {
    for (std::size_t p = 0; p < planes.size(); ++p) {
      if (state[p] == Sign::kZero && contacts_on[circles.circle[p].index()] > 1) return true;
    }
    return false;
  };

  const PaperEnumeration found = enumerate_slip_states_paper(planes);
  const ArrangementStructure structure(planes);
  EXPECT_EQ(sorted(texts(found.regions)), cell_texts<FaceId>(structure, structure.faces()));
  std::vector<std::string> facets;
  for (std::size_t e = 0; e < structure.edges(); ++e) {
    const SlipState state = structure.signs(EdgeId(e));
    if (!is_on_shared_plane(state)) facets.push_back(to_string(state));
  }
  EXPECT_EQ(sorted(facet_texts(found)), sorted(facets));
  std::vector<std::string> lines;
  for (std::size_t v = 0; v < structure.vertices(); ++v) {
    const SlipState state = structure.signs(VertexId(v));
    if (!is_on_shared_plane(state)) lines.push_back(to_string(state));
  }
  std::vector<std::string> basis;
  for (const PaperLine& line : found.lines.basis) basis.push_back(to_string(line.state));
  EXPECT_EQ(sorted(basis), sorted(lines));

  EXPECT_EQ(found.lines.components, ArrangementStructure(shared).faces());
  EXPECT_EQ(found.lines.basis.size(),
            found.facets.size() + found.lines.components - found.regions.size());
  EXPECT_EQ(found.lines.last.has_value(), !lines.empty());
  EXPECT_FALSE(found.lines.last_is_one_cycle);
  EXPECT_LT(found.cells(), structure.counts().cells());
  EXPECT_LT(found.states.size(), structure.counts().distinct_states);
}

/// One normal for each pair of opposite directions of the grid {-1,0,1}^3.
std::vector<Vector3> grid_directions() {
  std::vector<Vector3> result;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)))) result.push_back({x, y, z});
      }
    }
  }
  return result;
}

/// Calls visit with every multiset of m grid directions, in increasing order, some of them
/// turned around; with sets only if `distinct`.
template <class Visit>
void for_each_grid_choice(std::size_t m, bool distinct, Visit visit) {
  const std::vector<Vector3> directions = grid_directions();
  test::Random random(static_cast<std::uint32_t>(m));
  std::vector<std::size_t> chosen(m);
  const auto choose = [&](auto&& self, std::size_t position, std::size_t least) -> void {
    if (position == m) {
      std::vector<Vector3> planes;
      for (const std::size_t i : chosen) {
        planes.push_back(directions[i]);
        if (random.between(0, 1) == 1) {
          for (Rational& entry : planes.back()) entry = -entry;
        }
      }
      visit(planes);
      return;
    }
    for (std::size_t i = least; i < directions.size(); ++i) {
      chosen[position] = i;
      self(self, position + 1, distinct ? i + 1 : i);
    }
  };
  choose(choose, 0, 0);
}

// Table II counts 10 at m = 2, where only 3^2 sign vectors exist.
TEST(PaperSteps, TwoPlanesHaveOneCycleThatIsAlsoTheLastFace) {
  const std::vector<Vector3> planes = {{1, 2, 3}, {-1, 0, 4}};
  const PaperEnumeration found = enumerate_slip_states_paper(planes);
  ASSERT_EQ(found.lines.basis.size(), 1u);
  ASSERT_TRUE(found.lines.last.has_value());
  EXPECT_EQ(found.lines.last->facets, found.lines.basis.front().facets);
  EXPECT_EQ(to_string(found.lines.last->state), "00");
  EXPECT_EQ(found.cells(), 10u);
  EXPECT_EQ(found.states.size(), 9u);
  expect_agrees_with_arrangement(planes);
}

TEST(PaperSteps, TableII) {
  const std::size_t cells[] = {10, 26, 50, 82, 122, 170, 226, 290};
  for (std::size_t m = 2; m <= 9; ++m) {
    const std::vector<Vector3> planes = test::simple_planes(m, 11);
    EXPECT_EQ(enumerate_slip_states_paper(planes).cells(), cells[m - 2]);
    expect_agrees_with_arrangement(planes);
  }
}

TEST(PaperSteps, DistinctPlanesOfTheGridAgree) {
  for (std::size_t m = 0; m <= 4; ++m) {
    for_each_grid_choice(m, true, expect_agrees_with_arrangement);
  }
}

TEST(PaperSteps, RandomDistinctPlanesAgree) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    for (std::size_t m = 5; m <= 7; ++m) {
      expect_agrees_with_arrangement(test::simple_planes(m, seed));
      expect_agrees_with_arrangement(merged(test::grid_planes(m, 1, seed)));
      expect_agrees_with_arrangement(merged(test::grid_planes(m, 2, seed)));
      expect_agrees_with_arrangement(merged(test::axis_aligned_planes(m, 2, seed)));
      expect_agrees_with_arrangement(
          merged(test::near_grid_planes(m, 1, parse_rational("1e-30"), seed)));
    }
  }
}

// Large faces beside others: t planes through one axis, and one, two or three that are not.
TEST(PaperSteps, NearPencilsAgree) {
  for (std::size_t t = 3; t <= 6; ++t) {
    std::vector<Vector3> planes = test::pencil_planes(t, 4);
    for (const Vector3& n : {Vector3{7, 11, 100}, Vector3{-90, 17, 31}, Vector3{5, 83, -29}}) {
      planes.push_back(n);
      if (planes.size() <= 8) expect_agrees_with_arrangement(planes);
    }
  }
}

TEST(PaperSteps, CoincidentPlanesOfTheGridFallApart) {
  for (std::size_t m = 2; m <= 4; ++m) {
    for_each_grid_choice(m, false, [](const std::vector<Vector3>& planes) {
      if (merge_planes(planes).normals.size() < planes.size()) expect_falls_apart(planes);
    });
  }
}

TEST(PaperSteps, RandomCoincidentPlanesFallApartAndMergingMendsThem) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    const std::size_t m = 3 + seed % 4;
    std::vector<Vector3> planes =
        seed % 2 == 0 ? test::simple_planes(m, seed) : merged(test::grid_planes(m, 1, seed));
    const std::size_t copies = 1 + seed % 3;
    for (std::size_t i = 0; i < copies; ++i) {
      Vector3 n = planes[static_cast<std::size_t>(random.between(0, 2)) % planes.size()];
      const int scale = random.between(1, 3) * (random.between(0, 1) == 0 ? 1 : -1);
      for (Rational& entry : n) entry *= scale;
      planes.push_back(n);
    }
    expect_falls_apart(planes);
    expect_agrees_with_arrangement(merged(planes));
  }
}

TEST(PaperSteps, Fig4GraspGivesFourIsolatedRegions) {
  const std::vector<Vector3> planes = stick_planes(test::fig4_grasp());
  const PaperEnumeration found = enumerate_slip_states_paper(planes);
  EXPECT_THAT(texts(found.states), ElementsAre("++++", "++--", "--++", "----"));
  EXPECT_EQ(found.cells(), 4u);
  EXPECT_EQ(found.lines.components, 4u);
  expect_falls_apart(planes);
}

// Three planes that are not concurrent, and two contacts on a fourth: the sum of all cycles is
// the outline of both hemispheres. Its edges cross the first three planes only.
TEST(PaperSteps, TheLastFaceOfCoincidentPlanesCanBeAStateWithoutMotion) {
  const std::vector<Vector3> planes = {
      {1, 0, 1}, {-1, 2, 1}, {-1, -3, 1}, {0, 0, 1}, {0, 0, 1}};
  const PaperEnumeration found = enumerate_slip_states_paper(planes);
  ASSERT_TRUE(found.lines.last.has_value());
  EXPECT_FALSE(found.lines.last_is_one_cycle);
  EXPECT_EQ(to_string(found.lines.last->state), "000++");
  const std::vector<std::string> possible = texts(enumerate_slip_states_cgal(planes).states);
  EXPECT_FALSE(std::binary_search(possible.begin(), possible.end(), "000++"));
  expect_falls_apart(planes);
}

// Two planes and a doubled third: the outlines are the cycles themselves.
TEST(PaperSteps, TheLastFaceOfCoincidentPlanesCanRepeatAState) {
  const std::vector<Vector3> planes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  const PaperEnumeration found = enumerate_slip_states_paper(planes);
  ASSERT_TRUE(found.lines.last.has_value());
  ASSERT_EQ(found.lines.basis.size(), 2u);
  EXPECT_EQ(found.cells(), 8u + 8u + 3u);
  EXPECT_EQ(found.states.size(), 8u + 8u + 2u);
}

TEST(PaperSteps, WorkOfSimpleArrangements) {
  std::size_t programs = 0;
  for (std::size_t m = 0; m <= 8; ++m) {
    const std::size_t regions = m == 0 ? 1 : m * (m - 1) + 2;
    const std::vector<Vector3> planes = test::simple_planes(m, 2);
    const PaperEnumeration found = enumerate_slip_states_paper(planes);
    EXPECT_EQ(found.work.linear_programs, programs);
    EXPECT_EQ(found.work.pairs_compared, regions * (regions - 1) / 2);
    const std::size_t cycles = m < 2 ? 0 : m * (m - 1) - 1;
    EXPECT_EQ(found.lines.basis.size(), cycles);
    EXPECT_EQ(found.work.path_searches, cycles * (regions + 1));
    for (const PaperLine& line : found.lines.basis) EXPECT_EQ(line.facets.size(), 4u);
    programs += 2 * regions;

    const PaperEnumeration again = enumerate_slip_states_paper(planes);
    EXPECT_EQ(again.regions, found.regions);
    EXPECT_EQ(again.work.pivots, found.work.pivots);
    EXPECT_EQ(again.work.edges_scanned, found.work.edges_scanned);
  }
}

TEST(PaperSteps, ZeroNormalBreaksTheContract) {
  EXPECT_THROW(enumerate_slip_states_paper({{1, 0, 0}, {0, 0, 0}}), ContractError);
}

}  // namespace
}  // namespace stickslip
