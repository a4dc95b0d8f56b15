// SPDX-License-Identifier: GPL-3.0-or-later
#include "twist_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace stickslip::planar_detail {
namespace {

double magnitude_of(const ContactDoubles& c, const Double3& y) {
  double sum = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    sum += (std::fabs(c.normal[j]) + std::fabs(c.friction[j])) * std::fabs(y[j]);
  }
  return sum;
}

double magnitude_of(const Double5& function, const Double5& x) {
  double sum = 0;
  for (std::size_t j = 0; j < 5; ++j) sum += std::fabs(function[j] * x[j]);
  return sum;
}

struct ValueRange {
  double low;
  double high;
};

/// Returns the range of the functions of a box at a point, wide enough for what is rounded.
template <std::size_t n, std::size_t k>
ValueRange range_of(const CoefficientBox<n>& box, const std::array<double, k>& x) {
  constexpr std::size_t kUsed = std::min(n, k);
  double center = 0;
  double radius = 0;
  double magnitude = 0;
  for (std::size_t j = 0; j < kUsed; ++j) {
    center += box.center[j] * x[j];
    radius += box.radius[j] * std::fabs(x[j]);
    magnitude += std::fabs(box.center[j] * x[j]);
  }
  // The relative errors are 4u for coefficients, u for products, 6u for sums: below 18u, with u
  // = 2^-53.
  constexpr double kRelativeError = 2e-15;
  radius += kRelativeError * (magnitude + radius);
  return {center - radius, center + radius};
}

/// The work of a group's contacts on a twist.
struct GroupWork {
  double sigma = 1;         ///< the edge on which friction works most, in the middle
  bool is_one_edge = true;  ///< it is the edge of all of them
  ValueRange alpha{0, 0};   ///< the range of alpha over all of them

  /// Returns whether all contacts count, with one edge.
  bool is_one_form(const ContactFreedom& freedom) const {
    return is_one_edge && (freedom.is_closed() || alpha.low > 0);
  }
  /// Returns whether no contact counts.
  bool is_idle(const ContactFreedom& freedom) const {
    return !freedom.is_closed() && alpha.high < 0;
  }
};

GroupWork group_work(const ContactGroup& group, const ContactFreedom& freedom,
                     const Double3& y) {
  const ValueRange minus_normal = range_of(group.separation, y);
  const ValueRange friction = range_of(group.friction, y);
  GroupWork work;
  work.sigma = freedom.edge(friction.low + friction.high);
  work.is_one_edge = freedom.slip != 0 || friction.low >= 0 || friction.high <= 0;
  const ValueRange edge = work.sigma > 0 ? friction : ValueRange{-friction.high, -friction.low};
  work.alpha = {edge.low - minus_normal.high, edge.high - minus_normal.low};
  if (!work.is_one_edge) work.alpha.high = std::max(-edge.low, edge.high) - minus_normal.low;
  return work;
}

/// Returns max(0, v) of a contact at a ray, without what may be rounding alone; for proposals.
double push_at(const ContactDoubles& c, const Double5& x) {
  const double v = dot(c.separation, x);
  return v > c.separation_error ? v : 0;
}

}  // namespace

template <class Visit>
void TwistSearch::for_each_working(const RegionForces& forces, const UndecidedGroup& u,
                                   const Double3& twist, const Visit& visit) const {
  forces.for_each_contact(u, [&](std::uint32_t contact) {
    const ContactDoubles& c = model_.contacts[contact];
    const double friction = dot(c.friction, twist);
    const double sigma = u.freedom.edge(friction);
    double alpha = dot(c.normal, twist) + sigma * friction;
    if (!u.freedom.is_closed()) {
      // alpha sums 6 products of factors rounded once: below 16 roundings of its magnitude.
      constexpr double kAlphaError = 2e-15;
      if (alpha < -kAlphaError * magnitude_of(c, twist)) return;
      alpha = std::max(0.0, alpha);
    }
    visit(contact, sigma, alpha);
  });
}

template <class OnGroup, class OnContact>
void TwistSearch::for_each_part(const RegionForces& forces, const Double3& twist,
                                bool precisely, const OnGroup& on_group,
                                const OnContact& on_contact) const {
  for (std::size_t k = 0; k < forces.undecided().size(); ++k) {
    if (precisely) {
      const UndecidedGroup& u = forces.undecided()[k];
      const GroupWork work = group_work(model_.groups.groups()[u.group], u.freedom, twist);
      if (work.is_idle(u.freedom)) continue;
      if (!work.is_one_form(u.freedom)) {
        for_each_working(forces, u, twist,
                         [&](std::uint32_t contact, double sigma, double alpha) {
                           if (alpha != 0) on_contact(model_.contacts[contact], sigma, alpha);
                         });
        continue;
      }
    }
    const double sigma = middles_[k].edge(twist);
    if (sigma != 0) on_group(forces.block_forces(k), sigma);
  }
}

/// Adds the parts of undecided contacts to bounds_ and acting_.
void TwistSearch::add_undecided_bounds(const RegionForces& forces, const Double3& twist,
                                       bool precisely) {
  const auto [y0, y1, y2] = twist;
  const auto add_group = [&, y0 = y0, y1 = y1, y2 = y2](const BlockForces* sums, double sigma) {
    for (std::size_t b = 0; b < forces.blocks().size(); ++b) {
      const auto& [n, f, pressing, pushes] = sums[b];
      Eigen::Map<BlockDoubles> bounds(&bounds_[b * kBlock]);
      bounds +=
          y0 * (n[0] + sigma * f[0]) + y1 * (n[1] + sigma * f[1]) + y2 * (n[2] + sigma * f[2]);
      Eigen::Map<BlockDoubles> acting(&acting_[b * kBlock]);
      acting += pushes;
    }
  };
  const auto add_contact = [&](const ContactDoubles& c, double, double alpha) {
    for (std::size_t r = 0; r < forces.ray_count(); ++r) {
      const double push = push_at(c, forces.rays()[r]);
      bounds_[r] += alpha * push;
      acting_[r] += push;
    }
  };
  for_each_part(forces, twist, precisely, add_group, add_contact);
}

/// Returns the wrench whose work on the twist is the bound at the ray.
Double3 TwistSearch::wrench_at(const RegionForces& forces, const Double3& twist,
                               std::size_t ray, bool precisely) const {
  const Double5& x = forces.rays()[ray];
  Double3 wrench{};
  for (std::size_t j = 0; j < 3; ++j) {
    wrench[j] = x[3] * model_.load[j] + x[4] * model_.growth[j];
    for (std::size_t k = 0; k < 5; ++k) wrench[j] += forces.decided().value[j][k] * x[k];
  }
  const auto add_group = [&](const BlockForces* blocks, double sigma) {
    const BlockForces& sums = blocks[ray / kBlock];
    for (std::size_t j = 0; j < 3; ++j) {
      wrench[j] +=
          sums.normal[j].data()[ray % kBlock] + sigma * sums.friction[j].data()[ray % kBlock];
    }
  };
  const auto add_contact = [&](const ContactDoubles& c, double sigma, double) {
    const double push = push_at(c, x);
    for (std::size_t j = 0; j < 3; ++j) {
      wrench[j] += push * (c.normal[j] + sigma * c.friction[j]);
    }
  };
  for_each_part(forces, twist, precisely, add_group, add_contact);
  return wrench;
}

void TwistSearch::list_middles(const RegionForces& forces) {
  middles_.clear();
  for (const UndecidedGroup& u : forces.undecided()) {
    const ContactGroup& group = model_.groups.groups()[u.group];
    const auto& v = group.separation.center;
    middles_.push_back({{-v[0], -v[1], -v[2]}, group.friction.center, u.freedom});
  }
}

/// Finds scales that make the wrenches of rays comparable, by force: rays are as long as their
/// directions happen to be.
void TwistSearch::scale_rays(const RegionForces& forces) {
  const std::size_t ray_count = forces.ray_count();
  scales_.assign(ray_count, 0.0);
  const Double3& u = model_.growth;
  const double growth = std::fabs(u[0]) + std::fabs(u[1]) + std::fabs(u[2]) / model_.length;
  for (std::size_t r = 0; r < ray_count; ++r) {
    const Double5& x = forces.rays()[r];
    scales_[r] = std::fabs(x[3]) * model_.force + std::fabs(x[4]) * growth;
    for (std::size_t j = 0; j < 2; ++j) {
      double decided = 0;
      for (std::size_t k = 0; k < 5; ++k) decided += forces.decided().value[j][k] * x[k];
      scales_[r] += std::fabs(decided);
    }
  }
  for (std::size_t b = 0; b < forces.blocks().size(); ++b) {
    BlockDoubles sum = BlockDoubles::Zero();
    for (std::size_t k = 0; k < forces.undecided().size(); ++k) {
      sum += forces.block_forces(k)[b].pressing;
    }
    const std::size_t begin = b * kBlock;
    for (std::size_t r = begin; r < std::min(begin + kBlock, ray_count); ++r) {
      scales_[r] += sum.data()[r - begin];
    }
  }
  for (double& scale : scales_) {
    scale = std::max(scale, std::numeric_limits<double>::min()) / model_.force;
  }
}

/// Returns the ray with the largest bound on the twist, by scale, and that bound.
std::pair<std::size_t, double> TwistSearch::worst_ray(const RegionForces& forces,
                                                      const Double3& twist, bool precisely) {
  const std::size_t ray_count = forces.ray_count();
  Double5 form{0, 0, 0, dot(model_.load, twist), dot(model_.growth, twist)};
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t j = 0; j < 3; ++j) form[k] += twist[j] * forces.decided().value[j][k];
  }
  bounds_.assign(forces.blocks().size() * kBlock, 0.0);
  acting_.assign(forces.blocks().size() * kBlock, 0.0);
  for (std::size_t r = 0; r < ray_count; ++r) bounds_[r] = dot(form, forces.rays()[r]);
  add_undecided_bounds(forces, twist, precisely);
  std::pair<std::size_t, double> worst{ray_count, -HUGE_VAL};
  for (std::size_t r = 0; r < ray_count; ++r) {
    // A ray on which nothing acts is barred: g and h are 0.
    if (!forces.loaded(r) && !(acting_[r] > 0)) continue;
    const double bound = bounds_[r] / scales_[r];
    if (bound > worst.second) worst = {r, bound};
  }
  return worst;
}

SearchResult TwistSearch::search(const RegionForces& forces, bool precisely, BranchWork& work) {
  ++work.searches;
  list_middles(forces);
  scale_rays(forces);
  // The search takes torques over the length.
  const double length = model_.length;
  const auto unscaled = [&](const Double3& y) -> Double3 {
    return {y[0], y[1], y[2] / length};
  };
  const Double3 start = unscaled(model_.start);
  std::vector<Double3> against;
  if (pull_ != nullptr) {
    for (const Ray& ray : forces.exact_rays()) {
      const Reals exact = pull_->against(ray.x);
      normalize(against.emplace_back(Double3{exact[0], exact[1], exact[2] / length}));
    }
  }
  const auto found =
      nearest_wrench(Double3{-start[0], -start[1], -start[2]}, [&](const Double3& y) {
        ++work.support_points;
        const Double3 twist = unscaled(y);
        const auto [ray, bound] = worst_ray(forces, twist, precisely);
        Support support{bound, {}, ray, twist};
        if (bound >= 0) {
          support.wrench = unscaled(wrench_at(forces, twist, ray, precisely));
          for (double& entry : support.wrench) entry /= scales_[ray];
        }
        for (std::size_t r = 0; r < against.size(); ++r) {
          const double along = dot(against[r], y);
          if (along > support.work) support = {along, against[r], r, twist, true};
        }
        return std::optional(support);
      });
  SearchResult result;
  if (found.separated) {
    result.separated = true;
    result.twist = unscaled(found.twist);
    return result;
  }
  for (const auto& [part, support] : found.parts) {
    if (support.against) continue;
    const double weight = part / scales_[support.ray];
    PushedMotion pushed{forces.rays()[support.ray], support.twist, support.ray, weight};
    for (std::size_t j = 0; j < 5; ++j) {
      pushed.motion[j] *= weight;
      result.motion[j] += pushed.motion[j];
    }
    result.pushed.push_back(pushed);
  }
  return result;
}

RelaxedForce TwistSearch::force(std::uint32_t contact, const ContactFreedom& freedom,
                                const SearchResult& found) const {
  const ContactDoubles& c = model_.contacts[contact];
  RelaxedForce result;
  for (const PushedMotion& pushed : found.pushed) {
    const double friction = dot(c.friction, pushed.twist);
    const double sigma = freedom.edge(friction);
    if (!freedom.is_closed() && !(dot(c.normal, pushed.twist) + sigma * friction > 0)) continue;
    const double a = std::max(0.0, dot(c.separation, pushed.motion));
    result.normal += a;
    result.tangential += sigma * a;
  }
  return result;
}

/// Bounds k a^2 |n|^2 and the like. The box's coefficients are those of contacts with k |n|^2 =
/// 1; the stiffest contact of the group scales the result. A pushed motion on which a contact
/// counts has a = max(0, v), so it differs from v only where that is negative.
TwistSearch::GapBounds TwistSearch::gap_bounds(const ContactGroup& group,
                                               const ContactFreedom& freedom,
                                               const SearchResult& found) const {
  const ValueRange slip = range_of(group.friction, found.motion);
  const ValueRange law = range_of(group.separation, found.motion);
  double most = 0;   // bounds a
  double above = 0;  // bounds a - v
  double below = 0;  // bounds v - a
  GapBounds result;
  for (const PushedMotion& pushed : found.pushed) {
    const GroupWork work = group_work(group, freedom, pushed.twist);
    const ValueRange v = range_of(group.separation, pushed.motion);
    const bool counts = freedom.is_closed() || work.alpha.low > 0;
    const bool may_count = freedom.is_closed() || work.alpha.high > 0;
    const double a = may_count ? std::max(0.0, v.high) : 0;
    most += a;
    above += may_count ? std::max(0.0, -v.low) : -v.low;
    below += counts ? std::min(0.0, v.high) : v.high;
    // The dissipation that is missing is a |tau| + b tau.
    const double dissipated = !work.is_one_edge ? std::max(slip.high, -slip.low)
                              : work.sigma > 0  ? std::max(0.0, slip.high)
                                                : std::max(0.0, -slip.low);
    result.slip += 2 * a * dissipated;
  }
  const double gap = std::max({0.0, std::min(most, above), below});
  result.separation = group.stiffest * gap * std::max({0.0, most, law.high});
  result.slip *= group.stiffest;
  return result;
}

/// Returns about the energy of the springs, as if all contacts of a group had their share of
/// what presses.
double TwistSearch::energy(const RegionForces& forces, const SearchResult& found) const {
  double sum = 0;
  for (std::size_t k = 0; k < forces.undecided().size(); ++k) {
    double pressing = 0;
    for (const PushedMotion& pushed : found.pushed) {
      if (middles_[k].edge(pushed.twist) == 0) continue;
      const BlockForces& sums = forces.block_forces(k)[pushed.ray / kBlock];
      pressing += pushed.weight * sums.pressing.data()[pushed.ray % kBlock];
    }
    const UndecidedGroup& u = forces.undecided()[k];
    sum += pressing * pressing / model_.groups.groups()[u.group].stiffness;
  }
  return sum;
}

WidestGap TwistSearch::widest_gap(const RegionForces& forces, const SearchResult& found) const {
  struct Widest {
    double gap = 0;
    std::uint32_t contact = 0;

    void consider(double candidate_gap, std::uint32_t candidate) {
      // The first of equals wins, in whatever order they come.
      if (candidate_gap > gap || (candidate_gap == gap && gap > 0 && candidate < contact)) {
        gap = candidate_gap;
        contact = candidate;
      }
    }
  };
  Widest separation;
  Widest slip;
  const auto consider_separation = [&](std::uint32_t contact, const ContactFreedom& freedom) {
    if (freedom.is_closed()) return;
    const ContactDoubles& c = model_.contacts[contact];
    // The search lets a be anything from 0 up; a = max(0, v) is the law.
    const double a = force(contact, freedom, found).normal;
    const double lawful = std::max(0.0, dot(c.separation, found.motion));
    separation.consider(std::fabs(a - lawful) * std::max(a, lawful) / c.stiffness, contact);
  };
  const auto consider_slip = [&](std::uint32_t contact, const ContactFreedom& freedom) {
    if (freedom.slip != 0 || !freedom.slip_cuts) return;
    const ContactDoubles& c = model_.contacts[contact];
    // The dissipation that is missing is mu a |tau| + b tau.
    double tau = 0;
    for (std::size_t j = 0; j < 3; ++j) tau += c.friction[j] * found.motion[j];
    const RelaxedForce relaxed = force(contact, freedom, found);
    slip.consider(relaxed.normal * std::fabs(tau) + relaxed.tangential * tau, contact);
  };
  // Groups with the largest bounds come first, until no other can hold a wider gap.
  const auto find_widest = [&](Widest& widest, double GapBounds::*bound, const auto& consider) {
    struct Pending {
      double bound;
      UndecidedGroup part;
      bool operator<(const Pending& other) const { return bound < other.bound; }
    };
    std::priority_queue<Pending> pending;
    const auto add = [&](const UndecidedGroup& part) {
      const ContactGroup& group = model_.groups.groups()[part.group];
      pending.push({gap_bounds(group, part.freedom, found).*bound, part});
    };
    for (const UndecidedGroup& u : forces.undecided()) {
      const bool may_have_one = bound == &GapBounds::separation
                                    ? !u.freedom.is_closed()
                                    : u.freedom.slip == 0 && u.freedom.slip_cuts;
      if (may_have_one) add(u);
    }
    // The first of equals is wanted, but no look is needed at groups whose bound is 0.
    while (!pending.empty() && pending.top().bound > 0 && pending.top().bound >= widest.gap) {
      const UndecidedGroup part = pending.top().part;
      pending.pop();
      const ContactGroup& group = model_.groups.groups()[part.group];
      if (group.second != 0 && part.begin == part.end) {
        add({part.group + 1, part.freedom});
        add({group.second, part.freedom});
      } else {
        forces.for_each_contact(
            part, [&](std::uint32_t contact) { consider(contact, part.freedom); });
      }
    }
  };
  constexpr double kNoticeable = 1e-12;  // only chooses between a split and an exact program
  const double all = energy(forces, found);
  // Separation comes first: a contact that may open weakens the bound on every ray, and a tree
  // that splits these first is several times smaller.
  find_widest(separation, &GapBounds::separation, consider_separation);
  if (separation.gap > kNoticeable * all) {
    return {SeparationSplit{ContactId(separation.contact)}, separation.gap / all};
  }
  find_widest(slip, &GapBounds::slip, consider_slip);
  if (slip.gap > kNoticeable * all) {
    return {SlipSplit{ContactId(slip.contact)}, slip.gap / all};
  }
  return {};
}

std::optional<bool> TwistSearch::certain_refutation(const RegionForces& forces,
                                                    const Double3& twist) {
  if (!model_.is_moderate) return std::nullopt;
  const std::size_t ray_count = forces.ray_count();
  // g is one linear form of the ray where contacts are taken in groups, and its magnitude too.
  Double5 form{0, 0, 0, dot(model_.load, twist), dot(model_.growth, twist)};
  Double5 size{};
  const auto add = [&](const double(&work)[3][5], const double(&magnitude)[3][5]) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 5; ++k) {
        form[k] += twist[j] * work[j][k];
        size[k] += std::fabs(twist[j]) * magnitude[j][k];
      }
    }
  };
  for (std::size_t j = 0; j < 3; ++j) {
    size[3] += std::fabs(model_.load[j] * twist[j]);
    size[4] += std::fabs(model_.growth[j] * twist[j]);
  }
  add(forces.decided().value, forces.decided().magnitude);
  bounds_.assign(ray_count, 0.0);
  acting_.assign(ray_count, 0.0);
  errors_.assign(ray_count, 0.0);
  const auto add_at = [&](std::size_t r) {
    const Double5& x = forces.rays()[r];
    bounds_[r] += dot(form, x);
    for (std::size_t k = 0; k < 5; ++k) errors_[r] += std::fabs(x[k]) * size[k];
  };
  for (std::size_t r = 0; r < ray_count; ++r) add_at(r);
  std::vector<UndecidedGroup> parts;
  for (std::size_t k = 0; k < forces.undecided().size(); ++k) {
    const BlockForces* sums = forces.block_forces(k);
    const auto pushes_at = [&](std::size_t r) {
      return sums[r / kBlock].pushes.data()[r % kBlock] > 0;
    };
    parts.push_back(forces.undecided()[k]);
    while (!parts.empty()) {
      const UndecidedGroup u = parts.back();
      parts.pop_back();
      const ContactGroup& group = model_.groups.groups()[u.group];
      const GroupWork work = group_work(group, u.freedom, twist);
      const bool is_whole = u.begin == u.end;
      if (work.is_idle(u.freedom)) continue;
      if (work.is_one_form(u.freedom)) {
        form = {};
        size = {};
        double edge_work[3][5] = {};  // 0 unless the group is whole; if not, by rays below
        for (std::size_t j = 0; j < 3 && is_whole; ++j) {
          for (std::size_t n = 0; n < 5; ++n) {
            edge_work[j][n] = group.normal_work[j][n] + work.sigma * group.friction_work[j][n];
          }
        }
        add(edge_work, group.magnitude);
        for (std::size_t r = 0; r < ray_count; ++r) {
          if (!pushes_at(r)) continue;  // exactly 0, or open at this ray
          double sum = 0;               // one term of g
          for (std::size_t j = 0; j < 3 && !is_whole; ++j) {
            sum += twist[j] * (sums[r / kBlock].normal[j].data()[r % kBlock] +
                               work.sigma * sums[r / kBlock].friction[j].data()[r % kBlock]);
          }
          bounds_[r] += sum;
          add_at(r);
          acting_[r] = 1;
        }
      } else if (is_whole && group.second != 0) {
        parts.push_back({u.group + 1, u.freedom});
        parts.push_back({group.second, u.freedom});
      } else {
        for_each_working(forces, u, twist, [&](std::uint32_t contact, double, double alpha) {
          const ContactDoubles& c = model_.contacts[contact];
          const double alpha_magnitude = magnitude_of(c, twist);
          for (std::size_t r = 0; r < ray_count; ++r) {
            const Double5& x = forces.rays()[r];
            const double v = dot(c.separation, x);
            if (!pushes_at(r) || v < -c.separation_error) continue;  // open, or exactly 0
            // A v that is rounded to the wrong side of 0 is within the error.
            bounds_[r] += alpha * std::max(0.0, v);
            errors_[r] += alpha_magnitude * magnitude_of(c.separation, x);
            acting_[r] = 1;
          }
        });
      }
    }
  }
  // A term has fewer than 64 roundings (alpha 16, v 8, sums of a group and products 16), and
  // each partial sum adds one, of which there are no more than contacts; u = 2^-53 < 1.2e-16
  // leaves room for second order.
  const double roundings = 64 + static_cast<double>(model_.contacts.size());
  constexpr double kUnitRoundoff = 1.2e-16;
  // An underflow, 2^-873 in a v, is at most 2^-620 in a term, of which there are fewer than
  // 2^40.
  constexpr double kUnderflow = 1e-150;
  bool certain = true;
  for (std::size_t r = 0; r < ray_count; ++r) {
    if (!forces.loaded(r) && !(acting_[r] > 0)) continue;  // g and h are exactly 0: barred
    const double bound = kUnitRoundoff * roundings * errors_[r] + kUnderflow;
    if (bounds_[r] > bound) return false;
    certain = certain && bounds_[r] < -bound;  // false also for NaN
  }
  if (!certain) return std::nullopt;
  return true;
}

std::optional<Row> TwistSearch::confirm(const Problem& problem, const Region& region,
                                        const RegionForces& forces, const Double3& twist,
                                        BranchWork& work, bool exactly) {
  std::vector<IntegerVector5> points;
  if (pull_ != nullptr) {
    for (const Ray& ray : forces.exact_rays()) points.push_back(ray.x);
  }
  const auto y =
      in_fewest_bits(twist, {3, 6, 10, 16, 24, 36, 50}, [&](const IntegerVector3& candidate) {
        if (pull_ != nullptr && !pull_->holds(candidate, points)) return false;
        const std::optional<bool> certain = certain_refutation(forces, in_doubles(candidate));
        if (!certain && !exactly) return false;
        if (certain) {
          if (*certain) ++work.filter_hits;
          return *certain;
        }
        const bool refuted = refutes(problem, region, TwistLeaf{row_of(candidate)});
        if (refuted) ++work.filter_misses;
        return refuted;
      });
  if (!y) return std::nullopt;
  for (const Integer& entry : *y) {
    if (entry.is_zero()) continue;
    work.largest_twist_bits =
        std::max<std::size_t>(work.largest_twist_bits, msb(abs(entry)) + 1);
  }
  return row_of(*y);
}

}  // namespace stickslip::planar_detail
