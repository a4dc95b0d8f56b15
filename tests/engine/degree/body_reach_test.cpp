// SPDX-License-Identifier: GPL-3.0-or-later
// How far bodies of motions reach, against linear programs; and laws without some contacts,
// against laws of grasps without them.
#include "engine/degree/body_reach.hpp"

#include <gtest/gtest.h>

#include "random_grasps.hpp"
#include "stickslip/engine/force_span.hpp"
#include "stickslip/engine/grasp_law.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace body_reach_test {

using degree_detail::BodyReach;
using test::RandomSource;

RationalRow random_row(RandomSource& random, std::size_t size) {
  RationalRow row;
  for (std::size_t j = 0; j < size; ++j) row.emplace_back(random.between(-4, 4));
  return row;
}

/// Returns a body with so many independent rows, of a simplex with one more, which a sum with
/// numbers above 0 cancels; nothing if it drew dependent ones.
std::optional<ConvexBody> random_body(RandomSource& random, std::size_t size,
                                      std::size_t rank) {
  ConvexBody body;
  body.twist = random_row(random, size);
  for (std::size_t k = 0; k < rank; ++k) body.walls.push_back(random_row(random, size));
  if (rank_of(body.walls) < rank) return std::nullopt;
  body.is_simplex = random.between(0, 1) == 1;
  if (!body.is_simplex) return body;
  RationalRow last(size);
  for (const RationalRow& row : body.walls) {
    const Rational part(random.between(1, 5), 3);
    for (std::size_t j = 0; j < size; ++j) last[j] -= part * row[j];
  }
  body.walls.push_back(std::move(last));
  return body;
}

/// Returns the largest row.e by a linear program about e, across what no wall sees.
Rational by_program(const ConvexBody& body, const RationalRow& row) {
  LinearProgram program;
  program.add_variables(row.size(), VariableKind::kFree);
  for (const RationalRow& wall : body.walls) {
    program.add_row(wall, Relation::kLessEqual, 1);
    if (!body.is_simplex) program.add_row(wall, Relation::kGreaterEqual, -1);
  }
  for (const RationalRow& z : ForceSpan(row.size(), body.walls).free_motions()) {
    program.add_row(z, Relation::kEqual, 0);
  }
  RationalRow against;
  for (const Rational& entry : row) against.push_back(-entry);
  program.minimize(against);
  const LpResult result = solve(program);
  return -std::get<Optimal>(result).value;
}

TEST(BodyReach, IsWhatLinearProgramsFind) {
  RandomSource random(77);
  int simplices = 0;
  int flat = 0;
  for (int round = 0; round < 120; ++round) {
    const std::size_t size = 1 + static_cast<std::size_t>(random.between(0, 4));
    const std::size_t rank = 1 + static_cast<std::size_t>(round) % size;
    const auto body = random_body(random, size, rank);
    if (!body) continue;
    simplices += body->is_simplex ? 1 : 0;
    flat += rank < size ? 1 : 0;
    const BodyReach reach(*body);
    ASSERT_TRUE(reach.is_sound());
    for (int k = 0; k < 3; ++k) {
      const RationalRow row = random_row(random, size);
      EXPECT_EQ(reach.largest(row), by_program(*body, row));
    }
  }
  EXPECT_GE(simplices, 20);
  EXPECT_GE(flat, 20);
}

TEST(BodyReach, DependentRowsAreNoBody) {
  const ConvexBody body{{0, 0}, false, {{1, 2}, {2, 4}}};
  EXPECT_FALSE(BodyReach(body).is_sound());
}

TEST(BodyReach, WithoutWallsThereIsOneMotion) {
  const BodyReach reach(ConvexBody{{1, 2, 3}, false, {}});
  EXPECT_TRUE(reach.is_sound());
  EXPECT_EQ(reach.largest({5, -6, 7}), 0);
}

TEST(Without, IsTheLawOfTheGraspWithoutThem) {
  RandomSource random(5);
  for (int round = 0; round < 20; ++round) {
    GraspBox box =
        box_of(LoadedGrasp{test::generic_grasp(random, 6), test::small_wrench(random)});
    for (UncertainContact& c : box.contacts) {
      c.friction.high += Rational(random.between(0, 3), 10);
      c.position[0].high += Rational(random.between(0, 1), 10);
    }
    std::vector<ContactId> left_out;
    GraspBox less = box;
    less.contacts.clear();
    for (std::size_t i = 0; i < box.contacts.size(); ++i) {
      if (random.between(0, 2) == 0) {
        left_out.emplace_back(i);
      } else {
        less.contacts.push_back(box.contacts[i]);
      }
    }
    const GraspLaw found = GraspLaw(box, NormalLaw::kUnilateral).without(left_out);
    const GraspLaw expected(less, NormalLaw::kUnilateral);
    ASSERT_EQ(found.contacts.size(), expected.contacts.size());
    EXPECT_EQ(found.length, expected.length);
    ASSERT_EQ(found.parameters().size(), expected.parameters().size());
    for (std::size_t k = 0; k < expected.parameters().size(); ++k) {
      const ParameterId& id = expected.parameters()[k];
      EXPECT_EQ(found.parameters()[k].parameter, id.parameter);
      EXPECT_EQ(found.parameters()[k].index, id.index);
      EXPECT_EQ(found.interval(id).low, expected.interval(id).low);
      EXPECT_EQ(found.interval(id).high, expected.interval(id).high);
    }
    for (std::size_t i = 0; i < expected.contacts.size(); ++i) {
      EXPECT_EQ(found.contacts[i].separations, expected.contacts[i].separations);
    }
  }
}

}  // namespace body_reach_test
}  // namespace stickslip
