// SPDX-License-Identifier: GPL-3.0-or-later
#include "node.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip {

double DoubleModel::read(const Rational& value) {
  constexpr double kLargest = 0x1p200;
  const double rounded = to_double(value);
  const double size = std::fabs(rounded);
  is_moderate = is_moderate && (value.is_zero() || (size <= kLargest && size >= 1 / kLargest));
  return rounded;
}

DoubleModel::DoubleModel(const Problem& problem) {
  double arms = 0;
  double preloads = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    ContactDoubles c{};
    c.normal = read(row.normal);
    c.friction = read(row.friction * row.tangent);
    const Double3 tangent = read(row.tangent);
    c.slip = {tangent[0], tangent[1], tangent[2], 0};
    const Vector4& v = problem.separation(ContactId(i));
    for (std::size_t j = 0; j < 4; ++j) c.separation[j] = read(v[j]);
    c.stiffness = read(row.stiffness);
    c.frictionless = row.friction.is_zero();
    arms += std::hypot(c.normal[2], tangent[2]) / std::hypot(c.normal[0], c.normal[1]);
    preloads += c.separation[3] * std::hypot(c.normal[0], c.normal[1]);
    contacts.push_back(c);
  }
  for (const LoadRange::End& end : problem.load().ends()) {
    loads.push_back(read(end.wrench));
    multiples.push_back(read(end.multiple));
  }
  if (const auto& direction = problem.load().recession()) recession = read(*direction);
  const double count = std::max<double>(1, static_cast<double>(problem.size()));
  length = arms > 0 ? arms / count : 1;
  force = preloads / count;
  const auto add = [&](const Double3& load) {
    force += std::hypot(load[0], load[1]) + std::fabs(load[2]) / length;
  };
  std::for_each(loads.begin(), loads.end(), add);
  if (recession) add(*recession);
  if (!(force > 0) || !std::isfinite(force)) force = 1;
  if (!std::isfinite(length)) length = 1;
}

std::size_t DoubleModel::hardest_load(const Double3& twist) const {
  return loads.size() > 1 && dot(loads[1], twist) > dot(loads[0], twist) ? 1 : 0;
}

Double4 to_doubles(const IntegerVector4& x) {
  std::array<double, 4> mantissa{};
  std::array<long, 4> exponent{};
  long largest = 0;
  bool any = false;
  for (std::size_t j = 0; j < 4; ++j) {
    if (x[j].is_zero()) continue;
    mantissa[j] = mpz_get_d_2exp(&exponent[j], x[j].backend().data());
    largest = any ? std::max(largest, exponent[j]) : exponent[j];
    any = true;
  }
  Double4 result{};
  for (std::size_t j = 0; j < 4; ++j) {
    const long shift = std::max<long>(exponent[j] - largest, -2000);
    result[j] = std::ldexp(mantissa[j], static_cast<int>(shift));
  }
  return result;
}
namespace {

void decide(const Problem& problem, const DoubleModel& model, const UndecidedContact& u,
            DecidedContacts& decided) {
  const ContactDoubles& c = model.contacts[u.contact];
  for (std::size_t j = 0; j < 3; ++j) {
    const double edge = c.normal[j] - u.slip * c.friction[j];
    const double edge_magnitude = std::fabs(c.normal[j]) + std::fabs(c.friction[j]);
    for (std::size_t k = 0; k < 4; ++k) {
      decided.value[j][k] += edge * c.separation[k];
      decided.magnitude[j][k] += edge_magnitude * std::fabs(c.separation[k]);
    }
  }
  ++decided.terms;
  const IntegerVector4& plane = problem.separation_plane(ContactId(u.contact));
  for (std::size_t k = 0; k < 4; ++k) decided.push[k] += plane[k];
}

}  // namespace

Node Node::root(const Problem& problem) {
  Node node{Region::root(problem), {}, {}};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    UndecidedContact u;
    u.contact = static_cast<std::uint32_t>(i);
    node.undecided.push_back(u);
  }
  return node;
}

Node Node::slip_child(const Problem& problem, ContactId contact, Sign slip) const {
  Node child{region.slip_child(problem, contact, slip), undecided, decided};
  for (UndecidedContact& u : child.undecided) {
    if (u.contact != contact.index()) continue;
    u.slip = static_cast<std::int8_t>(to_int(slip));
    u.slip_cuts = false;
  }
  return child;
}

Node Node::separation_child(const Problem& problem, ContactId contact, Separation side) const {
  return {region.separation_child(problem, contact, side), undecided, decided};
}

Sign RayTable::sign_at(const Double4& function, const IntegerVector4& plane, std::size_t ray,
                       double& value) const {
  const std::optional<Sign> sign = certain_sign(function, rays_[ray], value);
  if (sign && doubles_decide_) return *sign;
  const int exact = dot(plane, directions_[ray]).sign();
  const double size = std::isfinite(value) ? std::fabs(value) : 1;
  value = exact * std::max(size, std::numeric_limits<double>::min());
  return sign_of_int(exact);
}

void RayTable::read(const Problem& problem, const DoubleModel& model, Node& node) {
  doubles_decide_ = model.is_moderate;
  directions_ = node.region.cone().directions();
  rays_.clear();
  for (const IntegerVector4& x : directions_) rays_.push_back(to_doubles(x));
  const std::size_t ray_count = rays_.size();
  separations_.clear();
  std::size_t kept = 0;
  for (UndecidedContact u : node.undecided) {
    const ContactDoubles& c = model.contacts[u.contact];
    const ContactId contact(u.contact);
    separations_.resize((kept + 1) * ray_count);
    double* separations = &separations_[kept * ray_count];
    SignRange range;
    for (std::size_t r = 0; r < ray_count; ++r) {
      const Sign sign =
          sign_at(c.separation, problem.separation_plane(contact), r, separations[r]);
      (sign == Sign::kNegative   ? range.negative
       : sign == Sign::kPositive ? range.positive
                                 : range.zero) = true;
    }
    if (u.separation == Separation::kMixed) {
      if (range.is_nonpositive()) continue;  // open: no force
      if (range.is_nonnegative()) u.separation = Separation::kClosed;
    }
    if (u.slip == 0 && c.frictionless) u.slip = 1;  // both edges are one
    if (u.slip == 0 && u.slip_cuts) {
      find_slip_sign(problem, model, node, u);
    }
    if (u.separation == Separation::kClosed && u.slip != 0) {
      decide(problem, model, u, node.decided);
      continue;
    }
    node.undecided[kept++] = u;
  }
  node.undecided.resize(kept);
  separations_.resize(kept * ray_count);
  loaded_.assign(ray_count, 0);
  const Double4 push = to_doubles(node.decided.push);
  for (std::size_t r = 0; r < ray_count; ++r) {
    double value = 0;
    const bool acts = !directions_[r][3].is_zero() ||
                      sign_at(push, node.decided.push, r, value) == Sign::kPositive;
    loaded_[r] = acts ? 1 : 0;
  }
}

/// The rule "has the sign" of certificate/FORMAT.md.
void RayTable::find_slip_sign(const Problem& problem, const DoubleModel& model,
                              const Node& node, UndecidedContact& u) {
  const ContactId contact(u.contact);
  bool positive = false;
  bool negative = false;
  zero_rays_.clear();
  const std::size_t first_ray = 2 * node.region.cone().lines().size();
  for (std::size_t r = 0; r < rays_.size() && !(positive && negative); ++r) {
    double value = 0;
    const Sign sign =
        sign_at(model.contacts[u.contact].slip, problem.slip_plane(contact), r, value);
    positive = positive || sign == Sign::kPositive;
    negative = negative || sign == Sign::kNegative;
    if (sign == Sign::kZero && r >= first_ray) {
      zero_rays_.push_back(&node.region.cone().rays()[r - first_ray]);
    }
  }
  if (positive && negative) return;
  if (!positive && !negative) {
    u.slip_cuts = false;  // sticks everywhere: friction is free, and a split idle
  } else if (node.region.is_barred(zero_rays_)) {
    u.slip = positive ? 1 : -1;
  }
}

}  // namespace stickslip
