// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How far a body of motions reaches, exactly.
#pragma once

#include <vector>

#include "stickslip/engine/proof.hpp"

namespace stickslip::degree_detail {

/// The reach of a parallelepiped or simplex from d0 across the motions that no E sees.
class BodyReach {
 public:
  /// O(walls^4) rational operations, of a parallelepiped; of a simplex a factor of walls more.
  explicit BodyReach(const ConvexBody& body);

  /// Returns whether the walls are as a body's have to be; nothing else is known otherwise.
  bool is_sound() const { return is_sound_; }
  /// Returns the largest row.e of all e that lead from d0 to a point of the body.
  Rational largest(const RationalRow& row) const;

 private:
  bool is_simplex_;
  bool is_sound_ = true;
  /// The ways to the vertices of a simplex; the edges of a parallelepiped, halved, along each
  /// of which one row grows alone.
  std::vector<RationalRow> ways_;
};

/// Returns whether all of the body, up to free motions, is within the bound, by coordinate; an
/// empty one is none. Rule `degree-bound`, of verdicts.
bool is_within(const ConvexBody& body, const RationalRow& bound);

}  // namespace stickslip::degree_detail
