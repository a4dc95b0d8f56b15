// SPDX-License-Identifier: GPL-3.0-or-later
#include "simple_grasp.hpp"

#include <random>
#include <utility>
#include <vector>

#include "stickslip/core/contact_row.hpp"

namespace stickslip {
namespace {

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_in_general_position(const std::vector<Vector3>& planes, const Vector3& candidate) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Vector3 line = cross(planes[i], candidate);
    if (line == Vector3{}) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (line[0] * planes[j][0] + line[1] * planes[j][1] + line[2] * planes[j][2] == 0) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

Grasp random_simple_grasp(std::size_t contacts) {
  // The standard fixes the engine's numbers, but not those of its distributions.
  std::mt19937 random;
  const auto draw = [&random] { return Rational(static_cast<int>(random() % 201U) - 100); };
  std::vector<Contact> chosen;
  std::vector<Vector3> planes;
  while (chosen.size() < contacts) {
    Contact contact;
    // One statement each: the order of evaluation is then fixed.
    contact.position.x = draw() / 100;
    contact.position.y = draw() / 100;
    contact.normal.x = draw();
    contact.normal.y = draw();
    if (contact.normal == Vector2{}) continue;
    Vector3 plane = coordinates(tangent_row(contact));
    if (!is_in_general_position(planes, plane)) continue;
    chosen.push_back(std::move(contact));
    planes.push_back(std::move(plane));
  }
  return Grasp(std::move(chosen));
}

}  // namespace stickslip
