// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigid_cells.hpp"

#include "stickslip/core/box.hpp"
#include "stickslip/core/integer_vector.hpp"

namespace stickslip::earlier_detail {
namespace {

using Slip = RigidCell::Slip;

/// Returns the sign of lambda if v = lambda u; 0 if there is no such lambda.
int proportion(const Wrench& u, const Wrench& v) {
  const IntegerVector<3> one = primitive_multiple(coordinates(u));
  const IntegerVector<3> other = primitive_multiple(coordinates(v));
  if (one == other) return 1;
  return one == primitive_multiple(coordinates(Rational(-1) * v)) ? -1 : 0;
}

Slip opposite(Slip slip) {
  return slip == Slip::kPlus ? Slip::kMinus : slip == Slip::kMinus ? Slip::kPlus : slip;
}
}  // namespace

std::vector<RigidCell> RigidCell::children(const Problem& problem,
                                           const RigidSplit& split) const {
  std::vector<RigidCell> result;
  const std::vector<ContactRow>& rows = problem.rows();
  const ContactRow& row = problem.row(split.contact);
  if (!split.slip) {
    for (const Touch touch : {Touch::kTouching, Touch::kApart}) {
      RigidCell child = *this;
      for (std::size_t j = 0; j < rows.size(); ++j) {
        if (proportion(row.normal, rows[j].normal) > 0) child.touch_[j] = touch;
      }
      result.push_back(std::move(child));
    }
    return result;
  }
  for (const Slip slip : {Slip::kPlus, Slip::kNone, Slip::kMinus}) {
    RigidCell child = *this;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      const int along = proportion(row.tangent, rows[j].tangent);
      if (along != 0) child.slip_[j] = along > 0 ? slip : opposite(slip);
    }
    result.push_back(std::move(child));
  }
  return result;
}

std::optional<RigidSplit> RigidCell::split_for(const Problem& problem, const CellPoint& point,
                                               const Rational& least_friction) const {
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const ContactForce& f = point.forces[i];
    const bool parts = !(f.normal * power(row.normal, point.acceleration)).is_zero();
    if (parts && touch_[i] == Touch::kUnknown) return RigidSplit{ContactId(i)};
    const Rational slip = power(row.tangent, point.acceleration);
    const bool drives =
        (least_friction * row.friction * f.normal * abs(slip) + f.tangential * slip).sign() > 0;
    if (drives && slip_[i] == Slip::kUnknown) return RigidSplit{ContactId(i), true};
  }
  return std::nullopt;
}

CellProgram::CellProgram(const Problem& problem, const Inertia& inertia, const RigidCell& cell,
                         const FrictionRange& friction)
    : problem_(problem), slip_rows_(problem.size()) {
  program_.add_variables(3, VariableKind::kFree);
  for (const RationalRow& axis : {RationalRow{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    const RationalRow column = times_mass(inertia, axis);
    for (std::size_t j = 0; j < 3; ++j) balance_[j].push_back(column[j]);
  }
  const auto add_edge = [&](std::size_t contact, const ContactForce& force) {
    const ContactRow& row = problem.rows()[contact];
    program_.add_variable(VariableKind::kNonNegative);
    edges_.push_back({contact, force});
    const Vector3 column =
        coordinates(force.normal * row.normal + force.tangential * row.tangent);
    for (std::size_t j = 0; j < 3; ++j) balance_[j].push_back(-column[j]);
  };
  for (std::size_t i = 0; i < problem.size(); ++i) {
    const ContactRow& row = problem.rows()[i];
    const Touch touch = cell.touch(i);
    const Slip slip = cell.slip(i);
    program_.add_row(row_of(row.normal),
                     touch == Touch::kTouching ? Relation::kEqual : Relation::kGreaterEqual, 0);
    if (slip != Slip::kUnknown) {
      slip_rows_[i] = program_.add_row(row_of(row.tangent),
                                       slip == Slip::kPlus    ? Relation::kGreaterEqual
                                       : slip == Slip::kMinus ? Relation::kLessEqual
                                                              : Relation::kEqual,
                                       0);
    }
    if (touch == Touch::kApart) continue;
    for (const int side : {1, -1}) {
      // Friction opposes slip.
      if (slip == (side > 0 ? Slip::kPlus : Slip::kMinus)) continue;
      const Rational mu = side * row.friction;
      if (friction.high) add_edge(i, {1, *friction.high * mu});
      if (!friction.high) add_edge(i, {0, mu});
      const bool slips = slip == Slip::kPlus || slip == Slip::kMinus;
      if (!friction.high || (slips && *friction.high != friction.low)) {
        add_edge(i, {1, friction.low * mu});
      }
    }
  }
}

std::size_t CellProgram::add_growth(const Wrench& u) {
  const std::size_t variable = program_.add_variable(VariableKind::kNonNegative);
  for (std::size_t j = 0; j < 3; ++j) balance_[j].push_back(-coordinates(u)[j]);
  return variable;
}

LinearProgram CellProgram::program() const {
  LinearProgram result = program_;
  for (std::size_t j = 0; j < 3; ++j) {
    result.add_row(balance_[j], Relation::kEqual, coordinates(problem_.wrench())[j]);
  }
  return result;
}

CellPoint CellProgram::point(const std::vector<Rational>& x) const {
  CellPoint result{{x[0], x[1], x[2]}, std::vector<ContactForce>(problem_.size())};
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    ContactForce& f = result.forces[edges_[e].contact];
    f.normal += x[3 + e] * edges_[e].force.normal;
    f.tangential += x[3 + e] * edges_[e].force.tangential;
  }
  return result;
}

std::variant<CellPoint, RigidLeaf> CellProgram::moving() const {
  const auto found = most_power(program(), row_of(problem_.wrench()));
  if (const auto* none = std::get_if<NoPower>(&found)) return leaf(*none);
  return point(std::get<std::vector<Rational>>(found));
}

RigidLeaf CellProgram::leaf(const NoPower& none) const {
  const auto at = [&](std::size_t row) { return none.multipliers[row]; };
  const std::size_t rows = program_.row_count();
  RigidLeaf result{none.weight, {at(rows), at(rows + 1), at(rows + 2)}, {}, {}};
  std::size_t row = 0;
  for (std::size_t i = 0; i < problem_.size(); ++i) {
    if (const Rational normal = at(row++); !normal.is_zero()) {
      result.normal.emplace_back(ContactId(i), normal);
    }
    if (!slip_rows_[i]) continue;
    if (const Rational tangent = at(row++); !tangent.is_zero()) {
      result.tangent.emplace_back(ContactId(i), RationalRow{tangent});
    }
  }
  return result;
}

namespace {

/// Branch and bound over cells, children in their order.
class Search {
 public:
  Search(const Problem& problem, const Inertia& inertia, const FrictionRange& friction,
         std::size_t most_programs)
      : problem_(problem),
        inertia_(inertia),
        friction_(friction),
        programs_left_(most_programs) {}

  /// Returns false to end the search.
  bool refutes(const RigidCell& cell) {
    if (programs_left_ == 0) {
      result.limited = true;
      return false;
    }
    --programs_left_;
    auto solved = CellProgram(problem_, inertia_, cell, friction_).moving();
    if (auto* leaf = std::get_if<RigidLeaf>(&solved)) {
      result.tree.emplace_back(std::move(*leaf));
      return true;
    }
    const auto& point = std::get<CellPoint>(solved);
    const std::optional<RigidSplit> split = cell.split_for(problem_, point, friction_.low);
    if (!split) {
      result.found = point;
      return false;
    }
    result.tree.emplace_back(*split);
    for (const RigidCell& child : cell.children(problem_, *split)) {
      if (!refutes(child)) return false;
    }
    return true;
  }

  AccelerationSearch result;

 private:
  const Problem& problem_;
  const Inertia& inertia_;
  const FrictionRange& friction_;
  std::size_t programs_left_;
};

}  // namespace

AccelerationSearch search_accelerations(const Problem& problem, const Inertia& inertia,
                                        const FrictionRange& friction,
                                        std::size_t most_programs) {
  Search search(problem, inertia, friction, most_programs);
  search.refutes(RigidCell(problem));
  return std::move(search.result);
}

}  // namespace stickslip::earlier_detail
