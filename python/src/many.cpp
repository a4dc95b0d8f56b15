// SPDX-License-Identifier: GPL-3.0-or-later
// Many questions in one call.
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <pybind11/numpy.h>

#include <limits>
#include <memory>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

/// Answers that become Python values only when they are looked at.
struct Decisions {
  struct Answer {
    std::shared_ptr<const GraspFile> grasp;
    QuestionOptions asked;
    Decision decision;
  };
  std::vector<Answer> answers;
};

/// Entry i of a list with an entry for each question, or with one for all of them.
template <class List>
const auto& entry(const List& list, std::size_t i) {
  return list[list.size() == 1 ? 0 : i];
}

/// Calls work(i) for all i below `count`, in parallel. Throws what the first i that throws
/// does.
template <class Work>
void for_all(std::size_t count, std::size_t threads, Work work) {
  using oneapi::tbb::global_control;
  std::optional<global_control> allowed;  // more than there are cores, without a warning
  if (threads > 0) allowed.emplace(global_control::max_allowed_parallelism, threads);
  oneapi::tbb::task_arena arena(threads == 0 ? oneapi::tbb::task_arena::automatic
                                             : static_cast<int>(threads));
  std::vector<std::exception_ptr> thrown(count);
  Cancellation* const cancellation = Cancellation::current();
  arena.execute([&] {
    oneapi::tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      const SharedCancellation shared(cancellation);
      throw_if_cancelled();
      try {
        work(i);
      } catch (const InputError&) {
        thrown[i] = std::current_exception();
      }
    });
  });
  for (const std::exception_ptr& error : thrown) {
    if (error) std::rethrow_exception(error);
  }
}

/// Each list has one entry for all questions or one for each; of the last three an empty one
/// leaves the grasps' own.
Decisions decide_many(std::size_t count, const py::list& given_grasps, const py::list& wrenches,
                      const py::list& frictions, const py::list& preloads, bool bilateral,
                      const std::string& engine, std::size_t node_limit, std::size_t threads) {
  std::vector<std::shared_ptr<const GraspFile>> grasps;
  for (const py::handle grasp : given_grasps) {
    grasps.push_back(grasp.cast<std::shared_ptr<GraspFile>>());
  }
  std::vector<QuestionOptions> asked(count);
  const py::object none = py::none();
  std::vector<std::vector<Rational>> friction;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    friction.push_back(numbers(frictions[i], entry(grasps, i)->content.grasp.size(),
                               "friction[" + std::to_string(i) + "]"));
  }
  const auto of = [&](const py::list& list, std::size_t i) -> py::object {
    return list.empty() ? none : py::object(list[list.size() == 1 ? 0 : i]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    asked[i] = question_options(of(wrenches, i), of(preloads, i), bilateral, none, none,
                                "[" + std::to_string(i) + "]");
  }
  return without_gil([&] {
    ConeOptions options;
    options.node_limit = node_limit;
    std::vector<std::optional<Decisions::Answer>> answers(count);
    for_all(count, threads, [&](std::size_t i) {
      try {
        std::shared_ptr<const GraspFile> grasp = entry(grasps, i);
        if (!friction.empty()) {
          grasp = std::make_shared<GraspFile>(with_friction(*grasp, entry(friction, i)));
        }
        const Question question = question_of(*grasp, asked[i]);
        Decision decision =
            decide(Problem(question.loaded, question.law), engine_named(engine), options);
        answers[i] = Decisions::Answer{std::move(grasp), asked[i], std::move(decision)};
      } catch (const InputError& error) {
        throw InputError("", "question " + std::to_string(i) + ", " + error.place(),
                         error.problem(), error.remedy());
      }
    });
    Decisions result;
    for (std::optional<Decisions::Answer>& answer : answers) {
      result.answers.push_back(std::move(*answer));
    }
    return result;
  });
}

/// The grasp that was asked about, with the friction of the question, and the fields of
/// results.Decision.
py::tuple decision_at(const Decisions& decisions, std::size_t i) {
  const auto& [grasp, asked, decision] = decisions.answers.at(i);
  const Question question = question_of(*grasp, asked);
  return py::make_tuple(
      *grasp, decision_fields(question, Problem(question.loaded, question.law), decision,
                              certificate_of(question, decision)));
}

py::list verdicts(const Decisions& decisions) {
  py::list result;
  for (const Decisions::Answer& answer : decisions.answers) {
    result.append(name_of(answer.decision.verdict));
  }
  return result;
}

/// One row of three for each question; NaN where there is no motion.
py::array_t<double> twists(const Decisions& decisions) {
  const auto count = static_cast<py::ssize_t>(decisions.answers.size());
  py::array_t<double> result({count, py::ssize_t{3}});
  auto rows = result.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < count; ++i) {
    const Verdict& verdict = decisions.answers[static_cast<std::size_t>(i)].decision.verdict;
    const auto* stable = std::get_if<Stable>(&verdict);
    for (py::ssize_t j = 0; j < 3; ++j) {
      rows(i, j) =
          stable == nullptr
              ? std::numeric_limits<double>::quiet_NaN()
              : to_double(coordinates(stable->witness.twist)[static_cast<std::size_t>(j)]);
    }
  }
  return result;
}

}  // namespace

void bind_many(py::module_& module) {
  py::class_<Decisions>(module, "DecisionsData")
      .def("size", [](const Decisions& d) { return d.answers.size(); })
      .def("at", &decision_at)
      .def("verdicts", &verdicts)
      .def("twists", &twists);
  module.def("decide_many", &decide_many);
}

}  // namespace stickslip::python
