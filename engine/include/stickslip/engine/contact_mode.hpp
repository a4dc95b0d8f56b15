// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The contact mode of each contact in a motion, as the grasping literature has it: a slip
/// state (Haas-Heger et al., RSS 2018, Section IV) with detachment.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// The mode of a contact: open, or closed and sticking or slipping.
///
/// A contact is closed iff v = P - k N.d >= 0. So one that just touches, with v = 0, is closed
/// and has no force. Under the bilateral law every contact is closed.
struct ContactMode {
  bool closed = false;  ///< v >= 0, or the law is bilateral
  /// The sign of T.d; a contact with kZero sticks. An open contact has a sign, too, but
  /// friction acts only where it is closed.
  Sign slip = Sign::kZero;

  /// Compares both members.
  friend bool operator==(ContactMode a, ContactMode b) {
    return a.closed == b.closed && a.slip == b.slip;
  }
};

/// Returns the mode of the contact in the motion d. Exact.
ContactMode mode_of(const Problem& problem, ContactId contact, const Twist& d);

/// Returns the modes of all contacts, by ContactId. O(m).
std::vector<ContactMode> modes_of(const Problem& problem, const Twist& d);

/// Returns the slips alone, one character a contact: "+0-".
std::string slips_text(const std::vector<ContactMode>& modes);

}  // namespace stickslip
