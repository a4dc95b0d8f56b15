// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/radius.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/box/effort.hpp"
#include "engine/box/examples.hpp"
#include "engine/box/short_numbers.hpp"
#include "engine/box/single_grasp.hpp"
#include "lost_loads.hpp"
#include "suspects.hpp"

namespace stickslip {

using namespace box_detail;
using namespace extent_detail;

namespace {

/// Returns the largest factor that leaves the box valid, or `most`.
Rational valid_limit(const GraspBox& centre, const GraspBox& box, const Rational& most) {
  Rational limit = most;
  // An end that must stay above 0 may not reach it.
  const Rational inside(1023, 1024);
  const auto keep = [&](const Rational& at, const Rational& low, bool may_reach) {
    if (low >= at) return;
    const Rational factor = at / (at - low);
    limit = std::min(limit, may_reach ? factor : Rational(factor * inside));
  };
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const UncertainContact& at = centre.contacts[i];
    keep(at.friction.low, c.friction.low, true);
    keep(at.preload.low, c.preload.low, true);
    keep(at.stiffness.low, c.stiffness.low, false);
    if (!c.slope.is_zero()) limit = std::min(limit, Rational(inside / c.slope));
  }
  for (std::size_t i = 0; i < box.springs.size(); ++i) {
    const Spring& spring = box.springs[i];
    const Spring& at = centre.springs[i];
    keep(at.stiffness.low, spring.stiffness.low, !spring.is_ratchet());
    if (spring.is_ratchet()) keep(at.force.low, spring.force.low, true);
  }
  return limit;
}

/// A number with more bits is longer than any that doubles spell.
constexpr std::size_t kLongBits = 4096;

bool is_long(const Rational& x) {
  return !x.is_zero() && std::max(msb(abs(numerator(x))), msb(denominator(x))) > kLongBits;
}

/// Returns the double nearest to a long number, unless that is 0 or beyond doubles; other
/// numbers stay.
Rational shortened(const Rational& x) {
  if (!is_long(x)) return x;
  const double near = to_double(x);
  return std::isfinite(near) && near != 0 ? rational_from_double(near) : x;
}

/// Shortens each number, which keeps their order; nothing if that changes none.
std::optional<GraspBox> shortened(GraspBox box) {
  bool is_changed = false;
  const auto shorten = [&](Rational& x) {
    Rational near = shortened(x);
    is_changed = is_changed || near != x;
    x = std::move(near);
  };
  for_each_number(box, [&](Interval& x) {
    shorten(x.low);
    shorten(x.high);
  });
  for (UncertainContact& c : box.contacts) {
    for (Rational& x : c.normal) shorten(x);
    shorten(c.slope);
  }
  return is_changed ? std::optional(std::move(box)) : std::nullopt;
}

class RadiusSearch {
 public:
  RadiusSearch(const GraspBox& centre, const GraspBox& box, NormalLaw law,
               const RadiusOptions& options, const std::function<void(const Radius&)>& progress)
      : centre_(centre),
        box_(box),
        law_(law),
        options_(options),
        progress_(progress),
        effort_(effort_for(box)) {}

  Radius run() {
    result_.limit = valid_limit(centre_, box_, options_.most);
    result_.stable = is_stable(centre_, law_, options_.box);
    if (!result_.stable || (options_.only_stable && !*result_.stable)) return result_;
    report();
    if (box_.ball && !effort_.decides_singles) {
      auto lost = LostLoads::of(centre_, box_, law_, options_.accuracy, result_.limit);
      if (lost) lost_.emplace(std::move(*lost));
    }
    refute();
    ask_whole();
    if (result_.is_on_threshold()) return result_;
    prove(0);
    if (effort_.cuts_boxes) prove(kMostParts);
    if (effort_.decides_singles && is_much_open() && options_.box.node_limit == 0) {
      options_.box.node_limit = kPatience * effort_.nodes;
      prove(0);
    }
    return result_;
  }

  /// Returns the same radii from those that another search found for numbers near these: a few
  /// proofs in place of many.
  Radius confirm(const RadiusSearch& near) {
    result_.limit = valid_limit(centre_, box_, options_.most);
    result_.stable = is_stable(centre_, law_, options_.box);
    if (!result_.stable || result_.stable != near.result_.stable) return result_;
    const Rational step = options_.accuracy / 8;
    const Radius& found = near.result_;
    if (found.refuted && !near.example_place_.empty()) {
      for (const int steps : {0, 1, 4, 16}) {
        const Rational factor = *found.refuted * (1 + steps * step);
        if (factor <= result_.limit && differs(near.example_place_, factor)) break;
      }
    }
    if (found.proved.is_zero()) return result_;
    for (const Rational& part : {Rational(1), 1 - 4 * step, Rational(3, 4), Rational(1, 2)}) {
      const Rational factor = found.proved * part;
      const bool may_hold = factor < bound() || (!result_.refuted && factor == bound());
      if (may_hold && (try_to_prove(factor, 0) || try_to_prove(factor, kMostParts))) break;
    }
    return result_;
  }

 private:
  static constexpr std::size_t kMostParts = 16;
  /// How many times as many nodes a proof may take where much is open without them.
  static constexpr std::size_t kPatience = 4;
  /// So many loads that are held are decided before others are tried.
  static constexpr std::size_t kMostHeld = 4;

  /// Asks decide_box() about the box that was given, if no counterexample in it is known, and
  /// then about smaller ones while two of their grasps differ: a radius knows no less than a
  /// verdict.
  void ask_whole() {
    Rational factor = std::min(Rational(1), result_.limit);
    while (!box_.ball && factor < bound() && factor >= kLeastFactor) {
      BoxDecision decision = decide_box(box_.scaled(centre_, factor), law_, options_.box);
      if (auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
        const GraspBox box = box_.scaled(centre_, factor);
        result_.refuted = factor;
        result_.example = std::move(*result_.stable ? fragile->unstable : fragile->stable);
        example_place_ = Examples(box, law_).place_of(*result_.example).value_or(Place());
        report();
        if (!example_place_.empty()) close_in(example_place_, 0, factor);
        flip_ends();
        factor = *result_.refuted * Rational(1, 16);
        continue;
      }
      if (is_stable(decision.verdict) == result_.stable) accept(factor, std::move(decision));
      return;
    }
  }

  void accept(const Rational& factor, BoxDecision decision) {
    result_.proved = factor;
    result_.proof = std::move(decision);
    report();
  }

  /// Returns true if the grasp at a place of the box of this factor has the other verdict.
  /// Remembers it if the factor is smaller than the known one.
  bool differs(const Place& place, const Rational& factor) {
    const GraspBox box = box_.scaled(centre_, factor);
    GraspBox grasp = Examples(box, law_).at(place);
    const std::optional<bool> stable = is_stable(grasp, law_, seeking());
    if (!stable || stable == result_.stable) return false;
    if (!result_.refuted || factor < *result_.refuted) {
      result_.refuted = factor;
      result_.example = std::move(grasp);
      example_place_ = place;
      report();
    }
    return true;
  }

  /// Seeks counterexamples: suspects near the centre, and then those at the edge of the box
  /// that these give.
  void refute() {
    if (*result_.stable) try_weak_corners();
    if (box_.ball) {
      if (*result_.stable) refute_ball();
      return;
    }
    if (result_.refuted) return flip_ends();
    suspect(std::min(Rational(1, 8), result_.limit));
    if (result_.refuted) {
      suspect(*result_.refuted);
    } else {
      suspect(std::min(Rational(1), result_.limit));
    }
    try_all_corners();
    flip_ends();
  }

  /// Moves one number of the counterexample at a time to another end, while that brings it
  /// nearer.
  void flip_ends() {
    if (!effort_.decides_singles || example_place_.empty()) return;
    constexpr int kMostRounds = 4;
    bool found = true;
    for (int round = 0; found && round < kMostRounds; ++round) {
      found = false;
      for (std::size_t n = 0; n < example_place_.size(); ++n) {
        Place place = example_place_;
        place[n] = place[n].sign() > 0 ? -1 : 1;
        const Rational near = below_bound();
        if (!differs(place, near)) continue;
        close_in(place, 0, near);
        found = true;
      }
    }
  }

  /// Tries the weakest corners of the smallest box, about, that has corners at which an
  /// equilibrium of the centre is lost.
  void try_weak_corners() {
    const std::vector<NearEquilibrium> here =
        equilibria_in_doubles(GraspLaw(centre_, law_).middle(), needs_enclosure(centre_));
    if (here.empty()) return;
    Rational size(1, 16);
    for (;;) {
      size = std::min(Rational(4 * size), bound());
      const GraspBox box = box_.scaled(centre_, size);
      std::vector<Place> lost;
      Examples(box, law_).visit_weak_corners(here.front(), [&](const Place& place) {
        constexpr std::size_t kMostTried = 4;
        lost.push_back(place);
        return lost.size() < kMostTried;
      });
      for (const Place& place : lost) {
        const Rational near = std::min(size, below_bound());
        if (lost_ && !lost_->has_none({place, near})) continue;
        if (differs(place, near)) close_in(place, 0, near);
      }
      if (size == bound() || !lost.empty()) return;
    }
  }

  /// Tries all corners, if the numbers are few.
  void try_all_corners() {
    const std::size_t numbers = Examples(box_, law_).middle().size();
    constexpr std::size_t kFew = 6;
    if (numbers > kFew) return;
    for (std::size_t corner = 0; corner < std::size_t{1} << numbers; ++corner) {
      Place place;
      for (std::size_t n = 0; n < numbers; ++n)
        place.push_back((corner >> n & 1) == 0 ? -1 : 1);
      const Rational near = below_bound();
      if (differs(place, near)) close_in(place, 0, near);
    }
  }

  /// Closes in on where this corner begins to differ, below `high`, where it does.
  void close_in(const Place& place, Rational low, Rational high) {
    while (high - low > options_.accuracy / 8 * high && high > kLeastFactor) {
      const Rational middle = short_middle(low, high);
      (differs(place, middle) ? high : low) = middle;
    }
  }

  /// Seeks a load of a ball that is too much, as near as may be, along axes and between them.
  /// Then turns it to where the border is nearer.
  void refute_ball() {
    if (lost_) return seek_in_doubles();
    const std::vector<Place> starts = Examples(box_, law_).ball_directions();
    Rational farthest = bound();
    constexpr int kMostSizes = 6;
    for (int size = 0; size < kMostSizes; ++size) {
      for (const Place& place : starts) {
        const Rational near = std::min(farthest, bound()) * (1 - options_.accuracy / 4);
        if (differs(place, near)) close_in(place, 0, near);
      }
      if (result_.refuted) break;
      farthest /= 4;
    }
    turn_to_normals();
    if (turn_nearby()) turn_to_normals();
  }

  /// Seeks with doubles, which say which load is worth a decision, as decisions take long here:
  /// along axes and between them, then at random, from far out inwards.
  void seek_in_doubles() {
    std::vector<Suspect> suspects;
    for (const Place& place : Examples(box_, law_).ball_directions()) {
      if (auto found = lost_->first_along(place)) suspects.push_back(std::move(*found));
    }
    std::stable_sort(suspects.begin(), suspects.end(),
                     [](const Suspect& a, const Suspect& b) { return a.factor < b.factor; });
    decide_suspects(std::move(suspects), 3);
    if (!result_.refuted) {
      lost_->look_longer();
      Rational farthest = below_bound();
      constexpr int kMostSizes = 3;
      for (int size = 0; size < kMostSizes && !result_.refuted; ++size) {
        decide_suspects(lost_->at_random(farthest), 1);
        farthest /= 8;
      }
    }
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds && result_.refuted; ++round) {
      const Rational before = *result_.refuted;
      std::size_t held = 0;
      for (const Place& place : along_normals()) {
        Suspect suspect{place, below_bound()};
        if (!lost_->contains(suspect)) continue;
        lost_->draw_in(suspect);
        if (confirm(suspect, bound())) {
          descend(suspect);
        } else if (lost_->looks_longer() && ++held == kMostHeld) {
          return;
        }
      }
      if (*result_.refuted == before || lost_->looks_longer()) break;
    }
  }

  /// Decides loads that doubles find to be too much, drawn in to where that begins, and turns
  /// so many of those that are to where the border is nearer.
  void decide_suspects(std::vector<Suspect> suspects, std::size_t most_descents) {
    constexpr std::size_t kMostTried = 16;
    std::size_t tried = 0;
    std::size_t descents = 0;
    for (Suspect& suspect : suspects) {
      if (tried++ == kMostTried || descents == most_descents) break;
      if (tried > kMostHeld && !result_.refuted) break;
      if (result_.refuted && suspect.factor > 2 * bound()) break;
      lost_->draw_in(suspect);
      if (!confirm(suspect, 2 * bound())) continue;
      ++descents;
      descend(suspect);
    }
  }

  /// Turns the suspect by smaller and smaller steps to where the border is nearer. A suspect
  /// that is not confirmed is forgotten.
  void descend(Suspect suspect) {
    const int last = lost_->looks_longer() ? 4 : 64;
    for (int steps = 2; steps <= last; steps *= 2) {
      const Suspect before = suspect;
      constexpr int kMostRounds = 12;
      bool found = true;
      for (int round = 0; found && round < kMostRounds; ++round) {
        found = false;
        for (const Place& place :
             Examples(box_, law_).turned(suspect.place, Rational(1, steps))) {
          Suspect nearer{place, suspect.factor * (1 - options_.accuracy / 4)};
          if (!lost_->contains(nearer)) continue;
          lost_->draw_in(nearer);
          suspect = std::move(nearer);
          found = true;
        }
      }
      const bool is_turned = suspect.place != before.place;
      if (is_turned && suspect.factor < bound() && !confirm(suspect, bound())) suspect = before;
    }
  }

  /// Returns true if the suspect, or another a little beyond it, is decided to be too much.
  /// What is farthest comes first: if that is held, so mostly is what is nearer, and decisions
  /// of loads that are held take longest.
  bool confirm(const Suspect& suspect, const Rational& most) {
    const auto at = [&](const Rational& beyond) {
      return Rational(suspect.factor * (1 + beyond * options_.accuracy));
    };
    const auto is_too_much = [&](const Rational& beyond) {
      const Rational factor = at(beyond);
      return factor < most && lost_->has_none({suspect.place, factor}) &&
             differs(suspect.place, factor);
    };
    const Rational farthest = 2;
    const bool is_confirmed = is_too_much(farthest);
    if (!is_confirmed && at(farthest) < most) return false;
    if (is_confirmed && lost_->looks_longer()) return true;
    return is_too_much(0) || is_too_much(Rational(1, 4)) || is_confirmed;
  }

  /// Returns the limits of a decision of one grasp.
  SearchOptions seeking() const {
    SearchOptions options = options_.box;
    if (options.node_limit == 0) options.node_limit = effort_.nodes_of_single;
    return options;
  }

  /// Returns true if a way near that of the nearest load that is too much leads to a nearer
  /// one.
  bool turn_nearby() {
    bool is_nearer = false;
    for (int steps = 2; result_.example && steps <= 32; steps *= 2) {
      constexpr int kMostRounds = 6;
      bool found = true;
      for (int round = 0; found && round < kMostRounds; ++round) {
        found = false;
        for (const Place& place :
             Examples(box_, law_).turned(example_place_, Rational(1, steps))) {
          const Rational near = below_bound();
          if (!differs(place, near)) continue;
          close_in(place, 0, near);
          found = is_nearer = true;
          break;
        }
      }
    }
    return is_nearer;
  }

  /// Turns the way of a ball's load along the normals of the border at the nearest load that is
  /// known to be too much. The normals are the virtual twists that refute it.
  void turn_to_normals() {
    constexpr int kMostRounds = 12;
    for (int round = 0; round < kMostRounds && result_.example; ++round) {
      const Rational before = *result_.refuted;
      for (const Place& place : along_normals()) {
        const Rational near = below_bound();
        if (differs(place, near)) close_in(place, 0, near);
      }
      if (*result_.refuted == before) return;
    }
  }

  /// Returns the ways along the normals, those first along which the border is nearest, if it
  /// is flat.
  std::vector<Place> along_normals() const {
    const Verdict verdict = decide_box(*result_.example, law_, seeking()).verdict;
    const auto* unstable = std::get_if<Unstable>(&verdict);
    if (unstable == nullptr) return {};
    const BallPart ball = BallPart::all_of(box_);
    std::vector<std::pair<double, Row>> ways;
    for (const TreeNode& node : unstable->tree) {
      const auto* leaf = std::get_if<TwistLeaf>(&node);
      if (leaf == nullptr || is_zero(leaf->twist)) continue;
      Row way = negated(leaf->twist);
      Rational work = 0;
      for (std::size_t j = 0; j < way.size(); ++j) {
        work += Rational(way[j]) * (result_.example->wrench[j].low - box_.wrench[j].low);
      }
      const Rational most = ball.most_work(way);
      if (most.sign() > 0 && work.sign() > 0) {
        ways.emplace_back(to_double(work / most), std::move(way));
      }
    }
    std::sort(ways.begin(), ways.end());
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    constexpr std::size_t kMostTried = 8;
    if (ways.size() > kMostTried) ways.resize(kMostTried);
    std::vector<Place> places;
    const Examples examples(box_, law_);
    for (const auto& [near, way] : ways) {
      const Place along = examples.loaded_along({way.begin(), way.end()}, example_place_);
      places.push_back(along);
      if (effort_.decides_singles) continue;
      places.push_back(examples.between_loads(example_place_, along));
    }
    return places;
  }

  void suspect(const Rational& size) {
    const GraspBox box = box_.scaled(centre_, size);
    for (const Place& place : extent_detail::suspects(Examples(box, law_), *result_.stable)) {
      // The search goes outwards to the first box where this corner differs, and then inwards
      // to its edge.
      Rational low = 0;
      Rational high = std::min(size, bound());
      bool found = differs(place, high);
      while (!found && high < bound()) {
        low = high;
        high = std::min(Rational(2 * high), bound());
        found = differs(place, high);
      }
      if (found) close_in(place, low, high);
    }
  }

  /// Returns the factor from which on no factor is of interest.
  Rational bound() const { return result_.refuted ? *result_.refuted : result_.limit; }

  /// Returns a factor below that by so much that a counterexample there is worth having.
  Rational below_bound() const { return bound() * (1 - options_.accuracy / 4); }

  /// Returns whether what is proved is far from what is refuted.
  bool is_much_open() const { return 3 * result_.proved < 2 * bound(); }

  bool try_to_prove(const Rational& factor, std::size_t parts) {
    BoxDecision decision = prove_box(box_.scaled(centre_, factor), law_, options_.box, parts);
    if (is_stable(decision.verdict) != result_.stable) return false;
    accept(factor, std::move(decision));
    return true;
  }

  /// Tries factors from near the bound downwards, and then bisects between the largest proved
  /// one and the bound. A box without a proof may be part of a larger one that has one; so the
  /// search may miss some proofs, but what it finds is proved.
  void prove(std::size_t parts) {
    Rational high = bound();
    if (!result_.refuted) {
      if (result_.proved == high || try_to_prove(high, parts)) return;
    } else {
      const Rational near = high * (1 - options_.accuracy / 2);
      // A proof that fails may take long: a factor near the bound is tried only if one a little
      // below it has a proof.
      if (seeks_size()) {
        const Rational below = short_middle(high * Rational(80, 100), high * Rational(81, 100));
        if (!try_to_prove(below, parts)) high = below;
      }
      const bool is_first = parts == 0 || result_.proved.is_zero();
      if (is_first && high == bound() && try_to_prove(short_middle(near, high), parts)) return;
      // A smaller box may have no proof though a larger one has. While much is open that is
      // worth the tries.
      const bool is_worth_tries = is_much_open() && !seeks_size();
      Rational least_failed = high;
      for (const int percent : {95, 90, 80, 65}) {
        const Rational below = bound() * Rational(percent, 100);
        if (!is_worth_tries || below <= result_.proved) break;
        const Rational factor = short_middle(below, bound() * Rational(percent + 1, 100));
        if (try_to_prove(factor, parts)) {
          if (!effort_.retries) high = least_failed;
          break;
        }
        least_failed = factor;
      }
    }
    constexpr int kMostSteps = 10;
    const Rational fine = std::min(options_.accuracy, Rational(1, 50));
    for (int step = 0; step < kMostSteps; ++step) {
      const Rational& enough = is_much_open() ? fine : options_.accuracy;
      if (high - result_.proved <= enough * high) return;
      const Rational middle = between(result_.proved, high);
      if (!try_to_prove(middle, parts)) high = middle;
    }
  }

  /// Returns whether proofs that fail take long, and nobody knows the size of what has one. (Of
  /// hands some proofs near the bound come soon where smaller balls have none.)
  bool seeks_size() const { return lost_ && !box_.mechanism; }

  /// Returns a factor between those that are proved and not: if seeks_size(), their geometric
  /// mean.
  Rational between(const Rational& proved, const Rational& high) const {
    constexpr int kFar = 4;
    if (!seeks_size() || high < kFar * proved) return short_middle(proved, high);
    const double low = proved.is_zero() ? to_double(high) / 1024 : to_double(proved);
    const Rational mean = rational_from_double(std::sqrt(low * to_double(high)));
    return short_middle(mean * Rational(31, 32), mean);
  }

  void report() const {
    if (progress_) progress_(result_);
  }

  const GraspBox& centre_;
  const GraspBox& box_;
  NormalLaw law_;
  RadiusOptions options_;
  const std::function<void(const Radius&)>& progress_;
  Effort effort_;
  Radius result_;
  Place example_place_;            ///< the place of result_.example
  std::optional<LostLoads> lost_;  ///< of a ball where decisions of single grasps take long
};

}  // namespace

Radius find_radius(const GraspBox& centre, const GraspBox& box, NormalLaw law,
                   const RadiusOptions& options,
                   const std::function<void(const Radius&)>& progress) {
  RadiusSearch search(centre, box, law, options, progress);
  const std::optional<GraspBox> near_box = shortened(box);
  if (!near_box) return search.run();
  const GraspBox near_centre = shortened(centre).value_or(centre);
  const std::function<void(const Radius&)> nothing_yet;
  RadiusSearch near(near_centre, *near_box, law, options, nothing_yet);
  near.run();
  return search.confirm(near);
}

}  // namespace stickslip
