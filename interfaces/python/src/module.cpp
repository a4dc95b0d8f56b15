// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

py::object error_class(const char* name) {
  return py::module_::import("stickslip.errors").attr(name);
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    const py::tuple arguments = py::make_tuple(text(error.file()), text(error.place()),
                                               text(error.problem()), text(error.remedy()));
    PyErr_SetObject(error_class("InputError").ptr(), arguments.ptr());
  } catch (const LimitError& error) {
    PyErr_SetObject(error_class("LimitReached").ptr(), text(error.what()).ptr());
  } catch (const ContractError& error) {
    PyErr_SetObject(error_class("ContractError").ptr(), text(error.what()).ptr());
  }
}

}  // namespace
}  // namespace stickslip::python

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of stickslip; import stickslip instead.";
  module.attr("version") = STICKSLIP_VERSION;
  pybind11::register_exception_translator(stickslip::python::translate);
  module.def("exact", [](const pybind11::object& value, const std::string& place) {
    return stickslip::python::fraction(stickslip::python::exact(value, place));
  });
  module.def("readable", [](const pybind11::object& value) {
    return stickslip::to_readable_string(stickslip::python::rational(value));
  });
  module.def("readable_root", [](const pybind11::object& square) {
    return stickslip::to_readable_string(1, stickslip::python::rational(square));
  });
  stickslip::python::bind_grasp(module);
  stickslip::python::bind_ask(module);
  stickslip::python::bind_check(module);
  stickslip::python::bind_many(module);
  stickslip::python::bind_batch(module);
  stickslip::python::bind_space(module);
  stickslip::python::bind_states(module);
}
