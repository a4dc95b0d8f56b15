// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The signs of v_i and tau_i at one point after another.
#pragma once

#include "engine/planar/double_model.hpp"

namespace stickslip::margin_detail {

/// A linear function of x = (d, h, l), exact up to a positive factor, with rounded coefficients
/// beside.
struct FilteredFunction {
  const IntegerVector5* plane;
  const Double5* rounded;  ///< nullptr: the sign is always computed exactly
};

/// Exact signs: doubles decide if their error bound allows (search/double_model.hpp), else
/// integers.
class PointSigns {
 public:
  explicit PointSigns(const Problem& problem) : problem_(problem), model_(problem) {}

  /// Sets the point whose signs are asked for from now on.
  void go_to(const Vector5& x) {
    x_ = primitive_multiple(x);
    rounded_ = in_doubles(x_);
  }

  FilteredFunction separation(std::size_t contact) const {
    return {&problem_.separation_plane(ContactId(contact)),
            &model_.contacts[contact].separation};
  }
  FilteredFunction slip(std::size_t contact) const {
    return {&problem_.slip_plane(ContactId(contact)), &model_.contacts[contact].slip};
  }

  Sign of(const FilteredFunction& function) const {
    double value = 0;
    if (function.rounded != nullptr && model_.is_moderate) {
      if (const auto certain = certain_sign(*function.rounded, rounded_, value))
        return *certain;
    }
    return sign_of(dot(*function.plane, x_));
  }

 private:
  const Problem& problem_;
  DoubleModel model_;
  IntegerVector5 x_{};
  Double5 rounded_{};
};

}  // namespace stickslip::margin_detail
