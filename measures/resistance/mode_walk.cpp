// SPDX-License-Identifier: GPL-3.0-or-later
#include "mode_walk.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "stickslip/core/cancellation.hpp"
#include "tight_planes.hpp"

namespace stickslip::resistance_detail {
namespace {

/// The signs of a plane on a region, and whether it is 0 at some motion there.
struct RaySigns {
  bool positive = false;
  bool negative = false;
  bool zero_in_motion = false;  ///< at some motion but 0
};

class ModeWalk {
 public:
  ModeWalk(const Problem& problem, MotionRays& rays, const ModeImages& images,
           const ResistibleOptions& options, ResistibleWork& work, ModeSections& sections)
      : bilateral_(problem.law() == NormalLaw::kBilateral),
        contacts_(problem.size()),
        rays_(rays),
        images_(images),
        options_(options),
        work_(work),
        sections_(sections) {}

  /// Returns false if the limit on modes was exceeded.
  bool find() {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      WalkedRegion root;
      root.rays.push_back(rays_.rest());
      for (std::size_t a = 0; a < 4; ++a) {
        if (a == left_out) continue;
        root.rays.push_back(rays_.corner(a));
        for (std::size_t b = 0; b < a; ++b) {
          if (b != left_out) root.facets.push_back(rays_.wall(a, b));
        }
      }
      root.facets.push_back(rays_.infinity());
      root.separations.assign(contacts_, Known::kNothing);
      root.slips.assign(rays_.classes().size(), Known::kNothing);
      if (!visit(std::move(root))) return false;
    }
    return true;
  }

 private:
  double value(RayIndex ray, PlaneIndex plane) const { return rays_[ray].values[plane]; }

  RaySigns signs(const WalkedRegion& region, PlaneIndex plane) const {
    RaySigns result;
    bool zero_h = false;
    bool zero_beside_rest = false;
    for (const RayIndex ray : region.rays) {
      const double v = value(ray, plane);
      if (v > 0) result.positive = true;
      if (v < 0) result.negative = true;
      if (v == 0) {
        zero_h = zero_h || rays_[ray].h > 0;
        zero_beside_rest = zero_beside_rest || ray != rays_.rest();
      }
    }
    result.zero_in_motion = zero_h && zero_beside_rest;
    return result;
  }

  /// Returns true if some motion but 0 is in the region.
  bool has_motion(const WalkedRegion& region) const {
    const bool only_rest = region.rays.size() == 1 && region.rays.front() == rays_.rest();
    return !only_rest && std::any_of(region.rays.begin(), region.rays.end(),
                                     [&](RayIndex ray) { return rays_[ray].h > 0; });
  }

  /// Returns the part of the region in a plane that does not cut it.
  WalkedRegion face(const WalkedRegion& region, PlaneIndex plane) const {
    WalkedRegion result = region;
    result.rays.erase(std::remove_if(result.rays.begin(), result.rays.end(),
                                     [&](RayIndex ray) { return value(ray, plane) != 0; }),
                      result.rays.end());
    return result;
  }

  bool may_have_friction(const WalkedRegion& region, std::size_t slip_class) const {
    const std::vector<std::size_t>& contacts = rays_.classes()[slip_class].contacts;
    return std::any_of(contacts.begin(), contacts.end(), [&](std::size_t i) {
      return region.separations[i] != Known::kNegative;
    });
  }

  /// Sets the separations that are known; closed is >= 0 throughout and > 0 somewhere. Returns
  /// false if the region has no motion, or if the bilateral law allows none of its motions.
  bool settle_separations(WalkedRegion& region) const {
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (region.separations[i] == Known::kNegative) continue;
      const RaySigns s = signs(region, rays_.separation(i));
      if (bilateral_ && s.negative && !s.positive) {
        region = face(region, rays_.separation(i));
        return has_motion(region) && settle_separations(region);
      }
      if (!s.positive) region.separations[i] = Known::kNegative;
      if (s.positive && !s.negative) region.separations[i] = Known::kPositive;
    }
    return has_motion(region);
  }

  /// Returns true if n < 0, or n > 0, for all loads of all motions of the region but those
  /// without force.
  bool is_beside_plane(const WalkedRegion& region) {
    for (const int side : {-1, 1}) {
      bool beside = true;
      bool free_motion = false;
      bool zero_with_force = false;
      for (const RayIndex ray : region.rays) {
        const NearNumber bound = largest_across(region, ray, side);
        const std::optional<int> sign = bound.sign();
        if (sign && *sign < 0) continue;
        if (!sign || *sign > 0) {
          beside = false;
          break;
        }
        const MotionRay& motion = rays_[ray];
        if (!motion.is_free) zero_with_force = true;
        if (motion.h > 0) {
          if (!motion.is_free) beside = false;
          free_motion = true;
        }
      }
      if (!beside || (free_motion && zero_with_force)) continue;
      if (free_motion) sections_.add_free_motion();
      return true;
    }
    return false;
  }

  /// Returns a bound of side * n at a ray.
  NearNumber largest_across(const WalkedRegion& region, RayIndex ray, int side) const {
    const MotionRay& motion = rays_[ray];
    const auto turned = [&](const NearNumber& e) { return side > 0 ? e : -e; };
    NearNumber sum;
    if (motion.h != 0) sum = turned(images_.at_rest()[2]) * NearNumber{motion.h, kValueError};
    for (std::size_t i = 0; i < contacts_; ++i) {
      const double v = motion.values[rays_.separation(i)];
      if (v <= 0 || region.separations[i] == Known::kNegative) continue;
      const std::size_t c = rays_.class_of(i);
      const Known slip = c == MotionRays::kNoClass ? Known::kPositive : slips_now_[c];
      NearNumber across;
      if (slip == Known::kPositive || slip == Known::kNegative) {
        const int s = (slip == Known::kPositive ? 1 : -1) * rays_.sense(i);
        across = turned(images_.slipping(i, s > 0 ? 0 : 1)[2]);
      } else {
        const NearNumber a = turned(images_.slipping(i, 0)[2]);
        const NearNumber b = turned(images_.slipping(i, 1)[2]);
        across = {std::max(a.value, b.value), std::max(a.error, b.error)};
      }
      if (region.separations[i] == Known::kNothing && across.value < -across.error) continue;
      if (region.separations[i] == Known::kNothing && across.value < 0) {
        across = {0, across.error};
      }
      sum = sum + across * NearNumber{v, kValueError};
    }
    return sum;
  }

  /// Finds the slips that splits and rays tell. A class that is 0 at motions of the region is
  /// known only if a split says so.
  void find_slips(const WalkedRegion& region) {
    slips_now_ = region.slips;
    for (std::size_t c = 0; c < slips_now_.size(); ++c) {
      if (slips_now_[c] != Known::kNothing) continue;
      const RaySigns s = signs(region, rays_.slip(c));
      if (s.zero_in_motion || (s.positive && s.negative)) continue;
      slips_now_[c] = s.positive ? Known::kPositive : Known::kNegative;
    }
  }

  /// Returns the plane that cuts the region and leaves n most open; nothing at a mode.
  std::optional<PlaneIndex> plane_to_split(const WalkedRegion& region) const {
    std::optional<PlaneIndex> best;
    double most = -1;
    const auto consider = [&](PlaneIndex plane, double weight) {
      if (best && !(weight > most)) return;
      best = plane;
      most = weight;
    };
    std::vector<double> largest(contacts_, 0);
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (region.separations[i] == Known::kNegative) continue;
      double above = 0;
      double below = 0;
      for (const RayIndex ray : region.rays) {
        const double v = value(ray, rays_.separation(i));
        above = std::max(above, v);
        below = std::max(below, -v);
      }
      largest[i] = above;
      if (region.separations[i] != Known::kNothing) continue;
      const double across = std::max(std::fabs(images_.slipping(i, 0)[2].value),
                                     std::fabs(images_.slipping(i, 1)[2].value));
      consider(rays_.separation(i), std::min(above, below) * across);
    }
    for (std::size_t c = 0; c < region.slips.size(); ++c) {
      if (region.slips[c] != Known::kNothing || !may_have_friction(region, c)) continue;
      const RaySigns s = signs(region, rays_.slip(c));
      if (!s.positive || !s.negative) continue;
      double weight = 0;
      for (const std::size_t i : rays_.classes()[c].contacts) {
        weight += largest[i] *
                  std::fabs(images_.slipping(i, 0)[2].value - images_.slipping(i, 1)[2].value);
      }
      consider(rays_.slip(c), weight);
    }
    return best;
  }

  /// Returns false if the limit on modes was exceeded.
  bool visit(WalkedRegion region) {
    throw_if_cancelled();
    ++work_.nodes;
    if (!settle_separations(region)) return true;
    for (std::size_t c = 0; c < region.slips.size(); ++c) {
      if (region.slips[c] == Known::kZero && !may_have_friction(region, c)) return true;
    }
    find_slips(region);
    if (is_beside_plane(region)) return true;
    const std::optional<PlaneIndex> plane = plane_to_split(region);
    if (!plane) return visit_mode(std::move(region));
    std::vector<TightPlanes> tight;
    for (const RayIndex ray : region.rays) tight.push_back(tight_at(rays_, ray, region.facets));
    std::vector<RayIndex> on;
    WalkedRegion above = region;
    WalkedRegion below = region;
    above.rays.clear();
    below.rays.clear();
    for (std::size_t a = 0; a < region.rays.size(); ++a) {
      const double at_a = value(region.rays[a], *plane);
      if (at_a == 0) on.push_back(region.rays[a]);
      if (at_a > 0) above.rays.push_back(region.rays[a]);
      if (at_a < 0) below.rays.push_back(region.rays[a]);
      if (!(at_a > 0)) continue;
      for (std::size_t b = 0; b < region.rays.size(); ++b) {
        if (!(value(region.rays[b], *plane) < 0) || !are_neighbours(tight, a, b)) continue;
        on.push_back(rays_.between(region.rays[a], region.rays[b], *plane));
      }
    }
    WalkedRegion between = region;
    between.rays = on;
    above.rays.insert(above.rays.end(), on.begin(), on.end());
    below.rays.insert(below.rays.end(), on.begin(), on.end());
    const bool is_slip = *plane >= rays_.slip(0);
    const std::size_t index = is_slip ? *plane - rays_.slip(0) : *plane;
    std::vector<Known>& of_above = is_slip ? above.slips : above.separations;
    std::vector<Known>& of_below = is_slip ? below.slips : below.separations;
    of_above[index] = Known::kPositive;
    of_below[index] = Known::kNegative;
    for (WalkedRegion* part : {&above, &below, &between}) {
      if (part != &between) part->facets.push_back(*plane);
      drop_far_planes(*part);
    }
    region = {};
    if (!visit(std::move(above))) return false;
    if ((is_slip || !bilateral_) && !visit(std::move(below))) return false;
    if (!is_slip) return true;
    between.slips[index] = Known::kZero;
    return visit(std::move(between));
  }

  /// Drops the planes that no ray of the region is on: they are no facets.
  void drop_far_planes(WalkedRegion& region) const {
    std::vector<PlaneIndex>& planes = region.facets;
    planes.erase(std::remove_if(planes.begin(), planes.end(),
                                [&](PlaneIndex plane) {
                                  return std::none_of(
                                      region.rays.begin(), region.rays.end(),
                                      [&](RayIndex ray) { return value(ray, plane) == 0; });
                                }),
                 planes.end());
  }

  /// Visits a region that no plane cuts any more. Returns false if the limit on modes was
  /// exceeded.
  bool visit_mode(WalkedRegion region) {
    ++work_.modes;
    if (options_.mode_limit != 0 && work_.modes > options_.mode_limit) return false;
    if (options_.progress) options_.progress(work_.modes);
    std::vector<Known> slips = region.slips;
    std::vector<WalkedRegion> faces;
    for (std::size_t c = 0; c < slips.size(); ++c) {
      if (!may_have_friction(region, c)) continue;
      if (slips[c] == Known::kNothing) {
        const RaySigns s = signs(region, rays_.slip(c));
        slips[c] = s.positive ? Known::kPositive : s.negative ? Known::kNegative : Known::kZero;
        if (slips[c] != Known::kZero && s.zero_in_motion) {
          faces.push_back(face(region, rays_.slip(c)));
          faces.back().slips[c] = Known::kZero;
        }
      }
    }
    region.slips = std::move(slips);
    sections_.add(region);
    for (WalkedRegion& part : faces) {
      if (!settle_separations(part)) continue;
      std::sort(part.rays.begin(), part.rays.end());
      if (faces_seen_.insert(part).second && !visit(std::move(part))) return false;
    }
    return true;
  }

  const bool bilateral_;
  const std::size_t contacts_;
  MotionRays& rays_;
  const ModeImages& images_;
  const ResistibleOptions& options_;
  ResistibleWork& work_;
  ModeSections& sections_;
  std::vector<Known> slips_now_;  ///< the slips of the region at hand
  std::set<WalkedRegion> faces_seen_;
};

}  // namespace

bool walk_modes(const Problem& problem, MotionRays& rays, const ModeImages& images,
                const ResistibleOptions& options, ResistibleWork& work,
                ModeSections& sections) {
  return ModeWalk(problem, rays, images, options, work, sections).find();
}

}  // namespace stickslip::resistance_detail
