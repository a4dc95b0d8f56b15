// SPDX-License-Identifier: MIT
/// \file
/// What the checker answers (FORMAT.md §6).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace stickslip_check {

/// The certificate proves `verdict` about the question spelled out here.
struct Accepted {
  std::size_t contacts = 0;
  std::string wrench[3];
  std::optional<std::string> preload;  ///< the value that replaces the file's preloads
  std::string normal_law;
  std::size_t snapped = 0;   ///< contacts whose normals were replaced
  std::string snapped_by;    ///< upper bound of the largest |u - n/|n||, a decimal
  std::string verdict;       ///< "stable" or "unstable"
  std::uint64_t nodes = 0;   ///< of the tree; 0 for a witness
  std::uint64_t leaves = 0;  ///< leaf nodes
  std::uint64_t voids = 0;   ///< void nodes
};

/// A rule of FORMAT.md does not hold. Also thrown inside the checker.
struct Rejected {
  std::string rule;                   ///< as FORMAT.md spells it
  std::optional<std::uint64_t> node;  ///< its number in the list, for trees
  std::string path;                   ///< from the root, such as "slip 3 +, separation 0 open"
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
