// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_region.hpp"

#include <utility>

namespace stickslip::box_detail {
namespace {

IntegerVector3 motion(const IntegerVector5& x) {
  return {x[0], x[1], x[2]};
}

}  // namespace

BoxRegion::BoxRegion(const BoxModel& model, StrictCone cone)
    : StrictCone(std::move(cone)),
      separations_(model.contacts.size(), Separation::kMixed),
      slips_(model.contacts.size(), Sign::kZero) {
  update(model);
}

BoxRegion BoxRegion::root(const BoxModel& model) {
  StrictCone cone;
  if (model.law == NormalLaw::kBilateral) {
    for (const BoxContact& contact : model.contacts) {
      if (contact.separations.size() == 1) {
        cone.cut(contact.separations.front(), Side::kPositive);
      }
    }
  }
  return BoxRegion(model, std::move(cone));
}

BoxRegion BoxRegion::wall(const BoxModel& model, const ConvexBody<3>& body, std::size_t wall) {
  StrictCone cone;
  cone.cut_to_wall(body, wall);
  return BoxRegion(model, std::move(cone));
}

BoxRegion BoxRegion::child(const BoxModel& model, const IntegerVector5& plane, Side side,
                           bool strict) const {
  BoxRegion region = *this;
  region.cut(plane, side, strict);
  region.update(model);
  return region;
}

/// What is found stays true in every part of the region.
void BoxRegion::update(const BoxModel& model) {
  list_points();
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const BoxContact& contact = model.contacts[i];
    if (separations_[i] == Separation::kMixed) {
      bool closed = true;
      bool open = true;
      for (const IntegerVector5& plane : contact.separations) {
        const PlaneSigns found = signs(plane);
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
        const PlaneSigns found = signs(plane);
        plus = plus && !found.negative && found.zeros_barred;
        minus = minus && !found.positive && found.zeros_barred;
        if (!plus && !minus) break;
      }
      if (plus || minus) slips_[i] = plus ? Sign::kPositive : Sign::kNegative;
    }
  }
}

bool BoxRegion::is_refuted(const BoxModel& model, const IntegerVector3& y,
                           const Direction<3>* direction) const {
  if (is_barred()) return true;
  if (direction != nullptr && !direction->holds(y, points())) return false;
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
  std::vector<std::size_t> zeros;
  std::array<Integer, 8> rises;
  for (std::size_t p = 0; p < points().size(); ++p) {
    const IntegerVector5& x = points()[p];
    const IntegerVector3 d = motion(x);
    Rational sum = Rational(x[3]) * load;
    for (std::size_t k = 0; k < works.size(); ++k) {
      const auto& normals = acting[k]->exact.normals;
      for (std::size_t c = 0; c < normals.size(); ++c) rises[c] = dot(normals[c], d);
      sum += Rational(works[k].at(x[3], rises.data()).bound) * acting[k]->weight;
    }
    if (sum.sign() > 0) return false;
    if (sum.is_zero()) zeros.push_back(p);
  }
  return bars(zeros);
}

}  // namespace stickslip::box_detail
