// SPDX-License-Identifier: GPL-3.0-or-later
#include "region.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Side side_of(Sign slip) {
  if (slip == Sign::kZero) return Side::kZero;
  return slip == Sign::kPositive ? Side::kPositive : Side::kNegative;
}

Rational value(const Vector5& function, const IntegerVector5& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < 5; ++j) sum += function[j] * Rational(x[j]);
  return sum;
}

void add_multiple(Vector5& sum, const Rational& factor, const Vector5& function) {
  for (std::size_t j = 0; j < 5; ++j) sum[j] += factor * function[j];
}

/// \{ The constraints l >= low h and l <= high h where the cone is one of motions alone, and
/// knows nothing of them. They come after all others.
constexpr ConstraintIndex kAboveLow = std::numeric_limits<ConstraintIndex>::max() - 1;
constexpr ConstraintIndex kBelowHigh = kAboveLow + 1;
/// \}

/// Returns sign * (l - end h), primitive.
IntegerVector5 end_plane(const Rational& end, int sign) {
  return primitive_multiple<5>({0, 0, 0, -sign * end, sign});
}

/// Returns the point of the motion x with l = multiple h.
IntegerVector5 with_multiple(const IntegerVector5& x, const Rational& multiple) {
  IntegerVector5 result = x;
  for (Integer& entry : result) entry *= denominator(multiple);
  result[4] = numerator(multiple) * x[3];
  return primitive(std::move(result));
}

/// Cuts the cone to the part where no v_i is below 0, by those that are somewhere. O(m rays).
void cut_by_normal_law(Cone& cone, const Problem& problem) {
  const std::size_t m = problem.size();
  // Contacts far apart come first: the later ones then cut less often.
  std::size_t step = m / 2 + m / 8 + 1;
  while (std::gcd(step, m) > 1) ++step;
  std::size_t i = 0;
  for (std::size_t seen = 0; seen < m;) {
    const ConeSigns signs(cone);
    const IntegerVector5* cutting = nullptr;
    for (; seen < m && cutting == nullptr; ++seen, i = (i + step) % m) {
      const IntegerVector5& plane = problem.separation_plane(ContactId(i));
      if (!signs.on(plane).is_nonnegative()) cutting = &plane;
    }
    if (cutting != nullptr) cone.cut(*cutting, Side::kPositive);
  }
}

}  // namespace

Region Region::root(const Problem& problem) {
  Region region(problem, problem.preloads_grow() ? Multiples::kAny : Multiples::kZero);
  const MultipleRange& range = problem.multiples();
  if (problem.preloads_grow()) {
    region.cut(end_plane(range.low, 1), Side::kPositive, !range.has_low);
    if (range.high) region.cut(end_plane(*range.high, -1), Side::kPositive, true);
  } else if (problem.is_family()) {
    region.any_multiple_ = true;
    if (!range.has_low) region.strict_.push_back(kAboveLow);
    if (range.high) region.strict_.push_back(kBelowHigh);
  }
  if (problem.law() == NormalLaw::kBilateral) cut_by_normal_law(region.cone_, problem);
  return region;
}

Region Region::between(const Problem& problem, const std::vector<Cut>& cuts) {
  Region region(problem, Multiples::kAny);
  region.strict_.clear();
  for (const Cut& cut : cuts) region.cut(cut.plane, cut.side, cut.strict);
  return region;
}

Region Region::wall(const Problem& problem, const ConvexBody& body, std::size_t wall) {
  Region region(problem);
  region.cut_to_wall(body, wall);
  return region;
}

Region Region::of_mode(const Problem& problem, const std::vector<ContactMode>& mode) {
  Region region = root(problem);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const ContactId contact(i);
    if (problem.law() == NormalLaw::kUnilateral) {
      region = std::move(region).separation_child(
          problem, contact, mode[i].closed ? Separation::kClosed : Separation::kOpen);
    }
    if (mode[i].closed && !problem.row(contact).friction.is_zero()) {
      region = std::move(region).slip_child(problem, contact, mode[i].slip);
    }
  }
  return region;
}

Region Region::slip_child(const Problem& problem, ContactId contact, Sign slip) const& {
  return Region(*this).slip_child(problem, contact, slip);
}

Region Region::slip_child(const Problem& problem, ContactId contact, Sign slip) && {
  labels_[contact.index()] = slip;
  cut(problem.slip_plane(contact), side_of(slip), slip != Sign::kZero);
  return std::move(*this);
}

Region Region::separation_child(const Problem& problem, ContactId contact,
                                Separation closed_or_open) const& {
  return Region(*this).separation_child(problem, contact, closed_or_open);
}

Region Region::separation_child(const Problem& problem, ContactId contact,
                                Separation closed_or_open) && {
  require(closed_or_open != Separation::kMixed, "a child of a separation is closed or open");
  return std::move(*this).plane_child(
      problem.separation_plane(contact),
      closed_or_open == Separation::kClosed ? Side::kPositive : Side::kNegative);
}

Region Region::plane_child(const IntegerVector5& plane, Side side) const& {
  return Region(*this).plane_child(plane, side);
}

Region Region::plane_child(const IntegerVector5& plane, Side side) && {
  require(side != Side::kZero, "a child of a plane is one of its half-spaces");
  require(!any_multiple_ || plane[4].is_zero(), "the motions go with any multiple");
  // Points on the plane belong to the first child, so the second has none of them.
  cut(plane, side, side == Side::kNegative);
  return std::move(*this);
}

std::vector<Region> Region::children(const Problem& problem, const ContactSplit& at) const {
  std::vector<Region> children;
  if (const auto* slip = std::get_if<SlipSplit>(&at)) {
    for (const Sign sign : {Sign::kPositive, Sign::kZero, Sign::kNegative}) {
      children.push_back(slip_child(problem, slip->contact, sign));
    }
  } else {
    const ContactId contact = std::get<SeparationSplit>(at).contact;
    for (const Separation side : {Separation::kClosed, Separation::kOpen}) {
      children.push_back(separation_child(problem, contact, side));
    }
  }
  return children;
}

Region Region::with_slip_state(const Problem& problem, const std::vector<Sign>& state) const {
  require(state.size() == problem.size(), "a slip state has one sign per contact");
  Region region = *this;
  std::optional<ConeSigns> signs(region.cone_);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const IntegerVector5& plane = problem.slip_plane(ContactId(i));
    region.labels_[i] = state[i];
    const SignRange range = signs->on(plane);
    const bool satisfied = state[i] == Sign::kZero       ? range.is_zero()
                           : state[i] == Sign::kPositive ? range.is_nonnegative()
                                                         : range.is_nonpositive();
    if (satisfied) continue;
    region.cone_.cut(plane, side_of(state[i]));
    signs.emplace(region.cone_);
  }
  return region;
}

Separation Region::separation(const Problem& problem, ContactId contact) const {
  return separation(problem, contact, ConeSigns(cone_));
}

Separation Region::separation(const Problem& problem, ContactId contact,
                              const ConeSigns& signs) {
  const SignRange range = signs.on(problem.separation_plane(contact));
  if (range.is_nonnegative()) return Separation::kClosed;
  return range.is_nonpositive() ? Separation::kOpen : Separation::kMixed;
}

std::optional<Sign> Region::slip_sign(const Problem& problem, ContactId contact) const {
  return slip_sign(problem, contact, ConeSigns(cone_));
}

std::optional<Sign> Region::slip_sign(const Problem& problem, ContactId contact,
                                      const ConeSigns& signs) const {
  if (const std::optional<Sign> known = label(contact)) {
    if (*known == Sign::kZero) return std::nullopt;
    return known;
  }
  const IntegerVector5& plane = problem.slip_plane(contact);
  const SignRange range = signs.on(plane);
  if (range.is_mixed() || !bars(signs.rays_in(plane))) return std::nullopt;
  return range.negative ? Sign::kNegative : Sign::kPositive;
}

std::vector<Ray> Region::generators(const Problem& problem) const {
  std::vector<ConstraintIndex> all(cone_.constraint_count());
  std::iota(all.begin(), all.end(), ConstraintIndex{0});
  const MultipleRange& range = problem.multiples();
  std::vector<Ray> result;
  if (any_multiple_) {
    if (!range.high) result.push_back({{0, 0, 0, 0, 1}, all});
    all.insert(all.end(), {kAboveLow, kBelowHigh});
  }
  for (const IntegerVector5& line : cone_.lines()) {
    result.push_back({line, all});
    result.push_back({negated(line), all});
  }
  for (const Ray& ray : cone_.rays()) {
    if (!any_multiple_) {
      result.push_back(ray);
      continue;
    }
    const auto add = [&](const Rational& multiple,
                         std::initializer_list<ConstraintIndex> ends) {
      result.push_back({with_multiple(ray.x, multiple), ray.tight});
      result.back().tight.insert(result.back().tight.end(), ends);
    };
    if (ray.x[3].is_zero()) {
      add(0, {kAboveLow, kBelowHigh});
    } else {
      add(range.low, {kAboveLow});
      if (range.high) add(*range.high, {kBelowHigh});
    }
  }
  return result;
}

namespace {

std::vector<Rational> work_bounds_on(const std::vector<Ray>& generators, const Problem& problem,
                                     const Region& region, const TwistLeaf& leaf) {
  const Twist y = twist_of(vector_of<3>(leaf.twist));
  Vector5 linear{0, 0, 0, power(problem.wrench(), y), power(problem.load_growth(), y)};
  struct Kink {  // alpha max(0, v)
    Rational alpha;
    const Vector5* v;
  };
  std::vector<Kink> kinks;
  const ConeSigns signs(region.cone());
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactId contact(i);
    const Separation separation = Region::separation(problem, contact, signs);
    if (separation == Separation::kOpen) continue;
    const ContactRow& row = problem.row(contact);
    const std::optional<Sign> slip = region.slip_sign(problem, contact, signs);
    const Rational friction = row.friction * power(row.tangent, y);
    Rational alpha = power(row.normal, y);
    alpha += slip ? Rational(-to_int(*slip)) * friction : abs(friction);
    const Vector5& v = problem.separation(contact);
    if (separation == Separation::kClosed) {
      add_multiple(linear, alpha, v);
    } else if (alpha.sign() > 0) {
      kinks.push_back({alpha, &v});
    }
  }
  std::vector<Rational> bounds;
  for (const Ray& r : generators) {
    Rational bound = value(linear, r.x);
    for (const Kink& kink : kinks) {
      const Rational v = value(*kink.v, r.x);
      if (v.sign() > 0) bound += kink.alpha * v;
    }
    bounds.push_back(std::move(bound));
  }
  return bounds;
}

}  // namespace

std::vector<Rational> work_bounds(const Problem& problem, const Region& region,
                                  const TwistLeaf& leaf) {
  return work_bounds_on(region.generators(problem), problem, region, leaf);
}

bool refutes(const Problem& problem, const Region& region, const TwistLeaf& leaf) {
  if (region.is_barred()) return true;
  const std::vector<Ray> generators = region.generators(problem);
  const std::vector<Rational> bounds = work_bounds_on(generators, problem, region, leaf);
  std::vector<const Ray*> zero;
  for (std::size_t r = 0; r < generators.size(); ++r) {
    if (bounds[r].sign() > 0) return false;
    if (bounds[r].is_zero()) zero.push_back(&generators[r]);
  }
  return region.bars(zero);
}

}  // namespace stickslip
