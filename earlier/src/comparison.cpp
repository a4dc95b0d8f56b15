// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/comparison.hpp"

#include <algorithm>

#include "contact_forces.hpp"
#include "method_answer.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// A grasp wrench space of more contacts than these is not computed.
constexpr std::size_t kMostContactsForWrenchSpace = 64;

/// The first contact with friction in a passive equilibrium.
struct Rubbing {
  std::size_t contact;
  Rational ratio;  ///< |c_t| / c_n
  bool slips;
};

class MethodsAsked {
 public:
  MethodsAsked(const Problem& problem, const AnyGrasp& grasp, const CompareOptions& options,
               NumberText& text)
      : problem_(problem),
        grasp_(grasp),
        bounded_(grasp.is_bounded() ? grasp.box() : nullptr),
        options_(options),
        text_(text) {}

  Comparison ask() {
    Comparison result;
    result.methods =
        asked(all_methods(), options_, [this](MethodId method) { return answer(method); });
    result.load_class = class_of(weakly_stable_, strongly_stable_);
    return result;
  }

 private:
  MethodAnswer answer(MethodId method) {
    switch (method) {
      case MethodId::kPassive:
        return passive();
      case MethodId::kFormClosure:
        return closure_answer(form_closure(problem_), text_);
      case MethodId::kFrictionless:
        return frictionless();
      case MethodId::kStronglyStable:
        return strong();
      case MethodId::kWeaklyStable:
        return weak();
      case MethodId::kWrenchSpaceL1:
        return wrench_space(ForceBound::kL1);
      case MethodId::kWrenchSpaceLinf:
        return wrench_space(ForceBound::kLinf);
      case MethodId::kLinearCompliance:
        return linear();
      case MethodId::kThreeStates:
        return three_states();
      case MethodId::kContactRobustness:
      case MethodId::kGraspRobustness:
      case MethodId::kRigidMotionRobustness:
        return robustness_answer(grasp_.as_box(), method, options_, text_);
      case MethodId::kGraspMap:
        return grasp_map_answer(grasp_.as_box(), options_.length, text_);
      case MethodId::kWrenchVolume:
        return wrench_volume_answer(grasp_.as_box(), options_, text_);
      case MethodId::kLeastForce:
        return least_force_answer(grasp_.as_box(), options_, text_);
      case MethodId::kInternalMargin:
        return internal_margin_answer(grasp_.as_box(), options_, text_);
      case MethodId::kCentroid:
        return centroid_answer(grasp_.as_box(), options_.inertia.centre, text_);
      default:
        return cones();
    }
  }

  MethodAnswer passive() {
    if (bounded_ != nullptr) {
      MethodAnswer passive = passive_answer(*bounded_, problem_.law(), text_);
      if (passive.verdict != "undecided") passive_stable_ = passive.verdict == "stable";
      return passive;
    }
    const Verdict verdict = decide(problem_).verdict;
    if (const auto* stable = std::get_if<Stable>(&verdict)) {
      passive_stable_ = true;
      note_friction(stable->witness());
      return of_load(
          true,
          "the motion " + text_(stable->witness().twist) + " gives rise to forces that hold",
          witness_json(stable->witness()));
    }
    if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
      passive_stable_ = false;
      return refuted(unstable->tree, "no motion satisfies all conditions");
    }
    return {"undecided", in_words(std::get<Undecided>(verdict))};
  }

  void note_friction(const Witness& witness) {
    for (std::size_t i = 0; i < problem_.size() && !rubbing_; ++i) {
      const ContactForce& f = witness.forces[i];
      if (f.tangential.is_zero()) continue;
      rubbing_ = Rubbing{i, abs(f.tangential) / f.normal,
                         !power(problem_.rows()[i].tangent, witness.twist).is_zero()};
    }
  }

  MethodAnswer frictionless() {
    return balance_answer(frictionless_stable_load(problem_),
                          "normal forces alone balance the load",
                          "without friction no contact opposes the load along ", true);
  }

  MethodAnswer weak() {
    const LoadClass result = weakly_stable_load(problem_);
    const auto* found = std::get_if<RigidForces>(&result);
    weakly_stable_ = found != nullptr;
    return balance_answer(
        result,
        found == nullptr ? "" : some_forces(planar_forces(*found)) + " would balance the load",
        "no force in the cones opposes the load along ", false);
  }

  MethodAnswer balance_answer(const LoadClass& result, const std::string& balanced,
                              const std::string& unopposed, bool without_friction) {
    if (const auto* found = std::get_if<RigidForces>(&result)) {
      return of_load(true, balanced + unless_passive(),
                     {{"forces", forces_json(planar_forces(*found))}});
    }
    const RationalRow& d = std::get<UnopposedMotion>(result).twist;
    std::string why = unopposed + text_.direction(d);
    if (without_friction && rubbing_) {
      why += "; passively " + contact_name(rubbing_->contact) + " holds by friction, " +
             text_(rubbing_->ratio) + " of its normal force";
    }
    return of_load(false, std::move(why), {{"motion", number_json(d)}});
  }

  MethodAnswer strong() {
    const auto result = strong_class();
    if (const auto* limit = std::get_if<Undecided>(&result)) return given_up(*limit);
    strongly_stable_ = std::holds_alternative<StronglyStable>(result);
    if (const auto* found = std::get_if<StronglyStable>(&result)) {
      return of_load(
          true,
          "rigid contacts leave no acceleration " + leaves_refuted(found->cases()) +
              unless_passive(),
          {{"forces", forces_json(planar_forces(found->rest))}, {"cases", found->cases()}});
    }
    const auto& a = std::get<Acceleration>(result);
    const bool is_preloaded =
        std::any_of(problem_.rows().begin(), problem_.rows().end(),
                    [](const ContactRow& row) { return !row.preload.is_zero(); });
    return of_load(
        false,
        std::string("rigid contacts ") +
            (passive_stable_ == true && is_preloaded ? "know no preload: they " : "") +
            "allow the acceleration " + text_(a.acceleration) + " with " +
            some_forces(planar_forces(a.forces)),
        {{"acceleration", number_json(a.acceleration)},
         {"forces", forces_json(planar_forces(a.forces))}});
  }

  /// Returns strong stability from the known rigid verdict, if that tells; else decides it.
  std::variant<StronglyStable, Acceleration, Undecided> strong_class() const {
    if (options_.verdict != nullptr) {
      if (const auto* stable = std::get_if<StronglyStable>(options_.verdict)) return *stable;
      if (const auto* open = std::get_if<OpenLoad>(options_.verdict)) return open->motion;
    }
    return strongly_stable_load(problem_, options_.inertia);
  }

  /// Returns the answer about a wrench space; it is not computed for many contacts, or if a
  /// normal has an irrational length.
  MethodAnswer wrench_space(ForceBound bound) {
    if (problem_.size() > kMostContactsForWrenchSpace) {
      const std::string limit = std::to_string(kMostContactsForWrenchSpace) + " contacts";
      return {kNotComputed, "there are more than " + limit, {{"limit", limit}}};
    }
    std::vector<HalfSpace> facets;
    try {
      facets = wrench_space_facets(problem_, bound, options_.length);
    } catch (const InputError& error) {
      return not_for(error);
    }
    const auto [radius_squared, nearest] = ferrari_canny_quality(facets);
    const std::optional<Rational> radius = exact_sqrt(radius_squared);
    Json evidence{
        {"radius_squared", number_json(radius_squared)},
        {"radius",
         radius ? number_json(*radius) : number_json(enclose_sqrt(1, radius_squared))},
        {"facet",
         {{"normal", number_json(nearest.normal)}, {"offset", number_json(nearest.offset)}}},
        {"facets", facets.size()}};
    if (bound == ForceBound::kL1) {
      Json& slice = evidence["zero_torque_slice"] = Json::array();
      for (const Vector2& vertex : zero_torque_slice(problem_)) {
        slice.push_back(number_json(vertex));
      }
    }
    if (radius_squared.is_zero()) {
      return {"not closed",
              "no force closure, quality 0: no wrench x with " +
                  text_.direction(nearest.normal) + ".x > 0 can be applied",
              std::move(evidence)};
    }
    return {"closed",
            "force closure: the largest ball has radius " + text_.root(1, radius_squared) +
                ", at the facet " + text_(nearest.normal) + ".x <= " + text_(nearest.offset),
            std::move(evidence)};
  }

  MethodAnswer linear() {
    const auto result = linear_compliance(problem_);
    if (const auto* motion = std::get_if<UnresistedMotion>(&result)) {
      return unresisted_answer(*motion, text_);
    }
    const auto& [springs, outside] = std::get<SpringBalance>(result);
    Json evidence = witness_json(springs);
    evidence["outside"] = outside ? Json(outside->index()) : Json(nullptr);
    return of_load(!outside,
                   outside
                       ? leaves_cone(*outside, springs)
                       : "linear springs balance the load within the cones" + however(springs),
                   std::move(evidence));
  }

  std::string leaves_cone(ContactId contact, const Witness& springs) const {
    const ContactRow& row = problem_.row(contact);
    const ContactForce& f = springs.forces[contact.index()];
    const std::string here = contact_name(contact.index());
    if (f.normal.sign() < 0) {
      return "a linear spring would pull at " + here + ", with the force " +
             text_(vector_of(contact.index(), f));
    }
    const std::string beyond = ", beyond mu = " + text_(row.friction);
    if (f.normal.is_zero()) {
      return "linear springs put friction without a normal force on " + here + beyond;
    }
    return "linear springs put friction of " + text_(Rational(abs(f.tangential) / f.normal)) +
           " of the normal force on " + here + beyond;
  }

  MethodAnswer three_states() {
    const auto result = three_state_compliance(problem_);
    if (const auto* limit = std::get_if<Undecided>(&result)) return given_up(*limit);
    if (const auto* found = std::get_if<SpringStates>(&result)) {
      constexpr const char* kNames[] = {"stick", "slip", "detached"};
      std::string list;
      Json evidence{{"states", Json::array()}};
      for (const SpringState state : found->states) {
        const char* name = kNames[static_cast<std::size_t>(state)];
        evidence["states"].push_back(name);
        list += (list.empty() ? "" : ", ") + std::string(name);
      }
      evidence.update(witness_json(found->springs));
      return of_load(true,
                     (list.empty() ? "there is nothing to hold"
                                   : "springs balance the load with the contacts in " + list) +
                         however(found->springs),
                     std::move(evidence));
    }
    const std::size_t count = std::get<NoSpringStates>(result).combinations;
    std::string why = "none of the " + std::to_string(count) +
                      " combinations of stick, slip and detached is lawful";
    if (rubbing_) {
      why += "; passively " + contact_name(rubbing_->contact) +
             (rubbing_->slips ? " slips against friction of " : " sticks with friction of ") +
             text_(rubbing_->ratio) + " of its normal force, " +
             (rubbing_->slips ? "not none" : "not that of a tangential spring");
    }
    return of_load(false, std::move(why), {{"combinations", count}});
  }

  MethodAnswer cones() {
    const ConesVerdict result = friction_cones_alone(problem_);
    if (const auto* limit = std::get_if<Undecided>(&result)) return given_up(*limit);
    if (const auto* witness = std::get_if<Witness>(&result)) {
      return of_load(true,
                     "the motion " + text_(witness->twist) + " loads the contacts enough" +
                         however(*witness),
                     witness_json(*witness));
    }
    return refuted(std::get<Trees>(result), "no motion loads the contacts enough");
  }

  /// Returns an addition for methods that find forces and ask nothing of motions.
  std::string unless_passive() const {
    if (passive_stable_ != false) return "";
    return std::string(", but no motion ") + (bounded_ != nullptr ? "within the bound " : "") +
           "gives rise to such forces";
  }

  /// Returns an addition for methods that find a motion, if the passive model has none.
  std::string however(const Witness& witness) const {
    if (passive_stable_ != false) return "";
    const Vector3 motion = coordinates(witness.twist);
    if (bounded_ != nullptr && !bounded_->allows({motion.begin(), motion.end()})) {
      return kBeyondBound;
    }
    const std::string breach = dissipation_breach(witness);
    if (!breach.empty()) return ", but this " + breach;
    // The motion may break only the bilateral law, with a spring that is released.
    const std::optional<std::string> violation = find_violation(problem_, witness);
    return violation ? ", but " + *violation : "";
  }

  /// Returns how motion and forces break maximum dissipation at the first contact where they
  /// do: "lets contact 0 slip without friction, though mu = 1/2". Empty if they do nowhere.
  std::string dissipation_breach(const Witness& witness) const {
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const ContactRow& row = problem_.rows()[i];
      const ContactForce& f = witness.forces[i];
      const Rational slip = power(row.tangent, witness.twist);
      if (slip.is_zero() || f.normal.is_zero()) continue;
      const Rational against = Rational(-slip.sign()) * f.tangential / f.normal;
      if (against == row.friction) continue;
      const std::string slips = "lets " + contact_name(i) + " slip ";
      const std::string mu = "mu = " + text_(row.friction);
      if (against.is_zero()) return slips + "without friction, though " + mu;
      if (against.sign() > 0) {
        return slips + "against friction of only " + text_(against) +
               " of the normal force, not " + mu;
      }
      return slips + "with friction pushing along, by " + text_(Rational(-against)) +
             " of the normal force";
    }
    return "";
  }

  Vector2 vector_of(std::size_t contact, const ContactForce& f) const {
    const Wrench& normal = problem_.rows()[contact].normal;
    return force_vector({normal.x, normal.y}, f);
  }

  Json forces_json(const std::vector<ContactForce>& forces) const {
    Json json = Json::array();
    for (std::size_t i = 0; i < forces.size(); ++i) {
      json.push_back(number_json(vector_of(i, forces[i])));
    }
    return json;
  }

  Json witness_json(const Witness& witness) const {
    return {{"twist", number_json(coordinates(witness.twist))},
            {"forces", forces_json(witness.forces)}};
  }

  /// Returns "the forces (1, -1/2) at contact 0 and (1, 1/2) at contact 2": two of them, and
  /// how many more.
  std::string some_forces(const std::vector<ContactForce>& forces) const {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const Vector2 f = vector_of(i, forces[i]);
      if (!(f == Vector2{})) parts.push_back(text_(f) + " at " + contact_name(i));
    }
    if (parts.empty()) return "no forces at all";
    if (parts.size() == 1) return "the force " + parts[0];
    if (parts.size() == 2) return "the forces " + parts[0] + " and " + parts[1];
    return "the forces " + parts[0] + ", " + parts[1] + " and " +
           std::to_string(parts.size() - 2) + " more";
  }

  const Problem& problem_;
  const AnyGrasp& grasp_;
  const GraspBox* bounded_;  ///< set if motions are bounded
  const CompareOptions& options_;
  NumberText& text_;
  std::optional<bool> passive_stable_;   ///< set if it was asked and said so
  std::optional<bool> weakly_stable_;    ///< set likewise
  std::optional<bool> strongly_stable_;  ///< set likewise
  std::optional<Rubbing> rubbing_;
};

}  // namespace

Comparison earlier_detail::compare_in_plane(const Problem& problem, const AnyGrasp& grasp,
                                            const CompareOptions& options, NumberText& text) {
  return MethodsAsked(problem, grasp, options, text).ask();
}

}  // namespace stickslip
