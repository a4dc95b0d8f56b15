// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A node of the cone engine: a region, the contacts whose part in the bounds is still open,
/// and the sum of those that are settled; with its rays in double precision.
#pragma once

#include <vector>

#include "double_model.hpp"
#include "stickslip/equilibrium/region.hpp"

namespace stickslip {

/// A contact whose part in the bounds is not yet one linear form.
struct OpenQuestion {
  std::uint32_t contact = 0;
  Separation separation = Separation::kMixed;
  std::int8_t slip = 0;   ///< -1, 1: the sign that slip has; 0: none
  bool slip_cuts = true;  ///< a slip split would make progress
};

/// The settled contacts, closed and with a sign of slip: the sum of (N + sigma mu T) (x) v, so
/// that y.value.x is the work of their forces at x on the virtual twist y.
struct Aggregate {
  double value[3][4] = {};
  double magnitude[3][4] = {};  ///< sums of absolute values, for error bounds
  std::size_t terms = 0;
  /// Sum of the settled contacts' separation planes: 0 at a ray iff none of them pushes there.
  IntegerVector4 push{};
};

/// What a node knows is inherited by its children: a contact that is open, closed or has a sign
/// of slip on a region is so on every part of it.
struct Node {
  Region region;
  std::vector<OpenQuestion> questions;
  Aggregate settled;

  static Node root(const Problem& problem);
  Node slip_child(const Problem& problem, ContactId contact, Sign slip) const;
  Node separation_child(const Problem& problem, ContactId contact, Separation side) const;
};

/// The rays of one node; buffers are reused from node to node.
class RayTable {
 public:
  /// Reads the node's rays; updates what is known of its questions, and settles those known.
  void read(const Problem& problem, const DoubleModel& model, Node& node);

  std::size_t ray_count() const { return rays_.size(); }
  const std::vector<Double4>& rays() const { return rays_; }
  /// v at each ray, of the node's question with this index. The signs are exact.
  const double* heights(std::size_t question) const {
    return &heights_[question * rays_.size()];
  }
  /// Whether the load (h > 0) or a settled contact acts at the ray; exact.
  bool loaded(std::size_t ray) const { return loaded_[ray] != 0; }

 private:
  Sign sign_at(const Double4& function, const IntegerVector4& plane, std::size_t ray,
               double& value) const;
  void find_slip_sign(const Problem& problem, const DoubleModel& model, const Node& node,
                      OpenQuestion& question);

  bool doubles_decide_ = true;  ///< where their error bounds do
  std::vector<IntegerVector4> directions_;
  std::vector<Double4> rays_;
  std::vector<double> heights_;
  std::vector<char> loaded_;
  std::vector<const Ray*> zero_rays_;
};

}  // namespace stickslip
