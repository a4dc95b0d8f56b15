// SPDX-License-Identifier: MIT
/// \file
/// The grasp file, `stickslip-grasp/1` or `/2` (FORMAT.md §1, docs/grasp_file.md).
#pragma once

#include <istream>
#include <map>
#include <string>
#include <vector>

#include "number.hpp"

namespace stickslip_check {

/// A contact as the grasp file gives it.
struct Contact {
  Vector position;
  Vector normal;  ///< of any length but 0
  Rational friction;
  Rational stiffness;
  Rational preload;
};

struct Grasp {
  std::vector<Contact> contacts;
  Vector wrench;                             ///< with cases, what is common to them
  std::map<std::string, Vector> cases = {};  ///< the wrench of each, by name
};

/// Throws Malformed, with `file` in it.
Grasp read_grasp(std::istream& in, const std::string& file);

}  // namespace stickslip_check
