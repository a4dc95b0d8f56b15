// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures, resistible regions, other methods, and the question for other solvers.
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/answer.hpp"
#include "stickslip/interfaces/grasp_plot.hpp"
#include "stickslip/interfaces/html.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/region_plot.hpp"
#include "stickslip/interfaces/states_plot.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

py::tuple point(const PlanePoint& p) {
  return fractions(p[0], p[1]);
}

py::tuple direction(const PlaneDirection& d) {
  return fractions(Rational(d[0]), Rational(d[1]));
}

py::object direction_or_none(const std::optional<PlaneDirection>& d) {
  return d ? py::object(direction(*d)) : py::object(py::none());
}

/// Returns the arguments of results.Outline.
py::tuple outline(const Outline& o) {
  return py::make_tuple(tuple_of(o.vertices, point), direction_or_none(o.from),
                        direction_or_none(o.to));
}

/// Returns the arguments of results.Cell.
py::tuple cell(const PlaneCell& c) {
  return py::make_tuple(tuple_of(c.vertices(), point), tuple_of(c.rays(), direction));
}

/// Returns the arguments of results.Piece.
py::tuple piece(const ResistiblePiece& p) {
  return py::make_tuple(
      slips_text(p.modes),
      tuple_of(p.modes, [](const ContactMode& mode) { return py::bool_(mode.closed); }),
      cell(p.cell));
}

WrenchPlane plane(const py::list& origin, const py::list& u, const py::list& v) {
  return {exact_wrench(origin, "origin"), exact_wrench(u, "u"), exact_wrench(v, "v")};
}

py::object region(const GraspFile& grasp, const py::list& origin, const py::list& u,
                  const py::list& v, const py::object& preload, bool bilateral,
                  std::size_t mode_limit, bool with_pieces, bool certificate,
                  std::size_t node_limit, bool picture) {
  struct Found {
    RegionAnswer answer;
    std::string certificate{};
    std::string picture{};
  };
  QuestionOptions asked = question_options(py::none(), preload, bilateral);
  asked.wrench = RationalRow(3);  // the plane stands for all loads of the grasp
  const WrenchPlane where = plane(origin, u, v);
  const Found found = without_gil([&] {
    RegionOptions options;
    options.modes.pieces = with_pieces;
    options.modes.mode_limit = mode_limit;
    options.proof.node_limit = node_limit;
    Found result{region_answer(question_of(grasp, asked), where, options)};
    RegionAnswer& answer = result.answer;
    if (certificate && !answer.undecided) {
      auto proved = certificate_of(answer, options);
      if (auto* undecided = std::get_if<Undecided>(&proved)) {
        answer.undecided = std::move(*undecided);
      } else {
        result.certificate = std::get<std::string>(std::move(proved));
      }
    }
    if (picture && !answer.undecided) {
      result.picture = plot_region(answer.question, where, answer.found.region);
    }
    return result;
  });
  const RegionAnswer& answer = found.answer;
  if (answer.undecided) return py::dict("limit"_a = answer.undecided->limit);
  if (picture) return text(found.picture);
  const PlaneUnion& all = answer.found.region;
  const py::dict stats("nodes"_a = answer.work.nodes, "borders"_a = answer.work.borders,
                       "modes"_a = answer.work.modes, "pieces"_a = answer.work.pieces);
  py::dict result(
      "areas"_a = tuple_of(
          all.areas, [](const PlaneArea& area) { return tuple_of(area.outlines, outline); }),
      "curves"_a = tuple_of(all.curves, cell), "points"_a = tuple_of(all.points, point),
      "pieces"_a = tuple_of(answer.found.pieces, piece), "origin"_a = fractions(where.origin()),
      "u"_a = fractions(where.u()), "v"_a = fractions(where.v()),
      "whole_plane"_a = all.is_whole_plane(), "stats"_a = stats);
  if (asked.preload) result["preload"] = fraction(*asked.preload);
  if (certificate) result["certificate"] = text(found.certificate);
  return std::move(result);
}

/// Returns a picture. `limit` is that of an answer that is known to be undecided; then nothing
/// is decided again.
py::str grasp_picture(const GraspFile& grasp, const py::object& wrench,
                      const py::object& preload, bool bilateral, const std::string& engine,
                      const std::optional<std::string>& limit) {
  const QuestionOptions asked = question_options(wrench, preload, bilateral);
  return text(without_gil([&] {
    const Question question = question_about(grasp, asked);
    if (limit) return plot_grasp(question, Undecided{*limit});
    SearchOptions options = to_draw();
    if (engine != "auto") options.engine = engine_named(engine);
    return plot_grasp(question, decide(question, options).verdict);
  }));
}

/// Returns a page. Numbers are spelled as on a command line; a time limit of 0 is none.
py::str page(const GraspFile& grasp, const std::string& wrench, const std::string& case_name,
             const std::string& preload, bool bilateral, const std::string& uncertain,
             std::size_t node_limit, double time_limit) {
  QuestionText asked;
  asked.wrench = wrench;
  asked.case_name = case_name;
  asked.preload = preload;
  if (bilateral) asked.normal_law = "bilateral";
  asked.uncertain = uncertain;
  PageLimits limits;
  limits.node_limit = node_limit;
  limits.time = std::chrono::milliseconds(static_cast<std::int64_t>(1000 * time_limit));
  try {
    return text(
        without_gil([&] { return page_html(page_answer(grasp, asked, {}, limits, "grasp")); }));
  } catch (const InputError& error) {
    // The place is spelled in the words of a command line.
    const std::string& place = error.place();
    if (place.rfind("--", 0) != 0) throw;
    throw InputError(error.file(), place.substr(2), error.problem(), error.remedy());
  }
}

py::str states_picture(const GraspFile& grasp) {
  return text(without_gil([&] { return plot_states(grasp.loaded().grasp); }));
}

py::str smtlib(const GraspFile& grasp, const py::object& wrench, const py::object& preload,
               bool bilateral) {
  const QuestionOptions asked = question_options(wrench, preload, bilateral);
  return text(without_gil([&] { return smtlib_text(question_in_box(grasp, asked)); }));
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("region", &region);
  module.def("plot_grasp", &grasp_picture);
  module.def("plot_states", &states_picture);
  module.def("page", &page);
  module.def("smtlib", &smtlib);
}

}  // namespace stickslip::python
