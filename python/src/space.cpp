// SPDX-License-Identifier: GPL-3.0-or-later
// Grasps in space: the class beside GraspData, and the questions that it answers to. The
// functions have the names and arguments of those of the plane.
#include <pybind11/stl.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/margin/spatial_margin.hpp"
#include "stickslip/plot/grasp_plot.hpp"
#include "stickslip/warnings/spatial_warnings.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

template <std::size_t N>
std::array<Rational, N> exact_array(const py::list& values, const std::string& name) {
  std::array<Rational, N> result;
  const std::vector<Rational> all = numbers(values, N, name);
  std::copy(all.begin(), all.end(), result.begin());
  return result;
}

WrenchBox certain(const Vector6& wrench) {
  WrenchBox result(6);
  for (std::size_t j = 0; j < 6; ++j) result[j] = point_interval(wrench[j]);
  return result;
}

Vector3 row_of(const py::list& rows, std::size_t i, const char* name) {
  const auto row = rows[i].cast<py::list>();
  Vector3 result;
  for (std::size_t j = 0; j < 3; ++j) {
    result[j] =
        exact(row[j], name + ("[" + std::to_string(i) + ", ") + std::to_string(j) + "]");
  }
  return result;
}

/// The package has checked the lengths.
SpatialGraspFile make_grasp(const py::list& positions, const py::list& normals,
                            const py::object& friction, const py::object& stiffness,
                            const py::object& preload, const py::list& wrench,
                            const std::string& name, bool assumed_stiffness,
                            const py::list& cases, const py::list& units) {
  const std::size_t m = positions.size();
  const std::vector<Rational> frictions = numbers(friction, m, "friction");
  const std::vector<Rational> stiffnesses = numbers(stiffness, m, "stiffness");
  const std::vector<Rational> preloads = numbers(preload, m, "preload");
  SpatialGraspFile grasp;
  auto& box = grasp.content.emplace<GraspBox>();
  for (std::size_t i = 0; i < m; ++i) {
    const Vector3 p = row_of(positions, i, "positions");
    const Vector3 n = row_of(normals, i, "normals");
    box.contacts.push_back({{point_interval(p[0]), point_interval(p[1]), point_interval(p[2])},
                            {n.begin(), n.end()},
                            point_interval(frictions[i]),
                            point_interval(stiffnesses[i]),
                            point_interval(preloads[i])});
    if (assumed_stiffness) grasp.assumed_stiffness.emplace_back(i);
  }
  box.wrench = certain(exact_array<6>(wrench, "wrench"));
  for (const py::handle entry : cases) {
    const auto named = entry.cast<py::tuple>();
    const auto case_name = named[0].cast<std::string>();
    grasp.cases.push_back(
        {case_name, certain(exact_array<6>(named[1].cast<py::list>(),
                                           "cases[" + quote(case_name) + "]"))});
  }
  // The requirements on units are Grasp's own.
  box.description = Grasp({}, GraspDescription{name, {}, units_from(units)}).description();
  box.check();
  return grasp;
}

/// Every stiffness written out, as of a GraspFile.
std::string text_of(SpatialGraspFile grasp) {
  grasp.assumed_stiffness.clear();
  return write_grasp_file(grasp);
}

const GraspBox& box_in(const GraspFile& grasp) {
  return std::get<GraspBox>(grasp.content);
}

/// The numbers of a grasp without intervals.
template <class Intervals>
py::tuple lows(const Intervals& intervals) {
  return tuple_of(intervals, [](const Interval& interval) { return fraction(interval.low); });
}

template <class Values>
py::tuple fractions_of(const Values& values) {
  return tuple_of(values, fraction);
}

/// One value a contact.
template <class Value>
auto by_contact(Value value) {
  return [value](const SpatialGraspFile& grasp) {
    return tuple_of(box_in(grasp).contacts, value);
  };
}

auto scalars(Interval UncertainContact::*member) {
  return by_contact([member](const UncertainContact& c) { return fraction((c.*member).low); });
}

struct Answer {
  Question question;
  BoxDecision decision;
  std::string certificate;  ///< empty if there is none
};

/// In an answer; nothing if no equilibrium is known in fractions.
const SpatialWitness* witness_of(const Answer& answer) {
  const auto* stable = std::get_if<StableThroughout>(&answer.decision.verdict);
  return stable == nullptr ? nullptr : std::get_if<SpatialWitness>(&stable->proof);
}

std::vector<SpatialForce> forces_in(const Answer& answer, const SpatialWitness& witness) {
  return forces_of(*answer.question.box(), witness.twist, witness.shares);
}

/// The fields that all answers have in common.
py::dict fields_of(const Answer& answer) {
  const Question& question = answer.question;
  const BoxDecision& decision = answer.decision;
  py::dict result("verdict"_a = name_of(decision.verdict), "engine"_a = kSpaceEngine,
                  "normal_law"_a = to_string(question.law),
                  "wrench"_a = tuple_of(question.box()->wrench, [](const Interval& w) {
                    return fraction(w.middle());
                  }));
  if (question.preload) result["preload"] = fraction(*question.preload);
  if (const auto* undecided = std::get_if<Undecided>(&decision.verdict)) {
    add_undecided(result, *undecided);
  }
  result["stats"] = stats(decision.work);
  return result;
}

Answer answer_to(Question question, std::size_t node_limit) {
  SearchOptions options;
  options.node_limit = node_limit;
  BoxDecision decision = decide_box(*question.box(), question.law, options);
  return {std::move(question), std::move(decision), {}};
}

void refuse_engine(const std::string& engine) {
  if (engine == "auto") return;
  throw InputError("", "engine", "the grasp is in space, for which there is one engine",
                   "leave it out");
}

void add_certificate(Answer& answer) {
  const BoxVerdict& verdict = answer.decision.verdict;
  if (std::holds_alternative<StableThroughout>(verdict) ||
      std::holds_alternative<UnstableThroughout>(verdict)) {
    answer.certificate =
        box_certificate_text(answer.question, answer.decision, producer_of(kSpaceEngine));
  }
}

/// The fields of results.Decision.
py::dict decision_fields(const Answer& answer) {
  py::dict result = fields_of(answer);
  if (!answer.certificate.empty()) result["certificate"] = answer.certificate;
  const auto* stable = std::get_if<StableThroughout>(&answer.decision.verdict);
  if (stable == nullptr) return result;
  const SpatialWitness* witness = witness_of(answer);
  if (witness == nullptr) {
    result["near"] = fractions_of(stable->motion);
    return result;
  }
  const auto forces = forces_in(answer, *witness);
  result["twist"] = fractions_of(witness->twist);
  result["forces"] =
      tuple_of(forces, [](const SpatialForce& f) { return fractions_of(f.force); });
  result["closed"] =
      tuple_of(forces, [](const SpatialForce& f) { return py::bool_(f.normal.sign() > 0); });
  return result;
}

py::dict decide_grasp(const SpatialGraspFile& grasp, const py::object& wrench,
                      const py::object& preload, bool bilateral, const std::string& engine,
                      std::size_t node_limit, bool warnings) {
  refuse_engine(engine);
  Question question = question_in_box(grasp, question_options(wrench, preload, bilateral));
  std::vector<ModelWarning> traps;
  const Answer answer = without_gil([&] {
    Answer found = answer_to(std::move(question), node_limit);
    add_certificate(found);
    if (warnings) traps = model_warnings(found.question, found.decision);
    return found;
  });
  py::dict result = decision_fields(answer);
  result["warnings"] = warning_fields(traps);
  return result;
}

py::dict find_grasp_margin(const SpatialGraspFile& grasp, const py::object& direction,
                           const py::object& wrench, const py::object& preload,
                           const py::object& preload_direction, bool bilateral,
                           std::size_t node_limit, bool warnings, const py::object& accuracy) {
  const Question question = question_in_box(
      grasp, question_options(wrench, preload, bilateral, direction, preload_direction));
  SpatialMarginOptions options;
  options.search.node_limit = node_limit;
  options.accuracy = exact(accuracy, "accuracy");
  if (options.accuracy.sign() <= 0) {
    throw InputError("", "accuracy", "the value is " + to_string(options.accuracy),
                     "give a number above 0, such as 1/1000");
  }
  std::vector<ModelWarning> traps;
  const auto [margin, certificate] = without_gil([&] {
    SpatialMargin found = find_margin(question, options);
    std::string text = margin_certificate_text(question, found, producer_of(kSpaceEngine));
    if (warnings) traps = model_warnings(question, found);
    return std::pair(std::move(found), std::move(text));
  });
  const auto pairs = [](const std::vector<MarginInterval>& intervals) {
    py::list result;
    for (const MarginInterval& i : intervals) {
      result.append(
          py::make_tuple(fraction(i.low), i.high ? fraction(*i.high) : py::object(py::none())));
    }
    return py::tuple(result);
  };
  py::dict result("resisted"_a = pairs(margin.resisted()),
                  "refuted"_a = pairs(margin.refuted()),
                  "wrench"_a = lows(question.box()->wrench),
                  "normal_law"_a = to_string(question.law), "certificate"_a = certificate,
                  "warnings"_a = warning_fields(traps), "stats"_a = stats(margin.work));
  result["direction"] = question.direction ? py::object(fractions_of(*question.direction))
                                           : py::object(py::none());
  if (question.preload) result["preload"] = fraction(*question.preload);
  if (question.preload_direction) {
    result["preload_direction"] = preload_direction_of(*question.preload_direction);
  }
  return result;
}

py::str spatial_picture(const SpatialGraspFile& grasp, const py::object& wrench,
                        const py::object& preload, bool bilateral,
                        const std::string& /*engine*/,
                        const std::optional<std::string>& limit) {
  const Question question =
      question_in_box(grasp, question_options(wrench, preload, bilateral));
  return text(without_gil([&] {
    return plot_grasp(question, limit ? Undecided{*limit}
                                      : decide_box(*question.box(), question.law).verdict);
  }));
}

SpatialGraspFile with_friction(SpatialGraspFile grasp, const std::vector<Rational>& friction) {
  auto& box = std::get<GraspBox>(grasp.content);
  for (std::size_t i = 0; i < friction.size(); ++i) {
    box.contacts[i].friction = point_interval(friction[i]);
  }
  box.check();
  return grasp;
}

SpatialGraspFile unpickled(const py::tuple& state) {
  return {parse_any_grasp(state[0].cast<std::string>(), "<pickle>", Intervals::kRefused)};
}

/// Of either class.
py::object parse(const std::string& content, const std::string& name) {
  GraspFile file =
      without_gil([&] { return parse_any_grasp(content, name, Intervals::kRefused); });
  if (in_space(file.content)) return py::cast(SpatialGraspFile{std::move(file)});
  return py::cast(std::move(file));
}

}  // namespace

std::function<ManyAnswer()> spatial_question(const py::handle& given, const OneOfMany& asked,
                                             bool bilateral, const std::string& engine,
                                             std::size_t node_limit) {
  refuse_engine(engine);
  auto grasp = given.cast<std::shared_ptr<const SpatialGraspFile>>();
  const py::object none = py::none();
  std::optional<std::vector<Rational>> friction;
  if (asked.friction != nullptr) friction = *asked.friction;
  return [grasp = std::move(grasp), friction = std::move(friction),
          options =
              question_options(asked.wrench, asked.preload, bilateral, none, none, asked.which),
          node_limit] {
    const auto about =
        friction ? std::make_shared<const SpatialGraspFile>(with_friction(*grasp, *friction))
                 : grasp;
    const auto found =
        std::make_shared<Answer>(answer_to(question_in_box(*about, options), node_limit));
    ManyAnswer answer;
    answer.verdict = name_of(found->decision.verdict);
    answer.engine = kSpaceEngine;
    for (const Interval& value : found->question.box()->wrench) {
      answer.wrench.push_back(to_double(value.low));
    }
    if (const auto* undecided = std::get_if<Undecided>(&found->decision.verdict)) {
      answer.limit = undecided->limit;
    }
    if (const SpatialWitness* witness = witness_of(*found)) {
      for (const Rational& value : witness->twist) answer.twist.push_back(to_double(value));
      for (const SpatialForce& contact : forces_in(*found, *witness)) {
        for (const Rational& value : contact.force) answer.forces.push_back(to_double(value));
      }
    }
    answer.whole = [about, found] {
      if (found->certificate.empty()) add_certificate(*found);
      return py::make_tuple(*about, decision_fields(*found));
    };
    return answer;
  };
}

void bind_space(py::module_& module) {
  py::class_<SpatialGraspFile, GraspFile, std::shared_ptr<SpatialGraspFile>>(module,
                                                                             "SpatialGraspData")
      .def(py::init(&make_grasp))
      .def("text", &text_of)
      .def("with_friction",
           [](const SpatialGraspFile& g, const py::object& friction) {
             return with_friction(g, numbers(friction, box_in(g).contacts.size(), "friction"));
           })
      .def("size", [](const SpatialGraspFile& g) { return box_in(g).contacts.size(); })
      .def("name", [](const SpatialGraspFile& g) { return text(g.description().name); })
      .def("positions", by_contact([](const UncertainContact& c) { return lows(c.position); }))
      .def("normals",
           by_contact([](const UncertainContact& c) { return fractions_of(c.normal); }))
      .def("friction", scalars(&UncertainContact::friction))
      .def("stiffness", scalars(&UncertainContact::stiffness))
      .def("preload", scalars(&UncertainContact::preload))
      .def("wrench", [](const SpatialGraspFile& g) { return lows(box_in(g).wrench); })
      .def("cases",
           [](const SpatialGraspFile& g) {
             py::dict result;
             for (const NamedLoad& one : g.cases) result[text(one.name)] = lows(one.wrench);
             return result;
           })
      .def("units", [](const SpatialGraspFile& g) { return units_of(g.description().units); })
      .def("snap",
           [](const SpatialGraspFile& g, const py::object& within) {
             SpatialSnapResult result = snap_normals(box_in(g), exact(within, "within"));
             SpatialGraspFile grasp = g;
             grasp.content = std::move(result.grasp);
             return py::make_tuple(std::move(grasp),
                                   moved_normals(result.snapped, fractions_of<Vector3>));
           })
      .def(py::pickle(
          [](const SpatialGraspFile& g) {
            return py::make_tuple(py::bytes(write_grasp_file(g)));
          },
          &unpickled));
  module.def("parse_grasp", &parse);
  // Before those of the plane, which take any grasp.
  module.def("decide", &decide_grasp, py::prepend());
  module.def("margin", &find_grasp_margin, py::prepend());
  module.def("plot_grasp", &spatial_picture, py::prepend());
}

}  // namespace stickslip::python
