// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/question.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// Returns the names of the coordinates, as "box.x, box.y, box.turn, joint 0".
std::string names_of(const Mechanism& mechanism) {
  std::string names;
  for (const std::string& name : coordinate_names(mechanism)) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

/// Throws InputError if the row is given and has not as many components as a wrench on the
/// grasp.
void check_size(const std::optional<RationalRow>& row, const char* place,
                const AnyGrasp& grasp) {
  const Mechanism* mechanism = grasp.mechanism();
  const std::size_t size = grasp.wrench().size();
  if (!row || row->size() == size) return;
  throw InputError(
      "", place, "it has " + std::to_string(row->size()) + " numbers",
      mechanism != nullptr ? "there are several bodies: give " + std::to_string(size) +
                                 ", a force or torque for each of " + names_of(*mechanism)
      : grasp.in_space() ? "the grasp is in space: give force x, y, z and torque x, y, z"
                         : "give force x, force y and torque, as 0,-11/10,0");
}

WrenchBox wrench_asked(const GraspFile& file, const QuestionOptions& options) {
  const std::optional<std::string>& name = options.case_name;
  check_size(options.wrench, "wrench", file.content);
  check_size(options.direction, "direction", file.content);
  if (options.wrench && name) {
    throw InputError("", "case", "a wrench is given as well", "give one of them");
  }
  if (options.wrench) {
    WrenchBox wrench;
    for (const Rational& component : *options.wrench) {
      wrench.push_back(point_interval(component));
    }
    return wrench;
  }
  if (!name && options.direction) return WrenchBox(options.direction->size());
  if (!name && file.cases.empty()) {
    return file.content.wrench();
  }
  std::vector<std::string> names;
  for (const NamedLoad& load : file.cases) names.push_back(load.name);
  return file.cases[case_named(names, name)].wrench;
}

bool all_zero(const std::vector<Rational>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](const Rational& value) { return value.is_zero(); });
}

bool is_certain(const WrenchBox& wrench) {
  return std::all_of(wrench.begin(), wrench.end(),
                     [](const Interval& w) { return w.is_point(); });
}

/// Returns whether some contact that has a preload, or whose preload grows, has a normal of
/// irrational length. `growth` is empty if no preload grows.
bool has_irrational_preload(const Grasp& grasp, const std::vector<Rational>& growth) {
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const Contact& c = grasp.contacts()[i];
    const bool is_loaded = !c.preload.is_zero() || (!growth.empty() && !growth[i].is_zero());
    if (is_loaded && !exact_sqrt(c.normal.x * c.normal.x + c.normal.y * c.normal.y))
      return true;
  }
  return false;
}

/// Sets the preloads of contacts and the forces of springs to 0.
void remove_preloads(AnyGrasp& grasp) {
  grasp.set_preload(0);
  if (GraspBox* box = grasp.box()) {
    for (Spring& spring : box->springs) spring.force = {};
  }
}

/// Returns the grasp under this wrench, widened by the tolerances: a box, or one grasp in the
/// plane if that is all it is.
AnyGrasp under(AnyGrasp grasp, const WrenchBox& wrench, const QuestionOptions& options,
               const Question& question) {
  const Tolerances& uncertain = options.uncertain;
  const std::optional<MotionBound>& bound = options.max_motion;
  LoadedGrasp* one = grasp.single();
  if (one != nullptr && is_certain(wrench) && !uncertain.any() && !bound &&
      !has_irrational_preload(one->grasp, question.preload_growth)) {
    one->wrench = wrench_of(middle_of(wrench));
    return grasp;
  }
  GraspBox box = one != nullptr ? box_of(*one) : std::move(*grasp.box());
  box.wrench = wrench;
  box = box.widened(uncertain);
  if (bound) {
    const RationalRow growth = question.direction.value_or(RationalRow{});
    box.max_motion = bound_of(grown(box, growth, question.preload_growth), *bound);
  }
  return simplest(std::move(box), question.preload_growth);
}

/// Returns how much each preload grows; `preloads` are those without growth. Throws InputError
/// unless there is one rate for each, and none of a pushing element is negative.
std::vector<Rational> preload_growth(const std::vector<Rational>& preloads,
                                     const PreloadDirection& direction, std::size_t pushing) {
  if (direction.scale) return preloads;
  if (direction.preloads.size() != preloads.size()) {
    throw InputError("", "preload_direction",
                     "there are " + std::to_string(direction.preloads.size()) +
                         " numbers for " + std::to_string(preloads.size()) +
                         (pushing < preloads.size() ? " contacts and springs" : " contacts"),
                     "give one for each, or the word scale for all in proportion");
  }
  for (std::size_t i = 0; i < pushing; ++i) {
    if (direction.preloads[i].sign() >= 0) continue;
    throw InputError("", "preload_direction",
                     "the number of contact " + std::to_string(i) + " is " +
                         to_string(direction.preloads[i]),
                     "preloads grow, and do not fall: give 0 or more");
  }
  return direction.preloads;
}

void require_growth(bool load_grows, const std::vector<Rational>& growth,
                    const std::optional<PreloadDirection>& direction) {
  if (load_grows || !all_zero(growth)) return;
  if (!direction) {
    throw InputError("", "direction", "the direction is 0",
                     "give the wrench whose multiples are asked for, such as 0,1,0");
  }
  throw InputError(
      "", "preload_direction",
      direction->scale ? "there is no preload to scale" : "all of its numbers are 0",
      direction->scale ? "give a preload, or how each one grows"
                       : "give a number above 0 to a contact whose preload grows");
}

void refuse_limits(const AnyGrasp& grasp) {
  const GraspBox* box = grasp.box();
  if (box == nullptr) return;
  for (const auto& [element, most] : box->force_limits()) {
    const std::size_t contacts = box->contacts.size();
    throw InputError("",
                     element < contacts
                         ? "contacts[" + std::to_string(element) + "].max_force"
                         : box->springs[element - contacts].place + ".max_torque",
                     "a force is limited, and how it yields is not in the law of springs",
                     "ask stickslip statics, which takes limits, or remove it");
  }
}

}  // namespace

AnyGrasp simplest(GraspBox box, const std::vector<Rational>& growth) {
  if (!box.mechanism && !box.in_space() && !box.is_bounded() && box.is_point()) {
    LoadedGrasp point = loaded_of(box);
    if (!has_irrational_preload(point.grasp, growth)) return point;
  }
  return box;
}

Question ask(GraspFile file, const QuestionOptions& options) {
  Question question;
  if (!options.takes_limits) refuse_limits(file.content);
  const WrenchBox wrench = wrench_asked(file, options);
  question.law = options.law;
  question.preload = options.preload;
  question.assumed_stiffness = std::move(file.assumed_stiffness);
  question.direction = options.direction;
  question.preload_direction = options.preload_direction;
  question.case_name = options.case_name.value_or("");
  question.uncertain = options.uncertain;
  AnyGrasp grasp = std::move(file.content);
  if (options.preload) {
    if (options.preload->sign() < 0) {
      throw InputError("", "preload", "the value is " + to_string(*options.preload),
                       "a preload is a normal force and must be 0 or more");
    }
    grasp.set_preload(*options.preload);
  }
  if (options.preload_direction) {
    question.preload_growth =
        preload_growth(grasp.preloads(), *options.preload_direction, grasp.pushing_elements());
    if (options.preload_direction->scale) remove_preloads(grasp);
  }
  if (question.is_margin()) {
    require_growth(options.direction && !all_zero(*options.direction), question.preload_growth,
                   options.preload_direction);
    if (!is_certain(wrench) || question.uncertain.any() || !grasp.has_certain_elements()) {
      throw InputError("", "uncertain", "a margin needs numbers, and some are uncertain",
                       "give one number for each, or ask only whether the load is held");
    }
  }
  if (options.uncertain.wrench) question.wrench_as_asked = wrench;
  question.grasp = under(std::move(grasp), wrench, options, question);
  return question;
}

Question without_bound(Question question) {
  if (!question.is_bounded()) return question;
  GraspBox box = std::move(*question.grasp.box());
  box.max_motion.clear();
  question.grasp = simplest(std::move(box), question.preload_growth);
  return question;
}

void require_one_grasp(const Question& question) {
  if (question.box() == nullptr || question.box()->is_point()) return;
  throw InputError("", "", "some numbers are uncertain, and this needs one grasp",
                   "give one number for each; only whether the load is held can be asked of "
                   "all grasps in a box");
}

Question as_one_body(Question question) {
  const GraspBox* box = question.box();
  if (box == nullptr || !box->mechanism || box->mechanism->bodies.size() != 1 ||
      !box->mechanism->joints.empty() || !box->springs.empty()) {
    return question;
  }
  for (const UncertainContact& c : box->contacts) {
    if (!c.torsion.is_zero()) return question;
  }
  GraspBox one = *box;
  one.mechanism.reset();
  question.grasp = simplest(std::move(one), question.preload_growth);
  return question;
}

void require_one_body(const AnyGrasp& grasp, const std::string& what) {
  if (grasp.mechanism() == nullptr) return;
  throw InputError("", "", "the grasp has several bodies", what + " is for one body only");
}

Problem problem_of(const Question& question) {
  require_one_body(question, "this");
  if (question.is_bounded()) {
    throw InputError("", "max_motion", "motions are bounded",
                     "this is known without a bound only; ask with max_motion none");
  }
  if (question.in_space()) {
    throw InputError("", "", "the grasp is in space", "this is done in the plane only");
  }
  require_one_grasp(question);
  // A box that is certain has irrational lengths, at which Problem or contact_rows() throws.
  const GraspBox* box = question.box();
  const LoadedGrasp point = box != nullptr ? loaded_of(*box) : question.loaded();
  Problem base(point, question.law);
  if (!question.is_margin()) return base;
  Growth growth;
  if (question.direction) growth.load = *question.direction;
  if (!question.preload_growth.empty()) {
    const Grasp growing = point.grasp.with_preloads(question.preload_growth);
    for (const ContactRow& row : contact_rows(growing)) growth.preloads.push_back(row.preload);
  }
  return base.along(growth);
}

}  // namespace stickslip
