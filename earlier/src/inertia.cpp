// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/error.hpp"
#include "stickslip/core/number_list.hpp"
#include "stickslip/earlier/load_classes.hpp"

namespace stickslip {
namespace {

RationalRow row_of(const Vector3& v) {
  return {v.begin(), v.end()};
}

}  // namespace

Inertia Inertia::of_length(const Rational& radius, bool in_space) {
  const Rational square = radius * radius;
  if (!in_space) return {{0, 0}, {{square}}};
  return {{0, 0, 0}, {{square, 0, 0}, {0, square, 0}, {0, 0, square}}};
}

RationalRow times_mass(const Inertia& inertia, const RationalRow& a) {
  const RationalRow& c = inertia.centre;
  if (!inertia.in_space()) {
    const Rational fx = a[0] - a[2] * c[1];
    const Rational fy = a[1] + a[2] * c[0];
    return {fx, fy, c[0] * fy - c[1] * fx + inertia.gyration[0][0] * a[2]};
  }
  const RationalRow turn(a.begin() + 3, a.end());
  const Vector3 centre = vector3(c);
  Vector3 force = cross(vector3(turn), centre);
  for (std::size_t j = 0; j < 3; ++j) force[j] += a[j];
  RationalRow result = row_of(force);
  const Vector3 moment = cross(centre, force);
  for (std::size_t j = 0; j < 3; ++j) {
    result.push_back(moment[j] + dot(inertia.gyration[j], turn));
  }
  return result;
}

Json inertia_json(const Inertia& inertia) {
  Json json{{"centre", number_json(inertia.centre)}};
  if (!inertia.in_space()) {
    json["gyration_squared"] = number_json(inertia.gyration[0][0]);
    return json;
  }
  Json& tensor = json["gyration"] = Json::array();
  for (const RationalRow& row : inertia.gyration) tensor.push_back(number_json(row));
  return json;
}

Inertia inertia_of(const std::string& place, const RationalRow& numbers, bool in_space) {
  const auto refuse = [&](const std::string& problem) {
    throw InputError(
        "", place, problem,
        in_space
            ? "give the centre of mass, x, y and z, and of the tensor of inertia about it, "
              "over the mass, xx, yy, zz, and xy, xz, yz if they are not 0, as in "
              "0,0,1/2,1/6,1/6,1/6"
            : "give the centre of mass, x and y, and the squared radius of gyration "
              "about it, above 0, as in 0,1/2,1/6");
  };
  const std::size_t n = numbers.size();
  if (!in_space) {
    if (n != 3) refuse("there are " + std::to_string(n) + " numbers");
    if (numbers[2].sign() <= 0) {
      refuse("the squared radius of gyration is " + to_string(numbers[2]));
    }
    return {{numbers[0], numbers[1]}, {{numbers[2]}}};
  }
  if (n != 6 && n != 9) {
    refuse("there are " + std::to_string(n) + " numbers, and the grasp is in space");
  }
  const auto at = [&](std::size_t j) { return j < n ? numbers[j] : Rational(0); };
  const Vector3 x{at(3), at(6), at(7)};
  const Vector3 y{at(6), at(4), at(8)};
  const Vector3 z{at(7), at(8), at(5)};
  if (x[0].sign() <= 0 || (x[0] * y[1] - x[1] * y[0]).sign() <= 0 ||
      dot(x, cross(y, z)).sign() <= 0) {
    refuse("the tensor is not positive definite");
  }
  return {{at(0), at(1), at(2)}, {row_of(x), row_of(y), row_of(z)}};
}

RationalRow numbers_of(const Inertia& inertia) {
  RationalRow numbers = inertia.centre;
  const auto& g = inertia.gyration;
  for (std::size_t j = 0; j < g.size(); ++j) numbers.push_back(g[j][j]);
  const bool is_diagonal =
      g.size() == 1 || (g[0][1].is_zero() && g[0][2].is_zero() && g[1][2].is_zero());
  if (!is_diagonal) numbers.insert(numbers.end(), {g[0][1], g[0][2], g[1][2]});
  return numbers;
}

RationalRow inertia_numbers(const std::string& place, const std::string& value) {
  if (value.empty()) return {};
  RationalRow numbers = rationals_at(place, value);
  inertia_of(place, numbers, numbers.size() > 3);
  return numbers;
}

}  // namespace stickslip
