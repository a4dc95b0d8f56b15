// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of arrangements in Q^D: against linear programs, Zaslavsky's count, the enumerators
// on the sphere, and known numbers.
#include "stickslip/arrangement/faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "faces_by_programs.hpp"
#include "families.hpp"
#include "rounds.hpp"
#include "stickslip/arrangement/sweep.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

using test::checked_faces;
using test::Random;

Row random_row(Random& random, std::size_t coordinates, int bound) {
  Row row(coordinates);
  for (Integer& entry : row) entry = random.between(-bound, bound);
  return row;
}

std::vector<FacePlane> random_planes(Random& random, std::size_t count, std::size_t coordinates,
                                     int bound) {
  std::vector<FacePlane> planes;
  for (std::size_t i = 0; i < count; ++i)
    planes.push_back({random_row(random, coordinates, bound)});
  return planes;
}

std::vector<Row> rows_of(const std::vector<FacePlane>& planes) {
  std::vector<Row> rows;
  for (const FacePlane& plane : planes) rows.push_back(plane.row);
  return rows;
}

/// The cells of an open decomposition of Q^D: the alternating sum is (-1)^D.
void expect_euler(const FaceCounts& counts) {
  std::int64_t sum = 0;
  std::int64_t sign = 1;
  for (const std::uint64_t number : counts.by_dimension) {
    sum += sign * static_cast<std::int64_t>(number);
    sign = -sign;
  }
  EXPECT_EQ(sum, -sign);
}

TEST(Faces, SmallWorldsAreThoseOfLinearPrograms) {
  Random random(1);
  for (int round = 0; round < test::rounds(120); ++round) {
    const auto coordinates = static_cast<std::size_t>(random.between(1, 4));
    const auto count = static_cast<std::size_t>(random.between(0, 6));
    const auto planes = random_planes(random, count, coordinates, random.between(1, 2));
    EXPECT_EQ(checked_faces(coordinates, planes), test::faces_by_programs(coordinates, planes))
        << "round " << round;
  }
}

TEST(Faces, OfConesTooWithPlanesThatCountOnFacets) {
  Random random(2);
  std::size_t hidden = 0;
  for (int round = 0; round < test::rounds(200); ++round) {
    const auto coordinates = static_cast<std::size_t>(random.between(1, 4));
    const auto asked = static_cast<std::size_t>(random.between(0, 4));
    const auto others = static_cast<std::size_t>(random.between(0, 3));
    auto planes = random_planes(random, asked + others, coordinates, random.between(1, 2));
    for (std::size_t i = 0; i < asked; ++i) {
      constexpr AllowedSigns kAllowed[] = {AllowedSigns::kNotNegative,
                                           AllowedSigns::kNotNegative, AllowedSigns::kZero,
                                           AllowedSigns::kPositive};
      planes[i].side = kAllowed[random.between(0, 3)];
    }
    for (std::size_t i = asked; i < planes.size() && asked > 0; ++i) {
      if (random.between(0, 3) > 0) {
        planes[i].where_zero =
            static_cast<std::size_t>(random.between(0, static_cast<int>(asked) - 1));
      }
    }
    const auto found = checked_faces(coordinates, planes);
    EXPECT_EQ(found, test::faces_by_programs(coordinates, planes)) << "round " << round;
    for (const std::string& signs : found)
      hidden += signs.find('.') != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(hidden, test::rounds(100u));
}

TEST(Faces, DegenerateOnesAreAsManyAsZaslavskyCounts) {
  Random random(3);
  for (int round = 0; round < test::rounds(60); ++round) {
    const auto coordinates = static_cast<std::size_t>(random.between(2, 6));
    const auto count = static_cast<std::size_t>(random.between(3, 9));
    const auto planes = random_planes(random, count, coordinates, 1);
    const FaceCounts counts = count_faces(coordinates, planes);
    EXPECT_EQ(counts.by_dimension, test::faces_by_restriction(coordinates, rows_of(planes)))
        << "round " << round;
    expect_euler(counts);
  }
}

TEST(Faces, OnTheSphereAreTheCellsOfTheSweep) {
  Random random(4);
  for (std::uint32_t round = 0; round < test::rounds(1000u); ++round) {
    const auto count = static_cast<std::size_t>(random.between(0, 9));
    const std::vector<Vector3> normals =
        round % 3 == 0   ? test::grid_planes(count, 1, round)
        : round % 3 == 1 ? test::axis_aligned_planes(count, 2, round)
                         : test::near_grid_planes(count, 1, Rational(1, 1000000000), round);
    std::vector<FacePlane> planes;
    for (const Vector3& normal : normals) {
      const IntegerVector3 row = primitive_multiple(normal);
      planes.push_back({row_of(row)});
    }
    std::vector<std::string> states;
    for (const SlipState& state : enumerate_slip_states_sweep(normals).states) {
      states.push_back(to_string(state));
    }
    std::sort(states.begin(), states.end());
    EXPECT_EQ(checked_faces(3, planes), states) << "round " << round;
  }
}

TEST(Faces, TwelveCoordinates) {
  std::vector<FacePlane> planes;
  for (std::size_t i = 0; i < 13; ++i) {
    Row row(12);
    for (std::size_t j = 0; j < 12; ++j) {
      if (i == 12 || i == j) row[j] = 1;
    }
    planes.push_back({row});
  }
  // Signs of the coordinates, 3^12, have three signs of the sum where + and - are among them.
  const FaceCounts counts = count_faces(12, planes);
  EXPECT_EQ(counts.total(), 3 * 531441u - 2 * (2 * 4096u - 1));
  expect_euler(counts);
}

/// Twenty planes in Q^6: the first `dependent` of rank 5, any others independent.
std::vector<FacePlane> twenty_planes(std::size_t dependent) {
  Random random(6);
  auto planes = random_planes(random, 20, 6, 1000);
  for (std::size_t i = 5; i < dependent; ++i) {
    Row sum(6);
    for (std::size_t k = 0; k < 5; ++k) {
      const int factor = random.between(1, 9);
      for (std::size_t j = 0; j < 6; ++j) sum[j] += factor * planes[k].row[j];
    }
    planes[i].row = sum;
  }
  return planes;
}

TEST(Faces, SixDependentRowsOfTwenty) {
  // In doubles 1,021,991 were found where any six of seven rows are dependent.
  for (const auto& [dependent, total] :
       {std::pair(0u, 1010577u), std::pair(6u, 1010453u), std::pair(7u, 1009937u)}) {
    const FaceCounts counts = count_faces(6, twenty_planes(dependent));
    EXPECT_EQ(counts.total(), total);
    expect_euler(counts);
  }
}

TEST(Faces, WorkIsReproducible) {
  Random random(7);
  const auto planes = random_planes(random, 12, 6, 1000);
  const FaceCounts counts = count_faces(6, planes);
  EXPECT_EQ(counts.total(), 54257u);
  EXPECT_EQ(counts.lines, 792u);  // C(12, 5): each once
  EXPECT_LT(counts.splits, counts.total());
  // Elimination finds six lines; of all others five planes are known to contain them.
  EXPECT_EQ(counts.signs, 6u * 12 + 786u * 7);
  EXPECT_GE(counts.exact_signs, 6u * 5);
  EXPECT_LT(counts.exact_signs, 6u * 6);
}

TEST(Faces, LinesAreComputedOnceForAllFacesOfACone) {
  // Two sides of a wedge with a line, which two planes on each side and on the line cut.
  const auto side = AllowedSigns::kNotNegative;
  const std::vector<FacePlane> planes{
      {{1, 0, 0}, side},
      {{0, 1, 0}, side},
      {{2, 3, 1}, AllowedSigns::kAny, 0},
      {{3, 5, 1}, AllowedSigns::kAny, 0},
      {{5, 2, 1}, AllowedSigns::kAny, 1},
      {{7, 3, 1}, AllowedSigns::kAny, 1},
  };
  const FaceCounts counts = count_faces(3, planes);
  EXPECT_EQ(checked_faces(3, planes), test::faces_by_programs(3, planes));
  // These are a ray of each side, the line of the wedge, and two lines on each side.
  EXPECT_EQ(counts.lines, 7u);
}

TEST(Faces, LongNumbersAreExact) {
  Random random(8);
  auto planes = random_planes(random, 8, 4, 1);
  const auto expected = checked_faces(4, planes);
  // A change of coordinates by long numbers changes no sign.
  const Integer huge("1234567890123456789012345678901234567890");
  for (FacePlane& plane : planes) {
    plane.row[0] = plane.row[0] * huge;
    plane.row[1] = plane.row[1] + plane.row[0];
  }
  EXPECT_EQ(checked_faces(4, planes), expected);
}

TEST(Faces, NearDependenciesAreNoDependencies) {
  const Integer large("1000000000000000000000");
  std::vector<FacePlane> planes{{{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}};
  const FaceCounts dependent = count_faces(3, planes);
  planes[2].row = {large, large, 1};
  const FaceCounts near = count_faces(3, planes);
  EXPECT_EQ(dependent.total(), 13u);
  EXPECT_EQ(near.total(), 27u);
  EXPECT_LT(near.near.distance, 1e-20);
  EXPECT_GT(near.near.distance, 0);
}

TEST(Faces, ChoicesAreThePartOfAllFacesThatTheySay) {
  Random random(9);
  for (int round = 0; round < test::rounds(30); ++round) {
    auto planes = random_planes(random, 7, 4, 1);
    for (std::size_t i = 0; i < 4; ++i) planes[i].side = AllowedSigns::kNotNegative;
    for (std::size_t i = 4; i < 7; ++i) planes[i].where_zero = i - 4;
    std::vector<std::string> expected;
    FaceOptions options;
    options.least_dimension = 1;
    options.most_dimension = 2;
    options.most_positive = 2;
    visit_faces(4, planes, [&](const Face& face) {
      const std::string signs = test::signs_of(face, planes.size());
      const auto positive = std::count(signs.begin(), signs.begin() + 4, '+');
      if (face.dimension() >= 1 && face.dimension() <= 2 && positive <= 2) {
        expected.push_back(signs);
      }
      return true;
    });
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(checked_faces(4, planes, options), expected) << "round " << round;
  }
}

TEST(Faces, AFaceThatIsNotTakenEndsTheWalk) {
  Random random(10);
  const auto planes = random_planes(random, 8, 4, 50);
  std::size_t seen = 0;
  const FaceCounts counts = visit_faces(4, planes, [&](const Face&) { return ++seen < 10; });
  EXPECT_EQ(seen, 10u);
  EXPECT_EQ(counts.total(), 9u);
  EXPECT_FALSE(counts.complete);
}

TEST(Faces, ThreadsShareTheCount) {
  Random random(12);
  auto planes = random_planes(random, 12, 6, 2);
  for (const AllowedSigns side : {AllowedSigns::kAny, AllowedSigns::kNotNegative}) {
    for (std::size_t i = 0; i < 4; ++i) planes[i].side = side;
    const FaceCounts expected = count_faces(6, planes);
    for (const unsigned threads : {0u, 2u, 5u}) {
      const FaceCounts counts = count_faces(6, planes, {}, threads);
      EXPECT_EQ(counts.by_dimension, expected.by_dimension);
      EXPECT_EQ(counts.splits, expected.splits);
      EXPECT_TRUE(counts.complete);
    }
  }
  FaceOptions options;
  options.go_on = [](std::uint64_t) { return false; };
  planes = random_planes(random, 16, 6, 99);
  EXPECT_FALSE(count_faces(6, planes, options, 2).complete);
  // The number that is told counts all threads, and never falls.
  std::uint64_t told = 0;
  options.go_on = [&](std::uint64_t found) { return std::exchange(told, found) <= found; };
  const FaceCounts counts = count_faces(6, planes, options, 2);
  EXPECT_TRUE(counts.complete);
  EXPECT_GT(told, counts.total() / 2);
  EXPECT_LE(told, counts.total());
}

/// Signs and motions of faces, a line each.
struct Texts : FaceBatch {
  explicit Texts(std::size_t number) : planes(number) {}
  void add(const Face& face) override {
    text += test::signs_of(face, planes);
    for (const Integer& entry : face.motion()) text += ' ' + entry.str();
    text += '\n';
  }
  std::size_t bytes() const override { return text.size(); }
  std::size_t planes;
  std::string text;
};

TEST(Faces, BatchesOfThreadsAreInTheOrderOfOne) {
  Random random(13);
  auto planes = random_planes(random, 12, 6, 2);
  const MakeFaceBatch make = [&] { return std::make_unique<Texts>(planes.size()); };
  for (const AllowedSigns side : {AllowedSigns::kAny, AllowedSigns::kNotNegative}) {
    for (std::size_t i = 0; i < 4; ++i) planes[i].side = side;
    Texts expected(planes.size());
    const FaceCounts counts = visit_faces(6, planes, [&](const Face& face) {
      expected.add(face);
      return true;
    });
    for (const unsigned threads : {1u, 2u, 5u}) {
      std::string text;
      const FaceCounts found = visit_faces_in_batches(
          6, planes, make,
          [&](FaceBatch& batch) {
            text += static_cast<Texts&>(batch).text;
            return true;
          },
          {}, threads);
      EXPECT_EQ(text, expected.text) << threads;
      EXPECT_EQ(found.by_dimension, counts.by_dimension);
      EXPECT_EQ(found.near.plane, counts.near.plane);
      EXPECT_EQ(found.near.distance, counts.near.distance);
      EXPECT_TRUE(found.complete);
      // Whoever takes batches may end the walk, and faces that were not handed over do not
      // count.
      std::size_t lines = 0;
      const FaceCounts ended = visit_faces_in_batches(
          6, planes, make,
          [&](FaceBatch& batch) {
            const std::string& some = static_cast<Texts&>(batch).text;
            lines += static_cast<std::size_t>(std::count(some.begin(), some.end(), '\n'));
            return lines < 1000;
          },
          {}, threads);
      EXPECT_FALSE(ended.complete);
      EXPECT_EQ(ended.total(), lines);
      EXPECT_LT(lines, counts.total());
      EXPECT_THROW(visit_faces_in_batches(
                       6, planes, make,
                       [&](FaceBatch&) -> bool { throw InputError("", "", "full", "stop"); },
                       {}, threads),
                   InputError);
    }
  }
}

TEST(Faces, WorkCanBeBrokenOff) {
  Random random(11);
  const auto planes = random_planes(random, 30, 6, 1000);
  const Cancellation cancellation([] { return true; });
  EXPECT_THROW(count_faces(6, planes), Cancelled);
  EXPECT_THROW(count_faces(6, planes, {}, 2), Cancelled);
}

TEST(Faces, ContractsAreChecked) {
  EXPECT_THROW(count_faces(13, {}), ContractError);
  EXPECT_THROW(count_faces(2, {{{1}}}), ContractError);
  std::vector<FacePlane> planes{{{1, 0}}, {{0, 1}}};
  planes[1].where_zero = 0;  // No sign of the first is asked for.
  EXPECT_THROW(count_faces(2, planes), ContractError);
  EXPECT_EQ(count_faces(0, {}).total(), 1u);
}

}  // namespace
}  // namespace stickslip
