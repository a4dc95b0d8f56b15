// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of a batch for stickslip.batch (interfaces/line.hpp).
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/line.hpp"
#include "stickslip/interfaces/question_text.hpp"
#include "stickslip/interfaces/results.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

constexpr const char* kGraspLines = "a file of grasps, one a line";

/// The name of a set of states, lines of slip, whether they are snapped, and a limit.
using AskedStates = std::tuple<std::string, std::size_t, bool, std::size_t>;
/// The words of methods, and the values of --length, --inertia, --max-force, --accuracy and
/// --edges.
using AskedMeasures = std::tuple<std::vector<std::string>, std::string, std::string,
                                 std::string, std::string, std::size_t>;

/// Makes a decider. Values are as the command line spells them; an option that is not given is
/// empty.
LineDecider make_decider(const std::string& wrench, const std::string& case_name,
                         const std::string& preload, bool bilateral, std::size_t node_limit,
                         bool asks_class, const std::string& inertia,
                         const std::string& certificates, const std::string& certificate_folder,
                         const std::optional<std::array<std::string, 5>>& quality,
                         const std::optional<AskedStates>& states,
                         const std::optional<AskedMeasures>& measures) {
  BatchOptions options;
  QuestionText asked;
  asked.wrench = wrench;
  asked.case_name = case_name;
  asked.preload = preload;
  options.question = question_options(asked);
  options.question.law = bilateral ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  options.node_limit = node_limit;
  if (asks_class) options.inertia = inertia_numbers("--inertia", inertia);
  if (quality) {
    const auto& [length, about, body, at_most, accuracy] = *quality;
    options.quality = quality_asked({length, about, body, at_most, accuracy});
  }
  if (states) {
    const auto& [set, lines, snap, limit] = *states;
    options.states = {state_set_named(set), {lines, snap, {}}, limit};
  }
  if (measures) {
    const auto& [methods, length, inertia_text, max_force, accuracy, edges] = *measures;
    options.measures =
        comparison_asked({methods, length, inertia_text, max_force, accuracy, edges});
  }
  options.certificates = certificates;
  options.certificate_folder = certificate_folder;
  return LineDecider(options);
}

/// Returns the results of the lines of `file` that begin at its bytes from `begin` to before
/// `end`, as they stand in the file of results, and their tally.
std::pair<py::bytes, BatchTally> decide(const LineDecider& decider, const std::string& file,
                                        std::uintmax_t begin, std::uintmax_t end,
                                        std::size_t lines_before) {
  BatchTally tally;
  const std::string results = without_gil([&] {
    InputFile in(file, kGraspLines);
    BatchLines lines(in.stream(), {begin, end, lines_before});
    std::string text;
    while (const std::optional<BatchLine> line = lines.next()) {
      throw_if_cancelled();
      const LineResult result = decider.decide(*line);
      text += result.text;
      tally.count(result.number, result.outcome);
    }
    return text;
  });
  return {py::bytes(results), tally};
}

/// Returns the result that line `number`, which begins at that byte, has in place of a verdict.
py::bytes failed(const LineDecider& decider, const std::string& file, std::uintmax_t begin,
                 std::size_t number, const std::string& problem, const std::string& remedy) {
  InputFile in(file, kGraspLines);
  const std::optional<BatchLine> line =
      BatchLines(in.stream(), {begin, begin + 1, number - 1}).next();
  if (!line) throw InputError(file, "line " + std::to_string(number), "it is gone", "");
  return decider.failed(*line, InputError("", "", problem, remedy)).text;
}

/// Returns the work that the results in `output` leave: their tally and bytes, where in `file`
/// the first line without a result begins, after how many lines, and a note.
py::tuple skip(const LineDecider& decider, const std::string& file, const std::string& output) {
  BatchTally tally;
  std::string note;
  std::uintmax_t bytes = 0;
  std::uintmax_t begin = 0;
  std::size_t lines_before = 0;
  without_gil([&] {
    InputFile in(file, kGraspLines);
    InputFile results_in(output, "a file of results");
    BatchLines lines(in.stream());
    FinishedResults results(results_in.stream(), output);
    tally = skip_finished(results, output, lines, file, decider);
    note = changed_note(results, output);
    bytes = results.bytes();
    begin = lines.end();
    lines_before = lines.number();
  });
  return py::make_tuple(tally, bytes, begin, lines_before, text(note));
}

}  // namespace

void bind_batch(py::module_& module) {
  py::class_<BatchTally>(module, "BatchTally")
      .def(py::init<>())
      .def_readonly("results", &BatchTally::results)
      .def_readonly("undecided", &BatchTally::undecided)
      .def_readonly("unreadable", &BatchTally::unreadable)
      .def("add", &BatchTally::add)
      .def("count_unreadable",
           [](BatchTally& tally, std::size_t line) {
             tally.count(line, LineOutcome::kUnreadable);
           })
      .def("complaint", [](const BatchTally& tally,
                           const std::string& name) { return text(tally.complaint(name)); })
      .def(py::pickle(
          [](const BatchTally& t) {
            return py::make_tuple(t.results, t.undecided, t.unreadable, t.first_unreadable);
          },
          [](const py::tuple& t) {
            return BatchTally{t[0].cast<std::size_t>(), t[1].cast<std::size_t>(),
                              t[2].cast<std::size_t>(), t[3].cast<std::size_t>()};
          }));
  py::class_<LineDecider>(module, "LineDecider")
      .def(py::init(&make_decider))
      .def("decide", &decide)
      .def("failed", &failed)
      .def("skip", &skip);
  module.def("open_certificate_folder", &open_certificate_folder);
}

}  // namespace stickslip::python
