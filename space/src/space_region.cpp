// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_region.hpp"

#include <algorithm>
#include <cmath>

namespace stickslip::space_detail {
namespace {

IntegerVector3 exact_slip(const CornerRow& row, const Point& x) {
  return {dot(row.slip_planes[0], x), dot(row.slip_planes[1], x), dot(row.slip_planes[2], x)};
}

/// The sum of terms that are, up to rounding and one positive factor, those of function.x: with
/// the exact sign, and to a few digits even where they cancel.
double sum_of(const std::array<double, 8>& terms, bool may_be_rounded, const Point& function,
              const Point& x) {
  double sum = 0;
  double magnitude = 0;
  std::size_t largest = 0;
  for (std::size_t j = 0; j < terms.size(); ++j) {
    sum += terms[j];
    magnitude += std::fabs(terms[j]);
    if (std::fabs(terms[j]) > std::fabs(terms[largest])) largest = j;
  }
  constexpr double kLost = 1e-10;
  constexpr double kLeast = 1e-200;  // beside which what underflows is nothing
  if (may_be_rounded && std::fabs(sum) > kLost * magnitude + kLeast) return sum;
  const Integer exact = dot(function, x);
  if (exact.is_zero()) return 0;
  const Integer term = function[largest] * x[largest];
  const std::array<double, 2> both = in_doubles(IntegerVector<2>{exact, term});
  const double value = both[0] / both[1] * terms[largest];
  // What underflows is tiny, but not 0.
  constexpr double kTiny = 1e-300;
  return std::isfinite(value) && value * exact.sign() > 0 ? value : exact.sign() * kTiny;
}

/// The sign of (a x b).n: whether b is to the left of a, seen against n.
int turn(const IntegerVector3& a, const IntegerVector3& b, const IntegerVector3& n) {
  return dot(cross(a, b), n).sign();
}

/// Whether u, not 0 and across n, is a sum of nonnegative multiples of these.
bool is_in_cone(const IntegerVector3& u, const std::vector<IntegerVector3>& directions,
                const IntegerVector3& n) {
  const IntegerVector3* left = nullptr;  // the nearest to u of those to the left
  const IntegerVector3* right = nullptr;
  for (const IntegerVector3& s : directions) {
    const int side = turn(u, s, n);
    if (side == 0) {
      if (dot(u, s).sign() > 0) return true;
    } else if (side > 0) {
      if (left == nullptr || turn(s, *left, n) > 0) left = &s;
    } else if (right == nullptr || turn(*right, s, n) > 0) {
      right = &s;
    }
  }
  return left != nullptr && right != nullptr && turn(*right, *left, n) > 0;
}

}  // namespace

SpaceRegion::SpaceRegion(const SpaceModel& model, StrictCone cone)
    : StrictCone(std::move(cone)),
      strict_slips_(model.contacts.size(), 0),
      still_(model.contacts.size(), 0),
      separations_(model.contacts.size(), Separation::kMixed),
      slips_(model.contacts.size()) {
  update(model);
}

namespace {

/// sign (l - end h) >= 0.
Point end_plane(const Rational& end, int sign) {
  return primitive_multiple<8>({0, 0, 0, 0, 0, 0, -sign * end, sign});
}

using MotionCone = StrictCone<6>;

MotionCone whole_cone(const SpaceModel& model) {
  using Multiples = ConeIn<8>::Multiples;
  return MotionCone(model.is_family ? Multiples::kAny : Multiples::kZero);
}

}  // namespace

SpaceRegion SpaceRegion::root(const SpaceModel& model) {
  StrictCone cone = whole_cone(model);
  if (model.is_family) {
    const auto& [low, high, has_low] = model.multiples;
    cone.cut(end_plane(low, 1), Side::kPositive, !has_low);
    if (high) cone.cut(end_plane(*high, -1), Side::kPositive, true);
  }
  if (model.law == NormalLaw::kBilateral) {
    for (const SpaceContact& contact : model.contacts) {
      if (contact.has_certain_separation()) {
        cone.cut(contact.separations.front(), Side::kPositive);
      }
    }
  }
  return SpaceRegion(model, std::move(cone));
}

SpaceRegion SpaceRegion::wall(const SpaceModel& model, const ConvexBody<6>& body,
                              std::size_t wall) {
  StrictCone cone = whole_cone(model);
  if (model.is_family) {
    cone.cut(end_plane(model.multiples.low, 1), Side::kPositive);
    cone.cut(end_plane(*model.multiples.high, -1), Side::kPositive);
  }
  cone.cut_to_wall(body, wall);
  return SpaceRegion(model, std::move(cone));
}

std::vector<SpaceRegion> SpaceRegion::halves(const SpaceModel& model,
                                             const Point& plane) const {
  auto [above, below] = StrictCone::halves(plane);
  std::vector<SpaceRegion> both(2, *this);
  static_cast<StrictCone&>(both[0]) = std::move(above);
  static_cast<StrictCone&>(both[1]) = std::move(below);
  for (SpaceRegion& region : both) region.update(model);
  return both;
}

SpaceRegion SpaceRegion::sticking(const SpaceModel& model, std::size_t contact) const {
  SpaceRegion region = *this;
  for (const Point& plane : model.contacts[contact].corners.front().slip_planes) {
    region.cut(plane, Side::kZero);
  }
  region.still_[contact] = 1;
  region.update(model);
  return region;
}

SpaceRegion SpaceRegion::slipping(const SpaceModel& model, std::size_t contact) const {
  SpaceRegion region = *this;
  region.strict_slips_[contact] = 1;  // the cone stays as it is, and so do its generators
  region.classify(model);
  return region;
}

bool SpaceRegion::bars_all(const SpaceModel& model,
                           const std::vector<std::size_t>& zeros) const {
  if (bars(zeros)) return true;
  for (std::size_t i = 0; i < strict_slips_.size(); ++i) {
    if (!strict_slips_[i]) continue;
    if (std::all_of(zeros.begin(), zeros.end(), [&](std::size_t g) {
          const Double3& s = slip(model, i, g, 0);
          return s[0] == 0 && s[1] == 0 && s[2] == 0;
        })) {
      return true;
    }
  }
  return false;
}

void SpaceRegion::update(const SpaceModel& model) {
  list_points();
  generators_.clear();
  for (const Point& x : points()) {
    generators_.push_back(equilibrium_detail::scaled_point<6>(x, model.length));
  }
  const std::size_t m = model.contacts.size();
  high_.assign(m * generators_.size(), 0);
  low_.assign(m * generators_.size(), 0);
  for (std::size_t i = 0; i < m; ++i) find_separation(model, i);
  first_slip_.assign(m, 0);
  std::size_t values = 0;
  for (std::size_t i = 0; i < m; ++i) {
    first_slip_[i] = values;
    values += generators_.size() * model.contacts[i].corners.size();
  }
  slip_values_.assign(values, Double3{});
  for (std::size_t i = 0; i < m; ++i) {
    const bool matters = strict_slips_[i] != 0 || (separations_[i] != Separation::kOpen &&
                                                   !model.contacts[i].friction.high.is_zero());
    if (matters && still_[i] == 0) compute_slips(model, i);
  }
  classify(model);
}

void SpaceRegion::classify(const SpaceModel& model) {
  barred_ = bars_all(model, all_points());
  if (barred_) return;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) find_slips(model, i);
}

void SpaceRegion::compute_slips(const SpaceModel& model, std::size_t contact) {
  const std::vector<CornerRow>& corners = model.contacts[contact].corners;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const Double6 motion = equilibrium_detail::motion_of<6>(generators_[g]);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const CornerRow& row = corners[c];
      Double3 s{};
      double size = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        s[k] = dot(row.slip_rounded[k], motion);
        for (std::size_t j = 0; j < 6; ++j) {
          size = std::max(size, std::fabs(row.slip_rounded[k][j] * motion[j]));
        }
      }
      // Where much is lost to cancellation the direction is that of the exact slip.
      constexpr double kLost = 1e-5;
      if (!model.contacts[contact].is_moderate || !(dot(s, s) > kLost * kLost * size * size)) {
        constexpr double kLeast = 1e-100;  // whose square does not vanish
        const double before = std::max(std::sqrt(dot(s, s)), kLeast);
        s = in_doubles(exact_slip(row, points()[g]));
        equilibrium_detail::normalize(s);
        for (double& entry : s) entry *= before;
      }
      slip_values_[first_slip_[contact] + g * corners.size() + c] = s;
    }
  }
}

void SpaceRegion::find_separation(const SpaceModel& model, std::size_t contact) {
  const SpaceContact& c = model.contacts[contact];
  bool closed = true;
  bool open = true;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const ScaledPoint<6>& at = generators_[g];
    double high = -HUGE_VAL;
    double low = HUGE_VAL;
    std::size_t plane = 0;
    for (const CornerRow& row : c.corners) {
      const bool certain = c.preload.is_point() && c.rate.is_point();
      for (std::size_t k = 0; k < (c.stiffness.is_point() ? 1U : 2U); ++k) {
        for (std::size_t p = 0; p < (certain ? 1U : 2U); ++p) {
          std::array<double, 8> terms;
          for (std::size_t j = 0; j < 6; ++j) {
            terms[j] = -c.stiffnesses[k] * row.normal_rounded[j] * at[j];
          }
          terms[6] = c.preloads[p] * at[6];
          terms[7] = c.rates[p] * at[7];
          const double value =
              sum_of(terms, c.is_moderate, c.separations[plane++], points()[g]);
          high = std::max(high, value);
          low = std::min(low, value);
        }
      }
    }
    high_[contact * generators_.size() + g] = high;
    low_[contact * generators_.size() + g] = low;
    closed = closed && low >= 0;
    open = open && high <= 0;
  }
  separations_[contact] = closed ? Separation::kClosed
                          : open ? Separation::kOpen
                                 : Separation::kMixed;
}

/// The directions of slip by their angles around n: the cone is pointed if there is a gap of
/// more than half a turn between two of them.
void SpaceRegion::find_slips(const SpaceModel& model, std::size_t contact) {
  SlipCone& cone = slips_[contact];
  cone = {};
  const SpaceContact& c = model.contacts[contact];
  if (separations_[contact] == Separation::kOpen || c.friction.high.is_zero()) return;
  struct Direction {
    double angle;
    std::size_t generator;
    std::size_t corner;
  };
  std::vector<Direction> directions;
  std::vector<std::vector<std::size_t>> still(c.corners.size());  // where s = 0
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    for (std::size_t k = 0; k < c.corners.size(); ++k) {
      const Double3& s = slip(model, contact, g, k);
      if (s[0] == 0 && s[1] == 0 && s[2] == 0) {
        still[k].push_back(g);
      } else {
        directions.push_back({std::atan2(dot(s, c.tangents[1]), dot(s, c.tangents[0])), g, k});
      }
    }
  }
  cone.moves = strict_slips_[contact] != 0;
  if (directions.empty()) return;
  std::sort(directions.begin(), directions.end(),
            [](const Direction& a, const Direction& b) { return a.angle < b.angle; });
  constexpr double kPi = 3.14159265358979323846;
  double gap = 0;
  std::size_t after = 0;  // the first direction after the gap
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double before = k == 0 ? directions.back().angle - 2 * kPi : directions[k - 1].angle;
    if (directions[k].angle - before > gap) {
      gap = directions[k].angle - before;
      after = k;
    }
  }
  constexpr double kClose = 1e-7;
  if (gap < kPi - kClose) {
    cone.whole = true;  // and where it is, all slips have their negative in it
    return;
  }
  // If this is half a plane, or nearly, doubles do not say whether it is pointed. Directions
  // between its sides have no negative in it; one of them says which half it is.
  const bool may_be_half = gap < kPi + kClose;
  const double first = directions[after].angle;
  const double last = first + 2 * kPi - gap;
  std::optional<std::pair<std::size_t, std::size_t>> middle;
  for (const Direction& d : directions) {
    const double angle = d.angle < first ? d.angle + 2 * kPi : d.angle;
    const bool is_side = angle < first + kClose || angle > last - kClose;
    const bool is_middle = may_be_half && !is_side && !middle;
    if (is_middle) middle = {d.generator, d.corner};
    if (is_side || is_middle) cone.sides.emplace_back(d.generator, d.corner);
  }
  if (may_be_half) {
    std::vector<IntegerVector3> sides;
    for (const auto& [g, k] : cone.sides) {
      sides.push_back(exact_slip(c.corners[k], points()[g]));
    }
    const auto is_opposed = [&](std::size_t g, std::size_t k) {
      return is_in_cone(negated(exact_slip(c.corners[k], points()[g])), sides, c.axis);
    };
    if (middle && is_opposed(middle->first, middle->second)) {
      cone.whole = true;
      cone.sides.clear();
      return;
    }
    for (const auto& [g, k] : cone.sides) {
      if (!cone.moves && is_opposed(g, k)) still[k].push_back(g);
    }
  }
  if (cone.moves) return;
  cone.moves = std::all_of(still.begin(), still.end(),
                           [&](const auto& zeros) { return bars_all(model, zeros); });
}

/// alpha of the format.
Rational SpaceRegion::most_work(const SpaceModel& model, std::size_t contact,
                                const IntegerVector<6>& y) const {
  const SpaceContact& c = model.contacts[contact];
  const SlipCone& cone = slips_[contact];
  std::vector<IntegerVector3> sides;
  if (cone.moves && !cone.whole) {
    for (const auto& [g, k] : cone.sides) {
      sides.push_back(exact_slip(c.corners[k], points()[g]));
    }
  }
  constexpr unsigned kBits = 64;
  std::optional<Rational> most;
  for (const CornerRow& row : c.corners) {
    Rational normal = 0;
    for (std::size_t j = 0; j < 6; ++j) normal += Rational(y[j]) * row.normal[j];
    const auto consider = [&](Rational alpha) {
      if (!most || alpha > *most) most = std::move(alpha);
    };
    if (c.friction.high.is_zero()) {
      consider(normal);
      continue;
    }
    const IntegerVector3 slid{dot(row.slip[0], y), dot(row.slip[1], y), dot(row.slip[2], y)};
    int sign = 1;
    Rational square = Rational(dot(slid, slid)) / (row.slip_factor * row.slip_factor);
    if (cone.moves && !cone.whole && !square.is_zero() && !sides.empty() &&
        !is_in_cone(negated(slid), sides, c.axis)) {
      bool first = true;
      Rational best = 0;  // with its sign
      for (const IntegerVector3& s : sides) {
        const Integer work = -dot(s, slid);
        const Rational signed_square(Integer(work * abs(work)), dot(s, s));
        if (first || signed_square > best) best = signed_square;
        first = false;
      }
      sign = best.sign();
      square = abs(best) / (row.slip_factor * row.slip_factor);
    }
    for (const Rational& mu : {c.friction.low, c.friction.high}) {
      const Rational q = mu * mu * c.squared_length * square;
      if (q.is_zero()) {
        consider(normal);
        continue;
      }
      const ShortRoot root = short_sqrt(q, kBits);
      consider(sign > 0 ? Rational(normal + root.upper) : Rational(normal - root.lower));
    }
  }
  return *most;
}

bool SpaceRegion::is_refuted(const SpaceModel& model, const IntegerVector<6>& y,
                             const Direction<6>* direction) const {
  if (barred_) return true;
  if (direction != nullptr && !direction->holds(y, points())) return false;
  // g(r) = linear.r + sum of kinks, all times a common factor.
  struct Kink {
    Rational alpha;
    std::size_t contact;
  };
  std::array<Rational, 8> linear{};
  for (std::size_t j = 0; j < 6; ++j) {
    linear[6] +=
        Rational(y[j]) * (y[j].sign() > 0 ? model.wrench[j].high : model.wrench[j].low);
    linear[7] += Rational(y[j]) * model.growth[j];
  }
  std::vector<Kink> kinks;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    if (separations_[i] == Separation::kOpen) continue;
    const SpaceContact& c = model.contacts[i];
    Rational alpha = most_work(model, i, y);
    const bool closed = separations_[i] == Separation::kClosed;
    if (!closed && alpha.sign() <= 0) continue;
    if (closed && c.separations.size() == 1) {
      const Rational weight = alpha * c.separation_factors.front();
      for (std::size_t j = 0; j < 8; ++j) {
        linear[j] += weight * Rational(c.separations.front()[j]);
      }
    } else {
      kinks.push_back({std::move(alpha), i});
    }
  }
  Integer common = 1;
  for (const Rational& entry : linear) common = lcm(common, denominator(entry));
  std::vector<std::vector<Rational>> weights;
  for (const Kink& kink : kinks) {
    weights.emplace_back();
    for (const Rational& factor : model.contacts[kink.contact].separation_factors) {
      weights.back().push_back(kink.alpha * factor);
      common = lcm(common, denominator(weights.back().back()));
    }
  }
  const auto whole = [&](const Rational& value) {
    return Integer(numerator(value) * (common / denominator(value)));
  };
  Point form{};
  for (std::size_t j = 0; j < 8; ++j) form[j] = whole(linear[j]);
  std::vector<std::vector<Integer>> factors;
  for (const auto& list : weights) {
    factors.emplace_back();
    for (const Rational& value : list) factors.back().push_back(whole(value));
  }
  std::vector<std::size_t> zeros;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const Point& x = points()[g];
    Integer sum = dot(form, x);
    for (std::size_t k = 0; k < kinks.size(); ++k) {
      const std::size_t i = kinks[k].contact;
      const std::vector<Point>& planes = model.contacts[i].separations;
      std::optional<Integer> most;
      for (std::size_t p = 0; p < planes.size(); ++p) {
        Integer work = factors[k][p] * dot(planes[p], x);
        if (!most || work > *most) most = std::move(work);
      }
      if (separations_[i] == Separation::kClosed || most->sign() > 0) sum += *most;
    }
    if (sum.sign() > 0) return false;
    if (sum.is_zero()) zeros.push_back(g);
  }
  return bars_all(model, zeros);
}

}  // namespace stickslip::space_detail
