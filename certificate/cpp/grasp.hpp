// SPDX-License-Identifier: MIT
/// \file
/// The grasp file, `stickslip-grasp/1`, `/2` or `/3` (FORMAT.md §1, §6, §14 and §15,
/// docs/grasp_file.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bodies.hpp"
#include "number.hpp"

namespace stickslip_check {

using Wrench = std::vector<Bounds>;  ///< its components

/// A contact as the grasp file gives it; what it gives as one number is certain. Or a ratchet
/// or a spring, without position and normal.
struct Contact {
  std::vector<Bounds> position;
  Vector normal;  ///< n0, of any length but 0
  Bounds friction;
  Bounds stiffness;
  Bounds preload;
  Rational slope = 0;     ///< the most that n = n0 + e t0 is turned
  Rational torsion = 0;   ///< e (FORMAT.md §15)
  std::optional<Rational> limit = {};  ///< A (FORMAT.md §16)
  Sight sight = nullptr;  ///< what it sees of several bodies
};

/// The contacts of a grasp, in order; of several bodies, all elements. Those of one body
/// without uncertainty whose numbers are short, which are nearly all of a large grasp, are kept
/// in 144 bytes each.
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

/// What is to be known of several bodies besides their elements.
struct Bodies {
  bool in_space;
  std::vector<std::string> coordinates;      ///< names of them, for whoever reads
  bool has_loads;                            ///< then no case has to be chosen
  std::map<std::string, std::size_t> names;  ///< of the bodies
  std::shared_ptr<const Mechanism> mechanism;
};

struct Grasp {
  Contacts contacts;
  Wrench wrench;                             ///< with cases, what is common to them
  std::map<std::string, Wrench> cases = {};  ///< the wrench of each, by name
  std::optional<Bodies> several = {};        ///< of version 3
  std::optional<Vector> max_motion = {};     ///< B, of D numbers, if it bounds motions

  /// D: of one body 3 in the plane, 6 in space.
  std::size_t dimension() const { return wrench.size(); }
  bool in_space() const { return several ? several->in_space : dimension() == kSpatial; }
};

/// Throws Malformed, with `file` in it.
Grasp read_grasp(std::istream& in, const std::string& file);

}  // namespace stickslip_check
