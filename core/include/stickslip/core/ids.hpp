// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Indices that cannot be mixed up. All count from 0.
#pragma once

#include <cstddef>

namespace stickslip {

/// The index of a thing of one kind; `Tag` tells the kinds apart.
template <class Tag>
class Id {
 public:
  /// Makes the id of an index. It is never implicit, as a plain number has no kind.
  constexpr explicit Id(std::size_t index) : index_(index) {}
  constexpr std::size_t index() const { return index_; }  ///< the index, from 0

  /// \{ Compares by index.
  friend constexpr bool operator==(Id a, Id b) { return a.index_ == b.index_; }
  friend constexpr bool operator!=(Id a, Id b) { return a.index_ != b.index_; }
  friend constexpr bool operator<(Id a, Id b) { return a.index_ < b.index_; }
  /// \}

 private:
  std::size_t index_;
};

/// The id of a contact of a grasp, its place in the grasp file.
using ContactId = Id<struct ContactTag>;
/// The id of one of the distinct great circles of an arrangement.
using CircleId = Id<struct CircleTag>;

}  // namespace stickslip
