// SPDX-License-Identifier: GPL-3.0-or-later
#include "families.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle.hpp"
#include "sweep_checks.hpp"

namespace stickslip::test {
namespace {

Rational determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

bool are_parallel(const Vector3& a, const Vector3& b) {
  return a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2] && a[0] * b[1] == a[1] * b[0];
}

bool keeps_simple(const std::vector<Vector3>& planes, const Vector3& candidate) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (are_parallel(planes[i], candidate)) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (determinant(planes[i], planes[j], candidate) == 0) return false;
    }
  }
  return true;
}

}  // namespace

Vector3 Random::vector(int bound) {
  for (;;) {
    const int x = between(-bound, bound);
    const int y = between(-bound, bound);
    const int z = between(-bound, bound);
    if (x != 0 || y != 0 || z != 0) return {x, y, z};
  }
}

std::vector<Vector3> simple_planes(std::size_t m, std::uint32_t seed) {
  Random random(seed);
  std::vector<Vector3> planes;
  while (planes.size() < m) {
    const Vector3 candidate = random.vector(1000);
    if (keeps_simple(planes, candidate)) planes.push_back(candidate);
  }
  return planes;
}

std::vector<Vector3> grid_planes(std::size_t m, int bound, std::uint32_t seed) {
  Random random(seed);
  std::vector<Vector3> planes;
  while (planes.size() < m) planes.push_back(random.vector(bound));
  return planes;
}

std::vector<Vector3> pencil_planes(std::size_t m, std::uint32_t seed) {
  Random random(seed);
  const Vector3 u = random.vector(3);
  Vector3 v = random.vector(3);
  while (are_parallel(u, v)) v = random.vector(3);
  std::vector<Vector3> planes;
  while (planes.size() < m) {
    const int a = random.between(-50, 50);
    const int b = random.between(-50, 50);
    if (a == 0 && b == 0) continue;
    const Vector3 candidate = {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
    const auto coincides = [&](const Vector3& n) { return are_parallel(n, candidate); };
    if (std::none_of(planes.begin(), planes.end(), coincides)) planes.push_back(candidate);
  }
  return planes;
}

std::vector<Vector3> near_grid_planes(std::size_t m, int bound, const Rational& epsilon,
                                      std::uint32_t seed) {
  std::vector<Vector3> planes = grid_planes(m, bound, seed);
  Random random(seed + 1);
  for (Vector3& n : planes) {
    if (random.between(0, 3) == 0) continue;
    for (Rational& entry : n) entry += random.between(-2, 2) * epsilon;
  }
  return planes;
}

std::vector<Vector3> axis_aligned_planes(std::size_t m, int bound, std::uint32_t seed) {
  Random random(seed);
  std::vector<Contact> contacts(m);
  for (Contact& contact : contacts) {
    contact.position = {random.between(-bound, bound), random.between(-bound, bound)};
    const int side = random.between(0, 1) == 0 ? -1 : 1;
    contact.normal = random.between(0, 1) == 0 ? Vector2{side, 0} : Vector2{0, side};
  }
  return stick_planes(Grasp(std::move(contacts)));
}

Grasp inward_grasp(const std::vector<Vector2>& points) {
  std::vector<Contact> contacts;
  for (const Vector2& p : points) {
    Contact contact;
    contact.position = p;
    contact.normal = {-p.x, -p.y};
    contacts.push_back(contact);
  }
  return Grasp(std::move(contacts));
}

Grasp fig1_grasp() {
  return inward_grasp({{-1, 0}, {0, -1}, {1, 0}});
}

Grasp fig4_grasp() {
  std::vector<Contact> contacts(4);
  contacts[0].position = {-1, 1};
  contacts[1].position = {-1, -1};
  contacts[2].position = {1, -1};
  contacts[3].position = {1, 1};
  for (std::size_t i = 0; i < 4; ++i) contacts[i].normal = {i < 2 ? 1 : -1, 0};
  return Grasp(std::move(contacts), "fig4");
}

std::vector<std::string> texts(const std::vector<SlipState>& states) {
  std::vector<std::string> result;
  result.reserve(states.size());
  for (const SlipState& state : states) result.push_back(to_string(state));
  return result;
}

std::string describe(const std::vector<Vector3>& planes) {
  std::string text = "{";
  for (const Vector3& n : planes) {
    if (text.size() > 1) text += ", ";
    text += "(" + to_string(n[0]) + ", " + to_string(n[1]) + ", " + to_string(n[2]) + ")";
  }
  return text + "}";
}

void expect_well_formed(const SlipStates& result) {
  const ArrangementCounts& counts = result.counts;
  if (counts.circles >= 2) {
    EXPECT_EQ(counts.vertices + counts.faces, counts.edges + 2);
  }
  EXPECT_EQ(counts.distinct_states, result.states.size());

  const std::vector<std::string> states = texts(result.states);
  EXPECT_TRUE(std::is_sorted(states.begin(), states.end()));
  EXPECT_EQ(std::adjacent_find(states.begin(), states.end()), states.end());
  EXPECT_TRUE(
      std::binary_search(states.begin(), states.end(), std::string(counts.planes, '0')));
  std::size_t without_antipode = 0;
  for (std::string state : states) {
    EXPECT_EQ(state.size(), counts.planes);
    for (char& c : state) c = c == '+' ? '-' : c == '-' ? '+' : '0';
    if (!std::binary_search(states.begin(), states.end(), state)) ++without_antipode;
  }
  EXPECT_EQ(without_antipode, 0u);
}

void expect_equals_oracle(const std::vector<Vector3>& planes) {
  SCOPED_TRACE(describe(planes));
  const OracleResult expected = enumerate_by_composition(planes);
  const SlipStates actual = enumerate_slip_states_cgal(planes);
  EXPECT_EQ(actual.counts.planes, planes.size());
  EXPECT_EQ(actual.counts.rank, expected.rank);
  EXPECT_EQ(actual.counts.vertices, expected.vertices);
  EXPECT_EQ(actual.counts.edges, expected.edges);
  EXPECT_EQ(actual.counts.faces, expected.faces);
  EXPECT_EQ(actual.counts.distinct_states, expected.states.size());
  EXPECT_EQ(texts(actual.states), expected.states);

  expect_sweep_equals(planes, expected);
}

}  // namespace stickslip::test
