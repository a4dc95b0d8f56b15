// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/region_program.hpp"

#include <algorithm>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// A contact whose force the region leaves open.
struct OpenContact {
  ContactId contact;
  bool mixed = false;
  std::optional<Sign> slip;
  std::vector<Rational> most;  ///< by generator: the largest a_i there, v_i or max(0, v_i)
  int edge = 0;                ///< of the current extreme point; 0: a_i = 0
};

/// A generator of the region, with what a program sees of it.
struct Generator {
  Vector5 x;
  Vector3 wrench;  ///< of the load, and of all contacts on their current edges
};

/// An extreme point of the relaxation on one generator: the edges that the contacts push along.
struct Column {
  std::size_t generator = 0;
  std::vector<std::int8_t> edges;  ///< by open contact
  Vector3 wrench;                  ///< of the load and all contacts
};

/// Which positive function of a solution is made 1: h, or a strict function of the multiples.
enum class Normalizer { kHeight, kFromLow, kToHigh };

void add(LpWork& sum, const LpWork& part) {
  sum.double_pivots += part.double_pivots;
  sum.exact_pivots += part.exact_pivots;
  sum.basis_confirmed = sum.basis_confirmed && part.basis_confirmed;
  sum.tier = std::max(sum.tier, part.tier);
  sum.largest_bits = std::max(sum.largest_bits, part.largest_bits);
}

class ColumnGeneration {
 public:
  ColumnGeneration(const Problem& problem, const Region& region) : problem_(problem) {
    for (const Ray& ray : region.generators(problem)) {
      Generator g;
      for (std::size_t j = 0; j < 5; ++j) g.x[j] = Rational(ray.x[j]);
      g.wrench = coordinates(g.x[3] * problem.wrench() + g.x[4] * problem.load_growth());
      generators_.push_back(std::move(g));
    }
    for (std::size_t i = 0; i < problem.size(); ++i) add_contact(region, ContactId(i));
  }

  std::variant<RelaxedPoint, VirtualWorkLeaf> solve(LpWork& work) {
    std::vector<Rational> sum;
    for (const Normalizer scale : scales()) {
      auto outcome = optimize(scale, 0, work);
      if (auto* twist = std::get_if<Vector3>(&outcome)) {
        return VirtualWorkLeaf{primitive_multiple(*twist)};
      }
      const std::vector<Rational>& found = std::get<Optimal>(outcome).point;
      sum.resize(found.size());
      for (std::size_t c = 0; c < found.size(); ++c) sum[c] += found[c];
    }
    // No scale is negative anywhere, so all of them are positive in the sum.
    return point(sum);
  }

  /// The largest (sign = 1) or smallest (sign = -1) multiple, or a ray on which it grows
  /// without end.
  std::optional<RelaxedPoint> extreme(int sign, LpWork& work) {
    const auto outcome = optimize(Normalizer::kHeight, sign, work);
    if (std::holds_alternative<Vector3>(outcome)) return std::nullopt;
    if (const auto* unbounded = std::get_if<Unbounded>(&outcome)) return point(unbounded->ray);
    return point(std::get<Optimal>(outcome).point);
  }

 private:
  void add_contact(const Region& region, ContactId contact) {
    const Separation separation = region.separation(problem_, contact);
    if (separation == Separation::kOpen) return;
    OpenContact open{
        contact, separation == Separation::kMixed, slip_for(region, contact), {}, 0};
    for (const Generator& g : generators_) {
      open.most.push_back(std::max(Rational(0), dot(problem_.separation(contact), g.x)));
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
    if (open.edge != 0)
      change = change + Rational(-1) * problem_.edge_wrench(open.contact, open.edge);
    open.edge = edge;
    const Vector3 c = coordinates(change);
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      if (open.most[k].is_zero()) continue;
      for (std::size_t j = 0; j < 3; ++j) generators_[k].wrench[j] += open.most[k] * c[j];
    }
  }

  std::vector<Normalizer> scales() const {
    if (!problem_.is_family()) return {Normalizer::kHeight};
    const MultipleRange& range = problem_.multiples();
    std::vector<Normalizer> scales;
    if (!range.has_low) scales.push_back(Normalizer::kFromLow);
    if (range.high) scales.push_back(Normalizer::kToHigh);
    // Between two finite ends h > 0 follows.
    if (scales.empty() || !range.high) scales.push_back(Normalizer::kHeight);
    return scales;
  }

  Rational value_of(Normalizer scale, const Vector5& x) const {
    const MultipleRange& range = problem_.multiples();
    if (scale == Normalizer::kHeight) return x[3];
    if (scale == Normalizer::kFromLow) return x[4] - range.low * x[3];
    return *range.high * x[3] - x[4];
  }

  /// sum lambda_c (wrench_c, scale_c) = (0, 0, 0, 1), lambda >= 0, with the most of
  /// sign * multiple. Or a twist y with g <= 0 on all generators, = 0 only where the scale is
  /// 0.
  std::variant<Optimal, Unbounded, Vector3> optimize(Normalizer scale, int sign, LpWork& work) {
    while (true) {
      LpWork master_work;
      const LpResult master = stickslip::solve(master_program(scale, sign), &master_work);
      add(work, master_work);
      if (const auto* unbounded = std::get_if<Unbounded>(&master)) return *unbounded;
      const auto* optimal = std::get_if<Optimal>(&master);
      const std::vector<Rational>& y =
          optimal != nullptr ? optimal->dual : std::get<Infeasible>(master).farkas;
      const Vector3 twist{y[0], y[1], y[2]};
      if (add_columns(twist, scale, y[3], optimal != nullptr ? sign : 0)) continue;
      if (optimal != nullptr) return *optimal;
      return twist;
    }
  }

  LinearProgram master_program(Normalizer scale, int sign) const {
    LinearProgram program;
    program.add_variables(columns_.size(), VariableKind::kNonNegative);
    for (std::size_t j = 0; j < 3; ++j) {
      std::vector<Rational> row;
      for (const Column& c : columns_) row.push_back(c.wrench[j]);
      program.add_row(std::move(row), Relation::kEqual, 0);
    }
    std::vector<Rational> scales;
    std::vector<Rational> cost;
    for (const Column& c : columns_) {
      const Vector5& x = generators_[c.generator].x;
      scales.push_back(value_of(scale, x));
      cost.push_back(Rational(-sign) * x[4]);
    }
    program.add_row(std::move(scales), Relation::kEqual, 1);
    program.minimize(std::move(cost));
    return program;
  }

  /// Adds, on each generator, the extreme point that does the most work on the twist, if its
  /// reduced cost is negative: y.wrench + z scale > cost. False if there are none.
  bool add_columns(const Vector3& twist, Normalizer scale, const Rational& z, int sign) {
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
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      const auto& [x, wrench] = generators_[k];
      Rational excess = z * value_of(scale, x) + Rational(sign) * x[4];
      for (std::size_t j = 0; j < 3; ++j) excess += twist[j] * wrench[j];
      if (excess.sign() <= 0) continue;
      added = true;
      Column column{k, {}, wrench};
      for (const OpenContact& open : open_) {
        column.edges.push_back(static_cast<std::int8_t>(open.edge));
      }
      columns_.push_back(std::move(column));
    }
    return added;
  }

  /// The combination of columns, scaled to h = 1; where h = 0, to the multiple 1.
  RelaxedPoint point(const std::vector<Rational>& weights) const {
    RelaxedPoint result;
    Vector5 x{};
    std::vector<ContactForce> open_forces(open_.size(), ContactForce{0, 0});
    for (std::size_t c = 0; c < weights.size(); ++c) {
      if (weights[c].is_zero()) continue;
      const Column& column = columns_[c];
      const Generator& g = generators_[column.generator];
      for (std::size_t j = 0; j < 5; ++j) x[j] += weights[c] * g.x[j];
      for (std::size_t q = 0; q < open_.size(); ++q) {
        if (column.edges[q] == 0) continue;
        const Rational a = weights[c] * open_[q].most[column.generator];
        open_forces[q].normal += a;
        open_forces[q].tangential +=
            Rational(column.edges[q]) * problem_.row(open_[q].contact).friction * a;
      }
    }
    result.is_ray = x[3].is_zero();
    const Rational scale = 1 / (result.is_ray ? x[4] : x[3]);
    for (Rational& entry : x) entry *= scale;
    result.multiple = x[4];
    for (ContactForce& force : open_forces) {
      force.normal *= scale;
      force.tangential *= scale;
    }
    result.witness.twist = {x[0], x[1], x[2]};
    result.witness.forces.assign(problem_.size(), ContactForce{0, 0});
    const auto v_at = [&](ContactId contact) { return dot(problem_.separation(contact), x); };
    for (const auto& [contact, edge] : settled_) {
      const Rational a = v_at(contact);
      result.witness.forces[contact.index()] = {
          a, Rational(edge) * problem_.row(contact).friction * a};
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
        const Rational lawful = std::max(Rational(0), v_at(contact));
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
  std::vector<Generator> generators_;
  std::vector<std::pair<ContactId, int>> settled_;  ///< closed, with the edge of their force
  std::vector<OpenContact> open_;
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
  throw_if_cancelled();
  LpWork total{0, 0, true, LpTier::kInt64, 0};
  auto outcome = ColumnGeneration(problem, region).solve(total);
  if (work != nullptr) *work = total;
  if (const auto* leaf = std::get_if<VirtualWorkLeaf>(&outcome)) {
    require(refutes(problem, region, *leaf), "a Farkas vector does not refute its region");
    return with_small_integers(problem, region, *leaf);
  }
  return outcome;
}

std::optional<MultipleExtent> multiple_extent(const Problem& problem, const Region& region) {
  ColumnGeneration program(problem, region);
  LpWork work;
  std::optional<RelaxedPoint> lowest = program.extreme(-1, work);
  if (!lowest) return std::nullopt;
  return MultipleExtent{std::move(*lowest), *program.extreme(1, work)};
}

}  // namespace stickslip
