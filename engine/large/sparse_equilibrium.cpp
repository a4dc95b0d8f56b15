// SPDX-License-Identifier: GPL-3.0-or-later
#include "sparse_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "engine/statics/few_columns.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/sparse_system.hpp"

namespace stickslip::large_detail {
namespace {

using statics_detail::ForceCone;

/// A sum of vectors with few entries.
class SparseSum {
 public:
  void add(const Rational& factor, const SparseRow& row) {
    for (const auto& [j, entry] : row) entries_[j] += factor * entry;
  }
  SparseRow row() const {
    SparseRow result;
    for (const auto& [j, entry] : entries_) {
      if (!entry.is_zero()) result.emplace_back(j, entry);
    }
    return result;
  }

 private:
  std::map<std::size_t, Rational> entries_;
};

class ModeEquations {
 public:
  ModeEquations(const LargeGrasp& grasp, const LargeProposal& near)
      : grasp_(grasp), cones_(grasp.model.cones()), near_(near), modes_(near.modes) {
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      const double first = near.friction[i].empty() ? 0 : near.friction[i].front();
      ways_.push_back(first < 0 ? -1 : 1);
    }
    find_followers();
  }

  std::variant<ShareWitness, NoEquilibrium> solve() {
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t i = 0; i < cones_.size(); ++i) {
        if (modes_[i] == LargeMode::kSlips && cones_[i].slips.size() > 1) {
          return NoEquilibrium::kIrrational;
        }
      }
      if (!solve_modes()) return NoEquilibrium::kModes;
      if (change_modes()) continue;
      if (!grasp_.may_open && opens()) return NoEquilibrium::kOpens;
      return witness();
    }
    return NoEquilibrium::kModes;
  }

 private:
  /// Faces whose numbers are rounded have contacts whose slips differ by that alone: of two of
  /// these one sticks, and the other slips as little, which takes all of its friction. First
  /// those are to stick that may have most friction.
  void find_followers() {
    leaders_.assign(cones_.size(), std::nullopt);
    faces_.resize(cones_.size());
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> faces;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (cones_[i].slips.size() != 1) continue;
      std::vector<std::size_t> bodies;
      for (const auto& [j, entry] : cones_[i].slips.front()) {
        const std::size_t body = grasp_.model.bodies()[j];
        if (bodies.empty() || bodies.back() != body) bodies.push_back(body);
      }
      faces[std::move(bodies)].push_back(i);
    }
    for (auto& [bodies, face] : faces) {
      std::stable_sort(face.begin(), face.end(), [&](std::size_t a, std::size_t b) {
        return near_.most[a] > near_.most[b];
      });
      std::vector<std::size_t> before;
      for (const std::size_t i : face) {
        faces_[i] = face;
        if (modes_[i] != LargeMode::kSticks) continue;
        stick_or_follow(i, before);
        before.push_back(i);
      }
    }
  }

  /// Lets a contact that is closed follow one of these that sticks, if it slips nearly as that
  /// does. Lets it stick if there is none.
  void stick_or_follow(std::size_t i, const std::vector<std::size_t>& others) {
    modes_[i] = LargeMode::kSticks;
    leaders_[i].reset();
    for (const std::size_t other : others) {
      if (other == i || modes_[other] != LargeMode::kSticks || !nearly_slips_as(i, other))
        continue;
      modes_[i] = LargeMode::kFollows;
      leaders_[i] = other;
      return;
    }
  }

  /// Returns whether the slip of a contact is nearly a multiple of another's, but none.
  bool nearly_slips_as(std::size_t i, std::size_t leader) const {
    const SparseRow& row = cones_[i].slips.front();
    const SparseRow& other = cones_[leader].slips.front();
    Rational product = 0;
    Rational square = 0;
    RationalRow full(grasp_.model.size());
    add_multiple(full, 1, row);
    for (const auto& [j, entry] : other) {
      product += entry * full[j];
      square += entry * entry;
    }
    add_multiple(full, -(product / square), other);
    double rest = 0;
    double size = 0;
    for (const auto& [j, entry] : other) rest = std::max(rest, std::fabs(to_double(full[j])));
    for (const auto& [j, entry] : row) {
      rest = std::max(rest, std::fabs(to_double(full[j])));
      size = std::max(size, std::fabs(to_double(entry)));
    }
    constexpr double kNearly = 1e-9;
    return rest > 0 && rest <= kNearly * size;
  }

  /// Returns the wrench of a = 1 of a contact that is closed, without the friction of one that
  /// sticks.
  SparseRow edge_of(std::size_t i) const {
    const ForceCone& cone = cones_[i];
    if (modes_[i] != LargeMode::kSlips) return cone.normal;
    const auto most = exact_sqrt(cone.squared_most);
    require(most.has_value(), "in the plane a cone has rational edges");
    SparseSum sum;
    sum.add(1, cone.normal);
    sum.add(ways_[i] * *most, cone.slips.front());
    return sum.row();
  }

  /// Solves the equations of these modes: balance in the first rows, and then no slip where
  /// contacts stick. Returns whether they have a solution.
  bool solve_modes() {
    const std::size_t size = grasp_.model.size();
    std::vector<SparseSum> motions(size);  // columns
    RationalRow right;
    for (const Rational& load : grasp_.model.load()) right.push_back(-load);
    const auto press = [&](const SparseRow& edge, const SparseRow& normal,
                           const SpringLaw& law) {
      for (const auto& [j, entry] : normal) motions[j].add(-law.stiffness * entry, edge);
      for (const auto& [j, entry] : edge) right[j] -= law.preload * entry;
    };
    for (std::size_t s = 0; s < grasp_.springs.size(); ++s) {
      press(grasp_.springs[s], grasp_.springs[s], grasp_.spring_law[s]);
    }
    struct Rub {
      std::size_t cone;
      std::size_t direction;
    };
    std::vector<Rub> rubs;
    std::vector<std::size_t> followers;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (modes_[i] == LargeMode::kOpen) continue;
      press(edge_of(i), cones_[i].normal, grasp_.cone_law[i]);
      if (modes_[i] == LargeMode::kFollows) followers.push_back(i);
      if (modes_[i] != LargeMode::kSticks) continue;
      for (std::size_t k = 0; k < cones_[i].slips.size(); ++k) {
        for (const auto& [j, entry] : cones_[i].slips[k]) {
          motions[j].add(entry, {{right.size(), 1}});
        }
        right.emplace_back(0);
        rubs.push_back({i, k});
      }
    }
    std::stable_sort(rubs.begin(), rubs.end(), [&](const Rub& a, const Rub& b) {
      return near_.spare[a.cone] > near_.spare[b.cone];
    });
    std::vector<SparseRow> columns;
    for (const SparseSum& column : motions) columns.push_back(column.row());
    for (const Rub& rub : rubs) columns.push_back(cones_[rub.cone].slips[rub.direction]);
    const SparseSystem system(right.size(), columns);
    friction_.assign(cones_.size(), {});
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      friction_[i].resize(cones_[i].slips.size());
    }
    // Friction that the equations leave open is rounded.
    std::vector<char> is_open(columns.size(), 1);
    for (const std::size_t j : system.independent()) is_open[j] = 0;
    double largest = 0;
    for (const auto& friction : near_.friction) {
      for (const double f : friction) largest = std::max(largest, std::fabs(f));
    }
    constexpr int kBits = 24;
    const int grid = kBits - (largest > 0 ? std::ilogb(largest) : 0);
    const auto set_near = [&](std::size_t i, std::size_t k) {
      const Rational friction = statics_detail::on_grid(near_.friction[i][k], grid);
      friction_[i][k] = friction;
      for (const auto& [j, entry] : cones_[i].slips[k]) right[j] -= friction * entry;
    };
    for (std::size_t r = 0; r < rubs.size(); ++r) {
      if (is_open[size + r] != 0) set_near(rubs[r].cone, rubs[r].direction);
    }
    for (const std::size_t i : followers) set_near(i, 0);
    const std::optional<SharedFractions> x = system.solve(right);
    if (!x) return false;
    height_ = x->denominator;
    const Row& found = x->numerators;
    motion_.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(size));
    for (RationalRow& friction : friction_) {
      for (Rational& entry : friction) entry *= height_;
    }
    for (std::size_t r = 0; r < rubs.size(); ++r) {
      if (is_open[size + r] == 0) friction_[rubs[r].cone][rubs[r].direction] = found[size + r];
    }
    return true;
  }

  Rational separation(std::size_t i) const {
    const SpringLaw& law = grasp_.cone_law[i];
    return law.preload * height_ - law.stiffness * dot(cones_[i].normal, motion_);
  }

  /// Changes the modes that break a law; returns whether there were any.
  bool change_modes() {
    bool any = false;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      const ForceCone& cone = cones_[i];
      const Rational v = separation(i);
      LargeMode& mode = modes_[i];
      const LargeMode before = mode;
      if (mode == LargeMode::kOpen) {
        if (v.sign() > 0) stick_or_follow(i, faces_[i]);
      } else if (v.sign() < 0) {
        mode = LargeMode::kOpen;
        if (before == LargeMode::kSticks) lead_instead(i);
        leaders_[i].reset();
      } else if (mode == LargeMode::kSlips) {
        if (slip_sign(i) * ways_[i] <= 0) continue;
        any = true;
        if (leaders_[i]) {
          ways_[i] = -ways_[i];
        } else {
          stick_or_follow(i, faces_[i]);
        }
      } else if (mode == LargeMode::kFollows && slip_sign(i) != 0) {
        mode = LargeMode::kSlips;
        ways_[i] = -slip_sign(i);
      } else if (!cone.slips.empty()) {
        Rational square = 0;
        for (std::size_t k = 0; k < cone.slips.size(); ++k) {
          square += friction_[i][k] * friction_[i][k] * cone.squares[k];
        }
        if (square > cone.squared_most * v * v) {
          mode = LargeMode::kSlips;
          ways_[i] = friction_[i].front().sign() < 0 ? -1 : 1;
          lead_instead(i);
        }
      }
      any = any || mode != before;
    }
    return any;
  }

  int slip_sign(std::size_t i) const { return dot(cones_[i].slips.front(), motion_).sign(); }

  /// Lets the first of those that follow a contact stick in its place.
  void lead_instead(std::size_t leader) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (leaders_[i] != leader) continue;
      if (!next) {
        next = i;
        leaders_[i].reset();
        modes_[i] = LargeMode::kSticks;
      } else {
        leaders_[i] = next;
      }
    }
    if (next) leaders_[leader] = next;
  }

  bool opens() const {
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      if (separation(i).sign() < 0) return true;
    }
    return false;
  }

  ShareWitness witness() const {
    ShareWitness result{grasp_.model.state_of(motion_), {}};
    for (Rational& entry : result.twist) entry /= height_;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      const ForceCone& cone = cones_[i];
      const Rational v = separation(i);
      if (cone.slips.empty() || modes_[i] == LargeMode::kOpen || v.is_zero()) continue;
      const Rational most = grasp_.frictions[i] * v;
      RationalRow share(cone.directions.front().size());
      if (modes_[i] == LargeMode::kSlips) {
        if (slip_sign(i) == 0) share = {ways_[i]};
      } else {
        for (std::size_t k = 0; k < cone.slips.size(); ++k) {
          for (std::size_t c = 0; c < share.size(); ++c) {
            share[c] += friction_[i][k] / most * cone.directions[k][c];
          }
        }
      }
      if (share == RationalRow(share.size())) continue;
      result.shares.emplace_back(ContactId(*cone.element), std::move(share));
    }
    return result;
  }

  const LargeGrasp& grasp_;
  const std::vector<ForceCone>& cones_;
  const LargeProposal& near_;
  std::vector<LargeMode> modes_;
  std::vector<std::vector<std::size_t>> faces_;      ///< the contacts of the same two bodies
  std::vector<std::optional<std::size_t>> leaders_;  ///< what a contact that follows follows
  std::vector<int> ways_;  ///< the sign of friction where a contact slips in the plane
  // Long numbers have one denominator: all is multiplied by it.
  Rational height_;
  RationalRow motion_;                 ///< in the model's coordinates
  std::vector<RationalRow> friction_;  ///< of contacts that stick, by direction
};

}  // namespace

std::variant<ShareWitness, NoEquilibrium> equilibrium_near(const LargeGrasp& grasp,
                                                           const LargeProposal& proposal) {
  return ModeEquations(grasp, proposal).solve();
}

}  // namespace stickslip::large_detail
