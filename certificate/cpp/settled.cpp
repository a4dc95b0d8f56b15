// SPDX-License-Identifier: MIT
#include "settled.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace stickslip_check {
namespace {

constexpr std::size_t kPoint = kPlanar + 2;
constexpr long kMostBits = 150;
constexpr long kMantissaBits = 53;

/// Numbers over 2^exponent.
struct Scaled {
  std::vector<double> numbers;  ///< the largest between 1/2 and 1, or all 0
  double unit = 0;              ///< if not 0, all are exact, and multiples of it
  long exponent = 0;
};

/// Nothing if one that is not 0 is below 2^-151 of the largest.
std::optional<Scaled> scaled(const Form& x) {
  Scaled result;
  std::vector<long> exponents;
  result.numbers.reserve(x.size());
  exponents.reserve(x.size());
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
  if (result.exponent <= kMantissaBits) {
    result.unit = std::ldexp(1.0, -static_cast<int>(result.exponent));
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
  result.v_unit = v->unit;
  result.tau_unit = tau->unit;
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

  /// If doubles tell. Each factor is rounded by 2u and each product and sum by u: 9u. With
  /// units of the two factors whose product is `unit`, or 0: see settled.hpp, "Signs".
  std::optional<int> sign(double unit) const {
    constexpr double kError = 0x1p-49;
    if (std::fabs(value) > kError * magnitude || magnitude == 0 || magnitude < 0x1p53 * unit) {
      return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
    }
    return std::nullopt;
  }
};

/// A generator in doubles, if it can be had.
struct Point {
  const Generator* exact;
  bool usable;
  double unit;
  std::array<double, kPoint> x;
};

std::vector<Point> points_of(const Generators& region) {
  std::vector<Point> points;
  for (const Generator& generator : region) {
    const auto numbers = scaled(*generator.x);
    points.push_back({&generator, numbers.has_value(), numbers ? numbers->unit : 0, {}});
    if (numbers) copy(numbers->numbers, 0, points.back().x);
  }
  return points;
}

/// Of contact i, whose exact functions are made only if doubles do not tell.
int sign_of_v(const Point& point, const RowDoubles& row, const Box& box, std::size_t i) {
  if (point.usable) {
    const auto sign = Sum(row.v, point.x.data()).sign(row.v_unit * point.unit);
    if (sign) return *sign;
  }
  return sign_of_dot(box.row(i).v[0], *point.exact->x);
}

int sign_of_tau(const Point& point, const RowDoubles& row, const Box& box, std::size_t i) {
  if (point.usable) {
    const auto sign = Sum(row.tau, point.x.data()).sign(row.tau_unit * point.unit);
    if (sign) return *sign;
  }
  return sign_of_dot(box.row(i).tau[0], *point.exact->x);
}

/// Two points where a function of some contact was above 0 and below 0: those of the next
/// contact, which mostly is near, are looked for there first.
struct Opposites {
  std::size_t above = 0;
  std::size_t below = 0;

  /// Whether there are two for this function, whose sign at a point is `sign_at(point)`.
  template <typename SignAt>
  bool found(const std::vector<Point>& points, const SignAt& sign_at) const {
    return !points.empty() && sign_at(points[above]) > 0 && sign_at(points[below]) < 0;
  }
  void keep(int sign, std::size_t k) {
    if (sign != 0) (sign > 0 ? above : below) = k;
  }
};

/// 1 or -1 if the contact has that sign of slip (FORMAT.md §4), else 0.
int slip_sign(const Generators& region, const std::vector<Point>& points, const RowDoubles& row,
              const Box& box, std::size_t i, Opposites& last) {
  const auto sign_at = [&](const Point& point) { return sign_of_tau(point, row, box, i); };
  if (last.found(points, sign_at)) return 0;
  int sign = 0;
  Barring zeros(region);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int here = sign_at(points[k]);
    last.keep(here, k);
    if (sign != 0 && here == -sign) return 0;
    if (here == 0) zeros.add(*points[k].exact);
    if (here != 0) sign = here;
  }
  return zeros.barred() ? sign : 0;  // 0 if it sticks everywhere
}

/// 1 if v >= 0 on all, -1 if v <= 0, which is preferred; else 0.
int side_of(const std::vector<Point>& points, const RowDoubles& row, const Box& box,
            std::size_t i, Opposites& last) {
  const auto sign_at = [&](const Point& point) { return sign_of_v(point, row, box, i); };
  if (last.found(points, sign_at)) return 0;
  bool above = false;
  bool below = false;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int here = sign_at(points[k]);
    last.keep(here, k);
    above = above || here > 0;
    below = below || here < 0;
    if (above && below) return 0;
  }
  return above ? 1 : -1;
}

static_assert(std::numeric_limits<double>::is_iec559 &&
              std::numeric_limits<double>::digits == 53);

/// What sums of LongSum round by: emulated machines may have no more than doubles.
double long_rounding() {
  constexpr LongSum kStep = std::numeric_limits<LongSum>::epsilon();
  volatile LongSum one = 1;
  volatile LongSum next = one + kStep;
  return next > one ? std::max(static_cast<double>(kStep), 0x1p-63) : 0x1p-52;
}

}  // namespace

std::shared_ptr<const BoxDoubles> make_doubles(const Box& box) {
  const bool is_planar = box.dimension() == kPlanar && box.coordinates() == kPoint;
  if (!is_planar || !box.certain()) return nullptr;
  auto result = std::make_shared<BoxDoubles>();
  result->rows.reserve(box.size());
  for (std::size_t i = 0; i < box.size(); ++i) {
    const auto contact = box.passing(i);
    const auto doubles = contact->box.sight ? std::nullopt : in_doubles(contact->row);
    if (!doubles) return nullptr;
    result->rows.push_back(*doubles);
  }
  const Vector load = box.load.lowest();
  for (std::size_t j = 0; j < kPlanar; ++j) {
    for (auto [exact, doubles] : {std::pair{&load[j], &result->load[j]},
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

Cone cut_by_normal_law(Cone cone, const Box& box, const BoxDoubles& doubles) {
  // Contacts far apart first: the later ones then cut less often.
  const std::size_t m = box.size();
  std::size_t step = m * 5 / 8 + 1;
  while (std::gcd(step, m) > 1) ++step;
  std::size_t i = 0;
  for (std::size_t seen = 0; seen < m;) {
    const Generators generators(box, cone, {});
    const std::vector<Point> points = points_of(generators);
    const auto is_closed = [&](const Point& point) {
      return sign_of_v(point, doubles.rows[i], box, i) >= 0;
    };
    while (seen < m && std::all_of(points.begin(), points.end(), is_closed)) {
      i = (i + step) % m;
      ++seen;
    }
    if (seen < m) cone = cone.cut(box.row(i).v[0]);
  }
  return cone;
}

Settled::Settled(const Box& box, std::shared_ptr<const BoxDoubles> doubles)
    : box_(&box), doubles_(std::move(doubles)) {
  auto all = std::make_shared<std::vector<Unsettled>>();
  for (std::size_t i = 0; i < box.size(); ++i) {
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
  rest->reserve(unsettled_->size());
  Opposites presses;
  Opposites slips;
  for (Unsettled contact : *unsettled_) {
    const RowDoubles& doubles = doubles_->rows[contact.contact];
    if (!contact.closed) {
      const int side = side_of(points, doubles, *box_, contact.contact, presses);
      if (side < 0) continue;
      contact.closed = side > 0;
    }
    if (contact.slip == 0) {
      contact.slip = static_cast<std::int8_t>(
          slip_sign(region, points, doubles, *box_, contact.contact, slips));
    }
    if (!contact.closed || contact.slip == 0) {
      rest->push_back(contact);
      continue;
    }
    inside.add(doubles, contact.slip);
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
    LongSum bound = 0;  ///< g, but for rounding
    double magnitude = 0;
    bool pressed = false;  ///< by an unsettled contact: v > 0
  };
  const std::vector<Point> points = points_of(region);
  /// Whether v is not 0 there for some contact that is settled, and so closed.
  const auto some_press = [&](const Point& point) {
    auto unsettled = unsettled_->begin();
    for (std::size_t i = 0; i < doubles_->rows.size(); ++i) {
      if (unsettled != unsettled_->end() && unsettled->contact == i) {
        ++unsettled;
      } else if (sign_of_v(point, doubles_->rows[i], *box_, i) > 0) {
        return true;
      }
    }
    return false;
  };
  std::vector<At> all;
  const Sum load(doubles_->load, y.data());
  const Sum growth(doubles_->growth, y.data());
  for (const Point& point : points) {
    if (!point.usable) return false;
    At at{&point};
    at.bound = load.value * point.x[kPlanar] + growth.value * point.x[kPlanar + 1];
    at.magnitude = load.magnitude * std::fabs(point.x[kPlanar]) +
                   growth.magnitude * std::fabs(point.x[kPlanar + 1]);
    for (std::size_t j = 0; j < kPlanar; ++j) {
      for (std::size_t k = 0; k < kPoint; ++k) {
        at.bound += sum_[j][k] * static_cast<LongSum>(y[j] * point.x[k]);
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
      const double unit = row.v_unit * at.point->unit;
      if (!contact.closed && v.sign(unit).value_or(0) < 0) continue;  // max(0, v_i) = 0
      at.bound += alpha * (contact.closed ? v.value : std::max(v.value, 0.0));
      at.magnitude += size * v.magnitude;
      // Of a closed contact it is not below 0 anywhere.
      at.pressed = at.pressed || sign_of_v(*at.point, row, *box_, contact.contact) > 0;
    }
  }
  const double terms = static_cast<double>(terms_ + unsettled_->size() + 64);
  const double error = 2 * (64 * 0x1p-53 + terms * long_rounding());
  Barring flat(region);  // where g = 0
  for (const At& at : all) {
    if (!(at.bound < -error * at.magnitude)) {
      if (at.pressed || some_press(*at.point)) return false;
      // No contact does any work there.
      const Form& x = *at.point->exact->x;
      const Rational work = box_->load.work(twist).high * x[kPlanar] +
                            dot(twist, box_->growths[0]) * x[kPlanar + 1];
      if (work > 0) return false;
      if (work == 0) flat.add(*at.point->exact);
    }
    if (!flat.barred()) return false;
  }
  return true;
}

}  // namespace stickslip_check
