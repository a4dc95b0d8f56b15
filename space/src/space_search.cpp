// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/equilibrium/search/nearest_wrench.hpp"

namespace stickslip::space_detail {

using namespace equilibrium_detail;

namespace {

template <std::size_t n>
double norm_of(const std::array<double, n>& a) {
  return std::sqrt(dot(a, a));
}

/// What a contact can do on a virtual twist, per unit of normal coefficient.
struct Action {
  double alpha = 0;    ///< the most work
  Double3 friction{};  ///< f that does it
  std::size_t corner = 0;
};

/// All contacts of a region on y.
class Actions {
 public:
  Actions(const SpaceModel& model, const SpaceRegion& region, const Double6& y)
      : region_(region) {
    for (std::size_t i = 0; i < model.contacts.size(); ++i) {
      all_.push_back(region.separation(i) == Separation::kOpen ? Action{}
                                                               : action(model, i, y));
    }
  }

  const Action& operator[](std::size_t contact) const { return all_[contact]; }
  /// Its normal coefficient at a generator where the force does the most work.
  double normal(std::size_t contact, std::size_t generator) const {
    if (region_.separation(contact) == Separation::kOpen) return 0;
    const double alpha = all_[contact].alpha;
    if (region_.separation(contact) == Separation::kMixed) {
      return alpha > 0 ? std::max(0.0, region_.most_separation(contact, generator)) : 0;
    }
    return alpha > 0 ? region_.most_separation(contact, generator)
                     : region_.least_separation(contact, generator);
  }

 private:
  Action action(const SpaceModel& model, std::size_t i, const Double6& y) const {
    const SpaceContact& c = model.contacts[i];
    const SlipCone& cone = region_.slips(i);
    Action best{-HUGE_VAL, {}, 0};
    for (std::size_t k = 0; k < c.corners.size(); ++k) {
      const CornerRow& row = c.corners[k];
      const double normal = dot(row.normal_rounded, y);
      Double3 slid{};
      for (std::size_t j = 0; j < 3; ++j) slid[j] = dot(row.slip_rounded[j], y);
      double most = norm_of(slid);
      Double3 along = slid;
      for (double& entry : along) entry = most > 0 ? entry / most : 0;
      if (cone.moves && !cone.whole && most > 0 && !cone.sides.empty() &&
          !is_against(model, i, slid)) {
        most = -HUGE_VAL;
        for (const auto& [g, corner] : cone.sides) {
          const Double3& s = region_.slip(model, i, g, corner);
          const double length = norm_of(s);
          const double work = -dot(s, slid) / length;
          if (!(work > most)) continue;
          most = work;
          for (std::size_t j = 0; j < 3; ++j) along[j] = -s[j] / length;
        }
      }
      const double slope = most > 0 ? c.slopes[1] : c.slopes[0];
      const double alpha = normal + slope * most;
      if (!(alpha > best.alpha)) continue;
      best = {alpha, along, k};
      for (double& entry : best.friction) entry *= slope;
    }
    return best;
  }

  /// Whether -slid lies in the cone of slips, by the angles of its sides.
  bool is_against(const SpaceModel& model, std::size_t i, const Double3& slid) const {
    const auto angle = [&](const Double3& s) {
      return std::atan2(dot(s, model.contacts[i].tangents[1]),
                        dot(s, model.contacts[i].tangents[0]));
    };
    constexpr double kPi = 3.14159265358979323846;
    const double at = angle(slid) + kPi;
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
    for (const auto& [g, corner] : region_.slips(i).sides) {
      const double off = std::remainder(angle(region_.slip(model, i, g, corner)) - at, 2 * kPi);
      least = std::min(least, off);
      most = std::max(most, off);
    }
    return least <= 0 && most >= 0 && most - least < kPi + 1e-7;
  }

  const SpaceRegion& region_;
  std::vector<Action> all_;
};

/// Over the corners.
Double3 mean_slip(const SpaceContact& contact, const Double6& motion) {
  Double3 s{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const CornerRow& row : contact.corners) {
      s[k] += dot(row.slip_rounded[k], motion) / static_cast<double>(contact.corners.size());
    }
  }
  return s;
}

template <std::size_t n>
void note_bits(std::size_t& most, const IntegerVector<n>& x) {
  for (const Integer& entry : x) {
    if (!entry.is_zero()) most = std::max<std::size_t>(most, msb(abs(entry)) + 1);
  }
}

/// A wrench that a region allows at one of its generators, and its forces by contact; or the
/// direction that list 2 excludes there.
struct SpaceSupport {
  double work = -HUGE_VAL;
  Double6 wrench{};
  std::size_t generator = 0;
  bool against = false;
  std::vector<double> normal{};
  std::vector<Double3> friction{};
};

/// The wrenches that a region allows, in doubles.
class Wrenches {
 public:
  Wrenches(const SpaceModel& model, const SpaceRegion& region, const Direction<6>* direction)
      : model_(model), region_(region) {
    // Comparable sizes of the wrenches at the generators, and where there are any.
    for (std::size_t g = 0; g < region.generators().size(); ++g) {
      const ScaledPoint<6>& x = region.generators()[g];
      double scale = x[6] * model.force + std::fabs(x[7]) * norm_of(model.growing);
      for (std::size_t i = 0; i < model.contacts.size(); ++i) {
        if (region.separation(i) == Separation::kOpen) continue;
        const Double6& normal = model.contacts[i].corners[0].normal_rounded;
        scale += std::max(0.0, region.most_separation(i, g)) * std::sqrt(dot(normal, normal));
      }
      scales_.push_back(scale);
      if (direction != nullptr) {
        against_.push_back(direction->against(region.points()[g], model.length));
      }
    }
  }

  /// The one with the most work on y.
  std::optional<SpaceSupport> worst(const Double6& y) const {
    const Actions actions(model_, region_, y);
    SpaceSupport best;
    for (std::size_t g = 0; g < scales_.size(); ++g) {
      if (!(scales_[g] > 0)) continue;
      const Double6 load = load_at(g, y);
      double work = dot(load, y);
      bool acts = dot(load, load) > 0;
      for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
        const double a = actions.normal(i, g);
        work += a * actions[i].alpha;
        acts = acts || a != 0;
      }
      work /= scales_[g];
      // Without any wrench an equilibrium is here, unless none may be.
      if (work > best.work && (acts || !region_.bars_point(model_, g))) best = {work, {}, g};
    }
    for (std::size_t g = 0; g < against_.size(); ++g) {
      if (dot(against_[g], against_[g]) == 0) continue;  // a free motion
      const double work = dot(against_[g], y);
      if (work > best.work) best = {work, against_[g], g, true};
    }
    if (best.work == -HUGE_VAL) return std::nullopt;  // nothing acts
    if (!best.against) add_forces(best, actions, y);
    return best;
  }

  SpaceRelaxation combine(const NearestWrench<6, SpaceSupport>& found) const {
    const std::size_t m = model_.contacts.size();
    SpaceRelaxation result{{}, std::vector<double>(m), std::vector<Double3>(m), {}};
    std::vector<std::pair<double, std::size_t>> order;
    for (const auto& [part, s] : found.parts) {
      order.emplace_back(-part, s.generator);
      if (s.against) continue;
      const double weight = part / scales_[s.generator];
      for (std::size_t j = 0; j < result.motion.size(); ++j) {
        result.motion[j] += weight * region_.generators()[s.generator][j];
      }
      for (std::size_t i = 0; i < m; ++i) {
        result.normal[i] += weight * s.normal[i];
        for (std::size_t j = 0; j < 3; ++j) result.friction[i][j] += weight * s.friction[i][j];
      }
    }
    std::sort(order.begin(), order.end());
    for (const auto& [weight, generator] : order) {
      if (std::find(result.points.begin(), result.points.end(), generator) ==
          result.points.end()) {
        result.points.push_back(generator);
      }
    }
    return result;
  }

 private:
  double height(std::size_t generator) const { return region_.generators()[generator][6]; }
  Double6 load_at(std::size_t generator, const Double6& y) const {
    const ScaledPoint<6>& x = region_.generators()[generator];
    return model_.load_at(x[6], x[7], y);
  }

  void add_forces(SpaceSupport& support, const Actions& actions, const Double6& y) const {
    const std::size_t m = model_.contacts.size();
    const std::size_t g = support.generator;
    support.normal.resize(m);
    support.friction.resize(m);
    support.wrench = load_at(g, y);
    for (std::size_t i = 0; i < m; ++i) {
      const double a = actions.normal(i, g);
      if (a == 0) continue;
      const CornerRow& row = model_.contacts[i].corners[actions[i].corner];
      support.normal[i] = a;
      for (std::size_t k = 0; k < 3; ++k) support.friction[i][k] = a * actions[i].friction[k];
      for (std::size_t j = 0; j < 6; ++j) {
        support.wrench[j] += a * row.normal_rounded[j];
        for (std::size_t k = 0; k < 3; ++k) {
          support.wrench[j] += support.friction[i][k] * row.slip_rounded[k][j];
        }
      }
    }
    for (double& entry : support.wrench) entry /= scales_[g];
  }

  const SpaceModel& model_;
  const SpaceRegion& region_;
  std::vector<double> scales_;
  std::vector<Double6> against_;
};

/// How far a force in this direction at the contact may turn the object, beside one at the
/// middle of its position: p.(f x omega) changes by at most the sum of far_k |omega_k|.
Vector3 farthest_arm(const SpaceContact& c, const Vector3& f) {
  Vector3 radius;
  for (std::size_t j = 0; j < 3; ++j) radius[j] = (c.position[j].high - c.position[j].low) / 2;
  Vector3 far{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    far[k] = radius[a] * abs(f[b]) + radius[b] * abs(f[a]);
  }
  return far;
}

}  // namespace

/// The twist in the fewest bits that still refute the region.
std::optional<IntegerVector<6>> SpaceSearch::confirm(const SpaceRegion& region,
                                                     const Double6& twist) {
  Double6 y = twist;
  for (std::size_t j = 3; j < 6; ++j) y[j] /= model_.length;
  // Most candidates fail clearly.
  const auto is_hopeless = [&](const IntegerVector<6>& candidate) {
    Double6 scaled = in_doubles(candidate);
    double size = 0;
    for (std::size_t j = 0; j < 6; ++j) {
      if (j >= 3) scaled[j] *= model_.length;
      size += std::fabs(scaled[j]);
    }
    const Actions actions(model_, region, scaled);
    for (std::size_t g = 0; g < region.generators().size(); ++g) {
      const ScaledPoint<6>& x = region.generators()[g];
      double work = dot(model_.load_at(x[6], x[7], scaled), scaled);
      double magnitude =
          (x[6] * model_.force + std::fabs(x[7]) * norm_of(model_.growing)) * size;
      for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
        const double part = actions.normal(i, g) * actions[i].alpha;
        work += part;
        magnitude += std::fabs(part);
      }
      constexpr double kClear = 1e-9;
      if (work > kClear * magnitude) return true;
    }
    return false;
  };
  const auto found = in_fewest_bits<6>(
      y, {2, 4, 6, 8, 12, 16, 24, 36, 50}, [&](const IntegerVector<6>& candidate) {
        if (is_hopeless(candidate)) {
          ++work_.filter_hits;
          return false;
        }
        ++work_.exact_checks;
        return region.is_refuted(model_, candidate, direction_);
      });
  if (found) note_bits(work_.twist_bits, *found);
  return found;
}

/// A plane beside the wedge, towards the motion: all that lies beyond it, strictly, has one
/// sign. Rotations have one sign first, so that such a plane is one. Nothing in the wedge.
std::optional<SpaceSearch::SpaceBranch> SpaceSearch::split_wedge(const SpaceRegion& region,
                                                                 const SpaceRelaxation& found,
                                                                 const Wedge& wedge) const {
  Double6 motion = motion_of<6>(found.motion);
  for (std::size_t j = 3; j < 6; ++j) motion[j] /= model_.length;
  double value = 0;
  double width = 0;
  for (std::size_t j = 0; j < 6; ++j) value += to_double(wedge.middle[j]) * motion[j];
  for (std::size_t k = 0; k < 3; ++k)
    width += to_double(wedge.far[k]) * std::fabs(motion[k + 3]);
  const double height = found.motion[6];
  const int side = value + to_double(wedge.low) * height - width > 0    ? 1
                   : value + to_double(wedge.high) * height + width < 0 ? -1
                                                                        : 0;
  if (side == 0) return std::nullopt;
  std::array<Rational, 8> towards{};
  for (std::size_t j = 0; j < 6; ++j) towards[j] = side * wedge.middle[j];
  towards[6] = side > 0 ? wedge.low : Rational(-wedge.high);
  for (std::size_t k = 0; k < 3; ++k) {
    if (wedge.far[k].is_zero()) continue;
    Point rotation{};
    rotation[k + 3] = 1;
    const PlaneSigns signs = region.signs(rotation);
    if (signs.cuts()) {
      return SpaceBranch{PlaneSplitIn<6>{rotation}, region.halves(model_, rotation)};
    }
    towards[k + 3] -= (signs.negative ? -1 : 1) * wedge.far[k];
  }
  const Point plane = negated(primitive_multiple(towards));
  if (!region.signs(plane).negative) return std::nullopt;
  return SpaceBranch{PlaneSplitIn<6>{plane}, region.halves(model_, plane)};
}

std::optional<SpaceSearch::SpaceBranch> SpaceSearch::split_separation(
    const SpaceRegion& region, const SpaceRelaxation& found, std::size_t contact) const {
  const SpaceContact& c = model_.contacts[contact];
  if (c.has_certain_separation()) {
    return SpaceBranch{SeparationSplit{ContactId(contact)},
                       region.halves(model_, c.separations.front())};
  }
  if (!model_.is_family) {  // v / k'
    Wedge wedge{c.centre.normal, c.preload.low / c.stiffness.high,
                c.preload.high / c.stiffness.low, farthest_arm(c, c.normal)};
    for (Rational& entry : wedge.middle) entry = -entry;
    return split_wedge(region, found, wedge);
  }
  // The corner's plane that is nearest to the motion, of those that cut the region.
  const Point* nearest = nullptr;
  double least = HUGE_VAL;
  for (const Point& plane : c.separations) {
    const double value = std::fabs(value_at<6>(plane, found.motion, model_.length));
    if (value < least && region.signs(plane).cuts()) {
      least = value;
      nearest = &plane;
    }
  }
  if (nearest == nullptr) return std::nullopt;
  return SpaceBranch{PlaneSplitIn<6>{*nearest}, region.halves(model_, *nearest)};
}

/// Across the mean of the slip and of the one that friction implies: first whether there is any
/// slip, and then on which side.
std::optional<SpaceSearch::SpaceBranch> SpaceSearch::split_slip(const SpaceRegion& region,
                                                                const SpaceRelaxation& found,
                                                                std::size_t contact) const {
  const SpaceContact& c = model_.contacts[contact];
  const Double3 s = mean_slip(c, motion_of<6>(found.motion));
  const Double3& f = found.friction[contact];
  const double slip_size = norm_of(s);
  const double friction_size = norm_of(f);
  Double3 mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    mean[k] =
        (slip_size > 0 ? s[k] / slip_size : 0) - (friction_size > 0 ? f[k] / friction_size : 0);
  }
  constexpr double kOpposed = 1e-6;
  if (!(norm_of(mean) > kOpposed)) mean = s;  // friction along the slip
  const Double3 n = cross(c.tangents[0], c.tangents[1]);
  Double3 turned = cross(n, mean);
  // a.s as a function of points, with a of few bits.
  const auto plane_along = [&](const Double3& a) {
    for (const int bits : {3, 6, 10, 16, 24, 36, 50}) {
      const IntegerVector3 direction = in_bits<3>(a, bits);
      Point plane{};
      for (std::size_t j = 0; j < 6; ++j) {
        for (std::size_t k = 0; k < 3; ++k) {
          plane[j] += direction[k] * c.corners.front().slip[k][j];
        }
      }
      plane = primitive(std::move(plane));
      if (region.signs(plane).cuts()) return std::optional(plane);
    }
    return std::optional<Point>();
  };
  const bool is_new = c.geometry_is_certain && !region.slips(contact).moves &&
                      !region.is_strict(contact) && !region.is_still(contact);
  if (is_new) {
    return SpaceBranch{SlipSplit{ContactId(contact)},
                       {region.sticking(model_, contact), region.slipping(model_, contact)}};
  }
  const SlipCone& cone = region.slips(contact);
  const bool narrow = cone.moves && !cone.whole;
  if (!c.geometry_is_certain && !narrow) {
    const IntegerVector3 direction = in_bits<3>(mean, 6);
    Wedge wedge{{}, 0, 0, {}};
    Vector3 across{};  // the direction without its part along the normal
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 6; ++j) {
        wedge.middle[j] += Rational(direction[k] * c.centre.slip[k][j]) / c.centre.slip_factor;
      }
    }
    for (std::size_t k = 0; k < 3; ++k) across[k] = wedge.middle[k];
    wedge.far = farthest_arm(c, across);
    return split_wedge(region, found, wedge);
  }
  auto plane = plane_along(narrow ? turned : mean);
  if (!plane) plane = plane_along(narrow ? mean : turned);
  if (!plane) return std::nullopt;
  return SpaceBranch{PlaneSplitIn<6>{*plane}, region.halves(model_, *plane)};
}

std::optional<SpaceSearch::SpaceBranch> SpaceSearch::split(const SpaceRegion& region,
                                                           const SpaceRelaxation& found) {
  const std::size_t m = model_.contacts.size();
  const Double6 motion = motion_of<6>(found.motion);
  double energy = 0;
  std::vector<std::pair<double, std::size_t>> separations;
  std::vector<std::pair<double, std::size_t>> slips;
  for (std::size_t i = 0; i < m; ++i) {
    const SpaceContact& c = model_.contacts[i];
    const double a = found.normal[i];
    const double stiffness = (c.stiffnesses[0] + c.stiffnesses[1]) / 2;
    energy += a * a / stiffness;
    const double corners = static_cast<double>(c.corners.size());
    if (region.separation(i) == Separation::kMixed) {
      double lawful = found.motion[6] * (c.preloads[0] + c.preloads[1]) / 2 +
                      found.motion[7] * (c.rates[0] + c.rates[1]) / 2;
      for (const CornerRow& row : c.corners) {
        lawful -= stiffness * dot(row.normal_rounded, motion) / corners;
      }
      lawful = std::max(0.0, lawful);
      const double gap = std::fabs(a - lawful) * std::max(a, lawful) / stiffness;
      separations.emplace_back(gap, i);
    }
    if (c.slopes[1] > 0 && a > 0 && !region.is_still(i)) {
      const Double3 s = mean_slip(c, motion_of<6>(found.motion));
      const double gap = a * c.slopes[0] * norm_of(s) + dot(found.friction[i], s);
      slips.emplace_back(gap, i);
    }
  }
  std::sort(separations.rbegin(), separations.rend());
  std::sort(slips.rbegin(), slips.rend());
  if (escapes(found, energy)) {
    end_ = SearchEnd::kUnbounded;
    return std::nullopt;
  }
  // Trying an equilibrium costs as much as many nodes: it is done at counts 1, 2, 4, 8, ... and
  // where the relaxed one is nearer than before.
  const double gap = std::max(separations.empty() ? 0.0 : separations.front().first,
                              slips.empty() ? 0.0 : slips.front().first) /
                     energy;
  const bool is_near = gap < least_gap_ / 10;
  if (is_near) least_gap_ = gap;
  const bool is_due = (nodes_ & (nodes_ - 1)) == 0;
  if ((is_near || is_due) && is_candidate(region, found)) {
    end_ = SearchEnd::kCandidate;
    return std::nullopt;
  }
  constexpr double kNoticeable = 1e-12;  // of the energy; only chooses between splits
  for (const auto& [separation_gap, contact] : separations) {
    if (!(separation_gap > kNoticeable * energy)) break;
    if (auto branch = split_separation(region, found, contact)) return branch;
  }
  for (const auto& [slip_gap, contact] : slips) {
    if (!(slip_gap > kNoticeable * energy)) break;
    if (auto branch = split_slip(region, found, contact)) return branch;
  }
  // Between two generators that take part.
  for (std::size_t k = 1; k < found.points.size(); ++k) {
    const Point plane =
        plane_between<6>(region.generators()[found.points[0]],
                         region.generators()[found.points[k]], found.motion, model_.length);
    if (region.signs(plane).cuts()) {
      return SpaceBranch{PlaneSplitIn<6>{plane}, region.halves(model_, plane)};
    }
  }
  end_ = SearchEnd::kPlane;
  return std::nullopt;
}

/// Of a margin: motions grow without end towards one multiple, and so would the tree.
bool SpaceSearch::escapes(const SpaceRelaxation& found, double energy) const {
  constexpr double kFar = 1e6;
  const double height = found.motion[6];
  const double stiffest = model_.force / model_.reach;
  const bool is_far = norm_of(motion_of<6>(found.motion)) > kFar * model_.reach * height;
  // Forces are typical nevertheless.
  return model_.is_family && is_far &&
         energy < kFar * model_.force * model_.force * height * height / stiffest;
}

/// Taken at its word: its motion says which contacts slip.
bool SpaceSearch::is_candidate(const SpaceRegion& region, const SpaceRelaxation& found) const {
  const double height = found.motion[6];
  if (!candidate_ || !(height > 0)) return false;
  const Double6 motion = motion_of<6>(found.motion);
  NearEquilibrium near{as_vector(motion) / height, found.normal, found.friction,
                       std::vector<char>(found.normal.size())};
  for (std::size_t i = 0; i < near.normal.size(); ++i) {
    near.normal[i] /= height;
    for (double& entry : near.friction[i]) entry /= height;
    const SpaceContact& c = model_.contacts[i];
    const double slip = norm_of(mean_slip(c, motion));
    constexpr double kStill = 1e-7;  // of all motion
    const double size = std::sqrt(dot(motion, motion));
    const bool rubs = near.normal[i] > 0 && c.slopes[1] > 0;
    near.sticks[i] = rubs && (region.is_still(i) || slip <= kStill * size) ? 1 : 0;
  }
  return candidate_(near, found.motion[7] / height);
}

std::optional<SpaceSearch::SpaceBranch> SpaceSearch::examine(const SpaceRegion& region,
                                                             std::size_t depth) {
  // Below the depth that the format allows.
  const std::size_t deepest = 2 * model_.contacts.size() + 250;
  if (nodes_left_ == 0 || depth > deepest) {
    end_ = nodes_left_ == 0 ? SearchEnd::kNodes : SearchEnd::kDepth;
    return std::nullopt;
  }
  --nodes_left_;
  ++nodes_;
  ++work_.nodes;
  work_.rays += region.points().size();
  work_.pairs += region.pairs();
  work_.most_rays = std::max(work_.most_rays, region.points().size());
  for (const Point& x : region.points()) note_bits(work_.ray_bits, x);
  if (region.is_barred()) return SpaceBranch{LeafIn<6>{}, {}};
  const Wrenches wrenches(model_, region, direction_);
  Double6 start{};
  for (std::size_t j = 0; j < 6; ++j) {
    start[j] = -(model_.load[j][0] + model_.load[j][1] + model_.growing[j]);
  }
  const auto found =
      nearest_wrench<6>(start, [&](const Double6& y) { return wrenches.worst(y); });
  if (!found.separated) return split(region, wrenches.combine(found));
  const auto y = confirm(region, found.twist);
  if (!y) {
    end_ = SearchEnd::kTwist;
    return std::nullopt;
  }
  ++work_.leaves;
  return SpaceBranch{LeafIn<6>{*y}, {}};
}

bool SpaceSearch::refute(const SpaceRegion& region, SpatialTrees& trees) {
  end_ = SearchEnd::kNone;
  return append_tree(region, trees, [&](const SpaceRegion& at, std::size_t depth) {
    return examine(at, depth);
  });
}

}  // namespace stickslip::space_detail
