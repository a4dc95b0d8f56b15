// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/statics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <utility>

#include "statics_model.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {
namespace earlier_detail {
namespace {

/// The dimension up to which systems are solved as dense ones.
constexpr std::size_t kMostDense = 60;

/// Returns x with its bits below 2^-`bits` cut off.
Rational on_grid(double x, int bits) {
  return std::isfinite(x)
             ? rational_from_double(std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits))
             : Rational(0);
}

/// Returns coefficients with which columns add up to a vector: few of them are not 0, and these
/// of columns that are long if multiplied by their weights and divided, row by row, by units.
std::optional<RationalRow> few_columns(const std::vector<RationalRow>& columns,
                                       const std::vector<double>& weights,
                                       const RationalRow& sum,
                                       const std::vector<double>& units) {
  std::vector<std::vector<double>> left;  // of each column, across those that are chosen
  for (std::size_t j = 0; j < columns.size(); ++j) {
    auto& column = left.emplace_back();
    for (std::size_t r = 0; r < sum.size(); ++r) {
      column.push_back(weights[j] * to_double(columns[j][r]) / units[r]);
    }
  }
  const auto square = [](const std::vector<double>& v) {
    double result = 0;
    for (const double entry : v) result += entry * entry;
    return result;
  };
  std::vector<std::size_t> chosen;
  double first = 0;
  while (chosen.size() < sum.size()) {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t j = 0; j < left.size(); ++j) {
      if (const double size = square(left[j]); size > most) {
        most = size;
        best = j;
      }
    }
    if (chosen.empty()) first = most;
    constexpr double kNone = 1e-18;
    if (!(most > kNone * first)) break;
    chosen.push_back(best);
    const std::vector<double> along = left[best];
    for (std::vector<double>& v : left) {
      double product = 0;
      for (std::size_t r = 0; r < v.size(); ++r) product += v[r] * along[r];
      for (std::size_t r = 0; r < v.size(); ++r) v[r] -= product / most * along[r];
    }
    std::fill(left[best].begin(), left[best].end(), 0);
  }
  std::vector<RationalRow> basis;
  for (const std::size_t j : chosen) basis.push_back(columns[j]);
  RationalRow result(columns.size());
  if (basis.empty()) {
    for (const Rational& entry : sum) {
      if (!entry.is_zero()) return std::nullopt;
    }
    return result;
  }
  const auto solution = solve_exactly(matrix_of_columns(basis, sum.size()), sum);
  if (!solution) return std::nullopt;
  for (std::size_t k = 0; k < chosen.size(); ++k) result[chosen[k]] = (*solution)[k];
  return result;
}

/// A way in which the force of a cone may change: by a multiple of `change`, whose wrench is
/// `column`.
struct ForceChange {
  std::size_t cone;
  ConeForce change;
  SparseRow column;
  double weight;         ///< how far it may change
  bool is_edge = false;  ///< whether it goes along an edge of the cone, which the force is on
};

/// Rounded forces and the ways in which they may change.
class ForceRounding {
 public:
  /// Forces beyond the border by a part of `border` are put on it.
  ForceRounding(const StaticsModel& model, const RationalRow& load,
                const ConeProposal& proposal, int bits, double border)
      : model_(model), left_(load) {
    double largest = 0;
    for (const auto& z : proposal.forces) largest = std::max(largest, z[0]);
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    for (std::size_t i = 0; i < model.cones().size(); ++i) {
      const ForceCone& cone = model.cones()[i];
      ConeForce& force = forces_.emplace_back(cone.slips.size() + 1);
      const std::vector<double>& z = proposal.forces[i];
      if (!(z[0] > border * largest)) continue;
      double tail = 0;
      for (std::size_t k = 1; k < z.size(); ++k) tail = std::hypot(tail, z[k]);
      const double depth = z[0] - tail;
      const bool on_border = z.size() > 1 && !(depth > border * z[0]);
      force[0] = on_grid(z[0], bits - exponent);
      if (on_border && z.size() == 2) {
        const auto most = exact_sqrt(cone.squared_most);
        require(most.has_value(), "in the plane a cone has rational edges");
        add(i, {1, z[1] < 0 ? Rational(-*most) : *most}, z[0]);
        changes_.back().is_edge = true;
        force[1] = force[0] * changes_.back().change[1];
      } else {
        for (std::size_t k = 0; k < z.size(); ++k) {
          const double scale = model.scale(cone, k);
          if (k > 0) force[k] = on_grid(z[k] * scale, bits - exponent - std::ilogb(scale));
          if (on_border) continue;
          ConeForce change(z.size());
          change[k] = 1;
          add(i, std::move(change), depth * scale);
        }
      }
      add_wrench(cone, force);
    }
  }

  /// Changes forces so that nothing of the load is left; returns whether it could.
  bool balance() {
    if (balance_by_tree()) return true;
    if (model_.size() > kMostDense) return false;
    std::vector<RationalRow> columns;
    std::vector<double> weights;
    for (const ForceChange& change : changes_) {
      stickslip::add_multiple(columns.emplace_back(model_.size()), 1, change.column);
      weights.push_back(change.weight);
    }
    const auto multiples = few_columns(columns, weights, opposite(left_), model_.arms());
    if (!multiples) return false;
    for (std::size_t c = 0; c < changes_.size(); ++c) change_by(changes_[c], (*multiples)[c]);
    return true;
  }

  /// Changes forces so that nearly nothing of the load is left, most where they are deep in
  /// their cones. What is left after it is smaller by many digits.
  void refine(const ConeSearch& search, int bits) {
    std::vector<double> left;
    for (std::size_t j = 0; j < left_.size(); ++j) {
      left.push_back(to_double(left_[j]) / model_.arms()[j]);
    }
    const auto changes = search.changes(left);
    for (const ForceChange& change : changes_) {
      for (std::size_t k = 0; k < change.change.size(); ++k) {
        if (change.change[k] != 1 || change.is_edge) continue;
        const double by =
            changes[change.cone][k] * model_.scale(model_.cones()[change.cone], k);
        change_by(change, on_grid(by, bits));
      }
    }
  }

  const std::vector<ConeForce>& forces() const { return forces_; }

  /// Returns whether all forces are in their cones.
  bool is_lawful() const {
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      if (!StaticsModel::is_in(model_.cones()[i], forces_[i])) return false;
    }
    return true;
  }

 private:
  static RationalRow opposite(RationalRow row) {
    for (Rational& entry : row) entry = -entry;
    return row;
  }

  void add(std::size_t i, ConeForce change, double weight) {
    const ForceCone& cone = model_.cones()[i];
    std::map<std::size_t, Rational> sum;
    for (std::size_t k = 0; k < change.size(); ++k) {
      if (change[k].is_zero()) continue;
      for (const auto& [j, entry] : k == 0 ? cone.normal : cone.slips[k - 1]) {
        sum[j] += change[k] * entry;
      }
    }
    changes_.push_back({i, std::move(change), {sum.begin(), sum.end()}, weight, false});
  }

  void add_wrench(const ForceCone& cone, const ConeForce& force) {
    stickslip::add_multiple(left_, force[0], cone.normal);
    for (std::size_t k = 0; k < cone.slips.size(); ++k) {
      if (!force[k + 1].is_zero()) stickslip::add_multiple(left_, force[k + 1], cone.slips[k]);
    }
  }

  void change_by(const ForceChange& change, const Rational& multiple) {
    if (multiple.is_zero()) return;
    for (std::size_t k = 0; k < change.change.size(); ++k) {
      forces_[change.cone][k] += multiple * change.change[k];
    }
    stickslip::add_multiple(left_, multiple, change.column);
  }

  /// Pushes what is left of each body to those nearer to the ground. Bodies are taken in the
  /// order in which most changes join them to the ground and those before them.
  bool balance_by_tree() {
    const std::vector<std::size_t>& bodies = model_.bodies();
    const std::size_t count = bodies.empty() ? 0 : bodies.back() + 1;
    std::vector<std::vector<std::size_t>> touched(changes_.size());
    std::vector<std::vector<std::size_t>> changes_of(count);
    for (std::size_t c = 0; c < changes_.size(); ++c) {
      for (const auto& [j, entry] : changes_[c].column) {
        if (touched[c].empty() || touched[c].back() != bodies[j]) {
          touched[c].push_back(bodies[j]);
          changes_of[bodies[j]].push_back(c);
        }
      }
    }
    std::vector<std::size_t> rows(count);
    for (const std::size_t body : bodies) ++rows[body];
    std::vector<std::size_t> order;
    std::vector<char> is_placed(count, 0);
    std::vector<std::size_t> joined(count, 0);  // changes that need no body that is not placed
    std::vector<double> weight(count, 0);
    std::vector<std::size_t> unplaced(changes_.size());
    using Entry = std::tuple<std::size_t, double, std::size_t>;
    std::priority_queue<Entry> queue;
    const auto join = [&](std::size_t c) {  // all but one of its bodies are placed
      for (const std::size_t body : touched[c]) {
        if (is_placed[body]) continue;
        ++joined[body];
        weight[body] += changes_[c].weight;
        queue.emplace(std::min(joined[body], rows[body]), weight[body], body);
      }
    };
    for (std::size_t c = 0; c < changes_.size(); ++c) {
      unplaced[c] = touched[c].size();
      if (unplaced[c] == 1) join(c);
    }
    for (std::size_t body = 0; body < count; ++body) queue.emplace(0, -1.0, body);
    while (!queue.empty()) {
      const std::size_t body = std::get<2>(queue.top());
      queue.pop();
      if (is_placed[body]) continue;
      is_placed[body] = 1;
      order.push_back(body);
      for (const std::size_t c : changes_of[body]) {
        if (--unplaced[c] == 1) join(c);
      }
    }
    std::vector<std::size_t> first(count, 0);
    for (std::size_t j = bodies.size(); j-- > 0;) first[bodies[j]] = j;
    std::vector<std::size_t> place(count);
    for (std::size_t k = 0; k < count; ++k) place[order[k]] = k;
    const std::vector<ConeForce> forces_before = forces_;
    const RationalRow left_before = left_;
    for (std::size_t k = count; k-- > 0;) {
      const std::size_t body = order[k];
      if (push(body, first[body], rows[body], changes_of[body], touched, place)) continue;
      forces_ = forces_before;
      left_ = left_before;
      return false;
    }
    return true;
  }

  bool push(std::size_t body, std::size_t first, std::size_t rows,
            const std::vector<std::size_t>& changes,
            const std::vector<std::vector<std::size_t>>& touched,
            const std::vector<std::size_t>& place) {
    RationalRow sum;
    bool any = false;
    for (std::size_t r = 0; r < rows; ++r) {
      sum.push_back(-left_[first + r]);
      any = any || !sum.back().is_zero();
    }
    if (!any) return true;
    std::vector<RationalRow> columns;
    std::vector<double> weights;
    std::vector<std::size_t> used;
    for (const std::size_t c : changes) {
      const bool is_last =
          std::all_of(touched[c].begin(), touched[c].end(),
                      [&](std::size_t other) { return place[other] <= place[body]; });
      if (!is_last) continue;
      RationalRow& column = columns.emplace_back(rows);
      for (const auto& [j, entry] : changes_[c].column) {
        if (j >= first && j < first + rows) column[j - first] = entry;
      }
      weights.push_back(changes_[c].weight);
      used.push_back(c);
    }
    const std::vector<double> units(
        model_.arms().begin() + static_cast<std::ptrdiff_t>(first),
        model_.arms().begin() + static_cast<std::ptrdiff_t>(first + rows));
    const auto multiples = few_columns(columns, weights, sum, units);
    if (!multiples) return false;
    for (std::size_t k = 0; k < used.size(); ++k) change_by(changes_[used[k]], (*multiples)[k]);
    return true;
  }

  const StaticsModel& model_;
  RationalRow left_;  ///< load and forces together
  std::vector<ConeForce> forces_;
  std::vector<ForceChange> changes_;
};

/// The answer in the model's coordinates.
using ModelAnswer = std::variant<std::vector<ConeForce>, RationalRow, std::monostate>;

/// Decides a load of a model.
class StaticsSearch {
 public:
  StaticsSearch(const StaticsModel& model, const RationalRow& load)
      : model_(model), load_(load) {}

  ModelAnswer run() const {
    for (const bool is_long : {false, true}) {
      const ConeSearch search(model_.rounded(load_), is_long);
      const ConeProposal& proposal = search.proposal();
      for (const bool rests : {proposal.rests, !proposal.rests}) {
        if (rests) {
          if (auto forces = exact_forces(search)) return std::move(*forces);
        } else if (auto motion = exact_motion(proposal)) {
          return std::move(*motion);
        }
      }
    }
    return by_program();
  }

 private:
  static constexpr double kBorders[] = {1e-10, 1e-7, 1e-4};

  std::optional<std::vector<ConeForce>> exact_forces(const ConeSearch& search) const {
    for (const double border : kBorders) {
      for (const int bits : {16, 32, 52}) {
        ForceRounding rounding(model_, load_, search.proposal(), bits, border);
        if (bits == 52) {
          rounding.refine(search, 80);
          rounding.refine(search, 110);
        }
        if (!rounding.balance()) break;
        if (rounding.is_lawful()) return rounding.forces();
      }
    }
    return std::nullopt;
  }

  bool is_proof(const RationalRow& y) const {
    return dot(load_, y).sign() > 0 && std::all_of(model_.cones().begin(), model_.cones().end(),
                                                   [&](const ForceCone& cone) {
                                                     return StaticsModel::is_unopposed(cone, y);
                                                   });
  }

  std::optional<RationalRow> exact_motion(const ConeProposal& proposal) const {
    RationalRow y(model_.size());
    for (const int bits : {8, 16, 32, 52}) {
      for (std::size_t j = 0; j < y.size(); ++j) {
        y[j] = on_grid(proposal.motion[j], bits) / rational_from_double(model_.arms()[j]);
      }
      if (is_proof(y)) return y;
    }
    if (model_.size() > kMostDense) return std::nullopt;
    for (const double border : kBorders) {
      RationalRow close = on_borders(y, proposal, border);
      if (is_proof(close)) return close;
    }
    return std::nullopt;
  }

  /// Returns a motion near y on which contacts that nearly oppose it just do not.
  RationalRow on_borders(RationalRow y, const ConeProposal& proposal, double border) const {
    std::vector<RationalRow> rows;
    const auto add = [&](const SparseRow& row) {
      stickslip::add_multiple(rows.emplace_back(y.size()), 1, row);
    };
    for (std::size_t i = 0; i < model_.cones().size(); ++i) {
      if (proposal.gaps[i] > border) continue;
      const ForceCone& cone = model_.cones()[i];
      const double press = to_double(dot(cone.normal, y));
      double size = 0;
      for (const auto& [j, entry] : cone.normal)
        size = std::max(size, std::fabs(to_double(entry) / model_.arms()[j]));
      if (press <= std::sqrt(border) * size || cone.slips.empty()) {
        add(cone.normal);
        for (const SparseRow& slip : cone.slips) add(slip);
      } else if (const auto most = exact_sqrt(cone.squared_most);
                 most && cone.slips.size() == 1) {
        add(cone.normal);
        const int sign = dot(cone.slips[0], y).sign();
        stickslip::add_multiple(rows.back(), sign < 0 ? *most : Rational(-*most),
                                cone.slips[0]);
      }
    }
    if (rows.empty()) return y;
    RationalRow off;
    for (const RationalRow& row : rows) off.push_back(-dot(row, y));
    std::vector<RationalRow> columns(y.size(), RationalRow(rows.size()));
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t j = 0; j < y.size(); ++j) columns[j][r] = rows[r][j];
    }
    std::vector<double> weights;
    for (const double arm : model_.arms()) weights.push_back(1 / arm);
    const auto change =
        few_columns(columns, weights, off, std::vector<double>(rows.size(), 1.0));
    for (std::size_t j = 0; change && j < y.size(); ++j) y[j] += (*change)[j];
    return y;
  }

  /// Decides by an exact linear program, if cones have rational edges.
  ModelAnswer by_program() const {
    if (model_.size() > kMostDense) return std::monostate{};
    LinearProgram program;
    std::vector<RationalRow> rows(model_.size());
    std::vector<std::pair<std::size_t, Rational>> edges;  // of a cone, and its friction
    const auto add = [&](std::size_t i, const Rational& friction) {
      const ForceCone& cone = model_.cones()[i];
      const std::size_t variable = program.add_variable(VariableKind::kNonNegative);
      for (RationalRow& row : rows) row.resize(variable + 1);
      for (const auto& [j, entry] : cone.normal) rows[j][variable] += entry;
      if (!friction.is_zero()) {
        for (const auto& [j, entry] : cone.slips[0]) rows[j][variable] += friction * entry;
      }
      edges.emplace_back(i, friction);
    };
    for (std::size_t i = 0; i < model_.cones().size(); ++i) {
      const ForceCone& cone = model_.cones()[i];
      if (cone.slips.empty()) {
        add(i, 0);
        continue;
      }
      const auto most = exact_sqrt(cone.squared_most);
      if (cone.slips.size() > 1 || !most) return std::monostate{};
      add(i, *most);
      add(i, Rational(-*most));
    }
    for (std::size_t j = 0; j < rows.size(); ++j) {
      program.add_row(std::move(rows[j]), Relation::kEqual, -load_[j]);
    }
    const LpResult result = solve(program);
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      RationalRow y = infeasible->farkas;
      for (Rational& entry : y) entry = -entry;
      return y;
    }
    std::vector<ConeForce> forces;
    for (const ForceCone& cone : model_.cones()) forces.emplace_back(cone.slips.size() + 1);
    const RationalRow& point = std::get<Optimal>(result).point;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto& [i, friction] = edges[e];
      forces[i][0] += point[e];
      if (!friction.is_zero()) forces[i][1] += friction * point[e];
    }
    return forces;
  }

  const StaticsModel& model_;
  const RationalRow& load_;
};

RationalRow wrench_of_point(const GraspBox& grasp) {
  RationalRow wrench;
  for (const Interval& w : grasp.wrench) wrench.push_back(w.low);
  return wrench;
}

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
    ModelAnswer answer = StaticsSearch(model, model.load()).run();
    if (const auto* forces = std::get_if<std::vector<ConeForce>>(&answer)) {
      found_.high = std::min(factor, needed(*forces));
      found_.forces = model.forces_of(*forces, wrench_of_point(grasp_));
      stands_ = true;
      return true;
    }
    const auto* y = std::get_if<RationalRow>(&answer);
    if (y == nullptr) return false;
    const std::optional<Rational> most = harmless(*y);
    found_.motion = {model.motion_of(*y)};
    always_moves_ = !most;
    if (most) found_.low = std::max(factor, *most);
    return true;
  }

  bool stands() const { return stands_; }
  bool always_moves() const { return always_moves_; }
  const LeastFriction& found() const { return found_; }

 private:
  static constexpr unsigned kBits = 64;

  /// Returns a factor with which forces are in their cones.
  Rational needed(const std::vector<ConeForce>& forces) const {
    Rational most = 0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const ForceCone& cone = plain_.cones()[i];
      Rational square = 0;
      for (std::size_t k = 0; k + 1 < forces[i].size(); ++k) {
        square += forces[i][k + 1] * forces[i][k + 1] * cone.squares[k];
      }
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
      Rational square = 0;
      for (std::size_t k = 0; k < cone.slips.size(); ++k) {
        const Rational work = dot(cone.slips[k], y);
        if (!work.is_zero()) square += work * work / cone.squares[k];
      }
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
  bool stands_ = false;
  bool always_moves_ = false;
};

}  // namespace
}  // namespace earlier_detail

using namespace earlier_detail;

LoadClass statics(const GraspBox& grasp, const Rational& friction_factor) {
  const StaticsModel model(grasp, friction_factor);
  ModelAnswer answer = StaticsSearch(model, model.load()).run();
  if (const auto* forces = std::get_if<std::vector<ConeForce>>(&answer)) {
    return model.forces_of(*forces, wrench_of_point(grasp));
  }
  if (const auto* y = std::get_if<RationalRow>(&answer)) {
    return UnopposedMotion{model.motion_of(*y)};
  }
  return kBorder;
}

std::variant<LeastFriction, UnopposedMotion, Undecided> least_friction(
    const GraspBox& grasp, const Rational& accuracy) {
  FrictionBracket bracket(grasp);
  for (const int factor : {0, 1, 32, 1000, 1000000}) {
    if (bracket.ask(factor) && bracket.always_moves()) return bracket.found().motion;
    if (bracket.stands()) break;
  }
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
