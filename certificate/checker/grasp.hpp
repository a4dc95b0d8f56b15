// SPDX-License-Identifier: MIT
/// \file
/// The grasp file, `stickslip-grasp/1` or `/2` (FORMAT.md §1, §6 and §7, docs/grasp_file.md).
#pragma once

#include <istream>
#include <map>
#include <string>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

using Wrench = std::vector<Bounds>;  ///< its components

/// A contact as the grasp file gives it; what it gives as one number is certain.
struct Contact {
  std::vector<Bounds> position;
  Vector normal;  ///< n0, of any length but 0
  Bounds friction;
  Bounds stiffness;
  Bounds preload;
  Rational slope = 0;  ///< the most that n = n0 + e t0 is turned
};

struct Grasp {
  std::vector<Contact> contacts;
  Wrench wrench;                             ///< with cases, what is common to them
  std::map<std::string, Wrench> cases = {};  ///< the wrench of each, by name

  /// 3 in the plane, 6 in space.
  std::size_t dimension() const { return wrench.size(); }
};

/// Throws Malformed, with `file` in it.
Grasp read_grasp(std::istream& in, const std::string& file);

}  // namespace stickslip_check
