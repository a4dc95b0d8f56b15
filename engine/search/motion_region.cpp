// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/motion_region.hpp"

#include <algorithm>
#include <cmath>

#include "engine/motion/nearest_wrench.hpp"
#include "nearest_in_cone.hpp"

namespace stickslip {

using search_detail::ConePoint;
using search_detail::nearest_in_cone;

namespace {

/// Returns whether a rounded sum of terms of this magnitude has the right sign and a few
/// digits.
bool is_kept(double sum, double magnitude) {
  constexpr double kLost = 1e-10;
  constexpr double kLeast = 1e-200;  // underflows are nothing beside it
  return std::fabs(sum) > kLost * magnitude + kLeast;
}

/// Returns the sum of terms that are, up to rounding and one positive factor, those of
/// function.x. It has the exact sign, and a few digits even where terms cancel.
double exact_sum(const Reals& terms, const Row& function, const Row& x) {
  const Integer exact = dot(function, x);
  if (exact.is_zero()) return 0;
  Eigen::Index largest = 0;
  terms.cwiseAbs().maxCoeff(&largest);
  const auto at = static_cast<std::size_t>(largest);
  const Integer term = function[at] * x[at];
  const std::array<double, 2> both = in_doubles(IntegerVector<2>{exact, term});
  const double value = both[0] / both[1] * terms[largest];
  // A value that underflows is tiny, but not 0.
  constexpr double kTiny = 1e-300;
  return std::isfinite(value) && value * exact.sign() > 0 ? value : exact.sign() * kTiny;
}

/// Returns the sign of (a x b).n: whether b is to the left of a, seen against n.
int turn(const ExactSlip& a, const ExactSlip& b, const IntegerVector3& n) {
  return dot(cross(IntegerVector3{a[0], a[1], a[2]}, IntegerVector3{b[0], b[1], b[2]}), n)
      .sign();
}

/// Returns whether u, not 0 and across n, is a sum of nonnegative multiples of these, without
/// torsion. In the plane all have one number, and n is 0.
bool is_in_cone(const ExactSlip& u, const std::vector<ExactSlip>& directions,
                const IntegerVector3& n) {
  const ExactSlip* left = nullptr;  // the nearest to u of those to the left
  const ExactSlip* right = nullptr;
  for (const ExactSlip& s : directions) {
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

/// Returns the plane of sign (l - end h) >= 0.
Row end_plane(std::size_t motions, const Rational& end, int sign) {
  RationalRow plane(motions + 2);
  plane[motions] = -sign * end;
  plane[motions + 1] = sign;
  return primitive_multiple(plane);
}

/// Returns the function B_j h - sign d_j of points. Motions at which it is below 0 are beyond
/// the bound.
Row bound_plane(const RationalRow& bound, std::size_t j, int sign) {
  RationalRow plane(bound.size() + 2);
  plane[j] = -sign;
  plane[bound.size()] = bound[j];
  return primitive_multiple(plane);
}

bool is_zero(const Double3& s) {
  return s[0] == 0 && s[1] == 0 && s[2] == 0;
}

Double3 negated(const Double3& s) {
  return {-s[0], -s[1], -s[2]};
}

/// Returns |q|^2 for a q with <-t - q, s> <= 0 for all sides of a cone of three dimensions: the
/// point of the cone nearest to -t, where doubles find it. `towards` is t in doubles. The units
/// are those of LawContact::product. Returns nothing if doubles find no q that is nearer to 0
/// than t.
std::optional<Rational> squared_nearest(const LawContact& c,
                                        const std::vector<ExactSlip>& sides,
                                        const std::vector<Double3>& units, const ExactSlip& t,
                                        const Double3& towards) {
  const std::vector<std::size_t> in_use = nearest_in_cone(units, negated(towards)).generators;
  if (in_use.size() > 2) return std::nullopt;
  std::vector<Integer> works;  // the work -<t, s> of friction along each side
  for (const ExactSlip& s : sides) works.emplace_back(-c.product(t, s));
  // q is a sum of multiples / common.
  std::vector<Integer> multiples;
  Integer common = 1;
  if (in_use.size() == 1) {
    const ExactSlip& s = sides[in_use[0]];
    common = c.product(s, s);
    multiples.push_back(works[in_use[0]]);
  } else if (in_use.size() == 2) {
    const ExactSlip& a = sides[in_use[0]];
    const ExactSlip& b = sides[in_use[1]];
    const Integer aa = c.product(a, a);
    const Integer ab = c.product(a, b);
    const Integer bb = c.product(b, b);
    common = aa * bb - ab * ab;
    const Integer& on_a = works[in_use[0]];
    const Integer& on_b = works[in_use[1]];
    multiples.emplace_back(on_a * bb - on_b * ab);
    multiples.emplace_back(on_b * aa - on_a * ab);
  }
  if (common.is_zero()) return std::nullopt;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    Integer rest = common * works[k];
    for (std::size_t l = 0; l < in_use.size(); ++l) {
      rest -= multiples[l] * c.product(sides[in_use[l]], sides[k]);
    }
    if (rest.sign() > 0) return std::nullopt;
  }
  Integer square = 0;
  for (std::size_t k = 0; k < in_use.size(); ++k) square += multiples[k] * works[in_use[k]];
  return Rational(square, common);
}

/// Returns the cone of all functions that are nowhere below 0 on these vectors of three
/// numbers. Beside them it has one ray that is about none of these.
ConeOf<Row> dual_cone(const std::vector<RationalRow>& vectors) {
  ConeOf<Row> cone(ConeOf<Row>::Multiples::kZero, 5);
  for (const RationalRow& v : vectors) {
    Row plane = primitive_multiple(v);
    plane.resize(5);
    cone.cut(plane, Side::kPositive);
  }
  return cone;
}

}  // namespace

std::vector<Row> simplex_planes(const RationalRow& bound) {
  const std::size_t motions = bound.size();
  std::vector<Row> planes;
  RationalRow sum(motions + 2);
  for (std::size_t j = 0; j < motions; ++j) {
    RationalRow plane(motions + 2);
    plane[j] = 1;
    plane[motions] = bound[j];
    planes.push_back(primitive_multiple(plane));
    sum[j] = -1 / bound[j];
  }
  sum[motions] = motions;
  planes.push_back(primitive_multiple(sum));
  return planes;
}

MotionRegion MotionRegion::wall(const Law& law, const ConvexBody& body, std::size_t wall) {
  StrictCone cone = whole_family(law);
  cone.cut_to_wall(body, wall);
  return MotionRegion(law, std::move(cone), true);
}

MotionRegion::MotionRegion(const Law& law, StrictCone cone, bool is_of_wall)
    : StrictCone(std::move(cone)),
      law_(&law),
      is_of_wall_(is_of_wall),
      strict_slips_(law.contacts.size(), 0),
      still_(law.contacts.size(), 0),
      separations_(law.contacts.size(), Separation::kMixed),
      slips_(law.contacts.size()),
      exact_sides_(law.contacts.size()) {
  update();
}

MotionRegion MotionRegion::root(const Law& law) {
  StrictCone cone(law.motions, law.is_family ? Multiples::kAny : Multiples::kZero);
  if (law.is_family) {
    const auto& [low, high, has_low] = law.multiples;
    cone.cut(end_plane(law.motions, low, 1), Side::kPositive, !has_low);
    if (high) cone.cut(end_plane(law.motions, *high, -1), Side::kPositive, true);
  }
  if (!law.max_motion.empty()) {
    for (const Row& plane : simplex_planes(law.max_motion)) cone.cut(plane, Side::kPositive);
  }
  if (law.normal_law == NormalLaw::kBilateral) {
    for (const LawContact& contact : law.contacts) {
      if (contact.has_certain_separation && !contact.is_spring) {
        cone.cut(contact.separations.front(), Side::kPositive);
      }
    }
  }
  return MotionRegion(law, std::move(cone));
}

/// Returns the cone of all motions, with both ends of the multiples included.
StrictCone MotionRegion::whole_family(const Law& law) {
  StrictCone cone(law.motions, law.is_family ? Multiples::kAny : Multiples::kZero);
  if (law.is_family) {
    cone.cut(end_plane(law.motions, law.multiples.low, 1), Side::kPositive);
    cone.cut(end_plane(law.motions, *law.multiples.high, -1), Side::kPositive);
  }
  return cone;
}

/// Returns whether all motions are beyond the bound. Doubles say at which functions a look is
/// worth while.
bool MotionRegion::is_beyond() const {
  if (is_of_wall_) return false;
  const RationalRow& bound = law_->max_motion;
  const auto height = static_cast<Eigen::Index>(bound.size());
  for (std::size_t j = 0; j < bound.size(); ++j) {
    const double most = to_double(bound[j]) * law_->unit(j);
    for (const int sign : {1, -1}) {
      const bool may_be =
          std::all_of(generators_.begin(), generators_.end(), [&](const Reals& x) {
            constexpr double kNearly = 1 - 1e-9;
            return sign * x[static_cast<Eigen::Index>(j)] >= kNearly * most * x[height];
          });
      if (!may_be) continue;
      const PlaneSigns signs = this->signs(bound_plane(bound, j, sign));
      if (!signs.positive && signs.zeros_barred) return true;
    }
  }
  return false;
}

std::optional<Row> MotionRegion::bound_across(const Reals& point) const {
  const RationalRow& bound = law_->max_motion;
  if (is_of_wall_ || bound.empty()) return std::nullopt;
  const double height = point[static_cast<Eigen::Index>(bound.size())];
  std::optional<std::size_t> farthest;
  double most = 1 + 1e-9;
  for (std::size_t j = 0; j < bound.size(); ++j) {
    const double part = std::fabs(point[static_cast<Eigen::Index>(j)]) /
                        (to_double(bound[j]) * law_->unit(j) * height);
    if (!(part > most)) continue;
    most = part;
    farthest = j;
  }
  if (!farthest) return std::nullopt;
  Row plane =
      bound_plane(bound, *farthest, point[static_cast<Eigen::Index>(*farthest)] > 0 ? 1 : -1);
  if (!signs(plane).cuts()) return std::nullopt;
  return plane;
}

std::optional<Sign> MotionRegion::slip_sign(std::size_t contact) const {
  const SlipCone& cone = slips_[contact];
  if (!cone.moves || cone.whole || cone.sides.empty()) return std::nullopt;
  const auto& [generator, corner] = cone.sides.front();
  return slip(contact, generator, corner)[0] > 0 ? Sign::kPositive : Sign::kNegative;
}

MotionRegion::MotionRegion(const MotionRegion& parent, StrictCone cone)
    : StrictCone(std::move(cone)),
      law_(parent.law_),
      is_of_wall_(parent.is_of_wall_),
      strict_slips_(parent.strict_slips_),
      still_(parent.still_),
      separations_(parent.separations_.size(), Separation::kMixed),
      slips_(parent.slips_.size()),
      exact_sides_(parent.slips_.size()) {}

std::vector<MotionRegion> MotionRegion::children(const Row& plane,
                                                 const std::vector<StrictSide>& sides) const {
  std::vector<MotionRegion> children;
  for (StrictCone& cone : StrictCone::parts(plane, sides)) {
    children.push_back(MotionRegion(*this, std::move(cone)));
  }
  return children;
}

std::vector<MotionRegion> MotionRegion::halves(const Row& plane) const {
  std::vector<MotionRegion> both =
      children(plane, {{Side::kPositive, false}, {Side::kNegative, true}});
  for (MotionRegion& region : both) region.update();
  return both;
}

std::vector<MotionRegion> MotionRegion::slip_children(std::size_t contact) const {
  const std::vector<Row> planes =
      law_->contacts[contact].corners.front().slip_planes(law_->coordinates());
  if (planes.size() == 1) {
    std::vector<MotionRegion> three =
        children(planes.front(),
                 {{Side::kPositive, true}, {Side::kZero, false}, {Side::kNegative, true}});
    three[1].still_[contact] = 1;
    for (MotionRegion& region : three) region.update();
    return three;
  }
  MotionRegion still = *this;
  for (const Row& plane : planes) still.cut(plane, Side::kZero);
  still.still_[contact] = 1;
  still.update();
  MotionRegion slipping = *this;  // the cone stays as it is, and so do its generators
  slipping.strict_slips_[contact] = 1;
  slipping.classify();
  return {std::move(still), std::move(slipping)};
}

bool MotionRegion::bars_all(const std::vector<std::size_t>& zeros) const {
  if (bars(zeros)) return true;
  for (std::size_t i = 0; i < strict_slips_.size(); ++i) {
    if (!strict_slips_[i]) continue;
    if (std::all_of(zeros.begin(), zeros.end(),
                    [&](std::size_t g) { return is_zero(slip(i, g, 0)); })) {
      return true;
    }
  }
  return false;
}

void MotionRegion::update() {
  list_points();
  generators_.clear();
  for (const Row& x : points()) generators_.push_back(law_->scaled(x));
  const std::size_t m = law_->contacts.size();
  high_.assign(m * generators_.size(), 0);
  low_.assign(m * generators_.size(), 0);
  first_.assign(m, 0);
  std::size_t values = 0;
  for (std::size_t i = 0; i < m; ++i) {
    find_separation(i);
    first_[i] = values;
    values += generators_.size() * law_->contacts[i].corners.size();
  }
  slip_values_.assign(values, Double3{});
  rises_.assign(values, 0);
  for (std::size_t i = 0; i < m; ++i) {
    const LawContact& c = law_->contacts[i];
    const bool acts = separations_[i] != Separation::kOpen;
    const bool matters = strict_slips_[i] != 0 || (acts && !c.friction.high.is_zero());
    if (matters && still_[i] == 0) compute_slips(i);
    if (acts && c.whole) compute_rises(i);
  }
  classify();
}

void MotionRegion::classify() {
  barred_ = bars_all(all_points()) || is_beyond();
  if (barred_) return;
  for (std::size_t i = 0; i < law_->contacts.size(); ++i) find_slips(i);
}

ExactSlip MotionRegion::exact_slip(std::size_t contact, std::size_t generator,
                                   std::size_t corner) const {
  const std::vector<Row>& rows = law_->contacts[contact].corners[corner].slip;
  ExactSlip s{};
  for (std::size_t k = 0; k < rows.size(); ++k) s[k] = dot(rows[k], points()[generator]);
  return s;
}

const std::vector<ExactSlip>& MotionRegion::exact_sides(std::size_t contact) const {
  std::vector<ExactSlip>& exact = exact_sides_[contact];
  if (exact.empty()) {
    for (const auto& [g, k] : slips_[contact].sides) exact.push_back(exact_slip(contact, g, k));
  }
  return exact;
}

void MotionRegion::compute_slips(std::size_t contact) {
  const std::vector<CornerRow>& corners = law_->contacts[contact].corners;
  const auto n = static_cast<Eigen::Index>(law_->motions);
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const auto motion = generators_[g].head(n);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const std::vector<Reals>& rows = corners[c].slip_rounded;
      Double3 s{};
      double size = 0;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        s[k] = rows[k].dot(motion);
        size = std::max(size, rows[k].cwiseProduct(motion).lpNorm<Eigen::Infinity>());
      }
      // The direction is that of the exact slip where much is lost to cancellation.
      constexpr double kLost = 1e-5;
      if (!law_->contacts[contact].is_moderate || !(dot(s, s) > kLost * kLost * size * size)) {
        constexpr double kLeast = 1e-100;  // its square does not vanish
        double before = std::sqrt(dot(s, s));
        // A slip that overflowed has no length: any will do.
        if (!(before > kLeast && before < 1 / kLeast)) before = kLeast;
        const ExactSlip exact = exact_slip(contact, g, c);
        s = law_->contacts[contact].direction_of(exact);
        if (is_zero(s) && exact != ExactSlip{}) s[0] = 1;  // some direction, as it is not 0
        for (double& entry : s) entry *= before;
      }
      slip_values_[first_[contact] + g * corners.size() + c] = s;
    }
  }
}

void MotionRegion::compute_rises(std::size_t contact) {
  const LawContact& c = law_->contacts[contact];
  const auto n = static_cast<Eigen::Index>(law_->motions);
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    for (std::size_t k = 0; k < c.corners.size(); ++k) {
      const Reals terms = c.corners[k].normal_rounded.cwiseProduct(generators_[g].head(n));
      double& rise = rises_[first_[contact] + g * c.corners.size() + k];
      rise = terms.sum();
      if (!c.is_moderate || !is_kept(rise, terms.lpNorm<1>())) {
        rise = exact_sum(terms, c.whole->normals[k], points()[g]);
      }
    }
  }
}

void MotionRegion::find_separation(std::size_t contact) {
  const LawContact& c = law_->contacts[contact];
  const auto n = static_cast<Eigen::Index>(law_->motions);
  const std::size_t stiffness_ends = c.stiffness.is_point() ? 1 : 2;
  const std::size_t preload_ends = c.preload.is_point() && c.rate.is_point() ? 1 : 2;
  bool closed = true;
  bool open = true;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const Reals& at = generators_[g];
    double high = -HUGE_VAL;
    double low = HUGE_VAL;
    std::size_t plane = 0;
    for (const CornerRow& row : c.corners) {
      double rise = 0;
      double size = 0;
      for (Eigen::Index j = 0; j < n; ++j) {
        rise += row.normal_rounded[j] * at[j];
        size += std::fabs(row.normal_rounded[j] * at[j]);
      }
      for (std::size_t k = 0; k < stiffness_ends; ++k) {
        for (std::size_t p = 0; p < preload_ends; ++p) {
          const double pushed = c.preloads[p] * at[n] + c.rates[p] * at[n + 1];
          double value = pushed - c.stiffnesses[k] * rise;
          const double magnitude = std::fabs(c.preloads[p] * at[n]) +
                                   std::fabs(c.rates[p] * at[n + 1]) + c.stiffnesses[k] * size;
          if (!c.is_moderate || !is_kept(value, magnitude)) {
            Reals terms(n + 2);
            terms.head(n) = -c.stiffnesses[k] * row.normal_rounded.cwiseProduct(at.head(n));
            terms[n] = c.preloads[p] * at[n];
            terms[n + 1] = c.rates[p] * at[n + 1];
            value = exact_sum(terms, c.separations[plane], points()[g]);
          }
          ++plane;
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
  separations_[contact] = closed || c.is_spring ? Separation::kClosed
                          : open                ? Separation::kOpen
                                                : Separation::kMixed;
}

void MotionRegion::find_slips(std::size_t contact) {
  SlipCone& cone = slips_[contact];
  cone = {};
  exact_sides_[contact].clear();
  const LawContact& c = law_->contacts[contact];
  if (separations_[contact] == Separation::kOpen || c.friction.high.is_zero()) return;
  if (c.slip_dimension() == 1) {
    find_sign(cone, contact);
  } else if (c.slip_dimension() == 2) {
    find_sides(cone, contact);
  } else {
    find_solid(cone, contact);
  }
}

/// Finds the sign of slip of a contact in the plane.
void MotionRegion::find_sign(SlipCone& cone, std::size_t contact) const {
  const std::size_t corners = law_->contacts[contact].corners.size();
  std::vector<std::vector<std::size_t>> still(corners);  // points with s = 0
  int sign = 0;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    for (std::size_t k = 0; k < corners; ++k) {
      const double s = slip(contact, g, k)[0];
      if (s == 0) {
        still[k].push_back(g);
        continue;
      }
      const int here = s > 0 ? 1 : -1;
      if (sign == 0) {
        sign = here;
        cone.sides.emplace_back(g, k);
      }
      if (here != sign) {
        cone.whole = true;
        cone.sides.clear();
        return;
      }
    }
  }
  cone.moves = sign != 0 && std::all_of(still.begin(), still.end(),
                                        [&](const auto& zeros) { return bars_all(zeros); });
}

/// Finds the cone of slips in two dimensions, from their angles around n. The cone is pointed
/// if there is a gap of more than half a turn between two neighbours.
void MotionRegion::find_sides(SlipCone& cone, std::size_t contact) const {
  const LawContact& c = law_->contacts[contact];
  struct Way {
    double angle;
    std::size_t generator;
    std::size_t corner;
  };
  std::vector<Way> directions;
  std::vector<std::vector<std::size_t>> still(c.corners.size());  // points with s = 0
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    for (std::size_t k = 0; k < c.corners.size(); ++k) {
      const Double3& s = slip(contact, g, k);
      if (is_zero(s)) {
        still[k].push_back(g);
      } else {
        directions.push_back({std::atan2(s[1], s[0]), g, k});
      }
    }
  }
  cone.moves = strict_slips_[contact] != 0;
  if (directions.empty()) return;
  std::sort(directions.begin(), directions.end(),
            [](const Way& a, const Way& b) { return a.angle < b.angle; });
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
    cone.whole = true;  // then the cone has the negative of every slip
    return;
  }
  // Doubles do not say whether a cone of half a plane, or nearly, is pointed. Directions
  // between the sides of a half-plane do not have their negative in it. One of them becomes a
  // side: it says which half it is.
  const bool may_be_half = gap < kPi + kClose;
  const double first = directions[after].angle;
  const double last = first + 2 * kPi - gap;
  std::optional<Way> middle;
  std::vector<Way> near_first;
  std::vector<Way> near_last;
  for (const Way& d : directions) {
    const double angle = d.angle < first ? d.angle + 2 * kPi : d.angle;
    const bool is_first = angle < first + kClose;
    const bool is_last = angle > last - kClose;
    const bool is_middle = may_be_half && !is_first && !is_last && !middle;
    if (is_middle) middle = d;
    if (is_first) near_first.push_back(d);
    if (is_last && !is_first) near_last.push_back(d);
    if (is_first || is_last || is_middle) cone.sides.emplace_back(d.generator, d.corner);
  }
  constexpr std::size_t kManySides = 100;
  if (cone.sides.size() > kManySides) {
    // The two outermost ones of many directions that doubles hardly tell apart are the sides.
    // (One would do, but at nearly opposite ends the other one says which way the cone goes.)
    cone.sides.clear();
    if (middle) cone.sides.emplace_back(middle->generator, middle->corner);
    for (const auto* near : {&near_first, &near_last}) {
      if (near->empty()) continue;
      for (const int sign : {-1, 1}) {
        Way end = near->front();
        for (const Way& d : *near) {
          const int turned = turn(exact_slip(contact, end.generator, end.corner),
                                  exact_slip(contact, d.generator, d.corner), c.axis);
          if (turned == sign) end = d;
        }
        cone.sides.emplace_back(end.generator, end.corner);
      }
    }
  }
  if (may_be_half) {
    std::vector<ExactSlip> sides;
    for (const auto& [g, k] : cone.sides) sides.push_back(exact_slip(contact, g, k));
    const auto is_opposed = [&](std::size_t g, std::size_t k) {
      return is_in_cone(negated(exact_slip(contact, g, k)), sides, c.axis);
    };
    if (middle && is_opposed(middle->generator, middle->corner)) {
      cone.whole = true;
      cone.sides.clear();
      return;
    }
    for (const auto* near : {&near_first, &near_last}) {
      for (const auto& [angle, g, k] : *near) {
        if (!cone.moves && is_opposed(g, k)) still[k].push_back(g);
      }
    }
  }
  if (cone.moves) return;
  cone.moves = std::all_of(still.begin(), still.end(),
                           [&](const auto& zeros) { return bars_all(zeros); });
}

/// Finds the cone of slips in three dimensions. If doubles do not show that it is pointed, the
/// functions that are nowhere below 0 on it tell which of its vectors have their negative in
/// it.
void MotionRegion::find_solid(SlipCone& cone, std::size_t contact) const {
  const LawContact& c = law_->contacts[contact];
  std::vector<std::vector<std::size_t>> still(c.corners.size());  // points with -s in the cone
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    for (std::size_t k = 0; k < c.corners.size(); ++k) {
      Double3 s = slip(contact, g, k);
      if (is_zero(s)) {
        still[k].push_back(g);
        continue;
      }
      normalize(s);
      cone.sides.emplace_back(g, k);
      cone.units.push_back(s);
    }
  }
  cone.moves = strict_slips_[contact] != 0;
  if (cone.sides.empty()) return;
  struct Against {
    double work;
    Double3 wrench;
  };
  const auto worst = [&](const Double3& y) -> std::optional<Against> {
    Against most{-HUGE_VAL, {}};
    for (const Double3& s : cone.units) {
      if (const double work = dot(s, y); work > most.work) most = {work, s};
    }
    return most;
  };
  constexpr double kClear = 1e-7;
  const auto found = nearest_wrench(Double3{1, 0, 0}, worst, true);
  if (!c.is_moderate || !found.separated ||
      !(worst(found.twist)->work < -kClear * norm_of(found.twist))) {
    std::vector<RationalRow> coordinates;
    for (const auto& [g, k] : cone.sides) {
      const ExactSlip s = exact_slip(contact, g, k);
      RationalRow& along = coordinates.emplace_back();
      for (const RationalRow& direction : c.directions) {
        Rational& sum = along.emplace_back();
        for (std::size_t j = 0; j < direction.size(); ++j) {
          sum += direction[j] * Rational(s[j]);
        }
      }
    }
    const ConeOf<Row> dual = dual_cone(coordinates);
    const std::vector<Row> functions = dual.directions();
    cone.whole = dual.lines().empty() && dual.rays().size() == 1;
    for (std::size_t side = 0; side < cone.sides.size(); ++side) {
      const bool is_opposed = std::all_of(
          functions.begin(), functions.end(),
          [&](const Row& function) { return dot(function, coordinates[side]).is_zero(); });
      if (is_opposed) still[cone.sides[side].second].push_back(cone.sides[side].first);
    }
  }
  if (cone.moves) return;
  cone.moves = std::all_of(still.begin(), still.end(),
                           [&](const auto& zeros) { return bars_all(zeros); });
}

/// Returns alpha of the format.
Rational MotionRegion::most_work(std::size_t contact, const Row& y) const {
  const LawContact& c = law_->contacts[contact];
  const SlipCone& cone = slips_[contact];
  const bool is_bound = cone.moves && !cone.whole && !cone.sides.empty();
  const bool is_solid = c.slip_dimension() == 3;
  Reals rounded;  // y in doubles
  if (is_bound && is_solid) {
    rounded = in_doubles(y);
    law_->scale(rounded);
  }
  constexpr unsigned kBits = 64;
  std::optional<Rational> most;
  for (const CornerRow& row : c.corners) {
    const Rational normal = dot(y, row.normal);
    const auto consider = [&](Rational alpha) {
      if (!most || alpha > *most) most = std::move(alpha);
    };
    if (c.friction.high.is_zero()) {
      consider(normal);
      continue;
    }
    ExactSlip slid{};
    for (std::size_t k = 0; k < row.slip.size(); ++k) slid[k] = dot(row.slip[k], y);
    int sign = 1;
    const Rational scale =
        row.slip_factor * row.slip_factor * Rational(denominator(c.spin_weight));
    const Rational whole = Rational(c.product(slid, slid)) / scale;
    Rational square = whole;
    std::optional<Rational> nearest;
    if (is_bound && is_solid && !square.is_zero()) {
      Double3 towards{};
      for (std::size_t k = 0; k < 3; ++k) towards[k] = row.slip_rounded[k].dot(rounded);
      nearest = squared_nearest(c, exact_sides(contact), cone.units, slid, towards);
      if (nearest) square = *nearest / scale;
    }
    if (is_bound && !whole.is_zero() &&
        (is_solid ? nearest && nearest->is_zero()
                  : !is_in_cone(negated(slid), exact_sides(contact), c.axis))) {
      bool first = true;
      Rational best = 0;  // squared, but with its sign
      for (const ExactSlip& s : exact_sides(contact)) {
        const Integer work = -c.product(s, slid);
        const Rational signed_square(Integer(work * abs(work)), c.product(s, s));
        if (first || signed_square > best) best = signed_square;
        first = false;
      }
      sign = best.sign();
      square = abs(best) / scale;
    }
    for (const Rational& mu : {c.friction.low, c.friction.high}) {
      if (c.slip_dimension() == 1) {  // no root is needed
        consider(normal + sign * mu * abs(Rational(slid[0]) / row.slip_factor));
        continue;
      }
      const Rational steepness = mu * mu * c.squared_length;
      Rational alpha = normal;
      if (const Rational q = steepness * square; !q.is_zero()) {
        const ShortRoot root = short_sqrt(q, kBits);
        alpha += sign > 0 ? root.upper : Rational(-root.lower);
      }
      if (const Rational q = steepness * whole; !c.tilt.is_zero() && !q.is_zero()) {
        alpha += Rational(3, 2) * c.tilt * short_sqrt(q, kBits).upper;
      }
      consider(std::move(alpha));
    }
  }
  return *most;
}

bool MotionRegion::is_refuted(const Row& y, const PullRule* pull) const {
  if (barred_) return true;
  if (pull != nullptr && !pull->holds(y, points())) return false;
  if (law_->hull && law_->hull->is_unbounded(y)) return false;
  // g(r) = linear.r + sum of terms that are not linear, all times a common factor.
  const std::size_t d = law_->motions;
  RationalRow linear(law_->coordinates());
  linear[d] = law_->most_load_work(y);
  for (std::size_t j = 0; law_->is_family && j < d; ++j) {
    linear[d + 1] += Rational(y[j]) * law_->growth[j];
  }
  struct Kink {  // the largest factor times separation, at least 0 unless it is closed
    std::size_t contact;
    RationalRow weights;
    Row factors{};
  };
  struct Product {  // over pairs of corners
    std::size_t contact;
    CornerWork<Integer> work;
    Integer factor{};
  };
  std::vector<Kink> kinks;
  std::vector<Product> products;
  Integer common = 1;
  for (std::size_t i = 0; i < law_->contacts.size(); ++i) {
    if (separations_[i] == Separation::kOpen) continue;
    const LawContact& c = law_->contacts[i];
    const bool closed = separations_[i] == Separation::kClosed;
    if (c.whole) {
      std::vector<std::vector<Integer>> alpha;
      for (const Integer& slope : slopes(i, c.whole->frictions)) {
        std::vector<Integer>& of = alpha.emplace_back();
        for (std::size_t k = 0; k < c.corners.size(); ++k) {
          of.emplace_back(c.whole->cone * dot(c.whole->normals[k], y) +
                          slope * dot(c.whole->tangents[k], y));
        }
      }
      products.push_back({i, {c.whole->ends, std::move(alpha), !closed}});
      common = lcm(common, denominator(c.whole->weight));
      continue;
    }
    const Rational alpha = most_work(i, y);
    if (!closed && alpha.sign() <= 0) continue;
    if (closed && c.separations.size() == 1) {
      const Rational weight = alpha * c.separation_factors.front();
      for (std::size_t j = 0; j < linear.size(); ++j) {
        linear[j] += weight * Rational(c.separations.front()[j]);
      }
      continue;
    }
    Kink kink{i, {}};
    for (const Rational& factor : c.separation_factors) {
      kink.weights.push_back(alpha * factor);
      common = lcm(common, denominator(kink.weights.back()));
    }
    kinks.push_back(std::move(kink));
  }
  for (const Rational& entry : linear) common = lcm(common, denominator(entry));
  const auto whole = [&](const Rational& value) {
    return Integer(numerator(value) * (common / denominator(value)));
  };
  Row form;
  for (const Rational& entry : linear) form.push_back(whole(entry));
  for (Kink& kink : kinks) {
    for (const Rational& weight : kink.weights) kink.factors.push_back(whole(weight));
  }
  for (Product& product : products) {
    product.factor = whole(law_->contacts[product.contact].whole->weight);
  }
  std::vector<std::size_t> zeros;
  bool is_loaded = false;  // h > 0 at one of these
  std::array<Integer, 8> rises;
  for (std::size_t g = 0; g < generators_.size(); ++g) {
    const Row& x = points()[g];
    Integer sum = dot(form, x);
    for (const Kink& kink : kinks) {
      const std::vector<Row>& planes = law_->contacts[kink.contact].separations;
      std::optional<Integer> most;
      for (std::size_t p = 0; p < planes.size(); ++p) {
        Integer work = kink.factors[p] * dot(planes[p], x);
        if (!most || work > *most) most = std::move(work);
      }
      if (separations_[kink.contact] == Separation::kClosed || most->sign() > 0) sum += *most;
    }
    for (const Product& product : products) {
      const std::vector<Row>& normals = law_->contacts[product.contact].whole->normals;
      for (std::size_t k = 0; k < normals.size(); ++k) rises[k] = dot(normals[k], x);
      sum += product.factor * product.work.at(x[d], rises.data()).bound;
    }
    if (sum.sign() > 0) return false;
    if (!sum.is_zero()) continue;
    zeros.push_back(g);
    is_loaded = is_loaded || !x[d].is_zero();
  }
  return bars_all(zeros) || (law_->hull && law_->hull->bars(y, is_loaded));
}

}  // namespace stickslip
