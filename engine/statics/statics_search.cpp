// SPDX-License-Identifier: GPL-3.0-or-later
#include "statics_search.hpp"

#include <algorithm>
#include <cmath>

#include "few_columns.hpp"
#include "force_rounding.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::statics_detail {

std::optional<EdgeProgram> EdgeProgram::of(const StaticsModel& model) {
  if (model.size() > kMostDense) return std::nullopt;
  EdgeProgram result(model);
  for (std::size_t i = 0; i < model.cones().size(); ++i) {
    const ForceCone& cone = model.cones()[i];
    if (cone.slips.empty()) {
      result.edges_.emplace_back(i, 0);
      continue;
    }
    const auto most = exact_sqrt(cone.squared_most);
    if (cone.slips.size() > 1 || !most) return std::nullopt;
    result.edges_.emplace_back(i, *most);
    result.edges_.emplace_back(i, Rational(-*most));
  }
  return result;
}

LinearProgram EdgeProgram::balancing(const RationalRow& load,
                                     const std::vector<RationalRow>& more,
                                     VariableKind kind) const {
  LinearProgram program;
  std::vector<RationalRow> rows(model_->size(), RationalRow(edges_.size()));
  program.add_variables(edges_.size(), VariableKind::kNonNegative);
  program.add_variables(more.size(), kind);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto& [i, friction] = edges_[e];
    const ForceCone& cone = model_->cones()[i];
    for (const auto& [j, entry] : cone.normal) rows[j][e] += entry;
    if (friction.is_zero()) continue;
    for (const auto& [j, entry] : cone.slips[0]) rows[j][e] += friction * entry;
  }
  for (std::size_t j = 0; j < rows.size(); ++j) {
    for (const RationalRow& growth : more) rows[j].push_back(growth[j]);
    program.add_row(std::move(rows[j]), Relation::kEqual, -load[j]);
  }
  return program;
}

std::vector<ConeForce> EdgeProgram::forces_at(const RationalRow& point) const {
  std::vector<ConeForce> forces;
  for (const ForceCone& cone : model_->cones()) forces.emplace_back(cone.slips.size() + 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto& [i, friction] = edges_[e];
    forces[i][0] += point[e];
    if (!friction.is_zero()) forces[i][1] += friction * point[e];
  }
  return forces;
}

namespace {

/// Decides a load of a model.
class StaticsSearch {
 public:
  StaticsSearch(const StaticsModel& model, const RationalRow& load)
      : model_(model), load_(load) {}

  /// Doubles are asked first, unless that is of no use, and then long doubles.
  ModelAnswer run(bool& needs_long) const {
    for (const bool is_long : {false, true}) {
      if (needs_long && !is_long) continue;
      needs_long = is_long;
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

  /// Does the same for motions alone, in doubles.
  std::optional<RationalRow> motion() const {
    const ConeSearch search(model_.rounded(load_));
    const ConeProposal& proposal = search.proposal();
    return proposal.rests ? std::nullopt : exact_motion(proposal);
  }

 private:
  static constexpr double kBorders[] = {1e-10, 1e-7, 1e-4};

  std::optional<std::vector<ConeForce>> exact_forces(const ConeSearch& search) const {
    for (const double border : kBorders) {
      const double depth = least_depth(search.proposal(), border);
      for (const int bits : {16, 32, 52}) {
        // A grid that is as wide as forces are deep does not leave them in their cones.
        if (bits < 52 && std::ldexp(1.0, -bits) > depth) continue;
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

  /// Returns how deep forces are in their cones, but those that will be put on the border, over
  /// the largest.
  static double least_depth(const ConeProposal& proposal, double border) {
    double largest = 0;
    for (const auto& z : proposal.forces) largest = std::max(largest, z[0]);
    double least = largest;
    for (const auto& z : proposal.forces) {
      double tail = 0;
      for (std::size_t k = 1; k < z.size(); ++k) tail = std::hypot(tail, z[k]);
      const double depth = z[0] - tail;
      if (z[0] > border * largest && depth > border * z[0]) least = std::min(least, depth);
    }
    return largest > 0 ? least / largest : 0;
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
    std::optional<EdgeProgram> edges = EdgeProgram::of(model_);
    if (!edges) return std::monostate{};
    const LpResult result = solve(edges->balancing(load_, {}, VariableKind::kFree));
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      return opposite(infeasible->farkas);
    }
    return edges->forces_at(std::get<Optimal>(result).point);
  }

  const StaticsModel& model_;
  const RationalRow& load_;
};

}  // namespace

std::optional<RationalRow> unopposed_motion(const StaticsModel& model,
                                            const RationalRow& load) {
  return StaticsSearch(model, load).motion();
}

ModelAnswer decide_load(const StaticsModel& model, const RationalRow& load) {
  bool needs_long = false;
  return decide_load(model, load, needs_long);
}

ModelAnswer decide_load(const StaticsModel& model, const RationalRow& load, bool& needs_long) {
  return StaticsSearch(model, load).run(needs_long);
}

}  // namespace stickslip::statics_detail
