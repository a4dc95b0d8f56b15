// SPDX-License-Identifier: GPL-3.0-or-later
#include "answering_forces.hpp"

#include <algorithm>
#include <optional>

#include "engine/motion/dense.hpp"

namespace stickslip::degree_detail {

Interval preload_at(const LawContact& c, const Rational& multiple) {
  return {c.preload.low + multiple * c.rate.low, c.preload.high + multiple * c.rate.high};
}

void add_wrenches(WrenchRange& sum, const LawContact& c, const RationalRow& friction,
                  const std::vector<Rational>& normal) {
  std::optional<WrenchRange> ends;
  for (const CornerRow& corner : c.corners) {
    const RationalRow across = corner.wrench_of(friction);
    for (const Rational& a : normal) {
      RationalRow wrench = across;
      for (std::size_t k = 0; k < wrench.size(); ++k) wrench[k] += a * corner.normal[k];
      if (!ends) {
        ends.emplace();
        for (const Rational& entry : wrench) ends->push_back(point_interval(entry));
      }
      for (std::size_t k = 0; k < wrench.size(); ++k) {
        (*ends)[k].low = std::min((*ends)[k].low, wrench[k]);
        (*ends)[k].high = std::max((*ends)[k].high, wrench[k]);
      }
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum[k].low += (*ends)[k].low;
    sum[k].high += (*ends)[k].high;
  }
}

WrenchRange loads_at(const GraspLaw& box, const Rational& multiple) {
  WrenchRange loads;
  for (std::size_t k = 0; k < box.motions; ++k) {
    Row along(box.motions);
    along[k] = 1;
    const Rational most = box.most_load_work(along);
    const Rational least = -box.most_load_work(negated(along));
    const Rational grown = multiple * box.growth[k];
    loads.push_back({least + grown, most + grown});
  }
  return loads;
}

Rational largest(const Interval& interval) {
  return std::max<Rational>(-interval.low, interval.high);
}

Rational length_above(const LawContact& contact, const RationalRow& f) {
  constexpr unsigned kBits = 64;
  return short_sqrt(contact.squared_force(f), kBits).upper;
}

AnswerSearch::AnswerSearch(const GraspLaw& box, const NearEquilibrium& middle)
    : box_(box),
      middle_(middle),
      motions_(static_cast<Eigen::Index>(box.motions)),
      multiples_{box.is_family ? box.multiples.low : Rational(0)},
      off_(box.motions, RationalRow(box.motions)),
      rest_(box.motions) {
  if (box.is_family && box.multiples.high && *box.multiples.high != box.multiples.low) {
    multiples_.push_back(*box.multiples.high);
  }
}

Eigen::MatrixXd AnswerSearch::normal_of(std::size_t contact) const {
  return box_.contacts[contact].corners.front().normal_rounded.transpose();
}

Eigen::MatrixXd AnswerSearch::slip_of(std::size_t contact) const {
  const std::vector<Reals>& rows = box_.contacts[contact].corners.front().slip_rounded;
  Eigen::MatrixXd slip(static_cast<Eigen::Index>(rows.size()), motions_);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    slip.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
  }
  return slip;
}

void AnswerSearch::keep_best(std::vector<Bearing>& bearing, std::size_t most,
                             const std::function<Eigen::MatrixXd(std::size_t)>& rows_of) const {
  constexpr std::size_t kMany = 8;
  if (bearing.size() <= kMany) return;
  std::stable_sort(bearing.begin(), bearing.end(),
                   [](const Bearing& a, const Bearing& b) { return a.spare > b.spare; });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(motions_, motions_);
  std::size_t taken = 0;
  while (taken < std::min(bearing.size(), most) &&
         (taken < kMany || rank(sum, kFlat) < motions_)) {
    const Eigen::MatrixXd rows = rows_of(bearing[taken++].contact);
    sum += rows.transpose() * rows;
  }
  bearing.resize(taken);
  std::sort(bearing.begin(), bearing.end(),
            [](const Bearing& a, const Bearing& b) { return a.contact < b.contact; });
}

Eigen::MatrixXd AnswerSearch::right_inverse(const Eigen::MatrixXd& wrenches,
                                            const Eigen::VectorXd& weights) {
  const Eigen::MatrixXd gram = wrenches * weights.asDiagonal() * wrenches.transpose();
  return weights.asDiagonal() * wrenches.transpose() * pseudo_inverse(gram, kFlat);
}

void AnswerSearch::state_friction(std::size_t contact) {
  const Double3& f = middle_.friction[contact];
  if (norm_of(f) == 0) return;
  friction_.emplace_back(ContactId(contact), box_.contacts[contact].force_near(f, kForceBits));
}

void AnswerSearch::state_answer(std::size_t contact, const Eigen::MatrixXd& forces,
                                Eigen::Index first) {
  const LawContact& c = box_.contacts[contact];
  RestProof::Answer answer{ContactId(contact), {}};
  for (std::size_t l = 0; l < box_.motions; ++l) {
    Double3 f{};
    for (std::size_t j = 0; j < c.slip_dimension(); ++j) {
      f[j] = forces(first + static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(l)) /
             box_.unit(l);
    }
    answer.forces.push_back(c.force_near(f, kForceBits));
  }
  answers_.push_back(std::move(answer));
}

void AnswerSearch::measure(const std::function<Interval(std::size_t, std::size_t)>& normal) {
  for (std::size_t at = 0; at < multiples_.size(); ++at) {
    WrenchRange sum = loads_at(box_, multiples_[at]);
    auto next = friction_.begin();
    for (std::size_t i = 0; i < box_.contacts.size(); ++i) {
      const LawContact& c = box_.contacts[i];
      RationalRow f(c.slip_numbers());
      if (next != friction_.end() && next->first.index() == i) f = (next++)->second;
      add_wrenches(sum, c, f, ends_of(normal(at, i)));
    }
    for (std::size_t k = 0; k < sum.size(); ++k) rest_[k] = std::max(rest_[k], largest(sum[k]));
  }
  for (std::size_t l = 0; l < rest_.size(); ++l) {
    WrenchRange column(rest_.size());
    column[l] = point_interval(-1);
    for (const StickingProof::Press& press : presses_) {
      const LawContact& c = contact(press.contact);
      add_wrenches(column, c, RationalRow(c.slip_numbers()), {press.forces[l]});
    }
    for (const RestProof::Answer& answer : answers_) {
      add_wrenches(column, contact(answer.contact), answer.forces[l], {0});
    }
    for (std::size_t k = 0; k < rest_.size(); ++k) off_[k][l] = largest(column[k]);
  }
}

bool AnswerSearch::is_reached(const RationalRow& reach, bool strictly) const {
  for (std::size_t k = 0; k < rest_.size(); ++k) {
    const Rational needed = rest_[k] + dot(off_[k], reach);
    if (strictly ? needed >= reach[k] : needed > reach[k]) return false;
  }
  return true;
}

std::vector<Rational> AnswerSearch::friction_needed(const RationalRow& reach) const {
  std::vector<Rational> needed(box_.contacts.size());
  for (const auto& [id, f] : friction_) needed[id.index()] = length_above(contact(id), f);
  for (const RestProof::Answer& answer : answers_) {
    for (std::size_t l = 0; l < reach.size(); ++l) {
      needed[answer.contact.index()] +=
          length_above(contact(answer.contact), answer.forces[l]) * reach[l];
    }
  }
  return needed;
}

Rational AnswerSearch::least_slope(const LawContact& c) {
  return c.friction.low * short_sqrt(c.squared_length, kRootBits).lower;
}

}  // namespace stickslip::degree_detail
