// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/load_section.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/number.hpp"
#include "stickslip/engine/ball_part.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace {

class Sections {
 public:
  explicit Sections(const Quality& quality)
      : grasp_(quality.ball), ball_(*quality.ball.ball), part_(BallPart::all_of(quality.ball)) {
    const Rational radius = quality.refuted.value_or(quality.proved);
    reach_ = radius * kSectionReach;
    if (quality.radii.example) find_lost(quality.radii.example->wrench, radius);
  }

  std::vector<LoadSection> all() const {
    std::vector<LoadSection> sections;
    if (reach_.is_zero()) return sections;
    for (std::size_t i = 0; i < part_.forces; ++i) {
      for (std::size_t j = i + 1; j < part_.forces; ++j) {
        sections.push_back(section({unit_along(i), unit_along(j)}));
      }
    }
    if (lost_.empty()) return sections;
    RationalRow force(part_.motion.size());
    RationalRow torque(part_.motion.size());
    for (std::size_t j = 0; j < lost_.size(); ++j)
      (j < part_.forces ? force : torque)[j] = lost_[j];
    if (ball_.squared_norm(force).is_zero()) force = unit_along(0);
    if (ball_.squared_norm(torque).is_zero()) torque = unit_along(part_.motion.size() - 1);
    sections.push_back(section({std::move(force), std::move(torque)}));
    return sections;
  }

 private:
  RationalRow unit_along(std::size_t component) const {
    RationalRow z(part_.motion.size());
    z[component] = 1;
    return z;
  }

  /// Finds the force and torque by which the load differs. They are not unique if a link feels
  /// only some of them; then the ones found may be farther than need be, and are no help.
  void find_lost(const WrenchBox& load, const Rational& radius) {
    RationalRow off(load.size());
    for (std::size_t j = 0; j < load.size(); ++j) off[j] = load[j].low - grasp_.wrench[j].low;
    auto found = solve_exactly(matrix_of_columns(part_.motion, load.size()), off);
    if (found && ball_.squared_norm(*found) <= radius * radius) lost_ = std::move(*found);
  }

  LoadSection section(std::array<RationalRow, 2> along) const {
    LoadSection result{{}, std::move(along)};
    std::array<Rational, 2> at{0, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      const RationalRow& z = result.along[k];
      const Rational square = ball_.squared_norm(z);
      constexpr int kDigits = 9;
      const Rational most = parse_rational(enclose_sqrt(reach_, 1 / square, kDigits).upper);
      MapAxis& axis = result.axes[k];
      axis.name = k == 0 ? "s" : "t";
      axis.kind = AxisKind::kAlong;
      axis.range = {-most, most};
      axis.along = part_.load(z);
      if (lost_.empty()) continue;
      for (std::size_t j = 0; j < z.size(); ++j) {
        at[k] +=
            lost_[j] * z[j] / (j < part_.forces ? Rational(1) : ball_.length * ball_.length);
      }
      at[k] /= square;
    }
    if (lost_.empty()) return result;
    bool is_here = true;
    for (std::size_t j = 0; j < lost_.size(); ++j) {
      is_here = is_here && at[0] * result.along[0][j] + at[1] * result.along[1][j] == lost_[j];
    }
    if (is_here) result.lost = at;
    return result;
  }

  const GraspBox& grasp_;
  const LoadBall& ball_;
  BallPart part_;
  Rational reach_;
  RationalRow lost_;  ///< a force and a torque, or empty
};

}  // namespace

Rational LoadSection::squared_norm(std::size_t axis, const LoadBall& ball) const {
  return ball.squared_norm(along[axis]);
}

std::vector<LoadSection> load_sections(const Quality& quality) {
  return Sections(quality).all();
}

}  // namespace stickslip
