// SPDX-License-Identifier: GPL-3.0-or-later
// Many questions in one call.
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
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
  std::size_t coordinates;  ///< the coordinates of a motion
};

/// \{ Return entry i of a list with an entry for each question, or with one for all of them.
template <class Value>
const Value& entry(const std::vector<Value>& list, std::size_t i) {
  return list[list.size() == 1 ? 0 : i];
}
py::object entry(const py::list& list, std::size_t i) {
  return list[list.size() == 1 ? 0 : i];
}
/// \}

/// Calls work(i) for all i below `count`, in parallel. If calls throw, throws what the first
/// such i does.
template <class Work>
void for_all(std::size_t count, std::size_t threads, Work work) {
  using oneapi::tbb::global_control;
  std::optional<global_control> allowed;  // there may be more threads than cores, without a
                                          // warning
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

/// Decides many questions. Each list has one entry for all questions or one for each; an empty
/// one of the last three leaves the grasps' own. The grasps are all of one kind, with as many
/// coordinates.
Decisions decide_many(std::size_t count, const py::list& grasps, const py::list& wrenches,
                      const py::list& frictions, const py::list& preloads, bool bilateral,
                      const std::string& engine, std::size_t node_limit, std::size_t threads) {
  const auto of = [](const py::list& list, std::size_t i) -> py::object {
    return list.empty() ? py::object(py::none()) : entry(list, i);
  };
  const std::size_t coordinates =
      grasps.empty() ? 3 : grasps[0].cast<const GraspFile&>().content.wrench().size();
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
    questions.push_back(one_question(entry(grasps, i), asked, bilateral, engine, node_limit));
  }
  return without_gil([&] {
    Decisions result{std::vector<ManyAnswer>(count), coordinates};
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

/// Returns the texts of every question.
py::list texts(const Decisions& decisions, std::string ManyAnswer::*member) {
  py::list result;
  for (const ManyAnswer& answer : decisions.answers) result.append(text(answer.*member));
  return result;
}

/// Returns one row of this width for each question, with NaN where it has fewer numbers.
py::array_t<double> rows(const Decisions& decisions, std::vector<double> ManyAnswer::*member,
                         std::size_t width) {
  py::array_t<double> result({decisions.answers.size(), width});
  double* row = result.mutable_data();
  for (const ManyAnswer& answer : decisions.answers) {
    const std::vector<double>& numbers = answer.*member;
    std::fill(std::copy(numbers.begin(), numbers.end(), row), row + width,
              std::numeric_limits<double>::quiet_NaN());
    row += width;
  }
  return result;
}

/// Returns rows with all forces of a question each; they are as long as the longest.
py::array_t<double> forces(const Decisions& decisions) {
  std::size_t width = 0;
  for (const ManyAnswer& answer : decisions.answers) {
    width = std::max(width, answer.forces.size());
  }
  return rows(decisions, &ManyAnswer::forces, width);
}

/// \{ Convert the whole answers for pickle, and back.
py::tuple pickled(const Decisions& decisions) {
  return py::make_tuple(decisions.coordinates,
                        tuple_of(decisions.answers, [](const ManyAnswer& a) {
                          return py::make_tuple(a.verdict, a.engine, a.limit, a.wrench, a.twist,
                                                a.forces, a.whole());
                        }));
}

Decisions unpickled(const py::tuple& state) {
  Decisions decisions{{}, state[0].cast<std::size_t>()};
  for (const py::handle entry : state[1]) {
    const auto a = entry.cast<py::tuple>();
    const auto numbers = [&a](std::size_t i) { return a[i].cast<std::vector<double>>(); };
    decisions.answers.push_back({a[0].cast<std::string>(), a[1].cast<std::string>(),
                                 a[2].cast<std::string>(), numbers(3), numbers(4), numbers(5),
                                 [whole = a[6].cast<py::tuple>()] { return whole; }});
  }
  return decisions;
}
/// \}

}  // namespace

void bind_many(py::module_& module) {
  py::class_<Decisions>(module, "DecisionsData")
      .def("size", [](const Decisions& d) { return d.answers.size(); })
      .def("at", &decision_at)
      .def("verdicts", [](const Decisions& d) { return texts(d, &ManyAnswer::verdict); })
      .def("engines", [](const Decisions& d) { return texts(d, &ManyAnswer::engine); })
      .def("limits", [](const Decisions& d) { return texts(d, &ManyAnswer::limit); })
      .def("wrenches",
           [](const Decisions& d) { return rows(d, &ManyAnswer::wrench, d.coordinates); })
      .def("twists",
           [](const Decisions& d) { return rows(d, &ManyAnswer::twist, d.coordinates); })
      .def("forces", &forces)
      .def(py::pickle(&pickled, &unpickled));
  module.def("decide_many", &decide_many);
}

}  // namespace stickslip::python
