// SPDX-License-Identifier: GPL-3.0-or-later
// PCR and PGR against all combinations of states, each by an exact linear program of another
// form and by minors of exact matrices; against closed forms, subset sums and invariance.
#include "stickslip/earlier/robustness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "both_checkers.hpp"
#include "random_source.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/grasp_map.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace {

using bench::RandomSource;
using Matrix = std::vector<RationalRow>;

UncertainContact finger(const RationalRow& p, const RationalRow& n, const Rational& friction,
                        const Rational& stiffness = 1) {
  UncertainContact c;
  for (const Rational& x : p) c.position.push_back(point_interval(x));
  c.normal = n;
  c.friction = point_interval(friction);
  c.stiffness = point_interval(stiffness);
  return c;
}

GraspBox grasp_of(std::vector<UncertainContact> contacts, const RationalRow& load) {
  GraspBox grasp{std::move(contacts), {}, {}};
  for (const Rational& w : load) grasp.wrench.push_back(point_interval(w));
  grasp.check();
  return grasp;
}

/// N and the rows of the tangents of one contact.
struct Rows {
  RationalRow normal;
  Matrix tangents;
  Rational mu;
  Rational stiffness;
};

std::vector<Rows> rows_of(const GraspBox& grasp, const Rational& length) {
  std::vector<Rows> result;
  for (const UncertainContact& c : grasp.contacts) {
    RationalRow n = c.normal;
    const Rational norm = *exact_sqrt(dot(n, n));
    for (Rational& x : n) x /= norm;
    Matrix tangents;
    if (n.size() == 2) {
      tangents = {{-n[1], n[0]}};
    } else {
      // Any orthonormal pair, here by the turn that takes z to n, or by hand for -z.
      if (n[2] == -1) {
        tangents = {{1, 0, 0}, {0, 1, 0}};
      } else {
        const Rational s = 1 / (1 + n[2]);
        tangents = {{1 - n[0] * n[0] * s, -n[0] * n[1] * s, -n[0]},
                    {-n[0] * n[1] * s, 1 - n[1] * n[1] * s, -n[1]}};
      }
    }
    const auto row = [&](const RationalRow& force) {
      RationalRow wrench = wrench_at(c.point(), force);
      for (std::size_t j = n.size(); j < wrench.size(); ++j) wrench[j] /= length;
      return wrench;
    };
    Rows rows{row(n), {}, c.friction.low, c.stiffness.low};
    for (const RationalRow& t : tangents) rows.tangents.push_back(row(t));
    result.push_back(std::move(rows));
  }
  return result;
}

RationalRow load_of(const GraspBox& grasp, const Rational& length) {
  RationalRow load;
  const std::size_t forces = grasp.in_space() ? 3 : 2;
  for (std::size_t j = 0; j < grasp.wrench.size(); ++j) {
    load.push_back(j < forces ? grasp.wrench[j].low : Rational(grasp.wrench[j].low / length));
  }
  return load;
}

/// The largest least distance in the plane, or with the friction of a polygon around the disc
/// in space, by variables that are the forces themselves. Nothing if that is below 0.
std::optional<Rational> most_distance(const std::vector<Rows>& rows, const RationalRow& load,
                                      const std::vector<SpringState>& states,
                                      const std::vector<Rational>& f, bool root_up) {
  LinearProgram program;
  const std::size_t d = program.add_variable(VariableKind::kNonNegative);
  std::vector<RationalRow> balance(load.size(), RationalRow(1));
  struct Bound {
    RationalRow row;
    Rational right;
  };
  std::vector<Bound> bounds;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (states[i] == SpringState::kDetached) continue;
    const bool sticks = states[i] == SpringState::kStick;
    const std::size_t normal = program.add_variable(VariableKind::kFree);
    for (std::size_t j = 0; j < load.size(); ++j) balance[j].push_back(rows[i].normal[j]);
    std::vector<std::size_t> tangents;
    if (sticks) {
      for (const RationalRow& t : rows[i].tangents) {
        tangents.push_back(program.add_variable(VariableKind::kFree));
        for (std::size_t j = 0; j < load.size(); ++j) balance[j].push_back(t[j]);
      }
    }
    const auto at_most = [&](const std::vector<std::pair<std::size_t, Rational>>& terms,
                             const Rational& right) {
      RationalRow row(program.variable_count());
      for (const auto& [variable, factor] : terms) row[variable] += factor;
      bounds.push_back({std::move(row), right});
    };
    at_most({{d, 1}, {normal, -1}}, 0);
    at_most({{d, 1}, {normal, 1}}, f[f.size() == 1 ? 0 : i]);
    if (!sticks) continue;
    const ShortRoot enclosed = short_sqrt(1 + rows[i].mu * rows[i].mu, 60);
    const Rational root = root_up ? enclosed.upper : enclosed.lower;
    if (tangents.size() == 1) {
      for (const int sign : {1, -1}) {
        at_most({{d, root}, {tangents[0], sign}, {normal, -rows[i].mu}}, 0);
      }
      continue;
    }
    // Half planes around the disc, with unit normals.
    for (int k = 0; k < 12; ++k) {
      const Rational t(k % 3, 4);
      Rational c = (1 - t * t) / (1 + t * t);
      Rational s = 2 * t / (1 + t * t);
      for (int quarter = k / 3; quarter > 0; --quarter) {
        std::swap(c, s);
        c = -c;
      }
      at_most({{d, root}, {tangents[0], c}, {tangents[1], s}, {normal, -rows[i].mu}}, 0);
    }
  }
  program.minimize({-1});
  for (std::size_t j = 0; j < load.size(); ++j) {
    program.add_row(balance[j], Relation::kEqual, -load[j]);
  }
  for (const Bound& bound : bounds) {
    program.add_row(bound.row, Relation::kLessEqual, bound.right);
  }
  const LpResult result = solve(program);
  if (const auto* best = std::get_if<Optimal>(&result)) return -best->value;
  return std::nullopt;
}

Rational determinant(Matrix a) {
  Rational result = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < a.size() && a[pivot][k].is_zero()) ++pivot;
    if (pivot == a.size()) return 0;
    if (pivot != k) {
      std::swap(a[pivot], a[k]);
      result = -result;
    }
    result *= a[k][k];
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      const Rational factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < a.size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return result;
}

/// Sylvester's criterion.
bool is_definite(const Matrix& a) {
  for (std::size_t n = 1; n <= a.size(); ++n) {
    Matrix minor;
    for (std::size_t j = 0; j < n; ++j) {
      minor.emplace_back(a[j].begin(), a[j].begin() + static_cast<std::ptrdiff_t>(n));
    }
    if (determinant(std::move(minor)).sign() <= 0) return false;
  }
  return true;
}

/// Returns whether 1/sigma_max(K G^T (G K G^T)^-1)^2 > square, for these states.
bool is_stiffer(const std::vector<Rows>& rows, const std::vector<SpringState>& states,
                const Rational& square) {
  const std::size_t n = rows.front().normal.size();
  Matrix a(n, RationalRow(n));
  Matrix b(n, RationalRow(n));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (states[i] == SpringState::kDetached) continue;
    Matrix columns{rows[i].normal};
    if (states[i] == SpringState::kStick) {
      columns.insert(columns.end(), rows[i].tangents.begin(), rows[i].tangents.end());
    }
    for (const RationalRow& x : columns) {
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < n; ++k) {
          a[j][k] += rows[i].stiffness * x[j] * x[k];
          b[j][k] += rows[i].stiffness * rows[i].stiffness * x[j] * x[k];
        }
      }
    }
  }
  if (determinant(a).is_zero()) return false;
  // sigma_max^2 is the largest value of A^-1 B A^-1, which is below 1/square iff A^2 - square B
  // is positive definite.
  Matrix rest(n, RationalRow(n));
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t l = 0; l < n; ++l) rest[j][k] += a[j][l] * a[l][k];
      rest[j][k] -= square * b[j][k];
    }
  }
  return is_definite(rest);
}

/// Checks the forces of an answer by its definition.
void check_evidence(const GraspBox& grasp, const RobustnessOptions& options,
                    const Robustness& found) {
  EXPECT_LE(found.lower, found.upper);
  if (!found.best) {
    EXPECT_EQ(found.lower, 0);
    return;
  }
  const RobustForces& best = *found.best;
  ASSERT_GT(best.distance, 0);
  EXPECT_LE(found.lower * found.lower, best.distance * best.distance * best.inverse_square);
  RationalRow sum;
  for (const Interval& w : grasp.wrench) sum.push_back(w.low);
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const UncertainContact& c = grasp.contacts[i];
    const RationalRow wrench = wrench_at(c.point(), best.forces[i]);
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += wrench[j];
    const Rational normal =
        dot(best.forces[i], c.normal) / *exact_sqrt(dot(c.normal, c.normal));
    const Rational friction = dot(best.forces[i], best.forces[i]) - normal * normal;
    if (best.states[i] == SpringState::kDetached) {
      EXPECT_EQ(normal, 0);
      EXPECT_EQ(friction, 0);
      continue;
    }
    EXPECT_GE(normal, best.distance);
    EXPECT_GE(options.most_forces[options.most_forces.size() == 1 ? 0 : i] - normal,
              best.distance);
    if (best.states[i] == SpringState::kSlip) {
      EXPECT_EQ(friction, 0);
      continue;
    }
    // (mu c_n - |c_t|)^2 >= (1 + mu^2) d^2 and mu c_n >= |c_t|, without roots.
    const Rational mu = c.friction.low;
    const Rational root = short_sqrt(1 + mu * mu, 64).upper;
    const Rational room = mu * normal - root * best.distance;
    EXPECT_GE(room, 0);
    EXPECT_LE(friction, room * room);
  }
  for (const Rational& x : sum) EXPECT_EQ(x, 0);
  const std::vector<Rows> rows = rows_of(grasp, options.length);
  EXPECT_TRUE(is_stiffer(rows, best.states, best.inverse_square * Rational(999999, 1000000)));
}

/// Has the checkers accept both bounds. All prunes of the search are leaves of the certificate.
void expect_proved(const GraspBox& grasp, RobustnessKind kind, const RobustnessOptions& options,
                   const Robustness& found) {
  std::string forces;
  for (const Rational& f : options.most_forces) {
    forces += (forces.empty() ? "" : ",") + to_string(f);
  }
  test::CheckerInput input;
  input.grasp = write_grasp(AnyGrasp(grasp));
  input.certificate = robustness_certificate_text(ask(parse_any_grasp(input.grasp, "grasp")),
                                                  kind, options, found, "tests");
  input.robustness = {"--robustness", kind == RobustnessKind::kContact ? "contact" : "grasp",
                      "--length",     to_string(options.length),
                      "--max-force",  forces};
  test::expect_accepted_by_both(input);
}

/// The combinations of states of m contacts.
std::vector<std::vector<SpringState>> combinations(std::size_t m) {
  std::vector<std::vector<SpringState>> result{{}};
  for (std::size_t i = 0; i < m; ++i) {
    std::vector<std::vector<SpringState>> longer;
    for (const std::vector<SpringState>& states : result) {
      for (const SpringState s :
           {SpringState::kStick, SpringState::kSlip, SpringState::kDetached}) {
        longer.push_back(states);
        longer.back().push_back(s);
      }
    }
    result = std::move(longer);
  }
  return result;
}

/// Compares both measures of a grasp with all combinations. Returns whether PGR is above 0.
bool compare_with_all(const GraspBox& grasp, const RobustnessOptions& options) {
  const Robustness contact = potential_contact_robustness(grasp, options);
  const Robustness whole = potential_grasp_robustness(grasp, options);
  check_evidence(grasp, options, contact);
  check_evidence(grasp, options, whole);
  expect_proved(grasp, RobustnessKind::kContact, options, contact);
  expect_proved(grasp, RobustnessKind::kGrasp, options, whole);
  EXPECT_TRUE(contact.is_complete);
  EXPECT_TRUE(whole.is_complete);
  EXPECT_LE(whole.upper, (1 + options.accuracy) * whole.lower);
  EXPECT_EQ(contact.balances, whole.balances);
  const std::vector<Rows> rows = rows_of(grasp, options.length);
  const RationalRow load = load_of(grasp, options.length);
  for (const std::vector<SpringState>& states : combinations(rows.size())) {
    // With roots rounded down there are more forces, so that the bound is to hold for these
    // nearly.
    const std::optional<Rational> d =
        most_distance(rows, load, states, options.most_forces, true);
    if (!d || d->is_zero()) continue;
    // The value is above the upper bound iff 1/sigma_max^2 > (upper / d)^2.
    EXPECT_FALSE(is_stiffer(rows, states, whole.upper * whole.upper / (*d * *d)));
    if (states == std::vector<SpringState>(rows.size(), SpringState::kStick)) {
      EXPECT_FALSE(is_stiffer(rows, states, contact.upper * contact.upper / (*d * *d)));
      EXPECT_GE(whole.upper, contact.lower);
    }
  }
  return whole.lower.sign() > 0;
}

Rational small(RandomSource& random, int most) {
  return random.between(-most, most);
}

/// Contacts on small grids with axis normals, where ties are the rule, or at random.
GraspBox planar_grasp(RandomSource& random, std::size_t m, bool degenerate) {
  static const RationalRow kTurned{Rational(3, 5), Rational(4, 5)};
  std::vector<UncertainContact> contacts;
  for (std::size_t i = 0; i < m; ++i) {
    RationalRow n{1, 0};
    if (!degenerate && random.one_in(2)) n = kTurned;
    for (int turns = random.between(0, 3); turns > 0; --turns) n = {-n[1], n[0]};
    RationalRow p{-n[0], -n[1]};
    const Rational aside = small(random, degenerate ? 1 : 4) / (degenerate ? 1 : 4);
    p[0] -= aside * n[1];
    p[1] += aside * n[0];
    const Rational mu = random.one_in(8) && degenerate ? Rational(0)
                        : random.one_in(2)             ? Rational(3, 4)
                                                       : Rational(1, 2);
    contacts.push_back(finger(p, n, mu, random.one_in(6) ? 3 : 1));
  }
  RationalRow load(3);
  if (random.one_in(2)) load = {small(random, 1) / 4, small(random, 2) / 4, 0};
  return grasp_of(std::move(contacts), load);
}

TEST(Robustness, IsThatOfAllCombinationsInThePlane) {
  RandomSource random(60);
  int positive = 0;
  for (int round = 0; round < 66; ++round) {
    SCOPED_TRACE(round);
    // The last six have more contacts.
    const std::size_t m =
        static_cast<std::size_t>(round < 60 ? random.between(2, 5) : random.between(6, 7));
    RobustnessOptions options;
    options.accuracy = {1, round % 2 == 0 ? 100 : 10000};
    options.length = round % 3 == 0 ? 2 : 1;
    if (round % 5 == 0) options.most_forces = {{3, 2}};
    if (round % 5 == 1) {
      options.most_forces.clear();
      for (std::size_t i = 0; i < m; ++i)
        options.most_forces.emplace_back(random.between(1, 3));
    }
    if (compare_with_all(planar_grasp(random, m, round % 2 == 0), options)) ++positive;
  }
  EXPECT_GE(positive, 12);
  // Stiff contacts with a short lever take all of a torque, so that the grasp is less robust with
  // them: 1/sigma^2 does not grow with contacts where stiffnesses differ.
  const Rational mu(3, 4);
  const GraspBox lever =
      grasp_of({finger({-1, 0}, {1, 0}, mu), finger({1, 0}, {-1, 0}, mu),
                finger({0, Rational(-1, 10)}, {0, 1}, mu, 10000),
                finger({0, Rational(1, 10)}, {0, -1}, mu, 10000)},
               RationalRow(3));
  EXPECT_TRUE(compare_with_all(lever, {}));
  const Robustness stuck = potential_contact_robustness(lever);
  EXPECT_LT(stuck.upper * Rational(5, 2), potential_grasp_robustness(lever).lower);
}

TEST(Robustness, IsThatOfAllCombinationsInSpace) {
  RandomSource random(61);
  int positive = 0;
  for (int round = 0; round < 60 && positive < 8; ++round) {
    SCOPED_TRACE(round);
    std::vector<UncertainContact> contacts;
    const std::size_t m = static_cast<std::size_t>(random.between(3, 5));
    for (std::size_t i = 0; i < m; ++i) {
      RationalRow n{0, 0, 0};
      n[static_cast<std::size_t>(random.between(0, 2))] = random.one_in(2) ? 1 : -1;
      if (random.one_in(3)) n = {Rational(2, 3), Rational(-1, 3), Rational(2, 3)};
      if (random.one_in(3)) n = {Rational(-2, 3), Rational(1, 3), Rational(2, 3)};
      RationalRow p;
      for (const Rational& x : n) p.push_back(-x + small(random, 2) / 4);
      contacts.push_back(finger(p, n, random.one_in(2) ? Rational(3, 4) : Rational(2)));
    }
    const GraspBox grasp = grasp_of(std::move(contacts), RationalRow(6));
    const Robustness whole = potential_grasp_robustness(grasp);
    if (whole.lower.is_zero()) continue;
    ++positive;
    const Robustness one = potential_contact_robustness(grasp);
    check_evidence(grasp, {}, whole);
    check_evidence(grasp, {}, one);
    expect_proved(grasp, RobustnessKind::kGrasp, {}, whole);
    expect_proved(grasp, RobustnessKind::kContact, {}, one);
    EXPECT_TRUE(whole.is_complete);
    EXPECT_LE(one.upper, one.lower * Rational(100001, 100000));
    EXPECT_LE(one.lower, whole.upper);
    // The polygon around the disc has more forces by at most 1/cos of half of an angle.
    const std::vector<Rows> rows = rows_of(grasp, 1);
    for (const std::vector<SpringState>& states : combinations(m)) {
      const std::optional<Rational> d = most_distance(rows, RationalRow(6), states, {1}, true);
      if (!d || d->is_zero()) continue;
      const Rational most = whole.upper * Rational(11, 10) / *d;
      EXPECT_FALSE(is_stiffer(rows, states, most * most));
    }
    // And what is found is not above the polygon's.
    const std::optional<Rational> d =
        most_distance(rows, RationalRow(6), whole.best->states, {1}, false);
    ASSERT_TRUE(d.has_value());
    EXPECT_LE(whole.best->distance, *d);
  }
  EXPECT_EQ(positive, 8);
}

/// The grasp of docs/measures.md, theorem 3: its PGR is sqrt(1/2) iff some of the numbers add
/// up to `sum`, which is not 0, and less otherwise.
GraspBox subset_sum_grasp(const std::vector<int>& numbers, int sum) {
  const Rational mu(20, 99);
  const Rational half(sum, 2);
  std::vector<UncertainContact> contacts{finger({0, half}, {1, 0}, mu),
                                         finger({0, -half}, {-1, 0}, mu)};
  int far = 1 + std::abs(sum);
  for (const int a : numbers) far += std::abs(a);
  for (const int side : {far, -far}) {
    contacts.push_back(finger({side, 0}, {0, 1}, mu));
    contacts.push_back(finger({side, 0}, {0, -1}, mu));
  }
  for (const int a : numbers) {
    contacts.push_back(finger({a, 0}, {0, 1}, mu));
    contacts.push_back(finger({0, 0}, {0, -1}, mu));
  }
  return grasp_of(std::move(contacts), RationalRow(3));
}

TEST(Robustness, DecidesSubsetSums) {
  RandomSource random(62);
  int yes = 0;
  int no = 0;
  for (int round = 0; round < 14; ++round) {
    std::vector<int> numbers{-5, round == 0 ? 2 : 4};
    int sum = -3;
    if (round >= 2) {
      numbers.assign(static_cast<std::size_t>(random.between(1, 3)), 0);
      for (int& a : numbers) a = random.between(-6, 6);
      sum = random.between(1, 7);
    }
    bool has_subset = false;
    int size = 1 + std::abs(sum);
    for (const int a : numbers) size += std::abs(a);
    size *= 5;  // above the sum of the magnitudes of all torques
    for (unsigned subset = 1; subset < 1U << numbers.size(); ++subset) {
      int total = 0;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if ((subset >> i & 1U) != 0) total += numbers[i];
      }
      has_subset = has_subset || total == sum;
    }
    SCOPED_TRACE(testing::Message()
                 << round << ": sum " << sum << " of " << testing::PrintToString(numbers));
    RobustnessOptions options;
    options.accuracy = {1, 4 * size};
    const GraspBox grasp = subset_sum_grasp(numbers, sum);
    const Robustness found = potential_grasp_robustness(grasp, options);
    check_evidence(grasp, options, found);
    expect_proved(grasp, RobustnessKind::kGrasp, options, found);
    EXPECT_TRUE(found.is_complete);
    const Rational just_below = Rational(1, 2) - Rational(1, 1000000000);
    EXPECT_EQ(found.lower * found.lower > just_below, has_subset);
    EXPECT_EQ(found.upper * found.upper >= Rational(1, 2), has_subset);
    ++(has_subset ? yes : no);
    if (round < 2) {
      EXPECT_EQ(has_subset, round == 0);
    }
  }
  EXPECT_GE(yes, 3);
  EXPECT_GE(no, 3);
}

/// Returns whether the value is between the bounds, which are near it, to 4 digits.
void expect_near(const Robustness& found, double value) {
  EXPECT_TRUE(found.is_complete);
  EXPECT_LE(to_double(found.lower), value * 1.0005);
  EXPECT_GE(to_double(found.upper), value * 0.9995);
}

TEST(Robustness, TheGraspsOfTheDocumentation) {
  // A jaw, and fingers that immobilise the object, which PCR and PGR like less.
  const Rational mu(5, 12);
  const RationalRow none(3);
  const Robustness jaw = potential_grasp_robustness(
      grasp_of({finger({2, 1}, {-1, 0}, mu), finger({2, -1}, {-1, 0}, mu),
                finger({-2, -2}, {1, 0}, mu), finger({-2, 2}, {1, 0}, mu)},
               none));
  expect_near(jaw, 5.0 / 9);
  expect_near(potential_grasp_robustness(
                  grasp_of({finger({2, 1}, {-1, 0}, mu), finger({-2, 2}, {0, -1}, mu),
                            finger({1, -2}, {0, 1}, mu), finger({-2, 2}, {1, 0}, mu)},
                           none)),
              0.3397);
  // Another contact does not lower PGR, though with it the grasp is not stable.
  std::vector<UncertainContact> fingers{finger({0, -2}, {0, -1}, {12, 5}),
                                        finger({-1, 0}, {-1, 0}, {12, 5})};
  expect_near(potential_grasp_robustness(grasp_of(fingers, {0, -1, 0})), 0.1198);
  fingers.push_back(finger({2, -2}, {0, 1}, {12, 5}));
  const GraspBox more = grasp_of(fingers, {0, -1, 0});
  const Robustness found = potential_grasp_robustness(more);
  expect_near(found, 0.1198);
  ASSERT_TRUE(found.best.has_value());
  EXPECT_EQ(found.best->states[2], SpringState::kDetached);
  EXPECT_LT(potential_contact_robustness(more).upper, found.lower);
}

TEST(Robustness, StatesOfRigidMotions) {
  // The example of docs/measures.md: two supports and a finger on top that is weak.
  const GraspBox example =
      grasp_of({finger({1, -1}, {0, 1}, {3, 4}), finger({-1, -1}, {0, 1}, {3, 4}),
                finger({0, 1}, {0, -1}, {3, 4})},
               {0, -1, 0});
  RobustnessOptions weak;
  weak.most_forces = {1, 1, {1, 8}};
  expect_near(potential_contact_robustness(example, weak), 0.07537);
  expect_near(rigid_motion_robustness(example, weak), 0.2621);
  RandomSource random(64);
  int loaded = 0;
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE(round);
    const GraspBox grasp =
        planar_grasp(random, static_cast<std::size_t>(random.between(3, 5)), round % 2 == 0);
    const Robustness one = potential_contact_robustness(grasp);
    const Robustness rigid = rigid_motion_robustness(grasp);
    const Robustness whole = potential_grasp_robustness(grasp);
    check_evidence(grasp, {}, rigid);
    EXPECT_GE(rigid.upper, one.lower);
    EXPECT_LE(rigid.lower, whole.upper);
    bool has_friction = true;
    for (const UncertainContact& c : grasp.contacts) {
      has_friction = has_friction && !c.friction.low.is_zero();
    }
    const bool is_loaded = std::any_of(grasp.wrench.begin(), grasp.wrench.end(),
                                       [](const Interval& w) { return !w.low.is_zero(); });
    if (is_loaded) {
      ++loaded;
    } else if (has_friction) {
      EXPECT_LE(rigid.lower, one.upper);  // for w = 0 it is PCR
    }
    // Motions at random have no other states, and all that are found are among the best.
    const std::vector<Rows> rows = rows_of(grasp, 1);
    if (!one.has_full_rank) continue;
    for (int motion = 0; motion < 20; ++motion) {
      const RationalRow y{small(random, 2), small(random, 2), small(random, 2)};
      std::vector<SpringState> states;
      for (const Rows& r : rows) {
        states.push_back(dot(r.normal, y).sign() > 0       ? SpringState::kDetached
                         : dot(r.tangents[0], y).is_zero() ? SpringState::kStick
                                                           : SpringState::kSlip);
      }
      const std::optional<Rational> d =
          most_distance(rows, load_of(grasp, 1), states, {1}, true);
      if (!d || d->is_zero()) continue;
      EXPECT_FALSE(is_stiffer(rows, states, rigid.upper * rigid.upper / (*d * *d)));
    }
  }
  EXPECT_GE(loaded, 5);
}

TEST(Robustness, LimitsAndOrder) {
  RandomSource random(63);
  for (int round = 0; round < 6; ++round) {
    GraspBox grasp = planar_grasp(random, 7, false);
    RobustnessOptions few;
    few.node_limit = static_cast<std::size_t>(round);
    const Robustness cut = potential_grasp_robustness(grasp, few);
    const Robustness whole = potential_grasp_robustness(grasp);
    // Bounds of a search that ended early are right, too.
    EXPECT_LE(cut.lower, whole.upper);
    EXPECT_GE(cut.upper, whole.lower);
    EXPECT_EQ(cut.is_complete, cut.upper <= Rational(101, 100) * cut.lower);
    check_evidence(grasp, few, cut);
    expect_proved(grasp, RobustnessKind::kGrasp, few, cut);
    // The order of contacts does not matter.
    std::reverse(grasp.contacts.begin(), grasp.contacts.end());
    const Robustness other = potential_grasp_robustness(grasp);
    EXPECT_LE(other.lower, whole.upper);
    EXPECT_GE(other.upper, whole.lower);
  }
}

TEST(Robustness, ClosedForms) {
  // Two fingers pinch: with E = ker G the only internal force is along the line, c_n = s. Its
  // distances are min(mu s / sqrt(1 + mu^2), f - s), so d = f / (1 + sqrt(1 + mu^2) / mu), and
  // M = diag(2, 2, 2): for mu = 3/4, d = 1 / (1 + 5/3) = 3/8 and PCR = 3/8 sqrt 2.
  const GraspBox pinch = grasp_of(
      {finger({-1, 0}, {1, 0}, {3, 4}), finger({1, 0}, {-5, 0}, {3, 4})}, RationalRow(3));
  const Robustness found = potential_contact_robustness(pinch);
  ASSERT_TRUE(found.best.has_value());
  EXPECT_EQ(found.best->distance, Rational(3, 8));
  EXPECT_LE(found.lower * found.lower, Rational(9, 32));
  EXPECT_GE(found.upper * found.upper, Rational(9, 32));
  EXPECT_LE(found.upper, found.lower * (1 + Rational(1, 1000000000)));
  // Three units of force scale it by three.
  RobustnessOptions strong;
  strong.most_forces = {3};
  EXPECT_EQ(potential_contact_robustness(pinch, strong).best->distance, Rational(9, 8));
  // A weight of 1/2 across the pinch leaves friction of 1/4 each: d = (3/4 s - 1/4) 4/5.
  const GraspBox held = grasp_of(
      {finger({-1, 0}, {1, 0}, {3, 4}), finger({1, 0}, {-5, 0}, {3, 4})}, {0, {-1, 2}, 0});
  EXPECT_EQ(potential_contact_robustness(held).best->distance, Rational(1, 4));
}

TEST(GraspMap, SingularValuesAndDeterminant) {
  RandomSource random(65);
  int full = 0;
  for (int round = 0; round < 20; ++round) {
    const GraspBox grasp =
        planar_grasp(random, static_cast<std::size_t>(random.between(1, 5)), round % 2 == 0);
    const Rational length = round % 3 == 0 ? 2 : 1;
    const GraspMapMeasures found = grasp_map_measures(grasp, length);
    Matrix square(3, RationalRow(3));
    for (const Rows& rows : rows_of(grasp, length)) {
      Matrix columns{rows.normal};
      if (!rows.mu.is_zero()) columns.push_back(rows.tangents[0]);
      for (const RationalRow& x : columns) {
        for (std::size_t j = 0; j < 3; ++j) {
          for (std::size_t k = 0; k < 3; ++k) square[j][k] += x[j] * x[k];
        }
      }
    }
    EXPECT_EQ(found.determinant, determinant(square));
    // Whether all eigenvalues are above `shift`, for the sign 1, or below it, for -1.
    const auto are_beyond = [&](const Rational& shift, int sign) {
      Matrix rest = square;
      for (std::size_t j = 0; j < 3; ++j) {
        rest[j][j] -= shift;
        for (std::size_t k = 0; k < 3; ++k) rest[j][k] *= sign;
      }
      return is_definite(rest);
    };
    const Rational more(1000001, 1000000);
    EXPECT_FALSE(are_beyond(found.least_square.high * more, 1));
    EXPECT_TRUE(are_beyond(found.largest_square.high * more, -1));
    EXPECT_FALSE(are_beyond(found.largest_square.low / more, -1));
    EXPECT_EQ(found.determinant.is_zero(), found.least_square.high.is_zero());
    if (found.determinant.is_zero()) continue;
    ++full;
    EXPECT_TRUE(are_beyond(found.least_square.low / more, 1));
    EXPECT_LE(found.least_square.high, found.least_square.low * more);
    EXPECT_LE(found.largest_square.high, found.largest_square.low * more);
  }
  EXPECT_GE(full, 8);
}

TEST(Robustness, WhatHasNoValue) {
  const auto fingers = [](const Rational& mu, const RationalRow& load) {
    return grasp_of({finger({-1, 0}, {1, 0}, mu), finger({1, 0}, {-1, 0}, mu)}, load);
  };
  // More than friction can carry.
  const Robustness heavy = potential_grasp_robustness(fingers({1, 2}, {0, -2, 0}));
  EXPECT_FALSE(heavy.balances);
  EXPECT_EQ(heavy.upper, 0);
  // All that friction can carry: the distance is 0.
  const Robustness border = potential_grasp_robustness(fingers({1, 2}, {0, -1, 0}));
  EXPECT_TRUE(border.balances);
  EXPECT_TRUE(border.is_complete);
  EXPECT_EQ(border.upper, 0);
  // Without friction a contact that sticks has no distance, and G of those that slip no rank.
  EXPECT_FALSE(potential_grasp_robustness(fingers(0, {0, 0, 0})).has_full_rank);
  // No contacts.
  EXPECT_FALSE(potential_contact_robustness(grasp_of({}, RationalRow(3))).has_full_rank);
  // Two contacts in space leave the turn about their line.
  const GraspBox line = grasp_of(
      {finger({-1, 0, 0}, {1, 0, 0}, 1), finger({1, 0, 0}, {-1, 0, 0}, 1)}, RationalRow(6));
  EXPECT_FALSE(potential_grasp_robustness(line).has_full_rank);
  // A normal of irrational length.
  try {
    potential_grasp_robustness(
        grasp_of({finger({0, 0}, {1, 1}, 1), finger({0, 1}, {1, 0}, 1)}, RationalRow(3)));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "contacts[0].normal");
  }
}

}  // namespace
}  // namespace stickslip
