// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What each contact does in a motion: the contact mode of the grasping literature, a slip
/// state (Haas-Heger et al., RSS 2018, Section IV) with detachment.
#pragma once

#include <string>
#include <vector>

#include "stickslip/core/sign.hpp"
#include "stickslip/engine/problem.hpp"

namespace stickslip {

/// Open, or closed and sticking or slipping.
///
/// A contact is closed iff v = P - k N.d >= 0: one that just touches, v = 0, is closed and has
/// no force. Under the bilateral law every contact is closed.
struct ContactMode {
  bool closed = false;  ///< v >= 0, or the law is bilateral
  /// The sign of T.d: kZero sticks. An open contact has it too, but friction only where it is
  /// closed.
  Sign slip = Sign::kZero;

  /// Both alike.
  friend bool operator==(ContactMode a, ContactMode b) {
    return a.closed == b.closed && a.slip == b.slip;
  }
};

/// What the contact does in the motion d. Exact.
ContactMode mode_of(const Problem& problem, ContactId contact, const Twist& d);

/// The same of all contacts, by ContactId. O(m).
std::vector<ContactMode> modes_of(const Problem& problem, const Twist& d);

/// The slips alone, one character a contact: "+0-".
std::string slips_text(const std::vector<ContactMode>& modes);

}  // namespace stickslip
