// SPDX-License-Identifier: MIT
/// \file
/// The part of a cone where some functions are strict, by its generators, and which sets of
/// them are barred (FORMAT.md §4).
#pragma once

#include <cstddef>
#include <vector>

#include "box.hpp"
#include "cone.hpp"

namespace stickslip_check {

/// Functions that are not zero at the solutions that a node stands for.
struct Strict {
  Set conditions;                  ///< of the region's cone
  std::vector<std::size_t> slips;  ///< in space: of these contacts
};

/// A ray, or a line in one of its two directions.
struct Generator {
  const Form* x;
  Set zero;  ///< the strict functions that are zero on it
};

class Generators {
 public:
  /// The cone must outlive this.
  Generators(const Box& box, const Cone& cone, const Strict& strict);
  Generators(const Generators&) = delete;
  Generators& operator=(const Generators&) = delete;

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  const Set& strict() const { return strict_; }
  /// Whether the slip of a contact is strict.
  bool slips(std::size_t contact) const;
  /// Whether all of them together are.
  bool barred() const;

 private:
  std::vector<Form> backwards_;  ///< the lines' second directions
  std::vector<Generator> all_;
  Set strict_;  ///< the cone's conditions by their numbers, then the slips
  std::vector<std::size_t> slips_;
};

/// FORMAT.md "barred", of generators that are added one by one: whether some strict function is
/// zero on all.
class Barring {
 public:
  explicit Barring(const Generators& region) : common_(region.strict()) {}
  void add(const Generator& generator) {
    for (std::size_t k = 0; k < common_.size(); ++k) {
      common_[k] &= k < generator.zero.size() ? generator.zero[k] : 0;
    }
  }
  bool barred() const;

 private:
  Set common_;
};

/// 1 if all functions are >= 0 on all generators, else -1 if all are <= 0, else 0. `*barred` is
/// then whether for each of them the generators on which it is 0 are.
int side(const Generators& region, const std::vector<Form>& functions, bool* barred = nullptr);

}  // namespace stickslip_check
