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

class RestSearch : AnswerSearch {
 public:
  using AnswerSearch::AnswerSearch;

  std::optional<RestProof> find() {
    if (!(middle_.motion.norm() <= kStill * box_.reach)) return std::nullopt;
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      if (middle_.sticks[i] == 0) continue;
      const double spare =
          box_.contacts[i].slopes[0] * middle_.normal[i] - norm_of(middle_.friction[i]);
      if (spare > 0) bearing_.push_back({i, spare});
    }
    keep_best(bearing_, bearing_.size(), [&](std::size_t i) { return slip_of(i); });
    if (!choose_answers()) return std::nullopt;
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      if (middle_.sticks[i] != 0) state_friction(i);
    }
    measure([&](std::size_t at, std::size_t i) {
      return preload_at(box_.contacts[i], multiples_[at]);
    });
    if (!choose_reach() || !is_reached(reach_, false) || !is_in_cones()) return std::nullopt;
    return RestProof{std::move(friction_), std::move(answers_), std::move(reach_)};
  }

 private:
  static constexpr double kStill = 1e-9;

  /// Chooses G: a right inverse, in which contacts with more to spare answer more.
  bool choose_answers() {
    if (bearing_.empty()) return false;
    std::vector<Eigen::Index> first{0};  // column of each
    for (const Bearing& b : bearing_) {
      first.push_back(first.back() +
                      static_cast<Eigen::Index>(box_.contacts[b.contact].slip_dimension()));
    }
    Eigen::MatrixXd wrenches(motions_, first.back());
    Eigen::VectorXd weights(first.back());
    for (std::size_t k = 0; k < bearing_.size(); ++k) {
      const auto& [contact, spare] = bearing_[k];
      const Eigen::Index size = first[k + 1] - first[k];
      wrenches.middleCols(first[k], size) = slip_of(contact).transpose();
      weights.segment(first[k], size).setConstant(spare * spare);
    }
    Eigen::MatrixXd answers = right_inverse(wrenches, weights);
    if (!answers.allFinite()) return false;
    // A load that friction does not answer, as along the normal of all contacts, has to balance
    // by itself.
    const Eigen::MatrixXd off =
        wrenches * answers - Eigen::MatrixXd::Identity(motions_, motions_);
    for (Eigen::Index l = 0; l < motions_; ++l) {
      if (off.col(l).norm() > kFlat) answers.col(l).setZero();
    }
    for (std::size_t k = 0; k < bearing_.size(); ++k) {
      state_answer(bearing_[k].contact, answers, first[k]);
    }
    return true;
  }

  /// Chooses Z, a little above the solution of Z = |W| + |M - 1| Z, in few bits.
  bool choose_reach() {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(motions_, motions_);
    Reals right(motions_);
    for (std::size_t k = 0; k < rest_.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      right[row] = to_double(rest_[k]);
      for (std::size_t l = 0; l < rest_.size(); ++l) {
        system(row, static_cast<Eigen::Index>(l)) -= to_double(off_[k][l]);
      }
    }
    // A component that is 0 must stay above what the others bring, if anything answers it.
    constexpr double kLeast = 1e-12;
    const double least = kLeast * right.maxCoeff();
    for (Eigen::Index k = 0; k < motions_; ++k) {
      if (system.row(k).isZero(0))
        system(k, k) = 1;
      else
        right[k] += least;
    }
    const Reals reach = solution(system, right) * 1.0001;
    for (const double z : reach) {
      if (!std::isfinite(z) || z < 0) return false;
      reach_.push_back(rational_in_bits(z * 1.0001, kForceBits));
    }
    return true;
  }

  /// Returns whether the rule `rest-cone` holds.
  bool is_in_cones() const {
    const std::vector<Rational> needed = friction_needed(reach_);
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (needed[i].is_zero()) continue;
      const LawContact& c = box_.contacts[i];
      const Rational slope = least_slope(c);
      for (const Rational& multiple : multiples_) {
        if (needed[i] > slope * preload_at(c, multiple).low) return false;
      }
    }
    return true;
  }

  std::vector<Bearing> bearing_;  ///< contacts whose friction answers
  RationalRow reach_;             ///< Z
};

}  // namespace

std::optional<RestProof> prove_at_rest(const GraspLaw& box, const NearEquilibrium& middle) {
  return RestSearch(box, middle).find();
}

}  // namespace stickslip
