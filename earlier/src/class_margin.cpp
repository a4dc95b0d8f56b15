// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/class_margin.hpp"

#include <algorithm>

#include "contact_forces.hpp"
#include "rigid_cells.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace earlier_detail {
namespace {

/// Multiples from low to high, or from low on.
struct Multiples {
  Rational low;
  std::optional<Rational> high;
  bool has_low = true;
  bool has_high = true;

  bool contains(const Rational& l) const {
    const bool above = low < l || (has_low && low == l);
    return above && (!high || l < *high || (has_high && l == *high));
  }
  bool contains(const Multiples& other) const {
    const bool below =
        !high || (other.high && (*other.high < *high ||
                                 (*other.high == *high && (has_high || !other.has_high))));
    return below && (low < other.low || (low == other.low && (has_low || !other.has_low)));
  }
};

struct LimitReached {};

class ClassSweep {
 public:
  ClassSweep(const Problem& family, const Inertia& inertia, std::size_t most_programs)
      : family_(family), inertia_(inertia), programs_left_(most_programs) {}

  std::vector<ClassRange> run() {
    find_weak();
    if (weak_) {
      for (int orthant = 0; orthant < 8; ++orthant) {
        for (std::size_t j = 0; j < 3; ++j) signs_[j] = (orthant >> j & 1) == 0 ? 1 : -1;
        take_away(RigidCell(family_));
      }
    }
    return ranges();
  }

 private:
  LpResult solved(const LinearProgram& program) {
    if (programs_left_ == 0) throw LimitReached{};
    --programs_left_;
    return solve(program);
  }

  static std::vector<Rational> objective(std::size_t variable, int sign) {
    std::vector<Rational> result(variable + 1);
    result.back() = sign;
    return result;
  }

  /// Returns the least and greatest value of a variable >= 0; nothing if the program has no
  /// point.
  std::optional<Multiples> extent(LinearProgram program, std::size_t variable) {
    program.minimize(objective(variable, 1));
    const LpResult least = solved(program);
    if (std::holds_alternative<Infeasible>(least)) return std::nullopt;
    Multiples result{std::get<Optimal>(least).value, std::nullopt};
    program.minimize(objective(variable, -1));
    const LpResult greatest = solved(program);
    if (const auto* optimal = std::get_if<Optimal>(&greatest)) result.high = -optimal->value;
    return result;
  }

  void find_weak() {
    LinearProgram program;
    std::array<std::vector<Rational>, 3> balance;
    const std::size_t l = program.add_variable(VariableKind::kNonNegative);
    const Vector3 u = coordinates(family_.load_growth());
    for (std::size_t j = 0; j < 3; ++j) balance[j].push_back(u[j]);
    for (std::size_t i = 0; i < family_.size(); ++i) {
      for (const int side : {1, -1}) {
        program.add_variable(VariableKind::kNonNegative);
        const Vector3 edge = coordinates(family_.edge_wrench(ContactId(i), side));
        for (std::size_t j = 0; j < 3; ++j) balance[j].push_back(edge[j]);
      }
    }
    for (std::size_t j = 0; j < 3; ++j) {
      program.add_row(balance[j], Relation::kEqual, -coordinates(family_.wrench())[j]);
    }
    weak_ = extent(program, l);
  }

  /// Returns true if the program has a point with a != 0, a being in the orthant.
  bool moves(LinearProgram program) {
    program.minimize({-signs_[0], -signs_[1], -signs_[2]});
    const LpResult fastest = solved(program);
    const auto* optimal = std::get_if<Optimal>(&fastest);
    return std::holds_alternative<Unbounded>(fastest) ||
           (optimal != nullptr && optimal->value.sign() < 0);
  }

  /// Adds the multiples under which a solution with a != 0 is in the cell and the orthant.
  void take_away(const RigidCell& cell) {
    CellProgram cell_program(family_, inertia_, cell);
    const std::size_t l = cell_program.add_growth(family_.load_growth());
    LinearProgram program = cell_program.program();
    for (std::size_t j = 0; j < 3; ++j) {
      program.add_row(objective(j, signs_[j]), Relation::kGreaterEqual, 0);
    }
    program.add_row(objective(l, 1), Relation::kGreaterEqual, weak_->low);
    if (weak_->high) program.add_row(objective(l, 1), Relation::kLessEqual, *weak_->high);
    if (!moves(program)) return;
    // Points with a != 0 are dense in a convex set that has one.
    Multiples range = *extent(program, l);
    const auto at = [&](const Rational& value) {
      LinearProgram there = program;
      there.add_row(objective(l, 1), Relation::kEqual, value);
      return there;
    };
    range.has_low = moves(at(range.low));
    if (range.high) range.has_high = moves(at(*range.high));
    if (std::any_of(moving_.begin(), moving_.end(),
                    [&](const Multiples& known) { return known.contains(range); })) {
      return;
    }
    const std::optional<RigidSplit> split = unknown(cell);
    if (!split) {
      moving_.push_back(std::move(range));
      return;
    }
    for (const RigidCell& child : cell.children(family_, *split)) take_away(child);
  }

  std::optional<RigidSplit> unknown(const RigidCell& cell) const {
    for (std::size_t i = 0; i < family_.size(); ++i) {
      if (cell.touch(i) == Touch::kUnknown) return RigidSplit{ContactId(i), false};
    }
    for (std::size_t i = 0; i < family_.size(); ++i) {
      if (cell.touch(i) == Touch::kTouching && cell.slip(i) == RigidCell::Slip::kUnknown &&
          !family_.rows()[i].friction.is_zero()) {
        return RigidSplit{ContactId(i), true};
      }
    }
    return std::nullopt;
  }

  RigidClass class_at(const Rational& l) const {
    if (!weak_ || !weak_->contains(l)) return RigidClass::kMustMove;
    const bool open =
        std::any_of(moving_.begin(), moving_.end(),
                    [&](const Multiples& multiples) { return multiples.contains(l); });
    return open ? RigidClass::kOpen : RigidClass::kMustHold;
  }

  /// Returns the ranges. The class changes only at ends, so it asks about each end and one
  /// multiple behind it.
  std::vector<ClassRange> ranges() const {
    std::vector<Rational> ends{0};
    const auto add = [&](const Multiples& multiples) {
      ends.push_back(multiples.low);
      if (multiples.high) ends.push_back(*multiples.high);
    };
    if (weak_) add(*weak_);
    for (const Multiples& multiples : moving_) add(multiples);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<ClassRange> result;
    const auto append = [&](const ClassRange& range) {
      if (result.empty() || result.back().rigid_class != range.rigid_class) {
        result.push_back(range);
      } else {
        result.back().high = range.high;
        result.back().has_high = range.has_high;
      }
    };
    for (std::size_t k = 0; k < ends.size(); ++k) {
      append({class_at(ends[k]), ends[k], ends[k], true, true});
      const bool last = k + 1 == ends.size();
      const Rational behind = last ? ends[k] + 1 : (ends[k] + ends[k + 1]) / 2;
      append({class_at(behind), ends[k],
              last ? std::nullopt : std::optional<Rational>(ends[k + 1]), false, false});
    }
    return result;
  }

  const Problem& family_;
  const Inertia& inertia_;
  std::size_t programs_left_;
  std::array<int, 3> signs_{};  ///< the signs of the orthant
  std::optional<Multiples> weak_;
  std::vector<Multiples> moving_;
};

}  // namespace
}  // namespace earlier_detail

std::string to_string(RigidClass rigid_class) {
  constexpr const char* kNames[] = {"must move", "must hold", "open"};
  return kNames[static_cast<std::size_t>(rigid_class)];
}

std::variant<std::vector<ClassRange>, Undecided> class_margin(const Problem& family,
                                                              const Inertia& inertia,
                                                              std::size_t most_programs) {
  earlier_detail::require_planar(inertia);
  try {
    return earlier_detail::ClassSweep(family, inertia, most_programs).run();
  } catch (const earlier_detail::LimitReached&) {
    return Undecided{"it takes more than " + std::to_string(most_programs) +
                     " linear programs"};
  }
}

}  // namespace stickslip
