// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "few_columns.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::statics_detail {

ForceRounding::ForceRounding(const StaticsModel& model, const RationalRow& load,
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

bool ForceRounding::balance() {
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

void ForceRounding::refine(const ConeSearch& search, int bits) {
  std::vector<double> left;
  for (std::size_t j = 0; j < left_.size(); ++j) {
    left.push_back(to_double(left_[j]) / model_.arms()[j]);
  }
  const auto changes = search.changes(left);
  for (const ForceChange& change : changes_) {
    for (std::size_t k = 0; k < change.change.size(); ++k) {
      if (change.change[k] != 1 || change.is_edge) continue;
      const double by = changes[change.cone][k] * model_.scale(model_.cones()[change.cone], k);
      change_by(change, on_grid(by, bits));
    }
  }
}

bool ForceRounding::is_lawful() const {
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    if (!StaticsModel::is_in(model_.cones()[i], forces_[i])) return false;
  }
  return true;
}

void ForceRounding::add(std::size_t i, ConeForce change, double weight) {
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

void ForceRounding::add_wrench(const ForceCone& cone, const ConeForce& force) {
  stickslip::add_multiple(left_, force[0], cone.normal);
  for (std::size_t k = 0; k < cone.slips.size(); ++k) {
    if (!force[k + 1].is_zero()) stickslip::add_multiple(left_, force[k + 1], cone.slips[k]);
  }
}

void ForceRounding::change_by(const ForceChange& change, const Rational& multiple) {
  if (multiple.is_zero()) return;
  for (std::size_t k = 0; k < change.change.size(); ++k) {
    forces_[change.cone][k] += multiple * change.change[k];
  }
  stickslip::add_multiple(left_, multiple, change.column);
}

/// Pushes what is left of each body to those nearer to the ground. Bodies are taken in the
/// order in which most changes join them to the ground and those before them.
bool ForceRounding::balance_by_tree() {
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

bool ForceRounding::push(std::size_t body, std::size_t first, std::size_t rows,
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

}  // namespace stickslip::statics_detail
