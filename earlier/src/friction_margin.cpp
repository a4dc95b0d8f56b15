// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/friction_margin.hpp"

#include <algorithm>
#include <utility>

#include "contact_forces.hpp"
#include "friction_border.hpp"
#include "rigid_cells.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace earlier_detail {
namespace {

/// Finds the factors about one that must hold, among those that balance the load.
class HoldSweep {
 public:
  HoldSweep(const Problem& problem, const Inertia& inertia, const Rational& accuracy,
            std::size_t most_programs)
      : problem_(problem),
        inertia_(inertia),
        accuracy_(accuracy),
        most_programs_(most_programs) {}

  /// Returns true if all factors of the range leave no acceleration.
  bool holds(const Rational& low, const std::optional<Rational>& high) {
    const AccelerationSearch search =
        search_accelerations(problem_, inertia_, {low, high}, most_programs_);
    if (search.found && high == low) open_ = low;
    return !search.found && !search.limited;
  }

  /// Returns how far down from `held` to `least` all must hold.
  Rational down(Rational held, const Rational& least) {
    return least < held && !holds(least, held) ? toward(held, least) : least;
  }
  /// Returns the same upwards; nothing if there is no end.
  std::optional<Rational> up(const Rational& held) {
    if (holds(held, std::nullopt)) return std::nullopt;
    Rational far = held;
    for (int doublings = 0; doublings < 10; ++doublings) {
      const Rational next = 2 * far;
      if (!holds(far, next)) return toward(far, next);
      far = next;
    }
    return far;
  }
  /// Returns the factor that was last found to be open, once.
  std::optional<Rational> take_open() { return std::exchange(open_, std::nullopt); }

 private:
  /// Returns true if all factors between hold, by parts of the range.
  bool holds_between(const Rational& one, const Rational& other, int halvings) {
    if (holds(std::min(one, other), std::max(one, other))) return true;
    if (halvings == 0) return false;
    const Rational middle = (one + other) / 2;
    return holds(middle, middle) && holds_between(one, middle, halvings - 1) &&
           holds_between(middle, other, halvings - 1);
  }

  /// Goes from `held` on towards `end`. Not all between hold, or one range has too much in it
  /// to show that they do.
  Rational toward(Rational held, Rational end) {
    if (holds(end, end) && holds_between(held, end, kHalvings)) return end;
    for (int round = 0; round < 64 && abs(end - held) > accuracy_ * held; ++round) {
      const Rational middle = (held + end) / 2;
      (holds_between(held, middle, kHalvings) ? held : end) = middle;
    }
    return held;
  }

  static constexpr int kHalvings = 4;

  const Problem& problem_;
  const Inertia& inertia_;
  const Rational& accuracy_;
  std::size_t most_programs_;
  std::optional<Rational> open_;
};

void add_point(std::vector<FactorRange>& known, const std::optional<Rational>& open) {
  if (open) known.push_back({RigidClass::kOpen, *open, *open, true, true});
}

/// Returns the known ranges, which are in their order, with unknown ranges between them.
std::vector<FactorRange> filled(const std::vector<FactorRange>& known) {
  std::vector<FactorRange> result;
  std::optional<Rational> end = Rational(0);
  bool has_end = false;  // whether what was written so far has `end`
  for (const FactorRange& range : known) {
    if (*end < range.low || (!has_end && !range.has_low)) {
      result.push_back({std::nullopt, *end, range.low, !has_end, !range.has_low});
    }
    result.push_back(range);
    end = range.high;
    has_end = range.has_high;
  }
  if (end) result.push_back({std::nullopt, *end, std::nullopt, !has_end, false});
  return result;
}

}  // namespace
}  // namespace earlier_detail

using namespace earlier_detail;

std::vector<FactorRange> friction_margin(const Problem& problem, const Inertia& inertia,
                                         const Rational& accuracy, std::size_t most_programs) {
  require_planar(inertia);
  require(accuracy.sign() > 0, "the accuracy must be above 0");
  const FrictionBorder border = friction_border(problem);
  if (border.always_moves) return {{RigidClass::kMustMove, 0, std::nullopt, true, false}};
  std::vector<FactorRange> known;
  if (border.moves && (border.moves_at || border.moves->sign() > 0)) {
    known.push_back({RigidClass::kMustMove, 0, *border.moves, true, border.moves_at});
  }
  if (!border.rests) return filled(known);
  const Rational& least = *border.rests;
  const bool rests_at_1 = least < 1 || (least == 1 && border.rests_at);
  const Rational from = rests_at_1        ? Rational(1)
                        : border.rests_at ? least
                                          : Rational(2 * least);
  HoldSweep sweep(problem, inertia, accuracy, most_programs);
  if (!sweep.holds(from, from)) {
    add_point(known, sweep.take_open());
    return filled(known);
  }
  const Rational low = sweep.down(from, least);
  if (const auto open = sweep.take_open(); open && (*open != least || border.rests_at)) {
    add_point(known, open);
  }
  const std::optional<Rational> high = sweep.up(from);
  known.push_back(
      {RigidClass::kMustHold, low, high, low != least || border.rests_at, high.has_value()});
  add_point(known, sweep.take_open());
  return filled(known);
}

}  // namespace stickslip
