// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/arrangement/great_circles.hpp"

#include <map>
#include <utility>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

/// Returns the primitive integer vector on the line of `v` whose first nonzero entry is
/// positive, and the side of it on which `v` lies. Requires v != 0.
std::pair<IntegerVector3, Sign> primitive_representative(const Vector3& v) {
  IntegerVector3 result = primitive_multiple(v);
  Sign side = Sign::kZero;
  for (const Integer& entry : result) {
    if (side == Sign::kZero) side = sign_of(entry);
  }
  require(side != Sign::kZero, "merge_planes: the normal of a plane is zero");
  if (side == Sign::kNegative) result = negated(std::move(result));
  return {std::move(result), side};
}

/// Returns the rank. It grows one normal at a time: later normals have to be compared only with
/// the first direction, and then with the cross product of the first independent pair.
int rank_of_distinct(const std::vector<IntegerVector3>& normals) {
  if (normals.size() < 2) return static_cast<int>(normals.size());
  const IntegerVector3 axis = cross(normals[0], normals[1]);
  for (const IntegerVector3& n : normals) {
    if (!dot(axis, n).is_zero()) return 3;
  }
  return 2;
}

}  // namespace

GreatCircles merge_planes(const std::vector<Vector3>& plane_normals) {
  GreatCircles result;
  std::map<IntegerVector3, CircleId> known;
  for (const Vector3& plane : plane_normals) {
    auto [normal, side] = primitive_representative(plane);
    const auto [entry, is_new] = known.emplace(normal, CircleId(result.normals.size()));
    if (is_new) result.normals.push_back(std::move(normal));
    result.circle.push_back(entry->second);
    result.orientation.push_back(side);
  }
  result.rank = rank_of_distinct(result.normals);
  return result;
}

std::vector<Vector3> stick_planes(const Grasp& grasp) {
  std::vector<Vector3> planes;
  planes.reserve(grasp.size());
  for (const Contact& contact : grasp.contacts()) {
    planes.push_back(coordinates(tangent_row(contact)));
  }
  return planes;
}

}  // namespace stickslip
