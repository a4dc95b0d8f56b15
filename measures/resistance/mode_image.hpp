// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loads that rays of motions resist, in coordinates of a plane of wrenches: estimated, and
/// exact if an estimate does not tell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "motion_ray.hpp"
#include "near_number.hpp"
#include "stickslip/measures/resistible_set.hpp"

namespace stickslip::resistance_detail {

using IntegerVector4 = IntegerVector<4>;

/// Returns the point in the plane between two images on either side of it; `above` has n > 0.
HomogeneousPoint crossing(const IntegerVector4& above, const IntegerVector4& below);
/// Adds generators of the section by the plane of the cone of these images.
void add_section(const std::vector<IntegerVector4>& images,
                 std::vector<HomogeneousPoint>& points);

/// The signs of the friction of the contacts of MotionRay::sticking.
using FrictionSigns = std::vector<std::int8_t>;

/// A generator of what a mode resists: a ray with friction on edges of the cones.
using GeneratorIndex = std::uint32_t;

/// Images (s, t, n, h) of generators (WrenchPlane::coordinates), each computed once.
class ModeImages {
 public:
  ModeImages(const Problem& problem, const WrenchPlane& plane, MotionRays& rays);

  GeneratorIndex index_of(RayIndex ray, const FrictionSigns& signs);
  RayIndex ray(GeneratorIndex g) const { return generators_[g].ray; }
  /// An estimate up to a positive factor.
  const std::array<NearNumber, 4>& estimate(GeneratorIndex g) const {
    return generators_[g].estimate;
  }
  /// The exact image up to a positive factor, primitive.
  const IntegerVector4& exact(GeneratorIndex g);
  /// The sign of n.
  int side(GeneratorIndex g);

  /// Returns the addition to (s, t, n) of a contact that slips + (k = 0) or - (1), for each
  /// unit of MotionRay::values.
  const std::array<NearNumber, 3>& slipping(std::size_t contact, int k) const {
    return slipping_[2 * contact + static_cast<std::size_t>(k)];
  }
  /// Returns the addition of h.
  const std::array<NearNumber, 3>& at_rest() const { return at_rest_; }
  /// Returns (s, t, n, h) of no wrench, primitive.
  const IntegerVector4& no_wrench() const { return no_wrench_; }
  /// Returns the same as slipping(), for each unit of the separation plane, times a common
  /// factor. exact_at_rest() is the addition of h, times the same factor.
  const IntegerVector4& exact_slipping(std::size_t contact, int k) const {
    return exact_slipping_[2 * contact + static_cast<std::size_t>(k)];
  }
  const IntegerVector4& exact_at_rest() const { return exact_at_rest_; }

  std::size_t exact_images() const { return exact_images_; }  ///< computed so far

 private:
  struct Generator {
    RayIndex ray;
    FrictionSigns signs;
    std::array<NearNumber, 4> estimate;
    std::optional<IntegerVector4> exact;
  };
  /// Calls add(contact, k) for each contact with a force.
  template <class Add>
  void for_each_force(const Generator& g, Add add) const;

  MotionRays& rays_;
  std::size_t contacts_;
  std::vector<std::array<NearNumber, 3>> slipping_;
  std::array<NearNumber, 3> at_rest_;
  std::vector<IntegerVector4> exact_slipping_;
  IntegerVector4 exact_at_rest_;
  IntegerVector4 no_wrench_;
  std::vector<Generator> generators_;
  std::map<std::pair<RayIndex, FrictionSigns>, GeneratorIndex> index_;
  std::size_t exact_images_ = 0;
};

}  // namespace stickslip::resistance_detail
