// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "method_answer.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"
#include "stickslip/engine/box_verdict.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

std::vector<Method> methods_in_space() {
  std::vector<Method> result;
  for (const Method& method : all_methods()) {
    if (method.in_space) result.push_back(method);
  }
  return result;
}

/// Throws InputError at the name of a method of the plane alone.
void check_in_space(const std::vector<std::string>& words) {
  for (const Method& method : all_methods()) {
    if (method.in_space || !method.is_among(words)) continue;
    std::string others;
    for (const Method& other : methods_in_space()) {
      others += (others.empty() ? "" : ", ") + other.word();
    }
    throw InputError("", "methods",
                     method.word() + " is done in the plane only, and the grasp is in space",
                     "in space there are " + others);
  }
}

Json forces_json(const std::vector<Vector3>& forces) {
  Json json = Json::array();
  for (const Vector3& force : forces) json.push_back(number_json(force));
  return json;
}

std::string within_bound(const GraspBox& grasp) {
  return grasp.is_bounded() ? " within the bound" : "";
}

class MethodsInSpace {
 public:
  MethodsInSpace(const GraspBox& grasp, NormalLaw law, const CompareOptions& options,
                 NumberText& text)
      : grasp_(grasp), law_(law), options_(options), text_(text), verdict_(options.verdict) {}

  Comparison ask() {
    check_in_space(options_.methods);
    Comparison result;
    result.methods =
        asked(methods_in_space(), options_, [this](MethodId method) { return answer(method); });
    result.load_class = class_of(weakly_stable_, strongly_stable_);
    result.undecided = class_undecided_;
    return result;
  }

 private:
  MethodAnswer answer(MethodId method) {
    try {
      switch (method) {
        case MethodId::kPassive:
          return passive();
        case MethodId::kFormClosure:
          return closure_answer(form_closure(grasp_), text_);
        case MethodId::kFrictionless:
          return frictionless();
        case MethodId::kStronglyStable:
          return strong();
        case MethodId::kWeaklyStable:
          return weak();
        case MethodId::kWrenchSpaceL1:
          return wrench_space();
        case MethodId::kLinearCompliance:
          return linear();
        case MethodId::kContactRobustness:
        case MethodId::kGraspRobustness:
          return robustness_answer(grasp_, method, options_, text_);
        case MethodId::kGraspMap:
          return grasp_map_answer(grasp_, options_.length, text_);
        case MethodId::kWrenchVolume:
          return wrench_volume_answer(grasp_, options_, text_);
        case MethodId::kLeastForce:
          return least_force_answer(grasp_, options_, text_);
        case MethodId::kInternalMargin:
          return internal_margin_answer(grasp_, options_, text_);
        case MethodId::kCentroid:
          return centroid_answer(grasp_, options_.inertia.centre, text_);
        default:
          return cones();
      }
    } catch (const InputError& error) {
      return not_for(error);  // a length that is irrational
    }
  }

  MethodAnswer passive() {
    MethodAnswer passive = passive_answer(grasp_, law_, text_);
    if (passive.verdict != "undecided") passive_stable_ = passive.verdict == "stable";
    return passive;
  }

  MethodAnswer frictionless() {
    GraspBox smooth = grasp_;
    for (UncertainContact& c : smooth.contacts) c.friction = {};
    return load_answer(weakly_stable_load(smooth), "normal forces alone balance the load",
                       "without friction no contact opposes the load along ");
  }

  MethodAnswer weak() {
    const LoadClass weak = weak_class();
    if (const auto* undecided = std::get_if<Undecided>(&weak)) {
      class_undecided_ = *undecided;
    } else {
      weakly_stable_ = std::holds_alternative<RigidForces>(weak);
    }
    return load_answer(weak, "forces in the cones would balance the load",
                       "no force in the cones opposes the load along ");
  }

  /// Returns weak stability from the known rigid verdict, if there is one; else decides it.
  LoadClass weak_class() const {
    if (verdict_ != nullptr) {
      if (const auto* motion = std::get_if<UnopposedMotion>(verdict_)) return *motion;
      if (const auto* stable = std::get_if<StronglyStable>(verdict_)) return stable->rest;
      if (const auto* open = std::get_if<OpenLoad>(verdict_)) return open->rest;
    }
    return weakly_stable_load(grasp_);
  }

  MethodAnswer load_answer(const LoadClass& found, const std::string& balanced,
                           const std::string& unopposed) {
    if (const auto* forces = std::get_if<RigidForces>(&found)) {
      return of_load(true, balanced + unless_passive(), {{"forces", rest_json(*forces)}});
    }
    if (const auto* motion = std::get_if<UnopposedMotion>(&found)) {
      return of_load(false, unopposed + text_.direction(motion->twist),
                     {{"motion", number_json(motion->twist)}});
    }
    return given_up(std::get<Undecided>(found));
  }

  MethodAnswer strong() {
    if (verdict_ == nullptr)
      verdict_ = &found_.emplace(rigid_verdict(grasp_, options_.inertia));
    if (const auto* undecided = std::get_if<Undecided>(verdict_)) {
      class_undecided_ = *undecided;
      return given_up(*undecided);
    }
    const auto* stable = std::get_if<StronglyStable>(verdict_);
    strongly_stable_ = stable != nullptr;
    if (stable != nullptr) {
      return of_load(true,
                     "rigid contacts leave no acceleration " + leaves_refuted(stable->cases()) +
                         unless_passive(),
                     {{"forces", rest_json(stable->rest)}, {"cases", stable->cases()}});
    }
    if (const auto* open = std::get_if<OpenLoad>(verdict_)) {
      weakly_stable_ = true;
      const auto& [acceleration, forces] = open->motion;
      return of_load(
          false, "rigid contacts allow the acceleration " + text_(acceleration),
          {{"acceleration", number_json(acceleration)}, {"forces", rest_json(forces)}});
    }
    weakly_stable_ = false;
    return of_load(false, "the load is not weakly stable", Json::object());
  }

  MethodAnswer wrench_space() {
    const WrenchBall ball = wrench_ball(grasp_, options_.length);
    Json evidence{{"low_squared", number_json(ball.low_squared)},
                  {"high_squared", number_json(ball.high_squared)},
                  {"low", number_json(enclose_sqrt(1, ball.low_squared))},
                  {"high", number_json(enclose_sqrt(1, ball.high_squared))},
                  {"direction", number_json(ball.direction)},
                  {"points", ball.points},
                  {"facets", ball.facets}};
    if (ball.high_squared.is_zero()) {
      return {"not closed",
              "no force closure, quality 0: no wrench x with " +
                  text_.direction(ball.direction) + ".x > 0 can be applied",
              std::move(evidence)};
    }
    const std::string bounds = "the largest ball has a radius from " +
                               text_.root(1, ball.low_squared) + " to " +
                               text_.root(1, ball.high_squared);
    if (ball.low_squared.is_zero()) {
      return {kNotComputed, bounds + ", which leaves force closure open", std::move(evidence)};
    }
    return {"closed",
            "force closure: " + bounds + ", by the hull of " + std::to_string(ball.points) +
                " forces on the cones",
            std::move(evidence)};
  }

  MethodAnswer linear() {
    const auto result = linear_compliance(grasp_);
    if (const auto* motion = std::get_if<UnresistedMotion>(&result)) {
      return unresisted_answer(*motion, text_);
    }
    const auto& found = std::get<SpatialSpringBalance>(result);
    Json evidence{{"twist", number_json(found.motion)},
                  {"forces", forces_json(found.forces)},
                  {"outside", found.outside ? Json(found.outside->index()) : Json(nullptr)}};
    return of_load(!found.outside,
                   found.outside ? leaves_cone(found.outside->index(), found)
                                 : "linear springs balance the load within the cones",
                   std::move(evidence));
  }

  std::string leaves_cone(std::size_t contact, const SpatialSpringBalance& found) const {
    const Vector3 n = vector3(grasp_.contacts[contact].normal);
    const Vector3& f = found.forces[contact];
    const Rational along = dot(f, n);
    const Rational square = dot(n, n);
    const std::string here = contact_name(contact);
    if (along.sign() < 0) {
      return "a linear spring would pull at " + here + ", with the force " + text_(f);
    }
    const std::string beyond = ", beyond mu = " + text_(grasp_.contacts[contact].friction.low);
    if (along.is_zero()) {
      return "linear springs put friction without a normal force on " + here + beyond;
    }
    // The ratio is |f_t|^2 / f_n^2.
    const Rational ratio = (dot(f, f) * square - along * along) / (along * along);
    return "linear springs put friction of " + text_.root(1, ratio) +
           " of the normal force on " + here + beyond;
  }

  MethodAnswer cones() {
    const auto result = friction_cones_alone(grasp_, law_);
    if (const auto* undecided = std::get_if<Undecided>(&result)) return given_up(*undecided);
    if (const auto* none = std::get_if<NoSpatialCones>(&result)) {
      return of_load(false,
                     "no motion loads the contacts enough " + leaves_refuted(none->regions),
                     {{"refutation", {{"leaves", none->regions}}}});
    }
    const auto& found = std::get<SpatialConesWitness>(result);
    return of_load(
        true,
        "the motion " + text_(found.motion) + " loads the contacts enough" +
            (passive_stable_ != false      ? ""
             : grasp_.allows(found.motion) ? ", but friction does not oppose every slip"
                                           : kBeyondBound),
        {{"twist", number_json(found.motion)}, {"forces", forces_json(found.forces)}});
  }

  /// Returns an addition for methods that find forces and ask nothing of motions.
  std::string unless_passive() const {
    if (passive_stable_ != false) return "";
    return ", but no motion" + within_bound(grasp_) + " gives rise to such forces";
  }

  Json rest_json(const RigidForces& forces) const {
    std::vector<Vector3> vectors;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      Vector3& force = vectors.emplace_back(vector3(forces[i].friction));
      for (std::size_t j = 0; j < 3; ++j) {
        force[j] += forces[i].normal * grasp_.contacts[i].normal[j];
      }
    }
    return forces_json(vectors);
  }

  const GraspBox& grasp_;
  NormalLaw law_;
  const CompareOptions& options_;
  NumberText& text_;
  const RigidVerdict* verdict_;
  std::optional<RigidVerdict> found_;
  std::optional<bool> passive_stable_;   ///< set if it was asked and said so
  std::optional<bool> weakly_stable_;    ///< set likewise
  std::optional<bool> strongly_stable_;  ///< set likewise
  std::optional<Undecided> class_undecided_;
};

}  // namespace

MethodAnswer earlier_detail::passive_answer(const GraspBox& grasp, NormalLaw law,
                                            NumberText& text) {
  const Verdict verdict = decide_box(grasp, law).verdict;
  if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
    return of_load(
        false,
        "no motion" + within_bound(grasp) + " satisfies all conditions " +
            leaves_refuted(leaf_count(unstable->tree)),
        {{"refutation",
          {{"nodes", unstable->tree.size()}, {"leaves", leaf_count(unstable->tree)}}}});
  }
  const auto* stable = std::get_if<Stable>(&verdict);
  if (stable == nullptr) return {"undecided", in_words(std::get<Undecided>(verdict))};
  if (const auto* witness = std::get_if<ShareWitness>(&stable->proof)) {
    std::vector<Vector3> forces;
    for (const SpatialForce& f : forces_of(grasp, witness->twist, witness->shares)) {
      forces.push_back(f.force);
    }
    return of_load(true,
                   "the motion " + text(witness->twist) + " gives rise to forces that hold",
                   {{"twist", number_json(witness->twist)}, {"forces", forces_json(forces)}});
  }
  if (are_at_rest(std::get<StabilityProof>(stable->proof))) {
    return of_load(true, "nothing moves: friction at rest holds the load", Json::object());
  }
  return of_load(true, "there is an equilibrium near the motion " + text(stable->motion),
                 {{"near", number_json(stable->motion)}});
}

Comparison earlier_detail::compare_in_space(const GraspBox& grasp, NormalLaw law,
                                            const CompareOptions& options, NumberText& text) {
  return MethodsInSpace(grasp, law, options, text).ask();
}

}  // namespace stickslip
