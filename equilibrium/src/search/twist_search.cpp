// SPDX-License-Identifier: GPL-3.0-or-later
#include "twist_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip::equilibrium_detail {
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

}  // namespace

void TwistSearch::find_work(const RayTable& table, const Double3& twist) {
  work_.resize(table.undecided().size());
  for (std::size_t b = 0; b < work_.size(); ++b) {
    const auto& [n, f, edge, any_edge, least] = table.undecided()[b];
    auto& [sigma, alpha, bound, share] = work_[b];
    const BlockDoubles friction = f[0] * twist[0] + f[1] * twist[1] + f[2] * twist[2];
    const BlockDoubles normal = n[0] * twist[0] + n[1] * twist[1] + n[2] * twist[2];
    alpha = normal + (edge * friction + any_edge * friction.abs());
    bound = alpha.max(least);
    for (std::size_t k = 0; k < kBlock; ++k) {
      sigma.data()[k] = friction.data()[k] >= 0 ? 1.0 : -1.0;
      share.data()[k] = alpha.data()[k] > least.data()[k] ? 1.0 : 0.0;
    }
    sigma = edge + any_edge * sigma;
  }
}

BlockDoubles TwistSearch::coefficients(const Node& node, const RayTable& table,
                                       std::size_t block, std::size_t ray) const {
  BlockDoubles v = BlockDoubles::Zero();
  const std::size_t begin = block * kBlock;
  const std::size_t end = std::min(begin + kBlock, node.undecided->size());
  for (std::size_t q = begin; q < end; ++q) v.data()[q - begin] = table.separation(q, ray);
  return work_[block].share * v.max(0.0);
}

/// Adds the undecided' parts to bounds_ and forces_.
void TwistSearch::add_undecided_bounds(const RayTable& table, const Double3& twist) {
  find_work(table, twist);
  for (std::size_t b = 0; b < table.block_count(); ++b) {
    const std::vector<BlockDoubles>& separations = table.separations(b);
    Eigen::Map<BlockDoubles> bounds(&bounds_[b * kBlock]);
    BlockDoubles sum = bounds;
    for (std::size_t q = 0; q < separations.size(); ++q) {
      sum += work_[q / kBlock].bound.data()[q % kBlock] * separations[q].max(0.0);
    }
    bounds = sum;
    if (table.block_is_loaded(b)) continue;
    Eigen::Map<BlockDoubles> forces(&forces_[b * kBlock]);
    sum = forces;
    for (std::size_t q = 0; q < separations.size(); ++q) {
      sum += work_[q / kBlock].share.data()[q % kBlock] * separations[q].max(0.0);
    }
    forces = sum;
  }
}

/// The wrench whose work on the twist of the last find_work is the bound at the ray.
Double3 TwistSearch::wrench_at(const Node& node, const RayTable& table, std::size_t ray) const {
  const Double5& x = table.rays()[ray];
  Double3 wrench{};
  for (std::size_t j = 0; j < 3; ++j) {
    wrench[j] = x[3] * model_.load[j] + x[4] * model_.growth[j];
    for (std::size_t k = 0; k < 5; ++k) wrench[j] += node.decided.value[j][k] * x[k];
  }
  for (std::size_t b = 0; b < work_.size(); ++b) {
    const BlockDoubles a = coefficients(node, table, b, ray);
    const UndecidedBlock& contacts = table.undecided()[b];
    for (std::size_t j = 0; j < 3; ++j) {
      const BlockDoubles terms =
          a * (contacts.normal[j] + work_[b].sigma * contacts.friction[j]);
      for (std::size_t k = 0; k < kBlock; ++k) wrench[j] += terms.data()[k];
    }
  }
  return wrench;
}

/// Rays are as long as their directions happen to be; their wrenches compare by force.
void TwistSearch::scale_rays(const Node& node, const RayTable& table) {
  const std::size_t ray_count = table.ray_count();
  scales_.assign(ray_count, 0.0);
  const Double3& u = model_.growth;
  const double growth = std::fabs(u[0]) + std::fabs(u[1]) + std::fabs(u[2]) / model_.length;
  for (std::size_t r = 0; r < ray_count; ++r) {
    const Double5& x = table.rays()[r];
    scales_[r] = std::fabs(x[3]) * model_.force + std::fabs(x[4]) * growth;
    for (std::size_t j = 0; j < 2; ++j) {
      double decided = 0;
      for (std::size_t k = 0; k < 5; ++k) decided += node.decided.value[j][k] * x[k];
      scales_[r] += std::fabs(decided);
    }
  }
  for (std::size_t b = 0; b < table.block_count(); ++b) {
    BlockDoubles sum = BlockDoubles::Zero();
    for (const BlockDoubles& v : table.separations(b)) sum += v.max(0.0);
    const std::size_t begin = b * kBlock;
    for (std::size_t r = begin; r < std::min(begin + kBlock, ray_count); ++r) {
      scales_[r] += sum.data()[r - begin];
    }
  }
  for (double& scale : scales_) {
    scale = std::max(scale, std::numeric_limits<double>::min()) / model_.force;
  }
}

/// The ray with the largest bound on the twist, by scale, and that bound.
std::pair<std::size_t, double> TwistSearch::worst_ray(const Node& node, const RayTable& table,
                                                      const Double3& twist) {
  const std::size_t ray_count = table.ray_count();
  Double5 form{0, 0, 0, dot(model_.load, twist), dot(model_.growth, twist)};
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t j = 0; j < 3; ++j) form[k] += twist[j] * node.decided.value[j][k];
  }
  bounds_.assign(table.block_count() * kBlock, 0.0);
  forces_.assign(table.block_count() * kBlock, 0.0);
  for (std::size_t r = 0; r < ray_count; ++r) bounds_[r] = dot(form, table.rays()[r]);
  add_undecided_bounds(table, twist);
  std::pair<std::size_t, double> worst{ray_count, -HUGE_VAL};
  for (std::size_t r = 0; r < ray_count; ++r) {
    // Where nothing acts, g and h are 0: the ray is barred.
    if (!table.loaded(r) && !(forces_[r] > 0)) continue;
    const double bound = bounds_[r] / scales_[r];
    if (bound > worst.second) worst = {r, bound};
  }
  return worst;
}

/// The motion and forces whose wrenches make up the nearest point.
void TwistSearch::combine(const Node& node, const RayTable& table,
                          const std::vector<std::pair<double, Support>>& parts,
                          SearchResult& result) {
  const std::size_t count = node.undecided->size();
  result.normal.assign(count, 0.0);
  result.tangential.assign(count, 0.0);
  for (const auto& [part, support] : parts) {
    if (support.against) continue;
    const double weight = part / scales_[support.ray];
    for (std::size_t j = 0; j < 5; ++j) {
      result.motion[j] += weight * table.rays()[support.ray][j];
    }
    find_work(table, support.twist);
    for (std::size_t b = 0; b < work_.size(); ++b) {
      const BlockDoubles a = weight * coefficients(node, table, b, support.ray);
      const BlockDoubles along = work_[b].sigma * a;
      for (std::size_t q = b * kBlock; q < std::min((b + 1) * kBlock, count); ++q) {
        result.normal[q] += a.data()[q % kBlock];
        result.tangential[q] += along.data()[q % kBlock];
      }
    }
  }
}

SearchResult TwistSearch::search(const Node& node, const RayTable& table, ConeWork& work) {
  ++work.searches;
  scale_rays(node, table);
  // In torques over the length.
  const double length = model_.length;
  const auto unscaled = [&](const Double3& y) -> Double3 {
    return {y[0], y[1], y[2] / length};
  };
  const Double3 start = unscaled(model_.start);
  std::vector<Double3> against;
  if (direction_ != nullptr) {
    for (const Ray& ray : table.exact_rays()) {
      against.push_back(direction_->against(ray.x, length));
    }
  }
  const auto found =
      nearest_wrench<3>({-start[0], -start[1], -start[2]}, [&](const Double3& y) {
        ++work.support_points;
        const Double3 twist = unscaled(y);
        const auto [ray, bound] = worst_ray(node, table, twist);
        Support support{bound, {}, ray, twist};
        if (bound >= 0) {
          support.wrench = unscaled(wrench_at(node, table, ray));
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
  } else {
    combine(node, table, found.parts, result);
  }
  return result;
}

std::optional<ContactSplit> TwistSearch::widest_gap(const Node& node,
                                                    const SearchResult& found) const {
  struct Widest {
    double gap = 0;
    std::optional<ContactSplit> split;

    void consider(double candidate_gap, ContactSplit candidate) {
      if (candidate_gap <= gap) return;
      gap = candidate_gap;
      split = candidate;
    }
  };
  Widest separation;
  Widest slip;
  double energy = 0;
  for (std::size_t q = 0; q < node.undecided->size(); ++q) {
    const UndecidedContact& u = (*node.undecided)[q];
    const ContactDoubles& c = model_.contacts[u.contact];
    const ContactId contact(u.contact);
    const double a = found.normal[q];
    energy += a * a / c.stiffness;
    if (u.slip == 0 && u.slip_cuts) {
      // mu a |tau| + b tau: the dissipation that is missing.
      double tau = 0;
      for (std::size_t j = 0; j < 3; ++j) tau += c.friction[j] * found.motion[j];
      slip.consider(a * std::fabs(tau) + found.tangential[q] * tau, SlipSplit{contact});
    }
    if (u.separation == Separation::kMixed) {
      // The search lets a be anything from 0 up; a = max(0, v) is the law.
      const double lawful = std::max(0.0, dot(c.separation, found.motion));
      separation.consider(std::fabs(a - lawful) * std::max(a, lawful) / c.stiffness,
                          SeparationSplit{contact});
    }
  }
  constexpr double kNoticeable = 1e-12;  // only chooses between a split and an exact program
  // Separation first: a contact that may open weakens the bound on every ray, and a tree that
  // splits these first is several times smaller (bench/README.md compares the rules).
  if (separation.gap > kNoticeable * energy) return separation.split;
  if (slip.gap > kNoticeable * energy) return slip.split;
  return std::nullopt;
}

std::optional<bool> TwistSearch::certain_refutation(const Node& node, const RayTable& table,
                                                    const Double3& twist) {
  if (!model_.is_moderate) return std::nullopt;
  const std::size_t ray_count = table.ray_count();
  const double load = dot(model_.load, twist);
  const double growth = dot(model_.growth, twist);
  double load_magnitude = 0;
  double growth_magnitude = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    load_magnitude += std::fabs(model_.load[j] * twist[j]);
    growth_magnitude += std::fabs(model_.growth[j] * twist[j]);
  }
  bounds_.assign(ray_count, 0.0);
  forces_.assign(ray_count, 0.0);
  errors_.assign(ray_count, 0.0);
  for (std::size_t r = 0; r < ray_count; ++r) {
    const Double5& x = table.rays()[r];
    bounds_[r] = x[3] * load + x[4] * growth;
    errors_[r] = std::fabs(x[3]) * load_magnitude + std::fabs(x[4]) * growth_magnitude;
    for (std::size_t k = 0; k < 5; ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        bounds_[r] += twist[j] * node.decided.value[j][k] * x[k];
        errors_[r] += std::fabs(twist[j] * x[k]) * node.decided.magnitude[j][k];
      }
    }
  }
  find_work(table, twist);
  for (std::size_t q = 0; q < node.undecided->size(); ++q) {
    const UndecidedContact& u = (*node.undecided)[q];
    const ContactDoubles& c = model_.contacts[u.contact];
    const double alpha_magnitude = magnitude_of(c, twist);
    const bool mixed = u.separation == Separation::kMixed;
    // alpha sums 6 products of factors rounded once: below 16 roundings of its magnitude.
    constexpr double kAlphaError = 2e-15;
    if (mixed && work_[q / kBlock].alpha.data()[q % kBlock] < -kAlphaError * alpha_magnitude)
      continue;
    const double alpha = work_[q / kBlock].bound.data()[q % kBlock];
    for (std::size_t r = 0; r < ray_count; ++r) {
      const double v = table.separation(q, r);
      if (!(v > 0)) continue;  // exactly 0, or open at this ray
      bounds_[r] += alpha * v;
      forces_[r] += v;
      errors_[r] += alpha_magnitude * magnitude_of(c.separation, table.rays()[r]);
    }
  }
  // A term has fewer than 64 roundings (alpha 16, v 8, aggregate and products 16), and
  // each partial sum adds one; u = 2^-53 < 1.2e-16 leaves room for second order.
  const double roundings =
      64 + static_cast<double>(node.decided.terms + node.undecided->size());
  constexpr double kUnitRoundoff = 1.2e-16;
  // What underflows, 2^-873 in a v, is at most 2^-620 in a term, of which there are fewer
  // than 2^40.
  constexpr double kUnderflow = 1e-150;
  bool certain = true;
  for (std::size_t r = 0; r < ray_count; ++r) {
    if (!table.loaded(r) && !(forces_[r] > 0)) continue;  // g and h are exactly 0: barred
    const double bound = kUnitRoundoff * roundings * errors_[r] + kUnderflow;
    if (bounds_[r] > bound) return false;
    certain = certain && bounds_[r] < -bound;  // false also for NaN
  }
  if (!certain) return std::nullopt;
  return true;
}

std::optional<VirtualWorkLeaf> TwistSearch::confirm(const Problem& problem, const Node& node,
                                                    const RayTable& table, const Double3& twist,
                                                    ConeWork& work, bool exactly) {
  std::vector<IntegerVector5> points;
  if (direction_ != nullptr) {
    for (const Ray& ray : table.exact_rays()) points.push_back(ray.x);
  }
  const auto y = in_fewest_bits<3>(
      twist, {3, 6, 10, 16, 24, 36, 50}, [&](const IntegerVector3& candidate) {
        if (direction_ != nullptr && !direction_->holds(candidate, points)) return false;
        const std::optional<bool> certain =
            certain_refutation(node, table, in_doubles(candidate));
        if (!certain && !exactly) return false;
        if (certain) {
          if (*certain) ++work.filter_hits;
          return *certain;
        }
        const bool refuted = refutes(problem, node.region, {candidate});
        if (refuted) ++work.filter_misses;
        return refuted;
      });
  if (!y) return std::nullopt;
  for (const Integer& entry : *y) {
    if (entry.is_zero()) continue;
    work.largest_twist_bits =
        std::max<std::size_t>(work.largest_twist_bits, msb(abs(entry)) + 1);
  }
  return VirtualWorkLeaf{*y};
}

}  // namespace stickslip::equilibrium_detail
