// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A node of the branch and bound: a region, the contacts whose part in the bounds is still
/// open, and the sum of those that are decided; with its rays in double precision.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/search/nearest_point.hpp"
#include "stickslip/equilibrium/search/region.hpp"

namespace stickslip::equilibrium_detail {

using Double5 = std::array<double, 5>;

/// One contact; every entry is within one unit roundoff of the exact value if that is moderate.
struct ContactDoubles {
  Double3 normal;      ///< N
  Double3 friction;    ///< mu T
  Double5 slip;        ///< tau_i
  Double5 separation;  ///< v_i
  double stiffness;
  bool frictionless;
};

struct DoubleModel {
  explicit DoubleModel(const Problem& problem);

  std::vector<ContactDoubles> contacts;
  Double3 load;      ///< w
  Double3 growth;    ///< u, of a family
  Double3 start{};   ///< the load at the high end of the multiples, or u: where to begin
  double length;     ///< a typical distance, to make torques and forces comparable
  double force = 0;  ///< a typical force

  /// Whether all entries are moderate: 0, or between 2^-200 and 2^200. No product of a load, or
  /// of an N and a v, with a ray and a twist of 50 bits then overflows, and what it loses by
  /// underflow is below the absolute errors that are allowed for. Otherwise doubles decide
  /// nothing.
  bool is_moderate = true;

 private:
  double read(const Rational& value);
  Double3 read(const Wrench& w) { return {read(w.x), read(w.y), read(w.torque)}; }
};

/// A ray scaled by a power of two to entries of about 1; within two unit roundoffs, or within
/// 2^-1073 where an entry is so small that it underflows.
Double5 to_doubles(const IntegerVector5& x);

/// value = dot(function, x) in double, with a moderate function and a ray as above: its sign,
/// if the error bound decides.
inline std::optional<Sign> certain_sign(const Double5& function, const Double5& x,
                                        double& value) {
  double magnitude = 0;
  value = 0;
  for (std::size_t j = 0; j < 5; ++j) {
    const double product = function[j] * x[j];
    value += product;
    magnitude += product < 0 ? -product : product;
  }
  // Factors 3u, products u, sums 4u, second order: below 9u, with u = 2^-53; magnitude itself
  // is rounded. What underflows, 2^-1073 in an entry of the ray, is at most 2^-873 in a
  // product.
  constexpr double kRelativeError = 1.2e-15;
  constexpr double kUnderflow = 1e-250;
  const double bound = kRelativeError * magnitude + kUnderflow;
  if (value > bound) return Sign::kPositive;
  if (value < -bound) return Sign::kNegative;
  return std::nullopt;  // also for NaN
}

/// A contact whose part in the bounds is not yet one linear form.
struct UndecidedContact {
  std::uint32_t contact = 0;
  Separation separation = Separation::kMixed;
  std::int8_t slip = 0;   ///< -1, 1: the sign that slip has; 0: none
  bool slip_cuts = true;  ///< a slip split would make progress
};

/// The decided contacts, closed and with a sign of slip: the sum of (N + sigma mu T) (x) v, so
/// that y.value.x is the work of their forces at x on the virtual twist y.
struct DecidedContacts {
  double value[3][5] = {};
  double magnitude[3][5] = {};  ///< sums of absolute values, for error bounds
  std::size_t terms = 0;
  /// Sum of the decided contacts' separation planes: 0 at a ray iff none of them pushes there.
  IntegerVector5 push{};
};

/// What a node knows is inherited by its children: a contact that is open, closed or has a sign
/// of slip on a region is so on every part of it.
struct Node {
  Region region;
  std::vector<UndecidedContact> undecided;
  DecidedContacts decided;

  static Node root(const Problem& problem);
  Node slip_child(const Problem& problem, ContactId contact, Sign slip) const;
  Node separation_child(const Problem& problem, ContactId contact, Separation side) const;
};

/// The generators of one node's region; buffers are reused from node to node.
class RayTable {
 public:
  /// Reads the node's rays; updates what is known of its undecided contacts, and moves those
  /// known to `decided`.
  void read(const Problem& problem, const DoubleModel& model, Node& node);

  std::size_t ray_count() const { return rays_.size(); }
  const std::vector<Double5>& rays() const { return rays_; }
  /// v at each ray, of the node's undecided contact with this index. The signs are exact.
  const double* separations(std::size_t u) const { return &separations_[u * rays_.size()]; }
  /// Whether h > 0, or the growing load or a decided contact acts at the ray; exact.
  bool loaded(std::size_t ray) const { return loaded_[ray] != 0; }

 private:
  Sign sign_at(const Double5& function, const IntegerVector5& plane, std::size_t ray,
               double& value) const;
  void find_slip_sign(const Problem& problem, const DoubleModel& model, const Node& node,
                      UndecidedContact& u);

  bool doubles_decide_ = true;  ///< where their error bounds do
  std::vector<Ray> generators_;
  std::vector<Double5> rays_;
  std::vector<double> separations_;
  std::vector<char> loaded_;
  std::vector<const Ray*> zero_rays_;
};

}  // namespace stickslip::equilibrium_detail
