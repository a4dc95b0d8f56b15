// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_search.hpp"

#include <cmath>
#include <utility>

#include "stickslip/equilibrium/search/nearest_wrench.hpp"

namespace stickslip::box_detail {

using namespace equilibrium_detail;

namespace {

double norm(const Double3& a) {
  return std::sqrt(dot(a, a));
}

/// A wrench that a region allows at one of its points, and its forces by acting contact; or the
/// direction that list 2 excludes there.
struct BoxSupport {
  std::size_t point = 0;
  bool against = false;
  double work = 0;
  Double3 wrench{};
  std::vector<double> normal{};
  std::vector<double> tangential{};
};

using Found = NearestWrench<3, BoxSupport>;

/// In rounded numbers: its motion, and forces by contact.
struct BoxRelaxation {
  ScaledPoint<3> motion{};
  std::vector<double> normal;
  std::vector<double> tangential;
};

}  // namespace

/// The wrenches that a region allows, in doubles.
class BoxSearch::Wrenches {
 public:
  Wrenches(const BoxModel& model, const BoxRegion& region, const Direction<3>* direction);

  /// The one with the most work on y.
  std::optional<BoxSupport> worst(const Double3& y) const;
  /// Of wrenches that add up to 0.
  BoxRelaxation combine(const Found& found) const;
  /// The rule of the leaf for this twist by rounded numbers and a bound on their errors;
  /// nothing if they do not decide.
  std::optional<bool> certainly_refuted(const IntegerVector3& twist) const;
  /// A plane between the two points that take most part, and across the motion; 0 for none.
  IntegerVector5 plane_between_widest(const Found& found, const ScaledPoint<3>& motion) const;

 private:
  struct Point {
    ScaledPoint<3> x;           ///< torques and rotations by length
    std::vector<double> rises;  ///< N.d by contact and corner
    double scale;               ///< of its wrenches
    std::vector<double> sizes;  ///< at least |v| by acting contact, and without cancellation
    Double3 against{};          ///< -A(d - h d0) over its norm, of list 2
  };

  std::vector<ContactWork<double>> works_on(const Double3& y) const;
  bool is_idle(const Point& point, const std::vector<ContactWork<double>>& works) const;
  double bound(const Point& point, const std::vector<ContactWork<double>>& works,
               const Double3& y, bool& acts) const;
  BoxSupport support(std::size_t point, const std::vector<ContactWork<double>>& works,
                     const Double3& y) const;

  const BoxModel& model_;
  const BoxRegion& region_;
  const Direction<3>* direction_;
  std::vector<std::size_t> acting_;
  std::vector<std::size_t> first_;  ///< of the acting contacts in Point::rises
  std::vector<Point> points_;
  bool is_moderate_;
};

BoxSearch::Wrenches::Wrenches(const BoxModel& model, const BoxRegion& region,
                              const Direction<3>* direction)
    : model_(model), region_(region), direction_(direction), is_moderate_(model.is_moderate) {
  std::size_t corners = 0;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    if (region.separation(i) == Separation::kOpen) continue;
    acting_.push_back(i);
    first_.push_back(corners);
    corners += model.contacts[i].rounded.normals.size();
  }
  for (const IntegerVector5& exact : region.points()) {
    Point point{scaled_point<3>(exact, model.length), {}, 0, {}};
    for (const Integer& entry : exact) {
      constexpr std::size_t kMostBits = 200;
      is_moderate_ = is_moderate_ && (entry.is_zero() || msb(abs(entry)) < kMostBits);
    }
    const ScaledPoint<3>& x = point.x;
    const Double3 d = motion_of<3>(x);
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
    if (direction != nullptr) point.against = direction->against(exact, model.length);
    points_.push_back(std::move(point));
  }
}

std::vector<ContactWork<double>> BoxSearch::Wrenches::works_on(const Double3& y) const {
  std::vector<ContactWork<double>> works;
  works.reserve(acting_.size());
  for (const std::size_t i : acting_) {
    works.emplace_back(model_.contacts[i].rounded, y, region_.slip(i), region_.separation(i));
  }
  return works;
}

/// The work on y at a point; acts: whether any wrench is there that is not 0.
double BoxSearch::Wrenches::bound(const Point& point,
                                  const std::vector<ContactWork<double>>& works,
                                  const Double3& y, bool& acts) const {
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
bool BoxSearch::Wrenches::is_idle(const Point& point,
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

std::optional<bool> BoxSearch::Wrenches::certainly_refuted(const IntegerVector3& twist) const {
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
  const std::vector<ContactWork<double>> works = works_on(y);
  std::vector<double> alphas;
  for (std::size_t k = 0; k < acting_.size(); ++k) {
    const ContactNumbers<double>& c = model_.contacts[acting_[k]].rounded;
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
    if (!works[k].is_clear(roundings * alpha)) return std::nullopt;
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

BoxSupport BoxSearch::Wrenches::support(std::size_t index,
                                        const std::vector<ContactWork<double>>& works,
                                        const Double3& y) const {
  const Point& point = points_[index];
  const double h = point.x[3];
  BoxSupport result;
  result.point = index;
  result.normal.resize(acting_.size());
  result.tangential.resize(acting_.size());
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

std::optional<BoxSupport> BoxSearch::Wrenches::worst(const Double3& y) const {
  const std::vector<ContactWork<double>> works = works_on(y);
  BoxSupport best;
  best.work = -HUGE_VAL;
  best.point = points_.size();
  for (std::size_t p = 0; p < points_.size(); ++p) {
    bool acts = false;
    const double work = bound(points_[p], works, y, acts) / points_[p].scale;
    if (!acts || !(work > best.work)) continue;
    best.work = work;
    best.point = p;
  }
  for (std::size_t p = 0; direction_ != nullptr && p < points_.size(); ++p) {
    const double work = dot(points_[p].against, y);
    if (!(work > best.work)) continue;
    best = {p, true, work, points_[p].against};
  }
  if (best.against) return best;
  // Where nothing acts all zeros are barred.
  if (best.point == points_.size()) return std::nullopt;
  BoxSupport result = support(best.point, works, y);
  result.work = best.work;
  for (double& entry : result.wrench) entry /= points_[best.point].scale;
  return result;
}

BoxRelaxation BoxSearch::Wrenches::combine(const Found& found) const {
  BoxRelaxation relaxed;
  relaxed.normal.assign(model_.contacts.size(), 0.0);
  relaxed.tangential.assign(model_.contacts.size(), 0.0);
  for (const auto& [part, s] : found.parts) {
    if (s.against) continue;
    const double weight = part / points_[s.point].scale;
    for (std::size_t j = 0; j < 5; ++j) relaxed.motion[j] += weight * points_[s.point].x[j];
    for (std::size_t q = 0; q < acting_.size(); ++q) {
      relaxed.normal[acting_[q]] += weight * s.normal[q];
      relaxed.tangential[acting_[q]] += weight * s.tangential[q];
    }
  }
  return relaxed;
}

IntegerVector5 BoxSearch::Wrenches::plane_between_widest(const Found& found,
                                                         const ScaledPoint<3>& motion) const {
  IntegerVector5 result{};
  double most = 0;
  for (std::size_t a = 0; a < found.parts.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const ScaledPoint<3>& x = points_[found.parts[a].second.point].x;
      const ScaledPoint<3>& z = points_[found.parts[b].second.point].x;
      double distance = 0;
      for (std::size_t j = 0; j < 5; ++j) distance += (x[j] - z[j]) * (x[j] - z[j]);
      distance *= std::min(found.parts[a].first, found.parts[b].first);
      if (distance <= most) continue;
      most = distance;
      result = plane_between<3>(x, z, motion, model_.length);
    }
  }
  return result;
}

std::optional<IntegerVector3> BoxSearch::confirm(const BoxRegion& region,
                                                 const Wrenches& wrenches,
                                                 const Double3& twist) {
  return in_fewest_bits<3>({twist[0], twist[1], twist[2] / model_.length},
                           {3, 6, 10, 16, 24, 36, 50}, [&](const IntegerVector3& y) {
                             const auto certain = wrenches.certainly_refuted(y);
                             if (!certain) ++exact_leaves_;
                             return certain ? *certain
                                            : region.is_refuted(model_, y, direction_);
                           });
}

namespace {

/// Whether cuts by the planes would make rays of so many bits that all that is exact is slow.
bool are_long(const std::vector<IntegerVector5>& planes) {
  constexpr std::size_t kLongBits = 64;
  for (const IntegerVector5& plane : planes) {
    for (const Integer& entry : plane) {
      if (!entry.is_zero() && msb(abs(entry)) >= kLongBits) return true;
    }
  }
  return false;
}

/// In few bits, a little nearer to the motion than all of these planes, on this side of which
/// it is, so that they have one sign beyond it; 0 if that is no plane of the region. Only where
/// the region is narrow: what rounding takes away at its points can then be given back.
IntegerVector5 short_plane(const BoxRegion& region, const std::vector<IntegerVector5>& planes,
                           const ScaledPoint<3>& motion, int side, double length) {
  using Scaled = std::array<double, 4>;  // d and h; of planes up to a factor
  // Units of length and of motion, powers of two.
  const int arm = std::ilogb(length);
  double reach = 0;
  std::vector<Scaled> points;
  for (const IntegerVector5& point : region.points()) {
    const std::array<double, 5> x = in_doubles(point);
    points.push_back({x[0], x[1], std::ldexp(x[2], arm), x[3]});
    const double size = std::hypot(x[0], x[1], points.back()[2]);
    if (x[3] > 0) reach = std::max(reach, size / x[3]);
  }
  constexpr int kMostUnits = 200;
  const int travel = reach > 0 && std::isfinite(reach) ? std::ilogb(reach) : 0;
  if (std::abs(travel) > kMostUnits || std::abs(arm) > kMostUnits) return {};
  const auto over_norm = [](Scaled x) {
    const double size = std::sqrt(dot(x, x));
    for (double& entry : x) entry /= size;
    return x;
  };
  // A function that is above 0 on the region, if it is narrow.
  Scaled inwards{};
  for (Scaled& x : points) {
    for (std::size_t j = 0; j < 3; ++j) x[j] = std::ldexp(x[j], -travel);
    x = over_norm(x);
    for (std::size_t j = 0; j < 4; ++j) inwards[j] += x[j];
  }
  inwards = over_norm(inwards);
  double least = 1;
  for (const Scaled& x : points) least = std::min(least, dot(inwards, x));
  constexpr double kNarrow = 0.05;
  if (!(least > kNarrow)) return {};
  std::vector<Scaled> functions;
  for (const IntegerVector5& plane : planes) {
    const std::array<double, 5> p = in_doubles(plane);
    functions.push_back(over_norm({std::ldexp(p[0], travel), std::ldexp(p[1], travel),
                                   std::ldexp(p[2], travel - arm), p[3]}));
  }
  const Scaled at{motion[0], motion[1], motion[2] / length * std::ldexp(1.0, arm),
                  std::ldexp(motion[3], travel)};
  Scaled nearest = *std::min_element(
      functions.begin(), functions.end(),
      [&](const Scaled& a, const Scaled& b) { return side * dot(a, at) < side * dot(b, at); });
  constexpr int kBits = 20;
  double error = std::ldexp(4.0, -kBits);
  for (const Scaled& x : points) {
    for (const Scaled& f : functions) {
      error = std::max(error, std::ldexp(4.0, -kBits) + std::fabs(dot(f, x) - dot(nearest, x)));
    }
  }
  for (std::size_t j = 0; j < 4; ++j) nearest[j] -= side * error / least * inwards[j];
  // Back to the units of the file.
  const std::array<int, 4> units{0, 0, arm, travel};
  const int lowest = std::min({0, arm, travel});
  IntegerVector5 result{};
  for (std::size_t j = 0; j < 4; ++j) {
    const double entry = std::ldexp(nearest[j], kBits);
    if (!std::isfinite(entry)) return {};
    result[j] = Integer(std::llround(entry)) << static_cast<unsigned>(units[j] - lowest);
  }
  result = primitive(std::move(result));
  return region.signs(result).cuts() ? result : IntegerVector5{};
}

/// A node whose children have a plane of one sign or another.
struct Split {
  BoxNode node;
  IntegerVector5 plane;
  bool three = false;  ///< slip: strict, on, strict; else kept, strict
};

/// The split that the relaxed equilibrium asks for: where a contact breaks its normal law or
/// maximum dissipation with the most energy, and the motion is on one side for all of the box.
std::optional<Split> broken_law(const BoxModel& model, const BoxRegion& region,
                                const BoxRelaxation& relaxed) {
  const ScaledPoint<3>& x = relaxed.motion;
  const Double3 d = motion_of<3>(x);
  double energy = 0;
  double separation_gap = 0;
  double slip_gap = 0;
  std::size_t separation = model.contacts.size();
  std::size_t slip = model.contacts.size();
  const auto value = [&](const IntegerVector5& plane) {
    return value_at<3>(plane, x, model.length);
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
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const BoxContact& contact = model.contacts[i];
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
        const auto is_still = [&] {
          const PlaneSigns signs = region.signs(contact.slips.front());
          return !signs.positive && !signs.negative;
        };
        if (contact.slips.size() > 1 || !is_still()) {
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
    if (!region.signs(rotation).cuts()) return std::nullopt;
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
  // The second child is on the side of the motion, and strict.
  const auto short_split =
      [&](const std::vector<IntegerVector5>& planes) -> std::optional<Split> {
    if (!are_long(planes) || stands_still) return std::nullopt;
    const int side = sign_of_all(planes);
    if (side == 0) return std::nullopt;
    const IntegerVector5 plane = short_plane(region, planes, x, side, model.length);
    if (is_zero(plane)) return std::nullopt;
    const IntegerVector5 towards = side > 0 ? negated(plane) : plane;
    return Split{PlaneSplit{towards}, towards};
  };
  if (separation_gap > kNoticeable * energy) {
    const std::vector<IntegerVector5>& planes = model.contacts[separation].separations;
    if (auto split = short_split(planes)) return split;
    if (planes.size() == 1) {
      return Split{SeparationSplit{ContactId(separation)}, planes.front()};
    }
    if (const auto rotation = split_of_rotation()) return rotation;
    const int side = stands_still ? 1 : sign_of_all(planes);
    const IntegerVector5* nearest =
        nearest_of(planes, side, [](const PlaneSigns& signs) { return signs.cuts(); });
    if (nearest != nullptr) return Split{PlaneSplit{*nearest}, *nearest};
  }
  if (slip_gap > kNoticeable * energy) {
    const std::vector<IntegerVector5>& planes = model.contacts[slip].slips;
    if (auto split = short_split(planes)) return split;
    if (planes.size() == 1) return Split{SlipSplit{ContactId(slip)}, planes.front(), true};
    if (const auto rotation = split_of_rotation()) return rotation;
    const int side = stands_still ? 1 : sign_of_all(planes);
    const IntegerVector5* nearest = nearest_of(planes, side, [side](const PlaneSigns& signs) {
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
  return std::nullopt;
}

}  // namespace

std::optional<BoxSearch::BoxBranch> BoxSearch::examine(const BoxRegion& region,
                                                       std::size_t depth) {
  // Below the depth that the format allows, by more than the parts of a box above this tree.
  const std::size_t deepest = 2 * model_.contacts.size() + 200;
  if (nodes_left_ == 0 || depth > deepest) {
    end_ = nodes_left_ == 0 ? SearchEnd::kNodes : SearchEnd::kDepth;
    return std::nullopt;
  }
  --nodes_left_;
  ++nodes_;
  if (region.is_barred()) return BoxBranch{VirtualWorkLeaf{}, {}};
  const Wrenches wrenches(model_, region, direction_);
  Double3 start{};
  for (std::size_t j = 0; j < 3; ++j) start[j] = -(model_.load[j][0] + model_.load[j][1]);
  const Found found =
      nearest_wrench<3>(start, [&](const Double3& y) { return wrenches.worst(y); });
  if (found.separated) {
    const auto y = confirm(region, wrenches, found.twist);
    if (!y) {
      end_ = SearchEnd::kTwist;
      return std::nullopt;
    }
    return BoxBranch{VirtualWorkLeaf{*y}, {}};
  }
  const BoxRelaxation relaxed = wrenches.combine(found);
  auto split = broken_law(model_, region, relaxed);
  if (!split) {
    const IntegerVector5 plane = wrenches.plane_between_widest(found, relaxed.motion);
    if (!region.signs(plane).cuts()) {
      end_ = SearchEnd::kPlane;
      return std::nullopt;
    }
    split = Split{PlaneSplit{plane}, plane};
  }
  BoxBranch branch{split->node, {}};
  branch.children.push_back(region.child(model_, split->plane, Side::kPositive, split->three));
  if (split->three) {
    branch.children.push_back(region.child(model_, split->plane, Side::kZero, false));
  }
  branch.children.push_back(region.child(model_, split->plane, Side::kNegative, true));
  return branch;
}

bool BoxSearch::refute(const BoxRegion& region, BoxTrees& trees) {
  end_ = SearchEnd::kNone;
  return append_tree(region, trees, [&](const BoxRegion& at, std::size_t depth) {
    return examine(at, depth);
  });
}

}  // namespace stickslip::box_detail
