// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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
      found_.high = std::min(factor, needed(*forces));
      found_.forces = model.forces_of(*forces, wrench_of_point(grasp_));
      stands_ = true;
      return true;
    }
    const auto* y = std::get_if<RationalRow>(&answer);
    if (y == nullptr) {
      moves_ = false;
      return false;
    }
    const std::optional<Rational> most = harmless(*y);
    found_.motion = {model.motion_of(*y)};
    always_moves_ = !most;
    moves_ = true;
    if (most) found_.low = std::max(factor, *most);
    return true;
  }

  bool stands() const { return stands_; }
  bool always_moves() const { return always_moves_; }
  bool moves() const { return moves_; }
  const LeastFriction& found() const { return found_; }

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
  LeastFriction found_;
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
    if (bracket.ask(factor) && bracket.always_moves()) return bracket.found().motion;
    if (bracket.stands()) break;
  }
  if (!bracket.stands() && bracket.moves()) return bracket.found().motion;
  if (!bracket.stands()) return kBorder;
  constexpr int kMostRounds = 60;
  for (int round = 0; round < kMostRounds; ++round) {
    const LeastFriction& found = bracket.found();
    if (found.high - found.low <= accuracy * std::max<Rational>(found.high, accuracy)) break;
    constexpr int kBits = 44;
    const auto at = [&](const Rational& part) {
      return rational_in_bits(to_double(Rational(found.low + part * (found.high - found.low))),
                              kBits);
    };
    if (!bracket.ask(at(Rational(1, 2))) && !bracket.ask(at(Rational(2, 3)))) break;
  }
  return bracket.found();
}

}  // namespace stickslip
