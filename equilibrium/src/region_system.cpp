// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/region_system.hpp"

#include <algorithm>
#include <array>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Rational value(const Vector4& function, const IntegerVector4& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < 4; ++j) sum += function[j] * Rational(x[j]);
  return sum;
}

/// How one contact stands in the program.
struct ContactColumns {
  Separation separation;
  std::optional<Sign> slip;
  std::size_t first = 0;     ///< of its force variables
  std::size_t at_least = 0;  ///< row a_i >= v_i of a mixed contact
};

/// Dense rows that grow with the variables.
class Builder {
 public:
  Builder(const Problem& problem, const Region& region)
      : problem_(problem), directions_(region.cone().directions()) {
    program_.add_variables(directions_.size(), VariableKind::kNonNegative);
    variable_count_ = directions_.size();
    for (std::size_t i = 0; i < problem.size(); ++i) {
      columns_.push_back(
          {region.separation(problem, ContactId(i)), slip_for(region, ContactId(i))});
    }
    for (std::vector<Rational>& row : balance_) row.resize(directions_.size());
    for (std::size_t i = 0; i < problem.size(); ++i) add_contact(ContactId(i));
    add_frame();
  }

  const LinearProgram& program() const { return program_; }

  RelaxedPoint point(const std::vector<Rational>& solution) const {
    RelaxedPoint result;
    Vector4 x{};
    for (std::size_t r = 0; r < directions_.size(); ++r) {
      if (solution[r].is_zero()) continue;
      for (std::size_t j = 0; j < 4; ++j) x[j] += solution[r] * Rational(directions_[r][j]);
    }
    result.witness.twist = {x[0], x[1], x[2]};
    Rational widest = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const ContactColumns& c = columns_[i];
      const ContactRow& row = problem_.rows()[i];
      const Rational v = row.normal_coefficient(result.witness.twist);
      ContactForce force{0, 0};
      if (c.separation != Separation::kOpen) {
        if (c.slip) {
          force.normal = c.separation == Separation::kClosed ? v : solution[c.first];
          force.tangential = Rational(-to_int(*c.slip)) * row.friction * force.normal;
        } else {
          const Rational& plus = solution[c.first];
          const Rational& minus = solution[c.first + 1];
          force = {plus + minus, row.friction * (plus - minus)};
        }
      }
      if (c.separation == Separation::kMixed) {
        const Rational& a = force.normal;
        // Complementarity of a_i >= 0 and a_i >= v_i, as the energy of the spring.
        const Rational gap = a * (a - v) / row.stiffness;
        if (gap > widest) {
          widest = gap;
          result.broken = SeparationSplit{ContactId(i)};
        }
      }
      if (!c.slip) {
        const Rational slip = power(row.tangent, result.witness.twist);
        const Rational gap = row.friction * force.normal * abs(slip) + force.tangential * slip;
        if (gap > widest) {
          widest = gap;
          result.broken = SlipSplit{ContactId(i)};
        }
      }
      result.witness.forces.push_back(std::move(force));
    }
    return result;
  }

  VirtualWorkLeaf leaf(const std::vector<Rational>& farkas) const {
    VirtualWorkLeaf leaf;
    const Vector3 y{farkas[first_balance_], farkas[first_balance_ + 1],
                    farkas[first_balance_ + 2]};
    leaf.twist = primitive_multiple(y);
    const Twist twist{y[0], y[1], y[2]};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const ContactColumns& c = columns_[i];
      if (c.separation != Separation::kMixed) continue;
      const ContactRow& row = problem_.rows()[i];
      const Rational friction = row.friction * power(row.tangent, twist);
      const Rational alpha = power(row.normal, twist) +
                             (c.slip ? Rational(-to_int(*c.slip)) * friction : abs(friction));
      const Rational& multiplier = farkas[c.at_least];
      if (alpha.sign() >= 0 || multiplier.is_zero()) continue;
      leaf.theta.emplace_back(ContactId(i), std::min(Rational(1), multiplier / -alpha));
    }
    return leaf;
  }

 private:
  /// Without friction both edges of the cone are one: any sign serves.
  std::optional<Sign> slip_for(const Region& region, ContactId contact) const {
    if (problem_.row(contact).friction.is_zero()) return Sign::kPositive;
    return region.slip_sign(problem_, contact);
  }

  std::size_t add_force_variable(ContactId contact, int sigma) {
    program_.add_variable(VariableKind::kNonNegative);
    const Vector3 wrench = coordinates(problem_.edge_wrench(contact, sigma));
    for (std::size_t j = 0; j < 3; ++j) {
      balance_[j].resize(variable_count_ + 1);
      balance_[j][variable_count_] = wrench[j];
    }
    return variable_count_++;
  }

  void add_contact(ContactId contact) {
    ContactColumns& c = columns_[contact.index()];
    if (c.separation == Separation::kOpen) return;
    std::vector<Rational> v(directions_.size());
    for (std::size_t r = 0; r < directions_.size(); ++r) {
      v[r] = value(problem_.separation(contact), directions_[r]);
    }
    if (c.separation == Separation::kClosed && c.slip) {
      const Vector3 wrench = coordinates(problem_.edge_wrench(contact, -to_int(*c.slip)));
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t r = 0; r < directions_.size(); ++r) balance_[j][r] += wrench[j] * v[r];
      }
      return;
    }
    if (c.slip) {
      c.first = add_force_variable(contact, -to_int(*c.slip));
    } else {
      c.first = add_force_variable(contact, 1);
      add_force_variable(contact, -1);
    }
    // a_i - (a form in lambda), with a_i the sum of the contact's force variables.
    auto less_form = [&](bool positive_part) {
      std::vector<Rational> row(variable_count_);
      for (std::size_t r = 0; r < directions_.size(); ++r) {
        if (!positive_part || v[r].sign() > 0) row[r] = -v[r];
      }
      for (std::size_t f = c.first; f < variable_count_; ++f) row[f] = 1;
      return row;
    };
    if (c.separation == Separation::kClosed) {
      program_.add_row(less_form(false), Relation::kEqual, 0);
    } else {
      c.at_least = program_.add_row(less_form(false), Relation::kGreaterEqual, 0);
      program_.add_row(less_form(true), Relation::kLessEqual, 0);
    }
  }

  void add_frame() {
    const Vector3 load = coordinates(problem_.wrench());
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t row =
          program_.add_row(std::move(balance_[j]), Relation::kEqual, -load[j]);
      if (j == 0) first_balance_ = row;
    }
    std::vector<Rational> h;
    for (const IntegerVector4& x : directions_) h.emplace_back(x[3]);
    program_.add_row(std::move(h), Relation::kEqual, 1);
  }

  const Problem& problem_;
  std::vector<IntegerVector4> directions_;
  LinearProgram program_;
  std::size_t variable_count_ = 0;
  std::vector<ContactColumns> columns_;
  std::array<std::vector<Rational>, 3> balance_;
  std::size_t first_balance_ = 0;
};

/// A leaf near the given one whose twist has small entries and whose theta are multiples of a
/// small fraction, if one refutes.
VirtualWorkLeaf with_small_integers(const Problem& problem, const Region& region,
                                    const VirtualWorkLeaf& leaf) {
  Integer largest = 0;
  for (const Integer& entry : leaf.twist) largest = std::max<Integer>(largest, abs(entry));
  constexpr long kLargestScale = 1L << 40;
  for (long scale = 1; scale < largest && scale <= kLargestScale; scale *= 4) {
    VirtualWorkLeaf small;
    for (std::size_t j = 0; j < 3; ++j) {
      // Round half up: floor((2 scale y + largest) / (2 largest)).
      Integer quotient;
      const Integer dividend = 2 * scale * leaf.twist[j] + largest;
      const Integer divisor = 2 * largest;
      mpz_fdiv_q(quotient.backend().data(), dividend.backend().data(),
                 divisor.backend().data());
      small.twist[j] = quotient;
    }
    for (const auto& [contact, theta] : leaf.theta) {
      const Rational scaled = theta * Rational(scale) + Rational(1, 2);
      const Rational rounded(Integer(numerator(scaled) / denominator(scaled)), Integer(scale));
      if (!rounded.is_zero()) small.theta.emplace_back(contact, rounded);
    }
    small.twist = primitive(std::move(small.twist));
    if (refutes(problem, region, small)) return small;
  }
  return leaf;
}

}  // namespace

std::variant<RelaxedPoint, VirtualWorkLeaf> solve_region(const Problem& problem,
                                                         const Region& region, LpWork* work) {
  const Builder builder(problem, region);
  const LpResult result = solve(builder.program(), work);
  if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
    const VirtualWorkLeaf leaf = builder.leaf(infeasible->farkas);
    require(refutes(problem, region, leaf), "a Farkas vector does not refute its region");
    return with_small_integers(problem, region, leaf);
  }
  // Without an objective the program is infeasible or optimal.
  return builder.point(std::get<Optimal>(result).point);
}

}  // namespace stickslip
