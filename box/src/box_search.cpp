// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_search.hpp"

#include <cmath>
#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/equilibrium/search/nearest_point.hpp"

namespace stickslip::box_detail {
namespace {

using Double3 = std::array<double, 3>;
using Double4 = std::array<double, 4>;

double norm(const Double3& a) {
  return std::sqrt(dot(a, a));
}

/// (d, h), in doubles.
Double4 shortened(const IntegerVector5& x) {
  return in_doubles(IntegerVector<4>{x[0], x[1], x[2], x[3]});
}

}  // namespace

/// The point of least norm of the wrenches that the region allows, in doubles; and the relaxed
/// equilibrium, if that is 0.
class BoxSearch::Wolfe {
 public:
  Wolfe(const BoxModel& model, const BoxRegion& region, const Direction* direction);

  /// Whether a virtual twist was found.
  bool run();
  const Double3& twist() const { return twist_; }
  const Relaxed& relaxed() const { return relaxed_; }
  /// The rule of the leaf for this twist by rounded numbers and a bound on their errors;
  /// nothing if they do not decide.
  std::optional<bool> certainly_refuted(const IntegerVector3& twist) const;
  /// The two rays that take most part, as (d, h) of norm 1; nothing if there is one only.
  std::optional<std::pair<Double4, Double4>> widest() const;

 private:
  struct Point {
    Double4 x;                  ///< (d, h), torques and rotations by length
    std::vector<double> rises;  ///< N.d by contact and corner
    double scale;               ///< of its wrenches
    std::vector<double> sizes;  ///< at least |v| by acting contact, and without cancellation
    Double3 against{};          ///< -A(d - h d0) over its norm, of list 2
  };
  /// What a point adds to the hull: its wrench, and its forces.
  struct Support {
    std::size_t point;
    Double3 wrench;
    bool against = false;
    std::vector<double> normal;
    std::vector<double> tangential;
  };

  bool is_idle(const Point& point, const std::vector<ContactWork<double>>& works) const;
  double bound(const Point& point, const std::vector<ContactWork<double>>& works,
               const Double3& y, bool& acts) const;
  Support support(std::size_t point, const std::vector<ContactWork<double>>& works,
                  const Double3& y) const;

  const BoxModel& model_;
  const BoxRegion& region_;
  const Direction* direction_;
  std::vector<std::size_t> acting_;
  std::vector<std::size_t> first_;  ///< of the acting contacts in Point::rises
  std::vector<Point> points_;
  std::vector<Support> supports_;
  equilibrium_detail::NearestPoint hull_;
  Double3 twist_{};
  Relaxed relaxed_;
  bool is_moderate_;
};

BoxSearch::Wolfe::Wolfe(const BoxModel& model, const BoxRegion& region,
                        const Direction* direction)
    : model_(model), region_(region), direction_(direction), is_moderate_(model.is_moderate) {
  std::size_t corners = 0;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    if (region.separation(i) == Separation::kOpen) continue;
    acting_.push_back(i);
    first_.push_back(corners);
    corners += model.contacts[i].rounded.normals.size();
  }
  for (const IntegerVector5& exact : region.points()) {
    Point point{shortened(exact), {}, 0, {}};
    for (std::size_t j = 0; j < 4; ++j) {
      constexpr std::size_t kMostBits = 200;
      is_moderate_ = is_moderate_ && (exact[j].is_zero() || msb(abs(exact[j])) < kMostBits);
    }
    Double4& x = point.x;
    x[2] *= model.length;
    const double size = std::sqrt(dot(x, x));
    for (double& entry : x) entry /= size;
    const Double3 d{x[0], x[1], x[2]};
    point.rises.reserve(corners);
    point.scale = std::fabs(x[3]) * model.force;
    for (const std::size_t i : acting_) {
      const ContactNumbers<double>& c = model.contacts[i].rounded;
      double size_of_rise = 0;
      for (std::size_t corner = 0; corner < c.normals.size(); ++corner) {
        const Double3& n = c.normals[corner];
        double rise = dot(n, d);
        // Rounding must not let a force act where there is none.
        constexpr double kDoubtful = 1e-12;
        if (std::fabs(rise) < kDoubtful * norm(n)) {
          const IntegerVector3 motion{exact[0], exact[1], exact[2]};
          if (dot(model.contacts[i].exact.normals[corner], motion).is_zero()) {
            rise = 0;
          } else {
            is_moderate_ = false;  // its sign may be wrong
          }
        }
        point.rises.push_back(rise);
        size_of_rise = std::max(size_of_rise, std::fabs(n[0] * d[0]) + std::fabs(n[1] * d[1]) +
                                                  std::fabs(n[2] * d[2]));
        point.scale +=
            std::max(0.0, x[3] * c.preloads[1] - c.stiffnesses[1] * point.rises.back()) /
            static_cast<double>(c.normals.size());
      }
      point.sizes.push_back(x[3] * c.preloads[1] + c.stiffnesses[1] * size_of_rise);
    }
    if (direction != nullptr) {
      // Exactly, as d - h d0 may be small beside d.
      Vector3 from{};
      for (std::size_t j = 0; j < 3; ++j) {
        from[j] = Rational(exact[j]) - Rational(exact[3]) * coordinates(direction->twist)[j];
      }
      for (std::size_t j = 0; j < 3; ++j) {
        const Rational value = dot(direction->matrix[j], from) / Rational(exact[3]);
        point.against[j] = -to_double(value) / (j == 2 ? model.length : 1);
      }
      const double length = norm(point.against);
      for (double& entry : point.against) entry /= length;
    }
    points_.push_back(std::move(point));
  }
}

/// The work on y at a point; acts: whether any wrench is there that is not 0.
double BoxSearch::Wolfe::bound(const Point& point,
                               const std::vector<ContactWork<double>>& works, const Double3& y,
                               bool& acts) const {
  double sum = 0;
  for (std::size_t j = 0; j < 3; ++j) sum += point.x[3] * y[j] * model_.load[j][y[j] > 0];
  acts = point.x[3] > 0;
  for (std::size_t k = 0; k < works.size(); ++k) {
    const Strongest<double> strongest = works[k].at(point.x[3], &point.rises[first_[k]]);
    if (strongest.friction == 2) continue;
    acts = acts || strongest.bound != 0;
    sum += strongest.bound / static_cast<double>(works[k].pairs().corners);
  }
  return sum;
}

/// Whether h is 0 and so is every bound, by what is exact: zeros, and signs that are clear.
bool BoxSearch::Wolfe::is_idle(const Point& point,
                               const std::vector<ContactWork<double>>& works) const {
  if (point.x[3] != 0) return false;
  for (std::size_t k = 0; k < works.size(); ++k) {
    const bool mixed = region_.separation(acting_[k]) == Separation::kMixed;
    for (std::size_t c = 0; c < works[k].pairs().corners; ++c) {
      const double rise = point.rises[first_[k] + c];
      if (mixed ? rise < 0 && works[k].pushes() : rise != 0) return false;
    }
  }
  return true;
}

std::optional<bool> BoxSearch::Wolfe::certainly_refuted(const IntegerVector3& twist) const {
  if (!is_moderate_) return std::nullopt;
  Double3 y{};
  for (std::size_t j = 0; j < 3; ++j) y[j] = twist[j].convert_to<double>();
  y[2] *= model_.length;
  // Every number is within four roundings of the exact one, up to the factors of the rays; a
  // term has fewer than ten factors and sums, of which a mean over the corners has 64 at most.
  // What underflows is far below kUnderflow.
  constexpr double kUnitRoundoff = 1.2e-16;
  constexpr double kUnderflow = 1e-250;
  const double roundings = kUnitRoundoff * (300 + static_cast<double>(acting_.size()));
  std::vector<ContactWork<double>> works;
  works.reserve(acting_.size());
  std::vector<double> alphas;
  for (const std::size_t i : acting_) {
    const ContactNumbers<double>& c = model_.contacts[i].rounded;
    double alpha = 0;
    for (std::size_t corner = 0; corner < c.normals.size(); ++corner) {
      double size = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        size += std::fabs(y[j]) * (std::fabs(c.normals[corner][j]) +
                                   c.frictions[1] * std::fabs(c.tangents[corner][j]));
      }
      alpha = std::max(alpha, size);
    }
    alphas.push_back(alpha);
    works.emplace_back(c, y, region_.slip(i), region_.separation(i));
    if (!works.back().is_clear(roundings * alpha)) return std::nullopt;
  }
  bool certain = true;
  for (const Point& point : points_) {
    if (direction_ != nullptr) {
      const double against = dot(point.against, y);
      const double size = roundings * norm(y);
      if (against > size) return false;
      if (!(against < -size)) certain = false;
    }
    if (is_idle(point, works)) continue;  // g and h are 0: the ray is barred
    bool acts = false;
    const double work = bound(point, works, y, acts);
    double error = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      error += point.x[3] * std::fabs(y[j]) *
               std::max(std::fabs(model_.load[j][0]), std::fabs(model_.load[j][1]));
    }
    for (std::size_t k = 0; k < works.size(); ++k) error += alphas[k] * point.sizes[k];
    error = roundings * error + kUnderflow;
    if (work > error) return false;
    if (!(work < -error)) certain = false;
  }
  if (certain) return true;
  return std::nullopt;
}

BoxSearch::Wolfe::Support BoxSearch::Wolfe::support(
    std::size_t index, const std::vector<ContactWork<double>>& works, const Double3& y) const {
  const Point& point = points_[index];
  const double h = point.x[3];
  Support result{index,
                 {},
                 false,
                 std::vector<double>(acting_.size()),
                 std::vector<double>(acting_.size())};
  for (std::size_t j = 0; j < 3; ++j) result.wrench[j] = h * model_.load[j][y[j] > 0];
  for (std::size_t k = 0; k < works.size(); ++k) {
    const ContactNumbers<double>& c = model_.contacts[acting_[k]].rounded;
    const double* rises = &point.rises[first_[k]];
    const Strongest<double> s = works[k].at(h, rises);
    if (s.friction == 2 ||
        (region_.separation(acting_[k]) == Separation::kMixed && !(s.bound > 0))) {
      continue;
    }
    const double slope = works[k].slope(s.friction);
    const CornerPairs& pairs = works[k].pairs();
    const auto add = [&](double a, std::size_t corner) {
      result.normal[k] += a;
      result.tangential[k] += slope * a;
      for (std::size_t j = 0; j < 3; ++j) {
        result.wrench[j] += a * (c.normals[corner][j] + slope * c.tangents[corner][j]);
      }
    };
    if (s.product) {
      const double least = *std::min_element(rises, rises + pairs.corners);
      add(h * c.preloads[s.preload] - c.stiffnesses[s.stiffness] * least, s.corner);
      continue;
    }
    for (std::size_t pair = 0; pair < pairs.cell.size(); ++pair) {
      if (pairs.cell[pair] != s.cell) continue;
      const double v =
          h * c.preloads[s.preload] - c.stiffnesses[s.stiffness] * rises[pair % pairs.corners];
      add(v * static_cast<double>(pairs.share[s.cell]) / static_cast<double>(pairs.corners),
          pair / pairs.corners);
    }
  }
  return result;
}

bool BoxSearch::Wolfe::run() {
  Double3& y = twist_;
  for (std::size_t j = 0; j < 3; ++j) y[j] = -(model_.load[j][0] + model_.load[j][1]);
  if (dot(y, y) == 0) y = {1, 0, 0};
  double largest = 0;
  constexpr std::size_t kMostSteps = 60;
  constexpr double kVanishing = 1e-22;  // of squared lengths; a proposal, not a decision
  for (std::size_t step = 0; step < kMostSteps; ++step) {
    std::vector<ContactWork<double>> works;
    works.reserve(acting_.size());
    for (const std::size_t i : acting_) {
      const Sign slip = region_.slip(i);
      works.emplace_back(model_.contacts[i].rounded, y, slip, region_.separation(i));
    }
    double worst = -HUGE_VAL;
    std::size_t worst_point = points_.size();
    bool against = false;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      bool acts = false;
      const double work = bound(points_[p], works, y, acts) / points_[p].scale;
      if (acts && work > worst) {
        worst = work;
        worst_point = p;
        against = false;
      }
    }
    for (std::size_t p = 0; direction_ != nullptr && p < points_.size(); ++p) {
      const double work = dot(points_[p].against, y);
      if (work > worst) {
        worst = work;
        worst_point = p;
        against = true;
      }
    }
    if (worst < 0) return true;
    if (worst_point == points_.size()) break;
    if (against) {
      supports_.push_back({worst_point, points_[worst_point].against, true, {}, {}});
    } else {
      supports_.push_back(support(worst_point, works, y));
      for (double& entry : supports_.back().wrench) entry /= points_[worst_point].scale;
    }
    const Double3& wrench = supports_.back().wrench;
    largest = std::max(largest, dot(wrench, wrench));
    const bool progress = hull_.add(wrench);
    const Double3& nearest = hull_.nearest();
    if (!progress || dot(nearest, nearest) <= kVanishing * largest) break;
    y = {-nearest[0], -nearest[1], -nearest[2]};
  }
  relaxed_.normal.assign(model_.contacts.size(), 0.0);
  relaxed_.tangential.assign(model_.contacts.size(), 0.0);
  for (std::size_t k = 0; k < hull_.size(); ++k) {
    const Support& s = supports_[hull_.order(k)];
    if (s.against) continue;
    const double weight = hull_.weight(k) / points_[s.point].scale;
    for (std::size_t j = 0; j < 4; ++j) relaxed_.motion[j] += weight * points_[s.point].x[j];
    for (std::size_t q = 0; q < acting_.size(); ++q) {
      relaxed_.normal[acting_[q]] += weight * s.normal[q];
      relaxed_.tangential[acting_[q]] += weight * s.tangential[q];
    }
  }
  return false;
}

std::optional<std::pair<Double4, Double4>> BoxSearch::Wolfe::widest() const {
  std::optional<std::pair<Double4, Double4>> result;
  double most = 0;
  for (std::size_t a = 0; a < hull_.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Double4& x = points_[supports_[hull_.order(a)].point].x;
      const Double4& z = points_[supports_[hull_.order(b)].point].x;
      double distance = 0;
      for (std::size_t j = 0; j < 4; ++j) distance += (x[j] - z[j]) * (x[j] - z[j]);
      distance *= std::min(hull_.weight(a), hull_.weight(b));
      if (distance <= most) continue;
      most = distance;
      result = {x, z};
    }
  }
  return result;
}

std::optional<IntegerVector3> BoxSearch::confirm(const BoxRegion& region,
                                                 const Wolfe& found) const {
  const Double3& y = found.twist();
  const Double3 twist{y[0], y[1], y[2] / model_.length};
  IntegerVector3 before{};
  for (const int bits : {3, 6, 10, 16, 24, 36, 50}) {
    const IntegerVector3 candidate = in_bits(twist, bits);
    if (candidate == before || is_zero(candidate)) continue;
    before = candidate;
    const std::optional<bool> certain = found.certainly_refuted(candidate);
    if (certain.value_or(false)) return candidate;
    if (!certain && region.is_refuted(model_, candidate, direction_)) return candidate;
  }
  return std::nullopt;
}

/// The split that the relaxed equilibrium asks for: where a contact breaks its normal law or
/// maximum dissipation with the most energy, and the motion is on one side for all of the box.
std::optional<BoxSearch::Split> BoxSearch::split(const BoxRegion& region,
                                                 const Wolfe& found) const {
  const Relaxed& relaxed = found.relaxed();
  const Double4& x = relaxed.motion;
  const Double3 d{x[0], x[1], x[2]};
  double energy = 0;
  double separation_gap = 0;
  double slip_gap = 0;
  std::size_t separation = model_.contacts.size();
  std::size_t slip = model_.contacts.size();
  const auto value = [&](const IntegerVector5& plane) {
    Double4 p = shortened(plane);
    p[2] /= model_.length;
    return dot(p, x) / std::sqrt(dot(p, p));  // 0 where nothing moves
  };
  const double least_clear = 1e-12 * std::sqrt(dot(x, x));
  const auto sign_of_all = [&](const std::vector<IntegerVector5>& planes) {
    bool plus = true;
    bool minus = true;
    for (const IntegerVector5& plane : planes) {
      const double at = value(plane);
      plus = plus && at > least_clear;
      minus = minus && at < -least_clear;
    }
    return plus ? 1 : minus ? -1 : 0;
  };
  const bool stands_still = !(dot(x, x) > 0);
  const auto is_clear = [&](const std::vector<IntegerVector5>& planes) {
    return planes.size() == 1 || stands_still || sign_of_all(planes) != 0;
  };
  for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
    const BoxContact& contact = model_.contacts[i];
    const ContactNumbers<double>& c = contact.rounded;
    const double a = relaxed.normal[i];
    const double stiffness = (c.stiffnesses[0] + c.stiffnesses[1]) / 2;
    energy += a * a / stiffness;
    if (region.separation(i) == Separation::kMixed) {
      double lawful = x[3] * (c.preloads[0] + c.preloads[1]) / 2;
      for (const Double3& n : c.normals) {
        lawful -= stiffness * dot(n, d) / static_cast<double>(c.normals.size());
      }
      lawful = std::max(0.0, lawful);
      const double gap = std::fabs(a - lawful) * std::max(a, lawful) / stiffness;
      if (gap > separation_gap && is_clear(contact.separations)) {
        separation_gap = gap;
        separation = i;
      }
    }
    if (region.slip(i) == Sign::kZero && c.frictions[1] > 0) {
      double tau = 0;
      for (const Double3& t : c.tangents)
        tau += dot(t, d) / static_cast<double>(c.normals.size());
      const double gap = a * c.frictions[0] * std::fabs(tau) + relaxed.tangential[i] * tau;
      if (gap > slip_gap && is_clear(contact.slips)) {
        const bool cuts = contact.slips.size() > 1 || [&] {
          const BoxRegion::Signs signs = region.signs(contact.slips.front());
          return signs.positive || signs.negative;
        }();
        if (cuts) {
          slip_gap = gap;
          slip = i;
        }
      }
    }
  }
  constexpr double kNoticeable = 1e-9;  // of the energy; only chooses between splits
  // Where the rotation has one sign, few corners matter: the others are never the extreme.
  const auto split_of_rotation = [&]() -> std::optional<Split> {
    const IntegerVector5 rotation{0, 0, 1, 0, 0};
    const BoxRegion::Signs signs = region.signs(rotation);
    if (!signs.positive || !signs.negative) return std::nullopt;
    return Split{PlaneSplit{rotation}, rotation};
  };
  // The corner plane nearest to the motion, of those that serve the split to this side.
  const auto nearest_of = [&](const std::vector<IntegerVector5>& planes, int side,
                              const auto& serves) {
    const IntegerVector5* nearest = nullptr;
    double least = HUGE_VAL;
    for (const IntegerVector5& plane : planes) {
      if (!serves(region.signs(plane)) || side * value(plane) >= least) continue;
      least = side * value(plane);
      nearest = &plane;
    }
    return nearest;
  };
  if (separation_gap > kNoticeable * energy) {
    const std::vector<IntegerVector5>& planes = model_.contacts[separation].separations;
    if (planes.size() == 1) {
      return Split{SeparationSplit{ContactId(separation)}, planes.front()};
    }
    if (const auto rotation = split_of_rotation()) return rotation;
    const int side = stands_still ? 1 : sign_of_all(planes);
    const IntegerVector5* nearest = nearest_of(
        planes, side, [](const auto& signs) { return signs.negative && signs.positive; });
    if (nearest != nullptr) return Split{PlaneSplit{*nearest}, *nearest};
  }
  if (slip_gap > kNoticeable * energy) {
    const std::vector<IntegerVector5>& planes = model_.contacts[slip].slips;
    if (planes.size() == 1) return Split{SlipSplit{ContactId(slip)}, planes.front(), true};
    if (const auto rotation = split_of_rotation()) return rotation;
    const int side = stands_still ? 1 : sign_of_all(planes);
    const IntegerVector5* nearest = nearest_of(planes, side, [side](const auto& signs) {
      const bool here = side > 0 ? signs.positive : signs.negative;
      const bool beyond = side > 0 ? signs.negative : signs.positive;
      return here && (beyond || !signs.zeros_barred);
    });
    if (nearest != nullptr) {
      // The strict side is that of the second child.
      const IntegerVector5 plane = side > 0 ? negated(*nearest) : *nearest;
      return Split{PlaneSplit{plane}, plane};
    }
  }
  const auto widest = found.widest();
  if (!widest) return std::nullopt;
  Double4 across{};
  double distance = 0;
  const double size = dot(x, x);
  for (std::size_t j = 0; j < 4; ++j) {
    across[j] = widest->first[j] - widest->second[j];
    distance += across[j] * across[j];
  }
  constexpr double kClose = 1e-8;  // squared
  if (!(size > 0) || distance < kClose) return std::nullopt;
  const double along = dot(across, x) / size;
  for (std::size_t j = 0; j < 4; ++j) across[j] -= along * x[j];
  across[2] *= model_.length;
  const IntegerVector<4> plane4 = in_bits(across, 12);
  const IntegerVector5 plane{plane4[0], plane4[1], plane4[2], plane4[3], 0};
  const BoxRegion::Signs signs = region.signs(plane);
  if (!signs.positive || !signs.negative) return std::nullopt;
  return Split{PlaneSplit{plane}, plane};
}

bool BoxSearch::visit(const BoxRegion& region, BoxTrees& trees, std::size_t depth) {
  throw_if_cancelled();
  // Below the depth that the format allows, by more than the parts of a box above this tree.
  const std::size_t deepest = 2 * model_.contacts.size() + 200;
  if (nodes_left_ == 0 || depth > deepest) return false;
  --nodes_left_;
  ++nodes_;
  if (region.is_barred()) {
    trees.push_back(VirtualWorkLeaf{});
    return true;
  }
  Wolfe wolfe(model_, region, direction_);
  if (wolfe.run()) {
    if (const auto y = confirm(region, wolfe)) {
      trees.push_back(VirtualWorkLeaf{*y});
      return true;
    }
    return false;
  }
  const auto chosen = split(region, wolfe);
  if (!chosen) return false;
  trees.push_back(chosen->node);
  const auto go = [&](Side side, bool strict) {
    return visit(region.child(model_, chosen->plane, side, strict), trees, depth + 1);
  };
  if (chosen->three) {
    return go(Side::kPositive, true) && go(Side::kZero, false) && go(Side::kNegative, true);
  }
  return go(Side::kPositive, false) && go(Side::kNegative, true);
}

bool BoxSearch::refute(const BoxRegion& region, BoxTrees& trees) {
  return visit(region, trees, 0);
}

}  // namespace stickslip::box_detail
