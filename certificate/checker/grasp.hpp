// SPDX-License-Identifier: MIT
/// \file
/// The grasp file, `stickslip-grasp/1` or `/2` (FORMAT.md §1, §6 and §7, docs/grasp_file.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
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

/// The contacts of a grasp, in order. Those without uncertainty whose numbers are short, which
/// are nearly all of a large grasp, are kept in 144 bytes each.
class Contacts {
 public:
  Contacts() = default;
  Contacts(std::initializer_list<Contact> contacts);

  std::size_t size() const { return short_.size(); }
  Contact operator[](std::size_t i) const;
  void push_back(const Contact& contact);
  void set(std::size_t i, const Contact& contact);

 private:
  struct Ratio {
    std::int64_t num = 0;
    std::int64_t den = 0;  ///< 0 if there is no such number
  };
  /// Friction, stiffness, preload, then the position and the normal.
  using Short = std::array<Ratio, 9>;

  std::vector<Short> short_;               ///< without any number if it is one of the others
  std::map<std::size_t, Contact> others_;  ///< by index
};

struct Grasp {
  Contacts contacts;
  Wrench wrench;                             ///< with cases, what is common to them
  std::map<std::string, Wrench> cases = {};  ///< the wrench of each, by name

  /// 3 in the plane, 6 in space.
  std::size_t dimension() const { return wrench.size(); }
};

/// Throws Malformed, with `file` in it.
Grasp read_grasp(std::istream& in, const std::string& file);

}  // namespace stickslip_check
