// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_prover.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/degree/exact_witness.hpp"
#include "engine/degree/prove_stable.hpp"
#include "engine/motion/dense.hpp"
#include "engine/search/exact_region.hpp"
#include "engine/search/law_forces.hpp"
#include "single_grasp.hpp"
#include "stickslip/engine/force_span.hpp"

namespace stickslip {
namespace {

/// Returns the motion, with 0 for what is rounding alone.
RationalRow motion_of(const Law& law, const NearEquilibrium& equilibrium) {
  RationalRow motion(law.motions);
  for (std::size_t j = 0; j < motion.size(); ++j) {
    const double d = equilibrium.motion[static_cast<Eigen::Index>(j)];
    constexpr double kNone = 1e-12;
    if (std::fabs(d) > kNone * law.reach) motion[j] = rational_from_double(d / law.unit(j));
  }
  return motion;
}

/// Returns whether some motion beside an equilibrium changes no force, though other forces of
/// these grasps would hold it: equilibria lie side by side then.
bool leaves_free(const GraspLaw& box, const RoundedGrasp& grasp, const NearEquilibrium& near) {
  std::vector<Reals> seen;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    if (!c.acts(near.normal[i])) continue;
    seen.push_back(c.normal);
    if (!(c.slope > 0)) continue;
    // Friction that slips does not see how fast.
    const Eigen::VectorXd slip = c.slip * near.motion;
    for (Eigen::Index k = 0; k < slip.size(); ++k) {
      Eigen::VectorXd across = Eigen::VectorXd::Unit(slip.size(), k);
      if (near.sticks[i] == 0) across -= slip[k] / slip.squaredNorm() * slip;
      seen.push_back(c.slip.transpose() * across);
    }
  }
  constexpr double kFlat = 1e-9;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(seen.size()), grasp.motions());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    rows.row(static_cast<Eigen::Index>(k)) = seen[k].transpose();
  }
  const Eigen::Index held = seen.empty() || !rows.allFinite() ? 0 : rank(rows, kFlat);
  return static_cast<std::size_t>(held) < ForceSpan(box).rank();
}

}  // namespace

BoxProver::BoxProver(GraspLaw box, const ProverLimits& limits, SearchWork& work)
    : whole_(std::move(box)),
      limits_(limits),
      work_(work),
      last_node_(work.nodes + limits.most_nodes) {}

std::optional<BoxProver::Verdict> BoxProver::prove() {
  if (!prove(whole_, middle_)) return std::nullopt;
  return verdict();
}

std::optional<BoxProver::Verdict> BoxProver::prove_in_parts(std::size_t most_parts) {
  limits_.most_parts = most_parts;
  limits_.examples_next = false;  // nothing waits any more
  if (far_middle_ && prove_near(whole_, whole_.middle(), *far_middle_)) {
    stable_ = true;
    return verdict();
  }
  if (!prove_halves(whole_, middle_)) return std::nullopt;
  return verdict();
}

BoxProver::Verdict BoxProver::verdict() {
  if (witness_) return Stable{std::move(*witness_), motion_};
  if (*stable_) return Stable{std::move(parts_), motion_};
  return Unstable{std::move(tree_)};
}

SearchReport BoxProver::report() const {
  const bool is_far = near_tree_.has_value() || end_ == SearchEnd::kUnbounded;
  return {end_,    limits_.node_limit, work_.nodes > last_node_, limits_.is_wide, is_far, near_,
          is_free_};
}

/// Proves the grasp stable by an equilibrium in the modes of this one; false if none was found.
bool BoxProver::prove_exactly(const GraspLaw& box, const NearEquilibrium& near) {
  witness_ = exact_witness(box, near);
  if (witness_ && !box.allows(witness_->twist)) witness_.reset();
  if (witness_) motion_ = witness_->twist;
  return witness_.has_value();
}

bool BoxProver::prove_near(const GraspLaw& box, const GraspLaw& middle,
                           const NearEquilibrium& near) {
  if (is_exact_ && prove_exactly(box, near)) return true;
  if (auto rest = prove_at_rest(box, near)) {
    if (parts_.empty()) motion_.assign(box.motions, 0);
    parts_.emplace_back(std::move(*rest));
    return true;
  }
  if (auto sticking = prove_sticking(box, near)) {
    if (parts_.empty()) motion_ = sticking->motion;
    parts_.emplace_back(std::move(*sticking));
    return true;
  }
  const DegreeLimits limits{limits_.wall_limit, last_node_, limits_.is_wide};
  auto proof = prove_by_degree(box, middle, near, limits, work_);
  if (!proof) {
    near_ = motion_of(box, near);
    is_free_ = leaves_free(box, rounded_middle(middle), near);
    if (is_free_) proof = prove_beside(box, middle, near, limits, work_);
  }
  if (!proof) return false;
  if (parts_.empty()) motion_ = motion_of(box, near);
  parts_.emplace_back(std::move(*proof));
  return true;
}

/// Proves all of the box stable or unstable; returns false if that failed. `near_middle`
/// becomes an equilibrium of the grasp in the middle, if one was found.
bool BoxProver::prove_whole(const GraspLaw& box, std::optional<NearEquilibrium>& near_middle) {
  ++work_.parts;
  const GraspLaw middle = box.middle();
  const RoundedGrasp grasp = rounded_middle(middle);
  const Newton newton(grasp);
  std::vector<Reals> tried;
  bool holds = false;
  // All of a box is hardly held by motions that turn on rounding: these say nothing about it.
  const auto is_far = [&](const NearEquilibrium& near) {
    return limits_.is_wide && box.max_motion.empty() &&
           box_detail::is_beyond(box, near, box.far_motion);
  };
  const auto try_near = [&](const NearEquilibrium& near, bool waits = false) {
    constexpr double kSame = 1e-6;
    for (const Reals& motion : tried) {
      if ((motion - near.motion).norm() <= kSame * near.motion.norm()) return false;
    }
    tried.push_back(near.motion);
    if (!box_detail::may_be_within(box, near)) return false;
    if (!near_middle && !is_far(near)) near_middle = near;
    if (waits && near_middle) {
      far_middle_ = near;
      return false;
    }
    return holds = prove_near(box, middle, near);
  };
  if (stable_ != true) {
    if (const std::optional<Row> unopposed = unopposed_twist(box)) {
      tree_.emplace_back(TwistLeaf{*unopposed});
      ++work_.nodes;
      ++work_.leaves;
      stable_ = false;
      return true;
    }
  }
  if (stable_ != false) {
    // Rest takes least, and what sticks needs no other equilibrium.
    if (limits_.rest_first) {
      for (const NearEquilibrium& near : newton.solve_from(0)) {
        if (try_near(near)) {
          stable_ = true;
          return true;
        }
      }
    }
    for (const NearEquilibrium& near :
         box_detail::equilibria_in_doubles(middle, !limits_.is_wide)) {
      if (try_near(newton.polish(near).value_or(near))) {
        stable_ = true;
        return true;
      }
    }
  }
  // The search below comes near what Newton's method missed, but not if geometry is uncertain:
  // no slip is 0 then for all of the box. So the middle is searched here.
  const bool may_miss = std::any_of(
      box.contacts.begin(), box.contacts.end(),
      [](const auto& c) { return c.slip_dimension() > 1 && !c.geometry_is_certain(); });
  if (stable_ != false && tried.empty() && may_miss) {
    Trees unused;
    LawSearch search(middle, nullptr, limits_.node_limit, work_);
    search.on_candidate([&](const NearEquilibrium& relaxed) {
      const auto found = newton.polish(relaxed);
      if (found) try_near(*found, limits_.examples_next);
      return found.has_value();
    });
    search.refute(MotionRegion::root(middle), unused);
    if (holds) {
      stable_ = true;
      return true;
    }
  }
  // No tree is about all of a wide box whose middle has an equilibrium.
  if (stable_ == true || (limits_.is_wide && near_middle)) return false;
  const std::size_t before = tree_.size();
  bool refuted = false;
  const auto take = [&](const NearEquilibrium& relaxed) {
    const auto found = newton.polish(relaxed);
    // Newton's method may not converge where equilibria lie side by side; a program may find
    // one.
    if (!found && is_exact_ && box.is_linear()) return holds = prove_exactly(box, relaxed);
    return found &&
           (try_near(*found) ||
            (limits_.is_wide && box_detail::may_be_within(box, *found) && !is_far(*found)));
  };
  const auto search_all = [&](bool exactly, bool keeps_near) {
    LawSearch search(box, nullptr, limits_.node_limit, work_);
    search.on_candidate(take);
    if (exactly) {
      search.on_doubt([&](const MotionRegion& region) -> std::optional<TreeNode> {
        auto found = decide_exactly(box, region);
        if (auto* node = std::get_if<TreeNode>(&found)) return std::move(*node);
        witness_ = std::move(std::get<ShareWitness>(found));
        motion_ = witness_->twist;
        holds = true;
        return std::nullopt;
      });
    }
    if (keeps_near) search.forces().keep_near();
    refuted = search.refute(MotionRegion::root(box), tree_);
    end_ = search.end();
    if (!refuted) tree_.erase(tree_.begin() + static_cast<std::ptrdiff_t>(before), tree_.end());
  };
  const bool may_be_far =
      box.max_motion.empty() && !box.far_motion.empty() && box.may_be_rounded();
  // The planes around near motions, one more than there are coordinates, multiply the corners
  // of all regions: many bodies are searched without them first, however far they move.
  constexpr std::size_t kFewMotions = 6;
  search_all(false, may_be_far && box.motions <= kFewMotions);
  const bool ended_by_limit = end_ == SearchEnd::kNodes;
  const bool is_lost = end_ == SearchEnd::kUnbounded || end_ == SearchEnd::kDepth ||
                       end_ == SearchEnd::kPlane || end_ == SearchEnd::kTwist ||
                       (ended_by_limit && limits_.is_default);
  if (!refuted && !holds && may_be_far && is_lost) {
    // All motions are searched together again if near ones take long as well.
    constexpr std::size_t kNearNodes = 400;
    LawSearch near(
        box, nullptr,
        limits_.is_default ? std::min(kNearNodes, limits_.node_limit) : limits_.node_limit,
        work_);
    near.on_candidate(take);
    refuted = refute_near_first(box, near);
    if (!refuted) tree_.erase(tree_.begin() + static_cast<std::ptrdiff_t>(before), tree_.end());
    const bool is_near_lost =
        near.end() == SearchEnd::kNodes || near.end() == SearchEnd::kPoints;
    if (!refuted && !holds && is_near_lost && !ended_by_limit) search_all(false, false);
  }
  const bool in_doubt =
      end_ == SearchEnd::kPlane || end_ == SearchEnd::kTwist || end_ == SearchEnd::kDepth;
  if (!refuted && !holds && in_doubt && is_exact_ && box.is_linear() &&
      box.max_motion.empty()) {
    search_all(true, false);
  }
  if (!refuted && !holds) return false;
  // (Another part may have been proved unstable.)
  if (stable_.value_or(holds) != holds) return false;
  stable_ = holds;
  return true;
}

/// Refutes near motions, which says whether the grasp holds within a bound, and then far ones,
/// beyond the planes of the simplex around the bound one after another.
bool BoxProver::refute_near_first(const GraspLaw& box, LawSearch& near) {
  MotionRegion region = MotionRegion::root(box);
  std::vector<MotionRegion> far;
  for (const Row& plane : simplex_planes(box.far_motion)) {
    std::vector<MotionRegion> both = region.halves(plane);
    tree_.emplace_back(PlaneCut{plane});
    far.push_back(std::move(both[1]));
    region = std::move(both[0]);
  }
  const auto first = static_cast<std::ptrdiff_t>(tree_.size());
  const bool is_near_refuted = near.refute(std::move(region), tree_);
  end_ = near.end();
  if (!is_near_refuted) return false;
  const bool is_whole = parts_.empty() && first == static_cast<std::ptrdiff_t>(far.size());
  if (is_whole) near_tree_.emplace(tree_.begin() + first, tree_.end());
  constexpr std::size_t kLeastFar = 100;
  const std::size_t most =
      limits_.is_default ? std::max(kLeastFar, near.nodes() / 4) : limits_.node_limit;
  LawSearch search(box, nullptr, most, work_);
  for (auto outside = far.rbegin(); outside != far.rend(); ++outside) {
    if (search.refute(std::move(*outside), tree_)) continue;
    end_ = search.end();
    return false;
  }
  return true;
}

bool BoxProver::prove(const GraspLaw& box, std::optional<NearEquilibrium>& middle) {
  const bool done = prove_whole(box, middle);
  if (limits_.is_wide) suspects_[middle ? 0 : 1] = place_of(box);
  return done || prove_halves(box, middle);
}

bool BoxProver::prove_halves(const GraspLaw& box,
                             const std::optional<NearEquilibrium>& middle) {
  if (suspects_[0] && suspects_[1]) return false;
  if (limits_.most_parts == 0 || work_.nodes > last_node_) return false;
  --limits_.most_parts;
  const auto cut = widest(box, middle);
  if (!cut) return false;
  parts_.emplace_back(*cut);
  tree_.emplace_back(*cut);
  const auto [low, high] = box.halves(*cut);
  std::optional<NearEquilibrium> middle_of_low;
  std::optional<NearEquilibrium> middle_of_high;
  return prove(low, middle_of_low) && prove(high, middle_of_high);
}

RationalRow BoxProver::place_of(const GraspLaw& part) const {
  RationalRow place;
  for (const ParameterId& id : whole_.parameters()) {
    const Interval& of = whole_.interval(id);
    const Rational middle = part.interval(id).middle();
    place.emplace_back(of.is_point() ? Rational(1, 2)
                                     : Rational((middle - of.low) / (of.high - of.low)));
  }
  return place;
}

/// Returns a cut in the middle of the interval that matters most, to its contact's force or to
/// the load.
std::optional<PartSplit> BoxProver::widest(const GraspLaw& box,
                                           const std::optional<NearEquilibrium>& near) const {
  std::optional<PartSplit> best;
  double most = 0;
  for (const ParameterId& id : box.parameters()) {
    const auto [parameter, i] = id;
    const Interval& interval = box.interval(id);
    double effect = to_double(interval.high - interval.low);
    if (parameter == Parameter::kWrench) {
      effect /= box.ball ? box.ball->unit(i) : box.unit(i);
    } else {
      const LawContact& c = box.contacts[i];
      const double size = c.size;
      const double preload = (c.preloads[0] + c.preloads[1]) / 2;
      // A contact that does not press here may press elsewhere.
      constexpr double kLittle = 1e-2;
      const double a = std::max(near ? near->normal[i] : preload, kLittle * box.force / size);
      const bool is_length = parameter == Parameter::kX || parameter == Parameter::kY ||
                             parameter == Parameter::kZ;
      if (const bool is_u = parameter == Parameter::kTurnU;
          is_u || parameter == Parameter::kTurnV) {
        const RationalRow& across = c.place->turns[is_u ? 0 : 1].direction;
        effect *= std::sqrt(to_double(dot(across, across) / c.squared_length));
      }
      if (parameter == Parameter::kPreload) {
        effect *= size;
      } else if (parameter == Parameter::kStiffness) {
        effect *= 2 * std::fabs(a - preload) * size / (c.stiffnesses[0] + c.stiffnesses[1]);
      } else {
        effect *= a * size / (is_length ? box.length : 1);
      }
    }
    if (!(effect > most)) continue;
    most = effect;
    best = PartSplit{parameter, i, interval.middle()};
  }
  return best;
}

}  // namespace stickslip
