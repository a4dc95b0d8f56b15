// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs by degree where a body floats, touched by nothing, beside others that are held: it may
// be anywhere, so equilibria lie side by side, and no body of motions encloses them.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "body_reach.hpp"
#include "prove_stable.hpp"
#include "rounded_box.hpp"
#include "stickslip/engine/force_span.hpp"
#include "stickslip/lp/exact_system.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

using namespace degree_detail;

namespace {

/// Returns whether some force of a contact does work on the motion, at a corner.
bool sees(const LawContact& contact, const RationalRow& motion) {
  return std::any_of(contact.corners.begin(), contact.corners.end(), [&](const CornerRow& row) {
    return !dot(row.normal, motion).is_zero() ||
           (!contact.friction.high.is_zero() &&
            std::any_of(row.slip.begin(), row.slip.end(),
                        [&](const Row& slip) { return !dot(slip, motion).is_zero(); }));
  });
}

/// Returns the motion along these that opens the contacts as far as possible, up to `most`; or
/// nothing if none opens them all.
std::optional<RationalRow> opening(const RoundedGrasp& grasp, const NearEquilibrium& near,
                                   const GraspLaw& law, const std::vector<ContactId>& contacts,
                                   const std::vector<RationalRow>& along, double most) {
  LinearProgram program;
  program.add_variables(along.size(), VariableKind::kFree);
  const std::size_t opened = program.add_variable(VariableKind::kFree);
  for (const ContactId id : contacts) {
    const RoundedContact& c = grasp.contacts[id.index()];
    const double depth = c.separation(near.motion) / c.stiffness;
    if (!std::isfinite(depth) || !std::isfinite(c.size)) return std::nullopt;
    // v - k' N.z <= -k' |N| t, whatever the unit of N is.
    for (const CornerRow& corner : law.contacts[id.index()].corners) {
      RationalRow row;
      for (const RationalRow& z : along) row.push_back(dot(corner.normal, z));
      row.push_back(-rational_from_double(c.size));
      program.add_row(std::move(row), Relation::kGreaterEqual, rational_from_double(depth));
    }
  }
  RationalRow only(opened + 1);
  only[opened] = 1;
  program.add_row(only, Relation::kLessEqual, rational_from_double(most));
  only[opened] = -1;
  program.minimize(only);
  const LpResult result = solve(program);
  const auto* optimal = std::get_if<Optimal>(&result);
  if (optimal == nullptr || optimal->value.sign() >= 0) return std::nullopt;
  RationalRow motion(law.motions);
  for (std::size_t k = 0; k < along.size(); ++k) {
    add_multiple(motion, optimal->point[k], along[k]);
  }
  return motion;
}

/// Removes the forces of these contacts.
void remove_forces(NearEquilibrium& near, const std::vector<ContactId>& contacts) {
  for (auto id = contacts.rbegin(); id != contacts.rend(); ++id) {
    const auto at = static_cast<std::ptrdiff_t>(id->index());
    near.normal.erase(near.normal.begin() + at);
    near.friction.erase(near.friction.begin() + at);
    near.sticks.erase(near.sticks.begin() + at);
  }
}

/// Returns the proof of what is in equilibrium wherever it is, as nothing touches it and there
/// is no load; nothing if there is one, or if it is beyond the bound of motions.
std::optional<DegreeProof> resting_anywhere(const GraspLaw& box, const GraspLaw& middle,
                                            const NearEquilibrium& near) {
  if (!ForceSpan(box).has_loads_of(box)) return std::nullopt;
  DegreeProof proof;
  for (std::size_t j = 0; j < box.motions; ++j) {
    const double d = near.motion[static_cast<Eigen::Index>(j)] / middle.unit(j);
    proof.twist.push_back(rational_from_double(d));
  }
  if (!box.allows(proof.twist)) return std::nullopt;
  proof.direction.assign(box.motions, RationalRow(box.motions));
  return proof;
}

/// Returns whether the contact is open on all of the body across its free motions: rule
/// `degree-open`, of verdicts.
bool is_open(const LawContact& contact, const DegreeProof& proof, const BodyReach& reach) {
  return std::all_of(
      contact.separations.begin(), contact.separations.end(), [&](const Row& separation) {
        const RationalRow along(
            separation.begin(),
            separation.begin() + static_cast<std::ptrdiff_t>(proof.twist.size()));
        return dot(along, proof.twist) + Rational(separation[proof.twist.size()]) +
                   reach.largest(along) <=
               0;
      });
}

/// Gives contacts the numbers that they have among all.
class Renumbering {
 public:
  explicit Renumbering(const std::vector<ContactId>& left_out) : left_out_(left_out) {}

  void renumber(Trees& trees) const {
    for (TreeNode& node : trees) std::visit(*this, node);
  }
  void operator()(SlipSplit& split) const { split.contact = number(split.contact); }
  void operator()(SeparationSplit& split) const { split.contact = number(split.contact); }
  void operator()(PlaneCut& /*cut*/) const {}
  void operator()(TwistLeaf& /*leaf*/) const {}
  void operator()(MovingLeaf& leaf) const {
    for (MovingLeaf::OwnSlip& own : leaf.own) own.contact = number(own.contact);
  }
  void operator()(PartSplit& split) const {
    if (split.parameter != Parameter::kWrench) {
      split.index = number(ContactId(split.index)).index();
    }
  }

 private:
  ContactId number(ContactId among_others) const {
    std::size_t i = among_others.index();
    for (const ContactId id : left_out_) i += id.index() <= i ? 1 : 0;
    return ContactId(i);
  }

  const std::vector<ContactId>& left_out_;
};

}  // namespace

std::optional<DegreeProof> prove_beside(const GraspLaw& box, const GraspLaw& middle,
                                        const NearEquilibrium& near, const DegreeLimits& limits,
                                        SearchWork& work) {
  if (box.normal_law == NormalLaw::kBilateral || box.is_family) return std::nullopt;
  const RoundedGrasp grasp = rounded_middle(middle);
  // A contact without a force is left out if it sees a motion that no contact with one does.
  constexpr double kForce = 1e-9;
  std::vector<ContactId> open;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    if (!c.is_spring && near.normal[i] * c.size <= kForce * grasp.force) open.emplace_back(i);
  }
  const std::vector<RationalRow> free = ForceSpan(box.without(open)).free_motions();
  const auto is_blind = [&](ContactId id) {
    return std::none_of(free.begin(), free.end(), [&](const RationalRow& z) {
      return sees(box.contacts[id.index()], z);
    });
  };
  open.erase(std::remove_if(open.begin(), open.end(), is_blind), open.end());
  if (open.empty()) return std::nullopt;
  const GraspLaw others = box.without(open);
  const GraspLaw middle_of_others = middle.without(open);
  // A little way off is within more bounds, and a long way leaves more room for what is near.
  for (const double far : {1.0, 10.0}) {
    const auto away = opening(grasp, near, middle, open, free, far * grasp.reach);
    if (!away) return std::nullopt;
    NearEquilibrium there = near;
    for (std::size_t j = 0; j < box.motions; ++j) {
      double& d = there.motion[static_cast<Eigen::Index>(j)];
      // (The unit of rotations is a distance that all contacts have a part in.)
      d = (d / middle.unit(j) + to_double((*away)[j])) * middle_of_others.unit(j);
    }
    if (!there.motion.allFinite()) return std::nullopt;
    remove_forces(there, open);
    auto proof = free.size() == box.motions
                     ? resting_anywhere(others, middle_of_others, there)
                     : prove_by_degree(others, middle_of_others, there, limits, work);
    if (!proof) continue;
    const BodyReach reach(*proof);
    const bool are_open = std::all_of(open.begin(), open.end(), [&](ContactId id) {
      return is_open(box.contacts[id.index()], *proof, reach);
    });
    if (!are_open) continue;
    Renumbering(open).renumber(proof->trees);
    proof->open = std::move(open);
    return proof;
  }
  return std::nullopt;
}

}  // namespace stickslip
