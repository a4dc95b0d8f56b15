// SPDX-License-Identifier: GPL-3.0-or-later
#include "spatial_cells.hpp"

#include <cmath>

#include "stickslip/core/integer_vector.hpp"

namespace stickslip::earlier_detail {
namespace {

template <std::size_t n>
RationalRow row_of(const std::array<Rational, n>& v) {
  return {v.begin(), v.end()};
}

Vector6 unit(std::size_t j) {
  Vector6 result{};
  result[j] = 1;
  return result;
}

}  // namespace

std::vector<FrictionDisc> discs_of(const GraspBox& grasp) {
  return {grasp.contacts.begin(), grasp.contacts.end()};
}

Vector6 load_of(const GraspBox& grasp) {
  Vector6 load;
  for (std::size_t j = 0; j < 6; ++j) load[j] = grasp.wrench.at(j).low;
  return load;
}

SpatialProgram::SpatialProgram(const std::vector<FrictionDisc>& discs, const Vector6& load,
                               const Inertia* inertia, const SpatialCell& cell,
                               DiscPolygon polygon)
    : discs_(discs), load_(load), motions_(inertia == nullptr ? 0 : 6) {
  program_.add_variables(motions_, VariableKind::kFree);
  for (std::size_t k = 0; k < motions_; ++k) {
    const RationalRow column = times_mass(*inertia, row_of(unit(k)));
    for (std::size_t j = 0; j < 6; ++j) balance_[j].push_back(column[j]);
  }
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const FrictionDisc& disc = discs[i];
    const SpatialLabel& label = cell[i];
    const auto along = [&](const Vector3& covector, Relation relation) {
      const IntegerVector3 c = primitive_multiple(covector);
      const Vector3 shortened{Rational(c[0]), Rational(c[1]), Rational(c[2])};
      rows_.push_back({i, shortened});
      add_row(disc.wrench(shortened), relation);
    };
    if (motions_ != 0) {
      rows_.push_back({i, std::nullopt});
      add_row(disc.normal_row(),
              label.touch == Touch::kTouching ? Relation::kEqual : Relation::kGreaterEqual);
      const Vector3& n = disc.normal();
      if (label.slip == SpatialLabel::Slip::kNone) {
        along(disc.direction(0, 0), Relation::kEqual);
        along(disc.direction(1, 0), Relation::kEqual);
      } else if (label.slip == SpatialLabel::Slip::kLine) {
        along(label.line, Relation::kGreaterEqual);
        along(cross(n, label.line), Relation::kEqual);
      } else if (label.slip == SpatialLabel::Slip::kSector) {
        const std::vector<Vector3> sides = discs[label.owner].directions(label.sector);
        along(cross(n, sides.front()), Relation::kGreaterEqual);
        along(cross(sides.back(), n), Relation::kGreaterEqual);
      }
    }
    if (label.touch == Touch::kApart) continue;
    const std::vector<Vector3> corners =
        label.slip == SpatialLabel::Slip::kSector
            ? disc.outer_against(discs[label.owner].directions(label.sector))
        : label.slip == SpatialLabel::Slip::kLine
            ? std::vector<Vector3>{*disc.against(label.line)}
        : polygon == DiscPolygon::kOuter ? disc.outer()
                                         : disc.inner();
    for (const Vector3& friction : corners) add_edge(i, friction);
  }
  for (std::size_t j = 0; j < 6; ++j) {
    program_.add_row(balance_[j], Relation::kEqual, load[j]);
  }
}

void SpatialProgram::add_edge(std::size_t contact, const Vector3& friction) {
  program_.add_variable(VariableKind::kNonNegative);
  edges_.push_back({contact, friction});
  const FrictionDisc& disc = discs_[contact];
  const Vector6 wrench = plus(disc.normal_row(), 1, disc.wrench(friction));
  for (std::size_t j = 0; j < 6; ++j) balance_[j].push_back(-wrench[j]);
}

void SpatialProgram::add_row(const Vector6& row, Relation relation) {
  program_.add_row(row_of(row), relation, 0);
}

SpatialPoint SpatialProgram::point(const std::vector<Rational>& x) const {
  SpatialPoint result{{}, SpatialForces(discs_.size())};
  for (std::size_t j = 0; j < motions_; ++j) result.acceleration[j] = x[j];
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Rational& amount = x[motions_ + e];
    if (amount.is_zero()) continue;
    SpatialContactForce& force = result.forces[edges_[e].contact];
    force.normal += amount;
    force.friction = plus(force.friction, amount, edges_[e].friction);
  }
  return result;
}

std::optional<SpatialForces> SpatialProgram::at_rest(Vector6& twist) const {
  const LpResult solved = solve(program_);
  if (const auto* none = std::get_if<Infeasible>(&solved)) {
    for (std::size_t j = 0; j < 6; ++j) twist[j] = none->farkas[j];
    return std::nullopt;
  }
  return point(std::get<Optimal>(solved).point).forces;
}

std::variant<SpatialPoint, RigidLeaf> SpatialProgram::moving() const {
  const auto found = most_power(program_, row_of(load_));
  if (const auto* none = std::get_if<NoPower>(&found)) return leaf(*none);
  return point(std::get<std::vector<Rational>>(found));
}

RigidLeaf SpatialProgram::leaf(const NoPower& none) const {
  const auto at = [&](std::size_t row) { return none.multipliers[row]; };
  RigidLeaf result{none.weight, {}, {}, {}};
  for (std::size_t j = 0; j < 6; ++j) result.twist.push_back(at(rows_.size() + j));
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (at(r).is_zero()) continue;
    const ContactId contact(rows_[r].contact);
    if (!rows_[r].along) {
      result.normal.emplace_back(contact, at(r));
      continue;
    }
    if (result.tangent.empty() || result.tangent.back().first != contact) {
      result.tangent.emplace_back(contact, RationalRow(3));
    }
    for (std::size_t j = 0; j < 3; ++j) {
      result.tangent.back().second[j] += at(r) * (*rows_[r].along)[j];
    }
  }
  return result;
}

bool is_solution(const std::vector<FrictionDisc>& discs, const Vector6& load,
                 const Inertia& inertia, const SpatialPoint& point) {
  const Vector6& a = point.acceleration;
  const RationalRow inert = times_mass(inertia, row_of(a));
  Vector6 left = load;
  for (std::size_t j = 0; j < 6; ++j) left[j] -= inert[j];
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const FrictionDisc& disc = discs[i];
    const auto& [normal, friction] = point.forces[i];
    const Rational parts = dot(disc.normal_row(), a);
    const Rational limit = disc.square() * normal * normal;
    if (normal.sign() < 0 || parts.sign() < 0 || !(normal * parts).is_zero()) return false;
    if (!dot(friction, disc.normal()).is_zero() || dot(friction, friction) > limit)
      return false;
    const Vector3 slip = disc.slip(a);
    const Rational power = dot(friction, slip);
    if (power.sign() > 0 || power * power != limit * dot(slip, slip)) return false;
    left = plus(plus(left, normal, disc.normal_row()), 1, disc.wrench(friction));
  }
  return left == Vector6{};
}

namespace {

/// Returns the fraction with the least denominator in [low, high], 0 <= low.
Rational simplest(const Rational& low, const Rational& high) {
  const Integer whole = numerator(low) / denominator(low);
  if (Rational(whole) == low) return low;
  if (Rational(whole + 1) <= high) return Rational(whole + 1);
  return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole));
}

/// Branch and bound over cells, children in their order.
class SpatialSearch {
 public:
  SpatialSearch(std::vector<FrictionDisc>& discs, const Vector6& load, const Inertia& inertia,
                std::size_t most_programs)
      : discs_(discs), load_(load), inertia_(inertia), programs_left_(most_programs) {}

  /// Returns false to end the search.
  bool refutes(const SpatialCell& cell, std::size_t depth) {
    for (;;) {
      if (programs_left_ == 0 || depth > 2 * discs_.size() + 250) {
        return gives_up("it takes too many linear programs", "limit");
      }
      --programs_left_;
      auto solved =
          SpatialProgram(discs_, load_, &inertia_, cell, DiscPolygon::kOuter).moving();
      if (auto* leaf = std::get_if<RigidLeaf>(&solved)) {
        result.tree.emplace_back(std::move(*leaf));
        return true;
      }
      const auto& point = std::get<SpatialPoint>(solved);
      if (is_solution(discs_, load_, inertia_, point)) {
        result.found = point;
        return false;
      }
      const Breach breach = worst_breach(cell, point);
      if (breach.power < kNearlyLawful && is_near_a_solution(cell, point)) return false;
      if (breach.power < kSame) {
        if (refines(cell, point)) continue;
        return gives_up(
            "accelerations obey the laws to all digits of doubles, but none was found "
            "that does exactly",
            "border");
      }
      return splits(cell, breach, depth);
    }
  }

  SpatialSearchResult result;

 private:
  /// The place where a point breaks the model most, by a part of the load's power.
  struct Breach {
    double power = 0;
    std::size_t contact = 0;
    bool slips = false;
    Vector3 slip{};
  };
  static constexpr double kNearlyLawful = 0.05;
  static constexpr double kSame = 1e-9;

  bool gives_up(const std::string& limit, const std::string& reason) {
    result.undecided =
        Undecided{limit, reason, "ask about a load or friction a little off", {}};
    return false;
  }

  Breach worst_breach(const SpatialCell& cell, const SpatialPoint& point) const {
    Breach worst;
    const double total = to_double(dot(load_, point.acceleration));
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const auto& [normal, friction] = point.forces[i];
      if (normal.is_zero()) continue;
      const double parting =
          to_double(normal * dot(discs_[i].normal_row(), point.acceleration)) / total;
      if (parting > worst.power && cell[i].touch == Touch::kUnknown) {
        worst = {parting, i, false, {}};
      }
      const Vector3 slip = discs_[i].slip(point.acceleration);
      const double size = std::sqrt(to_double(dot(slip, slip) * discs_[i].square()));
      const double driving =
          (to_double(dot(friction, slip)) + to_double(normal) * size) / total;
      if (driving > worst.power && cell[i].slip != SpatialLabel::Slip::kNone &&
          discs_[i].has_friction()) {
        worst = {driving, i, true, slip};
      }
    }
    return worst;
  }

  /// Makes polygons finer where a force leaves its cone. Returns false if none can be.
  bool refines(const SpatialCell& cell, const SpatialPoint& point) {
    bool finer = false;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const auto& [normal, friction] = point.forces[i];
      if (cell[i].slip == SpatialLabel::Slip::kSector ||
          dot(friction, friction) <= discs_[i].square() * normal * normal) {
        continue;
      }
      finer = discs_[i].refine(friction) || finer;
    }
    return finer;
  }

  bool splits(const SpatialCell& cell, const Breach& breach, std::size_t depth) {
    const std::size_t i = breach.contact;
    std::vector<SpatialCell> children;
    RigidSplit split{ContactId(i), breach.slips};
    const auto add = [&](const auto& set, bool of_slip) {
      children.push_back(cell);
      for (std::size_t j = 0; j < discs_.size(); ++j) {
        if (of_slip ? discs_[i].slips_like(discs_[j]) : discs_[i].presses_like(discs_[j])) {
          set(children.back()[j]);
        }
      }
    };
    const auto add_sector = [&](const Sector& sector, std::size_t owner) {
      add(
          [&](SpatialLabel& label) {
            label.slip = SpatialLabel::Slip::kSector;
            label.sector = sector;
            label.owner = owner;
          },
          true);
    };
    if (!breach.slips) {
      for (const Touch touch : {Touch::kTouching, Touch::kApart}) {
        add([&](SpatialLabel& label) { label.touch = touch; }, false);
      }
    } else if (cell[i].slip == SpatialLabel::Slip::kUnknown) {
      split.direction = row_of(discs_[i].direction(0, 0));
      add([](SpatialLabel& label) { label.slip = SpatialLabel::Slip::kNone; }, true);
      for (std::size_t q = 0; q < 4; ++q) add_sector({q, 0, 1}, i);
    } else {
      const Sector& sector = cell[i].sector;
      const std::size_t owner = cell[i].owner;
      const Rational middle = (sector.low + sector.high) / 2;
      split.direction = row_of(discs_[owner].direction(sector.quarter, middle));
      add_sector({sector.quarter, sector.low, middle}, owner);
      add_sector({sector.quarter, middle, sector.high}, owner);
    }
    result.tree.emplace_back(split);
    for (const SpatialCell& child : children) {
      if (!refutes(child, depth + 1)) return false;
    }
    return true;
  }

  /// Returns true if an exact solution is near the point: the same contacts touch, and slip in
  /// the simplest directions near theirs.
  bool is_near_a_solution(const SpatialCell& cell, const SpatialPoint& point) {
    if (attempts_left_ == 0) return false;
    --attempts_left_;
    SpatialCell mode = cell;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      SpatialLabel& label = mode[i];
      label.touch = point.forces[i].normal.is_zero() ? Touch::kApart : Touch::kTouching;
      label.slip = SpatialLabel::Slip::kUnknown;
      if (label.touch == Touch::kApart || !discs_[i].has_friction()) continue;
      const Vector3 slip = discs_[i].slip(point.acceleration);
      label.slip = SpatialLabel::Slip::kNone;
      if (is_zero(primitive_multiple(slip))) continue;
      Sector there = discs_[i].near(slip);
      const bool known = cell[i].slip == SpatialLabel::Slip::kSector;
      const Rational off(1, 20);
      there.low = known ? cell[i].sector.low : std::max(Rational(0), there.low - off);
      there.high = known ? cell[i].sector.high : std::min(Rational(1), there.high + off);
      if (known) there.quarter = cell[i].sector.quarter;
      label.slip = SpatialLabel::Slip::kLine;
      label.line = discs_[known ? cell[i].owner : i].direction(there.quarter,
                                                               simplest(there.low, there.high));
      if (!discs_[i].against(label.line)) return false;
    }
    const auto solved =
        SpatialProgram(discs_, load_, &inertia_, mode, DiscPolygon::kInner).moving();
    const auto* found = std::get_if<SpatialPoint>(&solved);
    if (found == nullptr || !is_solution(discs_, load_, inertia_, *found)) return false;
    result.found = *found;
    return true;
  }

  std::vector<FrictionDisc>& discs_;
  const Vector6& load_;
  const Inertia& inertia_;
  std::size_t programs_left_;
  std::size_t attempts_left_ = 200;
};

}  // namespace

SpatialSearchResult search_spatial_accelerations(std::vector<FrictionDisc>& discs,
                                                 const Vector6& load, const Inertia& inertia,
                                                 std::size_t most_programs) {
  SpatialSearch search(discs, load, inertia, most_programs);
  search.refutes(SpatialCell(discs.size()), 0);
  return std::move(search.result);
}

}  // namespace stickslip::earlier_detail
