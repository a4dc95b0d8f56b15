// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The largest work that the force of a contact in the plane can do on a virtual twist when its
/// geometry is uncertain: a product of two functions that are multilinear in it, bounded by
/// Bernstein coefficients (certificate/FORMAT.md, section 4), in any kind of number.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace stickslip {

/// The pairs (c, c') of corners of a cube of n dimensions, sorted by the sum c + c' into 3^n
/// cells. The cells are those of the Bernstein coefficients of a product of two multilinear
/// functions.
struct CornerPairs {
  std::size_t corners;             ///< 2^n
  std::size_t cells;               ///< 3^n
  std::vector<std::size_t> cell;   ///< the cell of the pair c * corners + c'
  std::vector<std::size_t> share;  ///< 2^n over the number of pairs in a cell

  /// Returns the pairs for so many corners: 1, 2, 4 or 8.
  static const CornerPairs& of(std::size_t corners);
};

/// The two ends of P' and of k'.
template <class Number>
struct SpringEnds {
  std::array<Number, 2> preloads;     ///< P'
  std::array<Number, 2> stiffnesses;  ///< k'
};

/// The force that does the most work: friction of a slope s, at these ends, in this cell.
template <class Number>
struct Strongest {
  Number bound{0};            ///< the work, times the number of corners
  std::size_t friction = 2;   ///< the index of s; 2: none, the force is 0
  std::size_t preload = 0;    ///< the index of the end of P'
  std::size_t stiffness = 0;  ///< the index of the end of k'
  std::size_t cell = 0;       ///< the cell, unless `product`
  std::size_t corner = 0;     ///< the corner where alpha is largest, if `product`
  /// Whether the bound is the product of the largest alpha and the largest v.
  bool product = false;
};

/// Computes the bound b_i(r) of the work of one contact on a virtual twist.
template <class Number>
class CornerWork {
 public:
  /// Takes `ends`, which must outlive this, and alpha by slope and corner. With `mixed` the
  /// contact may be open.
  CornerWork(const SpringEnds<Number>& ends, std::vector<std::vector<Number>> alpha, bool mixed)
      : ends_(ends),
        pairs_(CornerPairs::of(alpha.front().size())),
        mixed_(mixed),
        alpha_(std::move(alpha)) {
    for (std::size_t s = 0; s < alpha_.size(); ++s) {
      const std::vector<Number>& of = alpha_[s];
      const auto largest = std::max_element(of.begin(), of.end());
      largest_[s] = static_cast<std::size_t>(largest - of.begin());
      rises_[s] = *largest > 0;
      falls_[s] = *std::min_element(of.begin(), of.end()) < 0;
      for (std::size_t pair = 0; pair < pairs_.cell.size(); ++pair) {
        sums_[s][pairs_.cell[pair]] += of[pair / pairs_.corners];
      }
    }
  }

  /// Returns the strongest force at a height h >= 0; `rises` has N.d at each corner.
  Strongest<Number> at(const Number& h, const Number* rises) const {
    Strongest<Number> best;
    for (std::size_t s = 0; s < alpha_.size(); ++s) {
      if (mixed_ && !rises_[s]) continue;
      const Strongest<Number> here =
          mixed_ && falls_[s] ? product(s, h, rises) : bernstein(s, h, rises);
      const bool first = best.friction == 2 && !mixed_;
      if (first || here.bound > best.bound) best = here;
    }
    return best;
  }

  /// Returns whether some alpha is above 0.
  bool pushes() const { return rises_[0] || rises_[1]; }
  /// Returns whether alpha is further from 0 than `error` at all corners.
  bool is_clear(const Number& error) const {
    for (const std::vector<Number>& of : alpha_) {
      for (const Number& alpha : of) {
        if (!(alpha > error || alpha < -error)) return false;
      }
    }
    return true;
  }
  const CornerPairs& pairs() const { return pairs_; }  ///< the pairs of its corners

 private:
  Strongest<Number> bernstein(std::size_t s, const Number& h, const Number* rises) const {
    std::array<Number, 27> moved{};
    for (std::size_t pair = 0; pair < pairs_.cell.size(); ++pair) {
      moved[pairs_.cell[pair]] +=
          alpha_[s][pair / pairs_.corners] * rises[pair % pairs_.corners];
    }
    Strongest<Number> best;
    for (std::size_t k = 0; k < pairs_.cells; ++k) {
      const std::size_t p = sums_[s][k] > 0 ? 1 : 0;
      const std::size_t q = moved[k] > 0 ? 0 : 1;
      Number bound = (h * ends_.preloads[p] * sums_[s][k] - ends_.stiffnesses[q] * moved[k]) *
                     Number(pairs_.share[k]);
      if (best.friction == 2 || bound > best.bound) best = {std::move(bound), s, p, q, k};
    }
    return best;
  }

  Strongest<Number> product(std::size_t s, const Number& h, const Number* rises) const {
    const Number least = *std::min_element(rises, rises + pairs_.corners);
    const std::size_t q = least > 0 ? 0 : 1;
    const Number v = h * ends_.preloads[1] - ends_.stiffnesses[q] * least;
    if (!(v > 0)) return {Number(0)};
    return {alpha_[s][largest_[s]] * v * Number(pairs_.corners), s, 1, q, 0, largest_[s], true};
  }

  const SpringEnds<Number>& ends_;
  const CornerPairs& pairs_;
  bool mixed_;
  std::vector<std::vector<Number>> alpha_;
  std::array<std::array<Number, 27>, 2> sums_{};  ///< alpha summed over the pairs of each cell
  std::array<std::size_t, 2> largest_{};
  std::array<bool, 2> rises_{};
  std::array<bool, 2> falls_{};
};

}  // namespace stickslip
