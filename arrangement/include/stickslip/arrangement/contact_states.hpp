// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Slip states and contact modes of grasps in space, and of several bodies: the faces of an
/// arrangement of contact rows.
///
/// A contact has a row N of its normal and a row S_j = (v_j, p x v_j) for each of its k *lines
/// of slip*, directions v_j across the normal. The signs of S_j.d tell in which of 2k sectors,
/// or on which of 2k rays between them, the contact slips; it sticks where all are 0 (for k >=
/// 2). A point of a body slips relative to the other body, and N.d > 0 moves them apart. For a
/// contact in the plane k is 1, v_1 the tangent, and the states are those of slip_states.hpp.
///
/// Source: Haas-Heger et al., RSS 2018, Sections IV and VII (slip states; "a high number of
/// hyperplanes per contact"); Huang, Cheng and Mason, WAFR 2020 (contact modes).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/arrangement/faces.hpp"
#include "stickslip/core/box.hpp"

namespace stickslip {

/// The signs that tell states apart, and the motions that are looked at.
enum class StateSet {
  kSlip,     ///< the signs of slip, for all motions, as if no contact opened: slip states
  kFull,     ///< those, and the sign of N.d: apart, rolling or sliding, or pressed together
  kClosed,   ///< the signs of slip for motions on which all contacts stay closed, N.d = 0
  kOpening,  ///< open or closed, for motions that press nothing together, N.d >= 0 (CS)
  kContact   ///< contact modes: those, and of closed contacts the signs of slip (SS)
};

/// The choice of lines of slip.
struct SlipLines {
  std::size_t count = 0;  ///< k; 0 stands for 2 in space, and for 1, the tangent, in the plane
  /// Whether directions that are irrational may be replaced by rational ones near them.
  bool snap = false;
  /// Directions for each contact in place of these.
  std::optional<std::vector<std::vector<RationalRow>>> given{};
};

/// The largest number of lines of slip of a contact.
inline constexpr std::size_t kMostSlipLines = 64;

/// The rows of a contact as functions of motions; positive multiples, in integers.
struct ContactRows {
  Row normal;              ///< N
  std::vector<Row> lines;  ///< S_1, ..., S_k
};

/// Returns the directions of the lines of slip that a normal in space has by default. With
/// angles theta_j = pi j / k, v_j has the direction of cos(theta_j) a + sin(theta_j) b, where a
/// is n x e for the axis e with the least |n.e| (the first of these) and b is n x a, both for
/// unit length. So k = 1 is a, and k = 2 is a and b. If n has a rational length, k = 4 is
/// rational as well; otherwise `snap` gives rational directions within 1/500 radian. Throws
/// InputError with the place "lines" if directions are irrational and `snap` is false.
std::vector<Vector3> default_slip_lines(const RationalRow& normal, std::size_t count,
                                        bool snap);

/// Returns D, the number of coordinates of motions: 3, 6, or that of a mechanism.
std::size_t motion_coordinates(const GraspBox& grasp);

/// Returns the directions of the lines of slip of each contact of one grasp. Throws InputError
/// as contact_rows_for_states() does.
std::vector<std::vector<RationalRow>> slip_directions(const GraspBox& grasp,
                                                      const SlipLines& lines);

/// Returns the rows of all contacts of one grasp: positions and normals are certain. Throws
/// InputError if the choice of lines does not suit it: the number of lists, a direction that is
/// not across its normal, is 0 or is parallel to another, more than one line in the plane
/// (place "lines"), or as default_slip_lines() does.
std::vector<ContactRows> contact_rows_for_states(const GraspBox& grasp, const SlipLines& lines);

/// Returns the signs of slip of each contact of one grasp at a motion d, a sign for each of its
/// lines, in the words of StatePlanes::text. Throws InputError as contact_rows_for_states()
/// does.
std::vector<std::string> slips_at(const GraspBox& grasp, const RationalRow& motion,
                                  const SlipLines& lines = {});

/// The arrangement of a set of states.
struct StatePlanes {
  /// A contact by the indices of its planes.
  struct Contact {
    std::optional<std::size_t> normal;  ///< the plane of N, if the set has one
    std::vector<std::size_t> lines;     ///< the planes of its lines of slip
  };
  StateSet set = StateSet::kSlip;  ///< whose states these are
  std::size_t coordinates = 0;     ///< D
  std::vector<FacePlane> planes;   ///< N and S of the contacts, one after the other
  std::vector<Contact> contacts;   ///< the contacts, in order

  /// Returns the state of a face as text, contacts with a blank between them: a sign for each
  /// line; "o" for a contact that opens; with StateSet::kOpening "c" for one that is closed;
  /// with StateSet::kFull the sign of N.d and a "|" first.
  std::string text(const Face& face) const;
  /// Appends the same text.
  void append_text(std::string& to, const Face& face) const;
};

/// Returns the arrangement of a set of states of these contacts. Throws InputError with the
/// place "contacts" if motions have more than kMostFaceCoordinates coordinates, or if there are
/// more than kMostFacePlanes planes.
StatePlanes state_planes(std::size_t coordinates, const std::vector<ContactRows>& contacts,
                         StateSet set);

}  // namespace stickslip
