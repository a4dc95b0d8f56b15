// SPDX-License-Identifier: MIT
/// \file
/// What the checker answers (FORMAT.md §6).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stickslip_check {

/// Multiples of a direction, [low, high] or [low, oo).
struct ResistedInterval {
  std::string low;
  std::optional<std::string> high;
};

/// A margin (FORMAT.md §10): exactly these multiples of the direction are resisted.
struct ResistedMargin {
  std::string direction[3];
  std::vector<ResistedInterval> intervals;  ///< in increasing order
  std::uint64_t segments = 0;
  std::size_t trees = 0;  ///< one for each gap
};

/// The certificate proves `verdict` about the question spelled out here.
struct Accepted {
  std::size_t contacts = 0;
  std::string wrench[3];  ///< of a margin: added to every multiple of the direction
  std::optional<std::string> preload;  ///< the value that replaces the file's preloads
  std::string normal_law;
  std::size_t snapped = 0;  ///< contacts whose normals were replaced
  std::string snapped_by;   ///< upper bound of the largest |u - n/|n||, a decimal
  std::string verdict;      ///< "stable", "unstable" or "margin"
  std::optional<ResistedMargin> margin;
  std::uint64_t nodes = 0;   ///< of the tree or trees; 0 for a witness
  std::uint64_t leaves = 0;  ///< leaf nodes
  std::uint64_t voids = 0;   ///< void nodes
};

/// A rule of FORMAT.md does not hold. Also thrown inside the checker.
struct Rejected {
  std::string rule;                   ///< as FORMAT.md spells it
  std::optional<std::uint64_t> node;  ///< its number in the list, for trees
  std::string path;                   ///< from the root, such as "slip 3 +, separation 0 open";
                                      ///< or such as "segment 3, first point", "interval 0"
  std::string found;
};

/// The grasp or the certificate cannot be read, or the question cannot be asked. Also thrown
/// inside the checker.
struct Malformed {
  std::string file;
  std::string place;
  std::string problem;  ///< what is wrong, and what would be right
};

using Answer = std::variant<Accepted, Rejected, Malformed>;

}  // namespace stickslip_check
