// SPDX-License-Identifier: GPL-3.0-or-later
#include "node.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::equilibrium_detail {

double DoubleModel::read(const Rational& value) {
  constexpr double kLargest = 0x1p200;
  const double rounded = to_double(value);
  const double size = std::fabs(rounded);
  is_moderate = is_moderate && (value.is_zero() || (size <= kLargest && size >= 1 / kLargest));
  return rounded;
}

DoubleModel::DoubleModel(const Problem& problem) {
  double arms = 0;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    ContactDoubles c{};
    c.normal = read(row.normal);
    c.friction = read(row.friction * row.tangent);
    const Double3 tangent = read(row.tangent);
    c.slip = {tangent[0], tangent[1], tangent[2], 0, 0};
    const Vector5& v = problem.separation(ContactId(i));
    for (std::size_t j = 0; j < 5; ++j) c.separation[j] = read(v[j]);
    c.stiffness = read(row.stiffness);
    c.frictionless = row.friction.is_zero();
    arms += std::hypot(c.normal[2], tangent[2]) / std::hypot(c.normal[0], c.normal[1]);
    contacts.push_back(c);
  }
  load = read(problem.wrench());
  growth = read(problem.load_growth());
  const double count = std::max<double>(1, static_cast<double>(problem.size()));
  length = arms > 0 ? arms / count : 1;
  const auto add_end = [&](double h, double l) {
    for (std::size_t j = 0; j < 3; ++j) start[j] = h * load[j] + l * growth[j];
    force += std::hypot(start[0], start[1]) + std::fabs(start[2]) / length;
    for (const ContactDoubles& c : contacts) {
      const double preload = h * c.separation[3] + l * c.separation[4];
      force += preload * std::hypot(c.normal[0], c.normal[1]) / count;
    }
  };
  const MultipleRange& range = problem.multiples();
  add_end(1, to_double(range.low));
  if (problem.is_family()) range.high ? add_end(1, to_double(*range.high)) : add_end(0, 1);
  if (!(force > 0) || !std::isfinite(force)) force = 1;
  if (!std::isfinite(length)) length = 1;
}

Double5 to_doubles(const IntegerVector5& x) {
  std::array<double, 5> mantissa{};
  std::array<long, 5> exponent{};
  long largest = 0;
  bool any = false;
  for (std::size_t j = 0; j < 5; ++j) {
    if (x[j].is_zero()) continue;
    mantissa[j] = mpz_get_d_2exp(&exponent[j], x[j].backend().data());
    largest = any ? std::max(largest, exponent[j]) : exponent[j];
    any = true;
  }
  Double5 result{};
  for (std::size_t j = 0; j < 5; ++j) {
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
    for (std::size_t k = 0; k < 5; ++k) {
      decided.value[j][k] += edge * c.separation[k];
      decided.magnitude[j][k] += edge_magnitude * std::fabs(c.separation[k]);
    }
  }
  ++decided.terms;
  const IntegerVector5& plane = problem.separation_plane(ContactId(u.contact));
  for (std::size_t k = 0; k < 5; ++k) decided.push[k] += plane[k];
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

Sign RayTable::sign_at(const Double5& function, const IntegerVector5& plane, std::size_t ray,
                       double& value) const {
  const std::optional<Sign> sign = certain_sign(function, rays_[ray], value);
  if (sign && doubles_decide_) return *sign;
  const int exact = dot(plane, generators_[ray].x).sign();
  const double size = std::isfinite(value) ? std::fabs(value) : 1;
  value = exact * std::max(size, std::numeric_limits<double>::min());
  return sign_of_int(exact);
}

void RayTable::read(const Problem& problem, const DoubleModel& model, Node& node) {
  doubles_decide_ = model.is_moderate;
  generators_ = node.region.generators(problem);
  rays_.clear();
  for (const Ray& ray : generators_) rays_.push_back(to_doubles(ray.x));
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
  const Double5 push = to_doubles(node.decided.push);
  const bool load_grows = !(problem.load_growth() == Wrench{});
  for (std::size_t r = 0; r < ray_count; ++r) {
    double value = 0;
    const IntegerVector5& x = generators_[r].x;
    const bool acts = !x[3].is_zero() || (load_grows && !x[4].is_zero()) ||
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
  for (std::size_t r = 0; r < rays_.size() && !(positive && negative); ++r) {
    double value = 0;
    const Sign sign =
        sign_at(model.contacts[u.contact].slip, problem.slip_plane(contact), r, value);
    positive = positive || sign == Sign::kPositive;
    negative = negative || sign == Sign::kNegative;
    if (sign == Sign::kZero) zero_rays_.push_back(&generators_[r]);
  }
  if (positive && negative) return;
  if (!positive && !negative) {
    u.slip_cuts = false;  // sticks everywhere: friction is free, and a split idle
  } else if (node.region.is_barred(zero_rays_)) {
    u.slip = positive ? 1 : -1;
  }
}

}  // namespace stickslip::equilibrium_detail
