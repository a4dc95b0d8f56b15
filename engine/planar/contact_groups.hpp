// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Contacts in groups, and these in groups, like beside like. A group has boxes that hold the
/// coefficients of its contacts' functions, and sums: what is so for all of a group is found,
/// and added up, at once (bounding volume hierarchies; Ericson, "Real-Time Collision
/// Detection", 2005, chapter 6).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "stickslip/engine/problem.hpp"

namespace stickslip {

struct ContactDoubles;

/// An integer vector whose entries have at most 61 bits, or a note that it has longer ones.
struct ShortVector5 {
  /// Takes the entries of this vector.
  explicit ShortVector5(const IntegerVector5& x);
  std::array<std::int64_t, 5> entries{};  ///< the entries, if it is short
  bool is_short = true;                   ///< the vector is short
};

/// Returns the sign of a.b, or nothing unless both are short.
inline std::optional<int> short_sign(const ShortVector5& a, const ShortVector5& b) {
  if (!a.is_short || !b.is_short) return std::nullopt;
  __extension__ using Wide = __int128;
  Wide sum = 0;
  for (std::size_t j = 0; j < 5; ++j) sum += static_cast<Wide>(a.entries[j]) * b.entries[j];
  return (sum > 0) - (sum < 0);
}

/// Positive multiples of a contact's tau_i and v_i.
struct ContactPlanes {
  ShortVector5 slip;        ///< a multiple of tau_i
  ShortVector5 separation;  ///< a multiple of v_i
};

/// A box around vectors of n coefficients in double precision. Each coefficient is within four
/// unit roundoffs of an exact one, and 0 where that is 0.
template <std::size_t n>
struct CoefficientBox {
  std::array<double, n> center{};  ///< its middle
  std::array<double, n> radius{};  ///< half its widths
  /// A bound of the rounding of center.x -+ radius.|x| as bounds of the exact functions, at
  /// points with entries of at most 1 as in_doubles gives them.
  double error = 0;
};

/// Some contacts. The boxes are of functions scaled by 1/|n|, which changes no sign; the sums
/// are not.
struct ContactGroup {
  std::uint32_t begin = 0;  ///< \{ in ContactGroups::order()
  std::uint32_t end = 0;    ///< \}
  std::uint32_t second =
      0;  ///< the second of its two parts, the first being the next group; 0: no parts

  CoefficientBox<5> separation;    ///< v_i / k_i: minus N, and preloads over stiffness
  CoefficientBox<3> slip;          ///< T
  CoefficientBox<3> friction;      ///< mu T
  double stiffest = 0;             ///< the largest k_i |n|^2
  bool is_frictionless = true;     ///< all contacts are
  bool has_one_slip_plane = true;  ///< all contacts have the same

  double normal_work[3][5] = {};    ///< sum of N (x) v, for the work y.(...).x
  double friction_work[3][5] = {};  ///< sum of mu T (x) v
  double magnitude[3][5] = {};      ///< sum of (|N| + mu |T|) (x) |v|
  double law[5] = {};               ///< sum of v
  double stiffness = 0;             ///< sum of k
};

/// The numbers that are asked of each contact on each region; side by side in memory in the
/// order in which they are asked for.
struct ContactRowDoubles {
  /// \{ The members of ContactDoubles with these names.
  std::array<double, 5> separation;
  double separation_error;
  std::array<double, 3> slip;
  double slip_error;
  std::array<double, 3> normal;
  std::array<double, 3> friction;
  bool frictionless;
  /// \}
};

/// A binary tree of groups, in preorder. O(m log m) to make.
class ContactGroups {
 public:
  ContactGroups() = default;
  /// Groups contacts; `length` makes torques and forces comparable. Groups of fewer than two
  /// times `smallest`, at least 1, have no parts.
  ContactGroups(const Problem& problem, const std::vector<ContactDoubles>& contacts,
                double length, std::size_t smallest);

  /// Returns the groups, that of all contacts first; empty if there are no contacts.
  const std::vector<ContactGroup>& groups() const { return groups_; }
  /// Returns whether all groups without parts are single contacts.
  bool are_single() const { return are_single_; }
  /// Returns the contacts, a group's beside each other.
  const std::vector<std::uint32_t>& order() const { return order_; }
  /// \{ Returns numbers of the contacts in this order.
  const std::vector<ContactRowDoubles>& rows() const { return rows_; }
  const std::vector<ContactPlanes>& planes() const { return planes_; }
  /// \}

 private:
  bool are_single_ = false;
  std::vector<ContactRowDoubles> rows_;
  std::vector<ContactPlanes> planes_;
  std::vector<ContactGroup> groups_;
  std::vector<std::uint32_t> order_;
};

}  // namespace stickslip
