// SPDX-License-Identifier: GPL-3.0-or-later
#include "few_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include "engine/equilibrium/long_rationals.hpp"
#include "engine/motion/nearest_point.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip {
namespace {

template <class Number>
using Three = std::array<Number, 3>;

/// Returns a + factor * b.
template <class Number>
Three<Number> sum(Three<Number> a, const Number& factor, const Three<Number>& b) {
  for (std::size_t j = 0; j < 3; ++j) a[j] += factor * b[j];
  return a;
}

/// Returns the sum of magnitudes.
template <class Number>
Number size_of(const Three<Number>& a) {
  using std::abs;
  return abs(a[0]) + abs(a[1]) + abs(a[2]);
}

/// The program sum sigma_i columns[i] = target, -1 <= sigma <= 1, with the least sum of cost_i
/// |sigma_i|.
///
/// The dual is to maximize y.target - sum max(0, |y.columns[i]| - cost_i). A column is *basic*
/// while y.columns[i] = cost_i, then 0 <= sigma_i <= 1, or -cost_i, then -1 <= sigma_i <= 0;
/// others have sigma_i = 1, 0 or -1 as y.columns[i] is above these two, between, or below.
/// Three columns are basic; at first they are unit vectors, whose shares have to become 0.
/// Exact if Number is Rational.
template <class Number>
class ShareProgram {
 public:
  using Basis = Three<std::optional<std::size_t>>;  ///< none: the k-th unit vector

  /// `magnitude` is the sum of the absolute values of what target sums up, for its rounding.
  /// Each of the three rows is scaled to entries of at most 1.
  ShareProgram(std::vector<Three<Number>> columns, Three<Number> target,
               const Three<Number>& magnitude)
      : columns_(std::move(columns)), shares_(columns_.size()), is_basic_(columns_.size()) {
    using std::abs;
    for (std::size_t j = 0; j < 3; ++j) {
      Number largest = magnitude[j];
      for (const auto& c : columns_) largest = std::max<Number>(largest, abs(c[j]));
      if (!(largest > 0)) continue;
      target[j] /= largest;
      for (auto& c : columns_) c[j] /= largest;
    }
    rest_ = target;
    for (std::size_t k = 0; k < 3; ++k) basis_[k].column[k] = 1;
  }

  /// Starts from the shares and the basis of another program of the same columns.
  template <class Other>
  void start_from(const ShareProgram<Other>& other) {
    for (std::size_t i = 0; i < columns_.size(); ++i) add_share(i, other.shares_[i]);
    is_basic_ = other.is_basic_;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& index = other.basis_[k].index;
      if (index) basis_[k] = {columns_[*index], index, other.basis_[k].side};
    }
  }

  /// Solves the program. Returns what is left to make up for in the end, as a share: 0 for a
  /// solution. Returns nothing if it did not come to an end.
  std::optional<Number> solve() {
    using std::abs;
    // The costs are all different, so that steps of length 0 are rare. This limit ends the
    // search if they make it go round in circles.
    constexpr int kMostSteps = 300;
    for (int step = 0; step < kMostSteps; ++step) {
      if (!invert()) return std::nullopt;
      std::size_t leaving = 3;
      Number worst = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        Number excess = excess_of(k);
        if (abs(excess) <= abs(worst)) continue;
        worst = std::move(excess);
        leaving = k;
      }
      if (leaving == 3) return Number(0);
      Number left = move(leaving, worst);
      if (left > 0) return left;
    }
    return std::nullopt;
  }

  /// Returns the share, 1, 0 or -1, of a column that is not basic.
  int share(std::size_t column) const { return shares_[column]; }
  Basis basis() const { return {basis_[0].index, basis_[1].index, basis_[2].index}; }

 private:
  template <class Other>
  friend class ShareProgram;
  static constexpr bool kRounds = std::is_same_v<Number, double>;

  struct Basic {
    Three<Number> column{};
    std::optional<std::size_t> index;
    int side = 0;  ///< the sign of y.column
  };
  /// A place on the way of y where the share of a column that is not basic changes by one.
  struct Change {
    Number at;
    std::size_t index;
    int side;  ///< the sign of the cost that y.column passes
  };

  /// Returns 1, and a little more the later a contact comes.
  Number cost(std::size_t index) const {
    return 1 +
           Number(static_cast<long>(index)) / Number(1000 * static_cast<long>(columns_.size()));
  }

  /// Sets rows_ so that rows_[k].column_l = 1 if k = l, else 0. Returns false if it cannot.
  bool invert() {
    const Three<Number>& a = basis_[0].column;
    const Three<Number>& b = basis_[1].column;
    const Three<Number>& c = basis_[2].column;
    rows_ = {cross(b, c), cross(c, a), cross(a, b)};
    const Number determinant = dot(a, rows_[0]);
    if (determinant == 0) return false;
    for (Three<Number>& row : rows_) {
      for (Number& entry : row) entry /= determinant;
    }
    if constexpr (kRounds) {
      return std::isfinite(size_of(rows_[0]) + size_of(rows_[1]) + size_of(rows_[2]) +
                           size_of(rest_));
    }
    return true;
  }

  /// Returns how far the share of a basic column is above its bounds, or (negative) below.
  Number excess_of(std::size_t k) const {
    const Number share = dot(rows_[k], rest_);
    const int high = basis_[k].side > 0 ? 1 : 0;
    const int low = basis_[k].side < 0 ? -1 : 0;
    const Number excess = share > high  ? Number(share - high)
                          : share < low ? Number(share - low)
                                        : Number(0);
    if constexpr (kRounds) {
      if (!(std::fabs(excess) > 1e-13 * moved_ * size_of(rows_[k]))) return 0;
    }
    return excess;
  }

  /// Moves y so that the basic column k leaves at the bound that its share exceeds, past all
  /// changes as long as they leave some of the excess. Returns the part of it that no change
  /// makes up for.
  Number move(std::size_t k, const Number& excess) {
    using std::abs;
    const int sign = excess > 0 ? 1 : -1;
    const Three<Number> direction = sum({}, Number(sign), rows_[k]);
    const std::optional<std::size_t> leaving = basis_[k].index;
    if (leaving) {
      is_basic_[*leaving] = false;
      add_share(*leaving, basis_[k].side == sign ? sign : 0);
    }
    std::vector<Change> changes = changes_along(direction);
    const auto later = [](const Change& a, const Change& b) {
      return std::tie(a.at, a.index, a.side) > std::tie(b.at, b.index, b.side);
    };
    std::make_heap(changes.begin(), changes.end(), later);
    Number left = abs(excess);
    while (!changes.empty()) {
      std::pop_heap(changes.begin(), changes.end(), later);
      const Change change = std::move(changes.back());
      changes.pop_back();
      const Number rate = dot(direction, columns_[change.index]);
      left -= abs(rate);
      if (left > 0) {
        add_share(change.index, rate > 0 ? 1 : -1);
        continue;
      }
      enter(k, change.index, change.side);
      return 0;
    }
    if (leaving) enter(k, *leaving, sign);
    return left;
  }

  void enter(std::size_t k, std::size_t index, int side) {
    add_share(index, -shares_[index]);
    is_basic_[index] = true;
    basis_[k] = {columns_[index], index, side};
  }

  std::vector<Change> changes_along(const Three<Number>& direction) const {
    using std::abs;
    Three<Number> y{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (basis_[k].index)
        y = sum(y, Number(basis_[k].side * cost(*basis_[k].index)), rows_[k]);
    }
    Number least = 0;
    if constexpr (kRounds) least = 1e-11 * size_of(direction);
    std::vector<Change> changes;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (is_basic_[i]) continue;
      const Number rate = dot(direction, columns_[i]);
      if (!(abs(rate) > least * size_of(columns_[i]))) continue;
      const int up = rate > 0 ? 1 : -1;
      for (const int side : {-up, up}) {
        // A share goes from -1 to 0 past -cost, and from 0 to 1 past cost; or down.
        if (side == up ? shares_[i] == up : shares_[i] != -up) continue;
        const Number at = (side * cost(i) - dot(y, columns_[i])) / rate;
        changes.push_back({std::max(Number(0), at), i, side});
      }
    }
    return changes;
  }

  void add_share(std::size_t index, int change) {
    shares_[index] += change;
    rest_ = sum(rest_, Number(-change), columns_[index]);
    if constexpr (kRounds) moved_ += std::abs(change) * size_of(columns_[index]);
  }

  std::vector<Three<Number>> columns_;
  std::vector<int> shares_;  ///< shares by column; 0 for basic ones
  std::vector<char> is_basic_;
  std::array<Basic, 3> basis_;
  std::array<Three<Number>, 3> rows_{};  ///< rows of the basis' inverse
  Three<Number> rest_;                   ///< the target less the shares that are not basic
  double moved_ = 3;  ///< a bound of what was added up in rest_, for its rounding
};

/// Returns x with x_0 a_0 + x_1 a_1 + x_2 a_2 = b; nothing if there is none or more than one.
std::optional<Vector3> solve_three(const std::array<Vector3, 3>& a, const Vector3& b) {
  const Vector3 first = cross(a[1], a[2]);
  const Rational determinant = dot(a[0], first);
  if (determinant.is_zero()) return std::nullopt;
  return Vector3{dot(b, first) / determinant, dot(b, cross(a[2], a[0])) / determinant,
                 dot(b, cross(a[0], a[1])) / determinant};
}

Double3 to_doubles(const Wrench& w) {
  return {to_double(w.x), to_double(w.y), to_double(w.torque)};
}

/// Returns the sum of the load and all forces.
Vector3 total_wrench(const std::vector<ContactRow>& rows, const Wrench& load,
                     const Witness& witness) {
  // The forces times the motion's denominator have short denominators of their own.
  const Rational q = ScaledTwist(witness.twist).scale;
  std::array<std::vector<Rational>, 3> terms;
  const auto add = [&](const Wrench& w) {
    for (std::size_t j = 0; j < 3; ++j) terms[j].push_back(coordinates(w)[j]);
  };
  add(q * load);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ContactForce& force = witness.forces[i];
    if (force.normal.is_zero()) continue;
    add((q * force.normal) * rows[i].normal + (q * force.tangential) * rows[i].tangent);
  }
  Vector3 total;
  for (std::size_t j = 0; j < 3; ++j) total[j] = sum_in_pairs(std::move(terms[j])) / q;
  return total;
}

/// The forces of a motion, of which friction is open at some contacts.
class OpenFriction {
 public:
  OpenFriction(const std::vector<ContactRow>& rows, const Wrench& load,
               const std::vector<Sign>& slips, Witness witness)
      : rows_(rows), load_(load), witness_(std::move(witness)) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      push_along(i, -to_int(slips[i]));
      const bool acts = !rows[i].friction.is_zero() && !witness_.forces[i].normal.is_zero();
      if (acts && slips[i] == Sign::kZero) open_.push_back(i);
    }
  }

  ShareProgram<double> program_in_doubles() const {
    Double3 target{};
    Double3 magnitude{};
    const auto subtract = [&](double factor, const Wrench& wrench) {
      const Double3 w = to_doubles(wrench);
      target = sum(target, -factor, w);
      for (std::size_t j = 0; j < 3; ++j) magnitude[j] += std::fabs(factor * w[j]);
    };
    subtract(1, load_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const ContactForce& force = witness_.forces[i];
      if (force.normal.is_zero()) continue;
      subtract(to_double(force.normal), rows_[i].normal);
      if (!force.tangential.is_zero()) subtract(to_double(force.tangential), rows_[i].tangent);
    }
    std::vector<Double3> columns;
    for (const std::size_t i : open_) {
      const double limit = to_double(rows_[i].friction) * to_double(witness_.forces[i].normal);
      columns.push_back(sum({}, limit, to_doubles(rows_[i].tangent)));
    }
    return {std::move(columns), target, magnitude};
  }

  ShareProgram<Rational> exact_program() {
    std::vector<Vector3> columns;
    for (const std::size_t i : open_) {
      push_along(i, 0);
      columns.push_back(
          coordinates((rows_[i].friction * witness_.forces[i].normal) * rows_[i].tangent));
    }
    return {
        std::move(columns), sum({}, Rational(-1), total_wrench(rows_, load_, witness_)), {}};
  }

  /// Returns the witness with the shares of a program, the basic ones solved for exactly.
  /// Returns nothing if there is no solution, or one beyond the friction that there is.
  template <class Number>
  std::optional<Witness> complete(const ShareProgram<Number>& program) {
    for (std::size_t k = 0; k < open_.size(); ++k) push_along(open_[k], program.share(k));
    const auto basis = program.basis();
    std::array<Vector3, 3> tangents{};
    for (std::size_t k = 0; k < 3; ++k) {
      tangents[k][k] = 1;
      if (basis[k]) tangents[k] = coordinates(rows_[open_[*basis[k]]].tangent);
    }
    // Basic contacts have no friction yet: it has to make up for what is left.
    const std::optional<Vector3> found =
        solve_three(tangents, total_wrench(rows_, load_, witness_));
    if (!found) return std::nullopt;
    Witness result = witness_;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational& b = (*found)[k];
      if (!basis[k] && !b.is_zero()) return std::nullopt;
      if (!basis[k]) continue;
      const std::size_t contact = open_[*basis[k]];
      ContactForce& force = result.forces[contact];
      if (abs(b) > rows_[contact].friction * force.normal) return std::nullopt;
      force.tangential = -b;
    }
    return result;
  }

 private:
  void push_along(std::size_t contact, int edge) {
    ContactForce& force = witness_.forces[contact];
    force.tangential =
        edge == 0 ? Rational(0) : Rational(edge) * rows_[contact].friction * force.normal;
  }

  const std::vector<ContactRow>& rows_;
  const Wrench& load_;
  Witness witness_;
  std::vector<std::size_t> open_;
};

}  // namespace

std::optional<Witness> with_few_shares(const std::vector<ContactRow>& rows, const Wrench& load,
                                       const std::vector<Sign>& slips, Witness witness) {
  OpenFriction friction(rows, load, slips, std::move(witness));
  ShareProgram<double> proposal = friction.program_in_doubles();
  const std::optional<double> left = proposal.solve();
  if (left) {
    constexpr double kFar = 1e-6;
    if (*left > kFar) return std::nullopt;
    if (auto found = friction.complete(proposal)) return found;
  }
  ShareProgram<Rational> program = friction.exact_program();
  if (left) program.start_from(proposal);
  std::optional<Rational> exactly_left = program.solve();
  if (!exactly_left) {  // rounding spoiled the basis: start anew
    program = friction.exact_program();
    exactly_left = program.solve();
  }
  if (exactly_left != Rational(0)) return std::nullopt;
  return friction.complete(program);
}

std::optional<Witness> find_forces(const Problem& problem, const Twist& d) {
  Witness witness{d, {}};
  std::vector<Sign> slips;
  const ScaledTwist scaled(d);
  for (const ContactRow& row : problem.rows()) {
    const Rational v = scaled.normal_coefficient(row);
    if (v.sign() < 0 && problem.law() == NormalLaw::kBilateral) return std::nullopt;
    witness.forces.push_back({v.sign() > 0 ? v / scaled.scale : Rational(0), 0});
    slips.push_back(sign_of(power(row.tangent, scaled.twist)));
  }
  return with_few_shares(problem.rows(), problem.wrench(), slips, std::move(witness));
}

}  // namespace stickslip
