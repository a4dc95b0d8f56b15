// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "stickslip/equilibrium/search/nearest_point.hpp"

namespace stickslip::space_detail {
namespace {

double norm(const Double3& a) {
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
      double most = norm(slid);
      Double3 along = slid;
      for (double& entry : along) entry = most > 0 ? entry / most : 0;
      if (cone.moves && !cone.whole && most > 0 && !cone.sides.empty() &&
          !is_against(model, i, slid)) {
        most = -HUGE_VAL;
        for (const auto& [g, corner] : cone.sides) {
          const Double3& s = region_.slip(model, i, g, corner);
          const double length = norm(s);
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

Double6 load_on(const SpaceModel& model, const Double6& y) {
  Double6 load{};
  for (std::size_t j = 0; j < 6; ++j) load[j] = model.load[j][y[j] > 0 ? 1 : 0];
  return load;
}

}  // namespace

SpatialSearchResult SpaceSearch::search(const SpaceRegion& region) const {
  const std::vector<RegionPoint>& generators = region.generators();
  const std::size_t m = model_.contacts.size();
  // Comparable sizes of the wrenches at the generators, and where there are any.
  std::vector<double> scales;
  for (std::size_t g = 0; g < generators.size(); ++g) {
    double scale = generators[g].height * model_.force;
    for (std::size_t i = 0; i < m; ++i) {
      if (region.separation(i) == Separation::kOpen) continue;
      scale += std::max(0.0, region.most_separation(i, g)) *
               std::sqrt(dot(model_.contacts[i].corners[0].normal_rounded,
                             model_.contacts[i].corners[0].normal_rounded));
    }
    scales.push_back(scale);
  }
  std::vector<Double6> against;  // -A(d - h d0), of list 2
  if (direction_ != nullptr) {
    for (const RegionPoint& g : generators) {
      // Exactly, as d - h d0 may be small beside d.
      Vector6 from{};
      for (std::size_t j = 0; j < 6; ++j) {
        from[j] = Rational(g.exact[j]) - Rational(g.exact[6]) * direction_->twist[j];
      }
      Double6 a{};
      for (std::size_t j = 0; j < 6; ++j) {
        const Rational value = dot(direction_->matrix[j], from) / Rational(g.exact[6]);
        a[j] = -to_double(value) / (j < 3 ? 1 : model_.length);
      }
      const double length = std::sqrt(dot(a, a));
      for (double& entry : a) entry /= length;
      against.push_back(a);
    }
  }
  struct Support {
    std::size_t generator;
    bool against;
    std::vector<double> normal;
    std::vector<Double3> friction;
  };
  std::vector<Support> supports;
  equilibrium_detail::NearestPointIn<6> hull;
  SpatialSearchResult result;
  Double6& y = result.twist;
  for (std::size_t j = 0; j < 6; ++j) y[j] = -(model_.load[j][0] + model_.load[j][1]);
  if (dot(y, y) == 0) y = {1, 0, 0, 0, 0, 0};
  double largest = 0;
  constexpr std::size_t kMostSteps = 100;
  constexpr double kVanishing = 1e-22;  // of squared lengths; a proposal, not a decision
  for (std::size_t step = 0; step < kMostSteps; ++step) {
    const Actions actions(model_, region, y);
    const double load = dot(load_on(model_, y), y);
    double worst = -HUGE_VAL;
    std::size_t at = generators.size();
    bool is_against = false;
    for (std::size_t g = 0; g < generators.size(); ++g) {
      if (!(scales[g] > 0)) continue;
      double work = generators[g].height * load;
      bool acts = generators[g].height > 0;
      for (std::size_t i = 0; i < m; ++i) {
        const double a = actions.normal(i, g);
        work += a * actions[i].alpha;
        acts = acts || a != 0;
      }
      work /= scales[g];
      if (acts && work > worst) {
        worst = work;
        at = g;
      }
    }
    for (std::size_t g = 0; g < against.size(); ++g) {
      const double work = dot(against[g], y);
      if (work <= worst) continue;
      worst = work;
      at = g;
      is_against = true;
    }
    if (worst < 0) {
      result.separated = true;
      return result;
    }
    if (at == generators.size()) break;
    Double6 wrench{};
    Support support{at, is_against, std::vector<double>(m), std::vector<Double3>(m)};
    if (is_against) {
      wrench = against[at];
    } else {
      const Double6 w = load_on(model_, y);
      for (std::size_t j = 0; j < 6; ++j) wrench[j] = generators[at].height * w[j];
      for (std::size_t i = 0; i < m; ++i) {
        const double a = actions.normal(i, at);
        if (a == 0) continue;
        const CornerRow& row = model_.contacts[i].corners[actions[i].corner];
        support.normal[i] = a;
        for (std::size_t k = 0; k < 3; ++k) support.friction[i][k] = a * actions[i].friction[k];
        for (std::size_t j = 0; j < 6; ++j) {
          wrench[j] += a * row.normal_rounded[j];
          for (std::size_t k = 0; k < 3; ++k) {
            wrench[j] += support.friction[i][k] * row.slip_rounded[k][j];
          }
        }
      }
      for (double& entry : wrench) entry /= scales[at];
    }
    supports.push_back(std::move(support));
    largest = std::max(largest, dot(wrench, wrench));
    const bool progress = hull.add(wrench);
    const Double6& nearest = hull.nearest();
    if (!progress || dot(nearest, nearest) <= kVanishing * largest) break;
    for (std::size_t j = 0; j < 6; ++j) y[j] = -nearest[j];
  }
  result.normal.assign(m, 0);
  result.friction.assign(m, Double3{});
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Support& s = supports[hull.order(k)];
    order.emplace_back(-hull.weight(k), s.generator);
    if (s.against) continue;
    const double weight = hull.weight(k) / scales[s.generator];
    for (std::size_t j = 0; j < 6; ++j) {
      result.motion[j] += weight * generators[s.generator].motion[j];
    }
    result.height += weight * generators[s.generator].height;
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

/// The twist in the fewest bits that still refute the region.
std::optional<IntegerVector<6>> SpaceSearch::confirm(const SpaceRegion& region,
                                                     const Double6& twist) {
  Double6 y = twist;
  for (std::size_t j = 3; j < 6; ++j) y[j] /= model_.length;
  IntegerVector<6> before{};
  const std::vector<RegionPoint>& generators = region.generators();
  for (const int bits : {2, 4, 6, 8, 12, 16, 24, 36, 50}) {
    const IntegerVector<6> candidate = in_bits<6>(y, bits);
    if (candidate == before || is_zero(candidate)) continue;
    before = candidate;
    // Most candidates fail clearly.
    Double6 scaled{};
    double size = 0;
    for (std::size_t j = 0; j < 6; ++j) {
      scaled[j] = candidate[j].convert_to<double>() * (j < 3 ? 1 : model_.length);
      size += std::fabs(scaled[j]);
    }
    const Actions actions(model_, region, scaled);
    const double load = dot(load_on(model_, scaled), scaled);
    bool hopeless = false;
    for (std::size_t g = 0; g < generators.size() && !hopeless; ++g) {
      double work = generators[g].height * load;
      double magnitude = generators[g].height * model_.force * size;
      for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
        const double part = actions.normal(i, g) * actions[i].alpha;
        work += part;
        magnitude += std::fabs(part);
      }
      constexpr double kClear = 1e-9;
      hopeless = work > kClear * magnitude;
    }
    if (hopeless) continue;
    ++work_.exact_checks;
    if (region.is_refuted(model_, candidate, direction_)) {
      work_.twist_bits =
          std::max<std::size_t>(work_.twist_bits, static_cast<std::size_t>(bits));
      return candidate;
    }
  }
  return std::nullopt;
}

bool SpaceSearch::cut(const SpaceRegion& region, const Point& plane, SpatialTrees& trees,
                      std::size_t depth) {
  return visit(region.half(model_, plane, Side::kPositive), trees, depth + 1) &&
         visit(region.half(model_, plane, Side::kNegative), trees, depth + 1);
}

/// Across the mean of the slip and of the one that friction implies: first whether there is any
/// slip, and then on which side.
bool SpaceSearch::split_slip(const SpaceRegion& region, const SpatialSearchResult& found,
                             std::size_t contact, SpatialTrees& trees, std::size_t depth) {
  const SpaceContact& c = model_.contacts[contact];
  const Double3 s = mean_slip(c, found.motion);
  const Double3& f = found.friction[contact];
  const double slip_size = norm(s);
  const double friction_size = norm(f);
  Double3 mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    mean[k] =
        (slip_size > 0 ? s[k] / slip_size : 0) - (friction_size > 0 ? f[k] / friction_size : 0);
  }
  constexpr double kOpposed = 1e-6;
  if (!(norm(mean) > kOpposed)) mean = s;  // friction along the slip
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
      if (region.is_cut_by(plane)) return std::optional(plane);
    }
    return std::optional<Point>();
  };
  const bool is_new = c.geometry_is_certain && !region.slips(contact).moves &&
                      !region.is_strict(contact) && !region.is_still(contact);
  const auto go = [&](const SpaceRegion& at, std::size_t below) {
    const SlipCone& cone = at.slips(contact);
    const bool narrow = cone.moves && !cone.whole;
    auto plane = plane_along(narrow ? turned : mean);
    if (!plane) plane = plane_along(narrow ? mean : turned);
    if (!plane) {
      if (!is_new) return false;
      return visit(at, trees, below);
    }
    trees.push_back(SpatialPlaneSplit{*plane});
    return cut(at, *plane, trees, below);
  };
  if (!is_new) return go(region, depth);
  trees.push_back(SlipSplit{ContactId(contact)});
  if (!visit(region.sticking(model_, contact), trees, depth + 1)) return false;
  return go(region.slipping(model_, contact), depth + 1);
}

bool SpaceSearch::split(const SpaceRegion& region, const SpatialSearchResult& found,
                        SpatialTrees& trees, std::size_t depth) {
  const std::size_t m = model_.contacts.size();
  double energy = 0;
  double separation_gap = 0;
  std::size_t separation = m;
  std::vector<std::pair<double, std::size_t>> slips;
  for (std::size_t i = 0; i < m; ++i) {
    const SpaceContact& c = model_.contacts[i];
    const double a = found.normal[i];
    const double stiffness = (c.stiffnesses[0] + c.stiffnesses[1]) / 2;
    energy += a * a / stiffness;
    const double corners = static_cast<double>(c.corners.size());
    if (region.separation(i) == Separation::kMixed) {
      double lawful = found.height * (c.preloads[0] + c.preloads[1]) / 2;
      for (const CornerRow& row : c.corners) {
        lawful -= stiffness * dot(row.normal_rounded, found.motion) / corners;
      }
      lawful = std::max(0.0, lawful);
      const double gap = std::fabs(a - lawful) * std::max(a, lawful) / stiffness;
      if (gap > separation_gap) {
        separation_gap = gap;
        separation = i;
      }
    }
    if (c.slopes[1] > 0 && a > 0 && !region.is_still(i)) {
      const Double3 s = mean_slip(c, found.motion);
      const double gap = a * c.slopes[0] * norm(s) + dot(found.friction[i], s);
      slips.emplace_back(gap, i);
    }
  }
  std::sort(slips.rbegin(), slips.rend());
  // Trying an equilibrium costs as much as many nodes: it is done at counts 1, 2, 4, 8, ... and
  // where the relaxed one is nearer than before.
  const double gap =
      std::max(separation_gap, slips.empty() ? 0.0 : slips.front().first) / energy;
  const bool is_near = gap < least_gap_ / 10;
  if (is_near) least_gap_ = gap;
  const bool is_due = (nodes_ & (nodes_ - 1)) == 0;
  if ((is_near || is_due) && is_candidate(region, found)) return false;
  constexpr double kNoticeable = 1e-12;  // of the energy; only chooses between splits
  if (separation_gap > kNoticeable * energy) {
    const SpaceContact& c = model_.contacts[separation];
    if (c.has_certain_separation()) {
      trees.push_back(SeparationSplit{ContactId(separation)});
      return cut(region, c.separations.front(), trees, depth);
    }
    // The corner's plane that is nearest to the motion, of those that cut the region.
    const Point* nearest = nullptr;
    double least = HUGE_VAL;
    for (const Point& plane : c.separations) {
      double value = plane[6].convert_to<double>() * found.height;
      double size = std::fabs(value);
      for (std::size_t j = 0; j < 6; ++j) {
        const double term =
            plane[j].convert_to<double>() / (j < 3 ? 1 : model_.length) * found.motion[j];
        value += term;
        size += std::fabs(term);
      }
      value = std::fabs(value) / size;
      if (value < least && region.is_cut_by(plane)) {
        least = value;
        nearest = &plane;
      }
    }
    if (nearest != nullptr) {
      trees.push_back(SpatialPlaneSplit{*nearest});
      return cut(region, *nearest, trees, depth);
    }
  }
  for (const auto& [slip_gap, contact] : slips) {
    if (!(slip_gap > kNoticeable * energy)) break;
    const std::size_t before = trees.size();
    if (split_slip(region, found, contact, trees, depth)) return true;
    if (trees.size() != before) return false;
  }
  // Between two generators that take part.
  for (std::size_t k = 1; k < found.points.size(); ++k) {
    const RegionPoint& a = region.generators()[found.points[0]];
    const RegionPoint& b = region.generators()[found.points[k]];
    std::array<double, 7> across{};
    double along = 0;
    const double size = dot(found.motion, found.motion) + found.height * found.height;
    if (!(size > 0)) break;
    for (std::size_t j = 0; j < 7; ++j) {
      across[j] = j < 6 ? a.motion[j] - b.motion[j] : a.height - b.height;
      along += across[j] * (j < 6 ? found.motion[j] : found.height);
    }
    for (std::size_t j = 0; j < 7; ++j) {
      across[j] -= along / size * (j < 6 ? found.motion[j] : found.height);
      if (j >= 3 && j < 6) across[j] *= model_.length;
    }
    constexpr int kBits = 12;
    const IntegerVector<7> entries = in_bits<7>(across, kBits);
    Point plane{};
    std::copy(entries.begin(), entries.end(), plane.begin());
    if (!region.is_cut_by(plane)) continue;
    trees.push_back(SpatialPlaneSplit{plane});
    return cut(region, plane, trees, depth);
  }
  return false;
}

/// Taken at its word: its motion says which contacts slip.
bool SpaceSearch::is_candidate(const SpaceRegion& region,
                               const SpatialSearchResult& found) const {
  if (!candidate_ || !(found.height > 0)) return false;
  NearEquilibrium near{EigenVector6(found.motion.data()) / found.height, found.normal,
                       found.friction, std::vector<char>(found.normal.size())};
  for (std::size_t i = 0; i < near.normal.size(); ++i) {
    near.normal[i] /= found.height;
    for (double& entry : near.friction[i]) entry /= found.height;
    const SpaceContact& c = model_.contacts[i];
    const double slip = norm(mean_slip(c, found.motion));
    constexpr double kStill = 1e-7;  // of all motion
    const double size = std::sqrt(dot(found.motion, found.motion));
    const bool rubs = near.normal[i] > 0 && c.slopes[1] > 0;
    near.sticks[i] = rubs && (region.is_still(i) || slip <= kStill * size) ? 1 : 0;
  }
  return candidate_(near);
}

bool SpaceSearch::visit(const SpaceRegion& region, SpatialTrees& trees, std::size_t depth) {
  throw_if_cancelled();
  // Below the depth that the format allows, with room for the two nodes of a slip.
  const std::size_t deepest = 2 * model_.contacts.size() + 250;
  if (nodes_left_ == 0 || depth > deepest) return false;
  --nodes_left_;
  ++nodes_;
  ++work_.nodes;
  work_.rays += region.generators().size();
  work_.most_rays = std::max(work_.most_rays, region.generators().size());
  for (const RegionPoint& g : region.generators()) {
    for (const Integer& entry : g.exact) {
      if (!entry.is_zero()) {
        work_.ray_bits = std::max<std::size_t>(work_.ray_bits, msb(abs(entry)) + 1);
      }
    }
  }
  if (region.is_barred()) {
    trees.push_back(SpatialLeaf{});
    return true;
  }
  const SpatialSearchResult found = search(region);
  if (!found.separated) return split(region, found, trees, depth);
  const auto y = confirm(region, found.twist);
  if (!y) return false;
  ++work_.leaves;
  trees.push_back(SpatialLeaf{*y});
  return true;
}

}  // namespace stickslip::space_detail
