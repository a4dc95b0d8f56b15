// SPDX-License-Identifier: MIT
/// \file
/// The box of parameters that trees are about (FORMAT.md §6), and what they need of each
/// contact: its functions at the corners of the box, of which a contact without uncertainty has
/// one (§1, "Rows").
///
/// Of one body the dimension D of twists and wrenches is 3 in the plane and 6 in space. There
/// is no other difference between the two than how many coordinates positions have, and slips:
/// 2 and 1, or 3 and 3. Of several bodies (§14) D is any, and an element that is no contact has
/// a slip as in the plane, which is always 0.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "load.hpp"
#include "number.hpp"
#include "slip_cone.hpp"

namespace stickslip_check {

/// The coordinates of positions, normals and points where twists of one body have so many.
constexpr std::size_t coordinates(std::size_t dimension) {
  return dimension == kSpatial ? 3 : 2;
}

/// FORMAT.md §6, the table; kWrench is of no contact.
enum class Parameter : std::int8_t {
  kX,
  kY,
  kZ,
  kTurn,
  kTurnU,
  kTurnV,
  kFriction,
  kPreload,
  kStiffness,
  kWrench
};
inline constexpr std::array<const char*, 10> kParameterNames{
    "x", "y", "z", "turn", "turn_u", "turn_v", "friction", "preload", "stiffness", "wrench"};
inline constexpr std::size_t kContactParameters = 9;
/// Whether there is such a parameter in space, or in the plane.
constexpr bool is_parameter(Parameter name, bool in_space) {
  const bool of_space =
      name == Parameter::kZ || name == Parameter::kTurnU || name == Parameter::kTurnV;
  return in_space ? name != Parameter::kTurn : !of_space;
}

/// A way in which a normal may turn, and the most: t0 and `slope` in the plane, U and V with
/// the bounds of their parameters in space (FORMAT.md §6). What has no normal has none.
struct Turn {
  Vector way;
  Rational most;
};
std::vector<Turn> turns_of(const Vector& normal, const Rational& slope);

/// The parameters of a contact; one that there is not is 0.
struct ContactBox {
  Sight sight = nullptr;                          ///< what it sees of several bodies
  Vector normal;                                  ///< n0; none of a ratchet or a spring
  std::array<Bounds, kContactParameters> bounds;  ///< by Parameter
  Bounds growth;  ///< of a margin: P^u', whose ends go with those of P'
  /// Of the product of slips (FORMAT.md §1); 0 if they have three numbers.
  Rational gamma = 0;

  const Bounds& operator[](Parameter name) const {
    return bounds[static_cast<std::size_t>(name)];
  }
};

/// s*, so that s*.t is the product of slips (FORMAT.md §1); without torsion s.
Vector conjugate(const ContactBox& contact, Vector s);
/// The square of the length of friction.
Rational friction_square(const ContactBox& contact, const Vector& f);

/// What follows for one contact. A *corner* is one of the box of the position and turns, of
/// which those that are certain do not count. All forms are of points.
struct Row {
  bool certain = true;  ///< all parameters are
  bool slip_certain = true;
  bool v_certain = true;
  Rational tilt;  ///< in space, delta of §7

  /// At each corner N, and the rows of the slip: T in the plane, the three of S in space, or
  /// with torsion four.
  std::vector<Form> normals;
  std::vector<std::vector<Form>> slips;
  Rational scale;       ///< both are multiples of these by it
  SlipProduct product;  ///< in space

  /// v_i at all corners, those of P' and k' included, up to positive factors: one form if it is
  /// certain.
  std::vector<Form> v;
  Rational v_scale;  ///< if all is certain, v_i is a multiple of v[0] by this

  // If not, at each corner v_i(x) is a multiple of pull.d + preload h + growth l, all by one
  // factor.
  std::vector<Form> pulls[2];  ///< for k'_min, k'_max; the last is empty if k' is certain
  Integer preloads[2];         ///< for P'_min, P'_max
  Integer growths[2];          ///< for P^u'_min, P^u'_max

  // In the plane, and of what is no contact:
  std::vector<Form> tau;  ///< at all corners, up to positive factors: one form if certain
  /// N + s T at each corner, for s = -mu_max, -mu_min, mu_min, mu_max; if all is certain, for
  /// the first and the last.
  std::vector<Form> edges[4];

  /// With such edges, v_i(x) (N + s T) is the product of what stands for them here by this; in
  /// space, v_i(x) alone is.
  Rational weight;

  /// Whether the slip has one number, not three or four.
  bool has_edges() const { return slips[0].size() == 1; }
};

/// A contact of a box with what follows for it.
struct BoxContact {
  explicit BoxContact(ContactBox contact);

  ContactBox box;
  Row row;
};

/// Its contacts are shared with the boxes that it was cut from. Those of a grasp
/// without uncertain numbers are made when they are first asked for, as most never are.
class Box {
 public:
  using Maker = std::function<ContactBox(std::size_t)>;

  /// `make` is to make contact i < `size`. If `certain`, none of them has any uncertainty.
  Box(std::size_t size, Maker make, bool certain);

  Load load;  ///< w
  /// What the load gains with each coordinate of a point after h: u, which is 0 unless of a
  /// margin; of a region, u and v.
  std::vector<Vector> growths;

  std::size_t size() const { return contacts_.size(); }
  const ContactBox& contact(std::size_t i) const { return made(i).box; }
  const Row& row(std::size_t i) const { return made(i).row; }
  /// Contact i, not kept if it has not been asked for.
  std::shared_ptr<const BoxContact> passing(std::size_t i) const;

  std::size_t dimension() const { return load.dimension(); }
  /// Of a point: D of the motion, h, and the others.
  std::size_t coordinates() const { return dimension() + 1 + growths.size(); }
  /// Whether it is one point.
  bool certain() const;
  /// The interval of a parameter, or nothing if there is no such contact or number of the load,
  /// or if it has no such parameter.
  const Bounds* find(Parameter name, const Integer& index) const;
  /// The part with another interval of a parameter that there is.
  Box with(Parameter name, std::size_t index, Bounds bounds) const;
  /// The one point q0 in the middle of all intervals.
  Box middle() const;
  /// The box without these contacts, which must be there and increase.
  Box without(const std::vector<std::size_t>& contacts) const;

 private:
  const BoxContact& made(std::size_t i) const;

  Maker make_;
  mutable std::vector<std::shared_ptr<const BoxContact>> contacts_;  ///< null until made
};

}  // namespace stickslip_check
