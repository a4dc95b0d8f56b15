// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_region.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stickslip::box_detail {
namespace {

IntegerVector3 motion(const IntegerVector5& x) {
  return {x[0], x[1], x[2]};
}

}  // namespace

IntegerVector5 Direction::form(const IntegerVector3& y) const {
  Vector5 form{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) form[k] += Rational(y[j]) * matrix[j][k];
    form[3] -= form[k] * coordinates(twist)[k];
  }
  return primitive_multiple(form);
}

BoxRegion BoxRegion::root(const BoxModel& model) {
  BoxRegion region(model.contacts.size());
  if (model.law == NormalLaw::kBilateral) {
    for (const BoxContact& contact : model.contacts) {
      if (contact.separations.size() == 1) {
        region.cone_.cut(contact.separations.front(), Side::kPositive);
      }
    }
  }
  region.update(model);
  return region;
}

BoxRegion BoxRegion::wall(const BoxModel& model, const Matrix3& walls, const Twist& twist,
                          std::size_t wall, int sign) {
  BoxRegion region(model.contacts.size());
  // E_j.(d - h d0) - height h
  const auto plane = [&](std::size_t j, int height) {
    const Vector3& e = walls[j];
    const Vector3 d = coordinates(twist);
    return primitive_multiple<5>({e[0], e[1], e[2], -dot(e, d) - height, 0});
  };
  region.cone_.cut(plane(wall, sign), Side::kZero);
  for (std::size_t j = 0; j < 3; ++j) {
    if (j == wall) continue;
    region.cone_.cut(plane(j, 1), Side::kNegative);
    region.cone_.cut(plane(j, -1), Side::kPositive);
  }
  region.update(model);
  return region;
}

BoxRegion BoxRegion::child(const BoxModel& model, const IntegerVector5& plane, Side side,
                           bool strict) const {
  BoxRegion region = *this;
  if (strict) region.strict_.push_back(cone_.constraint_count());
  region.cone_.cut(plane, side);
  region.update(model);
  return region;
}

/// A strict function that is 0 on all of these rays; lines take nothing away.
bool BoxRegion::bars(const std::vector<std::size_t>& zeros) const {
  return std::any_of(strict_.begin(), strict_.end(), [&](ConstraintIndex constraint) {
    return std::all_of(zeros.begin(), zeros.end(), [&](std::size_t ray) {
      const std::vector<ConstraintIndex>& tight = cone_.rays()[ray].tight;
      return std::binary_search(tight.begin(), tight.end(), constraint);
    });
  });
}

bool BoxRegion::is_barred() const {
  std::vector<std::size_t> all(cone_.rays().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return bars(all);
}

BoxRegion::Signs BoxRegion::signs(const IntegerVector5& plane) const {
  Signs signs;
  std::vector<std::size_t> zeros;
  for (const IntegerVector5& line : cone_.lines()) {
    if (!dot(plane, line).is_zero()) return {true, true, false};
  }
  for (std::size_t r = 0; r < cone_.rays().size(); ++r) {
    const int sign = dot(plane, cone_.rays()[r].x).sign();
    if (sign > 0) signs.positive = true;
    if (sign < 0) signs.negative = true;
    if (sign == 0) zeros.push_back(r);
    if (signs.positive && signs.negative) return signs;
  }
  signs.zeros_barred = bars(zeros);
  return signs;
}

/// What is found stays true in every part of the region.
void BoxRegion::update(const BoxModel& model) {
  points_ = cone_.directions();
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const BoxContact& contact = model.contacts[i];
    if (separations_[i] == Separation::kMixed) {
      bool closed = true;
      bool open = true;
      for (const IntegerVector5& plane : contact.separations) {
        const Signs found = signs(plane);
        closed = closed && !found.negative;
        open = open && !found.positive;
        if (!closed && !open) break;
      }
      if (closed || open) separations_[i] = closed ? Separation::kClosed : Separation::kOpen;
    }
    if (slips_[i] == Sign::kZero) {
      bool plus = true;
      bool minus = true;
      for (const IntegerVector5& plane : contact.slips) {
        const Signs found = signs(plane);
        plus = plus && !found.negative && found.zeros_barred;
        minus = minus && !found.positive && found.zeros_barred;
        if (!plus && !minus) break;
      }
      if (plus || minus) slips_[i] = plus ? Sign::kPositive : Sign::kNegative;
    }
  }
}

bool BoxRegion::is_refuted(const BoxModel& model, const IntegerVector3& y,
                           const Direction* direction) const {
  if (is_barred()) return true;
  if (direction != nullptr) {
    const IntegerVector5 form = direction->form(y);
    for (const IntegerVector5& x : points_) {
      if (dot(form, x).sign() < 0) return false;
    }
  }
  Rational load = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    load += Rational(y[j]) * (y[j].sign() > 0 ? model.wrench[j].high : model.wrench[j].low);
  }
  std::vector<ContactWork<Integer>> works;
  works.reserve(model.contacts.size());
  std::vector<const BoxContact*> acting;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    if (separations_[i] == Separation::kOpen) continue;
    acting.push_back(&model.contacts[i]);
    works.emplace_back(model.contacts[i].exact, y, slips_[i], separations_[i]);
  }
  const std::size_t first_ray = 2 * cone_.lines().size();
  std::vector<std::size_t> zeros;
  std::array<Integer, 8> rises;
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const IntegerVector5& x = points_[p];
    const IntegerVector3 d = motion(x);
    Rational sum = Rational(x[3]) * load;
    for (std::size_t k = 0; k < works.size(); ++k) {
      const auto& normals = acting[k]->exact.normals;
      for (std::size_t c = 0; c < normals.size(); ++c) rises[c] = dot(normals[c], d);
      sum += Rational(works[k].at(x[3], rises.data()).bound) * acting[k]->weight;
    }
    if (sum.sign() > 0) return false;
    if (sum.is_zero() && p >= first_ray) zeros.push_back(p - first_ray);
  }
  return bars(zeros);
}

}  // namespace stickslip::box_detail
