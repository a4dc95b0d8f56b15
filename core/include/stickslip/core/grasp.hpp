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
  /// \{ A coordinate; of a point, a length in the user's unit.
  Rational x{};
  Rational y{};
  /// \}

  /// Exact.
  friend bool operator==(const Vector2& a, const Vector2& b) {
    return a.x == b.x && a.y == b.y;
  }
};

/// A closed line: edge i goes from vertex i to the next one, the last to the first.
using Ring = std::vector<Vector2>;
/// An outer ring, and then those of its holes, each in either sense.
using Polygon = std::vector<Ring>;

/// The surface of a body in space. It is drawn, and part of no question: nobody checks that it
/// is closed.
struct Mesh {
  std::vector<Vector3> vertices;  ///< in the object frame
  /// Of each the numbers of its vertices in order, at least three.
  std::vector<std::vector<std::size_t>> faces;

  /// Exact.
  friend bool operator==(const Mesh& a, const Mesh& b) {
    return a.vertices == b.vertices && a.faces == b.faces;
  }
};

/// The units that the numbers of a grasp are in. They are shown and never converted.
struct Units {
  std::string length;  ///< of positions: "mm"
  std::string force;   ///< of preloads and loads: "N"; a stiffness is a force per length

  /// A force times a length: "N mm".
  std::string torque() const { return force + " " + length; }
  /// The same spelling.
  friend bool operator==(const Units& a, const Units& b) {
    return a.length == b.length && a.force == b.force;
  }
};

/// What is known of a grasp for people and pictures; no answer depends on it.
struct GraspDescription {
  std::string name;                    ///< may be empty
  std::vector<Polygon> outline{};      ///< of a planar body; empty if nobody gave it
  std::optional<Units> units{};        ///< nothing if nobody gave them
  std::shared_ptr<const Mesh> body{};  ///< in space; null if nobody gave it. Copies share it
};

/// One frictional point contact. The normal need not have length 1: only its direction
/// has meaning. `preload` is the normal force before any load is applied.
struct Contact {
  Vector2 position;       ///< of the point of contact, in the object frame
  Vector2 normal;         ///< nonzero, points into the object
  Rational friction{};    ///< coefficient mu >= 0
  Rational stiffness{1};  ///< of the normal spring, k > 0, force per length
  Rational preload{};     ///< P >= 0, force
};

/// How normal forces answer the motion d, with v = P - k N.d (N of a unit normal).
enum class NormalLaw {
  kUnilateral,  ///< c_n = max(0, v): a contact may open
  kBilateral    ///< c_n = v, and c_n >= 0 is required: the literal Eq. 4 of the paper with
                ///< preload
};

/// "unilateral", "bilateral".
const char* to_string(NormalLaw law);

/// Bytes of the name of a unit: axes have room for so many.
inline constexpr std::size_t kMaxUnitLength = 16;

/// Contacts that satisfy the requirements stated at Contact. Immutable.
class Grasp {
 public:
  /// No contacts.
  Grasp() = default;
  /// Throws InputError naming "contacts[i].<member>" when a requirement fails.
  explicit Grasp(std::vector<Contact> contacts, std::string name = {});
  /// Throws also as check_outline does (core/outline.hpp), and if a unit has not 1 to
  /// kMaxUnitLength bytes.
  Grasp(std::vector<Contact> contacts, GraspDescription description);

  const std::string& name() const { return description_.name; }  ///< for people; may be empty
  const GraspDescription& description() const { return description_; }  ///< name and the rest
  const std::vector<Contact>& contacts() const { return contacts_; }    ///< by ContactId
  std::size_t size() const { return contacts_.size(); }                 ///< number of contacts
  /// Throws std::out_of_range when there is no such contact.
  const Contact& operator[](ContactId id) const { return contacts_.at(id.index()); }

  /// The same grasp with every preload replaced. Throws InputError if negative.
  Grasp with_preload(const Rational& preload) const;
  /// The same, each by its own. Requires one for each contact.
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
