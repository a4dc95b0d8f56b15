// SPDX-License-Identifier: GPL-3.0-or-later
#include "mode_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/engine/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::degree_detail {
namespace {

/// The mode that is assumed of a contact.
struct Mode {
  enum class Gap : std::int8_t { kUnknown, kClosed, kOpen };
  enum class Slip : std::int8_t { kUnknown, kSticks, kForward, kBackward };
  Gap gap = Gap::kUnknown;
  Slip slip = Slip::kUnknown;
};
using Modes = std::vector<Mode>;

/// A point of a program, with forces along the edges N + mu T and N - mu T of cones.
struct ProgramPoint {
  RationalRow motion;
  std::vector<std::array<Rational, 2>> edges;  ///< forces along the two edges, by contact

  Rational pressing(std::size_t i) const { return edges[i][0] + edges[i][1]; }
};

/// The contacts whose assumed slips, or gaps, contradict each other.
struct Contradiction {
  std::vector<std::size_t> slips;
  std::vector<std::size_t> gaps;
};

class ModeProgram {
 public:
  ModeProgram(const GraspLaw& law, const NearEquilibrium& near) : law_(law), near_(near) {
    for (const LawContact& c : law.contacts) {
      RationalRow slip(law.motions);
      const Row& row = c.corners.front().slip.front();
      slip.assign(row.begin(), row.end());
      slips_.push_back(std::move(slip));
    }
  }

  std::optional<ShareWitness> solve() {
    Modes modes = near_modes();
    // Rounded faces are not quite parallel: what sticks in doubles may slip by that.
    for (auto result = point_in(modes); std::holds_alternative<Contradiction>(result);
         result = point_in(modes)) {
      if (!forget(std::get<Contradiction>(result), modes)) return std::nullopt;
    }
    return solve(modes);
  }

 private:
  /// Returns the modes of the equilibrium in doubles, without those that rounding may decide.
  Modes near_modes() const {
    Modes modes(law_.contacts.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const LawContact& c = law_.contacts[i];
      Mode& mode = modes[i];
      const double normal = near_.normal[i];
      constexpr double kBorder = 1e-7;  // relative to typical forces
      double separation = (c.preloads[0] + c.preloads[1]) / 2;
      separation -= (c.stiffnesses[0] + c.stiffnesses[1]) / 2 *
                    c.corners.front().normal_rounded.dot(near_.motion);
      const bool is_clear = std::fabs(separation) * c.size > kBorder * law_.force;
      if (c.is_spring || law_.law == NormalLaw::kBilateral) {
        mode.gap = Mode::Gap::kClosed;
      } else if (is_clear) {
        mode.gap = separation > 0 ? Mode::Gap::kClosed : Mode::Gap::kOpen;
      }
      if (!rubs(i)) continue;
      const double most = c.slopes[0] * normal;
      const double friction = near_.friction[i][0];
      const bool has_spare = most - std::fabs(friction) > kBorder * most;
      if (near_.sticks[i] == 0) {
        mode.slip = friction < 0 ? Mode::Slip::kForward : Mode::Slip::kBackward;
      } else if (has_spare) {
        mode.slip = Mode::Slip::kSticks;
      }
    }
    return modes;
  }

  bool rubs(std::size_t i) const { return !law_.contacts[i].friction.high.is_zero(); }

  /// Leaves open the slips that contradict each other; if there are none, the gaps. Returns
  /// whether there were any.
  bool forget(const Contradiction& contradiction, Modes& modes) const {
    for (const std::size_t i : contradiction.slips) modes[i].slip = Mode::Slip::kUnknown;
    if (!contradiction.slips.empty()) return true;
    for (const std::size_t i : contradiction.gaps) modes[i].gap = Mode::Gap::kUnknown;
    return !contradiction.gaps.empty();
  }

  std::optional<ShareWitness> solve(Modes modes) {
    constexpr std::size_t kMostPrograms = 64;
    if (programs_ == kMostPrograms) return std::nullopt;
    ++programs_;
    const auto result = point_in(modes);
    const auto* point = std::get_if<ProgramPoint>(&result);
    if (point == nullptr) return std::nullopt;
    const Breach broken = widest_breach(modes, *point);
    if (broken.energy.is_zero()) return witness_of(*point);
    const std::size_t i = broken.contact;
    if (broken.is_gap) {
      const bool presses = separation(i, point->motion).sign() >= 0;
      for (const bool closed : {presses, !presses}) {
        modes[i].gap = closed ? Mode::Gap::kClosed : Mode::Gap::kOpen;
        if (auto found = solve(modes)) return found;
      }
      return std::nullopt;
    }
    const bool forward = dot(slips_[i], point->motion).sign() > 0;
    for (const Mode::Slip slip :
         {forward ? Mode::Slip::kForward : Mode::Slip::kBackward, Mode::Slip::kSticks,
          forward ? Mode::Slip::kBackward : Mode::Slip::kForward}) {
      modes[i].slip = slip;
      if (auto found = solve(modes)) return found;
    }
    return std::nullopt;
  }

  /// A law that is broken, and with what energy.
  struct Breach {
    std::size_t contact = 0;
    bool is_gap = false;  ///< it is the law of the gap, not that of slip
    Rational energy = 0;
  };

  /// Returns the widest breach of unknown modes; of energy 0 if all laws hold.
  Breach widest_breach(const Modes& modes, const ProgramPoint& point) const {
    Breach widest;
    const auto consider = [&](std::size_t i, bool is_gap, Rational energy) {
      if (energy > widest.energy) widest = {i, is_gap, std::move(energy)};
    };
    for (std::size_t i = 0; i < modes.size(); ++i) {
      if (modes[i].gap == Mode::Gap::kUnknown) {
        const Rational a = point.pressing(i);
        const Rational v = std::max<Rational>(0, separation(i, point.motion));
        consider(i, true, (a - v) / law_.contacts[i].stiffness.low * a);
      }
      if (modes[i].slip == Mode::Slip::kUnknown && rubs(i)) {
        const Rational slip = dot(slips_[i], point.motion);
        consider(i, false, abs(slip) * point.edges[i][slip.sign() > 0 ? 0 : 1]);
      }
    }
    return widest;
  }

  Rational separation(std::size_t i, const RationalRow& motion) const {
    const LawContact& c = law_.contacts[i];
    return c.preload.low - c.stiffness.low * dot(c.corners.front().normal, motion);
  }

  /// Returns a motion and forces that these modes allow, or which of them contradict.
  std::variant<ProgramPoint, Contradiction> point_in(const Modes& modes) const {
    LinearProgram program;
    std::vector<std::size_t> gap_rows;   // rows by contact
    std::vector<std::size_t> slip_rows;  // likewise; if there is none, that of the gap
    program.add_variables(law_.motions, VariableKind::kFree);
    std::vector<RationalRow> balance(law_.motions);  // coordinates of motions, then edges
    RationalRow rest;
    for (std::size_t j = 0; j < law_.motions; ++j) rest.push_back(-law_.wrench[j].low);
    std::vector<std::array<std::optional<std::size_t>, 2>> variables(modes.size());
    const auto with_motion = [&](RationalRow row, std::size_t variable, const Rational& value) {
      row.resize(program.variable_count());
      row[variable] = value;
      return row;
    };
    std::vector<std::pair<std::size_t, RationalRow>> wrenches;  // wrenches by variable
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const LawContact& c = law_.contacts[i];
      const CornerRow& corner = c.corners.front();
      const Mode& mode = modes[i];
      RationalRow rise = corner.normal;  // k N, of which v = P - k N z
      for (Rational& entry : rise) entry *= c.stiffness.low;
      gap_rows.push_back(program.row_count());
      slip_rows.push_back(program.row_count());
      if (mode.gap == Mode::Gap::kOpen) {
        program.add_row(rise, Relation::kGreaterEqual, c.preload.low);
        continue;
      }
      if (c.is_spring) {
        const std::size_t force = program.add_variable(VariableKind::kFree);
        variables[i][0] = force;
        wrenches.emplace_back(force, corner.normal);
        program.add_row(with_motion(rise, force, 1), Relation::kEqual, c.preload.low);
        continue;
      }
      RationalRow pressing = rise;
      for (const std::size_t edge : {std::size_t{0}, std::size_t{1}}) {
        const Mode::Slip against = edge == 0 ? Mode::Slip::kForward : Mode::Slip::kBackward;
        const bool is_one = !rubs(i) && edge == 1;
        if (is_one || (rubs(i) && mode.slip == against)) continue;
        const std::size_t force = program.add_variable(VariableKind::kNonNegative);
        variables[i][edge] = force;
        RationalRow wrench = corner.wrench_of({(edge == 0 ? 1 : -1) * c.friction.low});
        add_multiple(wrench, 1, corner.normal);
        wrenches.emplace_back(force, std::move(wrench));
        pressing = with_motion(std::move(pressing), force, 1);
      }
      const bool is_closed = mode.gap == Mode::Gap::kClosed;
      program.add_row(pressing, is_closed ? Relation::kEqual : Relation::kGreaterEqual,
                      c.preload.low);
      if (!rubs(i) || mode.slip == Mode::Slip::kUnknown) continue;
      ++slip_rows.back();
      program.add_row(slips_[i],
                      mode.slip == Mode::Slip::kSticks    ? Relation::kEqual
                      : mode.slip == Mode::Slip::kForward ? Relation::kGreaterEqual
                                                          : Relation::kLessEqual,
                      0);
    }
    for (std::size_t j = 0; j < law_.motions; ++j) {
      RationalRow row(program.variable_count());
      for (const auto& [variable, wrench] : wrenches) row[variable] = wrench[j];
      program.add_row(std::move(row), Relation::kEqual, rest[j]);
    }
    for (std::size_t j = 0; j < law_.max_motion.size(); ++j) {
      RationalRow row(j + 1);
      row[j] = 1;
      program.add_row(row, Relation::kLessEqual, law_.max_motion[j]);
      program.add_row(std::move(row), Relation::kGreaterEqual, -law_.max_motion[j]);
    }
    const LpResult result = stickslip::solve(program);
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      Contradiction contradiction;
      for (std::size_t i = 0; i < modes.size(); ++i) {
        const bool may_open = !law_.contacts[i].is_spring && law_.law != NormalLaw::kBilateral;
        if (slip_rows[i] != gap_rows[i] && !infeasible->farkas[slip_rows[i]].is_zero()) {
          contradiction.slips.push_back(i);
        }
        if (may_open && modes[i].gap != Mode::Gap::kUnknown &&
            !infeasible->farkas[gap_rows[i]].is_zero()) {
          contradiction.gaps.push_back(i);
        }
      }
      return contradiction;
    }
    const std::vector<Rational>& found = std::get<Optimal>(result).point;
    ProgramPoint point{
        RationalRow(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(law_.motions)),
        std::vector<std::array<Rational, 2>>(modes.size())};
    for (std::size_t i = 0; i < modes.size(); ++i) {
      for (const std::size_t edge : {std::size_t{0}, std::size_t{1}}) {
        if (variables[i][edge]) point.edges[i][edge] = found[*variables[i][edge]];
      }
    }
    return point;
  }

  /// Returns the point as a witness. Requires that no law is broken.
  ShareWitness witness_of(const ProgramPoint& point) const {
    ShareWitness witness{point.motion, {}};
    for (std::size_t i = 0; i < point.edges.size(); ++i) {
      if (!rubs(i) || !dot(slips_[i], point.motion).is_zero()) continue;
      const Rational a = point.pressing(i);
      if (a.is_zero() || point.edges[i][0] == point.edges[i][1]) continue;
      witness.shares.emplace_back(ContactId(i),
                                  RationalRow{(point.edges[i][0] - point.edges[i][1]) / a});
    }
    return witness;
  }

  const GraspLaw& law_;
  const NearEquilibrium& near_;
  std::vector<RationalRow> slips_;  ///< multiples of S by contact
  std::size_t programs_ = 0;        ///< how many were solved
};

}  // namespace

std::optional<ShareWitness> equilibrium_in_modes(const GraspLaw& law,
                                                 const NearEquilibrium& near) {
  return ModeProgram(law, near).solve();
}

}  // namespace stickslip::degree_detail
