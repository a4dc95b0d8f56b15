// SPDX-License-Identifier: MIT
#include "settled.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stickslip_check {
namespace {

constexpr std::size_t kPoint = kPlanar + 2;
constexpr long kMostBits = 150;

/// Numbers over 2^exponent.
struct Scaled {
  std::vector<double> numbers;  ///< the largest between 1/2 and 1, or all 0
  long exponent = 0;
};

/// Nothing if one that is not 0 is below 2^-150 of the largest.
std::optional<Scaled> scaled(const Form& x) {
  Scaled result;
  std::vector<long> exponents;
  bool any = false;
  for (const Integer& entry : x) {
    long exponent = 0;
    result.numbers.push_back(mpz_get_d_2exp(&exponent, entry.get_mpz_t()));
    exponents.push_back(exponent);
    if (entry == 0) continue;
    result.exponent = any ? std::max(result.exponent, exponent) : exponent;
    any = true;
  }
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] == 0) continue;
    const long down = exponents[j] - result.exponent;
    if (down < -kMostBits) return std::nullopt;
    result.numbers[j] = std::ldexp(result.numbers[j], static_cast<int>(down));
  }
  return result;
}

/// x 2^exponent for x > 0, with an error of 6u.
std::optional<double> times_power(const Rational& x, long exponent) {
  long num = 0;
  long den = 0;
  const double over = mpz_get_d_2exp(&num, x.get_num_mpz_t());
  const double under = mpz_get_d_2exp(&den, x.get_den_mpz_t());
  const long total = num - den + exponent;
  if (std::labs(total) >= kMostBits) return std::nullopt;
  return std::ldexp(over / under, static_cast<int>(total));
}

template <std::size_t n>
void copy(const std::vector<double>& from, std::size_t begin, std::array<double, n>& to) {
  std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(begin), n, to.begin());
}

std::optional<RowDoubles> in_doubles(const Row& row) {
  const auto v = scaled(row.v[0]);
  const auto tau = scaled(row.tau[0]);
  Form both = row.edges[0][0];
  both.insert(both.end(), row.edges[3][0].begin(), row.edges[3][0].end());
  const auto edges = scaled(both);
  if (!v || !tau || !edges) return std::nullopt;
  const auto weight = times_power(row.weight, v->exponent + edges->exponent);
  if (!weight) return std::nullopt;
  RowDoubles result;
  copy(v->numbers, 0, result.v);
  copy(tau->numbers, 0, result.tau);
  copy(edges->numbers, 0, result.edges[0]);
  copy(edges->numbers, kPlanar, result.edges[1]);
  result.weight = *weight;
  result.one_edge = row.edges[0][0] == row.edges[3][0];
  return result;
}

/// a.x, with the sum of the absolute values of its terms.
struct Sum {
  double value = 0;
  double magnitude = 0;

  template <std::size_t n>
  Sum(const std::array<double, n>& a, const double* x) {
    for (std::size_t j = 0; j < n; ++j) {
      const double term = a[j] * x[j];
      value += term;
      magnitude += std::fabs(term);
    }
  }

  /// 0 if it is not certain. Each factor is rounded by 2u and each product and sum by u: 9u.
  int sign() const {
    constexpr double kError = 0x1p-49;
    if (value > kError * magnitude) return 1;
    return value < -kError * magnitude ? -1 : 0;
  }
};

/// A generator in doubles, if it can be had.
struct Point {
  const Generator* exact;
  bool usable;
  std::array<double, kPoint> x;
};

std::vector<Point> points_of(const Generators& region) {
  std::vector<Point> points;
  for (const Generator& generator : region) {
    const auto numbers = scaled(*generator.x);
    points.push_back({&generator, numbers.has_value(), {}});
    if (numbers) copy(numbers->numbers, 0, points.back().x);
  }
  return points;
}

template <std::size_t n>
int sign_at(const Point& point, const std::array<double, n>& doubles, const Form& exact) {
  if (point.usable) {
    if (const int sign = Sum(doubles, point.x.data()).sign()) return sign;
  }
  return sign_of_dot(exact, *point.exact->x);
}

/// 1 or -1 if the contact has that sign of slip (FORMAT.md §4), else 0.
int slip_sign(const Generators& region, const std::vector<Point>& points,
              const RowDoubles& doubles, const Row& row) {
  int sign = 0;
  for (const Point& point : points) {
    const int here = sign_at(point, doubles.tau, row.tau[0]);
    if (sign != 0 && here == -sign) return 0;
    if (here != 0) sign = here;
  }
  if (sign == 0) return 0;  // sticks everywhere
  Barring zeros(region);
  for (const Point& point : points) {
    if (sign_at(point, doubles.tau, row.tau[0]) == 0) zeros.add(*point.exact);
  }
  return zeros.barred() ? sign : 0;
}

/// 1 if v >= 0 on all, -1 if v <= 0, which is preferred; else 0.
int side_of(const std::vector<Point>& points, const RowDoubles& doubles, const Row& row) {
  bool above = false;
  bool below = false;
  for (const Point& point : points) {
    const int here = sign_at(point, doubles.v, row.v[0]);
    above = above || here > 0;
    below = below || here < 0;
    if (above && below) return 0;
  }
  return above ? 1 : -1;
}

}  // namespace

std::shared_ptr<const BoxDoubles> make_doubles(const Box& box) {
  const bool is_planar = box.dimension() == kPlanar && box.coordinates() == kPoint;
  if (!is_planar || !box.certain()) return nullptr;
  auto result = std::make_shared<BoxDoubles>();
  result->rows.reserve(box.rows.size());
  for (const auto& row : box.rows) {
    const auto doubles = in_doubles(*row);
    if (!doubles) return nullptr;
    result->rows.push_back(*doubles);
  }
  for (std::size_t j = 0; j < kPlanar; ++j) {
    for (auto [exact, doubles] : {std::pair{&box.wrench[j].low, &result->load[j]},
                                  std::pair{&box.growths[0][j], &result->growth[j]}}) {
      *doubles = 0;
      if (*exact == 0) continue;
      const auto size = times_power(abs(*exact), 0);
      if (!size) return nullptr;
      *doubles = *exact > 0 ? *size : -*size;
    }
  }
  return result;
}

Settled::Settled(const Box& box, std::shared_ptr<const BoxDoubles> doubles)
    : box_(&box), doubles_(std::move(doubles)), push_(kPoint) {
  auto all = std::make_shared<std::vector<Unsettled>>();
  for (std::size_t i = 0; i < box.rows.size(); ++i) {
    // Without friction both signs of slip come to the same.
    const bool one_edge = doubles_->rows[i].one_edge;
    all->push_back(
        {static_cast<std::uint32_t>(i), false, static_cast<std::int8_t>(one_edge ? 1 : 0)});
  }
  unsettled_ = std::move(all);
}

void Settled::add(const RowDoubles& row, int slip) {
  const auto& edge = row.edges[slip > 0 ? 0 : 1];
  for (std::size_t j = 0; j < kPlanar; ++j) {
    for (std::size_t k = 0; k < kPoint; ++k) {
      const double term = row.weight * edge[j] * row.v[k];
      sum_[j][k] += term;
      magnitude_[j][k] += std::fabs(term);
    }
  }
  ++terms_;
}

Settled Settled::within(const Generators& region) const {
  const std::vector<Point> points = points_of(region);
  Settled inside = *this;
  auto rest = std::make_shared<std::vector<Unsettled>>();
  for (Unsettled contact : *unsettled_) {
    const RowDoubles& doubles = doubles_->rows[contact.contact];
    const Row& row = *box_->rows[contact.contact];
    if (!contact.closed) {
      const int side = side_of(points, doubles, row);
      if (side < 0) continue;
      contact.closed = side > 0;
    }
    if (contact.slip == 0) {
      contact.slip = static_cast<std::int8_t>(slip_sign(region, points, doubles, row));
    }
    if (!contact.closed || contact.slip == 0) {
      rest->push_back(contact);
      continue;
    }
    inside.add(doubles, contact.slip);
    for (std::size_t k = 0; k < kPoint; ++k) inside.push_[k] += row.v[0][k];
  }
  inside.unsettled_ = std::move(rest);
  return inside;
}

bool Settled::proves(const Generators& region, const Vector& twist) const {
  const auto scaled_twist = scaled(make_form(twist));
  if (!scaled_twist) return false;
  std::array<double, kPlanar> y;
  copy(scaled_twist->numbers, 0, y);

  struct At {
    const Point* point;
    double bound = 0;  ///< g, but for rounding
    double magnitude = 0;
    bool acts = false;  ///< some number that g is a multiple of is not 0
  };
  const std::vector<Point> points = points_of(region);
  std::vector<At> all;
  const Sum load(doubles_->load, y.data());
  const Sum growth(doubles_->growth, y.data());
  for (const Point& point : points) {
    if (!point.usable) return false;
    At at{&point};
    at.bound = load.value * point.x[kPlanar] + growth.value * point.x[kPlanar + 1];
    at.magnitude = load.magnitude * std::fabs(point.x[kPlanar]) +
                   growth.magnitude * std::fabs(point.x[kPlanar + 1]);
    at.acts = point.x[kPlanar] != 0 || point.x[kPlanar + 1] != 0 ||
              sign_of_dot(push_, *point.exact->x) != 0;
    for (std::size_t j = 0; at.acts && j < kPlanar; ++j) {
      for (std::size_t k = 0; k < kPoint; ++k) {
        at.bound += sum_[j][k] * y[j] * point.x[k];
        at.magnitude += magnitude_[j][k] * std::fabs(y[j]) * std::fabs(point.x[k]);
      }
    }
    all.push_back(at);
  }
  for (const Unsettled& contact : *unsettled_) {
    const RowDoubles& row = doubles_->rows[contact.contact];
    const Sum first(row.edges[0], y.data());
    const Sum second(row.edges[1], y.data());
    // The larger of two numbers has no larger error than the worse known of them.
    double alpha = contact.slip > 0   ? first.value
                   : contact.slip < 0 ? second.value
                                      : std::max(first.value, second.value);
    alpha *= row.weight;
    const double size = row.weight * std::max(first.magnitude, second.magnitude);
    if (!contact.closed && alpha < -0x1p-48 * size) continue;  // alpha_i < 0
    if (!contact.closed) alpha = std::max(alpha, 0.0);
    for (At& at : all) {
      const Sum v(row.v, at.point->x.data());
      if (!contact.closed && v.sign() < 0) continue;  // max(0, v_i) = 0
      at.bound += alpha * (contact.closed ? v.value : std::max(v.value, 0.0));
      at.magnitude += size * v.magnitude;
      // Of a closed contact it is not below 0 anywhere.
      at.acts = at.acts || sign_at(*at.point, row.v, box_->rows[contact.contact]->v[0]) > 0;
    }
  }
  const double terms = static_cast<double>(terms_ + unsettled_->size() + 64);
  const double error = 2 * (64 + terms) * 0x1p-53;
  Barring flat(region);  // where g = 0
  for (const At& at : all) {
    if (at.acts && !(at.bound < -error * at.magnitude)) return false;
    if (!at.acts) flat.add(*at.point->exact);
    if (!flat.barred()) return false;
  }
  return true;
}

}  // namespace stickslip_check
