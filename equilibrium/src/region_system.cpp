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

/// A contact whose force the region leaves open.
struct OpenContact {
  ContactId contact;
  bool mixed = false;
  std::optional<Sign> slip;
  std::vector<Rational> most;  ///< by ray: the largest a_i there, v_i or max(0, v_i)
  int edge = 0;                ///< of the current extreme point; 0: a_i = 0
};

/// An extreme point of the relaxation on one ray: the edges that the contacts push along.
struct Column {
  std::size_t ray = 0;
  std::vector<std::int8_t> edges;  ///< by open contact
  Vector3 wrench;                  ///< of the load and all contacts
};

void add(LpWork& sum, const LpWork& part) {
  sum.double_pivots += part.double_pivots;
  sum.exact_pivots += part.exact_pivots;
  sum.basis_confirmed = sum.basis_confirmed && part.basis_confirmed;
  sum.tier = std::max(sum.tier, part.tier);
  sum.largest_bits = std::max(sum.largest_bits, part.largest_bits);
}

class ColumnGeneration {
 public:
  ColumnGeneration(const Problem& problem, const Region& region)
      : problem_(problem), rays_(region.cone().directions()) {
    const Vector3 load = coordinates(problem.wrench());
    for (const IntegerVector4& x : rays_) {
      wrenches_.push_back({load[0] * x[3], load[1] * x[3], load[2] * x[3]});
    }
    for (std::size_t i = 0; i < problem.size(); ++i) add_contact(region, ContactId(i));
  }

  std::variant<RelaxedPoint, VirtualWorkLeaf> solve(LpWork* work) {
    if (work != nullptr) *work = LpWork{0, 0, true, LpTier::kInt64, 0};
    while (true) {
      LpWork master_work;
      const LpResult master = stickslip::solve(master_program(), &master_work);
      if (work != nullptr) add(*work, master_work);
      // Without an objective the program is infeasible or optimal.
      if (const auto* optimal = std::get_if<Optimal>(&master)) return point(optimal->point);
      const std::vector<Rational>& farkas = std::get<Infeasible>(master).farkas;
      const Vector3 twist{farkas[0], farkas[1], farkas[2]};
      if (!add_columns(twist, farkas[3])) return VirtualWorkLeaf{primitive_multiple(twist), {}};
    }
  }

 private:
  void add_contact(const Region& region, ContactId contact) {
    const Separation separation = region.separation(problem_, contact);
    if (separation == Separation::kOpen) return;
    OpenContact open{
        contact, separation == Separation::kMixed, slip_for(region, contact), {}, 0};
    for (const IntegerVector4& x : rays_) {
      open.most.push_back(std::max(Rational(0), value(problem_.separation(contact), x)));
    }
    if (!open.mixed) push_along(open, open.slip ? -to_int(*open.slip) : 1);
    if (open.slip && !open.mixed) {
      settled_.emplace_back(contact, open.edge);
    } else {
      open_.push_back(std::move(open));
    }
  }

  /// Without friction both edges of the cone are one: any sign serves.
  std::optional<Sign> slip_for(const Region& region, ContactId contact) const {
    if (problem_.row(contact).friction.is_zero()) return Sign::kPositive;
    return region.slip_sign(problem_, contact);
  }

  void push_along(OpenContact& open, int edge) {
    Wrench change;
    if (edge != 0) change = change + problem_.edge_wrench(open.contact, edge);
    if (open.edge != 0) change = change + Rational(-1) * problem_.edge_wrench(open.contact, open.edge);
    open.edge = edge;
    const Vector3 c = coordinates(change);
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      if (open.most[r].is_zero()) continue;
      for (std::size_t j = 0; j < 3; ++j) wrenches_[r][j] += open.most[r] * c[j];
    }
  }

  /// sum lambda_c (wrench_c, h_c) = (0, 0, 0, 1), lambda >= 0.
  LinearProgram master_program() const {
    LinearProgram program;
    program.add_variables(columns_.size(), VariableKind::kNonNegative);
    for (std::size_t j = 0; j < 4; ++j) {
      std::vector<Rational> row;
      for (const Column& c : columns_) {
        row.push_back(j < 3 ? c.wrench[j] : Rational(rays_[c.ray][3]));
      }
      program.add_row(std::move(row), Relation::kEqual, j < 3 ? 0 : 1);
    }
    return program;
  }

  /// The extreme points that do the most work on the twist, one of each ray where that is
  /// more than -z h. False if there are none: then g(r) <= -z h_r on every ray r, and z > 0.
  bool add_columns(const Vector3& twist, const Rational& z) {
    const Twist y{twist[0], twist[1], twist[2]};
    for (OpenContact& open : open_) {
      const ContactRow& row = problem_.row(open.contact);
      int edge = open.slip ? -to_int(*open.slip) : 1;
      if (!open.slip && power(row.tangent, y).sign() < 0) edge = -1;
      if (open.mixed && power(problem_.edge_wrench(open.contact, edge), y).sign() <= 0)
        edge = 0;
      if (edge != open.edge) push_along(open, edge);
    }
    bool added = false;
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      Rational excess = z * Rational(rays_[r][3]);
      for (std::size_t j = 0; j < 3; ++j) excess += twist[j] * wrenches_[r][j];
      if (excess.sign() <= 0) continue;
      added = true;
      Column column{r, {}, wrenches_[r]};
      for (const OpenContact& open : open_) {
        column.edges.push_back(static_cast<std::int8_t>(open.edge));
      }
      columns_.push_back(std::move(column));
    }
    return added;
  }

  RelaxedPoint point(const std::vector<Rational>& solution) const {
    RelaxedPoint result;
    Vector4 x{};
    std::vector<ContactForce> open_forces(open_.size(), ContactForce{0, 0});
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (solution[c].is_zero()) continue;
      const Column& column = columns_[c];
      for (std::size_t j = 0; j < 4; ++j) x[j] += solution[c] * Rational(rays_[column.ray][j]);
      for (std::size_t q = 0; q < open_.size(); ++q) {
        if (column.edges[q] == 0) continue;
        const Rational a = solution[c] * open_[q].most[column.ray];
        open_forces[q].normal += a;
        open_forces[q].tangential +=
            Rational(column.edges[q]) * problem_.row(open_[q].contact).friction * a;
      }
    }
    result.witness.twist = {x[0], x[1], x[2]};
    result.witness.forces.assign(problem_.size(), ContactForce{0, 0});
    for (const auto& [contact, edge] : settled_) {
      const ContactRow& row = problem_.row(contact);
      const Rational a = row.normal_coefficient(result.witness.twist);
      result.witness.forces[contact.index()] = {a, Rational(edge) * row.friction * a};
    }
    Rational widest = 0;
    const auto consider = [&](Rational gap, ContactSplit split) {
      if (gap <= widest) return;
      widest = std::move(gap);
      result.broken = split;
    };
    for (std::size_t q = 0; q < open_.size(); ++q) {
      const ContactId contact = open_[q].contact;
      const ContactRow& row = problem_.row(contact);
      const Rational& a = open_forces[q].normal;
      const Rational& b = open_forces[q].tangential;
      if (open_[q].mixed) {
        const Rational lawful =
            std::max(Rational(0), row.normal_coefficient(result.witness.twist));
        // An energy of the spring, as the slip's gap is one of friction.
        consider(abs(Rational(a - lawful)) * std::max(a, lawful) / row.stiffness,
                 SeparationSplit{contact});
      }
      if (!open_[q].slip) {
        const Rational slip = power(row.tangent, result.witness.twist);
        consider(row.friction * a * abs(slip) + b * slip, SlipSplit{contact});
      }
      result.witness.forces[contact.index()] = std::move(open_forces[q]);
    }
    return result;
  }

  const Problem& problem_;
  std::vector<IntegerVector4> rays_;                ///< lines both ways
  std::vector<std::pair<ContactId, int>> settled_;  ///< closed, with the edge of their force
  std::vector<OpenContact> open_;
  std::vector<Vector3> wrenches_;  ///< by ray, with all contacts on their current edges
  std::vector<Column> columns_;
};

/// A leaf near the given one whose twist has small entries, if one refutes.
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
    small.twist = primitive(std::move(small.twist));
    if (refutes(problem, region, small)) return small;
  }
  return leaf;
}

}  // namespace

std::variant<RelaxedPoint, VirtualWorkLeaf> solve_region(const Problem& problem,
                                                         const Region& region, LpWork* work) {
  auto outcome = ColumnGeneration(problem, region).solve(work);
  if (const auto* leaf = std::get_if<VirtualWorkLeaf>(&outcome)) {
    require(refutes(problem, region, *leaf), "a Farkas vector does not refute its region");
    return with_small_integers(problem, region, *leaf);
  }
  return outcome;
}

}  // namespace stickslip
