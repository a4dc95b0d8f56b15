// SPDX-License-Identifier: GPL-3.0-or-later
// The independent checker (certificate/cpp). It is given text, and no other data of the
// library.
#include "check.hpp"

#include <sstream>

#include "arguments.hpp"
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

/// Converts a number through its text, which is all that the two sides have in common.
stickslip_check::Rational for_checker(const Rational& value) {
  const std::optional<stickslip_check::Rational> same =
      stickslip_check::parse_decimal(to_string(value));
  require(same.has_value(), "the checker reads every number that exact() lets pass");
  return *same;
}

stickslip_check::PreloadDirection for_checker(const PreloadDirection& growth) {
  stickslip_check::PreloadDirection result{growth.scale, {}};
  for (const Rational& rate : growth.preloads) result.values.push_back(for_checker(rate));
  return result;
}

struct ToDict {
  py::dict operator()(const stickslip_check::Accepted& a) const {
    const stickslip_check::Question& q = a.question;
    const auto number = [](const stickslip_check::Rational& value) {
      return fraction(parse_rational(value.get_str()));
    };
    const auto wrench = [&](const stickslip_check::Vector& w) { return tuple_of(w, number); };
    const auto entry = [&](const stickslip_check::Bounds& w) {
      return w.certain() ? number(w.low)
                         : py::object(py::make_tuple(number(w.low), number(w.high)));
    };
    py::dict result(
        "accepted"_a = true, "verdict"_a = text(a.verdict), "contacts"_a = q.contacts.size(),
        "normal_law"_a = text(stickslip_check::law_name(q.asked.bilateral)),
        "wrench"_a = tuple_of(q.wrench, entry), "nodes"_a = a.nodes, "leaves"_a = a.leaves);
    if (q.asked.preload) result["preload"] = number(*q.asked.preload);
    if (q.asked.direction) result["direction"] = wrench(*q.asked.direction);
    if (const auto& growth = q.asked.preload_direction) {
      py::list rates;
      for (const stickslip_check::Rational& rate : growth->values) rates.append(number(rate));
      result["preload_direction"] =
          growth->scale ? py::object(py::str("scale")) : py::object(py::tuple(rates));
    }
    if (q.asked.plane) {
      result["plane"] =
          py::make_tuple(wrench((*q.asked.plane)[0]), wrench((*q.asked.plane)[1]));
      result["pieces"] = a.pieces;
    }
    if (a.bounds)
      result["bounds"] = py::make_tuple(number(a.bounds->low), number(a.bounds->high));
    if (q.asked.states) {
      result["by_dimension"] = tuple_of(a.by_dimension, [](const stickslip_check::Integer& n) {
        return py::int_(py::str(n.get_str()));
      });
    }
    if (q.asked.margin() && !q.asked.statics) {
      py::list resisted;
      for (const stickslip_check::Interval& interval : a.resisted) {
        const py::object high = interval.high ? number(*interval.high) : py::object(py::none());
        resisted.append(py::make_tuple(number(interval.low), high));
      }
      result["resisted"] = py::tuple(resisted);
    }
    return result;
  }
  py::dict operator()(const stickslip_check::Rejected& r) const {
    py::dict result("accepted"_a = false, "rule"_a = text(r.rule), "path"_a = text(r.path),
                    "found"_a = text(r.found));
    if (r.node) result["node"] = *r.node;
    return result;
  }
  py::dict operator()(const stickslip_check::Malformed& m) const {
    throw InputError(m.file == "the question" ? "" : m.file, m.place, m.problem, "");
  }
  py::dict operator()(const stickslip_check::NotJudged& given_up) const {
    throw LimitError(Undecided{given_up.why});
  }
};

py::dict check(const std::string& grasp, const std::string& certificate,
               const py::object& wrench, const py::object& preload, bool bilateral,
               const py::object& direction, const py::object& preload_direction,
               const py::object& plane, const py::object& inertia, const std::string& uncertain,
               const std::string& max_motion, const std::string& grasp_name,
               const std::string& certificate_name, const py::object& statics,
               const std::vector<std::string>& others) {
  const QuestionOptions asked = question_options(
      py::dict("preload"_a = preload, "preload_direction"_a = preload_direction));
  stickslip_check::Options options;
  options.bilateral = bilateral;
  // Rows have three numbers, or six, or of several bodies one for each coordinate.
  const auto read = [](const py::object& values, const char* name) {
    std::optional<stickslip_check::Vector> result;
    if (values.is_none()) return result;
    result.emplace();
    for (const Rational& component : numbers(values, 0, name)) {
      result->push_back(for_checker(component));
    }
    return result;
  };
  options.wrench = read(wrench, "wrench");
  options.direction = read(direction, "direction");
  options.inertia = read(inertia, "inertia");
  if (options.inertia && options.inertia->size() == 6) options.inertia->resize(9);
  if (!statics.is_none()) options.statics = for_checker(exact(statics, "statics"));
  if (!plane.is_none()) {
    options.plane.emplace();
    for (const py::handle& along : plane) {
      options.plane->push_back(*read(py::reinterpret_borrow<py::object>(along), "plane"));
    }
  }
  if (asked.preload_direction) {
    options.preload_direction = for_checker(*asked.preload_direction);
  }
  if (asked.preload) options.preload = for_checker(*asked.preload);
  std::vector<std::string> spelled;
  if (!uncertain.empty()) spelled.insert(spelled.end(), {"--uncertain", uncertain});
  if (!max_motion.empty()) spelled.insert(spelled.end(), {"--max-motion", max_motion});
  spelled.insert(spelled.end(), others.begin(), others.end());
  if (!spelled.empty()) {
    spelled.insert(spelled.end(), {"grasp", "certificate"});
    try {
      const stickslip_check::Options read_here =
          stickslip_check::parse_arguments(spelled).options;
      options.uncertain = read_here.uncertain;
      options.max_motion = read_here.max_motion;
      options.states = read_here.states;
      options.robustness = read_here.robustness;
      options.length = read_here.length;
      options.max_force = read_here.max_force;
    } catch (const stickslip_check::UsageError& error) {
      throw InputError("", "", error.problem, "");
    }
  }
  const stickslip_check::Answer answer = without_gil([&] {
    std::istringstream grasp_stream(grasp);
    std::istringstream certificate_stream(certificate);
    return stickslip_check::check(grasp_stream, certificate_stream, options, grasp_name,
                                  certificate_name);
  });
  return std::visit(ToDict{}, answer);
}

}  // namespace

void bind_check(py::module_& module) {
  module.def("check", &check);
}

}  // namespace stickslip::python
