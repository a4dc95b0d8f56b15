// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "answering_forces.hpp"
#include "engine/motion/dense.hpp"
#include "prove_stable.hpp"

namespace stickslip {

using namespace degree_detail;

namespace {

/// The numbers of one element that the rules compare, over the box at one multiple.
struct PressedContact {
  Interval separation;  ///< v at d0
  Interval normal;      ///< a0
  Rational slip;        ///< sigma
  Rational spare{};     ///< s, once it is known
};

class StickingSearch : AnswerSearch {
 public:
  /// Proposes a motion in so many bits; 0: rest.
  StickingSearch(const GraspLaw& box, const NearEquilibrium& middle, int bits)
      : AnswerSearch(box, middle) {
    proof_.motion.resize(box.motions);
    for (std::size_t j = 0; bits > 0 && j < box.motions; ++j) {
      const double d = middle.motion[static_cast<Eigen::Index>(j)] / box.unit(j);
      proof_.motion[j] = rational_in_bits(d, bits);
    }
  }

  std::optional<StickingProof> find() {
    if (!may_move() || !choose_contacts()) return std::nullopt;
    for (const Rational& multiple : multiples_) measure_contacts(multiple);
    if (!choose_answers()) return std::nullopt;
    measure([&](std::size_t at, std::size_t i) { return contacts_[at][i].normal; });
    if (!choose_reach()) return std::nullopt;
    sum_up();
    if (!choose_energy() || !holds() || !is_within_bound()) return std::nullopt;
    proof_.friction = std::move(friction_);
    proof_.presses = std::move(presses_);
    proof_.answers = std::move(answers_);
    return std::move(proof_);
  }

 private:
  bool moves() const {
    return std::any_of(proof_.motion.begin(), proof_.motion.end(),
                       [](const Rational& d) { return !d.is_zero(); });
  }

  /// Returns whether rule `sticking-motion` holds, but for the bilateral law.
  bool may_move() const {
    if (!moves()) return true;
    return multiples_.size() == 1 &&
           std::all_of(box_.contacts.begin(), box_.contacts.end(),
                       [](const LawContact& c) { return c.tilt.is_zero(); });
  }

  /// Lists what presses. Returns false if nothing does, if a contact that presses slips or has
  /// no friction to spare, or if one opens under the bilateral law. Of many contacts all that
  /// carry friction are listed, and few answer.
  bool choose_contacts() {
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      const LawContact& c = box_.contacts[i];
      const double a = middle_.normal[i];
      const bool rubs = c.slopes[1] > 0;
      if (c.is_spring) {
        if (c.stiffnesses[0] > 0) pressing_.push_back({i, std::fabs(a)});
        continue;
      }
      if (!(a > 0)) {
        if (box_.normal_law == NormalLaw::kBilateral) return false;
        continue;
      }
      const double spare = c.slopes[0] * a - norm_of(middle_.friction[i]);
      if (rubs && middle_.sticks[i] == 0) return false;
      if (rubs && !(spare > 0)) return false;
      pressing_.push_back({i, a});
      if (rubs) rubbing_.push_back({i, spare});
      if (rubs) state_friction(i);
    }
    if (pressing_.empty()) return false;
    if (box_.normal_law == NormalLaw::kUnilateral) {
      constexpr std::size_t kMost = 32;
      keep_best(rubbing_, kMost, [&](std::size_t i) { return slip_of(i); });
      keep_best(pressing_, kMost, [&](std::size_t i) { return normal_of(i); });
    }
    return true;
  }

  /// Chooses H and G: a right inverse, in which contacts with more to spare answer more. A
  /// stiff contact presses more for the same energy.
  bool choose_answers() {
    double stiffest = 0;
    for (const Bearing& b : pressing_) {
      stiffest =
          std::max(stiffest, box_.contacts[b.contact].stiffnesses[0] *
                                 box_.contacts[b.contact].size * box_.contacts[b.contact].size);
    }
    Eigen::Index columns = static_cast<Eigen::Index>(pressing_.size());
    std::vector<Eigen::Index> first;  // column of each that rubs
    for (const Bearing& b : rubbing_) {
      first.push_back(columns);
      columns += static_cast<Eigen::Index>(box_.contacts[b.contact].slip_dimension());
    }
    Eigen::MatrixXd wrenches(motions_, columns);
    Eigen::VectorXd weights(columns);
    double most = 0;  // the most that friction has to spare
    for (const Bearing& b : rubbing_) most = std::max(most, b.spare);
    for (std::size_t k = 0; k < pressing_.size(); ++k) {
      const LawContact& c = box_.contacts[pressing_[k].contact];
      const auto column = static_cast<Eigen::Index>(k);
      wrenches.col(column) = normal_of(pressing_[k].contact).transpose();
      const double part = c.stiffnesses[0] * c.size * c.size / stiffest;
      const double size =
          c.is_spring ? most
                      : std::min(most > 0 ? most : pressing_[k].spare, pressing_[k].spare);
      weights[column] = part * size * size;
    }
    for (std::size_t k = 0; k < rubbing_.size(); ++k) {
      const Eigen::MatrixXd slip = slip_of(rubbing_[k].contact);
      wrenches.middleCols(first[k], slip.rows()) = slip.transpose();
      weights.segment(first[k], slip.rows()).setConstant(rubbing_[k].spare * rubbing_[k].spare);
    }
    if (!(weights.maxCoeff() > 0)) return false;
    weights /= weights.maxCoeff();
    const Eigen::MatrixXd answers = right_inverse(wrenches, weights);
    if (!answers.allFinite()) return false;
    for (std::size_t k = 0; k < pressing_.size(); ++k) {
      StickingProof::Press press{ContactId(pressing_[k].contact), {}};
      bool is_any = box_.normal_law == NormalLaw::kBilateral;
      for (std::size_t l = 0; l < box_.motions; ++l) {
        const double a = answers(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l));
        press.forces.push_back(rational_in_bits(a / box_.unit(l), kForceBits));
        is_any = is_any || a != 0;
      }
      if (is_any) presses_.push_back(std::move(press));
    }
    for (std::size_t k = 0; k < rubbing_.size(); ++k) {
      state_answer(rubbing_[k].contact, answers, first[k]);
    }
    return true;
  }

  /// Measures v, a0 and sigma of all contacts, at a multiple.
  void measure_contacts(const Rational& multiple) {
    std::vector<PressedContact>& all = contacts_.emplace_back();
    RationalRow x = proof_.motion;
    x.emplace_back(1);
    x.push_back(multiple);
    const bool moves = this->moves();
    for (const LawContact& c : box_.contacts) {
      PressedContact pressed{};
      if (moves) {
        bool is_first = true;
        for (std::size_t k = 0; k < c.separations.size(); ++k) {
          const Rational v = c.separation_factors[k] * dot(c.separations[k], x);
          if (is_first || v < pressed.separation.low) pressed.separation.low = v;
          if (is_first || v > pressed.separation.high) pressed.separation.high = v;
          is_first = false;
        }
        Rational square = 0;
        for (const CornerRow& corner : c.corners) {
          RationalRow s;
          for (const Row& row : corner.slip) s.push_back(dot(row, x) / corner.slip_factor);
          Rational here = 0;
          for (std::size_t k = 0; k < s.size(); ++k) {
            here += k == 3 ? Rational(c.spin_weight * s[k] * s[k]) : Rational(s[k] * s[k]);
          }
          square = std::max(square, here);
        }
        pressed.slip = short_sqrt(square, kRootBits).upper;
      } else {
        pressed.separation = preload_at(c, multiple);
      }
      pressed.normal = pressed.separation;
      if (!c.is_spring) {
        pressed.normal.low = std::max<Rational>(pressed.normal.low, 0);
        pressed.normal.high = std::max<Rational>(pressed.normal.high, 0);
      }
      all.push_back(std::move(pressed));
    }
  }

  /// Chooses Z, a little above the solution of Z = |W| + |M - 1| Z. Returns whether rule
  /// `sticking-reach` holds.
  bool choose_reach() {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(motions_, motions_);
    Reals right(motions_);
    constexpr double kLeast = 1e-14;  // relative to a typical force: all are to be above 0
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      right[row] = to_double(rest_[k]) / box_.unit(k) + kLeast * box_.force;
      for (std::size_t l = 0; l < rest_.size(); ++l) {
        system(row, static_cast<Eigen::Index>(l)) -=
            to_double(off_[k][l]) * box_.unit(l) / box_.unit(k);
      }
    }
    const Reals reach = solution(system, right);
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const double z = reach[static_cast<Eigen::Index>(k)];
      if (!std::isfinite(z) || !(z > 0)) return false;
      proof_.reach.push_back(rational_in_bits(z * box_.unit(k) * 1.0002, kForceBits));
    }
    return is_reached(proof_.reach, true);
  }

  /// Sums up delta and phi.
  void sum_up() {
    press_.assign(box_.contacts.size(), 0);
    needed_ = friction_needed(proof_.reach);
    is_listed_.assign(box_.contacts.size(), 0);
    rubs_.assign(box_.contacts.size(), 0);
    for (const StickingProof::Press& press : presses_) {
      const std::size_t i = press.contact.index();
      is_listed_[i] = 1;
      for (std::size_t l = 0; l < box_.motions; ++l) {
        press_[i] += abs(press.forces[l]) * proof_.reach[l];
      }
    }
    const auto rubs = [&](ContactId id) { is_listed_[id.index()] = rubs_[id.index()] = 1; };
    for (const auto& [id, f] : friction_) rubs(id);
    for (const RestProof::Answer& answer : answers_) rubs(answer.contact);
  }

  Rational energy_of(std::size_t i, const PressedContact& at) const {
    const LawContact& c = box_.contacts[i];
    if (press_[i].is_zero() && at.slip.is_zero()) return 0;
    const Rational slope = c.friction.high * short_sqrt(c.squared_length, kRootBits).upper;
    Rational most = 0;
    for (const Rational& k : ends_of(c.stiffness)) {
      if (k.is_zero()) continue;
      const Rational sum = press_[i] + slope * k * at.slip;
      const Rational energy = sum * sum / (2 * k);
      most = std::max(most, energy);
    }
    return most + (slope * at.normal.high + needed_[i]) * at.slip;
  }

  /// Chooses c, a little above what `sticking-energy` asks; returns false if it cannot.
  bool choose_energy() {
    Rational most = 0;
    double floor = HUGE_VAL;  // so little energy that no contact feels it, if nothing is off
    for (const std::vector<PressedContact>& all : contacts_) {
      Rational sum = 0;
      for (std::size_t i = 0; i < all.size(); ++i) {
        sum += energy_of(i, all[i]);
        const LawContact& c = box_.contacts[i];
        if (is_listed_[i] == 0 || c.is_spring) continue;
        const double v = to_double(all[i].separation.low);
        if (!(v > 0)) return false;
        constexpr double kUnfelt = 1e-12;
        floor = std::min(floor, kUnfelt * v * (v / c.stiffnesses[1]));
      }
      most = std::max(most, sum);
    }
    if (!(floor > 0)) return false;
    const double least = std::isfinite(floor) ? floor * 1e-6 : 1;
    proof_.energy = rational_in_bits(to_double(most) * 1.0001 + least, kForceBits);
    return proof_.energy > most;
  }

  /// Finds s of each contact; returns whether rule `sticking-press` holds.
  bool holds() {
    for (std::vector<PressedContact>& all : contacts_) {
      for (std::size_t i = 0; i < all.size(); ++i) {
        const LawContact& c = box_.contacts[i];
        if (is_listed_[i] == 0 || c.is_spring) continue;
        const Rational loss = short_sqrt(2 * proof_.energy * c.stiffness.high, kRootBits).upper;
        const Rational pressed = all[i].separation.low - loss;
        if (pressed < 0) return false;
        if (rubs_[i] == 0) continue;
        all[i].spare = least_slope(c) * pressed - needed_[i];
        if (!(all[i].spare > 0)) return false;
      }
    }
    return true;
  }

  /// Returns whether rule `sticking-bound` holds.
  bool is_within_bound() const {
    if (box_.max_motion.empty()) return true;
    RationalRow room;  // E
    for (std::size_t l = 0; l < box_.motions; ++l) {
      room.push_back(box_.max_motion[l] - abs(proof_.motion[l]));
      if (!(room[l] > 0)) return false;
    }
    for (const std::vector<PressedContact>& all : contacts_) {
      RationalRow moved(box_.motions);
      for (const StickingProof::Press& press : presses_) {
        const LawContact& c = box_.contacts[press.contact.index()];
        const Rational depth = short_sqrt(2 * proof_.energy / c.stiffness.low, kRootBits).upper;
        for (std::size_t l = 0; l < moved.size(); ++l) moved[l] += abs(press.forces[l]) * depth;
      }
      for (const RestProof::Answer& answer : answers_) {
        const std::size_t i = answer.contact.index();
        const Rational slip = proof_.energy / all[i].spare + all[i].slip;
        for (std::size_t l = 0; l < moved.size(); ++l) {
          moved[l] += length_above(box_.contacts[i], answer.forces[l]) * slip;
        }
      }
      for (std::size_t l = 0; l < moved.size(); ++l) {
        for (std::size_t k = 0; k < moved.size(); ++k) moved[l] += off_[k][l] * room[k];
        if (moved[l] > room[l]) return false;
      }
    }
    return true;
  }

  std::vector<std::vector<PressedContact>> contacts_;  ///< contacts by multiple
  std::vector<Bearing> pressing_;                      ///< contacts whose normal forces answer
  std::vector<Bearing> rubbing_;                       ///< contacts whose friction answers
  std::vector<Rational> press_;                        ///< delta, by contact
  std::vector<Rational> needed_;                       ///< phi, by contact
  std::vector<char> is_listed_;                        ///< whether it is listed, by contact
  std::vector<char> rubs_;                             ///< whether it rubs, by contact
  StickingProof proof_;
};

}  // namespace

std::optional<StickingProof> prove_sticking(const GraspLaw& box,
                                            const NearEquilibrium& middle) {
  // A motion that is rounding alone counts as none. Several multiples are proved only around no
  // motion.
  constexpr double kStill = 1e-9;
  const bool is_range = box.is_family && box.multiples.high != box.multiples.low;
  if (is_range || middle.motion.norm() <= kStill * box.reach) {
    if (auto proof = StickingSearch(box, middle, 0).find()) return proof;
  }
  constexpr int kDoubleBits = 53;
  return StickingSearch(box, middle, kDoubleBits).find();
}

}  // namespace stickslip
