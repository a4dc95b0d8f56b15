// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A body in space held by frictional point contacts, and the load on it. Every number but the
/// normals' may be an interval: what is known exactly is an interval of one number.
///
/// Frame: the object frame, right-handed. Normals point into the object. A twist
/// d = (u, omega) moves the point p to p + u + omega x p; a wrench is a force and its torque
/// about the origin, w = (f, torque). Friction is Coulomb's cone (certificate/FORMAT.md,
/// section 7), without a choice of tangents.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip {

/// A twist or a wrench in space: translation x, y, z and rotation x, y, z, in radians; force
/// and torque.
using Vector6 = std::array<Rational, 6>;
/// The components of a wrench in space.
using SpatialWrench = std::array<Interval, 6>;

/// One frictional point contact. Normals are certain, and need not have length 1.
struct SpatialContact {
  std::array<Interval, 3> position;  ///< of the point of contact, in the object frame
  Vector3 normal;                    ///< nonzero, points into the object
  Interval friction;                 ///< coefficient mu >= 0
  Interval stiffness{1, 1};          ///< of the normal spring, k > 0, force per length
  Interval preload{};                ///< P >= 0, force
};

/// A load with a name: a question of its own.
struct SpatialCase {
  std::string name;      ///< not empty
  SpatialWrench wrench;  ///< all of it, with what is common to all cases
};

/// What a grasp file in space says.
struct SpatialGrasp {
  std::string name;                            ///< for people; may be empty
  std::optional<Units> units{};                ///< nothing if nobody gave them
  std::vector<SpatialContact> contacts{};      ///< by ContactId
  SpatialWrench wrench{};                      ///< of cases, what is common to them
  std::vector<SpatialCase> cases{};            ///< with different names
  std::vector<ContactId> assumed_stiffness{};  ///< as in GraspFile

  /// Whether every interval is one number.
  bool is_point() const;
};

/// Calls f(place, interval) of every number that may be an interval, in the order of a file:
/// "contacts[2].friction", "wrench[5]".
template <class Grasp, class Function>
void for_each_number(Grasp& grasp, Function f) {
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    auto& c = grasp.contacts[i];
    const std::string path = "contacts[" + std::to_string(i) + "].";
    for (std::size_t j = 0; j < 3; ++j) {
      f(path + "position[" + std::to_string(j) + "]", c.position[j]);
    }
    f(path + "friction", c.friction);
    f(path + "stiffness", c.stiffness);
    f(path + "preload", c.preload);
  }
  for (std::size_t j = 0; j < 6; ++j) f("wrench[" + std::to_string(j) + "]", grasp.wrench[j]);
}

/// Throws InputError naming "contacts[i].<member>" or "wrench[j]" if a normal is 0, a friction
/// coefficient or preload may be below 0, a stiffness may be 0 or below, or the ends of an
/// interval are exchanged.
void check(const SpatialGrasp& grasp);

/// Each interval widened as the tolerances say, and checked. Throws InputError with the place
/// "uncertain" for one of normals, and as check() does.
SpatialGrasp widened(SpatialGrasp grasp, const Tolerances& tolerances);

/// A grasp in the plane or in space.
using AnyGraspFile = std::variant<GraspFile, SpatialGrasp>;

/// For people; may be empty.
const std::string& name_of(const AnyGraspFile& file);

/// \{ As parse_grasp and read_grasp_file, which refuse grasps in space: either kind.
AnyGraspFile parse_any_grasp(std::string_view text, const std::string& file,
                             Intervals intervals = Intervals::kAllowed);
AnyGraspFile read_any_grasp_file(const std::string& path,
                                 Intervals intervals = Intervals::kAllowed);
/// \}

/// As of a GraspFile.
std::string write_grasp_file(const SpatialGrasp& grasp);

}  // namespace stickslip
