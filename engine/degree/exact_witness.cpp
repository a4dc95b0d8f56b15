// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_witness.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

#include "engine/motion/dense.hpp"
#include "mode_program.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/sparse_system.hpp"

namespace stickslip {
namespace {

/// Returns a number of these bits near x, which is about `size`.
Rational near(double x, double size, int bits) {
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(x)) return 0;
  const double unit = std::ldexp(1.0, std::ilogb(size) - bits);
  return rational_from_double(std::round(x / unit) * unit);
}

/// Returns a basis of the motions with no slip at these contacts.
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

/// Returns the motion in the units of the file instead of the law's.
Reals unscaled(const GraspLaw& model, Reals motion) {
  for (std::size_t j = 0; j < model.motions; ++j) {
    motion[static_cast<Eigen::Index>(j)] /= model.unit(j);
  }
  return motion;
}

/// An unknown of the balance: the wrench of a unit of it, and a value that it may be near.
struct BalanceTerm {
  RationalRow wrench;
  Rational value;
  double spare;         ///< how far it may change; motions do without limit
  std::size_t contact;  ///< the contact whose friction it is; for a motion their number
  RationalRow direction;
};

/// Changes the values of independent columns so that all balances, those with most to spare
/// first. Returns false if they cannot.
bool balance(std::vector<BalanceTerm>& terms, const RationalRow& rest) {
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return terms[a].spare > terms[b].spare;
  });
  std::vector<SparseRow> columns;
  for (const std::size_t k : order) columns.push_back(sparse(terms[k].wrench));
  const SparseSystem system(rest.size(), columns);
  const auto change = system.solve(rest);
  if (!change) return false;
  const RationalRow changes = change->row();
  for (const std::size_t k : system.independent()) terms[order[k]].value += changes[k];
  return true;
}

/// Returns whether a contact is closed in doubles.
bool is_closed(const GraspLaw& model, const NearEquilibrium& near, std::size_t contact) {
  return model.contacts[contact].is_spring || near.normal[contact] > 0;
}

/// Returns whether a contact is closed in doubles and has friction.
bool rubs(const GraspLaw& model, const NearEquilibrium& near, std::size_t contact) {
  return is_closed(model, near, contact) && !model.contacts[contact].friction.high.is_zero();
}

/// Returns the contacts that stick in doubles.
std::vector<std::size_t> sticking_contacts(const GraspLaw& model, const NearEquilibrium& near) {
  std::vector<std::size_t> sticking;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    if (rubs(model, near, i) && near.sticks[i] != 0) sticking.push_back(i);
  }
  return sticking;
}

/// Returns an equilibrium with friction rounded to these bits. `motions` are a basis of those
/// that leave all contacts that stick without slip. Motions that nothing resists are at rest,
/// or else where they are in doubles: a body that nothing holds is at rest only if nothing
/// pushes it there.
std::optional<ShareWitness> witness_in_bits(const GraspLaw& model,
                                            const NearEquilibrium& near_one,
                                            const std::vector<RationalRow>& motions, int bits,
                                            bool is_at_rest) {
  const std::size_t m = model.contacts.size();
  std::vector<bool> closed;
  std::vector<int> slips(m, 0);  // the signs of slips along a line
  for (std::size_t i = 0; i < m; ++i) {
    closed.push_back(is_closed(model, near_one, i));
    if (!rubs(model, near_one, i) || near_one.sticks[i] != 0) continue;
    slips[i] = near_one.friction[i][0] < 0 ? 1 : -1;
  }
  // The unknowns are multiples of the motions, and the coordinates of friction at each contact
  // that sticks. All but a few of the latter stay near what they are.
  std::vector<BalanceTerm> terms;
  RationalRow rest;  // the wrench that the values leave to balance
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
  for (const std::size_t i : sticking_contacts(model, near_one)) {
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
  // The modes and the cones are judged here.
  for (std::size_t i = 0; i < m; ++i) {
    const LawContact& c = model.contacts[i];
    const Rational v =
        c.preload.low - c.stiffness.low * dot(c.corners.front().normal, witness.twist);
    if (c.is_spring) continue;
    if (closed[i] ? v.sign() < 0 : v.sign() > 0) return std::nullopt;
    if (model.normal_law == NormalLaw::kBilateral && v.sign() < 0) return std::nullopt;
    if (slips[i] != 0 && v.sign() > 0) {
      const int sign = dot(c.corners.front().slip.front(), witness.twist).sign();
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

/// Returns an equilibrium with these modes, in numbers as short as will do.
std::optional<ShareWitness> short_witness(const GraspLaw& model, const NearEquilibrium& near) {
  constexpr int kShort = 20;  // short numbers, for people
  constexpr int kLong = 30;   // near the borders of cones
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const bool slips = rubs(model, near, i) && near.sticks[i] == 0;
    if (slips && model.contacts[i].slip_dimension() > 1)
      return std::nullopt;  // by an irrational length
  }
  const std::vector<RationalRow> motions =
      motions_without_slip(model, sticking_contacts(model, near));
  for (const bool is_at_rest : {true, false}) {
    for (const int bits : {kShort, kLong}) {
      if (auto witness = witness_in_bits(model, near, motions, bits, is_at_rest))
        return witness;
    }
  }
  return std::nullopt;
}

/// Returns the same with some contacts that slip by a rounding, where all that stick in doubles
/// cannot; nothing if there are none.
///
/// Two contacts on one face would both stick, were their normals not rounded: the slip of one
/// follows from that of the other. By what rounding leaves of it, it slips to a side, with all
/// its friction; the other takes what that changes, as their friction has one line. The
/// contacts with the most friction to spare stick, but for those in `last`; `last` gets those
/// that would have to take more than they can. Doubles say which contacts slip so, and motions
/// at which the others stick exactly say to which side.
std::optional<NearEquilibrium> slipping_by_rounding(const GraspLaw& model, NearEquilibrium near,
                                                    std::vector<std::size_t>& last) {
  std::vector<std::size_t> sticking;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    if (near.sticks[i] == 0) continue;
    if (model.contacts[i].slip_dimension() > 1) return std::nullopt;
    sticking.push_back(i);
  }
  const auto most = [&](std::size_t i) { return model.contacts[i].slopes[0] * near.normal[i]; };
  const auto spare = [&](std::size_t i) { return most(i) - std::fabs(near.friction[i][0]); };
  const auto slip_row = [&](std::size_t i) -> const Reals& {
    return model.contacts[i].corners.front().slip_rounded.front();
  };
  std::stable_sort(sticking.begin(), sticking.end(),
                   [&](std::size_t a, std::size_t b) { return spare(a) > spare(b); });
  std::stable_partition(sticking.begin(), sticking.end(), [&](std::size_t i) {
    return std::find(last.begin(), last.end(), i) == last.end();
  });
  std::vector<std::size_t> free;           // their slips follow from those of no others
  std::vector<std::size_t> following;      // but for rounding
  std::vector<Eigen::VectorXd> multiples;  // of the free ones' slips, by following contact
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(model.motions), 0);
  for (const std::size_t i : sticking) {
    constexpr double kRounding = 1e-9;  // of the row
    const Reals& row = slip_row(i);
    if (!free.empty()) {
      Eigen::VectorXd parts = least_squares(rows, row);
      if ((rows * parts - row).norm() < kRounding * row.norm()) {
        following.push_back(i);
        multiples.push_back(std::move(parts));
        continue;
      }
    }
    free.push_back(i);
    rows.conservativeResize(Eigen::NoChange, rows.cols() + 1);
    rows.col(rows.cols() - 1) = row;
  }
  const std::vector<RationalRow> motions = motions_without_slip(model, free);
  const Eigen::VectorXd nearest = multiples_near(motions, unscaled(model, near.motion));
  RationalRow d(model.motions);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    add_multiple(d, rational_from_double(nearest[static_cast<Eigen::Index>(k)]), motions[k]);
  }
  bool slips = false;
  for (std::size_t k = 0; k < following.size(); ++k) {
    const std::size_t i = following[k];
    const int sign = dot(model.contacts[i].corners.front().slip.front(), d).sign();
    if (sign == 0) continue;
    slips = true;
    near.sticks[i] = 0;
    const double change = near.friction[i][0] + sign * most(i);
    near.friction[i][0] -= change;
    for (Eigen::Index j = 0; j < multiples[k].size(); ++j) {
      near.friction[free[static_cast<std::size_t>(j)]][0] += multiples[k][j] * change;
    }
  }
  if (!slips) return std::nullopt;
  std::copy_if(free.begin(), free.end(), std::back_inserter(last),
               [&](std::size_t i) { return spare(i) < 0; });
  return near;
}

}  // namespace

std::optional<ShareWitness> exact_witness(const GraspLaw& model, const NearEquilibrium& near) {
  if (auto witness = short_witness(model, near)) return witness;
  std::vector<std::size_t> last;
  constexpr int kMostTries = 4;
  for (int tries = 0; tries < kMostTries; ++tries) {
    const std::size_t before = last.size();
    const auto slipping = slipping_by_rounding(model, near, last);
    if (!slipping) break;
    if (last.size() > before) continue;  // others slip in place of these
    if (auto witness = short_witness(model, *slipping)) return witness;
    break;
  }
  return degree_detail::equilibrium_in_modes(model, near);
}

}  // namespace stickslip
