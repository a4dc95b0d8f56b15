// SPDX-License-Identifier: GPL-3.0-or-later
#include "cone_node.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip {
namespace {

void settle(const Problem& problem, const DoubleModel& model, const OpenQuestion& question,
            Aggregate& settled) {
  const ContactDoubles& c = model.contacts[question.contact];
  for (std::size_t j = 0; j < 3; ++j) {
    const double edge = c.normal[j] - question.slip * c.friction[j];
    const double edge_magnitude = std::fabs(c.normal[j]) + std::fabs(c.friction[j]);
    for (std::size_t k = 0; k < 4; ++k) {
      settled.value[j][k] += edge * c.separation[k];
      settled.magnitude[j][k] += edge_magnitude * std::fabs(c.separation[k]);
    }
  }
  ++settled.terms;
  const IntegerVector4& plane = problem.separation_plane(ContactId(question.contact));
  for (std::size_t k = 0; k < 4; ++k) settled.push[k] += plane[k];
}

}  // namespace

Node Node::root(const Problem& problem) {
  Node node{Region::root(problem), {}, {}};
  for (std::size_t i = 0; i < problem.size(); ++i) {
    OpenQuestion question;
    question.contact = static_cast<std::uint32_t>(i);
    node.questions.push_back(question);
  }
  return node;
}

Node Node::slip_child(const Problem& problem, ContactId contact, Sign slip) const {
  Node child{region.slip_child(problem, contact, slip), questions, settled};
  for (OpenQuestion& question : child.questions) {
    if (question.contact != contact.index()) continue;
    question.slip = static_cast<std::int8_t>(to_int(slip));
    question.slip_cuts = false;
  }
  return child;
}

Node Node::separation_child(const Problem& problem, ContactId contact, Separation side) const {
  return {region.separation_child(problem, contact, side), questions, settled};
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
  heights_.clear();
  std::size_t kept = 0;
  for (OpenQuestion question : node.questions) {
    const ContactDoubles& c = model.contacts[question.contact];
    const ContactId contact(question.contact);
    heights_.resize((kept + 1) * ray_count);
    double* heights = &heights_[kept * ray_count];
    SignRange range;
    for (std::size_t r = 0; r < ray_count; ++r) {
      const Sign sign = sign_at(c.separation, problem.separation_plane(contact), r, heights[r]);
      (sign == Sign::kNegative   ? range.negative
       : sign == Sign::kPositive ? range.positive
                                 : range.zero) = true;
    }
    if (question.separation == Separation::kMixed) {
      if (range.is_nonpositive()) continue;  // open: no force
      if (range.is_nonnegative()) question.separation = Separation::kClosed;
    }
    if (question.slip == 0 && c.frictionless) question.slip = 1;  // both edges are one
    if (question.slip == 0 && question.slip_cuts) {
      find_slip_sign(problem, model, node, question);
    }
    if (question.separation == Separation::kClosed && question.slip != 0) {
      settle(problem, model, question, node.settled);
      continue;
    }
    node.questions[kept++] = question;
  }
  node.questions.resize(kept);
  heights_.resize(kept * ray_count);
  loaded_.assign(ray_count, 0);
  const Double4 push = to_doubles(node.settled.push);
  for (std::size_t r = 0; r < ray_count; ++r) {
    double value = 0;
    const bool acts = !directions_[r][3].is_zero() ||
                      sign_at(push, node.settled.push, r, value) == Sign::kPositive;
    loaded_[r] = acts ? 1 : 0;
  }
}

/// The rule "has the sign" of certificate/FORMAT.md.
void RayTable::find_slip_sign(const Problem& problem, const DoubleModel& model,
                              const Node& node, OpenQuestion& question) {
  const ContactId contact(question.contact);
  bool positive = false;
  bool negative = false;
  zero_rays_.clear();
  const std::size_t first_ray = 2 * node.region.cone().lines().size();
  for (std::size_t r = 0; r < rays_.size() && !(positive && negative); ++r) {
    double value = 0;
    const Sign sign =
        sign_at(model.contacts[question.contact].slip, problem.slip_plane(contact), r, value);
    positive = positive || sign == Sign::kPositive;
    negative = negative || sign == Sign::kNegative;
    if (sign == Sign::kZero && r >= first_ray) {
      zero_rays_.push_back(&node.region.cone().rays()[r - first_ray]);
    }
  }
  if (positive && negative) return;
  if (!positive && !negative) {
    question.slip_cuts = false;  // sticks everywhere: friction is free, and a split idle
  } else if (node.region.is_barred(zero_rays_)) {
    question.slip = positive ? 1 : -1;
  }
}

}  // namespace stickslip
