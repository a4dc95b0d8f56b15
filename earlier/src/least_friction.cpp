// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/statics/statics_search.hpp"
#include "stickslip/earlier/statics.hpp"

namespace stickslip {
namespace statics_detail {
namespace {

const Undecided kBorder{
    "forces that balance the load are at the border of the friction cones, to "
    "all digits of doubles",
    "border",
    "ask about a load or friction a little off",
    {}};

/// Bounds of the least factor of friction.
class FrictionBracket {
 public:
  explicit FrictionBracket(const GraspBox& grasp) : grasp_(grasp), plain_(grasp, 1) {}

  /// Asks about a factor and narrows the bracket; returns whether it was decided.
  bool ask(const Rational& factor) {
    const StaticsModel model(grasp_, factor);
    ModelAnswer answer = decide_load(model, model.load(), needs_long_);
    if (const auto* forces = std::get_if<std::vector<ConeForce>>(&answer)) {
      high_ = std::min(factor, needed(*forces));
      forces_ = std::move(*forces);
      moves_ = false;
      stands_ = true;
      return true;
    }
    const auto* y = std::get_if<RationalRow>(&answer);
    if (y == nullptr) {
      moves_ = false;
      return false;
    }
    const std::optional<Rational> most = harmless(*y);
    always_moves_ = !most;
    moves_ = true;
    if (most) low_ = std::max(factor, *most);
    motion_ = *y;
    return true;
  }

  /// Returns a number near the least factor, if forces and a motion are known, as these are
  /// near those at the least factor: there friction is against slip, and as large as it may be,
  /// at all contacts that the motion does not open. The quotient of the work of friction and
  /// the most that there is with the factor 1 is then the factor; as it is stationary there, it
  /// is off by the square of what forces and motion are.
  std::optional<double> estimate() const {
    if (forces_.empty() || motion_.empty()) return std::nullopt;
    double work = 0;
    double most = 0;
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      const ForceCone& cone = plain_.cones()[i];
      double square = 0;
      for (std::size_t k = 0; k < cone.slips.size(); ++k) {
        const double slip = to_double(dot(cone.slips[k], motion_));
        square += slip * slip / to_double(cone.squares[k]);
        if (k + 1 < forces_[i].size()) work -= to_double(forces_[i][k + 1]) * slip;
      }
      most += to_double(forces_[i][0]) * std::sqrt(to_double(cone.squared_most) * square);
    }
    return most > 0 ? std::optional(work / most) : std::nullopt;
  }

  bool stands() const { return stands_; }
  bool always_moves() const { return always_moves_; }
  bool moves() const { return moves_; }
  const Rational& low() const { return low_; }
  const Rational& high() const { return high_; }
  UnopposedMotion motion() const {
    if (motion_.empty()) return {};
    return {plain_.motion_of(motion_)};
  }
  LeastFriction found() const {
    return {low_, motion(), high_, plain_.forces_of(forces_, wrench_of_point(grasp_))};
  }

 private:
  static constexpr unsigned kBits = 64;

  /// Returns a factor with which forces are in their cones.
  Rational needed(const std::vector<ConeForce>& forces) const {
    Rational most = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const ForceCone& cone = plain_.cones()[i];
      Rational square = cone.squared_friction(forces[i]);
      if (square.is_zero()) continue;
      square /= cone.squared_most * forces[i][0] * forces[i][0];
      if (square > most) most = square;
    }
    return short_sqrt(most, kBits).upper;
  }

  /// Returns a factor with which no force opposes the motion, or nothing if all are such.
  std::optional<Rational> harmless(const RationalRow& y) const {
    std::optional<Rational> least;
    for (const ForceCone& cone : plain_.cones()) {
      Rational square = cone.squared_slip(y);
      if (square.is_zero()) continue;
      const Rational press = dot(cone.normal, y);
      square = press * press / (cone.squared_most * square);
      if (!least || square < *least) least = square;
    }
    if (!least) return std::nullopt;
    return short_sqrt(*least, kBits).lower;
  }

  const GraspBox& grasp_;
  const StaticsModel plain_;  ///< with friction as it is
  Rational low_ = 0;
  Rational high_ = 0;
  std::vector<ConeForce> forces_;  ///< the last that balance the load; empty if there are none
  RationalRow motion_;             ///< the last that nothing opposes; empty if there is none
  bool needs_long_ = false;  ///< whether factors are so near the least that doubles do not tell
  bool stands_ = false;
  bool always_moves_ = false;
  bool moves_ = false;  ///< whether the answer before was that they must move
};

}  // namespace
}  // namespace statics_detail

using namespace statics_detail;

LoadClass statics(const GraspBox& grasp, const Rational& friction_factor) {
  const StaticsModel model(grasp, friction_factor);
  ModelAnswer answer = decide_load(model, model.load());
  if (const auto* forces = std::get_if<std::vector<ConeForce>>(&answer)) {
    return model.forces_of(*forces, wrench_of_point(grasp));
  }
  if (const auto* y = std::get_if<RationalRow>(&answer)) {
    return UnopposedMotion{model.motion_of(*y)};
  }
  return kBorder;
}

std::string name_of(const LoadClass& found) {
  constexpr const char* kNames[] = {"may stand", "must move", "undecided"};
  return kNames[found.index()];
}

std::variant<LeastFriction, UnopposedMotion, Undecided> least_friction(
    const GraspBox& grasp, const Rational& accuracy) {
  FrictionBracket bracket(grasp);
  for (const int factor : {0, 1, 32, 1000, 1000000}) {
    if (bracket.ask(factor) && bracket.always_moves()) return bracket.motion();
    if (bracket.stands()) break;
  }
  if (!bracket.stands() && bracket.moves()) return bracket.motion();
  if (!bracket.stands()) return kBorder;
  // A little above and below the estimate is asked, ever nearer as long as it is right.
  constexpr int kMostRounds = 60;
  constexpr double kFirstPart = 1.0 / 16;
  double part = kFirstPart;
  for (int round = 0; round < kMostRounds; ++round) {
    const Rational close = accuracy * std::max<Rational>(bracket.high(), accuracy);
    if (bracket.high() - bracket.low() <= close) break;
    const double low = to_double(bracket.low());
    const double high = to_double(bracket.high());
    const double estimate = bracket.estimate().value_or((low + high) / 2);
    const bool from_above = high - estimate > estimate - low;
    const double away =
        std::max(0.4 * to_double(close), part * std::max(high - estimate, estimate - low));
    double next = from_above ? estimate + away : estimate - away;
    const bool is_inside = low < next && next < high;
    if (!is_inside) next = (low + high) / 2;
    constexpr int kBits = 44;
    // Its mirror image and other places between may be known where that is undecided.
    bool knows = false;
    for (const double place :
         {next, 2 * estimate - next, (low + 2 * high) / 3, (2 * low + high) / 3}) {
      knows = low < place && place < high && bracket.ask(rational_in_bits(place, kBits));
      if (knows) break;
    }
    if (!knows) break;
    part = is_inside && bracket.moves() != from_above ? part * part : kFirstPart;
  }
  return bracket.found();
}

}  // namespace stickslip
