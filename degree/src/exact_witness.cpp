// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/degree/exact_witness.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "independent_rows.hpp"
#include "stickslip/motion/dense.hpp"
#include "stickslip/motion/exact_system.hpp"

namespace stickslip {
namespace {

/// A number of these bits near x, which is about `size`.
Rational near(double x, double size, int bits) {
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(x)) return 0;
  const double unit = std::ldexp(1.0, std::ilogb(size) - bits);
  return rational_from_double(std::round(x / unit) * unit);
}

/// A basis of the motions with no slip at these contacts.
std::vector<RationalRow> motions_without_slip(const GraspLaw& model,
                                              const std::vector<std::size_t>& sticking) {
  std::vector<RationalRow> slips;
  for (const std::size_t i : sticking) {
    for (const Row& row : model.contacts[i].corners.front().slip) {
      slips.emplace_back(row.begin(), row.end());
    }
  }
  return null_space(matrix_of(slips, model.motions));
}

/// Returns the multiples of these motions whose sum is nearest to one in doubles.
Eigen::VectorXd multiples_near(const std::vector<RationalRow>& motions, const Reals& motion) {
  Eigen::MatrixXd rounded(motion.size(), static_cast<Eigen::Index>(motions.size()));
  for (std::size_t k = 0; k < motions.size(); ++k) {
    for (std::size_t j = 0; j < motions[k].size(); ++j) {
      rounded(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) =
          to_double(motions[k][j]);
    }
  }
  return least_squares(rounded, motion);
}

/// That sum.
RationalRow motion_near(const std::vector<RationalRow>& motions, const Reals& motion) {
  const Eigen::VectorXd parts = multiples_near(motions, motion);
  RationalRow result(static_cast<std::size_t>(motion.size()));
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const double part = parts[static_cast<Eigen::Index>(k)];
    if (std::isfinite(part)) add_multiple(result, rational_from_double(part), motions[k]);
  }
  return result;
}

/// Not in the law's units.
Reals unscaled(const GraspLaw& model, Reals motion) {
  for (std::size_t j = 0; j < model.motions; ++j) {
    motion[static_cast<Eigen::Index>(j)] /= model.unit(j);
  }
  return motion;
}

/// Two contacts on one face have the same slip, but where numbers are rounded: then one sticks,
/// and the other slips by a rounding with all the friction that there may be. Which of them
/// does, so that the other can carry what is left, is found here for those that stick and whose
/// slips have one dimension.
class RoundedFaces {
 public:
  RoundedFaces(const GraspLaw& model, const NearEquilibrium& near)
      : model_(model), near_(near), motion_(unscaled(model, near.motion)) {}

  /// Takes those that slip out of `sticking`, and notes the signs of their slips.
  void let_slip(std::vector<std::size_t>& sticking, std::vector<int>& slips) const {
    std::vector<std::size_t> order = sticking;  // those that rather stick first
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return spare(a) > spare(b); });
    for (std::size_t tries = 0; tries <= order.size(); ++tries) {
      std::vector<std::size_t> others;
      sticking = independent_of(order, others);
      if (others.empty()) break;
      const RationalRow exact = motion_near(motions_without_slip(model_, sticking), motion_);
      std::vector<std::size_t> wrong;
      for (const std::size_t i : others) {
        slips[i] = slip_at(exact, i).sign();
        if (slips[i] == 0)
          sticking.push_back(i);
        else if (!can_slip(i, slips[i], sticking))
          wrong.push_back(i);
      }
      if (wrong.empty() || tries == order.size()) break;
      for (const std::size_t i : wrong) {
        order.erase(std::find(order.begin(), order.end(), i));
        order.insert(order.begin(), i);
      }
      for (const std::size_t i : others) slips[i] = 0;
    }
  }

 private:
  /// Whether of those that stick the one whose slip is most like its own can carry the rest.
  bool can_slip(std::size_t i, int slip, const std::vector<std::size_t>& sticking) const {
    const auto row_of = [&](std::size_t k) -> const Reals& {
      return model_.contacts[k].corners.front().slip_rounded.front();
    };
    const auto likeness = [&](std::size_t k) {
      return std::fabs(row_of(i).dot(row_of(k))) / row_of(k).norm();
    };
    std::size_t other = i;
    for (const std::size_t k : sticking) {
      const bool has_one = model_.contacts[k].slip_dimension() == 1;
      if (has_one && (other == i || likeness(k) > likeness(other))) other = k;
    }
    if (other == i) return true;
    const auto most = [&](std::size_t k) {
      return model_.contacts[k].slopes[0] * near_.normal[k];
    };
    const double rest = near_.friction[i][0] + slip * most(i);
    const double carried = near_.friction[other][0] +
                           rest * row_of(i).dot(row_of(other)) / row_of(other).squaredNorm();
    return std::fabs(carried) <= most(other);
  }

  double spare(std::size_t i) const {
    return model_.contacts[i].slopes[0] * near_.normal[i] - norm_of(near_.friction[i]);
  }

  std::vector<std::size_t> independent_of(const std::vector<std::size_t>& order,
                                          std::vector<std::size_t>& others) const {
    constexpr double kNew = 1e-6;  // of a slip that those before do not have
    degree_detail::IndependentRows rows(static_cast<Eigen::Index>(model_.motions));
    std::vector<std::size_t> kept;
    for (const std::size_t i : order) {
      const LawContact& c = model_.contacts[i];
      const Reals& row = c.corners.front().slip_rounded.front();
      const bool has_one = c.slip_dimension() == 1;
      if (has_one && !(rows.beyond(row).norm() > kNew * row.norm())) {
        others.push_back(i);
        continue;
      }
      kept.push_back(i);
      if (has_one) rows.take(row);
    }
    return kept;
  }

  Rational slip_at(const RationalRow& motion, std::size_t i) const {
    const Row& row = model_.contacts[i].corners.front().slip.front();
    return dot(RationalRow(row.begin(), row.end()), motion);
  }

  const GraspLaw& model_;
  const NearEquilibrium& near_;
  Reals motion_;  ///< not in the law's units
};

/// The wrench of a unit of an unknown of the balance, and a value that it may be near.
struct BalanceTerm {
  RationalRow wrench;
  Rational value;
  double spare;         ///< how far it may change; motions: at will
  std::size_t contact;  ///< whose friction it is; of a motion none
  RationalRow direction;
};

/// Independent columns carry what the values leave to balance; those with most to spare first.
bool balance(std::vector<BalanceTerm>& terms, const RationalRow& rest) {
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return terms[a].spare > terms[b].spare;
  });
  std::vector<std::size_t> chosen;
  std::vector<RationalRow> columns;
  for (const std::size_t k : order) {
    columns.push_back(terms[k].wrench);
    if (rank_of(columns) == chosen.size()) {
      columns.pop_back();
      continue;
    }
    chosen.push_back(k);
    if (columns.size() == rest.size()) break;
  }
  const std::optional<RationalRow> change =
      solve_exactly(matrix_of_columns(columns, rest.size()), rest);
  if (!change) return false;
  for (std::size_t k = 0; k < chosen.size(); ++k) terms[chosen[k]].value += (*change)[k];
  return true;
}

/// With friction rounded to these bits. What may move at will is at rest, or where it is in
/// doubles: a body that nothing holds is at rest only if nothing pushes it there.
std::optional<ShareWitness> witness_in_bits(const GraspLaw& model,
                                            const NearEquilibrium& near_one, int bits,
                                            bool is_at_rest) {
  const std::size_t m = model.contacts.size();
  std::vector<bool> closed;
  for (std::size_t i = 0; i < m; ++i) {
    closed.push_back(model.contacts[i].is_spring || near_one.normal[i] > 0);
  }
  std::vector<std::size_t> sticking;
  std::vector<int> slips(m, 0);  // signs of those that slip, which has one dimension
  for (std::size_t i = 0; i < m; ++i) {
    const bool rubs = closed[i] && !model.contacts[i].friction.high.is_zero();
    if (!rubs) continue;
    if (near_one.sticks[i] != 0) {
      sticking.push_back(i);
    } else if (model.contacts[i].slip_dimension() > 1) {
      return std::nullopt;  // slips of irrational lengths
    } else {
      slips[i] = near_one.friction[i][0] < 0 ? 1 : -1;
    }
  }
  RoundedFaces(model, near_one).let_slip(sticking, slips);
  // Unknown: multiples of the motions that leave all of these without slip, and two numbers of
  // friction at each. Of the latter all but a few stay near what they are.
  const std::vector<RationalRow> motions = motions_without_slip(model, sticking);
  std::vector<BalanceTerm> terms;
  RationalRow rest;  // what the values leave to balance
  for (std::size_t j = 0; j < model.motions; ++j) rest.push_back(-model.wrench[j].low);
  for (const RationalRow& motion : motions) {
    terms.push_back({RationalRow(model.motions), 0, HUGE_VAL, m, motion});
  }
  for (std::size_t i = 0; i < m; ++i) {
    if (!closed[i]) continue;
    const LawContact& c = model.contacts[i];
    const CornerRow& row = c.corners.front();
    RationalRow edge = row.normal;
    if (slips[i] != 0) add_multiple(edge, -1, row.wrench_of({slips[i] * c.friction.low}));
    add_multiple(rest, -c.preload.low, edge);
    for (std::size_t k = 0; k < motions.size(); ++k) {
      const Rational rise = dot(row.normal, motions[k]);
      add_multiple(terms[k].wrench, -(c.stiffness.low * rise), edge);
    }
  }
  if (!is_at_rest) {
    const Eigen::VectorXd multiples = multiples_near(motions, unscaled(model, near_one.motion));
    for (std::size_t k = 0; k < motions.size(); ++k) {
      BalanceTerm& term = terms[k];
      term.value = near(multiples[static_cast<Eigen::Index>(k)],
                        multiples.lpNorm<Eigen::Infinity>(), bits);
      add_multiple(rest, -term.value, term.wrench);
    }
  }
  for (const std::size_t i : sticking) {
    const LawContact& c = model.contacts[i];
    const CornerRow& row = c.corners.front();
    const double most = c.slopes[0] * near_one.normal[i];
    const Double3& f = near_one.friction[i];
    for (std::size_t k = 0; k < c.directions.size(); ++k) {
      const double size = c.direction_sizes[k];
      BalanceTerm term{row.wrench_of(c.directions[k]), near(f[k] / size, most / size, bits),
                       most - norm_of(f), i, c.directions[k]};
      add_multiple(rest, -term.value, term.wrench);
      terms.push_back(std::move(term));
    }
  }
  if (!balance(terms, rest)) return std::nullopt;
  ShareWitness witness{RationalRow(model.motions), {}};
  std::vector<RationalRow> friction;
  for (const LawContact& c : model.contacts) friction.emplace_back(c.slip_numbers());
  for (const BalanceTerm& term : terms) {
    for (std::size_t k = 0; k < term.direction.size(); ++k) {
      Rational& sum = term.contact == m ? witness.twist[k] : friction[term.contact][k];
      sum += term.value * term.direction[k];
    }
  }
  // Judged: the modes, and the cones.
  for (std::size_t i = 0; i < m; ++i) {
    const LawContact& c = model.contacts[i];
    const Rational v =
        c.preload.low - c.stiffness.low * dot(c.corners.front().normal, witness.twist);
    if (c.is_spring) continue;
    if (closed[i] ? v.sign() < 0 : v.sign() > 0) return std::nullopt;
    if (model.law == NormalLaw::kBilateral && v.sign() < 0) return std::nullopt;
    if (slips[i] != 0 && v.sign() > 0) {
      const RationalRow slip(c.corners.front().slip.front().begin(),
                             c.corners.front().slip.front().end());
      const int sign = dot(slip, witness.twist).sign();
      if (sign == -slips[i]) return std::nullopt;
      if (sign == 0) witness.shares.emplace_back(ContactId(i), RationalRow{-slips[i]});
      continue;
    }
    if (c.squared_force(friction[i]).is_zero()) continue;
    const Rational scale = c.friction.low * v;
    if (scale.is_zero()) return std::nullopt;
    for (Rational& entry : friction[i]) entry /= scale;
    if (c.squared_force(friction[i]) > c.squared_length) return std::nullopt;
    witness.shares.emplace_back(ContactId(i), friction[i]);
  }
  return witness;
}

}  // namespace

std::optional<ShareWitness> exact_witness(const GraspLaw& model, const NearEquilibrium& near) {
  constexpr int kShort = 20;  // for people
  constexpr int kLong = 30;   // near the borders of cones
  for (const bool is_at_rest : {true, false}) {
    for (const int bits : {kShort, kLong}) {
      if (auto witness = witness_in_bits(model, near, bits, is_at_rest)) return witness;
    }
  }
  return std::nullopt;
}

}  // namespace stickslip
