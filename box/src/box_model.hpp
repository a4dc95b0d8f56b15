// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Contacts of a box at the corners of what is uncertain of their geometry, and the largest
/// work that a contact's force can do (certificate/FORMAT.md, section 6), in any kind of
/// number.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "stickslip/box/parameter_box.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/search/region.hpp"

namespace stickslip::box_detail {

/// The pairs (c, c') of corners of a cube of n dimensions by the sum c + c', which is one of
/// 3^n cells: the Bernstein coefficients of a product of two functions that are multilinear.
struct CornerPairs {
  std::size_t corners;             ///< 2^n
  std::size_t cells;               ///< 3^n
  std::vector<std::size_t> cell;   ///< of the pair c * corners + c'
  std::vector<std::size_t> share;  ///< 2^n over the number of pairs of a cell

  /// For n = 0 to 3.
  static const CornerPairs& of(std::size_t dimensions);
};

/// Numbers of one contact, up to positive factors: N and T times `length`, mu times `cone`, k'
/// times `law` and P' times `law` and `length`. In doubles all factors are 1.
template <class Number>
struct ContactNumbers {
  std::vector<std::array<Number, 3>> normals;   ///< N by corner
  std::vector<std::array<Number, 3>> tangents;  ///< T by corner
  std::array<Number, 2> frictions;              ///< ends
  std::array<Number, 2> preloads;               ///< ends
  std::array<Number, 2> stiffnesses;            ///< ends
  Number length;
  Number cone;
  Number law;
};

/// Which force does the most work: friction of slope s, at these ends, in this cell.
template <class Number>
struct Strongest {
  Number bound{0};           ///< times the contact's factor
  std::size_t friction = 2;  ///< index of s; 2: none, the force is 0
  std::size_t preload = 0;   ///< end
  std::size_t stiffness = 0;
  std::size_t cell = 0;    ///< unless `product`
  std::size_t corner = 0;  ///< where alpha is largest, if `product`
  bool product = false;
};

/// b_i(r) of a virtual twist y, for one contact.
template <class Number>
class ContactWork {
 public:
  ContactWork(const ContactNumbers<Number>& contact, const std::array<Number, 3>& y,
              const std::optional<Sign>& slip, Separation separation)
      : contact_(contact),
        pairs_(CornerPairs::of(dimensions(contact))),
        mixed_(separation == Separation::kMixed) {
    const auto& mu = contact.frictions;
    if (!slip || *slip == Sign::kZero) {
      slopes_ = {Number(-mu[1]), mu[1]};
    } else if (*slip == Sign::kPositive) {
      slopes_ = {Number(-mu[0]), Number(-mu[1])};
    } else {
      slopes_ = mu;
    }
    slope_count_ = slopes_[0] == slopes_[1] ? 1 : 2;
    for (std::size_t s = 0; s < slope_count_; ++s) {
      std::array<Number, 8>& alpha = alpha_[s];
      for (std::size_t c = 0; c < pairs_.corners; ++c) {
        alpha[c] = contact.cone * dot(y, contact.normals[c]) +
                   slopes_[s] * dot(y, contact.tangents[c]);
        if (alpha[c] > alpha[largest_[s]]) largest_[s] = c;
        falls_[s] = falls_[s] || alpha[c] < 0;
      }
      rises_[s] = alpha[largest_[s]] > 0;
      for (std::size_t pair = 0; pair < pairs_.cell.size(); ++pair) {
        sums_[s][pairs_.cell[pair]] += alpha[pair / pairs_.corners];
      }
    }
  }

  static std::size_t dimensions(const ContactNumbers<Number>& contact) {
    std::size_t n = 0;
    while ((std::size_t{1} << n) < contact.normals.size()) ++n;
    return n;
  }

  /// At h >= 0, from N.d by corner.
  Strongest<Number> at(const Number& h, const Number* rises) const {
    Strongest<Number> best;
    for (std::size_t s = 0; s < slope_count_; ++s) {
      if (mixed_ && !rises_[s]) continue;
      const Strongest<Number> here =
          mixed_ && falls_[s] ? product(s, h, rises) : bernstein(s, h, rises);
      const bool first = best.friction == 2 && !mixed_;
      if (first || here.bound > best.bound) best = here;
    }
    return best;
  }

  const Number& slope(std::size_t s) const { return slopes_[s]; }
  /// Whether some alpha is above 0.
  bool pushes() const { return rises_[0] || rises_[1]; }
  /// Whether alpha is further from 0 than `error` at all corners, if its sign matters.
  bool is_clear(const Number& error) const {
    if (!mixed_) return true;
    for (std::size_t s = 0; s < slope_count_; ++s) {
      for (std::size_t c = 0; c < pairs_.corners; ++c) {
        const Number& alpha = alpha_[s][c];
        if (!(alpha > error || alpha < -error)) return false;
      }
    }
    return true;
  }
  const CornerPairs& pairs() const { return pairs_; }

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
      Number bound =
          (h * contact_.preloads[p] * sums_[s][k] - contact_.stiffnesses[q] * moved[k]) *
          Number(pairs_.share[k]);
      if (best.friction == 2 || bound > best.bound) best = {std::move(bound), s, p, q, k};
    }
    return best;
  }

  Strongest<Number> product(std::size_t s, const Number& h, const Number* rises) const {
    const Number least = *std::min_element(rises, rises + pairs_.corners);
    const std::size_t q = least > 0 ? 0 : 1;
    const Number v = h * contact_.preloads[1] - contact_.stiffnesses[q] * least;
    if (!(v > 0)) return {Number(0)};
    return {alpha_[s][largest_[s]] * v * Number(pairs_.corners), s, 1, q, 0, largest_[s], true};
  }

  const ContactNumbers<Number>& contact_;
  const CornerPairs& pairs_;
  bool mixed_;
  std::size_t slope_count_ = 0;
  std::array<Number, 2> slopes_;
  std::array<std::array<Number, 8>, 2> alpha_{};  ///< by corner
  std::array<std::array<Number, 27>, 2> sums_{};  ///< of alpha over the pairs, by cell
  std::array<std::size_t, 2> largest_{};
  std::array<bool, 2> rises_{};
  std::array<bool, 2> falls_{};
};

/// One contact of a box.
struct BoxContact {
  explicit BoxContact(const ParameterContact& contact);

  ContactNumbers<Integer> exact;
  Rational weight;  ///< of its bounds in integers
  /// \{ Without repetition, primitive: tau at the corners of the geometry, and v at those of
  /// all parameters. One only: certain.
  std::vector<IntegerVector5> slips;
  std::vector<IntegerVector5> separations;
  /// \}
  ContactNumbers<double> rounded;  ///< torques over `length`
};

/// All contacts and the load.
struct BoxModel {
  explicit BoxModel(const ParameterBox& box);

  std::vector<BoxContact> contacts;
  WrenchBox wrench;
  NormalLaw law;
  double length = 1;  ///< a typical distance, over which torques and forces are compared
  std::array<std::array<double, 2>, 3> load{};  ///< ends; torque over `length`
  double force = 1;                             ///< a typical force
  bool is_point = false;                        ///< one grasp: nothing is uncertain
  /// Whether all entries are 0 or between 2^-200 and 2^200: otherwise doubles decide nothing.
  bool is_moderate = true;
};

}  // namespace stickslip::box_detail
