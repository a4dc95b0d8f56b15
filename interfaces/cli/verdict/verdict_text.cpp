// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>
#include <vector>

#include "box_numbers.hpp"
#include "stickslip/arrangement/contact_states.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/engine/refutation_summary.hpp"
#include "stickslip/engine/second_question.hpp"
#include "terminal.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

using Rows = std::vector<std::vector<std::string>>;

const char kForces[] =
    "These forces balance the load, lie in their friction cones and oppose slip; checked "
    "exactly.\n";

/// The text about an equilibrium, contact by contact if it is exact. It begins with the line
/// after the load's.
struct EquilibriumText {
  const Answer& answer;
  const Stable& stable;
  NumberText& text;

  std::string operator()(const Witness& witness) const {
    Rows rows{{"contact", "normal", "tangential", "force", "slip", ""}};
    for (const ContactReport& c : report_contacts(answer, witness)) {
      rows.push_back({std::to_string(rows.size() - 1),
                      text.root(c.force.normal, c.length_squared),
                      text.root(c.force.tangential, c.length_squared), text(c.vector),
                      std::string(1, to_char(c.mode.slip)), c.mode.closed ? "closed" : "open"});
    }
    return "  motion d  " + text(witness.twist) + "\n\n" + format_table(rows) + "\n";
  }
  std::string operator()(const ShareWitness& witness) const {
    const GraspBox& grasp = *answer.question.box();
    if (grasp.mechanism) {
      return "\n" + forces_text(grasp, witness) + "\n";
    }
    const std::vector<std::string> slips = slips_at(grasp, witness.twist);
    Rows rows{{"contact", "normal", "friction", "force", "slip", ""}};
    for (const SpatialForce& c : forces_of(grasp, witness.twist, witness.shares)) {
      const std::size_t i = rows.size() - 1;
      const RationalRow& n = grasp.contacts[i].normal;
      rows.push_back({std::to_string(i), text.root(c.normal, dot(n, n)),
                      text(vector_in(grasp, c.friction)), text(vector_in(grasp, c.force)),
                      slips[i], c.normal.sign() > 0 ? "closed" : "open"});
    }
    return "  motion d  " + text(witness.twist) + "\n\n" + format_table(rows) + "\n";
  }
  std::string operator()(const StabilityProof& /*proof*/) const {
    if (answer.question.mechanism() != nullptr) return "\n";  // states_text() has the motion
    return "  motion d  near " + text(stable.motion) + "\n\n";
  }

 private:
  /// Returns the forces of several bodies: by contact, with the bodies, and then by spring.
  /// Soft fingers also have the moment about the normal.
  std::string forces_text(const GraspBox& grasp, const ShareWitness& witness) const {
    Rows rows{{"contact", "of", "by", "normal", "force", "slip", ""}};
    const std::vector<std::string> slips = slips_at(grasp, witness.twist);
    const bool is_soft = has_torsion(grasp);
    if (is_soft) rows.front().insert(rows.front().end() - 2, "moment");
    for (const SpatialForce& c : forces_of(grasp, witness.twist, witness.shares)) {
      const std::size_t i = rows.size() - 1;
      const UncertainContact& contact = grasp.contacts[i];
      rows.push_back({std::to_string(i), grasp.mechanism->name_of(contact.of),
                      grasp.mechanism->name_of(contact.by),
                      text.root(c.normal, dot(contact.normal, contact.normal)),
                      text(vector_in(grasp, c.force)), slips[i],
                      c.normal.sign() > 0 ? "closed" : "open"});
      if (!is_soft) continue;
      const bool turns = !contact.torsion.is_zero();
      rows.back().insert(rows.back().end() - 2,
                         turns ? text.root(c.moment, dot(contact.normal, contact.normal)) : "");
    }
    std::string result = rows.size() > 1 ? format_table(rows) : "";
    Rows springs{{"spring", "force"}};
    const std::vector<Rational> forces = spring_forces_of(grasp, witness.twist);
    for (std::size_t j = 0; j < forces.size(); ++j) {
      const Spring& spring = grasp.springs[j];
      springs.push_back({spring.name.empty() ? spring.place : spring.name, text(forces[j])});
    }
    if (springs.size() > 1) result += (result.empty() ? "" : "\n") + format_table(springs);
    return result;
  }
};

/// Returns the load and the state of several bodies, coordinate by coordinate, without those
/// that are 0 throughout.
std::string states_text(const Answer& answer, const Mechanism& mechanism, NumberText& text) {
  const WrenchBox load = answer.question.grasp.wrench();
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  const bool has_motion = stable != nullptr && !stable->motion.empty();
  const bool is_exact = has_motion && std::holds_alternative<ShareWitness>(stable->proof);
  Rows rows{{"coordinate", "load w"}};
  if (has_motion) rows.front().emplace_back(is_exact ? "motion z" : "motion z, near");
  for (std::size_t j = 0; j < load.size(); ++j) {
    const bool moves = has_motion && !stable->motion[j].is_zero();
    if (load[j] == Interval{} && !moves) continue;
    rows.push_back({mechanism.coordinate_name(j),
                    load[j].is_point()
                        ? text(load[j].low)
                        : "[" + text(load[j].low) + ", " + text(load[j].high) + "]"});
    if (has_motion) rows.back().push_back(text(stable->motion[j]));
  }
  if (rows.size() == 1) return "  no load" + std::string(has_motion ? ", no motion\n" : "\n");
  return format_table(rows);
}

std::string leaves_text(std::size_t leaves) {
  return "Proved by a tree of " + std::to_string(leaves) + (leaves == 1 ? " leaf" : " leaves");
}

/// Returns why one grasp in the plane is unstable.
std::string refutation_text(const RefutationSummary& summary, NumberText& text) {
  if (summary.leaves == 0) return "The normal law allows no motion at all.\n";
  // The load does negative work on a leaf's own twist, so the contacts lose the opposite way.
  const std::string twist = text.direction(negated(summary.largest_leaf_twist));
  if (summary.largest_leaf.empty()) {
    return "Whatever the contacts do: along the virtual twist " + twist +
           "\nthe load does more work than they can take up.\n";
  }
  std::string result = "No motion and forces satisfy all conditions. " +
                       leaves_text(summary.leaves) +
                       ", which\ntogether cover all motions: in each, along some virtual "
                       "twist, the load does more\nwork than the contacts can take up. The "
                       "largest leaf:\n";
  for (const std::string& condition : summary.largest_leaf) result += "  " + condition + "\n";
  return result + "  twist " + twist + "\n\n";
}

/// The meaning of the verdict, and how it is proved.
struct Meaning {
  const Answer& answer;
  bool is_wide;  ///< whether some number is an interval
  NumberText& text;
  const std::string& examples;

  std::string operator()(const Stable& stable) const {
    const auto* proof = std::get_if<StabilityProof>(&stable.proof);
    if (proof == nullptr) return kForces;
    const std::size_t parts = part_count(*proof);
    return (is_wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                    : std::string("The grasp holds the load. Proved")) +
           (parts == 1 ? "" : ", in " + std::to_string(parts) + " parts") +
           (are_at_rest(*proof)
                ? ": nothing moves,\nas friction answers whatever load is left.\n"
            : are_sticking(*proof)
                ? ": contacts stick\nnear this motion, and friction has more to spare than "
                  "what is off takes away.\n"
            : are_untouched(*proof)
                ? ": near this motion\nnothing touches it, and there is no load.\n"
                : ": the forces on the walls\naround motions near this one leave no way out "
                  "but an equilibrium inside.\n") +
           exact_forces_text();
  }
  std::string operator()(const Unstable& unstable) const {
    if (answer.problem) {
      return refutation_text(summarize(unstable.tree, &*answer.problem), text);
    }
    const std::size_t leaves = leaf_count(unstable.tree);
    return std::string(is_wide ? "No grasp in the box holds the load: no"
                               : "The grasp does not hold the load: no") +
           " motion and forces satisfy all conditions.\n" +
           (leaves == 1
                ? "Whatever the contacts do, along some virtual twist the load does more work "
                  "than they\ncan take up.\n"
                : leaves_text(leaves) +
                      ", which together cover all motions: in each, along "
                      "some\nvirtual twist, the load does more work than "
                      "the contacts can take up.\n");
  }
  std::string operator()(const Fragile& fragile) const {
    Rows rows{{"differs", "stable", "unstable"}};
    for (const Difference& d :
         differences(*answer.question.box(), fragile.stable, fragile.unstable)) {
      rows.push_back({d.number.label(), text(d.stable), text(d.unstable)});
    }
    return "Some grasps in the box hold the load and some do not. Two of them, what differs "
           "most first:\n\n" +
           short_table(rows) + "\n" +
           (examples.empty()
                ? "--examples DIR writes both, each with a certificate of its verdict.\n"
                : "Both are in " + examples + ", each with a certificate of its verdict.\n");
  }
  std::string operator()(const Undecided& undecided) const {
    return undecided_text(undecided, is_wide);
  }

 private:
  /// Returns how to have the exact forces of one grasp in the plane.
  std::string exact_forces_text() const {
    const Question& question = answer.question;
    if (simplest(*question.box(), question.preload_growth).box() != nullptr) return "";
    return "Exact forces would have numbers of many digits: --engine branch-and-bound finds "
           "them, and\nthe warnings that need them.\n";
  }
};

const std::string kNatural = "within " + std::to_string(kFarMotion) +
                             " times what the load would press the softest contact, ";

/// Returns the largest rotation of a motion, or the largest translation if it hardly turns.
std::string size_text(const GraspBox& box, const RationalRow& motion) {
  const std::size_t half = box.in_space() ? 3 : 2;
  Rational turn = 0;
  Rational move = 0;
  for (std::size_t j = 0; j < motion.size(); ++j) {
    Rational& most = !box.mechanism && j >= half ? turn : move;
    most = std::max<Rational>(most, abs(motion[j]));
  }
  const bool turns = turn > box.max_motion.back();
  const double size = to_double(turns ? turn : move);
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.2g", size);
  return digits + std::string(turns ? " rad" : "");
}

/// Returns the part of the heading that is about the second answer.
std::string second_heading(const Answer& answer) {
  if (!answer.within) return "";
  const Answer& within = *answer.within;
  const std::string verdict =
      std::string(name_of(within.verdict)) + (is_stable(within.verdict) ? " (proved)" : "");
  if (!within.question.is_bounded()) {
    char size[32];
    std::snprintf(size, sizeof size, "%.2g",
                  std::sqrt(to_double(squared_distance(answer.question, within.question))));
    return ", but only for a part of the load of " + std::string(size) +
           ", which no contact opposes;\nwithout it, " + verdict;
  }
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  if (stable == nullptr) return "; " + kNatural + verdict;
  RationalRow motion = stable->motion;
  if (const auto* witness = std::get_if<Witness>(&stable->proof)) {
    const auto all = coordinates(witness->twist);
    motion.assign(all.begin(), all.end());
  }
  return ", but only by motions of " + size_text(*within.question.box(), motion) + ";\n" +
         kNatural + verdict;
}

/// Returns how to ask for the second answer and its proof.
std::string second_text(const Answer& answer) {
  if (!answer.within) return "";
  const Answer& within = *answer.within;
  if (within.question.is_bounded()) {
    return "The second answer, with its proof: --max-motion " +
           bound_text(*within.question.box()) + " --certificate FILE.\n";
  }
  return "The load without that part is \"within\" in the answer with --json; it differs from "
         "the one asked\nabout as two doubles do that are next to each other.\n";
}

/// Returns a share in percent, with the digits that matter.
std::string percent(const Rational& share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g %%", 100 * to_double(share));
  return text;
}

/// Returns what samples of a box say.
std::string samples_text(const Samples* samples) {
  if (samples == nullptr) return "";
  const std::size_t n = samples->count();
  if (n == 0) return "Samples: none was decided.\n";
  const auto counted = [](std::size_t count, const char* what) {
    return std::to_string(count) + " " + what;
  };
  const StableShare share = stable_share(*samples);
  return "\nSamples: " + counted(n, n == 1 ? "grasp" : "grasps") +
         " drawn from the box, each number uniform in its interval (seed " +
         std::to_string(samples->seed) + "),\neach decided, with a proof that was checked: " +
         counted(samples->stable, "stable") + ", " + counted(samples->unstable, "unstable") +
         (samples->undecided == 0 ? "" : ", " + counted(samples->undecided, "undecided")) +
         ".\nWith a confidence of 95 % between " + percent(share.low) + " and " +
         percent(share.high) +
         " of the grasps that are drawn so hold; of one side,\nat least " +
         percent(share.at_least) + ". A sample proves nothing about any other grasp.\n\n";
}

/// Returns the meaning of the numbers.
std::string legend(const Answer& answer) {
  if (answer.question.mechanism() != nullptr) {
    return "Load: a force or torque for each coordinate. Motion: of bodies that are no links "
           "x, "
           "y and rotation\nin radians; of joints their coordinate. What is left out is 0.\n";
  }
  if (answer.question.in_space()) {
    return "Load: force x, y, z, torque x, y, z. Motion: x, y, z, rotation x, y, z in "
           "radians.\n";
  }
  if (!answer.problem || !std::holds_alternative<Stable>(answer.verdict)) return "";
  return "Load: force x, y, torque. Motion: x, y, rotation in radians. Slip: + is along the "
         "normal turned\nby +90 degrees, - against it, 0 sticks. An open contact is "
         "detached.\n";
}

}  // namespace

void print_text(const Answer& answer, const Warnings& warnings, const NumberOptions& output,
                const std::string& examples, const Samples* samples) {
  const Question& question = answer.question;
  NumberText text(output);
  std::vector<UncertainNumber> uncertain;
  std::vector<std::size_t> enclosed;
  if (const GraspBox* box = question.box()) {
    uncertain = uncertain_numbers(*box);
    enclosed = enclosed_contacts(*box);
  }
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  std::cout << heading(question) << name_of(answer.verdict) << second_heading(answer) << "\n\n"
            << (question.mechanism() != nullptr
                    ? states_text(answer, *question.mechanism(), text)
                    : "  load w    " + load_text(question.grasp.wrench(), text) + "\n")
            << (stable == nullptr
                    ? "\n"
                    : std::visit(EquilibriumText{answer, *stable, text}, stable->proof))
            << (question.box() == nullptr ? ""
                                          : uncertain_text(*question.box(), uncertain, text))
            << motions_text(question)
            << std::visit(Meaning{answer, !uncertain.empty(), text, examples}, answer.verdict)
            << second_text(answer) << samples_text(samples)
            << enclosure_text(enclosed, answer.bits,
                              !std::holds_alternative<Undecided>(answer.verdict))
            << legend(answer) << text.note() << conventions_text(question)
            << engine_text(answer.engine(), question.law);
  print(warnings);
}

}  // namespace stickslip
