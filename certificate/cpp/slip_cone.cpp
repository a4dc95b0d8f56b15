// SPDX-License-Identifier: MIT
#include "slip_cone.hpp"

#include <algorithm>
#include <optional>

namespace stickslip_check {
namespace {

Rational ratio(const Integer& num, const Integer& den) {
  Rational result(num, den);
  result.canonicalize();
  return result;
}

}  // namespace

SlipProduct::SlipProduct(const Vector& n, const Rational& gamma) {
  while (n[left_out] == 0) ++left_out;
  Vector others = n;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
  Vector weights{1, 1};
  if (gamma != 0) {
    others.emplace_back(0);
    weights.push_back(gamma);
  }
  const std::size_t size = weights.size();
  Vector entries;
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b) {
      // The number that is left out is -others.s / n[left_out].
      entries.emplace_back(others[a] * others[b] / (n[left_out] * n[left_out]));
      if (a == b) entries.back() += weights[a];
    }
  }
  const Form all = make_form(entries, &scale);
  for (auto row = all.begin(); row != all.end(); row += static_cast<std::ptrdiff_t>(size)) {
    matrix.emplace_back(row, row + static_cast<std::ptrdiff_t>(size));
  }
}

Form SlipProduct::times(const Form& s) const {
  Form result;
  for (const Form& row : matrix) result.push_back(dot(row, s));
  return result;
}

bool SlipCone::contains(const Form& s) const {
  return std::all_of(dual_.lines().begin(), dual_.lines().end(),
                     [&](const Form& z) { return sign_of_dot(z, s) == 0; }) &&
         std::all_of(dual_.rays().begin(), dual_.rays().end(),
                     [&](const auto& z) { return sign_of_dot(z->x, s) >= 0; });
}

void SlipCone::add(const Form& s) {
  if (contains(s)) return;
  dual_ = dual_.cut(s);
  Form times = product_->times(s);
  Integer square = dot(times, s);
  slips_.push_back({s, std::move(times), std::move(square)});
}

/// A sum of positive multiples of one slip or two; k of the header.
struct SlipCone::Nearest {
  std::vector<const Slip*> slips;
  Form point;  ///< k times over
  Integer over;
  Rational square;  ///< <k, k> over the product's scale
};

/// The nearest point to q on the line of a slip, or on the plane of two, if it is such a sum.
std::optional<SlipCone::Nearest> SlipCone::nearest_on(std::vector<const Slip*> slips,
                                                      const Form& q) {
  const Slip& a = *slips.front();
  const Slip& b = *slips.back();
  const Integer qa = dot(a.times, q);
  Integer x = qa;
  Integer y = 0;
  Integer over = a.square;
  Integer square = qa * qa;
  if (slips.size() == 2) {
    const Integer qb = dot(b.times, q);
    const Integer ab = dot(a.times, b.s);
    x = qa * b.square - qb * ab;
    y = qb * a.square - qa * ab;
    over = a.square * b.square - ab * ab;
    square = x * qa + y * qb;
    if (y <= 0) return std::nullopt;
  }
  if (x <= 0) return std::nullopt;
  Form point;
  for (std::size_t j = 0; j < q.size(); ++j) point.emplace_back(x * a.s[j] + y * b.s[j]);
  return Nearest{std::move(slips), std::move(point), over, ratio(square, over)};
}

Rational SlipCone::most_along(const Form& t) const {
  const Form q = negative(t);
  if (contains(q)) return product_->square(q);
  Nearest nearest{{}, Form(q.size()), 1, 0};
  for (;;) {
    Form left;  // q - k, times over
    for (std::size_t j = 0; j < q.size(); ++j) {
      left.emplace_back(nearest.over * q[j] - nearest.point[j]);
    }
    const Slip* steepest = nullptr;
    Integer most;  // the square of <left, s> with its sign, over that of s the largest
    for (const Slip& slip : slips_) {
      const Integer along = dot(slip.times, left);
      Integer here = along * abs(along);
      if (steepest != nullptr && here * steepest->square <= most * slip.square) continue;
      steepest = &slip;
      most = std::move(here);
    }
    if (most <= 0) {
      return product_->scale *
             (nearest.slips.empty() ? ratio(most, steepest->square) : nearest.square);
    }
    auto next = nearest_on({steepest}, q);
    for (const Slip* slip : nearest.slips) {
      auto other = nearest_on({slip, steepest}, q);
      if (other && (!next || other->square > next->square)) next = std::move(other);
    }
    nearest = std::move(*next);
  }
}

}  // namespace stickslip_check
