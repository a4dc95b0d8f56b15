// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "stickslip/earlier/friction_margin.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

Inertia inertia_from(const py::object& given, bool in_space = false) {
  return inertia_of("inertia", numbers(given, 0, "inertia"), in_space);
}

struct Compared {
  Comparison comparison;
  std::string certificate{};
  std::string limit{};
};

/// Returns the fields of results.Method for each, the evidence as JSON; the class of the load;
/// and the certificate of the class, if it is wanted, or why there is none.
py::dict compare(const GraspFile& grasp, const py::object& wrench, const py::object& preload,
                 bool bilateral, std::vector<std::string> methods, const py::object& length,
                 const py::object& inertia, bool certificate, const std::string& max_motion) {
  const QuestionOptions asked = bounded_options(wrench, preload, bilateral, max_motion);
  CompareOptions options;
  options.methods = std::move(methods);
  options.length = exact(length, "length");
  if (options.length.sign() <= 0) {
    throw InputError("", "length", "the value is " + to_string(options.length),
                     "a characteristic length must be above 0");
  }
  const bool space = in_space(grasp.content);
  options.inertia = inertia.is_none() ? Inertia::of_length(options.length, space)
                                      : inertia_from(inertia, space);
  const Compared found = without_gil([&] {
    NumberText readable(false);
    const Question question = space ? question_in_box(grasp, asked) : question_of(grasp, asked);
    std::optional<RigidVerdict> verdict;
    const Question of_all = without_bound(question);  // classes are about all motions
    if (certificate) verdict = rigid_verdict(of_all, options.inertia);
    options.verdict = verdict ? &*verdict : nullptr;
    Compared result{compare_methods(question, options, readable)};
    if (!verdict) return result;
    if (const auto* undecided = std::get_if<Undecided>(&*verdict)) {
      result.limit = undecided->limit;
    } else {
      result.certificate = class_certificate_text(of_all, options.inertia, *verdict,
                                                  "stickslip " STICKSLIP_VERSION);
    }
    return result;
  });
  py::list rows;
  for (const MethodRow& row : found.comparison.methods) {
    rows.append(py::make_tuple(text(row.method), text(row.source), row.about_the_load,
                               text(row.verdict),
                               row.agrees ? py::object(py::bool_(*row.agrees)) : py::none(),
                               text(row.why), text(finished(row.evidence, false).dump())));
  }
  py::dict result;
  const auto& known = found.comparison.load_class;
  result["methods"] = rows;
  result["load_class"] = known ? py::object(text(*known)) : py::none();
  if (!found.certificate.empty()) result["certificate"] = text(found.certificate);
  if (!found.limit.empty()) result["limit"] = text(found.limit);
  return result;
}

/// Returns the fields of results.ClassRange for each; or the limit at which they are not known.
py::object classes(const GraspFile& grasp, const py::object& direction,
                   const py::object& wrench, const py::object& inertia) {
  QuestionOptions asked = question_options(wrench, py::none(), false, direction);
  asked.preload = 0;  // contacts are rigid
  const Inertia mass = inertia_from(inertia);
  const auto found =
      without_gil([&] { return class_margin(problem_of(question_of(grasp, asked)), mass); });
  if (const auto* undecided = std::get_if<Undecided>(&found)) return text(undecided->limit);
  return tuple_of(std::get<std::vector<ClassRange>>(found), [](const ClassRange& range) {
    return py::make_tuple(text(to_string(range.rigid_class)), fraction(range.low),
                          fraction_or_none(range.high), range.has_low, range.has_high);
  });
}

/// Returns tuples of results.ClassRange: which factors of all friction are of which class.
py::tuple factors(const GraspFile& grasp, const py::object& wrench, const py::object& inertia,
                  const py::object& accuracy) {
  QuestionOptions asked = question_options(wrench, py::none(), false);
  asked.preload = 0;  // contacts are rigid
  const Inertia mass = inertia_from(inertia);
  const Rational part = exact(accuracy, "accuracy");
  if (part.sign() <= 0) {
    throw InputError("", "accuracy", "the value is " + to_string(part),
                     "give a number above 0, such as 1/1000");
  }
  const auto found = without_gil(
      [&] { return friction_margin(problem_of(question_of(grasp, asked)), mass, part); });
  return tuple_of(found, [](const FactorRange& range) {
    const auto& kind = range.rigid_class;
    return py::make_tuple(kind ? py::object(text(to_string(*kind))) : py::object(py::none()),
                          fraction(range.low), fraction_or_none(range.high), range.has_low,
                          range.has_high);
  });
}

}  // namespace

void bind_compare(py::module_& module) {
  module.def("compare", &compare);
  module.def("class_margin", &classes);
  module.def("friction_margin", &factors);
}

}  // namespace stickslip::python
