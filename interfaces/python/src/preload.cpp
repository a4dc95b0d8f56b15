// SPDX-License-Identifier: GPL-3.0-or-later
// The best preloads, in the plane, in space and of several bodies.
#include "stickslip/measures/preload.hpp"

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/preload_answer.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

struct FoundPreload {
  std::optional<RationalRow> preloads;
  std::optional<Rational> bound;
  PreloadRange range;
  std::vector<std::pair<std::string, ProvedFiles>> proofs;
  std::vector<ModelWarning> warnings;
  std::optional<Rational> radius{};
  std::optional<Rational> refuted{};
};

FoundPreload least_sum(const std::vector<Question>& asked, const PreloadOptions& options) {
  const NormalLaw law = asked.front().law;
  const LeastPreload least = find_least_preload(loads_of(asked, ""), law, options);
  FoundPreload found{least.preloads, least.bound, least.range, proved_preload(law, least), {}};
  if (least.preloads) found.warnings = unbalanced(least.held.front().box, law);
  return found;
}

FoundPreload largest_ball(const Question& asked, const LoadBall& shape, const Rational& budget,
                          const PreloadOptions& options) {
  const GraspBox grasp = loads_of({asked}, "").front();
  const BallPreload ball = find_ball_preload(grasp, asked.law, shape, budget, options);
  const bool holds = ball.quality.stable == true;
  FoundPreload found{std::nullopt, ball.bound, ball.range, proved_preload(asked, ball), {}};
  if (!holds) return found;
  found.preloads = ball.preloads;
  found.warnings = unbalanced(ball.quality.ball, asked.law);
  found.radius = ball.quality.proved;
  found.refuted = ball.quality.refuted;
  return found;
}

/// Finds the best preloads; with a budget, those under the first load alone.
py::dict best_preload(const GraspFile& grasp, const py::list& loads, const py::object& budget,
                      const std::string& uncertain, const py::object& length,
                      const py::list& about, const std::string& body, bool balanced,
                      bool bilateral, const py::object& accuracy, std::size_t boxes,
                      std::size_t node_limit, const std::string& max_motion) {
  PreloadOptions options;
  options.box.node_limit = node_limit;
  options.most_boxes = boxes;
  options.balanced = balanced;
  options.accuracy = exact(accuracy, "accuracy");
  if (options.accuracy.sign() <= 0 || options.accuracy >= 1) {
    throw InputError("", "accuracy", "the value is " + to_string(options.accuracy),
                     "it is a part of the sum or the radius: give more than 0 and less than 1");
  }
  std::vector<Question> asked;
  for (const py::handle& load : loads) {
    asked.push_back(question_in_box(grasp,
                                    bounded_options(py::reinterpret_borrow<py::object>(load),
                                                    py::none(), bilateral, max_motion),
                                    uncertain));
  }
  FoundPreload found;
  if (budget.is_none()) {
    found = without_gil([&] { return least_sum(asked, options); });
  } else {
    const Rational most = exact(budget, "budget");
    if (most.sign() <= 0) {
      throw InputError("", "budget", "the value is " + to_string(most),
                       "it is the sum of preloads: give a number above 0");
    }
    LoadBall shape{1, exact(length, "length")};
    shape.set_about(numbers(about, 0, "about"));
    shape.body = body;
    found = without_gil([&] { return largest_ball(asked.front(), shape, most, options); });
  }
  py::dict proofs;
  for (const auto& [name, proved] : found.proofs) proofs[name.c_str()] = files(proved);
  py::dict result("bound"_a = fraction_or_none(found.bound),
                  "multiples"_a = tuple_of(found.range.multiples,
                                           [](const MarginInterval& i) {
                                             return py::make_tuple(fraction(i.low),
                                                                   fraction_or_none(i.high));
                                           }),
                  "each_for_itself"_a = !found.range.boxes.empty(), "proofs"_a = proofs,
                  "warnings"_a = warning_fields(found.warnings),
                  "normal_law"_a = to_string(asked.front().law));
  result["preloads"] =
      found.preloads ? py::object(tuple_of(*found.preloads, fraction)) : py::object(py::none());
  result["radius"] = fraction_or_none(found.radius);
  result["refuted"] = fraction_or_none(found.refuted);
  return result;
}

}  // namespace

void bind_preload(py::module_& module) {
  module.def("best_preload", &best_preload);
}

}  // namespace stickslip::python
