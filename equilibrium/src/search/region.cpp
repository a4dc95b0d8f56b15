// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/search/region.hpp"

#include <algorithm>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Side side_of(Sign slip) {
  if (slip == Sign::kZero) return Side::kZero;
  return slip == Sign::kPositive ? Side::kPositive : Side::kNegative;
}

Rational value(const Vector4& function, const IntegerVector4& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < 4; ++j) sum += function[j] * Rational(x[j]);
  return sum;
}

void add_multiple(Vector4& sum, const Rational& factor, const Vector4& function) {
  for (std::size_t j = 0; j < 4; ++j) sum[j] += factor * function[j];
}

}  // namespace

Region Region::root(const Problem& problem) {
  Region region;
  region.labels_.resize(problem.size());
  if (problem.law() == NormalLaw::kBilateral) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      region.cone_.cut(problem.separation_plane(ContactId(i)), Side::kPositive);
    }
  }
  return region;
}

Region Region::slip_child(const Problem& problem, ContactId contact, Sign slip) const& {
  return Region(*this).slip_child(problem, contact, slip);
}

Region Region::slip_child(const Problem& problem, ContactId contact, Sign slip) && {
  labels_[contact.index()] = slip;
  if (slip != Sign::kZero) strict_.push_back(cone_.constraint_count());
  cone_.cut(problem.slip_plane(contact), side_of(slip));
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

Region Region::plane_child(const IntegerVector4& plane, Side side) const& {
  return Region(*this).plane_child(plane, side);
}

Region Region::plane_child(const IntegerVector4& plane, Side side) && {
  require(side != Side::kZero, "a child of a plane is one of its half-spaces");
  // Points on the plane belong to the first child, so the second has none of them.
  if (side == Side::kNegative) strict_.push_back(cone_.constraint_count());
  cone_.cut(plane, side);
  return std::move(*this);
}

Region Region::with_slip_state(const Problem& problem, const std::vector<Sign>& state) const {
  require(state.size() == problem.size(), "a slip state has one sign per contact");
  Region region = *this;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const IntegerVector4& plane = problem.slip_plane(ContactId(i));
    region.labels_[i] = state[i];
    const SignRange range = signs_on(region.cone_, plane);
    const bool satisfied = state[i] == Sign::kZero       ? range.is_zero()
                           : state[i] == Sign::kPositive ? range.is_nonnegative()
                                                         : range.is_nonpositive();
    if (!satisfied) region.cone_.cut(plane, side_of(state[i]));
  }
  return region;
}

Separation Region::separation(const Problem& problem, ContactId contact) const {
  const SignRange range = signs_on(cone_, problem.separation_plane(contact));
  if (range.is_nonnegative()) return Separation::kClosed;
  return range.is_nonpositive() ? Separation::kOpen : Separation::kMixed;
}

std::optional<Sign> Region::slip_sign(const Problem& problem, ContactId contact) const {
  if (const std::optional<Sign> known = label(contact)) {
    if (*known == Sign::kZero) return std::nullopt;
    return known;
  }
  const IntegerVector4& plane = problem.slip_plane(contact);
  const SignRange range = signs_on(cone_, plane);
  if (range.is_mixed()) return std::nullopt;
  std::vector<const Ray*> on_plane;
  for (const Ray& ray : cone_.rays()) {
    if (dot(plane, ray.x).is_zero()) on_plane.push_back(&ray);
  }
  if (!is_barred(on_plane)) return std::nullopt;
  return range.negative ? Sign::kNegative : Sign::kPositive;
}

/// Lines need no look: every strict function is a constraint, and so is 0 on them.
bool Region::is_barred(const std::vector<const Ray*>& rays) const {
  return std::any_of(strict_.begin(), strict_.end(), [&](ConstraintIndex strict) {
    return std::all_of(rays.begin(), rays.end(), [&](const Ray* ray) {
      return std::binary_search(ray->tight.begin(), ray->tight.end(), strict);
    });
  });
}

bool Region::is_void() const {
  std::vector<const Ray*> all;
  for (const Ray& ray : cone_.rays()) all.push_back(&ray);
  return is_barred(all);
}

namespace {

Twist twist_of(const VirtualWorkLeaf& leaf) {
  return {Rational(leaf.twist[0]), Rational(leaf.twist[1]), Rational(leaf.twist[2])};
}

}  // namespace

std::vector<Rational> contact_work_bounds(const Problem& problem, const Region& region,
                                          const VirtualWorkLeaf& leaf) {
  const Twist y = twist_of(leaf);
  Vector4 linear{0, 0, 0, 0};
  struct Kink {  // alpha max(0, v)
    Rational alpha;
    const Vector4* v;
  };
  std::vector<Kink> kinks;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactId contact(i);
    const Separation separation = region.separation(problem, contact);
    if (separation == Separation::kOpen) continue;
    const ContactRow& row = problem.row(contact);
    const std::optional<Sign> slip = region.slip_sign(problem, contact);
    const Rational friction = row.friction * power(row.tangent, y);
    Rational alpha = power(row.normal, y);
    alpha += slip ? Rational(-to_int(*slip)) * friction : abs(friction);
    const Vector4& v = problem.separation(contact);
    if (separation == Separation::kClosed) {
      add_multiple(linear, alpha, v);
    } else if (alpha.sign() > 0) {
      kinks.push_back({alpha, &v});
    }
  }
  std::vector<Rational> bounds;
  for (const IntegerVector4& x : region.cone().directions()) {
    Rational bound = value(linear, x);
    for (const Kink& kink : kinks) {
      const Rational v = value(*kink.v, x);
      if (v.sign() > 0) bound += kink.alpha * v;
    }
    bounds.push_back(std::move(bound));
  }
  return bounds;
}

bool refutes(const Problem& problem, const Region& region, const VirtualWorkLeaf& leaf) {
  if (region.is_void()) return true;
  const LoadRange& load = problem.load();
  const Twist y = twist_of(leaf);
  // The generators where g is 0: of motions, and which ends of the loads they go with.
  std::vector<const Ray*> zero;
  bool zero_at_low = false;
  bool zero_at_high = false;
  if (load.recession()) {
    const Rational bound = power(*load.recession(), y);
    if (bound.sign() > 0) return false;
    zero_at_high = bound.is_zero();
  }
  std::vector<Rational> powers;
  for (const LoadRange::End& end : load.ends()) powers.push_back(power(end.wrench, y));
  const std::vector<Rational> contacts = contact_work_bounds(problem, region, leaf);
  const std::size_t first_ray = 2 * region.cone().lines().size();
  for (std::size_t r = 0; r < contacts.size(); ++r) {
    const Rational h =
        r < first_ray ? Rational(0) : Rational(region.cone().rays()[r - first_ray].x[3]);
    bool is_zero = false;
    for (std::size_t e = 0; e < powers.size(); ++e) {
      const int sign = Rational(contacts[r] + h * powers[e]).sign();
      if (sign > 0) return false;
      if (sign < 0) continue;
      is_zero = true;
      if (!h.is_zero()) (e == 0 ? zero_at_low : zero_at_high) = true;
    }
    if (is_zero && r >= first_ray) zero.push_back(&region.cone().rays()[r - first_ray]);
  }
  return region.is_barred(zero) || (load.low_is_strict() && !zero_at_high) ||
         (load.high_is_strict() && !zero_at_low);
}

}  // namespace stickslip
