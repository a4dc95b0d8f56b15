// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/region_program.hpp"

#include <algorithm>

#include "stickslip/core/cancellation.hpp"
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

/// A generator of the region's motions and loads (load_range.hpp).
struct Generator {
  std::optional<std::size_t> ray;  ///< none: the recession of the loads
  Rational h;
  Rational multiple;  ///< times h
  Vector3 load;       ///< times h
};

/// An extreme point of the relaxation on one generator: the edges that the contacts push along.
struct Column {
  std::size_t generator = 0;
  std::vector<std::int8_t> edges;  ///< by open contact
  Vector3 wrench;                  ///< of the load and all contacts
};

/// Which positive function of a solution is made 1: h, or a strict function of the loads.
enum class Normalizer { kHeight, kAboveLow, kBelowHigh };

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
      : problem_(problem), rays_(region.cone().directions()), wrenches_(rays_.size()) {
    for (std::size_t r = 0; r < rays_.size(); ++r) add_generators(r);
    if (const auto& direction = problem.load().recession()) {
      generators_.push_back({std::nullopt, 0, 1, coordinates(*direction)});
    }
    for (std::size_t i = 0; i < problem.size(); ++i) add_contact(region, ContactId(i));
  }

  std::variant<RelaxedPoint, VirtualWorkLeaf> solve(LpWork& work) {
    std::vector<Rational> sum;
    for (const Normalizer scale : scales()) {
      auto outcome = optimize(scale, 0, work);
      if (auto* twist = std::get_if<Vector3>(&outcome)) {
        return VirtualWorkLeaf{primitive_multiple(*twist), {}};
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
  void add_generators(std::size_t r) {
    const Rational h(rays_[r][3]);
    if (h.is_zero()) {
      generators_.push_back({r, 0, 0, {}});
      return;
    }
    for (const LoadRange::End& end : problem_.load().ends()) {
      generators_.push_back({r, h, h * end.multiple, coordinates(h * end.wrench)});
    }
  }

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
    if (open.edge != 0)
      change = change + Rational(-1) * problem_.edge_wrench(open.contact, open.edge);
    open.edge = edge;
    const Vector3 c = coordinates(change);
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      if (open.most[r].is_zero()) continue;
      for (std::size_t j = 0; j < 3; ++j) wrenches_[r][j] += open.most[r] * c[j];
    }
  }

  std::vector<Normalizer> scales() const {
    const LoadRange& load = problem_.load();
    std::vector<Normalizer> scales;
    if (load.low_is_strict()) scales.push_back(Normalizer::kAboveLow);
    if (load.high_is_strict()) scales.push_back(Normalizer::kBelowHigh);
    // Between two finite ends h > 0 follows.
    if (scales.empty() || load.recession()) scales.push_back(Normalizer::kHeight);
    return scales;
  }

  Rational value_of(Normalizer scale, const Generator& g) const {
    if (scale == Normalizer::kHeight) return g.h;
    if (scale == Normalizer::kAboveLow)
      return g.multiple - problem_.load().ends()[0].multiple * g.h;
    return problem_.load().ends()[1].multiple * g.h - g.multiple;
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
      const Generator& g = generators_[c.generator];
      scales.push_back(value_of(scale, g));
      cost.push_back(Rational(-sign) * g.multiple);
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
      const Generator& g = generators_[k];
      Vector3 wrench = g.load;
      Rational excess = z * value_of(scale, g) + Rational(sign) * g.multiple;
      for (std::size_t j = 0; j < 3; ++j) {
        if (g.ray) wrench[j] += wrenches_[*g.ray][j];
        excess += twist[j] * wrench[j];
      }
      if (excess.sign() <= 0) continue;
      added = true;
      Column column{k, {}, std::move(wrench)};
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
    Vector4 x{};
    std::vector<ContactForce> open_forces(open_.size(), ContactForce{0, 0});
    for (std::size_t c = 0; c < weights.size(); ++c) {
      if (weights[c].is_zero()) continue;
      const Column& column = columns_[c];
      const Generator& g = generators_[column.generator];
      result.multiple += weights[c] * g.multiple;
      if (!g.ray) continue;
      for (std::size_t j = 0; j < 4; ++j) x[j] += weights[c] * Rational(rays_[*g.ray][j]);
      for (std::size_t q = 0; q < open_.size(); ++q) {
        if (column.edges[q] == 0) continue;
        const Rational a = weights[c] * open_[q].most[*g.ray];
        open_forces[q].normal += a;
        open_forces[q].tangential +=
            Rational(column.edges[q]) * problem_.row(open_[q].contact).friction * a;
      }
    }
    result.is_ray = x[3].is_zero();
    const Rational scale = 1 / (result.is_ray ? result.multiple : x[3]);
    result.multiple *= scale;
    for (Rational& entry : x) entry *= scale;
    for (ContactForce& force : open_forces) {
      force.normal *= scale;
      force.tangential *= scale;
    }
    result.witness.twist = {x[0], x[1], x[2]};
    result.witness.forces.assign(problem_.size(), ContactForce{0, 0});
    const auto v_at = [&](ContactId contact) {
      const Vector4& v = problem_.separation(contact);
      return v[0] * x[0] + v[1] * x[1] + v[2] * x[2] + v[3] * x[3];
    };
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
  std::vector<IntegerVector4> rays_;  ///< lines both ways
  std::vector<Vector3> wrenches_;     ///< by ray, of all contacts on their current edges
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

std::optional<LoadExtent> load_extent(const Problem& problem, const Region& region) {
  ColumnGeneration program(problem, region);
  LpWork work;
  std::optional<RelaxedPoint> lowest = program.extreme(-1, work);
  if (!lowest) return std::nullopt;
  return LoadExtent{std::move(*lowest), *program.extreme(1, work)};
}

}  // namespace stickslip
