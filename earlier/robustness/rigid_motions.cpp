// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier/robustness/rigid_motions.hpp"

namespace stickslip::robustness_detail {
namespace {

Row cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

std::set<std::vector<SpringState>> states_of_motions(const ForceModel& model) {
  const std::size_t m = model.contacts.size();
  std::vector<Row> planes;  // those of N, then those of T
  for (const ForceContact& contact : model.contacts) planes.push_back(contact.normal.integers);
  for (const ForceContact& contact : model.contacts) {
    planes.push_back(contact.tangents.front().integers);
  }
  std::set<std::vector<SpringState>> found;
  found.emplace(m, SpringState::kStick);  // the motion 0
  // The signs of N.y and of T.y at a motion say what its states are.
  const auto add = [&](const std::vector<int>& signs) {
    std::vector<SpringState> states;
    for (std::size_t i = 0; i < m; ++i) {
      states.push_back(signs[i] > 0        ? SpringState::kDetached
                       : signs[m + i] == 0 ? SpringState::kStick
                                           : SpringState::kSlip);
    }
    found.insert(std::move(states));
  };
  std::set<Row> rays;
  for (std::size_t a = 0; a < planes.size(); ++a) {
    for (std::size_t b = a + 1; b < planes.size(); ++b) {
      const Row ray = primitive(cross(planes[a], planes[b]));
      if (is_zero(ray)) continue;
      rays.insert(ray);
      rays.insert(negated(ray));
    }
  }
  // Each face but 0 has a ray at its border. Beside a ray are half planes, along the planes
  // through it, and beside each of these two open cones.
  for (const Row& ray : rays) {
    std::vector<int> signs;
    for (const Row& plane : planes) signs.push_back(dot(plane, ray).sign());
    add(signs);
    for (std::size_t z = 0; z < planes.size(); ++z) {
      if (signs[z] != 0) continue;
      for (Row along : {cross(planes[z], ray), cross(ray, planes[z])}) {
        std::vector<int> beside = signs;
        std::vector<std::size_t> rest;
        for (std::size_t k = 0; k < planes.size(); ++k) {
          if (signs[k] != 0) continue;
          beside[k] = dot(planes[k], along).sign();
          if (beside[k] == 0) rest.push_back(k);
        }
        add(beside);
        for (const int side : {1, -1}) {
          std::vector<int> open = beside;
          for (const std::size_t k : rest) open[k] = side * dot(planes[k], planes[z]).sign();
          add(open);
        }
      }
    }
  }
  return found;
}

}  // namespace stickslip::robustness_detail
