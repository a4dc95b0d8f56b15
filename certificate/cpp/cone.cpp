// SPDX-License-Identifier: MIT
#include "cone.hpp"

#include <algorithm>
#include <bitset>
#include <utility>

#include "work.hpp"

namespace stickslip_check {
namespace {

constexpr std::size_t kWordBits = 64;
constexpr std::uint64_t kStepsOfARay = 64;  // to make one, of which it keeps the memory

/// p a - q b
Form combine(const Integer& p, const Form& a, const Integer& q, const Form& b) {
  Form x(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) {
    x[j] = p * a[j];
    mpz_submul(x[j].get_mpz_t(), q.get_mpz_t(), b[j].get_mpz_t());
  }
  make_primitive(x);
  return x;
}

bool includes(const Set& set, const Set& part) {
  for (std::size_t k = 0; k < part.size(); ++k) {
    if ((part[k] & ~(k < set.size() ? set[k] : 0)) != 0) return false;
  }
  return true;
}

/// The number of conditions in both.
std::size_t common_size(const Set& a, const Set& b) {
  std::size_t size = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    size += std::bitset<kWordBits>(a[k] & b[k]).count();
  }
  return size;
}

}  // namespace

void insert(Set& set, std::size_t condition) {
  const std::size_t word = condition / kWordBits;
  if (set.size() <= word) set.resize(word + 1);
  set[word] |= std::uint64_t{1} << condition % kWordBits;
}

Set intersection(const Set& a, const Set& b) {
  Set common(std::min(a.size(), b.size()));
  for (std::size_t k = 0; k < common.size(); ++k) common[k] = a[k] & b[k];
  return common;
}

Cone::Cone(std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) {
    lines_.emplace_back(n);
    lines_.back()[j] = 1;
  }
}

void Cone::add(Form x, Set zero) {
  spend(kStepsOfARay + words(x));
  rays_.push_back(std::make_shared<const Ray>(Ray{std::move(x), std::move(zero)}));
}

Cone Cone::cut_line(const Form& a, bool equality, std::size_t line) const {
  Form pivot = lines_[line];
  Integer rise = dot(a, pivot);
  if (rise < 0) {
    pivot = negative(std::move(pivot));
    rise = -rise;
  }
  const auto onto_plane = [&](const Form& g) { return combine(rise, g, dot(a, g), pivot); };
  Cone result;
  result.cuts_ = cuts_ + 1;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    if (k != line) result.lines_.push_back(onto_plane(lines_[k]));
  }
  for (const auto& ray : rays_) {
    Set zero = ray->zero;
    insert(zero, cuts_);
    result.add(onto_plane(ray->x), std::move(zero));
  }
  if (!equality) {
    Set all_before;
    for (std::size_t k = 0; k < cuts_; ++k) insert(all_before, k);
    result.add(std::move(pivot), std::move(all_before));
  }
  return result;
}

Cone Cone::cut(const Form& a, bool equality) const {
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    if (sign_of_dot(a, lines_[k]) != 0) return cut_line(a, equality, k);
  }
  std::vector<Integer> height;
  for (const auto& ray : rays_) height.push_back(dot(a, ray->x));
  Cone result;
  result.cuts_ = cuts_ + 1;
  result.lines_ = lines_;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    if (height[i] > 0 && !equality) result.rays_.push_back(rays_[i]);
    if (height[i] != 0) continue;
    Set zero = rays_[i]->zero;
    insert(zero, cuts_);
    result.add(rays_[i]->x, std::move(zero));
  }
  // A pair that is adjacent spans, with the lines, all that is zero in its common conditions.
  const std::size_t n = rays_.empty() ? 0 : rays_.front()->x.size();
  const std::size_t least = n - std::min(n, lines_.size() + 2);
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    if (height[i] > 0) spend(rays_.size());
    for (std::size_t j = 0; j < rays_.size(); ++j) {
      if (height[i] <= 0 || height[j] >= 0) continue;
      if (common_size(rays_[i]->zero, rays_[j]->zero) < least) continue;
      spend(rays_.size());
      Set common = intersection(rays_[i]->zero, rays_[j]->zero);
      std::size_t holders = 0;  // of all common zeros; the two themselves are
      for (std::size_t k = 0; k < rays_.size() && holders <= 2; ++k) {
        if (includes(rays_[k]->zero, common)) ++holders;
      }
      if (holders > 2) continue;
      insert(common, cuts_);
      result.add(combine(height[i], rays_[j]->x, height[j], rays_[i]->x), std::move(common));
    }
  }
  return result;
}

}  // namespace stickslip_check
