// SPDX-License-Identifier: MIT
#include "cone.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace stickslip_check {
namespace {

constexpr std::size_t kLeadBits = 30;

/// p a + q b, p and q not both 0.
Vector combine(const Integer& p, const Vector& a, const Integer& q, const Vector& b) {
  std::array<Integer, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = p * a.x[i] + q * b.x[i];
  return make_vector(std::move(x));
}

std::vector<std::uint32_t> intersection(const std::vector<std::uint32_t>& a,
                                        const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common;
}

}  // namespace

Vector make_vector(std::array<Integer, 4> x) {
  Integer divisor;
  for (const Integer& coordinate : x) {
    divisor = gcd(divisor, coordinate);
    if (divisor == 1) break;
  }
  std::size_t bits = 0;
  for (Integer& coordinate : x) {
    if (divisor > 1)
      mpz_divexact(coordinate.get_mpz_t(), coordinate.get_mpz_t(), divisor.get_mpz_t());
    bits = std::max(bits, mpz_sizeinbase(coordinate.get_mpz_t(), 2));
  }
  Vector result;
  result.is_short = bits <= kLeadBits;
  for (std::size_t i = 0; i < 4; ++i) {
    if (result.is_short) {
      result.lead[i] = x[i].get_si();
      continue;
    }
    Integer lead;
    mpz_tdiv_q_2exp(lead.get_mpz_t(), x[i].get_mpz_t(), bits - kLeadBits);
    result.lead[i] = lead.get_si();
  }
  result.x = std::move(x);
  return result;
}

Vector make_vector(const std::array<Rational, 4>& x, Rational* scale) {
  Integer den = 1;
  for (const Rational& coordinate : x) den = lcm(den, coordinate.get_den());
  std::array<Integer, 4> integers;
  Integer divisor;
  for (std::size_t i = 0; i < 4; ++i) {
    integers[i] = x[i].get_num() * (den / x[i].get_den());
    divisor = gcd(divisor, integers[i]);
  }
  if (scale != nullptr) {
    *scale = divisor == 0 ? Rational(1) : Rational(divisor, den);
    scale->canonicalize();
  }
  return make_vector(std::move(integers));
}

Vector negative(Vector a) {
  for (std::size_t i = 0; i < 4; ++i) {
    a.x[i] = -a.x[i];
    a.lead[i] = -a.lead[i];
  }
  return a;
}

Integer dot(const Vector& a, const Vector& b) {
  Integer sum = a.x[0] * b.x[0];
  for (std::size_t i = 1; i < 4; ++i) {
    mpz_addmul(sum.get_mpz_t(), a.x[i].get_mpz_t(), b.x[i].get_mpz_t());
  }
  return sum;
}

int sign_of_dot(const Vector& a, const Vector& b) {
  // Each |lead| < 2^30, so the sum is below 2^62. a.b / 2^(s+s') differs from it by less than
  // the sum of |lead_i| + |lead'_i| + 1 over four i, which is below 2^33 + 4.
  constexpr std::int64_t kError = (std::int64_t{1} << 33U) + 4;
  std::int64_t product = 0;
  for (std::size_t i = 0; i < 4; ++i) product += a.lead[i] * b.lead[i];
  if (a.is_short && b.is_short) return (product > 0) - (product < 0);
  if (product > kError) return 1;
  if (product < -kError) return -1;
  return sgn(dot(a, b));
}

Cone Cone::half_space() {
  Cone cone;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Integer, 4> x{0, 0, 0, 0};
    x[i] = 1;
    if (i < 3) {
      cone.lines_.push_back(make_vector(std::move(x)));
    } else {
      cone.rays_.push_back(std::make_shared<const Ray>(Ray{make_vector(std::move(x)), {}}));
    }
  }
  cone.recorded_ = 1;  // x_3 >= 0, on which the ray is not tight
  return cone;
}

bool Cone::adjacent(std::size_t i, std::size_t j) const {
  const std::vector<std::uint32_t> common = intersection(rays_[i]->tight, rays_[j]->tight);
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    if (k == i || k == j) continue;
    const std::vector<std::uint32_t>& tight = rays_[k]->tight;
    if (std::includes(tight.begin(), tight.end(), common.begin(), common.end())) return false;
  }
  return true;
}

Cone Cone::cut_line(const Vector& a, Side side, std::size_t line) const {
  Vector pivot = lines_[line];
  Integer at_pivot = dot(a, pivot);
  if (at_pivot < 0) {
    pivot = negative(std::move(pivot));
    at_pivot = -at_pivot;
  }
  const auto onto_plane = [&](const Vector& g) {
    return combine(at_pivot, g, Integer(-dot(a, g)), pivot);
  };
  Cone result;
  result.recorded_ = recorded_ + (side == Side::kZero ? 0 : 1);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (i != line) result.lines_.push_back(onto_plane(lines_[i]));
  }
  for (const auto& ray : rays_) {
    Ray moved{onto_plane(ray->v), ray->tight};
    if (side != Side::kZero) moved.tight.push_back(recorded_);
    result.rays_.push_back(std::make_shared<const Ray>(std::move(moved)));
  }
  if (side != Side::kZero) {
    // All earlier inequalities vanish on a line.
    Ray ray{side == Side::kAtLeastZero ? pivot : negative(pivot), {}};
    for (std::uint32_t i = 0; i < recorded_; ++i) ray.tight.push_back(i);
    result.rays_.push_back(std::make_shared<const Ray>(std::move(ray)));
  }
  return result;
}

Cone Cone::cut(const Vector& a, Side side) const {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (sign_of_dot(a, lines_[i]) != 0) return cut_line(a, side, i);
  }
  std::vector<std::size_t> above;  // kept by a.x >= 0
  std::vector<std::size_t> below;
  std::vector<std::size_t> on;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const int sign = sign_of_dot(a, rays_[i]->v);
    (sign == 0 ? on : (sign > 0 ? above : below)).push_back(i);
  }
  const std::vector<std::size_t>& kept = side == Side::kAtMostZero ? below : above;
  const std::vector<std::size_t>& lost = side == Side::kAtMostZero ? above : below;
  if (side != Side::kZero && lost.empty()) return *this;

  Cone result;
  result.lines_ = lines_;
  result.recorded_ = recorded_ + (side == Side::kZero ? 0 : 1);
  const auto add_on_plane = [&](Ray ray) {
    if (side != Side::kZero) ray.tight.push_back(recorded_);
    result.rays_.push_back(std::make_shared<const Ray>(std::move(ray)));
  };
  if (side != Side::kZero) {
    for (const std::size_t i : kept) result.rays_.push_back(rays_[i]);
  }
  for (const std::size_t i : on) add_on_plane(*rays_[i]);
  for (const std::size_t i : above) {
    for (const std::size_t j : below) {
      if (!adjacent(i, j)) continue;
      add_on_plane({combine(dot(a, rays_[i]->v), rays_[j]->v, Integer(-dot(a, rays_[j]->v)),
                            rays_[i]->v),
                    intersection(rays_[i]->tight, rays_[j]->tight)});
    }
  }
  return result;
}

}  // namespace stickslip_check
