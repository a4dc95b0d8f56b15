// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/contact_mode.hpp"
#include "stickslip/margin/margin.hpp"
#include "stickslip/planar/decide.hpp"
#include "stickslip/warnings/model_warnings.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

/// The evidence of a stable verdict, contact by contact.
void add_witness(py::dict& result, const Question& question, const Problem& problem,
                 const Witness& witness) {
  py::tuple coefficients(problem.size());
  py::tuple closed(problem.size());
  const std::vector<ContactMode> modes = modes_of(problem, witness.twist);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    coefficients[i] = fractions(witness.forces[i].normal, witness.forces[i].tangential);
    closed[i] = modes[i].closed;
  }
  result["twist"] = fractions(witness.twist);
  result["forces"] = force_vectors(question.loaded().grasp, witness.forces);
  result["coefficients"] = coefficients;
  result["slip"] = slips_text(modes);
  result["closed"] = closed;
}

/// The fields that answers about a box have in common.
py::dict box_fields(const Question& question, const char* verdict) {
  py::dict result("verdict"_a = verdict, "normal_law"_a = to_string(question.law),
                  "wrench"_a = fractions(question.loaded().wrench));
  if (question.preload) result["preload"] = fraction(*question.preload);
  return result;
}

/// By an engine; or, where an exact equilibrium would be long, that the grasp
/// is stable by degree.
using Judgement = std::variant<Decision, BoxDecision>;

std::string certificate_of(const Question& question, const Judgement& judgement) {
  if (const auto* decision = std::get_if<Decision>(&judgement)) {
    return python::certificate_of(question, *decision);
  }
  return *stickslip::certificate_of(
      answer_by_degree(question, std::get<BoxDecision>(judgement)));
}

/// The fields of results.Decision, but the warnings.
py::dict judgement_fields(const Question& question, const Judgement& judgement,
                          const std::string& certificate) {
  if (const auto* decision = std::get_if<Decision>(&judgement)) {
    return decision_fields(question, Problem(question.loaded(), question.law), *decision,
                           certificate);
  }
  const BoxDecision& decision = std::get<BoxDecision>(judgement);
  py::dict result = box_fields(question, "stable");
  result["engine"] = kIntervalsEngine;
  result["certificate"] = certificate;
  result["near"] = tuple_of(*motion_near(answer_by_degree(question, decision)), fraction);
  result["stats"] = stats(decision.work);
  return result;
}

/// The motion and the forces of an equilibrium.
void add_doubles(ManyAnswer& answer, const Grasp& grasp, const Witness& witness) {
  for (const Rational& value : coordinates(witness.twist)) {
    answer.twist.push_back(to_double(value));
  }
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const Vector2 force = force_vector(grasp.contacts()[i].normal, witness.forces[i]);
    answer.forces.push_back(to_double(force.x));
    answer.forces.push_back(to_double(force.y));
  }
}

py::dict decide_grasp(const GraspFile& grasp, const py::object& wrench,
                      const py::object& preload, bool bilateral, const std::string& engine,
                      std::size_t node_limit, bool warnings) {
  struct Answer {
    Question question;
    Judgement judgement;
    std::string certificate;  ///< empty if undecided
    std::vector<ModelWarning> warnings;
  };
  const QuestionOptions asked = question_options(wrench, preload, bilateral);
  const Answer answer = without_gil([&] {
    Question question = question_of(grasp, asked);
    // Warnings need an exact equilibrium.
    const Problem problem(question.loaded(), question.law);
    const Engine asked_for = engine_named(engine);
    const bool exactly = warnings && asked_for == Engine::kAuto;
    Judgement judgement =
        judge(problem, exactly ? Engine::kBranchAndBound : asked_for, node_limit);
    std::string certificate = certificate_of(question, judgement);
    std::vector<ModelWarning> found;
    if (warnings) {
      found = model_warnings(question, problem, std::get<Decision>(judgement).verdict);
    }
    return Answer{std::move(question), std::move(judgement), std::move(certificate),
                  std::move(found)};
  });
  py::dict result = judgement_fields(answer.question, answer.judgement, answer.certificate);
  result["warnings"] = warning_fields(answer.warnings);
  return result;
}

py::dict slip_states(const GraspFile& grasp, const std::string& engine, bool list,
                     unsigned threads) {
  const Enumerator enumerator = engine == "cgal"    ? Enumerator::kCgal
                                : engine == "sweep" ? Enumerator::kSweep
                                : engine == "paper" ? Enumerator::kPaper
                                                    : Enumerator::kAuto;
  const Enumeration answer = without_gil([&] {
    return enumerate_slip_states(stick_planes(grasp.loaded().grasp), enumerator, list, threads);
  });
  const ArrangementCounts& c = answer.found.counts;
  py::dict result("contacts"_a = c.planes, "circles"_a = c.circles, "rank"_a = c.rank,
                  "vertices"_a = c.vertices, "edges"_a = c.edges, "faces"_a = c.faces,
                  "cells"_a = c.cells(), "distinct_states"_a = c.distinct_states,
                  "engine"_a = answer.engine);
  if (list) {
    py::tuple states(answer.found.states.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      states[i] = to_string(answer.found.states[i]);
    }
    result["states"] = states;
  }
  return result;
}

py::dict find_grasp_margin(const GraspFile& grasp, const py::object& direction,
                           const py::object& wrench, const py::object& preload,
                           const py::object& preload_direction, bool bilateral,
                           std::size_t node_limit, bool warnings,
                           const py::object& /*accuracy*/) {
  struct Answer {
    Question question;
    std::variant<Margin, Undecided> result;
    MarginWork work;
    std::string certificate;  ///< empty if undecided
    std::vector<ModelWarning> warnings;
  };
  const QuestionOptions asked =
      question_options(wrench, preload, bilateral, direction, preload_direction);
  const Answer answer = without_gil([&] {
    Question question = question_of(grasp, asked);
    ConeOptions options;
    options.node_limit = node_limit;
    MarginWork work;
    auto found = find_margin(problem_of(question), options, &work);
    std::string certificate;
    std::vector<ModelWarning> traps;
    if (const auto* margin = std::get_if<Margin>(&found)) {
      certificate = margin_certificate_text(question, *margin, "stickslip " STICKSLIP_VERSION);
      if (warnings) traps = model_warnings(question, *margin);
    }
    return Answer{std::move(question), std::move(found), work, std::move(certificate),
                  std::move(traps)};
  });

  if (const auto* undecided = std::get_if<Undecided>(&answer.result)) {
    return py::dict("limit"_a = undecided->limit);
  }
  const auto& margin = std::get<Margin>(answer.result);
  py::tuple resisted(margin.resisted.size());
  for (std::size_t i = 0; i < resisted.size(); ++i) {
    const MarginInterval& interval = margin.resisted[i];
    resisted[i] =
        py::make_tuple(fraction(interval.low),
                       interval.high ? fraction(*interval.high) : py::object(py::none()));
  }
  py::dict work("ranges"_a = answer.work.ranges, "mode_programs"_a = answer.work.modes);
  work.attr("update")(stats(answer.work.cone));
  const Question& question = answer.question;
  py::dict result("resisted"_a = resisted, "wrench"_a = fractions(question.loaded().wrench),
                  "normal_law"_a = to_string(question.law),
                  "certificate"_a = answer.certificate,
                  "warnings"_a = warning_fields(answer.warnings), "stats"_a = work);
  result["direction"] = question.direction ? py::object(tuple_of(*question.direction, fraction))
                                           : py::object(py::none());
  if (question.preload) result["preload"] = fraction(*question.preload);
  if (question.preload_direction) {
    result["preload_direction"] = preload_direction_of(*question.preload_direction);
  }
  return result;
}

}  // namespace

py::object preload_direction_of(const PreloadDirection& direction) {
  if (direction.scale) return py::str("scale");
  return tuple_of(direction.rates, fraction);
}

void refuse_without_case(const std::string& first) {
  throw InputError("", "wrench", "the grasp has cases, and none is chosen",
                   "give the wrench of one, such as grasp.cases[" + quote(first) + "]");
}

void refuse_certain() {
  throw InputError("", "uncertain", "nothing is uncertain",
                   "say how far numbers may be off, as in {\"friction\": \"10%\"}");
}

void add_undecided(py::dict& result, const Undecided& undecided) {
  result["limit"] = undecided.limit;
  result["reason"] = undecided.reason;
  if (!undecided.remedy.empty()) result["remedy"] = undecided.remedy;
  if (undecided.near.empty()) return;
  result["near"] = tuple_of(undecided.near, [](const Rational& d) { return fraction(d); });
}

py::tuple warning_fields(const std::vector<ModelWarning>& warnings) {
  return tuple_of(warnings, [](const ModelWarning& warning) {
    return py::make_tuple(to_string(warning.trap), warning.text);
  });
}

std::string certificate_of(const Question& question, const Decision& decision) {
  if (std::holds_alternative<Undecided>(decision.verdict)) return {};
  return certificate_text(
      question, decision.verdict,
      std::string("stickslip " STICKSLIP_VERSION ", engine ") + decision.engine());
}

py::dict decision_fields(const Question& question, const Problem& problem,
                         const Decision& decision, const std::string& certificate) {
  const Verdict& verdict = decision.verdict;
  py::dict result("verdict"_a = name_of(verdict), "engine"_a = decision.engine(),
                  "normal_law"_a = to_string(question.law),
                  "wrench"_a = fractions(problem.wrench()));
  if (question.preload) result["preload"] = fraction(*question.preload);
  if (!certificate.empty()) result["certificate"] = certificate;
  result["stats"] = std::visit([](const auto& work) { return stats(work); }, decision.work);
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    add_witness(result, question, problem, stable->witness);
  } else if (const auto* undecided = std::get_if<Undecided>(&verdict)) {
    add_undecided(result, *undecided);
  }
  return result;
}

std::function<ManyAnswer()> planar_question(const py::handle& given, const OneOfMany& asked,
                                            bool bilateral, const std::string& engine,
                                            std::size_t node_limit) {
  auto grasp = given.cast<std::shared_ptr<const GraspFile>>();
  std::optional<std::vector<Rational>> friction;
  if (asked.friction != nullptr) friction = *asked.friction;
  return [grasp = std::move(grasp), friction = std::move(friction),
          options = question_options(asked.wrench, asked.preload, bilateral, py::none(),
                                     py::none(), asked.which),
          engine = engine_named(engine), node_limit] {
    const auto about =
        friction ? std::make_shared<const GraspFile>(with_friction(*grasp, *friction)) : grasp;
    const Question question = question_of(*about, options);
    const auto judgement = std::make_shared<const Judgement>(
        judge(Problem(question.loaded(), question.law), engine, node_limit));
    ManyAnswer answer;
    for (const Rational& value : coordinates(question.loaded().wrench)) {
      answer.wrench.push_back(to_double(value));
    }
    if (const auto* decision = std::get_if<Decision>(judgement.get())) {
      answer.verdict = name_of(decision->verdict);
      answer.engine = decision->engine();
      if (const auto* stable = std::get_if<Stable>(&decision->verdict)) {
        add_doubles(answer, question.loaded().grasp, stable->witness);
      } else if (const auto* undecided = std::get_if<Undecided>(&decision->verdict)) {
        answer.limit = undecided->limit;
      }
    } else {
      answer.verdict = "stable";
      answer.engine = kIntervalsEngine;
    }
    answer.whole = [about, options, judgement] {
      const Question again = question_of(*about, options);
      return py::make_tuple(
          *about, judgement_fields(again, *judgement, certificate_of(again, *judgement)));
    };
    return answer;
  };
}

py::tuple force_vectors(const Grasp& grasp, const std::vector<ContactForce>& forces) {
  py::tuple vectors(forces.size());
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const Vector2 force = force_vector(grasp.contacts()[i].normal, forces[i]);
    vectors[i] = fractions(force.x, force.y);
  }
  return vectors;
}

Engine engine_named(const std::string& name) {
  return name == "states"             ? Engine::kStates
         : name == "branch-and-bound" ? Engine::kBranchAndBound
                                      : Engine::kAuto;
}

QuestionOptions question_options(const py::object& wrench, const py::object& preload,
                                 bool bilateral, const py::object& direction,
                                 const py::object& preload_direction,
                                 const std::string& which) {
  QuestionOptions options;
  if (!wrench.is_none()) {
    options.wrench = numbers(wrench.cast<py::list>(), 0, "wrench" + which);
  }
  if (!preload.is_none()) options.preload = exact(preload, "preload" + which);
  options.law = bilateral ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  if (!direction.is_none()) {
    options.direction = numbers(direction.cast<py::list>(), 0, "direction");
  }
  if (!preload_direction.is_none()) {
    PreloadDirection& growth = options.preload_direction.emplace();
    growth.scale = !py::isinstance<py::list>(preload_direction);
    if (!growth.scale) {
      std::size_t index = 0;
      for (const py::handle rate : preload_direction) {
        growth.rates.push_back(
            exact(rate, "preload_direction[" + std::to_string(index++) + "]"));
      }
    }
  }
  return options;
}

Question question_of(const GraspFile& grasp, const QuestionOptions& options) {
  Question question = question_in_box(grasp, options);
  try {
    problem_of(question);
  } catch (const InputError& error) {
    throw InputError("", error.place(), error.problem(), "ask about grasp.snap().grasp");
  }
  return question;
}

Question question_in_box(const GraspFile& grasp, QuestionOptions options,
                         const std::string& uncertain) {
  if (!uncertain.empty()) options.uncertain = parse_tolerances(uncertain);
  if (!options.wrench && !options.direction && !grasp.cases.empty()) {
    refuse_without_case(grasp.cases.front().name);
  }
  return ask(grasp, options);
}

void bind_questions(py::module_& module) {
  module.def("decide", &decide_grasp);
  module.def("slip_states", &slip_states);
  module.def("margin", &find_grasp_margin);
}

}  // namespace stickslip::python
