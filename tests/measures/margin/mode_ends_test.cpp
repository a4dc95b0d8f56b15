// SPDX-License-Identifier: GPL-3.0-or-later
// The ends of modes from their lines against exact linear programs over the modes' regions, and
// sums that are kept from mode to mode against sums over all contacts.
#include "measures/margin/mode_ends.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "family.hpp"
#include "random_grasps.hpp"
#include "rounds.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace margin_detail;

namespace {

using test::RandomSource;
using test::rounds;

std::optional<Problem> random_family(RandomSource& random, bool generic) {
  const auto contacts = static_cast<std::size_t>(random.between(1, generic ? 8 : 5));
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  const Grasp grasp = generic ? test::generic_grasp(random, contacts)
                              : test::degenerate_grasp(random, contacts);
  std::optional<Wrench> direction = test::small_wrench(random);
  if (direction == Wrench{}) direction->x = 1;
  std::optional<PreloadDirection> growth;
  LoadedGrasp loaded{grasp, test::planted_wrench(random, grasp, law)};
  if (random.one_in(3)) {
    growth = PreloadDirection{true, {}};
    if (random.one_in(2)) direction.reset();
  }
  try {
    return problem_of(test::margin_question(loaded, law, direction, growth)).within({});
  } catch (const InputError&) {  // no preload to scale
    return std::nullopt;
  }
}

Rational coordinate(RandomSource& random) {
  return Rational(random.between(-4, 4), random.between(1, 5));
}

/// Of a motion, some of which make contacts stick.
FamilyMode random_mode(RandomSource& random, const Problem& family) {
  Twist d{coordinate(random), coordinate(random), coordinate(random)};
  if (random.one_in(4)) d = {0, 0, 0};
  FamilyMode mode = modes_of(family.at(random.between(0, 3)), d);
  while (random.one_in(2)) {
    const auto stuck = static_cast<std::size_t>(random.between(0, 1000)) % mode.size();
    mode[stuck] = {true, Sign::kZero};
  }
  return mode;
}

/// The next one along a chain, or one that is no neighbour.
void change(RandomSource& random, FamilyMode& mode, NormalLaw law) {
  ContactMode& at = mode[static_cast<std::size_t>(random.between(0, 1000)) % mode.size()];
  if (law == NormalLaw::kUnilateral && random.one_in(3)) {
    at.closed = !at.closed;
  } else {
    at.slip = at.slip == Sign::kZero ? sign_of_int(random.one_in(2) ? 1 : -1) : Sign::kZero;
  }
}

std::array<Vector5, 3> naive_sum(const Problem& family, const FamilyMode& mode) {
  std::array<Vector5, 3> sum{};
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const ContactId contact(i);
    if (!mode[i].closed) continue;
    const Vector3 wrench = coordinates(family.edge_wrench(contact, -to_int(mode[i].slip)));
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 5; ++k)
        sum[j][k] += wrench[j] * family.separation(contact)[k];
    }
  }
  return sum;
}

/// What friction adds up to where contacts stick; each within its limit.
Wrench friction_at(const Problem& family, const FamilyMode& mode, const ModePoint& point) {
  Wrench sum;
  std::size_t before = 0;
  for (const auto& [i, b] : point.friction) {
    const ContactId contact(i);
    EXPECT_TRUE(sticks(family, mode, i));
    EXPECT_TRUE(&b == &point.friction.front().second || before < i);
    before = i;
    EXPECT_LE(abs(b), family.row(contact).friction * dot(family.separation(contact), point.x));
    sum += b * family.row(contact).tangent;
  }
  return sum;
}

struct Tally {
  std::size_t lines = 0;
  std::size_t resisting = 0;
  std::size_t unbounded = 0;
  std::size_t stuck = 0;   ///< lines with friction where contacts stick
  std::size_t shared = 0;  ///< that is shared by several
  std::size_t others = 0;
};

void expect_same(const Problem& family, const FamilyMode& mode, ModeLines& lines,
                 Tally& tally) {
  const std::optional<ModeEnds> found = lines.ends(mode);
  if (!lines.was_line()) {
    ++tally.others;
    return;
  }
  ++tally.lines;
  const std::optional<ModeEnds> expected = ends_by_programs(family, mode);
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) return;
  ++tally.resisting;
  tally.unbounded += found->high.x[3].is_zero() ? 1 : 0;
  tally.stuck += found->low.friction.empty() ? 0 : 1;
  const auto compare = [&](const ModePoint& point, const ModePoint& other) {
    EXPECT_EQ(point.x, other.x);
    EXPECT_EQ(friction_at(family, mode, point), friction_at(family, mode, other));
    ASSERT_EQ(point.friction.size(), other.friction.size());
    tally.shared += point.friction == other.friction ? 0 : 1;
  };
  compare(found->low, expected->low);
  compare(found->high, expected->high);
}

TEST(ModeEnds, LinesAgainstLinearPrograms) {
  for (const bool generic : {false, true}) {
    RandomSource random(generic ? 621 : 622);
    Tally tally;
    for (int round = 0; round < rounds(400); ++round) {
      const std::optional<Problem> family = random_family(random, generic);
      if (!family) continue;
      ModeLines lines(*family);
      FamilyMode mode = random_mode(random, *family);
      for (int step = 0; step < 12; ++step) {
        SCOPED_TRACE("round " + std::to_string(round) + ", step " + std::to_string(step));
        expect_same(*family, mode, lines, tally);
        if (random.one_in(4)) mode = random_mode(random, *family);
        change(random, mode, family->law());
      }
    }
    std::cout << (generic ? "generic: " : "degenerate: ") << tally.lines << " lines, "
              << tally.resisting << " resist, " << tally.unbounded << " without end, "
              << tally.stuck << " with friction that sticks, " << tally.shared
              << " ends where it is shared otherwise; " << tally.others << " no lines\n";
    EXPECT_GE(tally.lines, rounds(100U));
    EXPECT_GE(tally.resisting, rounds(20U));
    EXPECT_GE(tally.unbounded, rounds(4U));
    EXPECT_GE(tally.stuck, rounds(4U));
    EXPECT_GE(tally.others, rounds(20U));
  }
}

TEST(ModeEnds, SumsThatAreKept) {
  RandomSource random(623);
  for (int round = 0; round < rounds(60); ++round) {
    const std::optional<Problem> family = random_family(random, true);
    if (!family) continue;
    ForceSum sum(*family);
    FamilyMode mode = random_mode(random, *family);
    for (int step = 0; step < 20; ++step) {
      EXPECT_EQ(sum.of(mode), naive_sum(*family, mode));
      if (random.one_in(5)) mode = random_mode(random, *family);
      change(random, mode, family->law());
    }
  }
}

}  // namespace
}  // namespace stickslip
