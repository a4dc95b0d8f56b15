// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "engine/box/effort.hpp"
#include "engine/box/examples.hpp"
#include "engine/box/single_grasp.hpp"
#include "in_parallel.hpp"
#include "preload_boxes.hpp"
#include "preload_patterns.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using namespace box_detail;
using namespace extent_detail;

namespace {

/// The boxes to look at next, by the least sum in them; equal ones stay in the order in which
/// they came.
using OpenBoxes = std::multimap<Rational, PreloadBox>;

/// The result of a look at a box.
struct Looked {
  std::optional<ProvedPreloads> refused{};
  bool middle_may_hold = true;  ///< false if some known load says otherwise
};

class LeastSearch {
 public:
  LeastSearch(const std::vector<GraspBox>& loads, NormalLaw law, const PreloadOptions& options,
              const std::function<void(const LeastPreload&)>& progress)
      : asked_(loads),
        law_(law),
        options_(options),
        progress_(progress),
        effort_(effort_for(loads.front())),
        patterns_(loads.front(), options.balanced, options.alike) {
    options_.box = of_many(options.box, loads.front());
    for (const GraspBox& load : asked_) {
      load.check();
      Rational size = size_of(load.wrench);
      if (load.ball) size = std::max<Rational>(size, load.ball->radius);
      size_ = std::max(size_, size);
    }
    for (const GraspBox& load : asked_) know(load);
  }

  LeastPreload run() {
    const RationalRow given = preloads_of(asked_.front());
    const std::size_t count = patterns_.size();
    result_.limit = std::max<Rational>(kMostSizes * size_, 2 * sum_of(given));
    report();
    if (!take(RationalRow(count))) {
      // The search begins with those of the file, and so finds no more than a multiple of them.
      const std::optional<RationalRow> weights = patterns_.weights(given);
      if (weights && !sum_of(given).is_zero()) begin_along(*weights, sum_of(given));
      if (count > 0) begin_along(RationalRow(count, 1), size_ / 64);
      bound();
    }
    if (found()) {
      std::vector<GraspBox> held;
      for (const ProvedPreloads& load : result_.held) held.push_back(load.box);
      result_.range = range_of(held, law_, options_.box);
    }
    return std::move(result_);
  }

 private:
  static constexpr int kMostSizes = 256;

  bool found() const { return result_.preloads.has_value(); }
  Rational sum() const { return sum_of(*result_.preloads); }

  /// Adds loads that are known to be asked about. A ball adds some of its loads, which show
  /// soonest that it is not held, if that takes less time than a proof about the ball.
  void know(const GraspBox& load) {
    GraspBox centre = load;
    centre.ball.reset();
    known_.push_back(std::move(centre));
    if (!load.ball || !effort_.decides_singles) return;
    const Examples examples(load, law_);
    for (const Place& place : examples.ball_directions()) {
      known_.push_back(examples.at(place));
    }
  }

  bool may_hold(const RationalRow& preloads) const {
    return std::all_of(known_.begin(), known_.end(), [&](const GraspBox& load) {
      return is_stable(with_preloads(load, preloads), law_, options_.box) == true;
    });
  }

  /// Returns a proof for each load if these preloads hold all loads; nothing if they do not.
  /// Only balls need proofs. Remembers a load of a ball that is not resisted.
  std::optional<std::vector<ProvedPreloads>> hold(const RationalRow& preloads) {
    if (!may_hold(preloads)) return std::nullopt;
    std::vector<ProvedPreloads> held;
    for (const GraspBox& load : asked_) {
      held.push_back({with_preloads(load, preloads)});
      if (!load.ball) continue;
      const GraspBox& box = held.back().box;
      BoxDecision decision = prove_box(box, law_, options_.box, 0);
      if (stickslip::is_stable(decision.verdict) != true) {
        RadiusOptions whole{options_.box, Rational(1, 2), 1};
        Radius radius = find_radius(box.middle(), box, law_, whole);
        if (radius.example && radius.stable == true) {
          known_.push_back(std::move(*radius.example));
        }
        if (radius.proved != 1) return std::nullopt;
        decision = std::move(*radius.proof);
      }
      held.back().proof = std::move(decision);
    }
    return held;
  }

  /// Returns true if preloads with these weights are better than the known ones, and keeps
  /// them.
  bool take(const RationalRow& weights) {
    if (found() && sum_of(weights) >= sum()) return false;
    const RationalRow preloads = patterns_.preloads(weights);
    auto held = hold(preloads);
    if (!held) return false;
    weights_ = weights;
    result_.preloads = preloads;
    result_.held = std::move(*held);
    report();
    return true;
  }

  /// Seeks preloads along these weights, of twice a sum again and again while that is less than
  /// what is known, and others near the first that are found.
  void begin_along(RationalRow weights, const Rational& least) {
    const Rational whole = sum_of(weights);
    for (Rational& weight : weights) weight *= least / whole;
    while (sum_of(weights) <= (found() ? sum() : result_.limit)) {
      if (take(weights)) return improve();
      for (Rational& weight : weights) weight *= 2;
    }
  }

  /// Tries less of all weights or of one, perhaps with a part of that added to another, in ever
  /// smaller steps.
  void improve() {
    std::size_t tries = effort_.tries;
    Rational step = 1;
    while (step > sum()) step /= 2;
    while (2 * step <= sum()) step *= 2;
    const Rational grain = step / (1 << 14);
    shrink();
    for (Rational part(1, 2); effort_.last_step * part > options_.accuracy; part /= 2) {
      step /= 2;
      while (take_nearby(part, step, grain, tries)) {
      }
    }
    shrink();
  }

  bool take_nearby(const Rational& part, const Rational& step, const Rational& grain,
                   std::size_t& tries) {
    const RationalRow now = weights_;
    const auto take_one = [&](const RationalRow& weights) {
      if (tries == 0) return false;
      --tries;
      return take(weights);
    };
    const auto in_grains = [&](const Rational& weight) -> Rational {
      const Rational grains = weight / grain;
      return Rational(numerator(grains) / denominator(grains)) * grain;
    };
    RationalRow less_of_all = now;
    for (Rational& weight : less_of_all) weight = in_grains(weight * (1 - part));
    if (take_one(less_of_all)) return true;
    const std::array<Rational, 3> kept{Rational(1, 2), Rational(7, 8), Rational(31, 32)};
    const Rational taken = sum() - sum_of(less_of_all);
    for (std::size_t i = 0; i < now.size(); ++i) {
      for (const Rational& how_much : kept) {
        RationalRow more_of_one = less_of_all;
        more_of_one[i] += in_grains(how_much * taken);
        if (take_one(more_of_one)) return true;
      }
      if (now[i].is_zero()) continue;
      RationalRow less_of_one = now;
      less_of_one[i] = std::max<Rational>(0, now[i] - step);
      if (take_one(less_of_one)) return true;
      for (std::size_t j = 0; j < now.size(); ++j) {
        for (const Rational& how_much : kept) {
          if (j == i) continue;
          RationalRow other = less_of_one;
          other[j] += how_much * (now[i] - less_of_one[i]);
          if (take_one(other)) return true;
        }
      }
    }
    return false;
  }

  /// Reduces the preloads to their least multiple, which a margin knows exactly.
  void shrink() {
    std::vector<GraspBox> held;
    for (const ProvedPreloads& load : result_.held) held.push_back(load.box);
    const PreloadRange range =
        effort_.margins_come_soon ? range_of(held, law_, options_.box) : PreloadRange();
    if (range.margins.empty()) return shrink_by_steps();
    for (const auto& [low, high] : range.multiples) {
      if (low >= 1 || (high && *high < 1)) continue;
      RationalRow least = weights_;
      for (Rational& weight : least) weight *= low;
      constexpr std::size_t kShort = 128;
      const bool is_short = std::all_of(least.begin(), least.end(), [](const Rational& x) {
        return msb(denominator(x)) < kShort;
      });
      if (!is_short) {
        const Rational steps = low * (1 << 16);
        const Rational above = Rational(numerator(steps) / denominator(steps) + 1) / (1 << 16);
        least = weights_;
        for (Rational& weight : least) weight *= above;
      }
      take(least);
      return;
    }
  }

  void shrink_by_steps() {
    const RationalRow most = weights_;
    Rational low = 0;
    Rational high = 1;
    while (high - low > options_.accuracy / 8 * high && low < Rational(63, 64)) {
      const Rational middle = (low + high) / 2;
      RationalRow less = most;
      for (Rational& weight : less) weight *= middle;
      (take(less) ? high : low) = middle;
    }
  }

  /// Returns a sum above which no preloads are of interest: a little more than the known sum,
  /// in few digits.
  Rational ceiling() const {
    if (!found()) return result_.limit;
    const Rational unit = size_of({point_interval(sum())}) / 256;
    const Rational units = sum() / unit;
    return Rational(numerator(units) / denominator(units) + 1) * unit;
  }

  Looked look(const PreloadBox& box) const {
    constexpr int kMostTries = 3;
    Looked looked;
    int tries = 0;
    for (const GraspBox& load : known_) {
      if (seems_held(with_preloads(load, middle_of(box)), law_, options_.box)) continue;
      if (effort_.decides_singles) looked.middle_may_hold = false;
      if (!may_refuse(load, box, law_, options_.box)) continue;
      looked.refused = refuse(load, box, law_, options_.box);
      if (looked.refused || ++tries == kMostTries) break;
    }
    return looked;
  }

  void bound() {
    OpenBoxes open;
    open.emplace(0, PreloadBox(asked_.front().contacts.size(), Interval{0, ceiling()}));
    const std::size_t most_boxes = options_.most_boxes_of_sum();
    std::size_t count = 0;
    const auto is_of_interest = [&](const Rational& least) {
      return !found() || least < (1 - options_.accuracy) * sum();
    };
    while (!open.empty() && count < most_boxes && is_of_interest(open.begin()->first)) {
      constexpr std::size_t kAtOnce = 8;  // the same on every machine
      std::vector<PreloadBox> boxes;
      while (!open.empty() && boxes.size() < kAtOnce && is_of_interest(open.begin()->first)) {
        boxes.push_back(below_sum(std::move(open.begin()->second), ceiling()));
        open.erase(open.begin());
      }
      count += boxes.size();
      std::vector<Looked> looked(boxes.size());
      in_parallel(boxes.size(), [&](std::size_t k) { looked[k] = look(boxes[k]); });
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        if (looked[k].refused) {
          result_.refused.push_back(std::move(*looked[k].refused));
          continue;
        }
        if (looked[k].middle_may_hold && patterns_.are_contacts() &&
            take(middle_of(boxes[k]))) {
          improve();
        }
        auto [low, high] = halves(boxes[k]);
        for (PreloadBox* half : {&low, &high}) {
          Rational least = sum_of(low_corner(*half));
          if (least < ceiling()) open.emplace(std::move(least), std::move(*half));
        }
      }
      result_.looked = count;
      result_.bound = open.empty() ? ceiling() : std::min(open.begin()->first, ceiling());
      report();
    }
    auto& refused = result_.refused;
    const auto is_beyond = [&](const ProvedPreloads& part) {
      return sum_of(preloads_of(part.box)) >= result_.bound;
    };
    refused.erase(std::remove_if(refused.begin(), refused.end(), is_beyond), refused.end());
  }

  void report() const {
    if (progress_) progress_(result_);
  }

  const std::vector<GraspBox>& asked_;
  NormalLaw law_;
  PreloadOptions options_;
  const std::function<void(const LeastPreload&)>& progress_;
  Effort effort_;
  std::vector<GraspBox> known_;  ///< single loads that are asked about
  Rational size_ = 0;            ///< the size of the largest load
  PreloadPatterns patterns_;
  RationalRow weights_{};  ///< the weights of the known preloads
  LeastPreload result_;
};

}  // namespace

LeastPreload find_least_preload(const std::vector<GraspBox>& loads, NormalLaw law,
                                const PreloadOptions& options,
                                const std::function<void(const LeastPreload&)>& progress) {
  require(!loads.empty(), "preloads that hold some load");
  return LeastSearch(loads, law, options, progress).run();
}

}  // namespace stickslip
