// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_program.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

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
    for (const Integer& entry : ray.x) g.x.emplace_back(entry);
    g.load = row_of(g.x[3] * problem.wrench() + g.x[4] * problem.load_growth());
    if (above_low) g.positive.push_back(g.x[4] - range.low * g.x[3]);
    if (below_high) g.positive.push_back(*range.high * g.x[3] - g.x[4]);
    // h > 0 follows between two finite ends.
    if (g.positive.empty() || !range.high) g.positive.push_back(g.x[3]);
    generators.push_back(std::move(g));
  }
  return generators;
}

/// Returns the factor by which the vector is longer than a positive multiple of it.
Rational scale_of(const Vector5& vector, const IntegerVector5& multiple) {
  for (std::size_t j = 0; j < 5; ++j) {
    if (!multiple[j].is_zero()) return vector[j] / Rational(multiple[j]);
  }
  return 0;
}

/// The program of a region of one grasp in the plane.
class PlanarProgram {
 public:
  PlanarProgram(const Problem& problem, const Region& region)
      : problem_(problem),
        region_(region),
        rays_(region.generators(problem)),
        program_(3, loaded_generators(problem, rays_)) {
    const ConeSigns signs(region.cone());
    for (std::size_t i = 0; i < problem.size(); ++i) add_contact(ContactId(i), signs);
  }

  /// Applies the rule leaf-bound.
  bool is_refuted_by(const Row& twist) {
    const std::vector<Rational> bounds =
        program_.bounds(RationalRow(twist.begin(), twist.end()));
    std::vector<const Ray*> zeros;
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      if (bounds[k].sign() > 0) return false;
      if (bounds[k].is_zero()) zeros.push_back(&rays_[k]);
    }
    return region_.bars(zeros);
  }

  void start_from(const Row& twist) {
    program_.start_from(RationalRow(twist.begin(), twist.end()));
  }

  std::variant<RelaxedPoint, TwistLeaf> solve(LpWork& work) {
    auto outcome = program_.solve(work);
    if (const auto* twist = std::get_if<RationalRow>(&outcome)) {
      return TwistLeaf{primitive_multiple(*twist)};
    }
    return point(std::get<RelaxedSum>(std::move(outcome)));
  }

  /// Returns the point at an end of the multiples (RelaxedRegion::extreme).
  std::optional<RelaxedPoint> extreme(int sign, LpWork& work) {
    std::optional<RelaxedSum> found = program_.extreme(sign, work);
    if (!found) return std::nullopt;
    return point(std::move(*found));
  }

 private:
  void add_contact(ContactId contact, const ConeSigns& signs) {
    // Integers are several times faster than v itself.
    const IntegerVector5& plane = problem_.separation_plane(contact);
    const Rational scale = scale_of(problem_.separation(contact), plane);
    RelaxedContact added{contact};
    SignRange range;
    for (const Ray& ray : rays_) {
      added.separations.push_back(scale * Rational(dot(plane, ray.x)));
      const int sign = added.separations.back().sign();
      (sign < 0 ? range.negative : sign > 0 ? range.positive : range.zero) = true;
    }
    if (range.is_nonpositive() && !range.is_nonnegative()) return;
    const ContactRow& row = problem_.row(contact);
    added.is_mixed = !range.is_nonnegative();
    // Without friction both edges of the cone are one: any sign serves.
    added.slip =
        row.friction.is_zero() ? Sign::kPositive : region_.slip_sign(problem_, contact, signs);
    added.edges = {row_of(problem_.edge_wrench(contact, 1)),
                   row_of(problem_.edge_wrench(contact, -1))};
    added.stiffness = row.stiffness;
    if (added.is_settled()) settled_.emplace_back(contact, -to_int(*added.slip));
    program_.add(std::move(added));
  }

  RelaxedPoint point(RelaxedSum sum) const {
    RelaxedPoint result;
    result.is_ray = sum.is_ray;
    result.multiple = sum.x[4];
    result.broken = std::move(sum.broken);
    result.broken_separation = sum.broken_separation;
    result.witness.twist = {sum.x[0], sum.x[1], sum.x[2]};
    result.witness.forces.assign(problem_.size(), ContactForce{0, 0});
    Vector5 x;
    std::copy(sum.x.begin(), sum.x.end(), x.begin());
    const auto push = [&](ContactId contact, const Rational& a, const Rational& friction) {
      result.witness.forces[contact.index()] = {a, friction * problem_.row(contact).friction};
    };
    for (const auto& [contact, edge] : settled_) {
      const Rational a = dot(problem_.separation(contact), x);
      push(contact, a, edge * a);
    }
    for (const RelaxedSum::Push& of : sum.pushes) {
      push(of.contact, of.along[0] + of.along[1], of.along[0] - of.along[1]);
    }
    return result;
  }

  const Problem& problem_;
  const Region& region_;
  std::vector<Ray> rays_;  ///< the region's generators
  RelaxedRegion program_;
  std::vector<std::pair<ContactId, int>> settled_;  ///< closed, with the edge of their force
};

/// Returns a leaf near the given one whose twist has small entries, if one refutes; else the
/// given one.
TwistLeaf with_small_integers(PlanarProgram& program, TwistLeaf leaf) {
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
    if (program.is_refuted_by(small.twist)) return small;
  }
  return leaf;
}

}  // namespace

std::variant<RelaxedPoint, TwistLeaf> solve_region(const Problem& problem, const Region& region,
                                                   LpWork* work, const TwistLeaf* guess) {
  throw_if_cancelled();
  LpWork total{0, 0, true, LpTier::kInt64, 0};
  std::variant<RelaxedPoint, TwistLeaf> outcome;
  PlanarProgram program(problem, region);
  if (guess != nullptr && program.is_refuted_by(guess->twist)) {
    outcome = *guess;
  } else {
    if (guess != nullptr) program.start_from(guess->twist);
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

std::optional<MultipleExtent> multiple_extent(const Problem& problem, const Region& region) {
  PlanarProgram program(problem, region);
  LpWork work;
  std::optional<RelaxedPoint> lowest = program.extreme(-1, work);
  if (!lowest) return std::nullopt;
  return MultipleExtent{std::move(*lowest), *program.extreme(1, work)};
}

}  // namespace stickslip
