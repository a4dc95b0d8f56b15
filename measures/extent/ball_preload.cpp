// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "engine/box/effort.hpp"
#include "engine/box/examples.hpp"
#include "in_parallel.hpp"
#include "preload_boxes.hpp"
#include "preload_patterns.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace box_detail;
using namespace extent_detail;

namespace {

/// A box of preloads, and a load at a distance that all of them refuse.
struct BoundedBox {
  PreloadBox box;
  std::shared_ptr<const ProvedPreloads> refused{};  ///< perhaps about a box around this one
};

/// Boxes that cover all preloads of the budget, by the distance, largest first. Boxes without a
/// load come before all others.
using Cover = std::multimap<Rational, BoundedBox, std::greater<Rational>>;

class BallSearch {
 public:
  BallSearch(const GraspBox& grasp, NormalLaw law, const LoadBall& shape,
             const Rational& budget, const PreloadOptions& options,
             const std::function<void(const BallPreload&)>& progress)
      : grasp_(grasp),
        law_(law),
        shape_(shape),
        budget_(budget),
        options_(options),
        progress_(progress),
        patterns_(grasp, options.balanced, options.alike) {
    options_.box = of_many(options.box, grasp);
    shape_.radius = 1;
    GraspBox unit = grasp_;
    unit.ball = shape_;
    unit.check();
    const Examples examples(unit, law_);
    for (const Place& place : examples.ball_directions()) {
      directions_.push_back(beside(examples.at(place)));
    }
    most_ = 64 * (size_of(grasp_.wrench) + budget_);
  }

  BallPreload run() {
    result_.quality.ball = grasp_;
    result_.quality.ball.ball = shape_;
    report();
    std::vector<RationalRow> starts;
    if (patterns_.size() > 0) {
      starts.emplace_back(patterns_.size(), budget_ / patterns_.size());
    }
    const RationalRow given = preloads_of(grasp_);
    const std::optional<RationalRow> weights = patterns_.weights(given);
    if (const Rational sum = sum_of(given); !sum.is_zero() && weights) {
      starts.push_back(*weights);
      for (Rational& weight : starts.back()) weight *= budget_ / sum;
    }
    RationalRow best;
    Rational most = 0;
    for (const RationalRow& start : starts) {
      const Rational distance = distance_at(patterns_.preloads(start));
      if (distance <= most && !best.empty()) continue;
      most = distance;
      best = start;
    }
    if (!best.empty()) climb_and_take(std::move(best));
    bound();
    if (result_.quality.stable == true && !result_.quality.proved.is_zero()) {
      GraspBox held = result_.quality.ball;
      held.ball->radius = result_.quality.proved;
      result_.range = range_of({held}, law_, options_.box);
    }
    return std::move(result_);
  }

 private:
  /// Returns the load of a grasp less the load that is asked about.
  RationalRow beside(const GraspBox& loaded) const {
    RationalRow z;
    for (std::size_t j = 0; j < loaded.wrench.size(); ++j) {
      z.push_back(loaded.wrench[j].low - grasp_.wrench[j].low);
    }
    return z;
  }

  GraspBox loaded(const RationalRow& z, const Rational& distance) const {
    GraspBox grasp = grasp_;
    for (std::size_t j = 0; j < z.size(); ++j) {
      grasp.wrench[j] = point_interval(grasp.wrench[j].low + distance * z[j]);
    }
    return grasp;
  }

  bool resists(const RationalRow& preloads, const RationalRow& z,
               const Rational& distance) const {
    return seems_held(with_preloads(loaded(z, distance), preloads), law_, options_.box);
  }

  /// Returns a distance in this direction at which the load is not resisted, nearly the least;
  /// or `most` if the load at that distance is resisted.
  Rational distance_along(const RationalRow& preloads, const RationalRow& z,
                          Rational most) const {
    if (resists(preloads, z, most)) return most;
    const Rational least = most / (1 << 20);
    Rational high = std::move(most);
    Rational low = high / 2;
    while (high > least && !resists(preloads, z, low)) {
      high = low;
      low /= 2;
    }
    if (high <= least) return 0;
    while (high - low > options_.accuracy / 8 * high) {
      const Rational middle = rational_in_bits(to_double((low + high) / 2), 16);
      (resists(preloads, z, middle) ? low : high) = middle;
    }
    return high;
  }

  /// Returns the least distance over all directions, or one that is at most `enough`. A
  /// proposal: between two directions the distance may be less.
  Rational distance_at(const RationalRow& preloads, const Rational& enough = 0) const {
    if (!resists(preloads, directions_.front(), 0)) return 0;
    Rational least = most_;
    for (const RationalRow& z : directions_) {
      least = distance_along(preloads, z, std::move(least));
      if (least <= enough) break;
    }
    return least;
  }

  /// Moves a part of one weight to another, or leaves it out, in ever smaller steps.
  void climb(RationalRow& weights) const {
    Rational most = distance_at(patterns_.preloads(weights));
    std::size_t tries = effort_for(grasp_).tries_for_ball;
    for (Rational step = budget_ / 4; 16 * step > options_.accuracy * budget_;) {
      bool is_better = false;
      for (std::size_t i = 0; i < weights.size(); ++i) {
        for (std::size_t j = 0; j < weights.size() && !weights[i].is_zero(); ++j) {
          if (tries == 0) return;
          --tries;
          RationalRow other = weights;
          other[i] = std::max<Rational>(0, weights[i] - step);
          if (j != i) other[j] += weights[i] - other[i];
          const Rational distance = distance_at(patterns_.preloads(other), most);
          if (distance <= most) continue;
          most = distance;
          weights = std::move(other);
          is_better = true;
        }
      }
      if (!is_better) step /= 2;
    }
  }

  /// Improves the weights and keeps the ball that these preloads resist, if it is larger. The
  /// nearest load that is too much becomes a direction.
  void climb_and_take(RationalRow weights) {
    constexpr int kMostRounds = 4;
    for (int round = 0; round < kMostRounds; ++round) {
      climb(weights);
      const RationalRow preloads = patterns_.preloads(weights);
      QualityOptions search;
      search.radius.box = options_.box;
      search.radius.accuracy = options_.accuracy / 4;
      Quality quality = find_quality(with_preloads(grasp_, preloads), law_, shape_, search);
      const std::optional<GraspBox> example = quality.radii.example;
      const std::optional<Rational> refuted = quality.refuted;
      if (result_.preloads.empty() || quality.proved > result_.quality.proved) {
        result_.preloads = preloads;
        result_.quality = std::move(quality);
        report();
      }
      if (!example || !refuted) return;
      const Rational before = distance_at(preloads);
      RationalRow z = beside(*example);
      for (Rational& component : z) component /= *refuted;
      directions_.push_back(std::move(z));
      if (*refuted >= (1 - options_.accuracy / 2) * before) return;
    }
  }

  /// Looks for a load that all of a box refuse, nearer than the one that is known.
  void look(Rational& distance, BoundedBox& bounded, RationalRow& middle,
            Rational& at_middle) const {
    const PreloadBox box = below_sum(bounded.box, budget_);
    middle = middle_of(box);
    const auto refuse_at = [&](const RationalRow& z, const Rational& at) {
      const GraspBox load = loaded(z, at);
      if (!may_refuse(load, box, law_, options_.box)) return false;
      auto refused = refuse(load, box, law_, options_.box);
      if (!refused) return false;
      bounded.refused = std::make_shared<const ProvedPreloads>(std::move(*refused));
      distance = at;
      return true;
    };
    at_middle = resists(middle, directions_.front(), 0) ? most_ : Rational(0);
    if (at_middle.is_zero() && refuse_at(directions_.front(), 0)) return;
    // A load that all preloads of the box refuse is refused at these corners.
    const RationalRow high_one = high_corner(box);
    const RationalRow low_one = low_corner(box);
    std::vector<std::pair<Rational, const RationalRow*>> ways;
    for (const RationalRow& z : directions_) {
      const Rational most = std::min(most_, distance);
      Rational at = distance_along(middle, z, most);
      at_middle = std::min(at_middle, at);
      for (const RationalRow* preloads : {&high_one, &low_one}) {
        if (at < most) at = std::max(at, distance_along(*preloads, z, most));
      }
      if (at < most) ways.emplace_back(at, &z);
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    constexpr std::size_t kMostWays = 3;
    if (ways.size() > kMostWays) ways.resize(kMostWays);
    for (const auto& [at, z] : ways) {
      // Tries go from just above upwards, as far as a refusal is of use.
      Rational above = std::max<Rational>(at, most_ / 1024) / 32;
      while (at + above < distance && at + above < most_ && !refuse_at(*z, at + above)) {
        above *= 4;
      }
    }
  }

  void bound() {
    const Rational unknown = most_ + 1;
    Cover cover;
    cover.emplace(unknown,
                  BoundedBox{PreloadBox(grasp_.contacts.size(), Interval{0, budget_})});
    const std::size_t most_boxes = options_.most_boxes_of_ball();
    std::size_t count = 0;
    const auto is_of_interest = [&] {
      return cover.begin()->first > (1 + options_.accuracy) * result_.quality.proved;
    };
    int climbs = 0;
    while (count < most_boxes && is_of_interest()) {
      constexpr std::size_t kAtOnce = 8;  // the same on every machine
      std::vector<std::pair<Rational, BoundedBox>> boxes;
      while (!cover.empty() && boxes.size() < kAtOnce && is_of_interest()) {
        auto& [distance, first] = *cover.begin();
        // A box that has been looked at is cut.
        if (count == 0) {
          boxes.emplace_back(distance, std::move(first));
        } else {
          auto [low, high] = halves(below_sum(first.box, budget_));
          for (PreloadBox* half : {&low, &high}) {
            if (sum_of(low_corner(*half)) <= budget_) {
              boxes.emplace_back(distance, BoundedBox{std::move(*half), first.refused});
            }
          }
        }
        cover.erase(cover.begin());
      }
      count += boxes.size();
      std::vector<RationalRow> middles(boxes.size());
      RationalRow at_middles(boxes.size());
      in_parallel(boxes.size(), [&](std::size_t k) {
        look(boxes[k].first, boxes[k].second, middles[k], at_middles[k]);
      });
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        constexpr int kMostClimbs = 4;
        const Rational enough = (1 + options_.accuracy) * result_.quality.proved;
        if (patterns_.are_contacts() && climbs < kMostClimbs && sum_of(middles[k]) <= budget_ &&
            at_middles[k] > enough && distance_at(middles[k]) > enough) {
          ++climbs;
          climb_and_take(middles[k]);
        }
        cover.emplace(std::move(boxes[k].first), std::move(boxes[k].second));
      }
      result_.looked = count;
      if (cover.begin()->first < unknown) {
        result_.bound = cover.begin()->first;
        keep_refused(cover);
      }
      report();
    }
  }

  /// Keeps each box that some box of the cover is a part of.
  void keep_refused(const Cover& cover) {
    result_.refused.clear();
    std::vector<const ProvedPreloads*> kept;
    for (const auto& [distance, bounded] : cover) {
      if (std::find(kept.begin(), kept.end(), bounded.refused.get()) == kept.end()) {
        kept.push_back(bounded.refused.get());
        result_.refused.push_back(*bounded.refused);
      }
    }
  }

  void report() const {
    if (progress_) progress_(result_);
  }

  const GraspBox& grasp_;
  NormalLaw law_;
  LoadBall shape_;
  const Rational& budget_;
  PreloadOptions options_;
  const std::function<void(const BallPreload&)>& progress_;
  PreloadPatterns patterns_;
  std::vector<RationalRow> directions_;  ///< loads of the ball of radius 1
  Rational most_;                        ///< no larger distance is sought
  BallPreload result_;
};

}  // namespace

BallPreload find_ball_preload(const GraspBox& grasp, NormalLaw law, const LoadBall& shape,
                              const Rational& budget, const PreloadOptions& options,
                              const std::function<void(const BallPreload&)>& progress) {
  require(grasp.is_point() && budget.sign() > 0, "a budget above 0, of one grasp");
  return BallSearch(grasp, law, shape, budget, options, progress).run();
}

}  // namespace stickslip
