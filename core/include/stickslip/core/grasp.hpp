// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A planar body held by frictional point contacts, and the load on it.
///
/// Frame: the object frame. Normals point into the object. The tangent of a contact is
/// its normal turned by +90 degrees, t = (-n_y, n_x). Source: Haas-Heger et al., RSS
/// 2018, Section III and Fig. 2.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/ids.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip {

/// A point or a direction in the object frame.
struct Vector2 {
  /// \{ A coordinate. Those of a point are lengths in the user's unit.
  Rational x{};
  Rational y{};
  /// \}

  /// Compares exactly.
  friend bool operator==(const Vector2& a, const Vector2& b) {
    return a.x == b.x && a.y == b.y;
  }
};

/// A closed line: edge i goes from vertex i to the next one, and the last edge back to the
/// first vertex.
using Ring = std::vector<Vector2>;
/// An outer ring and then the rings of its holes, each in either sense.
using Polygon = std::vector<Ring>;

/// The surface of a body in space. It is drawn only: no answer depends on it, and nobody checks
/// that it is closed.
struct Mesh {
  std::vector<Vector3> vertices;  ///< the vertices, in the object frame
  /// The faces, each by the numbers of its vertices in order, at least three.
  std::vector<std::vector<std::size_t>> faces;

  /// Compares exactly.
  friend bool operator==(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.faces == b.faces;
  }
};

/// The units that the numbers of a grasp are in. They are shown and never converted.
struct Units {
  std::string length;  ///< the unit of positions: "mm"
  /// The unit of preloads and loads: "N"; a stiffness is a force per length.
  std::string force;

  /// Returns the unit of torques, a force times a length: "N mm".
  std::string torque() const { return force + " " + length; }
  /// Compares the spelling.
  friend bool operator==(const Units& a, const Units& b) {
    return a.length == b.length && a.force == b.force;
  }
};

/// A normal in the plane that a file gives by an angle whose cosine or sine is irrational: a
/// rational unit vector stands for it (certificate/FORMAT.md, section 1).
struct RoundedNormal {
  ContactId contact;   ///< the contact
  Rational degrees{};  ///< the angle in the file, from the x axis, counterclockwise
};

/// The description of a grasp for people and pictures. No answer depends on it.
struct GraspDescription {
  std::string name;                ///< the name; may be empty
  std::vector<Polygon> outline{};  ///< the outline of a planar body; empty if nobody gave it
  std::optional<Units> units{};    ///< the units; nothing if nobody gave them
  /// The surface of a body in space; null if nobody gave it. Copies share it.
  std::shared_ptr<const Mesh> body{};
  /// The acceleration by which masses of the file became forces, with as many numbers as a
  /// point; empty if no load is a mass.
  std::vector<Rational> gravity{};
  std::vector<RoundedNormal> rounded_normals{};  ///< the normals that were rounded, in order
};

/// One frictional point contact. The normal need not have length 1: only its direction
/// has meaning. `preload` is the normal force before any load is applied.
struct Contact {
  Vector2 position;       ///< the point of contact, in the object frame
  Vector2 normal;         ///< nonzero, points into the object
  Rational friction{};    ///< the coefficient mu >= 0
  Rational stiffness{1};  ///< the stiffness k > 0 of the normal spring, force per length
  Rational preload{};     ///< P >= 0, force
};

/// The law by which normal forces answer the motion d, with v = P - k N.d (N for a unit
/// normal).
enum class NormalLaw {
  kUnilateral,  ///< c_n = max(0, v): a contact may open
  kBilateral    ///< c_n = v, and c_n >= 0 is required: the literal Eq. 4 of the paper with
                ///< preload
};

/// Returns "unilateral" or "bilateral".
const char* to_string(NormalLaw law);

/// The most bytes of the name of a unit: axes have room for so many.
inline constexpr std::size_t kMaxUnitLength = 16;

/// The contacts of a grasp, which satisfy the requirements stated at Contact. Immutable.
class Grasp {
 public:
  /// Makes a grasp without contacts.
  Grasp() = default;
  /// Makes a grasp. Throws InputError naming "contacts[i].<member>" when a requirement fails.
  explicit Grasp(std::vector<Contact> contacts, std::string name = {});
  /// Makes a grasp. Throws also as check_outline does (core/outline.hpp), and if a unit has not
  /// 1 to kMaxUnitLength bytes.
  Grasp(std::vector<Contact> contacts, GraspDescription description);

  /// Returns the name for people; may be empty.
  const std::string& name() const { return description_.name; }
  /// Returns the description, name included.
  const GraspDescription& description() const { return description_; }
  /// Returns the contacts, by ContactId.
  const std::vector<Contact>& contacts() const { return contacts_; }
  std::size_t size() const { return contacts_.size(); }  ///< the number of contacts
  /// Returns a contact. Throws std::out_of_range when there is no such contact.
  const Contact& operator[](ContactId id) const { return contacts_.at(id.index()); }

  /// Returns the same grasp with every preload replaced by this one. Throws InputError if it is
  /// negative.
  Grasp with_preload(const Rational& preload) const;
  /// Returns the same grasp with each preload replaced by its own. Requires one for each
  /// contact. Throws InputError if one is negative.
  Grasp with_preloads(const std::vector<Rational>& preloads) const;

 private:
  std::vector<Contact> contacts_;
  GraspDescription description_;
};

/// A grasp and the wrench applied to the object: the content of a grasp file.
/// Equilibrium is `wrench` + (sum of the contact wrenches) = 0.
struct LoadedGrasp {
  Grasp grasp;    ///< the contacts
  Wrench wrench;  ///< w, applied to the object
};

}  // namespace stickslip
