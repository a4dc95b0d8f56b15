// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/spatial_grasp.hpp"

namespace stickslip {

const std::string& name_of(const AnyGraspFile& file) {
  if (const auto* grasp = std::get_if<SpatialGrasp>(&file)) return grasp->name;
  return std::get<GraspFile>(file).content.grasp.name();
}

}  // namespace stickslip
