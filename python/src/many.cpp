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

struct Decisions {
  std::vector<ManyAnswer> answers;
  std::size_t coordinates;  ///< of a motion
};

/// \{ Entry i of a list with an entry for each question, or with one for all of them.
template <class Value>
const Value& entry(const std::vector<Value>& list, std::size_t i) {
  return list[list.size() == 1 ? 0 : i];
}
py::object entry(const py::list& list, std::size_t i) {
  return list[list.size() == 1 ? 0 : i];
}
/// \}

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
/// leaves the grasps' own. The grasps are all in the plane, or all in space.
Decisions decide_many(std::size_t count, const py::list& grasps, const py::list& wrenches,
                      const py::list& frictions, const py::list& preloads, bool bilateral,
                      const std::string& engine, std::size_t node_limit, std::size_t threads) {
  const auto of = [](const py::list& list, std::size_t i) -> py::object {
    return list.empty() ? py::object(py::none()) : entry(list, i);
  };
  const bool in_space = !grasps.empty() && !py::isinstance<GraspFile>(grasps[0]);
  std::vector<std::vector<Rational>> friction;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    friction.push_back(numbers(frictions[i],
                               entry(grasps, i).attr("size")().cast<std::size_t>(),
                               "friction[" + std::to_string(i) + "]"));
  }
  std::vector<std::function<ManyAnswer()>> questions;
  for (std::size_t i = 0; i < count; ++i) {
    const OneOfMany asked{of(wrenches, i), of(preloads, i),
                          friction.empty() ? nullptr : &entry(friction, i),
                          "[" + std::to_string(i) + "]"};
    questions.push_back((in_space ? spatial_question : planar_question)(
        entry(grasps, i), asked, bilateral, engine, node_limit));
  }
  return without_gil([&] {
    Decisions result{std::vector<ManyAnswer>(count), in_space ? std::size_t{6} : 3};
    for_all(count, threads, [&](std::size_t i) {
      try {
        result.answers[i] = questions[i]();
      } catch (const InputError& error) {
        throw InputError("", "question " + std::to_string(i) + ", " + error.place(),
                         error.problem(), error.remedy());
      }
    });
    return result;
  });
}

py::tuple decision_at(const Decisions& decisions, std::size_t i) {
  return decisions.answers.at(i).whole();
}

py::list verdicts(const Decisions& decisions) {
  py::list result;
  for (const ManyAnswer& answer : decisions.answers) result.append(answer.verdict);
  return result;
}

/// One row for each question; NaN where there is no motion.
py::array_t<double> twists(const Decisions& decisions) {
  const std::size_t count = decisions.answers.size();
  py::array_t<double> result({count, decisions.coordinates});
  double* entry_of_row = result.mutable_data();
  for (const ManyAnswer& answer : decisions.answers) {
    for (std::size_t j = 0; j < decisions.coordinates; ++j) {
      *entry_of_row++ =
          answer.twist.empty() ? std::numeric_limits<double>::quiet_NaN() : answer.twist[j];
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
