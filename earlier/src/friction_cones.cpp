// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/friction_cones.hpp"

#include <algorithm>
#include <array>

#include "contact_forces.hpp"
#include "engine/planar/region.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// Returns max(0, v), or v under the bilateral law.
Rational normal_law(const Problem& problem, const ContactRow& row, const Twist& d) {
  const Rational v = row.normal_coefficient(d);
  return problem.law() == NormalLaw::kUnilateral && v.sign() < 0 ? Rational(0) : v;
}

/// The program of one region, in d and the coefficients on the edges of the friction cones.
class RegionProgram {
 public:
  RegionProgram(const Problem& problem, const Region& region) : problem_(problem) {
    program_.add_variables(3, VariableKind::kFree);
    program_.add_variables(2 * problem.size(), VariableKind::kNonNegative);
    for (std::size_t j = 0; j < 3; ++j) {
      std::vector<Rational> coefficients(3);
      for (std::size_t i = 0; i < problem.size(); ++i) {
        for (const int side : {1, -1}) {
          coefficients.push_back(coordinates(problem.edge_wrench(ContactId(i), side))[j]);
        }
      }
      program_.add_row(std::move(coefficients), Relation::kEqual,
                       -coordinates(problem.wrench())[j]);
    }
    const ConeSigns signs(region.cone());
    for (std::size_t i = 0; i < problem.size(); ++i) {
      separations_.push_back(Region::separation(problem, ContactId(i), signs));
      add_contact(i);
    }
  }

  LpResult solve() const { return stickslip::solve(program_); }

  Witness witness(const std::vector<Rational>& point) const {
    Witness result{{point[0], point[1], point[2]}, {}};
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      result.forces.push_back(
          force_of_edges(problem_.rows()[i], point[3 + 2 * i], point[4 + 2 * i]));
    }
    return result;
  }

  TwistLeaf leaf(const std::vector<Rational>& farkas) const {
    return {primitive_multiple(RationalRow{farkas[0], farkas[1], farkas[2]})};
  }

  /// Returns the contact, which may be open or closed here, whose a_i >= v_i the contradiction
  /// uses most. A leaf counts no negative work of such contacts; if there are none the leaf
  /// refutes.
  ContactId most_used(const std::vector<Rational>& farkas) const {
    std::optional<std::size_t> most;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      if (separations_[i] != Separation::kMixed) continue;
      if (!most || farkas[normal_rows_[i]] > farkas[normal_rows_[*most]]) most = i;
    }
    require(most && !farkas[normal_rows_[*most]].is_zero(),
            "a Farkas vector does not refute its region");
    return ContactId(*most);
  }

 private:
  void add_contact(std::size_t i) {
    const ContactRow& row = problem_.rows()[i];
    const Vector3 n = coordinates(row.stiffness * row.normal);
    std::vector<Rational> spring{n.begin(), n.end()};
    if (separations_[i] != Separation::kOpen) {
      // The row is a_i + k N.d = P, or >= while the contact may be open.
      spring.resize(5 + 2 * i);
      spring[3 + 2 * i] = spring[4 + 2 * i] = 1;
      normal_rows_.push_back(program_.add_row(
          std::move(spring),
          separations_[i] == Separation::kClosed ? Relation::kEqual : Relation::kGreaterEqual,
          row.preload));
      return;
    }
    normal_rows_.push_back(
        program_.add_row(std::move(spring), Relation::kGreaterEqual, row.preload));
    std::vector<Rational> force(5 + 2 * i);
    force[3 + 2 * i] = force[4 + 2 * i] = 1;
    program_.add_row(std::move(force), Relation::kEqual, 0);
  }

  const Problem& problem_;
  LinearProgram program_;
  std::vector<Separation> separations_;
  std::vector<std::size_t> normal_rows_;
};

class SeparationSearch {
 public:
  SeparationSearch(const Problem& problem, std::size_t most_programs)
      : problem_(problem), programs_left_(most_programs) {}

  enum class Outcome { kRefuted, kFound, kLimit };

  /// Extends the tree by one for `region`, unless it finds forces first.
  Outcome run(const Region& region) {
    if (region.is_barred()) {
      tree.emplace_back(TwistLeaf{Row(3)});
      return Outcome::kRefuted;
    }
    if (programs_left_ == 0) return Outcome::kLimit;
    --programs_left_;
    const RegionProgram program(problem_, region);
    const LpResult result = program.solve();
    if (const auto* infeasible = std::get_if<Infeasible>(&result)) {
      TwistLeaf leaf = program.leaf(infeasible->farkas);
      if (!refutes(problem_, region, leaf)) {
        return split(region, program.most_used(infeasible->farkas));
      }
      tree.emplace_back(std::move(leaf));
      return Outcome::kRefuted;
    }
    witness = program.witness(std::get<Optimal>(result).point);
    const std::optional<ContactId> broken = most_in_excess();
    return broken ? split(region, *broken) : Outcome::kFound;
  }

  Trees tree;
  Witness witness;

 private:
  Outcome split(const Region& region, ContactId contact) {
    tree.emplace_back(SeparationSplit{contact});
    const Outcome closed = run(region.separation_child(problem_, contact, Separation::kClosed));
    if (closed != Outcome::kRefuted) return closed;
    return run(region.separation_child(problem_, contact, Separation::kOpen));
  }

  std::optional<ContactId> most_in_excess() const {
    std::optional<ContactId> worst;
    Rational most = 0;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const Rational excess =
          witness.forces[i].normal - normal_law(problem_, problem_.rows()[i], witness.twist);
      if (excess > most) {
        most = excess;
        worst = ContactId(i);
      }
    }
    return worst;
  }

  const Problem& problem_;
  std::size_t programs_left_;
};

}  // namespace

ConesVerdict friction_cones_alone(const Problem& problem, std::size_t most_programs) {
  SeparationSearch search(problem, most_programs);
  switch (search.run(Region::root(problem))) {
    case SeparationSearch::Outcome::kLimit:
      return Undecided{"it takes more than " + std::to_string(most_programs) +
                       " linear programs"};
    case SeparationSearch::Outcome::kRefuted:
      return std::move(search.tree);
    default:
      break;
  }
  const Witness& found = search.witness;
  require(balances_in_cones(problem, found.forces), "the forces do not balance the load");
  for (std::size_t i = 0; i < problem.size(); ++i) {
    require(found.forces[i].normal == normal_law(problem, problem.rows()[i], found.twist),
            "a normal force breaks its law");
  }
  return found;
}

}  // namespace stickslip
