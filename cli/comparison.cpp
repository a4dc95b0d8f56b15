// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison.hpp"

#include <algorithm>

#include "comparison_text.hpp"
#include "stickslip/earlier/compliance.hpp"
#include "stickslip/earlier/friction_cones.hpp"
#include "stickslip/earlier/load_classes.hpp"
#include "stickslip/equilibrium/decide.hpp"

namespace stickslip {
namespace {

/// The first contact with friction in a passive equilibrium.
struct Rubbing {
  std::size_t contact;
  Rational ratio;  ///< |c_t| / c_n
  bool slips;
};

class Comparison {
 public:
  Comparison(const Question& question, const Rational& length, NumberText& text)
      : problem_(question.loaded, question.law), length_(length), text_(text) {}

  std::vector<MethodRow> rows() {
    passive();
    rows_.push_back(form_closure_row(problem_, text_));
    frictionless();
    strong();
    weak();
    rows_.push_back(wrench_space_row(problem_, ForceBound::kL1, length_, text_));
    rows_.push_back(wrench_space_row(problem_, ForceBound::kLinf, length_, text_));
    linear();
    three_states();
    cones();
    return std::move(rows_);
  }

 private:
  void add(const char* method, const char* source, bool accepts, std::string why,
           Json evidence) {
    rows_.push_back(
        {method, source, accepts ? "stable" : "unstable",
         passive_undecided_ ? std::nullopt : std::optional<bool>(accepts == passive_stable_),
         true, std::move(why), std::move(evidence)});
  }
  void add_undecided(const char* method, const char* source, const std::string& limit) {
    rows_.push_back({method,
                     source,
                     kNotComputed,
                     std::nullopt,
                     true,
                     "given up at " + limit,
                     {{"limit", limit}}});
  }

  void passive() {
    const Decision decision = decide(problem_);
    const Verdict& verdict = decision.verdict;
    MethodRow row{
        "passive equilibrium", "Haas-Heger et al. 2018", name_of(verdict), {}, true, "", {}};
    if (const auto* stable = std::get_if<Stable>(&verdict)) {
      passive_stable_ = true;
      note_friction(stable->witness);
      row.why =
          "the motion " + text_(stable->witness.twist) + " gives rise to forces that hold";
      row.evidence = witness_json(problem_, stable->witness);
    } else if (const auto* unstable = std::get_if<Unstable>(&verdict)) {
      row.why = "no motion satisfies all conditions " +
                cases_refuted(summarize(unstable->refutation).leaves);
      row.evidence = refutation_json(unstable->refutation);
    } else {
      passive_undecided_ = true;
      row.why = "given up at " + std::get<Undecided>(verdict).limit;
    }
    rows_.push_back(std::move(row));
  }

  void note_friction(const Witness& witness) {
    for (std::size_t i = 0; i < problem_.size() && !rubbing_; ++i) {
      const ContactForce& f = witness.forces[i];
      if (f.tangential.is_zero()) continue;
      rubbing_ = Rubbing{i, abs(f.tangential) / f.normal,
                         !power(problem_.rows()[i].tangent, witness.twist).is_zero()};
    }
  }

  std::string friction_that_holds() const {
    if (!rubbing_) return "";
    return "; passively " + contact_name(rubbing_->contact) + " holds by friction, " +
           text_(rubbing_->ratio) + " of its normal force";
  }

  void frictionless() {
    const char* const method = "frictionless stable load";
    const LoadClass result = frictionless_stable_load(problem_);
    if (const auto* found = std::get_if<BalancingForces>(&result)) {
      add(method, kPangTrinkle, true, "normal forces alone balance the load" + unless_passive(),
          {{"forces", forces_json(problem_, found->forces)}});
      return;
    }
    const Twist& d = std::get<UnopposedMotion>(result).twist;
    add(method, kPangTrinkle, false,
        "without friction no contact opposes the load along " + text_.direction(d) +
            (passive_stable_ ? friction_that_holds() : ""),
        motion_json(d));
  }

  void strong() {
    const char* const method = "strongly stable load";
    const auto result = strongly_stable_load(problem_, {{0, 0}, length_ * length_});
    if (const auto* limit = std::get_if<Undecided>(&result)) {
      add_undecided(method, kPangTrinkle, limit->limit);
    } else if (const auto* found = std::get_if<StronglyStable>(&result)) {
      add(method, kPangTrinkle, true,
          "rigid contacts leave no acceleration " + cases_refuted(found->cases) +
              unless_passive(),
          {{"forces", forces_json(problem_, found->equilibrium.forces)},
           {"cases", found->cases}});
    } else {
      const auto& a = std::get<Acceleration>(result);
      add(method, kPangTrinkle, false,
          std::string("rigid contacts ") +
              (passive_stable_ && is_preloaded() ? "know no preload: they " : "") +
              "allow the acceleration " + text_(a.acceleration) + " with " +
              some_forces(problem_, a.forces, text_),
          {{"acceleration", number_json(coordinates(a.acceleration))},
           {"forces", forces_json(problem_, a.forces)}});
    }
  }

  bool is_preloaded() const {
    return std::any_of(problem_.rows().begin(), problem_.rows().end(),
                       [](const ContactRow& row) { return !row.preload.is_zero(); });
  }

  void weak() {
    const char* const method = "weakly stable load";
    const LoadClass result = weakly_stable_load(problem_);
    if (const auto* found = std::get_if<BalancingForces>(&result)) {
      add(method, kPangTrinkle, true,
          some_forces(problem_, found->forces, text_) + " would balance the load" +
              unless_passive(),
          {{"forces", forces_json(problem_, found->forces)}});
      return;
    }
    const Twist& d = std::get<UnopposedMotion>(result).twist;
    add(method, kPangTrinkle, false,
        "no force in the cones opposes the load along " + text_.direction(d), motion_json(d));
  }

  /// For methods that find forces and ask nothing of motions.
  std::string unless_passive() const {
    return passive_stable_ || passive_undecided_ ? ""
                                                 : ", but no motion gives rise to such forces";
  }

  void linear() {
    const char* const method = "linear compliance";
    const char* const source = "Cutkosky and Kao 1989, Bicchi 1993";
    const auto result = linear_compliance(problem_);
    if (const auto* motion = std::get_if<UnresistedMotion>(&result)) {
      add(method, source, false,
          "no spring resists the motion " + text_.direction(motion->twist) +
              ", along which the load does work",
          motion_json(motion->twist));
      return;
    }
    const auto& found = std::get<SpringBalance>(result);
    Json evidence = witness_json(problem_, found.springs);
    evidence["outside"] = found.outside ? Json(found.outside->index()) : Json(nullptr);
    add(method, source, !found.outside,
        found.outside
            ? leaves_cone(*found.outside, found.springs)
            : "linear springs balance the load within the cones" + however(found.springs),
        std::move(evidence));
  }

  std::string leaves_cone(ContactId contact, const Witness& springs) const {
    const ContactRow& row = problem_.row(contact);
    const ContactForce& f = springs.forces[contact.index()];
    const std::string here = contact_name(contact.index());
    if (f.normal.sign() < 0) {
      return "a linear spring would pull at " + here + ", with the force " +
             text_(vector_of(row, f));
    }
    const std::string beyond = ", beyond mu = " + text_(row.friction);
    if (f.normal.is_zero()) {
      return "linear springs put friction without a normal force on " + here + beyond;
    }
    return "linear springs put friction of " + text_(Rational(abs(f.tangential) / f.normal)) +
           " of the normal force on " + here + beyond;
  }

  /// For methods that find a motion, when the passive model has none.
  std::string however(const Witness& witness) const {
    if (passive_stable_ || passive_undecided_) return "";
    const std::string breach = dissipation_breach(problem_, witness, text_);
    if (!breach.empty()) return ", but this " + breach;
    // A released spring under the bilateral law.
    const std::optional<std::string> violation = find_violation(problem_, witness);
    return violation ? ", but " + *violation : "";
  }

  void three_states() {
    const char* const method = "three-state compliance";
    const char* const source = "Prattichizzo et al. 1997";
    const auto result = three_state_compliance(problem_);
    if (const auto* limit = std::get_if<Undecided>(&result)) {
      add_undecided(method, source, limit->limit);
    } else if (const auto* found = std::get_if<SpringStates>(&result)) {
      const char* const names[] = {"stick", "slip", "detached"};
      std::string list;
      Json states = Json::array();
      for (const SpringState state : found->states) {
        const char* name = names[static_cast<std::size_t>(state)];
        states.push_back(name);
        list += (list.empty() ? "" : ", ") + std::string(name);
      }
      Json evidence{{"states", states}};
      evidence.update(witness_json(problem_, found->springs));
      add(method, source, true,
          (list.empty() ? "there is nothing to hold"
                        : "springs balance the load with the contacts in " + list) +
              however(found->springs),
          std::move(evidence));
    } else {
      const std::size_t count = std::get<NoSpringStates>(result).combinations;
      std::string why = "none of the " + std::to_string(count) +
                        " combinations of stick, slip and detached is lawful";
      if (passive_stable_ && rubbing_) {
        why += "; passively " + contact_name(rubbing_->contact) +
               (rubbing_->slips ? " slips against friction of " : " sticks with friction of ") +
               text_(rubbing_->ratio) + " of its normal force, " +
               (rubbing_->slips ? "not none" : "not that of a tangential spring");
      }
      add(method, source, false, std::move(why), {{"combinations", count}});
    }
  }

  void cones() {
    const char* const method = "friction cones alone";
    const char* const source = "Haas-Heger et al. 2018, Eqs. 1-4";
    const ConesVerdict result = friction_cones_alone(problem_);
    if (const auto* limit = std::get_if<Undecided>(&result)) {
      add_undecided(method, source, limit->limit);
    } else if (const auto* witness = std::get_if<Witness>(&result)) {
      add(method, source, true,
          "the motion " + text_(witness->twist) + " loads the contacts enough" +
              however(*witness),
          witness_json(problem_, *witness));
    } else {
      const auto& tree = std::get<Refutation>(result);
      add(method, source, false,
          "no motion loads the contacts enough " + cases_refuted(summarize(tree).leaves),
          refutation_json(tree));
    }
  }

  static constexpr const char* kPangTrinkle = "Pang and Trinkle 2000";

  Problem problem_;
  Rational length_;
  NumberText& text_;
  bool passive_stable_ = false;
  bool passive_undecided_ = false;
  std::optional<Rubbing> rubbing_;
  std::vector<MethodRow> rows_;
};

}  // namespace

std::vector<MethodRow> compare_methods(const Question& question, const Rational& length,
                                       NumberText& text) {
  return Comparison(question, length, text).rows();
}

}  // namespace stickslip
