// SPDX-License-Identifier: MIT
/// \file
/// What the regions of a tree in the plane inherit, so that most leaves cost the contacts that
/// are not settled above them; and `leaf-bound` in doubles with error bounds, which accept what
/// they prove and leave everything else to leaf.hpp.
///
/// *Inheritance.* A region that is cut from another has generators in its cone and all of its
/// strict functions. So v_i <= 0 on the one (open) gives v_i <= 0 on the other, and v_i >= 0
/// (closed) the same. If tau_i >= 0 and some strict function is zero on all generators where
/// tau_i is, then it is zero on the face tau_i = 0 of the cone, on which the generators of the
/// other region lie where tau_i is zero. So a contact that has a sign of slip keeps it. A
/// contact that is open is dropped from the list; of one that is closed and has a sign, its
/// part of g, alpha_i v_i(x) = y.E v_i(x) with one edge E of its friction cone, is bilinear in
/// y and x: it is added to a matrix.
///
/// *Doubles.* With u = 2^-53. Numbers are taken with a relative error of at most 6u, as
/// fractions of a power of two, and no nonzero one is below 2^-151 after that, so no product
/// underflows; an overflow makes an infinity or NaN, by which nothing is proved. A term of g is
/// a product of sums of products; all that is rounded in it, at most 60 times, is relative to
/// the same term with every number replaced by its absolute value, its *magnitude*. Adding N
/// terms and more, in a type that rounds by e, rounds by at most N e times the sum of
/// magnitudes. The magnitudes' own rounding is within a factor of 2.
///
/// *Signs.* The sum of a_j x_j has the sign of the computed one where that is above 9u times
/// its magnitude. And where all a_j are integers below 2^53 times a power of 2, their *unit*,
/// and all x_j as well, every product is a multiple of the product U of the two units.
/// Multiples of U that are at most 2^53 U are doubles, and numbers that round to less than
/// 2^53 U are less than that. So if the computed magnitude is less, or 0, nothing was rounded
/// in it, nor in the sum, and the sum's sign is exact, 0 included. All other signs are found in
/// integers, for which the exact numbers of the contact are made (box.hpp).
///
/// *No force.* At a ray where no contact has v > 0, of those that are not dropped and not mixed
/// with alpha_i < 0, every b_i is 0, and g is y.load, which is computed exactly.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "region.hpp"

namespace stickslip_check {

/// The functions of a contact in doubles: v, tau and the two edges up to positive factors, and
/// the factor that v times an edge then needs.
struct RowDoubles {
  std::array<double, kPlanar + 2> v;
  std::array<double, kPlanar> tau;
  std::array<double, kPlanar> edges[2];  ///< for a slip > 0 and < 0
  double v_unit;                         ///< if not 0, v is exact, and of multiples of it
  double tau_unit;
  double weight;
  bool one_edge;  ///< both are the same
};

/// A box of one point in doubles.
struct BoxDoubles {
  std::vector<RowDoubles> rows;
  std::array<double, kPlanar> load;    ///< w
  std::array<double, kPlanar> growth;  ///< u
};

/// Nothing for a box that is more than a point or in space, for a plane of loads, for several
/// bodies, or where numbers differ too much in size.
std::shared_ptr<const BoxDoubles> make_doubles(const Box& box);

/// For sums of many terms. More than doubles where the machine has it, which is asked of the
/// machine and not of the type.
using LongSum = long double;

/// The part of the cone where no v_i is below 0: cut by those that are somewhere.
Cone cut_by_normal_law(Cone cone, const Box& box, const BoxDoubles& doubles);

/// A contact that is neither open nor closed with a sign of slip.
struct Unsettled {
  std::uint32_t contact;
  bool closed;
  std::int8_t slip;  ///< 1, -1, or 0 if it has no sign

  friend bool operator==(const Unsettled& a, const Unsettled& b) {
    return a.contact == b.contact && a.closed == b.closed && a.slip == b.slip;
  }
};

class Settled {
 public:
  /// Of all points: nothing is. The box must outlive this.
  Settled(const Box& box, std::shared_ptr<const BoxDoubles> doubles);

  /// The same for a region that was cut from this one's, by looking at the unsettled contacts.
  /// If it is barred, which contacts are settled does not matter: use this.
  Settled within(const Generators& region) const;

  const std::vector<Unsettled>& unsettled() const { return *unsettled_; }

  /// Whether `leaf-bound` is proved to hold in doubles; for the region given to `within`.
  bool proves(const Generators& region, const Vector& twist) const;

 private:
  void add(const RowDoubles& row, int slip);

  const Box* box_;
  std::shared_ptr<const BoxDoubles> doubles_;
  std::shared_ptr<const std::vector<Unsettled>> unsettled_;

  // The contacts that are closed and have a sign:
  LongSum sum_[kPlanar][kPlanar + 2] = {};       ///< of weight edge v
  double magnitude_[kPlanar][kPlanar + 2] = {};  ///< of its terms
  std::size_t terms_ = 0;
};

}  // namespace stickslip_check
