// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/earlier/comparison.hpp"

#include <algorithm>

#include "contact_forces.hpp"
#include "method_answer.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/grasp_wrench_space.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/decide_problem.hpp"

namespace stickslip {

using namespace earlier_detail;

namespace {

/// A grasp wrench space in the plane of more contacts than these is not computed.
constexpr std::size_t kMostContactsForWrenchSpace = 64;

/// The forces of contacts, with as many components as points have.
using Forces = std::vector<RationalRow>;

/// The first contact with friction in a passive equilibrium.
struct Rubbing {
  std::size_t contact;
  Rational ratio;  ///< |c_t| / c_n
  bool slips;
};

/// Springs in balance with the load, of linear compliance.
struct LinearSprings {
  RationalRow motion;
  Forces forces;
  std::optional<ContactId> outside;
  std::string however;  ///< what is to be said of them if the passive model refuses the load
};

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

Forces as_forces(const std::vector<Vector3>& vectors) {
  Forces forces;
  for (const Vector3& v : vectors) forces.emplace_back(v.begin(), v.end());
  return forces;
}

Json forces_json(const Forces& forces) {
  Json json = Json::array();
  for (const RationalRow& force : forces) json.push_back(number_json(force));
  return json;
}

Json equilibrium_json(const RationalRow& motion, const Forces& forces) {
  return {{"twist", number_json(motion)}, {"forces", forces_json(forces)}};
}

class MethodsAsked {
 public:
  /// Throws what problem_of() and point_in_space() do.
  MethodsAsked(const Question& question, const CompareOptions& options, NumberText& text)
      : grasp_(point_grasp(question)),
        law_(question.law),
        options_(options),
        text_(text),
        verdict_(options.verdict) {
    if (!question.in_space()) problem_ = problem_of(without_bound(question));
  }

  Comparison ask() {
    if (!problem_) check_in_space(options_.methods);
    Comparison result;
    result.methods = asked(problem_ ? all_methods() : methods_in_space(), options_,
                           [this](MethodId method) { return answer(method); });
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
          return closure_answer(problem_ ? form_closure(*problem_) : form_closure(grasp_),
                                text_);
        case MethodId::kFrictionless:
          return frictionless();
        case MethodId::kStronglyStable:
          return strong();
        case MethodId::kWeaklyStable:
          return weak();
        case MethodId::kWrenchSpaceL1:
          return problem_ ? wrench_space(ForceBound::kL1) : wrench_space();
        case MethodId::kWrenchSpaceLinf:
          return wrench_space(ForceBound::kLinf);
        case MethodId::kLinearCompliance:
          return linear();
        case MethodId::kThreeStates:
          return three_states();
        case MethodId::kContactRobustness:
        case MethodId::kGraspRobustness:
        case MethodId::kRigidMotionRobustness:
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

  /// Returns the verdict of the passive model. The engine for boxes knows bounds on motions.
  MethodAnswer passive() {
    const bool is_exact = problem_ && !grasp_.is_bounded();
    const Verdict verdict =
        is_exact ? decide(*problem_).verdict : decide_box(grasp_, law_).verdict;
    passive_stable_ = is_stable(verdict);
    if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
      const std::string why = "no motion" + within_bound() + " satisfies all conditions";
      if (is_exact) return refuted(unstable->tree, why);
      const std::size_t leaves = leaf_count(unstable->tree);
      return of_load(false, why + " " + leaves_refuted(leaves),
                     {{"refutation", {{"nodes", unstable->tree.size()}, {"leaves", leaves}}}});
    }
    const auto* stable = std::get_if<Stable>(&verdict);
    if (stable == nullptr) return {"undecided", in_words(std::get<Undecided>(verdict))};
    if (const auto* proof = std::get_if<StabilityProof>(&stable->proof)) {
      if (are_at_rest(*proof)) {
        return of_load(true, "nothing moves: friction at rest holds the load", Json::object());
      }
      return of_load(true, "there is an equilibrium near the motion " + text_(stable->motion),
                     {{"near", number_json(stable->motion)}});
    }
    RationalRow motion;
    Forces forces;
    if (is_exact) {
      note_friction(stable->witness());
      motion = row_of(stable->witness().twist);
      forces = vectors_of(stable->witness().forces);
    } else {
      const auto& witness = std::get<ShareWitness>(stable->proof);
      motion = witness.twist;
      for (const SpatialForce& f : forces_of(grasp_, witness.twist, witness.shares)) {
        forces.emplace_back(f.force.begin(), f.force.end());
      }
    }
    return of_load(true, "the motion " + text_(motion) + " gives rise to forces that hold",
                   equilibrium_json(motion, forces));
  }

  void note_friction(const Witness& witness) {
    for (std::size_t i = 0; i < problem_->size() && !rubbing_; ++i) {
      const ContactForce& f = witness.forces[i];
      if (f.tangential.is_zero()) continue;
      rubbing_ = Rubbing{i, abs(f.tangential) / f.normal,
                         !power(problem_->rows()[i].tangent, witness.twist).is_zero()};
    }
  }

  MethodAnswer frictionless() {
    GraspBox smooth = grasp_;
    for (UncertainContact& c : smooth.contacts) c.friction = {};
    const LoadClass found =
        problem_ ? frictionless_stable_load(*problem_) : weakly_stable_load(smooth);
    return load_answer(found, "normal forces alone balance the load",
                       "without friction no contact opposes the load along ",
                       rubbing_ ? "; passively " + contact_name(rubbing_->contact) +
                                      " holds by friction, " + text_(rubbing_->ratio) +
                                      " of its normal force"
                                : "");
  }

  MethodAnswer weak() {
    const LoadClass found = weak_class();
    const auto* forces = std::get_if<RigidForces>(&found);
    if (const auto* undecided = std::get_if<Undecided>(&found)) {
      class_undecided_ = *undecided;
    } else {
      weakly_stable_ = forces != nullptr;
    }
    return load_answer(found,
                       (problem_ && forces != nullptr ? some_forces(vectors_of(*forces))
                                                      : "forces in the cones") +
                           " would balance the load",
                       "no force in the cones opposes the load along ");
  }

  /// Returns weak stability from the known rigid verdict, if there is one; else decides it.
  LoadClass weak_class() const {
    if (verdict_ != nullptr) {
      if (const auto* motion = std::get_if<UnopposedMotion>(verdict_)) return *motion;
      if (const auto* stable = std::get_if<StronglyStable>(verdict_)) return stable->rest;
      if (const auto* open = std::get_if<OpenLoad>(verdict_)) return open->rest;
    }
    return problem_ ? weakly_stable_load(*problem_) : weakly_stable_load(grasp_);
  }

  MethodAnswer load_answer(const LoadClass& found, const std::string& balanced,
                           const std::string& unopposed, const std::string& note = "") {
    if (const auto* forces = std::get_if<RigidForces>(&found)) {
      return of_load(true, balanced + unless_passive(),
                     {{"forces", forces_json(vectors_of(*forces))}});
    }
    if (const auto* motion = std::get_if<UnopposedMotion>(&found)) {
      return of_load(false, unopposed + text_.direction(motion->twist) + note,
                     {{"motion", number_json(motion->twist)}});
    }
    return given_up(std::get<Undecided>(found));
  }

  MethodAnswer strong() {
    const auto found = problem_ ? strong_in_plane() : strong_in_space();
    if (const auto* undecided = std::get_if<Undecided>(&found)) return given_up(*undecided);
    strongly_stable_ = std::holds_alternative<StronglyStable>(found);
    if (const auto* stable = std::get_if<StronglyStable>(&found)) {
      return of_load(
          true,
          "rigid contacts leave no acceleration " + leaves_refuted(stable->cases()) +
              unless_passive(),
          {{"forces", forces_json(vectors_of(stable->rest))}, {"cases", stable->cases()}});
    }
    if (std::holds_alternative<UnopposedMotion>(found)) {
      return of_load(false, "the load is not weakly stable", Json::object());
    }
    const auto& [acceleration, rigid] = std::get<Acceleration>(found);
    const Forces forces = vectors_of(rigid);
    std::string why = "rigid contacts ";
    if (problem_ && passive_stable_ == true && is_preloaded()) why += "know no preload: they ";
    why += "allow the acceleration " + text_(acceleration);
    if (problem_) why += " with " + some_forces(forces);
    return of_load(
        false, std::move(why),
        {{"acceleration", number_json(acceleration)}, {"forces", forces_json(forces)}});
  }

  using StrongClass = std::variant<StronglyStable, Acceleration, UnopposedMotion, Undecided>;

  /// Returns strong stability from the known rigid verdict, if that tells; else decides it.
  StrongClass strong_in_plane() const {
    if (verdict_ != nullptr) {
      if (const auto* stable = std::get_if<StronglyStable>(verdict_)) return *stable;
      if (const auto* open = std::get_if<OpenLoad>(verdict_)) return open->motion;
    }
    return std::visit([](auto&& found) { return StrongClass(std::move(found)); },
                      strongly_stable_load(*problem_, options_.inertia));
  }

  /// Returns the same by the rigid verdict, which tells of weak stability, too.
  StrongClass strong_in_space() {
    if (verdict_ == nullptr) {
      verdict_ = &found_.emplace(rigid_verdict(grasp_, options_.inertia));
    }
    if (const auto* undecided = std::get_if<Undecided>(verdict_)) {
      class_undecided_ = *undecided;
      return *undecided;
    }
    if (const auto* stable = std::get_if<StronglyStable>(verdict_)) return *stable;
    const auto* open = std::get_if<OpenLoad>(verdict_);
    weakly_stable_ = open != nullptr;
    if (open != nullptr) return open->motion;
    return std::get<UnopposedMotion>(*verdict_);
  }

  bool is_preloaded() const {
    return std::any_of(grasp_.contacts.begin(), grasp_.contacts.end(),
                       [](const UncertainContact& c) { return !c.preload.low.is_zero(); });
  }

  /// Returns the answer about an exact wrench space, in the plane; it is not computed for many
  /// contacts.
  MethodAnswer wrench_space(ForceBound bound) {
    if (problem_->size() > kMostContactsForWrenchSpace) {
      const std::string limit = std::to_string(kMostContactsForWrenchSpace) + " contacts";
      return {kNotComputed, "there are more than " + limit, {{"limit", limit}}};
    }
    const std::vector<HalfSpace> facets =
        wrench_space_facets(*problem_, bound, options_.length);
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
      for (const Vector2& vertex : zero_torque_slice(*problem_)) {
        slice.push_back(number_json(vertex));
      }
    }
    if (radius_squared.is_zero()) {
      return not_closed(text_.direction(nearest.normal), std::move(evidence));
    }
    return {"closed",
            "force closure: the largest ball has radius " + text_.root(1, radius_squared) +
                ", at the facet " + text_(nearest.normal) + ".x <= " + text_(nearest.offset),
            std::move(evidence)};
  }

  /// Returns the answer about a wrench space in space, between polytopes.
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
      return not_closed(text_.direction(ball.direction), std::move(evidence));
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

  static MethodAnswer not_closed(const std::string& direction, Json evidence) {
    return {
        "not closed",
        "no force closure, quality 0: no wrench x with " + direction + ".x > 0 can be applied",
        std::move(evidence)};
  }

  MethodAnswer linear() {
    const auto found = linear_springs();
    if (const auto* motion = std::get_if<UnresistedMotion>(&found)) {
      return unresisted_answer(*motion, text_);
    }
    const auto& [motion, forces, outside, however] = std::get<LinearSprings>(found);
    Json evidence = equilibrium_json(motion, forces);
    evidence["outside"] = outside ? Json(outside->index()) : Json(nullptr);
    return of_load(!outside,
                   outside ? leaves_cone(outside->index(), forces[outside->index()])
                           : "linear springs balance the load within the cones" + however,
                   std::move(evidence));
  }

  std::variant<LinearSprings, UnresistedMotion> linear_springs() const {
    if (problem_) {
      const auto found = linear_compliance(*problem_);
      if (const auto* motion = std::get_if<UnresistedMotion>(&found)) return *motion;
      const auto& [springs, outside] = std::get<SpringBalance>(found);
      return LinearSprings{row_of(springs.twist), vectors_of(springs.forces), outside,
                           outside ? "" : however(springs)};
    }
    const auto found = linear_compliance(grasp_);
    if (const auto* motion = std::get_if<UnresistedMotion>(&found)) return *motion;
    const auto& springs = std::get<SpatialSpringBalance>(found);
    return LinearSprings{springs.motion, as_forces(springs.forces), springs.outside, ""};
  }

  std::string leaves_cone(std::size_t contact, const RationalRow& force) const {
    const UncertainContact& c = grasp_.contacts[contact];
    const Rational along = dot(force, c.normal);
    const std::string here = contact_name(contact);
    if (along.sign() < 0) {
      return "a linear spring would pull at " + here + ", with the force " + text_(force);
    }
    const std::string beyond = ", beyond mu = " + text_(c.friction.low);
    if (along.is_zero()) {
      return "linear springs put friction without a normal force on " + here + beyond;
    }
    // The ratio is |f_t|^2 / f_n^2.
    const Rational ratio = dot(force, force) * dot(c.normal, c.normal) / (along * along) - 1;
    return "linear springs put friction of " + text_.root(1, ratio) +
           " of the normal force on " + here + beyond;
  }

  MethodAnswer three_states() {
    const auto result = three_state_compliance(*problem_);
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
      evidence.update(
          equilibrium_json(row_of(found->springs.twist), vectors_of(found->springs.forces)));
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
    static const std::string kNone = "no motion loads the contacts enough";
    const auto found = [&](const RationalRow& motion, const Forces& forces,
                           const std::string& but) {
      return of_load(true, "the motion " + text_(motion) + " loads the contacts enough" + but,
                     equilibrium_json(motion, forces));
    };
    if (problem_) {
      const ConesVerdict result = friction_cones_alone(*problem_);
      if (const auto* limit = std::get_if<Undecided>(&result)) return given_up(*limit);
      if (const auto* tree = std::get_if<Trees>(&result)) return refuted(*tree, kNone);
      const auto& witness = std::get<Witness>(result);
      return found(row_of(witness.twist), vectors_of(witness.forces), however(witness));
    }
    const auto result = friction_cones_alone(grasp_, law_);
    if (const auto* undecided = std::get_if<Undecided>(&result)) return given_up(*undecided);
    if (const auto* none = std::get_if<NoSpatialCones>(&result)) {
      return of_load(false, kNone + " " + leaves_refuted(none->regions),
                     {{"refutation", {{"leaves", none->regions}}}});
    }
    const auto& [motion, forces] = std::get<SpatialConesWitness>(result);
    return found(motion, as_forces(forces),
                 passive_stable_ != false ? ""
                 : grasp_.allows(motion)  ? ", but friction does not oppose every slip"
                                          : kBeyondBound);
  }

  /// Returns an addition for methods that find forces and ask nothing of motions.
  std::string unless_passive() const {
    if (passive_stable_ != false) return "";
    return ", but no motion" + within_bound() + " gives rise to such forces";
  }

  std::string within_bound() const { return grasp_.is_bounded() ? " within the bound" : ""; }

  /// Returns an addition for methods in the plane that find a motion, if the passive model has
  /// none.
  std::string however(const Witness& witness) const {
    if (passive_stable_ != false) return "";
    if (!grasp_.allows(row_of(witness.twist))) return kBeyondBound;
    const std::string breach = dissipation_breach(witness);
    if (!breach.empty()) return ", but this " + breach;
    // The motion may break only the bilateral law, with a spring that is released.
    const std::optional<std::string> violation = find_violation(*problem_, witness);
    return violation ? ", but " + *violation : "";
  }

  /// Returns how motion and forces break maximum dissipation at the first contact where they
  /// do: "lets contact 0 slip without friction, though mu = 1/2". Empty if they do nowhere.
  std::string dissipation_breach(const Witness& witness) const {
    for (std::size_t i = 0; i < problem_->size(); ++i) {
      const ContactRow& row = problem_->rows()[i];
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

  Forces vectors_of(const std::vector<ContactForce>& forces) const {
    Forces vectors;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const Wrench& normal = problem_->rows()[i].normal;
      const Vector2 f = force_vector({normal.x, normal.y}, forces[i]);
      vectors.push_back({f.x, f.y});
    }
    return vectors;
  }

  Forces vectors_of(const RigidForces& forces) const {
    if (problem_) return vectors_of(planar_forces(forces));
    Forces vectors;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      RationalRow& force = vectors.emplace_back(forces[i].friction);
      for (std::size_t j = 0; j < force.size(); ++j) {
        force[j] += forces[i].normal * grasp_.contacts[i].normal[j];
      }
    }
    return vectors;
  }

  /// Returns "the forces (1, -1/2) at contact 0 and (1, 1/2) at contact 2": two of them, and
  /// how many more.
  std::string some_forces(const Forces& forces) const {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const RationalRow& f = forces[i];
      const bool acts =
          std::any_of(f.begin(), f.end(), [](const Rational& x) { return !x.is_zero(); });
      if (acts) parts.push_back(text_(f) + " at " + contact_name(i));
    }
    if (parts.empty()) return "no forces at all";
    if (parts.size() == 1) return "the force " + parts[0];
    if (parts.size() == 2) return "the forces " + parts[0] + " and " + parts[1];
    return "the forces " + parts[0] + ", " + parts[1] + " and " +
           std::to_string(parts.size() - 2) + " more";
  }

  GraspBox grasp_;
  std::optional<Problem> problem_{};  ///< the problem in the plane, without a bound of motions
  NormalLaw law_;
  const CompareOptions& options_;
  NumberText& text_;
  const RigidVerdict* verdict_;  ///< the verdict on the class, if it is known
  std::optional<RigidVerdict> found_;
  std::optional<bool> passive_stable_;   ///< set if it was asked and said so
  std::optional<bool> weakly_stable_;    ///< set likewise
  std::optional<bool> strongly_stable_;  ///< set likewise
  std::optional<Undecided> class_undecided_;
  std::optional<Rubbing> rubbing_;
};

}  // namespace

Comparison compare_methods(const Question& question, const CompareOptions& options,
                           NumberText& text) {
  check_options(question, options);
  return MethodsAsked(question, options, text).ask();
}

}  // namespace stickslip
