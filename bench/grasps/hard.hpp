// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Families meant to make the tree of branch and bound grow: what is nearly degenerate, badly
/// scaled, or symmetric, under loads next to a threshold, where no bound has room to spare.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "loads.hpp"

namespace stickslip::bench {

enum class HardFamily {
  kFrictionless,      ///< an arc without friction
  kHalfFrictionless,  ///< an arc, every other contact without friction
  kNearlyParallel,    ///< a floor whose normals and heights differ by 1e-9
  kNearlyCoincident,  ///< three edges whose contacts leave the edge by 1e-9
  kStiffness,         ///< an arc, stiffness 1e-9, 1 or 1e9
  kPreload,           ///< an arc, preload 1e-9, 1 or 1e9
  kFacingPairs,       ///< a thin plate pinched by pairs in all directions
  kOnePoint,          ///< an arc within 1e-6 of a point, and one contact away from it
  kFloor,             ///< all normals parallel, friction and preload differ
  kLattice,           ///< a grid of pegs with all four axis normals
  kSticky,            ///< an arc with friction 2 to 10: it jams
  kSlippery,          ///< contacts all round, friction 1/1000 to 9/1000
  kWheel,             ///< a disc: all contacts alike, planes tangent to one cone
  kNested,            ///< an arc whose radii and stiffnesses grow geometrically
};

inline constexpr std::size_t kHardFamilies = 14;

const char* name_of(HardFamily family);

/// A grasp, a load that it holds without moving or friction, -sum P_i N_i, and a direction in
/// which to look for the end of what it holds.
struct HardGrasp {
  Grasp grasp;
  Wrench held;
  Wrench direction;
};
HardGrasp hard_grasp(HardFamily family, std::size_t contacts, std::uint64_t seed);

/// The two sides of a threshold: loads held + s direction that are stable and not, whose s
/// differ by a part in 2^40.
struct Threshold {
  Question held;
  Question too_much;
};

/// Nothing if the grasp holds every s tried, up to 2^20.
std::optional<Threshold> find_threshold(const HardGrasp& hard, NormalLaw law,
                                        const StableOracle& is_stable);

}  // namespace stickslip::bench
