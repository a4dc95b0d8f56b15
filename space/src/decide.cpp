// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "equilibria.hpp"
#include "rest.hpp"
#include "spatial_degree.hpp"
#include "stickslip/equilibrium/search/search_end.hpp"
#include "stickslip/search/force_span.hpp"
#include "stickslip/search/tree_search.hpp"
#include "stickslip/space/spatial_verdict.hpp"

namespace stickslip {

using namespace space_detail;

const char* name_of(const SpatialVerdict& verdict) {
  constexpr const char* kNames[] = {"stable", "unstable", "fragile", "undecided"};
  return kNames[verdict.index()];
}

bool are_at_rest(const SpatialParts& parts) {
  return std::none_of(parts.begin(), parts.end(), [](const auto& part) {
    return std::holds_alternative<SpatialDegreeProof>(part);
  });
}

namespace {

/// Without what is rounding alone.
Vector6 motion_of(const SpaceModel& model, const NearEquilibrium& equilibrium) {
  Vector6 motion{};
  for (std::size_t j = 0; j < 6; ++j) {
    const double d = equilibrium.motion[static_cast<Eigen::Index>(j)];
    constexpr double kNone = 1e-12;
    if (std::fabs(d) > kNone * model.reach) {
      motion[j] = rational_from_double(d / (j < 3 ? 1 : model.length));
    }
  }
  return motion;
}

/// How an equilibrium of the middle moves as each number goes to its ends.
std::vector<EigenVector6> moves_within(const SpaceModel& box, const NearEquilibrium& near) {
  std::vector<EigenVector6> moves;
  for_each_parameter(box, [&](Parameter parameter, std::size_t i, const Interval& interval) {
    if (interval.is_point()) return;
    const auto [low, high] = box.halves({parameter, i, interval.middle()});
    for (const SpaceModel& half : {low, high}) {
      if (const auto there = NewtonMethod(half.at(0)).follow(near)) {
        moves.emplace_back(2 * (there->motion - near.motion));
      }
    }
  });
  return moves;
}

/// The grasp of a box in the middle of one of its parts.
SpatialGrasp grasp_in(const SpatialGrasp& box, const SpaceModel& whole,
                      const SpaceModel& part) {
  std::vector<Rational> middles;
  for_each_parameter(part, [&](Parameter, std::size_t, const Interval& interval) {
    middles.push_back(interval.middle());
  });
  std::size_t next = 0;
  for_each_parameter(whole, [&](Parameter, std::size_t, const Interval& interval) {
    Rational& middle = middles[next++];
    middle = interval.is_point()
                 ? Rational(1, 2)
                 : Rational((middle - interval.low) / (interval.high - interval.low));
  });
  SpatialGrasp grasp = box;
  next = 0;
  for_each_number(grasp, [&](const std::string& /*place*/, Interval& interval) {
    const Rational& at = middles[next++];
    interval = point_interval(interval.low + at * (interval.high - interval.low));
  });
  return grasp;
}

/// Proofs about a box and its parts, until one fails or two parts seem to differ.
class SpaceDecider {
 public:
  /// `question` and `work` must outlive this.
  SpaceDecider(const SpatialQuestion& question, const SpatialSearchOptions& options,
               std::size_t most_parts, SearchWork& work)
      : grasp_(question.grasp),
        whole_(question, options.bits),
        has_witness_(!question.is_box),
        is_wide_(!question.grasp.is_point()),
        node_limit_(options.node_limit != 0 ? options.node_limit
                    : is_wide_              ? kWideLimit
                                            : kDefaultLimit),
        parts_left_(most_parts),
        most_nodes_(work.nodes + kMostSearches * node_limit_),
        work_(work) {}

  bool prove() { return prove(whole_); }
  /// If that failed.
  SearchReport report() const {
    return {end_, node_limit_, work_.nodes > most_nodes_, is_wide_, near_};
  }
  /// Of grasps in the middle of parts that seem to be stable, and unstable; empty, or the last
  /// one of a kind.
  const std::array<std::optional<SpatialGrasp>, 2>& examples() const { return examples_; }
  /// Once that is done.
  SpatialVerdict verdict() && {
    if (witness_) return SpatiallyStable{std::move(*witness_), motion_};
    if (*stable_) return SpatiallyStable{std::move(parts_), motion_};
    return SpatiallyUnstable{std::move(tree_)};
  }

 private:
  bool prove(const SpaceModel& box);
  bool prove_whole(const SpaceModel& box, std::optional<NearEquilibrium>& near_middle);
  bool prove_stable_near(const SpaceModel& box, const SpaceModel& middle,
                         const NearEquilibrium& near);
  std::optional<PartSplit> widest(const SpaceModel& box,
                                  const std::optional<NearEquilibrium>& near) const;

  static constexpr std::size_t kDefaultLimit = 20000;
  /// A box that is wide may well be neither, which is to be said soon.
  static constexpr std::size_t kWideLimit = 1000;
  /// Of all trees together, beyond which a box is cut no more.
  static constexpr std::size_t kMostSearches = 4;

  const SpatialGrasp& grasp_;
  SpaceModel whole_;
  bool has_witness_;
  bool is_wide_;
  std::size_t node_limit_;  ///< of a tree
  std::size_t parts_left_;
  std::size_t most_nodes_;  ///< where the work of all is to end
  SearchWork& work_;
  std::array<std::optional<SpatialGrasp>, 2> examples_;
  std::optional<bool> stable_;  ///< what was proved of the first part
  std::optional<SpatialWitness> witness_;
  Vector6 motion_{};
  SpatialParts parts_;
  Trees tree_;
  SearchEnd end_ = SearchEnd::kNone;
  std::vector<Rational> near_;  ///< an equilibrium in doubles without a proof
};

bool SpaceDecider::prove_stable_near(const SpaceModel& box, const SpaceModel& middle,
                                     const NearEquilibrium& near) {
  if (has_witness_) {
    if ((witness_ = exact_witness(box, near))) {
      motion_ = witness_->twist;
      return true;
    }
  }
  if (auto rest = prove_at_rest(box, near)) {
    parts_.emplace_back(std::move(*rest));
    return true;
  }
  const std::size_t limit = std::max<std::size_t>(node_limit_ / (is_wide_ ? 8 : 24), 1);
  const std::vector<EigenVector6> moves =
      is_wide_ ? moves_within(box, near) : std::vector<EigenVector6>{};
  auto proof = prove_stable(box, middle, near, limit, most_nodes_, work_, moves);
  if (!proof) {
    const Vector6 motion = motion_of(box, near);
    near_.assign(motion.begin(), motion.end());
    return false;
  }
  if (parts_.empty()) motion_ = motion_of(box, near);
  parts_.emplace_back(std::move(*proof));
  return true;
}

/// Proves what it is of all of the box; false if that failed. `near_middle` becomes an
/// equilibrium of the grasp in the middle, if one was found.
bool SpaceDecider::prove_whole(const SpaceModel& box,
                               std::optional<NearEquilibrium>& near_middle) {
  ++work_.parts;
  const SpaceModel middle = box.at(0);
  const NewtonMethod newton(middle);
  std::vector<EigenVector6> tried;
  bool holds = false;
  const auto prove_near = [&](const NearEquilibrium& near) {
    constexpr double kSame = 1e-6;
    for (const EigenVector6& motion : tried) {
      if ((motion - near.motion).norm() <= kSame * near.motion.norm()) return false;
    }
    tried.push_back(near.motion);
    if (!near_middle) near_middle = near;
    return holds = prove_stable_near(box, middle, near);
  };
  const std::optional<Row> unopposed = stable_ != true ? unopposed_twist(box) : std::nullopt;
  if (unopposed) {
    tree_.emplace_back(TwistLeaf{*unopposed});
    ++work_.nodes;
    ++work_.leaves;
    stable_ = false;
    return true;
  }
  if (stable_ != false) {
    constexpr std::size_t kStarts = 3;
    for (const NearEquilibrium& near : newton.solve_from(kStarts)) {
      if (prove_near(near)) {
        stable_ = true;
        return true;
      }
    }
  }
  // There is an equilibrium in the middle of a wide box: no tree is about all of it.
  if (stable_ == true || (is_wide_ && !tried.empty())) return false;
  const std::size_t before = tree_.size();
  TreeSearch search(box, nullptr, node_limit_, work_);
  search.on_candidate([&](const RelaxedEquilibrium& relaxed) {
    const auto found = newton.polish(near(relaxed));
    return found && (prove_near(*found) || is_wide_);
  });
  const bool refuted = search.refute(MotionRegion::root(box), tree_);
  end_ = search.end();
  if (!refuted) tree_.erase(tree_.begin() + static_cast<std::ptrdiff_t>(before), tree_.end());
  if (!refuted && !holds) return false;
  // (Of another part it may have been proved that it is unstable.)
  if (stable_.value_or(holds) != holds) return false;
  stable_ = holds;
  return true;
}

bool SpaceDecider::prove(const SpaceModel& box) {
  std::optional<NearEquilibrium> near;
  const bool done = prove_whole(box, near);
  if (is_wide_) examples_[near ? 0 : 1] = grasp_in(grasp_, whole_, box);
  if (done) return true;
  if (examples_[0] && examples_[1]) return false;
  if (parts_left_ == 0 || work_.nodes > most_nodes_) return false;
  --parts_left_;
  const auto cut = widest(box, near);
  if (!cut) return false;
  parts_.emplace_back(*cut);
  tree_.emplace_back(*cut);
  const auto [low, high] = box.halves(*cut);
  return prove(low) && prove(high);
}

/// The middle of the interval that matters most: of its contact's force, or of the load.
std::optional<PartSplit> SpaceDecider::widest(
    const SpaceModel& box, const std::optional<NearEquilibrium>& near) const {
  std::optional<PartSplit> best;
  double most = 0;
  for_each_parameter(box, [&](Parameter parameter, std::size_t i, const Interval& interval) {
    double effect = to_double(interval.high - interval.low);
    if (parameter == Parameter::kWrench) {
      if (i >= 3) effect /= box.length;
    } else {
      const LawContact& c = box.contacts[i];
      const double size = std::sqrt(to_double(c.squared_length));
      const double preload = (c.preloads[0] + c.preloads[1]) / 2;
      // Where nothing presses, something may elsewhere.
      constexpr double kLittle = 1e-2;
      const double a = std::max(near ? near->normal[i] : preload, kLittle * box.force / size);
      if (parameter == Parameter::kPreload) {
        effect *= size;
      } else if (parameter == Parameter::kStiffness) {
        effect *= 2 * std::fabs(a - preload) * size / (c.stiffnesses[0] + c.stiffnesses[1]);
      } else {
        effect *= a * size / (parameter == Parameter::kFriction ? 1 : box.length);
      }
    }
    if (!(effect > most)) return;
    most = effect;
    best = PartSplit{parameter, i, interval.middle()};
  });
  return best;
}

/// A grasp of the box with all numbers where one would think that it holds better (more
/// friction and preload under less load), or worse.
SpatialGrasp extreme_of(SpatialGrasp box, bool better) {
  for_each_number(box, [&](const std::string& place, Interval& interval) {
    const auto is = [&](const char* name) { return place.find(name) != std::string::npos; };
    std::optional<bool> high;
    if (is("friction") || is("preload")) high = better;
    if (is("wrench")) high = better != (interval.middle().sign() > 0);
    interval = point_interval(!high ? interval.middle() : *high ? interval.high : interval.low);
  });
  return box;
}

/// Two grasps in the box with opposite verdicts.
class ExampleSearch {
 public:
  ExampleSearch(const SpatialQuestion& question, const SpatialSearchOptions& options,
                SearchWork& work)
      : law_(question.law), options_(options), work_(work) {}

  void try_grasp(const SpatialGrasp& grasp) {
    ++work_.examples;
    SpatialOptions as_it_stands;
    as_it_stands.law = law_;
    const SpatialDecision decision = decide(ask(grasp, as_it_stands), options_);
    work_ += decision.work;
    if (std::holds_alternative<SpatiallyStable>(decision.verdict)) stable_ = grasp;
    if (std::holds_alternative<SpatiallyUnstable>(decision.verdict)) unstable_ = grasp;
  }

  std::optional<SpatiallyFragile> found() const {
    if (!stable_ || !unstable_) return std::nullopt;
    return SpatiallyFragile{*stable_, *unstable_};
  }

 private:
  NormalLaw law_;
  const SpatialSearchOptions& options_;
  SearchWork& work_;
  std::optional<SpatialGrasp> stable_;
  std::optional<SpatialGrasp> unstable_;
};

}  // namespace

SpatialDecision decide(const SpatialQuestion& question, const SpatialSearchOptions& options) {
  SpatialDecision decision{Undecided{}, {}, options.bits};
  const bool is_wide = !question.grasp.is_point();
  ExampleSearch examples(question, options, decision.work);
  SearchReport report;
  constexpr std::size_t kMostParts = 32;
  for (const std::size_t most_parts : {std::size_t{0}, kMostParts}) {
    SpaceDecider decider(question, options, most_parts, decision.work);
    if (decider.prove()) {
      decision.verdict = std::move(decider).verdict();
      return decision;
    }
    report = decider.report();
    if (!is_wide) break;
    for (const auto& grasp : decider.examples()) {
      if (grasp) examples.try_grasp(*grasp);
    }
    for (const bool better : {false, true}) {
      if (most_parts == 0 && !examples.found()) {
        examples.try_grasp(extreme_of(question.grasp, better));
      }
    }
    if (auto fragile = examples.found()) {
      decision.verdict = std::move(*fragile);
      return decision;
    }
  }
  decision.verdict = undecided_by(report);
  return decision;
}

}  // namespace stickslip
