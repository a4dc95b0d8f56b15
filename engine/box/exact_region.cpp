// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_region.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::box_detail {
namespace {

/// The pushes of a contact: a = p + q, along the edges N + mu T and N - mu T of its cone.
struct Pushes {
  std::vector<Rational> most;        ///< v by point, or max(0, v) of a mixed contact
  bool is_open = false;              ///< it is open on all of the region
  bool may_be_less = false;          ///< mixed: a is at most this
  std::vector<RationalRow> edges{};  ///< only one, if its slip has a sign or nothing rubs
  std::size_t first = 0;             ///< the variable of the first edge
};

/// The relaxation of a region: points with weights, and forces that the cones allow.
class RelaxedRegion {
 public:
  RelaxedRegion(const Law& law, const MotionRegion& region) : law_(law), region_(region) {
    for (std::size_t i = 0; i < law.contacts.size(); ++i) add_contact(i);
  }

  /// Returns a twist that refutes the region; or weights and forces with which this strict
  /// function is not 0.
  std::variant<Row, std::vector<Rational>> solve(const std::vector<std::size_t>& strict) {
    const std::size_t points = region_.points().size();
    LinearProgram program;
    program.add_variables(points, VariableKind::kNonNegative);
    for (Pushes& c : pushes_) {
      if (has_variables(c)) {
        c.first = program.add_variables(c.edges.size(), VariableKind::kNonNegative);
      }
    }
    for (std::size_t j = 0; j < law_.motions; ++j)
      program.add_row(balance(j, program), Relation::kEqual, 0);
    for (const Pushes& c : pushes_) {
      if (!has_variables(c)) continue;
      std::vector<Rational> row(program.variable_count());
      for (std::size_t g = 0; g < points; ++g) row[g] = -c.most[g];
      for (std::size_t e = 0; e < c.edges.size(); ++e) row[c.first + e] = 1;
      program.add_row(std::move(row), c.may_be_less ? Relation::kLessEqual : Relation::kEqual,
                      0);
    }
    std::vector<Rational> scale(points);
    for (const std::size_t g : strict) scale[g] = 1;
    program.add_row(std::move(scale), Relation::kEqual, 1);
    const LpResult result = stickslip::solve(program);
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      return primitive_multiple(
          RationalRow(infeasible->farkas.begin(),
                      infeasible->farkas.begin() + static_cast<std::ptrdiff_t>(law_.motions)));
    }
    return std::get<Optimal>(result).point;
  }

  /// Returns the split at the law that is broken most at this point; if none is, the
  /// equilibrium.
  std::variant<TreeNode, ShareWitness> judge(const std::vector<Rational>& solution) const {
    RationalRow x(law_.coordinates());
    for (std::size_t g = 0; g < region_.points().size(); ++g) {
      if (solution[g].is_zero()) continue;
      for (std::size_t j = 0; j < x.size(); ++j) {
        x[j] += solution[g] * Rational(region_.points()[g][j]);
      }
    }
    const Rational h = x[law_.motions];
    require(h.sign() > 0, "h is a strict function");
    ShareWitness witness{
        RationalRow(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(law_.motions)), {}};
    for (Rational& entry : witness.twist) entry /= h;
    std::optional<TreeNode> broken;
    Rational widest = 0;
    const auto consider = [&](const Rational& breach, const auto& split) {
      if (abs(breach) <= widest) return;
      widest = abs(breach);
      broken = TreeNode(split);
    };
    for (std::size_t i = 0; i < pushes_.size(); ++i) {
      const Pushes& c = pushes_[i];
      if (!has_variables(c)) continue;
      const LawContact& contact = law_.contacts[i];
      const CornerRow& row = contact.corners.front();
      Rational a = 0;
      for (std::size_t e = 0; e < c.edges.size(); ++e) a += solution[c.first + e];
      if (c.may_be_less) {
        const Rational v = separation(contact, x);
        consider(a - std::max<Rational>(0, v), SeparationSplit{ContactId(i)});
      }
      if (c.edges.size() < 2 || a.is_zero()) continue;
      const Rational slip = dot(row.wrench_of({1}), x);
      const Rational share = (solution[c.first] - solution[c.first + 1]) / a;
      if (slip.is_zero()) {
        if (!share.is_zero()) witness.shares.emplace_back(ContactId(i), RationalRow{share});
        continue;
      }
      const Rational lacking = 1 + share * slip.sign();  // missing friction against the slip
      consider(contact.friction.low * a * lacking * slip, SlipSplit{ContactId(i)});
    }
    if (broken) return *broken;
    return witness;
  }

 private:
  static Rational separation(const LawContact& contact, const RationalRow& x) {
    return contact.separation_factors.front() * dot(contact.separations.front(), x);
  }

  static bool has_variables(const Pushes& c) {
    return !c.is_open && (c.may_be_less || c.edges.size() > 1);
  }

  void add_contact(std::size_t i) {
    const LawContact& contact = law_.contacts[i];
    const CornerRow& row = contact.corners.front();
    Pushes& c = pushes_.emplace_back();
    c.is_open = region_.separation(i) == Separation::kOpen;
    if (c.is_open) return;
    c.may_be_less = region_.separation(i) == Separation::kMixed;
    for (const Row& point : region_.points()) {
      Rational v = separation(contact, RationalRow(point.begin(), point.end()));
      if (c.may_be_less && v.sign() < 0) v = 0;
      c.most.push_back(std::move(v));
    }
    const auto edge = [&](int sign) {
      c.edges.push_back(row.push_with({sign * contact.friction.low}));
    };
    if (contact.friction.low.is_zero()) {
      edge(0);
    } else if (const std::optional<Sign> slip = region_.slip_sign(i)) {
      edge(*slip == Sign::kPositive ? -1 : 1);
    } else {
      edge(1);
      edge(-1);
    }
  }

  /// Returns the row of the balance of one component of all wrenches.
  std::vector<Rational> balance(std::size_t component, const LinearProgram& program) const {
    std::vector<Rational> row(program.variable_count());
    const std::size_t d = law_.motions;
    for (std::size_t g = 0; g < region_.points().size(); ++g) {
      row[g] = Rational(region_.points()[g][d]) * law_.wrench[component].low;
    }
    for (const Pushes& c : pushes_) {
      if (c.is_open) continue;
      if (!has_variables(c)) {
        for (std::size_t g = 0; g < c.most.size(); ++g) {
          row[g] += c.most[g] * c.edges.front()[component];
        }
        continue;
      }
      for (std::size_t e = 0; e < c.edges.size(); ++e) {
        row[c.first + e] = c.edges[e][component];
      }
    }
    return row;
  }

  const Law& law_;
  const MotionRegion& region_;
  std::vector<Pushes> pushes_;
};

}  // namespace

std::variant<TreeNode, ShareWitness> decide_exactly(const Law& law,
                                                    const MotionRegion& region) {
  RelaxedRegion relaxed(law, region);
  std::vector<Rational> sum;
  for (const std::vector<std::size_t>& strict : region.strict_points()) {
    auto outcome = relaxed.solve(strict);
    if (auto* twist = std::get_if<Row>(&outcome)) return TreeNode(TwistLeaf{std::move(*twist)});
    // No strict function is negative anywhere, so none is 0 in the sum.
    const auto& found = std::get<std::vector<Rational>>(outcome);
    sum.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) sum[k] += found[k];
  }
  return relaxed.judge(sum);
}

}  // namespace stickslip::box_detail
