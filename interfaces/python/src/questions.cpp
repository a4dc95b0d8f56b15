// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/engine/contact_mode.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/margin.hpp"
#include "stickslip/measures/model_warnings.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

/// Adds the evidence of a stable verdict, contact by contact.
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

/// Returns the coordinates of a vector in the plane or in space.
RationalRow coordinates_of(const Answer& about, const Vector3& v) {
  return {v.begin(), v.begin() + (about.question.in_space() ? 3 : 2)};
}

/// Adds the fields of an equilibrium, as far as it is known.
struct EquilibriumFields {
  const Answer& answer;
  const Stable& stable;
  py::dict& result;

  void operator()(const Witness& witness) const {
    add_witness(result, answer.question, *answer.problem, witness);
  }
  void operator()(const ShareWitness& witness) const {
    const auto forces = forces_of(*answer.question.box(), witness.twist, witness.shares);
    result["twist"] = tuple_of(witness.twist, fraction);
    result["forces"] = tuple_of(forces, [this](const SpatialForce& f) {
      return tuple_of(coordinates_of(answer, f.force), fraction);
    });
    result["closed"] =
        tuple_of(forces, [](const SpatialForce& f) { return py::bool_(f.normal.sign() > 0); });
    if (has_torsion(*answer.question.box())) {
      auto contact = answer.question.box()->contacts.begin();
      result["moments"] = tuple_of(forces, [&](const SpatialForce& f) {
        return tuple_of(moment_of(f, *contact++), fraction);
      });
    }
    if (answer.question.mechanism() != nullptr) {
      result["springs"] =
          tuple_of(spring_forces_of(*answer.question.box(), witness.twist), fraction);
    }
  }
  void operator()(const StabilityProof& /*proof*/) const {
    result["near"] = tuple_of(stable.motion, fraction);
  }
};

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

Engine engine_for(const GraspFile& grasp, const std::string& name) {
  const bool several = mechanism_of(grasp.content) != nullptr;
  if ((several || in_space(grasp.content)) && name != "auto") {
    throw InputError(
        "", "engine",
        std::string(several ? "there are several bodies" : "the grasp is in space") +
            ", for which there is one engine",
        "leave it out");
  }
  return engine_named(name);
}

py::dict decide_grasp(const GraspFile& grasp, const py::object& wrench,
                      const py::object& preload, bool bilateral, const std::string& engine,
                      std::size_t node_limit, bool warnings, const std::string& max_motion) {
  const QuestionOptions asked = bounded_options(wrench, preload, bilateral, max_motion);
  SearchOptions options = by(engine_for(grasp, engine));
  options.node_limit = node_limit;
  // Warnings need an exact equilibrium.
  if (warnings && options.engine == Engine::kAuto) options.engine = Engine::kBranchAndBound;
  const auto [answer, certificate, traps] = without_gil([&] {
    Answer found = decide(question_about(grasp, asked), options);
    std::string proof = certificate_of(found).value_or("");
    std::vector<ModelWarning> traps_of;
    if (warnings) traps_of = model_warnings(found);
    return std::tuple(std::move(found), std::move(proof), std::move(traps_of));
  });
  py::dict result = decision_fields(answer, certificate);
  result["warnings"] = warning_fields(traps);
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

/// Returns the fields of results.Margin; or the limit at which it is not known.
py::dict exact_margin(const Question& question, std::size_t node_limit, bool warnings) {
  struct Answer {
    std::variant<Margin, Undecided> result;
    MarginWork work;
    std::string certificate;  ///< empty if undecided
    std::vector<ModelWarning> warnings;
  };
  const Answer answer = without_gil([&] {
    SearchOptions options;
    options.node_limit = node_limit;
    MarginWork work;
    auto found = find_margin(problem_of(question), options, &work);
    std::string certificate;
    std::vector<ModelWarning> traps;
    if (const auto* margin = std::get_if<Margin>(&found)) {
      certificate = margin_certificate_text(question, *margin, "stickslip " STICKSLIP_VERSION);
      if (warnings) traps = model_warnings(question, *margin);
    }
    return Answer{std::move(found), work, std::move(certificate), std::move(traps)};
  });

  if (const auto* undecided = std::get_if<Undecided>(&answer.result)) {
    return py::dict("limit"_a = undecided->limit);
  }
  const auto& margin = std::get<Margin>(answer.result);
  py::tuple resisted(margin.resisted.size());
  for (std::size_t i = 0; i < resisted.size(); ++i) {
    const MarginInterval& interval = margin.resisted[i];
    resisted[i] = py::make_tuple(fraction(interval.low), fraction_or_none(interval.high));
  }
  py::dict work("ranges"_a = answer.work.ranges, "mode_programs"_a = answer.work.modes);
  work.attr("update")(stats(answer.work.cone));
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

py::dict find_grasp_margin(const GraspFile& grasp, const py::object& direction,
                           const py::object& wrench, const py::object& preload,
                           const py::object& preload_direction, bool bilateral,
                           std::size_t node_limit, bool warnings, const py::object& accuracy,
                           const std::string& max_motion) {
  const Question question =
      question_in_box(grasp, question_options(wrench, preload, bilateral, direction,
                                              preload_direction, "", max_motion));
  return question.has_claims() ? margin_by_claims(question, node_limit, warnings, accuracy)
                               : exact_margin(question, node_limit, warnings);
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

/// Returns the second answer, with the file and the certificate that prove it, if it is
/// decided.
py::dict within_fields(const Answer& within) {
  const GraspBox box = box_of(within.question.grasp);
  py::dict result(
      "verdict"_a = name_of(within.verdict), "normal_law"_a = to_string(within.question.law),
      "wrench"_a = tuple_of(box.wrench, [](const Interval& w) { return fraction(w.low); }));
  if (box.is_bounded()) result["max_motion"] = tuple_of(box.max_motion, fraction);
  if (const auto certificate = certificate_of(within)) {
    result["grasp"] = write_grasp(box);
    result["certificate"] = *certificate;
  }
  return result;
}

py::dict decision_fields(const Answer& answer, const std::string& certificate) {
  const Question& question = answer.question;
  py::dict result("verdict"_a = name_of(answer.verdict), "engine"_a = answer.engine(),
                  "normal_law"_a = to_string(question.law),
                  "wrench"_a = tuple_of(wrench_of(question.grasp),
                                        [](const Interval& w) { return fraction(w.low); }));
  if (question.preload) result["preload"] = fraction(*question.preload);
  if (question.is_bounded()) {
    result["max_motion"] = tuple_of(question.box()->max_motion, fraction);
  }
  if (!certificate.empty()) result["certificate"] = certificate;
  py::dict work;
  for (const auto& [name, value] : counters(answer)) work[name.c_str()] = value;
  result["stats"] = work;
  if (const auto* stable = std::get_if<Stable>(&answer.verdict)) {
    std::visit(EquilibriumFields{answer, *stable, result}, stable->proof);
  } else if (const auto* undecided = std::get_if<Undecided>(&answer.verdict)) {
    add_undecided(result, *undecided);
  }
  if (answer.within) result["within"] = within_fields(*answer.within);
  return result;
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
          options = question_options(asked.wrench, asked.preload, bilateral, py::none(),
                                     py::none(), asked.which),
          how] {
    const auto about =
        friction ? std::make_shared<const GraspFile>(with_friction(*grasp, *friction)) : grasp;
    const auto found =
        std::make_shared<const Answer>(decide(question_about(*about, options), how));
    ManyAnswer answer;
    answer.verdict = name_of(found->verdict);
    answer.engine = found->engine();
    for (const Interval& w : wrench_of(found->question.grasp)) {
      answer.wrench.push_back(to_double(w.low));
    }
    if (const auto* stable = std::get_if<Stable>(&found->verdict)) {
      std::visit(AddDoubles{*found, answer}, stable->proof);
    } else if (const auto* undecided = std::get_if<Undecided>(&found->verdict)) {
      answer.limit = undecided->limit;
    }
    answer.whole = [about, found] {
      return py::make_tuple(in_its_class(*about),
                            decision_fields(*found, certificate_of(*found).value_or("")));
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
                                 const py::object& preload_direction, const std::string& which,
                                 const std::string& max_motion) {
  QuestionOptions options;
  if (!max_motion.empty()) options.max_motion = parse_motion_bound(max_motion);
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
    problem_of(without_bound(question));
  } catch (const InputError& error) {
    throw InputError("", error.place(), error.problem(), "ask about grasp.snap().grasp");
  }
  return question;
}

Question question_about(const GraspFile& grasp, const QuestionOptions& options) {
  return in_space(grasp.content) || mechanism_of(grasp.content) != nullptr
             ? question_in_box(grasp, options)
             : question_of(grasp, options);
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
