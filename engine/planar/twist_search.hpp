// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The search for a virtual twist in double precision, the relaxed equilibrium that it leaves
/// when there is none, and the confirmation of a twist.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "engine/motion/nearest_wrench.hpp"
#include "region_forces.hpp"
#include "region_program.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/pull_rule.hpp"

namespace stickslip::planar_detail {

/// A motion in a region, and a twist on which its contacts do the most work.
struct PushedMotion {
  Double5 motion;  ///< the motion of a ray, times the weight
  Double3 twist;
  std::size_t ray;
  double weight;
};

/// A virtual twist along which every wrench of the region does negative work, or a relaxed
/// equilibrium.
struct SearchResult {
  bool separated = false;
  Double3 twist{};                   ///< the twist, if separated
  std::vector<PushedMotion> pushed;  ///< parts of the relaxed equilibrium, if not separated
  Double5 motion{};                  ///< the sum of the motions
};

/// The numbers a_i and b_i / mu_i of a relaxed equilibrium.
struct RelaxedForce {
  double normal = 0;
  double tangential = 0;
};

/// The place where a relaxed equilibrium breaks a law the most.
struct WidestGap {
  std::optional<ContactSplit> at;  ///< the split there; nothing if no law is broken noticeably
  double size = 0;                 ///< its size over the energy of the springs
};

class TwistSearch {
 public:
  /// Asks for the rule of the pull as well, if there is one (pull_rule.hpp).
  explicit TwistSearch(const DoubleModel& model, const PullRule* pull = nullptr)
      : model_(model), pull_(pull) {}

  /// Searches for a twist. Unless `precisely`, contacts of a group have the edges that are best
  /// in its middle: the result is about right, and costs O(groups rays) for each twist that is
  /// tried.
  SearchResult search(const RegionForces& forces, bool precisely, BranchWork& work);

  /// Returns the force of an undecided contact.
  RelaxedForce force(std::uint32_t contact, const ContactFreedom& freedom,
                     const SearchResult& found) const;

  /// Returns the separation, else the slip, whose law the relaxed equilibrium breaks with the
  /// most energy.
  WidestGap widest_gap(const RegionForces& forces, const SearchResult& found) const;

  /// Returns the twist rounded to the smallest integers that still refute the region. Where
  /// error bounds do not decide, it is tried exactly or, unless `exactly`, turned down.
  std::optional<Row> confirm(const Problem& problem, const Region& region,
                             const RegionForces& forces, const Double3& twist, BranchWork& work,
                             bool exactly = true);

 private:
  /// A wrench that entered the hull: the ray's, on the twist on which it was the worst.
  struct Support {
    double work;
    Double3 wrench;
    std::size_t ray;
    Double3 twist;
    bool against = false;  ///< it is a wrench that the pull excludes there
  };
  /// Upper bounds of the gaps by which contacts of a group break their laws.
  struct GapBounds {
    double separation = 0;
    double slip = 0;
  };
  /// The middle of an undecided group, side by side in memory with those of others.
  struct Middle {
    Double3 normal;
    Double3 friction;
    ContactFreedom freedom;

    /// Returns the edge on which friction works most, or 0 if the group does not count.
    double edge(const Double3& y) const {
      const double work = y[0] * friction[0] + y[1] * friction[1] + y[2] * friction[2];
      const double sigma = freedom.edge(work);
      if (freedom.is_closed()) return sigma;
      const double alpha =
          y[0] * normal[0] + y[1] * normal[1] + y[2] * normal[2] + sigma * work;
      return alpha > 0 ? sigma : 0;
    }
  };
  void list_middles(const RegionForces& forces);
  void scale_rays(const RegionForces& forces);
  std::pair<std::size_t, double> worst_ray(const RegionForces& forces, const Double3& twist,
                                           bool precisely);
  void add_undecided_bounds(const RegionForces& forces, const Double3& twist, bool precisely);
  Double3 wrench_at(const RegionForces& forces, const Double3& twist, std::size_t ray,
                    bool precisely) const;
  /// Visits what undecided contacts do most on a twist. Calls `on_group(blocks, sigma)` with
  /// the sums of a group that has one edge, or, unless `precisely`, is taken to have one; else
  /// it calls `on_contact(contact, sigma, alpha)` by contact.
  template <class OnGroup, class OnContact>
  void for_each_part(const RegionForces& forces, const Double3& twist, bool precisely,
                     const OnGroup& on_group, const OnContact& on_contact) const;
  /// Calls `visit(contact, sigma, alpha)` for each contact of an undecided group that can work.
  template <class Visit>
  void for_each_working(const RegionForces& forces, const UndecidedGroup& u,
                        const Double3& twist, const Visit& visit) const;
  GapBounds gap_bounds(const ContactGroup& group, const ContactFreedom& freedom,
                       const SearchResult& found) const;
  double energy(const RegionForces& forces, const SearchResult& found) const;
  /// Returns whether g <= 0 with zeros only where nothing acts, if error bounds decide.
  std::optional<bool> certain_refutation(const RegionForces& forces, const Double3& twist);

  const DoubleModel& model_;
  const PullRule* pull_;
  std::vector<Middle> middles_;
  std::vector<double> bounds_;  ///< g(r)
  std::vector<double> acting_;  ///< above 0 where an undecided contact may act
  std::vector<double> errors_;  ///< magnitudes of g(r)'s terms
  std::vector<double> scales_;  ///< comparable sizes of wrenches, by ray
};

}  // namespace stickslip::planar_detail
