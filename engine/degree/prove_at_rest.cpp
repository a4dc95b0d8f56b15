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

class RestSearch {
 public:
  RestSearch(const GraspLaw& box, const NearEquilibrium& middle)
      : box_(box), middle_(middle), motions_(static_cast<Eigen::Index>(box.motions)) {
    multiples_ = {0};
    if (box.is_family) {
      multiples_ = {box.multiples.low};
      if (box.multiples.high && *box.multiples.high != box.multiples.low) {
        multiples_.push_back(*box.multiples.high);
      }
    }
  }

  std::optional<RestProof> find() {
    if (!(middle_.motion.norm() <= kStill * box_.reach)) return std::nullopt;
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      const LawContact& c = box_.contacts[i];
      if (middle_.sticks[i] == 0) continue;
      const double spare = c.slopes[0] * middle_.normal[i] - norm_of(middle_.friction[i]);
      if (spare > 0) bearing_.push_back({i, spare});
    }
    take_those_with_most_to_spare();
    if (!choose_answers()) return std::nullopt;
    state_friction();
    Rows off(box_.motions, RationalRow(box_.motions));
    RationalRow rest(box_.motions);
    measure(off, rest);
    if (!choose_reach(off, rest) || !holds(off, rest)) return std::nullopt;
    return std::move(proof_);
  }

 private:
  struct Bearing {
    std::size_t contact;
    double spare;
  };

  static constexpr double kStill = 1e-9;
  static constexpr double kFlat = 1e-9;  ///< the part below which nothing is independent
  static constexpr int kBits = 24;

  /// Keeps the contacts with most to spare: of many, a few answer as well, and with less to be
  /// written.
  void take_those_with_most_to_spare() {
    constexpr std::size_t kMany = 8;
    std::stable_sort(bearing_.begin(), bearing_.end(),
                     [](const Bearing& a, const Bearing& b) { return a.spare > b.spare; });
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(motions_, motions_);
    const auto rank = [&] { return stickslip::rank(sum, kFlat); };
    std::size_t taken = 0;
    while (taken < bearing_.size() && (taken < kMany || rank() < motions_)) {
      const Eigen::MatrixXd slip = slip_of(bearing_[taken++].contact);
      sum += slip.transpose() * slip;
    }
    bearing_.resize(taken);
    std::sort(bearing_.begin(), bearing_.end(),
              [](const Bearing& a, const Bearing& b) { return a.contact < b.contact; });
  }

  /// Returns S in the middle of the box, in doubles.
  Eigen::MatrixXd slip_of(std::size_t contact) const {
    const std::vector<Reals>& rows = box_.contacts[contact].corners.front().slip_rounded;
    Eigen::MatrixXd slip(static_cast<Eigen::Index>(rows.size()), motions_);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      slip.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
    }
    return slip;
  }

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
    const Eigen::MatrixXd gram = wrenches * weights.asDiagonal() * wrenches.transpose();
    Eigen::MatrixXd answers =
        weights.asDiagonal() * wrenches.transpose() * pseudo_inverse(gram, kFlat);
    if (!answers.allFinite()) return false;
    // A load that friction does not answer, as along the normal of all contacts, has to balance
    // by itself.
    const Eigen::MatrixXd off =
        wrenches * answers - Eigen::MatrixXd::Identity(motions_, motions_);
    for (Eigen::Index l = 0; l < motions_; ++l) {
      if (off.col(l).norm() > kFlat) answers.col(l).setZero();
    }
    for (std::size_t k = 0; k < bearing_.size(); ++k) {
      const std::size_t i = bearing_[k].contact;
      RestProof::Answer answer{ContactId(i), {}};
      for (Eigen::Index l = 0; l < motions_; ++l) {
        const double unit = box_.unit(static_cast<std::size_t>(l));
        Double3 f{};
        for (Eigen::Index j = first[k]; j < first[k + 1]; ++j) {
          f[static_cast<std::size_t>(j - first[k])] = answers(j, l) / unit;
        }
        answer.forces.push_back(box_.contacts[i].force_near(f, kBits));
      }
      proof_.answers.push_back(std::move(answer));
    }
    return true;
  }

  void state_friction() {
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      const LawContact& c = box_.contacts[i];
      const Double3& f = middle_.friction[i];
      if (middle_.sticks[i] == 0 || norm_of(f) == 0) continue;
      proof_.friction.emplace_back(ContactId(i), c.force_near(f, kBits));
    }
  }

  /// Measures max |W|, and max |M - 1| by rows.
  void measure(Rows& off, RationalRow& rest) const {
    for (const Rational& multiple : multiples_) {
      WrenchRange sum = loads_at(box_, multiple);
      auto next = proof_.friction.begin();
      for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
        const LawContact& c = box_.contacts[i];
        RationalRow f(c.slip_numbers());
        if (next != proof_.friction.end() && next->first.index() == i) f = (next++)->second;
        add_wrenches(sum, c, f, ends_of(preload_at(c, multiple)));
      }
      for (std::size_t k = 0; k < sum.size(); ++k) rest[k] = std::max(rest[k], largest(sum[k]));
    }
    for (std::size_t l = 0; l < rest.size(); ++l) {
      WrenchRange column(rest.size());
      column[l] = point_interval(-1);
      for (const RestProof::Answer& answer : proof_.answers) {
        add_wrenches(column, box_.contacts[answer.contact.index()], answer.forces[l], {0});
      }
      for (std::size_t k = 0; k < rest.size(); ++k) off[k][l] = largest(column[k]);
    }
  }

  /// Chooses Z, a little above the solution of Z = |W| + |M - 1| Z, in few bits.
  bool choose_reach(const Rows& off, const RationalRow& rest) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(motions_, motions_);
    Reals right(motions_);
    for (std::size_t k = 0; k < rest.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      right[row] = to_double(rest[k]);
      for (std::size_t l = 0; l < rest.size(); ++l) {
        system(row, static_cast<Eigen::Index>(l)) -= to_double(off[k][l]);
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
      proof_.reach.push_back(rational_in_bits(z * 1.0001, kBits));
    }
    return true;
  }

  /// Returns whether the rules `rest-reach` and `rest-cone` hold.
  bool holds(const Rows& off, const RationalRow& rest) const {
    for (std::size_t k = 0; k < rest.size(); ++k) {
      if (rest[k] + dot(off[k], proof_.reach) > proof_.reach[k]) return false;
    }
    std::vector<Rational> needed(box_.contacts.size());
    for (const auto& [contact, f] : proof_.friction) {
      needed[contact.index()] = length_above(box_.contacts[contact.index()], f);
    }
    for (const RestProof::Answer& answer : proof_.answers) {
      for (std::size_t l = 0; l < rest.size(); ++l) {
        const std::size_t i = answer.contact.index();
        needed[i] += length_above(box_.contacts[i], answer.forces[l]) * proof_.reach[l];
      }
    }
    constexpr unsigned kRootBits = 64;
    for (std::size_t i = 0; i < needed.size(); ++i) {
      if (needed[i].is_zero()) continue;
      const LawContact& c = box_.contacts[i];
      const Rational slope = c.friction.low * short_sqrt(c.squared_length, kRootBits).lower;
      for (const Rational& multiple : multiples_) {
        if (needed[i] > slope * preload_at(c, multiple).low) return false;
      }
    }
    return true;
  }

  const GraspLaw& box_;
  const NearEquilibrium& middle_;
  Eigen::Index motions_;
  std::vector<Rational> multiples_;  ///< 0, or the ends of a margin
  std::vector<Bearing> bearing_;     ///< contacts whose friction answers
  RestProof proof_;
};

}  // namespace

std::optional<RestProof> prove_at_rest(const GraspLaw& box, const NearEquilibrium& middle) {
  return RestSearch(box, middle).find();
}

}  // namespace stickslip
