// SPDX-License-Identifier: MIT
/// \file
/// Slips in space, and the cone C_i of FORMAT.md §7: all sums of slips of one contact
/// with multiples >= 0. Of the three numbers of a slip, which is across n, one follows from the
/// others and is left out; with torsion there is a fourth. So a slip is a point of a plane, or
/// of a space of three dimensions, with a product.
///
/// *The nearest point* to q, which is not in the cone, is on a side of it: on the line of one
/// slip, or on the plane of two and between them. And of all points k of the cone it is the one
/// for which no slip s has <q - k, s> > 0, with <q - k, k> = 0. It is found in steps, by points
/// k that are nearest in the cone of one slip or two: s, the one that breaks the first rule
/// most, is added to these. In the cone of so few the nearest point is again on a line, or a
/// plane, of which s is; for else it would be k. It is nearer to q than k, so no k comes twice,
/// and the steps end.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cone.hpp"

namespace stickslip_check {

/// <s, t>, of slips without the number that is left out.
struct SlipProduct {
  SlipProduct() = default;
  /// Of slips across n; gamma = e^2 / |n|^2, which is 0 if they have no fourth number.
  SlipProduct(const Vector& n, const Rational& gamma);

  Form times(const Form& s) const;  ///< matrix s
  Rational square(const Form& s) const { return scale * dot(times(s), s); }

  std::size_t left_out = 0;
  std::vector<Form> matrix;
  Rational scale;  ///< <s, t> is that of s and matrix t by this
};

class SlipCone {
 public:
  /// {0}. The product must outlive this.
  explicit SlipCone(const SlipProduct& product)
      : product_(&product), dual_(product.matrix.size()) {}

  /// The cone of this one and of s.
  void add(const Form& s);
  bool contains(const Form& s) const;
  /// M(c)^2 with the sign of M(c), of a contact that moves, where S_i y is t. The cone must not
  /// be {0}.
  Rational most_along(const Form& t) const;

 private:
  struct Slip {
    Form s;
    Form times;      ///< matrix s
    Integer square;  ///< s.times
  };
  struct Nearest;
  static std::optional<Nearest> nearest_on(std::vector<const Slip*> slips, const Form& q);

  const SlipProduct* product_;
  Cone dual_;                ///< of all z with z.s >= 0 for its slips s
  std::vector<Slip> slips_;  ///< that generate the cone
};

}  // namespace stickslip_check
