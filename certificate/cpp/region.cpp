// SPDX-License-Identifier: MIT
#include "region.hpp"

#include <algorithm>

namespace stickslip_check {

Generators::Generators(const Box& box, const Cone& cone, const Strict& strict)
    : strict_(strict.conditions), slips_(strict.slips) {
  const auto add = [&](const Form& x, Set zero) {
    for (std::size_t k = 0; k < slips_.size(); ++k) {
      const std::vector<Form>& slip = box.row(slips_[k]).slips[0];
      const bool sticks = std::all_of(slip.begin(), slip.end(),
                                      [&](const Form& s) { return sign_of_dot(s, x) == 0; });
      if (sticks) insert(zero, cone.cuts() + k);
    }
    all_.push_back({&x, std::move(zero)});
  };
  for (const Form& line : cone.lines()) backwards_.push_back(negative(line));
  // On lines all conditions are zero.
  for (const Form& line : cone.lines()) add(line, strict.conditions);
  for (const Form& line : backwards_) add(line, strict.conditions);
  for (const auto& ray : cone.rays()) add(ray->x, intersection(strict.conditions, ray->zero));
  for (std::size_t k = 0; k < slips_.size(); ++k) insert(strict_, cone.cuts() + k);
}

bool Generators::slips(std::size_t contact) const {
  return std::find(slips_.begin(), slips_.end(), contact) != slips_.end();
}

bool Generators::barred() const {
  Barring zero(*this);
  for (const Generator& generator : all_) zero.add(generator);
  return zero.barred();
}

bool Barring::barred() const {
  return std::any_of(common_.begin(), common_.end(), [](auto word) { return word != 0; });
}

int side(const Generators& region, const std::vector<Form>& functions, bool* barred) {
  std::vector<Barring> zeros(barred != nullptr ? functions.size() : 0, Barring(region));
  bool possible[2]{true, true};
  for (const Generator& generator : region) {
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const int sign = sign_of_dot(functions[k], *generator.x);
      if (sign < 0) possible[0] = false;
      if (sign > 0) possible[1] = false;
      if (sign == 0 && barred != nullptr) zeros[k].add(generator);
    }
    if (!possible[0] && !possible[1]) return 0;
  }
  if (barred != nullptr) {
    *barred = std::all_of(zeros.begin(), zeros.end(), [](auto& zero) { return zero.barred(); });
  }
  return possible[0] ? 1 : -1;
}

}  // namespace stickslip_check
