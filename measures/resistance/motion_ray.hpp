// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Rays of homogeneous motions (d, h), and on which side of each plane they are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "stickslip/engine/problem.hpp"

namespace stickslip::resistance_detail {

/// A ray (d, h), h >= 0, or a plane of rays; primitive.
using HomogeneousMotion = IntegerVector<4>;

/// \{ Indices of rays, and of planes.
using RayIndex = std::uint32_t;
using PlaneIndex = std::uint32_t;
/// \}

/// A ray, with the values of all planes on it. Doubles are over the largest coefficient of the
/// plane and the largest entry of the ray.
struct MotionRay {
  HomogeneousMotion x;
  double h = 0;                ///< 0 iff h = 0, else with the error of `values`
  std::vector<double> values;  ///< by plane: the sign is exact, the error below kValueError
  bool is_free = false;        ///< no contact has a force there
  /// The slip classes that stick there with friction, increasing.
  std::vector<std::uint32_t> sticking;
};

/// The error bound of MotionRay::values. Both factors of four products are at most 1 and off by
/// at most 2^-51.
inline constexpr double kValueError = 1e-14;

/// Contacts whose slip planes coincide: they stick together.
struct SlipClass {
  IntegerVector3 tangent;             ///< primitive; slips are positive along it
  std::vector<std::size_t> contacts;  ///< the contacts with friction
};

/// The planes that tell modes apart, and the rays met so far, each once.
class MotionRays {
 public:
  explicit MotionRays(const Problem& problem);

  const std::vector<SlipClass>& classes() const { return classes_; }
  /// A contact with friction has a class, and a sense: 1 if it slips + when its class does, -1
  /// if it slips -. A contact without friction has no class.
  static constexpr std::size_t kNoClass = static_cast<std::size_t>(-1);
  std::size_t class_of(std::size_t contact) const { return class_of_[contact]; }
  int sense(std::size_t contact) const { return sense_[contact]; }

  /// \{ Indices of planes: v_i = 0, a class sticks, h = 0, and those that halve the space of
  /// motions at will.
  PlaneIndex separation(std::size_t contact) const { return static_cast<PlaneIndex>(contact); }
  PlaneIndex slip(std::size_t slip_class) const {
    return static_cast<PlaneIndex>(contacts_ + slip_class);
  }
  PlaneIndex infinity() const { return slip(classes_.size()); }
  PlaneIndex wall(std::size_t a, std::size_t b) const { return wall_[a][b]; }
  /// \}
  /// Returns a positive multiple of the plane's function.
  const HomogeneousMotion& plane(PlaneIndex p) const { return planes_[p]; }

  /// Rays with h = 0; any three span a cone with no other of them inside, and all four the
  /// space.
  RayIndex corner(std::size_t k) const { return corner_[k]; }
  /// The ray d = 0.
  RayIndex rest() const { return rest_; }

  RayIndex index_of(HomogeneousMotion x);
  const MotionRay& operator[](RayIndex index) const { return rays_[index]; }
  std::size_t size() const { return rays_.size(); }
  /// Returns the ray in the plane between two rays on either side of it.
  RayIndex between(RayIndex a, RayIndex b, PlaneIndex p);

 private:
  void add_plane(HomogeneousMotion plane);
  double value(PlaneIndex p, const HomogeneousMotion& x, const std::array<double, 4>& scaled,
               const Integer& largest) const;

  std::size_t contacts_;
  bool bilateral_;
  std::vector<SlipClass> classes_;
  std::vector<std::size_t> class_of_;
  std::vector<int> sense_;
  std::vector<HomogeneousMotion> planes_;
  std::vector<std::array<double, 4>> rows_;  ///< the planes over their largest coefficients
  std::vector<Integer> largest_;             ///< the largest coefficients of the planes
  std::array<std::array<PlaneIndex, 4>, 4> wall_{};
  std::array<RayIndex, 4> corner_{};
  RayIndex rest_ = 0;
  std::vector<MotionRay> rays_;
  std::map<HomogeneousMotion, RayIndex> index_;
};

}  // namespace stickslip::resistance_detail
