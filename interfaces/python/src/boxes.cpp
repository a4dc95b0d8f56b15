// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about all grasps in a box, in the plane and in space.
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/map_plot.hpp"
#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/map.hpp"
#include "stickslip/measures/radius.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

py::tuple middles(const WrenchBox& wrench) {
  return tuple_of(wrench, [](const Interval& w) { return fraction(w.middle()); });
}

/// Returns the question about a grasp with the tolerances `uncertain`, spelled as in
/// --uncertain.
Question asked_of(const GraspFile& grasp, const py::object& wrench, const py::object& preload,
                  bool bilateral, const std::string& uncertain, const std::string& max_motion) {
  return question_in_box(grasp, bounded_options(wrench, preload, bilateral, max_motion),
                         uncertain);
}

py::dict fields_of(const Question& asked, const char* verdict, const py::object& preload) {
  py::dict result("verdict"_a = verdict, "normal_law"_a = to_string(asked.law),
                  "wrench"_a = middles(wrench_of(asked.grasp)));
  if (!preload.is_none()) result["preload"] = fraction(exact(preload, "preload"));
  return result;
}

/// Decides a box. Irrational lengths or a bound on motions are enough to make one.
py::dict decide_box_of(const GraspFile& grasp, const std::string& uncertain,
                       const py::object& wrench, const py::object& preload, bool bilateral,
                       std::size_t node_limit, const std::string& max_motion) {
  const Question asked = asked_of(grasp, wrench, preload, bilateral, uncertain, max_motion);
  const GraspBox box = box_of(asked.grasp);
  if (box.is_point() && !box.is_bounded() && !needs_enclosure(box)) refuse_certain();
  SearchOptions options;
  options.node_limit = node_limit;
  const auto [decision, proofs] = without_gil([&] {
    BoxDecision found = decide_box(box, asked.law, options);
    auto proved = proved_decision(box, asked.law, found, producer_of(box_engine(asked)));
    return std::pair(std::move(found), std::move(proved));
  });
  py::dict result = fields_of(asked, name_of(decision.verdict), preload);
  result["engine"] = box_engine(asked);
  add_files(result, proofs);
  if (const auto* undecided = std::get_if<Undecided>(&decision.verdict)) {
    add_undecided(result, *undecided);
  }
  result["stats"] = stats(decision.work);
  return result;
}

Rational accuracy_of(const py::object& value) {
  Rational accuracy = exact(value, "accuracy");
  if (accuracy.sign() > 0 && accuracy < 1) return accuracy;
  throw InputError("", "accuracy", "the value is " + to_string(accuracy),
                   "it is a part of the radius: give more than 0 and less than 1");
}

py::dict radius(const GraspFile& grasp, const std::string& uncertain, const py::object& wrench,
                const py::object& preload, bool bilateral, const py::object& accuracy,
                std::size_t node_limit, const std::string& max_motion) {
  RadiusOptions options;
  options.box.node_limit = node_limit;
  options.accuracy = accuracy_of(accuracy);
  const Question asked = asked_of(grasp, wrench, preload, bilateral, uncertain, max_motion);
  const GraspBox box = box_of(asked.grasp);
  if (box.is_point()) refuse_certain();
  const auto [found, proofs] = without_gil([&] {
    const GraspBox centre = box.middle();
    Radius radius = find_radius(centre, box, asked.law, options);
    std::vector<ProvedFiles> proved;
    if (radius.stable) {
      proved = proved_radius(centre, box, asked.law, radius, producer_of(box_engine(asked)));
    }
    return std::pair(std::move(radius), std::move(proved));
  });
  py::dict result = fields_of(asked, verdict_name(found.stable), preload);
  result["proved"] = fraction(found.proved);
  result["limit"] = fraction(found.limit);
  if (!proofs.empty()) result["proof"] = files(proofs[0]);
  if (found.refuted) {
    result["refuted"] = fraction(*found.refuted);
    result["counterexample"] = files(proofs[1]);
  }
  return result;
}

py::dict quality(const GraspFile& grasp, const py::object& length, const py::object& about,
                 const std::string& body, const py::object& wrench, const py::object& preload,
                 bool bilateral, const py::object& at_most, const py::object& accuracy,
                 std::size_t node_limit, const std::string& max_motion) {
  QualityOptions options;
  options.radius.box.node_limit = node_limit;
  options.radius.accuracy = accuracy_of(accuracy);
  const auto positive = [](const py::object& value, const char* name) {
    Rational number = exact(value, name);
    if (number.sign() > 0) return number;
    throw InputError("", name, "the value is " + to_string(number), "give a number above 0");
  };
  if (!at_most.is_none()) options.at_most = positive(at_most, "at_most");
  LoadBall shape{1};
  shape.length = positive(length, "length");
  if (!about.is_none()) shape.set_about(numbers(about, 0, "about"));
  shape.body = body;
  const Question asked =
      question_about(grasp, bounded_options(wrench, preload, bilateral, max_motion));
  const auto [found, proofs] = without_gil([&] {
    Quality known = find_quality(box_of(asked.grasp), asked.law, shape, options);
    std::vector<std::pair<std::string, ProvedFiles>> proved;
    if (known.stable) proved = proved_quality(asked, known);
    return std::pair(std::move(known), std::move(proved));
  });
  py::dict result = fields_of(asked, verdict_name(found.stable), preload);
  result["length"] = fraction(shape.length);
  result["proved"] = fraction(found.proved);
  result["limit"] = fraction(found.limit);
  result["scales"] = found.scales;
  if (found.refuted) result["refuted"] = fraction(*found.refuted);
  if (found.stable == true && found.radii.example) {
    result["not_resisted"] = middles(found.radii.example->wrench);
  }
  for (const auto& [name, proof] : proofs) {
    result[name == "proved" ? "proof" : "counterexample"] = files(proof);
  }
  return result;
}

/// Returns the arguments of results.MapCell, but the proof's law.
py::tuple map_cell(const MapCell& cell, const std::optional<ProvedFiles>& proof) {
  const auto ends = [](const Interval& interval) {
    return fractions(interval.low, interval.high);
  };
  return py::make_tuple(ends(cell.x), ends(cell.y), name_of(cell.decision.verdict),
                        proof ? py::object(files(*proof)) : py::object(py::none()));
}

py::dict map(const GraspFile& grasp, const std::string& x_text, const std::string& y_text,
             const std::string& uncertain, const py::object& wrench, const py::object& preload,
             bool bilateral, unsigned depth, std::size_t node_limit, bool proofs,
             const std::string& max_motion) {
  // A map of a grasp in the plane needs rational lengths.
  const Question asked =
      question_about(grasp, bounded_options(wrench, preload, bilateral, max_motion));
  const GraspBox centre = box_of(asked.grasp);
  const MapAxis x = parse_axis(centre, x_text, "x");
  const MapAxis y = parse_axis(centre, y_text, "y");
  MapOptions options;
  options.depth = depth;
  options.box.node_limit = node_limit;
  if (!uncertain.empty()) options.uncertain = parse_tolerances(uncertain);
  std::vector<MapCell> cells;
  std::vector<std::optional<ProvedFiles>> proved;
  const std::string picture = without_gil([&] {
    map_verdicts(centre, asked.law, x, y, options, [&](MapCell cell) {
      proved.emplace_back();
      if (proofs && !std::holds_alternative<Undecided>(cell.decision.verdict)) {
        proved.back() = proved_box(box_of_cell(centre, x, y, cell.x, cell.y, options.uncertain),
                                   asked.law, cell.decision, producer_of(box_engine(asked)));
      }
      cells.push_back(std::move(cell));
    });
    return plot_map(asked.description().name, x, y, cells);
  });
  py::tuple rows(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) rows[k] = map_cell(cells[k], proved[k]);
  py::dict result("cells"_a = rows, "picture"_a = picture,
                  "normal_law"_a = to_string(asked.law), "wrench"_a = middles(centre.wrench));
  if (!preload.is_none()) result["preload"] = fraction(exact(preload, "preload"));
  return result;
}

}  // namespace

void bind_boxes(py::module_& module) {
  module.def("decide_box", &decide_box_of);
  module.def("radius", &radius);
  module.def("quality", &quality);
  module.def("stability_map", &map);
}

}  // namespace stickslip::python
