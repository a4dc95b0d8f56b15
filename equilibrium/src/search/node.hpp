// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A node of the branch and bound: a region, the contacts whose part in the bounds is still
/// open, and the sum of those that are decided; with its rays in double precision.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/search/nearest_point.hpp"
#include "stickslip/equilibrium/search/region.hpp"
#include "stickslip/equilibrium/search/region_program.hpp"
#include "stickslip/equilibrium/search/tree_walk.hpp"

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
  /// \{ Bounds of the rounding of the functions' values at points with entries of at most 1.
  double slip_error;
  double separation_error;
  /// \}
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

/// The error of a moderate function's value at a ray as above, by the sum of the absolute
/// values of its five products.
inline double rounding_bound(double magnitude) {
  // Factors 3u, products u, sums 4u, second order: below 9u, with u = 2^-53; magnitude itself
  // is rounded. What underflows, 2^-1073 in an entry of the ray, is at most 2^-873 in a
  // product.
  constexpr double kRelativeError = 1.2e-15;
  constexpr double kUnderflow = 1e-250;
  return kRelativeError * magnitude + kUnderflow;
}

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
  const double bound = rounding_bound(magnitude);
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
  /// Before RayTable::read those of the node above, shared by all its children.
  std::shared_ptr<const std::vector<UndecidedContact>> undecided;
  DecidedContacts decided;

  static Node root(const Problem& problem) { return Node(problem, Region::root(problem)); }
  /// Of which nothing is known yet.
  Node(const Problem& problem, Region root);
  Node slip_child(const Problem& problem, ContactId contact, Sign slip) const;
  Node separation_child(const Problem& problem, ContactId contact, Separation side) const;
  /// The node of a tree that splits it, and the regions of its children.
  Branch<RefutationNode, Node> split(const Problem& problem, const ContactSplit& at) const;
};

/// Rays and contacts are taken in blocks: what is done with each is done with several at once.
inline constexpr std::size_t kBlock = 4;
using BlockDoubles = Eigen::Array<double, kBlock, 1>;

/// What the search needs of some of a node's undecided contacts.
struct UndecidedBlock {
  std::array<BlockDoubles, 3> normal;    ///< N
  std::array<BlockDoubles, 3> friction;  ///< mu T
  BlockDoubles edge;                     ///< sigma if slip has a sign, else 0
  BlockDoubles any_edge;                 ///< 0 if slip has a sign, else 1
  BlockDoubles least;                    ///< of the work that counts: -inf if closed, else 0
};

/// The generators of one node's region; buffers are reused from node to node.
class RayTable {
 public:
  /// Reads the node's rays; updates what is known of its undecided contacts, and moves those
  /// known to `decided`.
  void read(const Problem& problem, const DoubleModel& model, Node& node);

  std::size_t ray_count() const { return rays_.size(); }
  /// Blocks of rays; the last one is filled up with what stands for no ray.
  std::size_t block_count() const { return blocks_.size(); }
  const std::vector<Ray>& exact_rays() const { return generators_; }
  const std::vector<Double5>& rays() const { return rays_; }
  /// The node's undecided contacts, in their order; the last block is filled up with zeros.
  const std::vector<UndecidedBlock>& undecided() const { return undecided_; }
  /// v at the rays of a block, by the node's undecided contacts. The signs are exact.
  const std::vector<BlockDoubles>& separations(std::size_t block) const {
    return separations_[block];
  }
  double separation(std::size_t undecided, std::size_t ray) const {
    return separations_[ray / kBlock][undecided].data()[ray % kBlock];
  }
  /// Whether h > 0, or may be 0 at solutions; or the growing load or a decided contact acts at
  /// the ray; exact.
  bool loaded(std::size_t ray) const { return loaded_[ray] != 0; }
  /// Whether that is so at all rays of a block.
  bool block_is_loaded(std::size_t block) const;

 private:
  /// The coordinates of a block's rays.
  using Block = std::array<BlockDoubles, 5>;

  Sign sign_at(const Double5& function, const IntegerVector5& plane, std::size_t ray,
               double& value) const;
  void list_rays(const Problem& problem, const Node& node);
  SignRange find_separations(const Problem& problem, const ContactDoubles& c,
                             ContactId contact);
  void find_slip_sign(const Problem& problem, const DoubleModel& model, const Node& node,
                      UndecidedContact& u);

  bool doubles_decide_ = true;  ///< where their error bounds do
  std::vector<Ray> generators_;
  std::vector<Double5> rays_;
  std::vector<Block> blocks_;
  std::vector<BlockDoubles> values_;  ///< of one contact
  std::vector<UndecidedBlock> undecided_;
  std::vector<std::vector<BlockDoubles>> separations_;
  std::vector<char> loaded_;
  std::vector<const Ray*> zero_rays_;
};

}  // namespace stickslip::equilibrium_detail
