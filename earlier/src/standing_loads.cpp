// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "engine/statics/few_columns.hpp"
#include "engine/statics/statics_search.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/statics.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {
namespace statics_detail {
namespace {

/// Finds the border of the loads that may stand, along rays from one that may.
class LoadSearch {
 public:
  LoadSearch(const GraspBox& grasp, const std::vector<RationalRow>& directions,
             const Rational& friction_factor, const Rational& accuracy)
      : grasp_(grasp),
        model_(grasp, friction_factor),
        accuracy_(accuracy),
        edges_(EdgeProgram::of(model_)) {
    loads_.push_back(model_.load());
    wrenches_.push_back(wrench_of_point(grasp));
    for (const RationalRow& u : directions) {
      loads_.push_back(model_.load_of(u));
      wrenches_.push_back(u);
    }
  }

  StandingLoads run() {
    if (!find_start()) return std::move(found_);
    if (loads_.size() == 2) {
      shoot({1});
      shoot({-1});
    } else {
      shoot_around();
    }
    return std::move(found_);
  }

 private:
  using Place = RationalRow;  ///< l of each direction

  RationalRow load_at(const Rational& h, const Place& l) const { return sum_at(loads_, h, l); }
  static RationalRow sum_at(const std::vector<RationalRow>& terms, const Rational& h,
                            const Place& l) {
    RationalRow sum(terms.front().size());
    stickslip::add_multiple(sum, h, terms[0]);
    for (std::size_t k = 0; k < l.size(); ++k) {
      stickslip::add_multiple(sum, l[k], terms[k + 1]);
    }
    return sum;
  }

  void add_stand(const Rational& h, const Place& l, const std::vector<ConeForce>& forces) {
    RationalRow point{h};
    point.insert(point.end(), l.begin(), l.end());
    found_.stand.push_back(
        {std::move(point), model_.forces_of(forces, sum_at(wrenches_, h, l), h)});
  }
  void add_move(const RationalRow& y) {
    found_.move.push_back(model_.motion_of(y));
    cuts_.push_back({});
    for (const RationalRow& load : loads_) cuts_.back().push_back(dot(y, load));
  }

  /// Returns whether the load at l may stand, and notes why or why not; nothing if that is not
  /// known.
  std::optional<bool> ask(const Rational& h, const Place& l) {
    const RationalRow load = load_at(h, l);
    ModelAnswer answer = decide_load(model_, load);
    if (const auto* forces = std::get_if<std::vector<ConeForce>>(&answer)) {
      add_stand(h, l, *forces);
      return true;
    }
    if (const auto* y = std::get_if<RationalRow>(&answer)) {
      add_move(*y);
      return false;
    }
    return std::nullopt;
  }

  /// Finds a load that may stand, as any multiple of the directions may be added.
  bool find_start() { return edges_ ? find_start_exactly() : find_start_in_doubles(); }

  bool find_start_exactly() {
    const LpResult result = solve(
        edges_->balancing(loads_[0], {loads_.begin() + 1, loads_.end()}, VariableKind::kFree));
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      add_move(opposite(infeasible->farkas));
      return false;
    }
    const RationalRow& point = std::get<Optimal>(result).point;
    start_.assign(point.end() - static_cast<std::ptrdiff_t>(loads_.size() - 1), point.end());
    add_stand(1, start_, edges_->forces_at(point));
    return true;
  }

  bool find_start_in_doubles() {
    ConePair pair = model_.rounded(loads_[0]);
    for (std::size_t k = 1; k < loads_.size(); ++k) {
      for (const int sign : {1, -1}) {
        DoubleColumn column;
        for (std::size_t j = 0; j < model_.size(); ++j) {
          if (loads_[k][j].is_zero()) continue;
          column.emplace_back(j, sign * to_double(loads_[k][j]) / model_.arms()[j]);
        }
        pair.cones.push_back({std::move(column)});
      }
    }
    const ConeSearch search(pair);
    const auto& forces = search.proposal().forces;
    constexpr int kStartBits = 20;
    for (std::size_t k = 0; k + 1 < loads_.size(); ++k) {
      const std::size_t at = model_.cones().size() + 2 * k;
      start_.push_back(rational_in_bits(forces[at][0] - forces[at + 1][0], kStartBits));
    }
    if (search.proposal().rests) {
      const auto stands = ask(1, start_);
      if (stands == true) return true;
    }
    start_.assign(start_.size(), 0);
    if (ask(1, start_) == true) return true;
    found_.is_exact = found_.is_complete = always_moves();
    return false;
  }

  /// Returns whether some motion of those that are known excludes all loads.
  bool always_moves() const {
    return std::any_of(cuts_.begin(), cuts_.end(), [](const RationalRow& cut) {
      return cut[0].sign() > 0 && std::all_of(cut.begin() + 1, cut.end(),
                                              [](const Rational& x) { return x.is_zero(); });
    });
  }

  Place at(const Place& way, const Rational& t) const {
    Place l = start_;
    for (std::size_t k = 0; k < l.size(); ++k) l[k] += t * way[k];
    return l;
  }

  /// Finds the border along a ray from the start, unless it has no end.
  void shoot(const Place& way) {
    if (edges_) return shoot_exactly(way);
    if (ask(0, way) == true) return;
    Rational stands = 0;
    std::optional<Rational> moves = border_along(way);
    Rational next = 1;
    const auto is_near = [&] { return moves && *moves - stands <= accuracy_ * *moves; };
    constexpr int kMostRounds = 100;
    for (int round = 0; round < kMostRounds && !is_near(); ++round) {
      if (moves) next = (stands + *moves) / 2;
      constexpr int kPlaceBits = 40;
      next = rational_in_bits(to_double(next), kPlaceBits);
      const auto answer = ask(1, at(way, next));
      if (!answer) {
        found_.is_complete = false;
        break;
      }
      if (*answer) {
        if (stands.sign() > 0) found_.stand.erase(found_.stand.end() - 2);  // it is behind
        stands = next;
        next = 2 * next;
      } else {
        moves = border_along(way);
      }
    }
    found_.is_exact = false;
    // A border at the start itself is known after so many halves, whatever is_near() says.
    if (stands.sign() > 0 && !is_near()) found_.is_complete = false;
  }

  /// Returns the least t from which on a known motion excludes loads along the ray.
  std::optional<Rational> border_along(const Place& way) const {
    std::optional<Rational> least;
    for (const RationalRow& cut : cuts_) {
      Rational here = cut[0];
      Rational growth = 0;
      for (std::size_t k = 0; k < way.size(); ++k) {
        here += cut[k + 1] * start_[k];
        growth += cut[k + 1] * way[k];
      }
      if (growth.sign() <= 0) continue;
      const Rational border = -here / growth;
      if (!least || border < *least) least = border;
    }
    return least;
  }

  void shoot_exactly(const Place& way) {
    const RationalRow growth = load_at(0, way);
    LinearProgram program =
        edges_->balancing(load_at(1, start_), {growth}, VariableKind::kNonNegative);
    RationalRow objective(program.variable_count());
    objective.back() = -1;
    program.minimize(std::move(objective));
    const LpResult result = solve(program);
    if (const auto* unbounded = std::get_if<Unbounded>(&result)) {
      Place far = way;
      for (Rational& entry : far) entry *= unbounded->ray.back();
      add_stand(0, far, edges_->forces_at(unbounded->ray));
      return;
    }
    const auto& optimal = std::get<Optimal>(result);
    const Rational t = -optimal.value;
    add_stand(1, at(way, t), edges_->forces_at(optimal.point));
    add_move(opposite(optimal.dual));
  }

  /// Shoots at the corners of the polygon that known motions leave, until all are reached.
  void shoot_around() {
    for (const auto& [x, y] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) shoot({x, y});
    constexpr int kMostRays = 200;
    std::set<Place> known;
    for (int ray = 0; ray < kMostRays; ++ray) {
      const std::optional<Place> way = open_corner(known);
      if (!way) return;
      known.insert(*way);
      shoot(*way);
    }
    found_.is_complete = found_.is_exact = false;
  }

  /// Returns the way to a corner of what is not excluded that is not in the hull of what may
  /// stand, but for the accuracy; or one between two rays along which nothing has an end.
  std::optional<Place> open_corner(const std::set<Place>& known) const;
  /// Returns whether (h, l) is a sum of multiples >= 0 of load points that may stand.
  bool is_inside(const RationalRow& point) const;

  const GraspBox& grasp_;
  const StaticsModel model_;
  const Rational& accuracy_;
  std::optional<EdgeProgram> edges_;
  std::vector<RationalRow> loads_;     ///< w and the directions, in the model's coordinates
  std::vector<RationalRow> wrenches_;  ///< the same in the grasp's
  Place start_;
  std::vector<RationalRow> cuts_;  ///< of each motion: its work with each of `loads_`
  StandingLoads found_;
};

/// A corner of the polygon of loads that are not excluded is where the borders of two motions
/// meet, or an end of one border, at infinity. It is reached if it is in the hull of load
/// points, with the accuracy.
std::optional<RationalRow> LoadSearch::open_corner(const std::set<Place>& known) const {
  // A corner is (h, l), with h = 0 at infinity.
  const auto is_open = [&](const Rational& h, const Place& corner, const Place& way) {
    for (const RationalRow& cut : cuts_) {
      const Rational work = cut[0] * h + cut[1] * corner[0] + cut[2] * corner[1];
      if (work.sign() > 0) return false;
    }
    if (known.count(way) > 0) return false;
    Place near = corner;
    const Rational part = edges_ ? Rational(0) : accuracy_;
    for (std::size_t k = 0; k < 2; ++k) near[k] += h * part * (start_[k] - corner[k]);
    return !is_inside({h, near[0], near[1]});
  };
  for (std::size_t a = 0; a < cuts_.size(); ++a) {
    for (const int sign : {1, -1}) {
      Place along{sign * cuts_[a][2], -sign * cuts_[a][1]};
      if (along[0].is_zero() && along[1].is_zero()) continue;
      if (is_open(0, along, along)) return along;
    }
    for (std::size_t b = 0; b < a; ++b) {
      const Rational det = cuts_[a][1] * cuts_[b][2] - cuts_[a][2] * cuts_[b][1];
      if (det.is_zero()) continue;
      const Place corner{(cuts_[a][2] * cuts_[b][0] - cuts_[a][0] * cuts_[b][2]) / det,
                         (cuts_[a][0] * cuts_[b][1] - cuts_[a][1] * cuts_[b][0]) / det};
      const Place way{corner[0] - start_[0], corner[1] - start_[1]};
      if (way[0].is_zero() && way[1].is_zero()) continue;
      if (is_open(1, corner, way)) return way;
    }
  }
  return std::nullopt;
}

bool LoadSearch::is_inside(const RationalRow& point) const {
  LinearProgram program;
  program.add_variables(found_.stand.size(), VariableKind::kNonNegative);
  for (std::size_t k = 0; k < point.size(); ++k) {
    RationalRow row;
    for (const StandPoint& stand : found_.stand) row.push_back(stand.point[k]);
    program.add_row(std::move(row), Relation::kEqual, point[k]);
  }
  return std::holds_alternative<Optimal>(solve(program));
}

}  // namespace
}  // namespace statics_detail

using namespace statics_detail;

StandingLoads standing_loads(const GraspBox& grasp, const std::vector<RationalRow>& directions,
                             const Rational& friction_factor, const Rational& accuracy) {
  require(directions.size() == 1 || directions.size() == 2, "one direction or two");
  require(accuracy.sign() > 0, "the accuracy must be above 0");
  const std::size_t rank = rank_of(directions);
  if (rank < directions.size()) {
    throw InputError("", directions.size() == 1 ? "direction" : "plane",
                     directions.size() == 1 ? "the direction is 0"
                                            : "the directions are multiples of one another",
                     "give a load that grows, or two that differ");
  }
  return LoadSearch(grasp, directions, friction_factor, accuracy).run();
}

StandingMultiples multiples_of(const GraspBox& grasp, const StandingLoads& loads,
                               const RationalRow& direction) {
  StandingMultiples result;
  bool has_low = true;
  bool has_high = true;
  for (const StandPoint& stand : loads.stand) {
    const Rational& h = stand.point[0];
    const Rational& l = stand.point[1];
    if (h.is_zero()) {
      if (l.sign() < 0) has_low = false;
      if (l.sign() > 0) has_high = false;
      continue;
    }
    const Rational multiple = l / h;
    result.any = true;
    if (!result.low || multiple < *result.low) result.low = multiple;
    if (!result.high || multiple > *result.high) result.high = multiple;
  }
  if (!has_low) result.low.reset();
  if (!has_high) result.high.reset();
  const RationalRow load = wrench_with_springs(grasp);
  const auto limits = grasp.force_limits();
  for (const RationalRow& y : loads.move) {
    Rational work = dot(y, load);
    for (std::size_t k = 0; k < limits.size(); ++k) {
      work -= limits[k].second * y[load.size() + k];
    }
    const Rational growth = dot(y, direction);
    if (growth.is_zero()) {
      result.always_moves = result.always_moves || work.sign() > 0;
      continue;
    }
    const Rational border = -work / growth;
    std::optional<Rational>& end = growth.sign() > 0 ? result.above : result.below;
    if (!end || (growth.sign() > 0 ? border < *end : border > *end)) end = border;
  }
  return result;
}

}  // namespace stickslip
