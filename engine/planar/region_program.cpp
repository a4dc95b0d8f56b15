// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_program.hpp"

#include <algorithm>
#include <limits>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// A contact whose force the region leaves open.
struct OpenContact {
  ContactId contact;
  bool mixed = false;
  std::optional<Sign> slip;
  std::vector<Rational> most;  ///< the largest a_i by generator: v_i or max(0, v_i)
  Vector3 forward;             ///< the wrench of its edge 1, per unit of a_i
  Vector3 backward;            ///< the wrench of its edge -1
  int edge = 0;                ///< the edge of the current extreme point; 0: a_i = 0
};

/// An extreme point of the relaxation on one generator: the edges that the contacts push along.
struct Column {
  std::size_t generator = 0;
  std::vector<std::int8_t> edges;  ///< edges by open contact
  Vector3 wrench;                  ///< the sum of the load and all contacts' wrenches
};

/// Returns the generators with the problem's own loads. The positive functions are the strict
/// ones of the multiples, and h.
std::vector<LoadedGenerator> loaded_generators(const Problem& problem,
                                               const std::vector<Ray>& rays) {
  const MultipleRange& range = problem.multiples();
  const bool above_low = problem.is_family() && !range.has_low;
  const bool below_high = problem.is_family() && range.high;
  std::vector<LoadedGenerator> generators;
  for (const Ray& ray : rays) {
    LoadedGenerator g;
    for (std::size_t j = 0; j < 5; ++j) g.x[j] = Rational(ray.x[j]);
    g.load = coordinates(g.x[3] * problem.wrench() + g.x[4] * problem.load_growth());
    if (above_low) g.positive.push_back(g.x[4] - range.low * g.x[3]);
    if (below_high) g.positive.push_back(*range.high * g.x[3] - g.x[4]);
    // h > 0 follows between two finite ends.
    if (g.positive.empty() || !range.high) g.positive.push_back(g.x[3]);
    generators.push_back(std::move(g));
  }
  return generators;
}

void add(LpWork& sum, const LpWork& part) {
  sum.double_pivots += part.double_pivots;
  sum.exact_pivots += part.exact_pivots;
  sum.basis_confirmed = sum.basis_confirmed && part.basis_confirmed;
  sum.tier = std::max(sum.tier, part.tier);
  sum.largest_bits = std::max(sum.largest_bits, part.largest_bits);
}

/// Returns the factor by which the vector is longer than a positive multiple of it.
Rational scale_of(const Vector5& vector, const IntegerVector5& multiple) {
  for (std::size_t j = 0; j < 5; ++j) {
    if (!multiple[j].is_zero()) return vector[j] / Rational(multiple[j]);
  }
  return 0;
}

class ColumnGeneration {
 public:
  /// Solves for the problem's own loads.
  ColumnGeneration(const Problem& problem, const Region& region)
      : ColumnGeneration(problem, region, ConeSigns(region.cone()),
                         region.generators(problem)) {}

  /// Solves for other loads.
  ColumnGeneration(const Problem& problem, const std::vector<std::optional<Sign>>& slips,
                   std::vector<LoadedGenerator> generators)
      : problem_(problem), generators_(std::move(generators)) {
    begin([&](ContactId contact) { return slips[contact.index()]; });
  }

  /// Applies the rule leaf-bound: g is the work of the corners that do the most. For the
  /// problem's own loads only.
  bool is_refuted_by(const TwistLeaf& leaf) {
    const Vector3 y = coordinates(twist_of(vector_of<3>(leaf.twist)));
    push_against(y);
    std::vector<const Ray*> zeros;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const int bound = dot(y, wrenches_[k]).sign();
      if (bound > 0) return false;
      if (bound == 0) zeros.push_back(&rays_[k]);
    }
    return region_->bars(zeros);
  }

  /// Begins with the corners that do the most work on a twist, where it is positive.
  void start_from(const TwistLeaf& leaf) {
    add_columns(coordinates(twist_of(vector_of<3>(leaf.twist))), kHeight, 0, 0);
  }

  std::variant<RelaxedPoint, TwistLeaf> solve(LpWork& work) {
    std::vector<Rational> sum;
    for (std::size_t scale = 0; scale < scales_; ++scale) {
      auto outcome = optimize(scale, 0, work);
      if (auto* twist = std::get_if<Vector3>(&outcome)) {
        return TwistLeaf{row_of(primitive_multiple(*twist))};
      }
      const std::vector<Rational>& found = std::get<Optimal>(outcome).point;
      sum.resize(found.size());
      for (std::size_t c = 0; c < found.size(); ++c) sum[c] += found[c];
    }
    // No scale is negative anywhere, so all of them are positive in the sum.
    return point(sum);
  }

  /// Returns the point with the largest (sign = 1) or smallest (sign = -1) multiple, or a ray
  /// on which it grows without end.
  std::optional<RelaxedPoint> extreme(int sign, LpWork& work) {
    const auto outcome = optimize(kHeight, sign, work);
    if (std::holds_alternative<Vector3>(outcome)) return std::nullopt;
    if (const auto* unbounded = std::get_if<Unbounded>(&outcome)) return point(unbounded->ray);
    return point(std::get<Optimal>(outcome).point);
  }

 private:
  /// Stands for h in place of the number of a positive function.
  static constexpr std::size_t kHeight = std::numeric_limits<std::size_t>::max();

  /// Returns the value of what is made 1: a positive function, or h.
  static const Rational& value_of(std::size_t scale, const LoadedGenerator& g) {
    return scale == kHeight ? g.x[3] : g.positive[scale];
  }

  ColumnGeneration(const Problem& problem, const Region& region, const ConeSigns& signs,
                   std::vector<Ray> rays)
      : problem_(problem),
        region_(&region),
        rays_(std::move(rays)),
        generators_(loaded_generators(problem, rays_)) {
    begin([&](ContactId contact) { return region.slip_sign(problem, contact, signs); });
  }

  template <class SlipSign>
  void begin(SlipSign slip_sign) {
    for (const LoadedGenerator& g : generators_) wrenches_.push_back(g.load);
    if (!generators_.empty()) scales_ = generators_.front().positive.size();
    for (std::size_t i = 0; i < problem_.size(); ++i) add_contact(ContactId(i), slip_sign);
  }

  /// Returns v_i at the generators; by integers where there are any, which is several times
  /// faster.
  std::vector<Rational> separations(ContactId contact) const {
    std::vector<Rational> result;
    const Vector5& separation = problem_.separation(contact);
    if (rays_.empty()) {
      for (const LoadedGenerator& g : generators_) result.push_back(dot(separation, g.x));
      return result;
    }
    const IntegerVector5& plane = problem_.separation_plane(contact);
    const Rational scale = scale_of(separation, plane);
    for (const Ray& ray : rays_) result.emplace_back(scale * Rational(dot(plane, ray.x)));
    return result;
  }

  template <class SlipSign>
  void add_contact(ContactId contact, SlipSign slip_sign) {
    std::vector<Rational> heights = separations(contact);
    SignRange range;
    for (const Rational& height : heights) {
      const int sign = height.sign();
      (sign < 0 ? range.negative : sign > 0 ? range.positive : range.zero) = true;
    }
    if (range.is_nonpositive() && !range.is_nonnegative()) return;
    OpenContact open{
        contact,
        !range.is_nonnegative(),
        // Without friction both edges of the cone are one: any sign serves.
        problem_.row(contact).friction.is_zero() ? Sign::kPositive : slip_sign(contact),
        {},
        coordinates(problem_.edge_wrench(contact, 1)),
        coordinates(problem_.edge_wrench(contact, -1))};
    for (Rational& height : heights) {
      open.most.push_back(height.sign() > 0 ? std::move(height) : Rational(0));
    }
    if (!open.mixed) push_along(open, open.slip ? -to_int(*open.slip) : 1);
    if (open.slip && !open.mixed) {
      settled_.emplace_back(contact, open.edge);
    } else {
      open_.push_back(std::move(open));
    }
  }

  void push_along(OpenContact& open, int edge) {
    Vector3 change{};
    const auto add_edge = [&](int of, int sign) {
      if (of == 0) return;
      const Vector3& wrench = of > 0 ? open.forward : open.backward;
      for (std::size_t j = 0; j < 3; ++j) change[j] += sign * wrench[j];
    };
    add_edge(edge, 1);
    add_edge(open.edge, -1);
    open.edge = edge;
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      if (open.most[k].is_zero()) continue;
      for (std::size_t j = 0; j < 3; ++j) wrenches_[k][j] += open.most[k] * change[j];
    }
  }

  /// Pushes all open contacts along the edges that do the most work on a twist.
  void push_against(const Vector3& twist) {
    for (OpenContact& open : open_) {
      const Rational forward = dot(open.forward, twist);
      const Rational backward = dot(open.backward, twist);
      const bool is_forward = open.slip ? *open.slip != Sign::kPositive : forward >= backward;
      int edge = is_forward ? 1 : -1;
      if (open.mixed && (is_forward ? forward : backward).sign() <= 0) edge = 0;
      if (edge != open.edge) push_along(open, edge);
    }
  }

  /// Solves sum lambda_c (wrench_c, scale_c) = (0, 0, 0, 1), lambda >= 0, so that the multiple
  /// is largest (sign = 1), smallest (-1) or any (0); returns a ray if it grows without end. If
  /// there is no solution, returns a twist y with g <= 0 on all generators, = 0 only where the
  /// scale is 0.
  std::variant<Optimal, Unbounded, Vector3> optimize(std::size_t scale, int sign,
                                                     LpWork& work) {
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

  LinearProgram master_program(std::size_t scale, int sign) const {
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
      const LoadedGenerator& g = generators_[c.generator];
      scales.push_back(value_of(scale, g));
      cost.push_back(Rational(-sign) * g.x[4]);
    }
    program.add_row(std::move(scales), Relation::kEqual, 1);
    program.minimize(std::move(cost));
    return program;
  }

  /// Adds, on each generator, the extreme point that does the most work on the twist, if its
  /// reduced cost is negative: y.wrench + z scale > cost. Returns false if there are none.
  bool add_columns(const Vector3& twist, std::size_t scale, const Rational& z, int sign) {
    push_against(twist);
    bool added = false;
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      const LoadedGenerator& g = generators_[k];
      const Vector3& wrench = wrenches_[k];
      Rational excess = z * value_of(scale, g) + Rational(sign) * g.x[4];
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

  /// Returns the combination of columns, scaled to h = 1; where h = 0, to the multiple 1.
  RelaxedPoint point(const std::vector<Rational>& weights) const {
    RelaxedPoint result;
    Vector5 x{};
    std::vector<ContactForce> open_forces(open_.size(), ContactForce{0, 0});
    for (std::size_t c = 0; c < weights.size(); ++c) {
      if (weights[c].is_zero()) continue;
      const Column& column = columns_[c];
      const LoadedGenerator& g = generators_[column.generator];
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
    Rational widest_separation = 0;
    const auto consider = [](const Rational& gap, Rational& most, auto split, auto& broken) {
      if (gap <= most) return;
      most = gap;
      broken = split;
    };
    for (std::size_t q = 0; q < open_.size(); ++q) {
      const ContactId contact = open_[q].contact;
      const ContactRow& row = problem_.row(contact);
      const Rational& a = open_forces[q].normal;
      const Rational& b = open_forces[q].tangential;
      if (open_[q].mixed) {
        const Rational lawful = std::max(Rational(0), v_at(contact));
        // The gap is an energy of the spring, as the slip's gap is one of friction.
        const Rational gap = abs(Rational(a - lawful)) * std::max(a, lawful) / row.stiffness;
        consider(gap, widest, SeparationSplit{contact}, result.broken);
        consider(gap, widest_separation, SeparationSplit{contact}, result.broken_separation);
      }
      if (!open_[q].slip) {
        const Rational slip = power(row.tangent, result.witness.twist);
        consider(row.friction * a * abs(slip) + b * slip, widest, SlipSplit{contact},
                 result.broken);
      }
      result.witness.forces[contact.index()] = std::move(open_forces[q]);
    }
    return result;
  }

  const Problem& problem_;
  const Region* region_ = nullptr;  ///< the region, for the problem's own loads
  std::vector<Ray> rays_;           ///< its generators, for the problem's own loads
  std::vector<LoadedGenerator> generators_;
  std::vector<Vector3> wrenches_;  ///< sums of load and contacts on their edges, by generator
  std::size_t scales_ = 1;         ///< how many functions are positive
  std::vector<std::pair<ContactId, int>> settled_;  ///< closed, with the edge of their force
  std::vector<OpenContact> open_;
  std::vector<Column> columns_;
};

/// Returns a leaf near the given one whose twist has small entries, if one refutes; else the
/// given one.
TwistLeaf with_small_integers(ColumnGeneration& program, TwistLeaf leaf) {
  Integer largest = 0;
  for (const Integer& entry : leaf.twist) largest = std::max<Integer>(largest, abs(entry));
  constexpr long kLargestScale = 1L << 40;
  for (long scale = 1; scale < largest && scale <= kLargestScale; scale *= 4) {
    TwistLeaf small{Row(3)};
    for (std::size_t j = 0; j < 3; ++j) {
      // This rounds half up: floor((2 scale y + largest) / (2 largest)).
      Integer quotient;
      const Integer dividend = 2 * scale * leaf.twist[j] + largest;
      const Integer divisor = 2 * largest;
      mpz_fdiv_q(quotient.mutable_gmp(), dividend.gmp(), divisor.gmp());
      small.twist[j] = quotient;
    }
    small.twist = primitive(std::move(small.twist));
    if (program.is_refuted_by(small)) return small;
  }
  return leaf;
}

}  // namespace

std::variant<RelaxedPoint, TwistLeaf> solve_region(const Problem& problem, const Region& region,
                                                   LpWork* work, const TwistLeaf* guess) {
  throw_if_cancelled();
  LpWork total{0, 0, true, LpTier::kInt64, 0};
  std::variant<RelaxedPoint, TwistLeaf> outcome;
  ColumnGeneration program(problem, region);
  if (guess != nullptr && program.is_refuted_by(*guess)) {
    outcome = *guess;
  } else {
    if (guess != nullptr) program.start_from(*guess);
    outcome = program.solve(total);
    if (auto* leaf = std::get_if<TwistLeaf>(&outcome)) {
      *leaf = with_small_integers(program, std::move(*leaf));
    }
  }
  if (work != nullptr) *work = total;
  if (const auto* leaf = std::get_if<TwistLeaf>(&outcome)) {
    require(refutes(problem, region, *leaf), "a Farkas vector does not refute its region");
  }
  return outcome;
}

std::variant<RelaxedPoint, TwistLeaf> solve_loaded_region(
    const Problem& problem, const std::vector<std::optional<Sign>>& slips,
    const std::vector<LoadedGenerator>& generators) {
  throw_if_cancelled();
  LpWork total{0, 0, true, LpTier::kInt64, 0};
  return ColumnGeneration(problem, slips, generators).solve(total);
}

std::optional<MultipleExtent> multiple_extent(const Problem& problem, const Region& region) {
  ColumnGeneration program(problem, region);
  LpWork work;
  std::optional<RelaxedPoint> lowest = program.extreme(-1, work);
  if (!lowest) return std::nullopt;
  return MultipleExtent{std::move(*lowest), *program.extreme(1, work)};
}

}  // namespace stickslip
