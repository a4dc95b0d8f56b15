// SPDX-License-Identifier: MIT
// The two ways to bound a leaf: the rounded one is never below the exact one, and hardly above.
#include "bound.hpp"

#include <gtest/gtest.h>

#include "naive.hpp"

namespace stickslip_check {
namespace {

TEST(Bound, RoundedIsAboveExactAndClose) {
  Random random(99);
  std::size_t compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Row> rows;
    const int m = between(random, 1, 6);
    for (int i = 0; i < m; ++i) {
      GraspContact contact = random_contact(random);
      contact.position = {Rational(between(random, -99, 99), between(random, 1, 97)),
                          Rational(between(random, -99, 99), between(random, 1, 89))};
      contact.stiffness = Rational(between(random, 1, 99), between(random, 1, 83));
      for (Rational& c : contact.position) c.canonicalize();
      contact.stiffness.canonicalize();
      rows.push_back(make_row(contact).value());
    }
    const Vector3 w{Rational(between(random, -9, 9)), Rational(1, 3), Rational(-2, 7)};
    const Problem problem = make_problem(rows);
    std::vector<Status> status(rows.size());
    std::vector<std::size_t> undecided;
    Aggregate decided;
    std::map<std::size_t, Rational> thetas;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      status[i].gap = static_cast<Gap>(between(random, 0, 2));
      status[i].sign = static_cast<SlipSign>(between(random, 0, 2));
      if (status[i].gap == Gap::kClosed && status[i].sign != SlipSign::kNone) {
        add(decided, problem.contacts[i], status[i].sign);
      } else if (status[i].gap != Gap::kOpen) {
        undecided.push_back(i);
      }
      if (between(random, 0, 1) == 0) thetas[i] = Rational(between(random, 0, 3), 3);
    }
    for (auto& [i, theta] : thetas) theta.canonicalize();
    Vector3 y{Rational(between(random, -9, 9), between(random, 1, 9)), Rational(-3, 4),
              Rational(between(random, -9, 9))};
    y[0].canonicalize();
    const LeafBound bound(problem, w, status, undecided, decided, y, thetas);
    for (int k = 0; k < 5; ++k) {
      std::array<Integer, 4> x;
      for (std::size_t j = 0; j < 3; ++j) x[j] = between(random, -999, 999);
      x[3] = between(random, 0, 999);
      const Vector r = make_vector(x);
      const Rational exact = bound.exact(r);
      Rational rounded(bound.upper(r));
      rounded /= Rational(Integer(1) << static_cast<unsigned long>(problem.shift));
      EXPECT_GE(rounded, exact);
      // 2^64 against a few thousand contacts' worth of rounding errors.
      EXPECT_LE(rounded - exact, Rational(1, 100'000'000));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 1500U);
}

TEST(Bound, ShiftFollowsTheSmallestWeight) {
  GraspContact contact;
  contact.position = {0, 0};
  contact.normal = {1, 0};
  contact.stiffness = parse_decimal("1e-100").value();
  const Problem problem = make_problem({make_row(contact).value()});
  EXPECT_GE(problem.shift, 64U + 330U);
  EXPECT_GE(problem.contacts[0].plus.shifted[0], Integer(1) << 62U);
}

}  // namespace
}  // namespace stickslip_check
