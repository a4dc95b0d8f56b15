// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/margin_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

/// Returns the coordinates of a vector in the plane or in space.
RationalRow coordinates_of(const Answer& about, const Vector3& v) {
  return {v.begin(), v.begin() + (about.question.in_space() ? 3 : 2)};
}

/// Adds the motion and the forces of an equilibrium, if it is exact.
struct AddDoubles {
  const Answer& about;
  ManyAnswer& answer;

  void operator()(const Witness& witness) const {
    add(answer.twist, coordinates(witness.twist));
    const std::vector<Contact>& contacts = about.question.loaded().grasp.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Vector2 force = force_vector(contacts[i].normal, witness.forces[i]);
      add(answer.forces, std::array{force.x, force.y});
    }
  }
  void operator()(const ShareWitness& witness) const {
    add(answer.twist, witness.twist);
    for (const SpatialForce& f :
         forces_of(*about.question.box(), witness.twist, witness.shares)) {
      add(answer.forces, coordinates_of(about, f.force));
    }
  }
  void operator()(const StabilityProof& /*proof*/) const {}

 private:
  template <class Values>
  static void add(std::vector<double>& doubles, const Values& values) {
    for (const Rational& value : values) doubles.push_back(to_double(value));
  }
};

}  // namespace

Engine engine_for(const GraspFile& grasp, const std::string& name) {
  const bool several = grasp.content.mechanism() != nullptr;
  if ((several || grasp.content.in_space()) && name != "auto") {
    throw InputError(
        "", "engine",
        std::string(several ? "there are several bodies" : "the grasp is in space") +
            ", for which there is one engine",
        "leave it out");
  }
  return engine_named(name);
}

void refuse_without_case(const std::string& first) {
  throw InputError("", "wrench", "the grasp has cases, and none is chosen",
                   "give the wrench of one, such as grasp.cases[" + quote(first) + "]");
}

void refuse_certain() {
  throw InputError("", "uncertain", "nothing is uncertain",
                   "say how far numbers may be off, as in {\"friction\": \"10%\"}");
}

Json files_json(const ProvedFiles& files) {
  Json json{{"grasp", files.grasp},
            {"certificate", files.certificate},
            {"uncertain", files.uncertain}};
  if (const auto& direction = files.preload_direction) {
    json["preload_direction"] = preload_direction_json(*direction);
  }
  return json;
}

Json decision_json(const Answer& answer, const Warnings& warnings) {
  Json json = to_json(answer, warnings);
  if (answer.question.preload) json["preload"] = number_json(*answer.question.preload);
  if (const auto certificate = certificate_of(answer)) json["certificate"] = *certificate;
  if (answer.within) {
    if (const auto certificate = certificate_of(*answer.within)) {
      json["within"]["proof"] =
          files_json({write_grasp(answer.within->question.grasp.as_box()), *certificate});
    }
  }
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  if (stable == nullptr) return json;
  if (const auto* witness = std::get_if<Witness>(&stable->proof)) {
    json["coefficients"] = Json::array();
    for (std::size_t i = 0; i < witness->forces.size(); ++i) {
      const auto& [normal, tangential] = witness->forces[i];
      json["coefficients"].push_back(number_json(std::array{normal, tangential}));
      for (const char* length : {"normal", "tangential"}) json["contacts"][i].erase(length);
    }
  }
  return json;
}

std::function<ManyAnswer()> one_question(const py::handle& given, const OneOfMany& asked,
                                         bool bilateral, const std::string& engine,
                                         std::size_t node_limit) {
  auto grasp = given.cast<std::shared_ptr<const GraspFile>>();
  std::optional<std::vector<Rational>> friction;
  if (asked.friction != nullptr) friction = *asked.friction;
  SearchOptions how = by(engine_for(*grasp, engine));
  how.node_limit = node_limit;
  return [grasp = std::move(grasp), friction = std::move(friction),
          options = question_options(asked.wrench, asked.preload, bilateral, asked.which),
          how] {
    const auto about =
        friction ? std::make_shared<const GraspFile>(with_friction(*grasp, *friction)) : grasp;
    const auto found =
        std::make_shared<const Answer>(decide(question_about(*about, options), how));
    ManyAnswer answer;
    answer.verdict = name_of(found->verdict);
    answer.engine = found->engine();
    for (const Interval& w : found->question.grasp.wrench()) {
      answer.wrench.push_back(to_double(w.low));
    }
    if (const auto* stable = std::get_if<Stable>(&found->verdict)) {
      std::visit(AddDoubles{*found, answer}, stable->proof);
    } else if (const auto* undecided = std::get_if<Undecided>(&found->verdict)) {
      answer.limit = undecided->limit;
    }
    answer.whole = [about, found] {
      return py::make_tuple(in_its_class(*about), python_of(decision_json(*found)));
    };
    return answer;
  };
}

Engine engine_named(const std::string& name) {
  return name == "states"             ? Engine::kStates
         : name == "branch-and-bound" ? Engine::kBranchAndBound
                                      : Engine::kAuto;
}

QuestionOptions question_options(const py::object& wrench, const py::object& preload,
                                 bool bilateral, const std::string& which) {
  QuestionOptions options;
  if (!wrench.is_none()) {
    options.wrench = numbers(wrench.cast<py::list>(), 0, "wrench" + which);
  }
  if (!preload.is_none()) options.preload = exact(preload, "preload" + which);
  options.law = bilateral ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  return options;
}

QuestionOptions question_options(const py::dict& given) {
  const auto at = [&given](const char* name) -> py::object {
    return given.contains(name) ? py::object(given[name]) : py::none();
  };
  const auto words = [&at](const char* name) {
    const py::object value = at(name);
    return value.is_none() ? std::string() : value.cast<std::string>();
  };
  QuestionOptions options =
      question_options(at("wrench"), at("preload"), at("bilateral").is(py::bool_(true)));
  if (const std::string bound = words("max_motion"); !bound.empty()) {
    options.max_motion = parse_motion_bound(bound);
  }
  if (const std::string uncertain = words("uncertain"); !uncertain.empty()) {
    options.uncertain = parse_tolerances(uncertain);
  }
  if (const py::object direction = at("direction"); !direction.is_none()) {
    options.direction = numbers(direction, 0, "direction");
  }
  if (const py::object along = at("preload_direction"); !along.is_none()) {
    const bool scale = !py::isinstance<py::list>(along);
    options.preload_direction.emplace(PreloadDirection{
        scale, scale ? RationalRow() : numbers(along, 0, "preload_direction")});
  }
  return options;
}

Question question_of(const GraspFile& grasp, const QuestionOptions& options) {
  Question question = question_about(grasp, options);
  try {
    problem_of(without_bound(question));
  } catch (const InputError& error) {
    throw InputError("", error.place(), error.problem(), "ask about grasp.snap().grasp");
  }
  return question;
}

Question question_about(const GraspFile& grasp, const QuestionOptions& options) {
  if (!options.wrench && !options.direction && !grasp.cases.empty()) {
    refuse_without_case(grasp.cases.front().name);
  }
  return ask(grasp, options);
}

}  // namespace stickslip::python
