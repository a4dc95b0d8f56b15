// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a search finds out about the children of a split before it chooses that split.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "law_forces.hpp"

namespace stickslip::search_detail {

/// A split by the separation or the slip of a contact.
struct SplitChoice {
  bool is_slip = false;
  std::size_t contact = 0;
  std::size_t order = 0;  ///< how many splits break a law more
};

/// A search's knowledge of children that its walk in preorder has not entered yet, and of the
/// splits that have served before.
class Foresight {
 public:
  /// The result on each child of a split; nothing where none was sought.
  using Children = std::vector<std::optional<LawForces::Found>>;

  /// Takes the number of contacts.
  explicit Foresight(std::size_t contacts);

  /// Enters a node of this depth. Returns what was found on it when it was a child.
  std::optional<LawForces::Found> enter(std::size_t depth);
  /// Notes the children of the node entered last.
  void expect(Children children);

  /// Orders splits by how often they left one child at most, those that did most often first;
  /// equals keep their order.
  void sort(std::vector<SplitChoice>& splits) const;
  /// Learns whether a split left one child at most.
  void learn(const SplitChoice& split, bool has_served);

 private:
  struct Child {
    std::size_t depth;
    std::optional<LawForces::Found> found;
  };
  struct Record {
    double served = 1;
    double tried = 2;
  };

  std::size_t index_of(const SplitChoice& split) const {
    return split.contact + (split.is_slip ? records_.size() / 2 : 0);
  }

  std::size_t depth_ = 0;        ///< of the node entered last
  std::vector<Child> children_;  ///< the one to be entered next comes last
  std::vector<Record> records_;  ///< by contact, of separations and then of slips
};

}  // namespace stickslip::search_detail
