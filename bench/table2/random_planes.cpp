// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_planes.hpp"

#include <random>
#include <utility>

#include "stickslip/arrangement/sweep.hpp"
#include "stickslip/core/grasp.hpp"

namespace stickslip::bench {
namespace {

/// std::mt19937_64 is specified to the bit, the distributions of <random> are not.
int between(std::mt19937_64& random, int low, int high) {
  return low + static_cast<int>(random() % (static_cast<std::uint64_t>(high - low) + 1));
}

Contact random_contact(std::mt19937_64& random) {
  const int px = between(random, -1000, 1000);
  const int py = between(random, -1000, 1000);
  int nx = 0;
  int ny = 0;
  while (nx == 0 && ny == 0) {
    nx = between(random, -1000, 1000);
    ny = between(random, -1000, 1000);
  }
  if (nx * px + ny * py > 0) {
    nx = -nx;
    ny = -ny;
  }
  Contact contact;
  contact.position = {Rational(px, 1000), Rational(py, 1000)};
  contact.normal = {nx, ny};
  return contact;
}

}  // namespace

std::size_t cells_of_simple(std::size_t m) {
  return 4 * m * (m - 1) + 2;
}

std::vector<Vector3> random_simple_planes(std::size_t m, std::uint64_t seed) {
  std::mt19937_64 random(seed * 1000003 + m);
  for (;;) {
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < m; ++i) contacts.push_back(random_contact(random));
    std::vector<Vector3> planes = stick_planes(Grasp(std::move(contacts)));
    if (count_cells(planes).cells() == cells_of_simple(m)) return planes;
  }
}

}  // namespace stickslip::bench
