// SPDX-License-Identifier: GPL-3.0-or-later
#include "mode_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/lp/exact_system.hpp"
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

/// A point of a program, with forces along the edges of cones.
struct ProgramPoint {
  RationalRow motion;
  std::vector<RationalRow> edges;  ///< the force along each edge, by contact

  Rational pressing(std::size_t i) const {
    Rational sum = 0;
    for (const Rational& force : edges[i]) sum += force;
    return sum;
  }
};

/// The contacts whose assumed slips, or gaps, contradict each other.
struct Contradiction {
  std::vector<std::size_t> slips;
  std::vector<std::size_t> gaps;
};

class ModeProgram {
 public:
  ModeProgram(const GraspLaw& law, const NearEquilibrium& near) : law_(law), near_(near) {
    for (std::size_t i = 0; i < law.contacts.size(); ++i) {
      auto& slips = slips_.emplace_back();
      for (const Row& row : law.contacts[i].corners.front().slip) {
        slips.emplace_back(row.begin(), row.end());
      }
      frictions_.push_back(frictions_of(i));
    }
  }

  std::optional<ShareWitness> solve() {
    for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
      if (slips_in_space(i) && !is_slight(i)) return std::nullopt;
    }
    Modes modes = near_modes();
    auto result = point_in(modes);
    // Rounded faces are not quite parallel: what sticks in doubles may slip by that.
    while (const auto* contradiction = std::get_if<Contradiction>(&result)) {
      if (!forget(*contradiction, modes)) return std::nullopt;
      result = point_in(modes);
    }
    return settle(std::move(modes), std::get<ProgramPoint>(result));
  }

 private:
  /// Returns the modes of the equilibrium in doubles, without those that rounding may decide.
  Modes near_modes() const {
    Modes modes(law_.contacts.size());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const LawContact& c = law_.contacts[i];
      Mode& mode = modes[i];
      const double normal = near_.normal[i];
      double separation = (c.preloads[0] + c.preloads[1]) / 2;
      separation -= (c.stiffnesses[0] + c.stiffnesses[1]) / 2 *
                    c.corners.front().normal_rounded.dot(near_.motion);
      const bool is_clear = std::fabs(separation) * c.size > kBorder * law_.force;
      if (c.is_spring || law_.normal_law == NormalLaw::kBilateral) {
        mode.gap = Mode::Gap::kClosed;
      } else if (is_clear) {
        mode.gap = separation > 0 ? Mode::Gap::kClosed : Mode::Gap::kOpen;
      }
      if (!rubs(i)) continue;
      if (!slips_along_a_line(i)) {
        mode.slip = Mode::Slip::kSticks;
        if (mode.gap == Mode::Gap::kUnknown || slips_in_space(i)) mode.gap = Mode::Gap::kOpen;
        continue;
      }
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

  static constexpr double kBorder = 1e-7;  ///< relative to typical forces

  bool rubs(std::size_t i) const { return !law_.contacts[i].friction.high.is_zero(); }
  bool slips_along_a_line(std::size_t i) const {
    return law_.contacts[i].slip_dimension() == 1;
  }
  /// Returns whether it slips so that friction has irrational numbers.
  bool slips_in_space(std::size_t i) const {
    return rubs(i) && !slips_along_a_line(i) && near_.normal[i] > 0 && near_.sticks[i] == 0;
  }
  /// Returns whether its force is as good as none.
  bool is_slight(std::size_t i) const {
    return !(near_.normal[i] * law_.contacts[i].size > kBorder * law_.force);
  }

  /// Returns friction forces for a = 1 that are corners of a part of the cone: all of it in the
  /// plane; in space forces along the axes, and one near that of the equilibrium.
  std::vector<RationalRow> frictions_of(std::size_t i) const {
    const LawContact& c = law_.contacts[i];
    if (!rubs(i)) return {RationalRow(c.slip_numbers())};
    if (slips_along_a_line(i)) return {{c.friction.low}, {-c.friction.low}};
    constexpr unsigned kBits = 20;
    std::vector<RationalRow> frictions;
    const auto add = [&](const RationalRow& direction) {
      const Rational square = c.squared_force(direction);
      if (square.is_zero()) return;
      const Rational most = c.friction.low * short_sqrt(c.squared_length / square, kBits).lower;
      RationalRow friction(direction.size());
      add_multiple(friction, most, direction);
      frictions.push_back(std::move(friction));
    };
    for (const RationalRow& direction : c.directions) {
      for (const int sign : {1, -1}) {
        RationalRow along(direction.size());
        add_multiple(along, sign, direction);
        add(along);
      }
    }
    if (near_.normal[i] > 0) add(c.force_near(near_.friction[i], kBits));
    return frictions;
  }

  /// Leaves open the slips that contradict each other; if there are none, the gaps. Returns
  /// whether there were any.
  bool forget(const Contradiction& contradiction, Modes& modes) const {
    for (const std::size_t i : contradiction.slips) modes[i].slip = Mode::Slip::kUnknown;
    if (!contradiction.slips.empty()) return true;
    for (const std::size_t i : contradiction.gaps) modes[i].gap = Mode::Gap::kUnknown;
    return !contradiction.gaps.empty();
  }

  /// Returns this point of the program of these modes as an equilibrium, if it breaks no law;
  /// else one with the mode that it breaks the most chosen.
  std::optional<ShareWitness> settle(Modes modes, const ProgramPoint& point) {
    const Breach broken = widest_breach(modes, point);
    if (broken.energy.is_zero()) return witness_of(point);
    Mode& mode = modes[broken.contact];
    if (broken.is_gap) {
      const bool presses = separation(broken.contact, point.motion).sign() >= 0;
      for (const bool closed : {presses, !presses}) {
        mode.gap = closed ? Mode::Gap::kClosed : Mode::Gap::kOpen;
        if (!slips_along_a_line(broken.contact)) mode.slip = Mode::Slip::kSticks;
        if (auto found = solve_with(modes)) return found;
      }
      return std::nullopt;
    }
    if (!slips_along_a_line(broken.contact)) {
      mode.slip = Mode::Slip::kSticks;
      return solve_with(modes);
    }
    const bool forward = dot(slips_[broken.contact].front(), point.motion).sign() > 0;
    for (const Mode::Slip slip :
         {forward ? Mode::Slip::kForward : Mode::Slip::kBackward, Mode::Slip::kSticks,
          forward ? Mode::Slip::kBackward : Mode::Slip::kForward}) {
      mode.slip = slip;
      if (auto found = solve_with(modes)) return found;
    }
    return std::nullopt;
  }

  /// Solves the program of these modes and settles its point, unless enough were solved.
  std::optional<ShareWitness> solve_with(const Modes& modes) {
    constexpr std::size_t kMostChoices = 63;
    if (choices_ == kMostChoices) return std::nullopt;
    ++choices_;
    const auto result = point_in(modes);
    const auto* point = std::get_if<ProgramPoint>(&result);
    return point == nullptr ? std::nullopt : settle(modes, *point);
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
      if (modes[i].slip != Mode::Slip::kUnknown || !rubs(i)) continue;
      for (const RationalRow& row : slips_[i]) {
        const Rational slip = dot(row, point.motion);
        consider(i, false,
                 abs(slip) * (slips_along_a_line(i) ? point.edges[i][slip.sign() > 0 ? 0 : 1]
                                                    : point.pressing(i)));
      }
    }
    return widest;
  }

  Rational separation(std::size_t i, const RationalRow& motion) const {
    const LawContact& c = law_.contacts[i];
    return c.preload.low - c.stiffness.low * dot(c.corners.front().normal, motion);
  }

  /// The linear program of some modes, over the motion and then the forces along edges.
  struct Assembled {
    LinearProgram program;
    std::vector<std::size_t> gap_rows;  ///< rows by contact
    std::vector<std::size_t>
        slip_rows;  ///< the first by contact; that of the gap if there is none
    std::vector<std::vector<std::optional<std::size_t>>> forces;  ///< variables by contact
    std::vector<std::pair<std::size_t, RationalRow>> wrenches;    ///< per unit of a variable
  };

  /// Returns the edges of its cone along which a contact may push; a spring has one.
  std::vector<std::size_t> edges_of(std::size_t i, const Mode& mode) const {
    if (mode.slip == Mode::Slip::kForward && rubs(i)) return {1};
    if (mode.slip == Mode::Slip::kBackward) return {0};
    std::vector<std::size_t> all(frictions_[i].size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }

  void add_contact(std::size_t i, const Mode& mode, Assembled& to) const {
    const LawContact& c = law_.contacts[i];
    const CornerRow& corner = c.corners.front();
    LinearProgram& program = to.program;
    to.gap_rows.push_back(program.row_count());
    to.slip_rows.push_back(program.row_count());
    to.forces.emplace_back(frictions_[i].size());
    RationalRow row = corner.normal;  // k N z, which is P - v
    for (Rational& entry : row) entry *= c.stiffness.low;
    if (mode.gap == Mode::Gap::kOpen) {
      program.add_row(std::move(row), Relation::kGreaterEqual, c.preload.low);
      return;
    }
    for (const std::size_t edge : edges_of(i, mode)) {
      const std::size_t force =
          program.add_variable(c.is_spring ? VariableKind::kFree : VariableKind::kNonNegative);
      to.forces.back()[edge] = force;
      to.wrenches.emplace_back(force, corner.push_with(frictions_[i][edge]));
      row.resize(program.variable_count());
      row[force] = 1;
    }
    const bool is_closed = mode.gap == Mode::Gap::kClosed;
    program.add_row(std::move(row), is_closed ? Relation::kEqual : Relation::kGreaterEqual,
                    c.preload.low);
    if (!rubs(i) || mode.slip == Mode::Slip::kUnknown) return;
    to.slip_rows.back() = program.row_count();
    for (const RationalRow& slip : slips_[i]) {
      program.add_row(slip,
                      mode.slip == Mode::Slip::kSticks    ? Relation::kEqual
                      : mode.slip == Mode::Slip::kForward ? Relation::kGreaterEqual
                                                          : Relation::kLessEqual,
                      0);
    }
  }

  Assembled assembled(const Modes& modes) const {
    Assembled result;
    LinearProgram& program = result.program;
    program.add_variables(law_.motions, VariableKind::kFree);
    for (std::size_t i = 0; i < modes.size(); ++i) add_contact(i, modes[i], result);
    for (std::size_t j = 0; j < law_.motions; ++j) {
      RationalRow row(program.variable_count());
      for (const auto& [variable, wrench] : result.wrenches) row[variable] = wrench[j];
      program.add_row(std::move(row), Relation::kEqual, -law_.wrench[j].low);
    }
    for (std::size_t j = 0; j < law_.max_motion.size(); ++j) {
      RationalRow row(j + 1);
      row[j] = 1;
      program.add_row(row, Relation::kLessEqual, law_.max_motion[j]);
      program.add_row(std::move(row), Relation::kGreaterEqual, -law_.max_motion[j]);
    }
    return result;
  }

  /// Returns a motion and forces that these modes allow, or which of them contradict.
  std::variant<ProgramPoint, Contradiction> point_in(const Modes& modes) const {
    const Assembled built = assembled(modes);
    const LpResult result = stickslip::solve(built.program);
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      return contradiction_in(modes, built, infeasible->farkas);
    }
    const std::vector<Rational>& found = std::get<Optimal>(result).point;
    ProgramPoint point{
        RationalRow(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(law_.motions)),
        {}};
    for (std::size_t i = 0; i < modes.size(); ++i) {
      RationalRow& edges = point.edges.emplace_back();
      for (const auto& force : built.forces[i]) {
        edges.push_back(force ? found[*force] : Rational(0));
      }
    }
    return point;
  }

  Contradiction contradiction_in(const Modes& modes, const Assembled& built,
                                 const std::vector<Rational>& farkas) const {
    Contradiction result;
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const std::size_t gap = built.gap_rows[i];
      const std::size_t slip = built.slip_rows[i];
      for (std::size_t k = 0; slip != gap && k < slips_[i].size(); ++k) {
        if (farkas[slip + k].is_zero()) continue;
        result.slips.push_back(i);
        break;
      }
      const bool may_open =
          !law_.contacts[i].is_spring && law_.normal_law != NormalLaw::kBilateral;
      const bool is_known = modes[i].gap != Mode::Gap::kUnknown;
      if (may_open && is_known && !farkas[gap].is_zero()) result.gaps.push_back(i);
    }
    return result;
  }

  bool slips(std::size_t i, const RationalRow& motion) const {
    return std::any_of(slips_[i].begin(), slips_[i].end(),
                       [&](const RationalRow& row) { return !dot(row, motion).is_zero(); });
  }

  /// Returns the point as a witness. Requires that no law is broken.
  ShareWitness witness_of(const ProgramPoint& point) const {
    ShareWitness witness{point.motion, {}};
    for (std::size_t i = 0; i < point.edges.size(); ++i) {
      if (!rubs(i) || slips(i, point.motion)) continue;
      const Rational a = point.pressing(i);
      if (a.is_zero()) continue;
      RationalRow share(frictions_[i].front().size());
      for (std::size_t edge = 0; edge < point.edges[i].size(); ++edge) {
        const Rational part = point.edges[i][edge] / (law_.contacts[i].friction.low * a);
        add_multiple(share, part, frictions_[i][edge]);
      }
      if (share != RationalRow(share.size())) witness.shares.emplace_back(ContactId(i), share);
    }
    return witness;
  }

  const GraspLaw& law_;
  const NearEquilibrium& near_;
  std::vector<std::vector<RationalRow>> slips_;  ///< multiples of the rows of S by contact
  std::vector<std::vector<RationalRow>>
      frictions_;            ///< that of each edge for a = 1, by contact
  std::size_t choices_ = 0;  ///< programs that were solved with a mode chosen
};

}  // namespace

std::optional<ShareWitness> equilibrium_in_modes(const GraspLaw& law,
                                                 const NearEquilibrium& near) {
  return ModeProgram(law, near).solve();
}

}  // namespace stickslip::degree_detail
