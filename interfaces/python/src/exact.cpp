// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact.hpp"

#include "stickslip/core/error.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

// Integers travel in base 16: linear time, and free of Python's limit on decimal digits.

Integer integer(py::handle value) {
  const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!index) throw py::error_already_set();
  const auto digits = py::reinterpret_steal<py::str>(PyNumber_ToBase(index.ptr(), 16));
  if (!digits) throw py::error_already_set();
  Integer result;
  mpz_set_str(result.mutable_gmp(), std::string(digits).c_str(), 0);
  return result;
}

py::object python_int(const Integer& value) {
  std::string digits(mpz_sizeinbase(value.gmp(), 16) + 2, '\0');
  mpz_get_str(digits.data(), 16, value.gmp());
  auto result =
      py::reinterpret_steal<py::object>(PyLong_FromString(digits.c_str(), nullptr, 16));
  if (!result) throw py::error_already_set();
  return result;
}

py::object fraction_of(const Integer& above, const Integer& below) {
  return py::module_::import("fractions")
      .attr("Fraction")(python_int(above), python_int(below));
}

/// Returns a number of any length by its digits.
py::object exact_of(const std::string& digits) {
  if (digits.find_first_not_of("-/0123456789") != std::string::npos) return py::str(digits);
  const std::size_t bar = digits.find('/');
  return fraction_of(Integer(digits.substr(0, bar)),
                     bar == std::string::npos ? Integer(1) : Integer(digits.substr(bar + 1)));
}

bool is_instance(py::handle value, const char* module, const char* type) {
  return py::isinstance(value, py::module_::import(module).attr(type));
}

std::string_view utf8(py::handle string) {
  py::ssize_t size = 0;
  const char* bytes = PyUnicode_AsUTF8AndSize(string.ptr(), &size);
  if (bytes == nullptr) throw py::error_already_set();
  return {bytes, static_cast<std::size_t>(size)};
}

/// Returns true if a grasp file can hold the number. Its length is known but for one digit in
/// each part before it is spelled.
bool fits_a_file(const Rational& value) {
  const std::size_t digits =
      mpz_sizeinbase(mpq_numref(value.gmp()), 10) + mpz_sizeinbase(mpq_denref(value.gmp()), 10);
  if (digits + 2 <= kMaxNumberLength) return true;  // with a sign and a bar
  return digits <= kMaxNumberLength + 2 && to_string(value).size() <= kMaxNumberLength;
}

/// Reads a number. Throws NumberError, or the exception that Python raises.
Rational read_exact(py::handle value) {
  if (PyFloat_Check(value.ptr())) return rational_from_double(PyFloat_AS_DOUBLE(value.ptr()));
  if (PyUnicode_Check(value.ptr())) return parse_rational(utf8(value));
  if (!PyBool_Check(value.ptr()) && !is_instance(value, "numpy", "bool_")) {
    if (PyIndex_Check(value.ptr())) return Rational(integer(value));
    // A Decimal is read by its text, whose length and exponent are limited; its ratio could
    // fill the memory.
    if (is_instance(value, "decimal", "Decimal")) return parse_rational(utf8(py::str(value)));
    if (py::hasattr(value, "as_integer_ratio")) {  // Fraction, numpy.float32, ...
      const auto ratio = value.attr("as_integer_ratio")().cast<py::tuple>();
      return Rational(integer(ratio[0]), integer(ratio[1]));
    }
  }
  throw NumberError(std::string(py::str(py::type::of(value).attr("__name__"))) +
                    " is not a type of number that is taken");
}

}  // namespace

Rational exact(py::handle value, const std::string& place) {
  std::string problem;
  try {
    const Rational number = read_exact(value);
    if (fits_a_file(number)) return number;
    throw InputError("", place, "the number is too long",
                     "numbers are written with at most " + std::to_string(kMaxNumberLength) +
                         " characters, as in a grasp file");
  } catch (const NumberError& error) {
    problem = error.what();
  } catch (py::error_already_set& error) {  // as_integer_ratio of NaN, a lone surrogate, ...
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_OverflowError) &&
        !error.matches(PyExc_TypeError)) {
      throw;
    }
    problem = utf8(py::str(error.value()));
  }
  throw InputError(
      "", place, problem,
      "give a finite int, float, Fraction or Decimal, or a string such as \"3/5\", "
      "\"-0.25\" or \"1e-3\"");
}

Rational rational(py::handle fraction) {
  return {integer(fraction.attr("numerator")), integer(fraction.attr("denominator"))};
}

Wrench exact_wrench(const py::list& values, const std::string& name) {
  return {exact(values[0], name + "[0]"), exact(values[1], name + "[1]"),
          exact(values[2], name + "[2]")};
}

py::object fraction(const Rational& value) {
  return fraction_of(numerator(value), denominator(value));
}

py::tuple fractions(const Rational& x, const Rational& y) {
  return py::make_tuple(fraction(x), fraction(y));
}

py::tuple fractions(const Wrench& w) {
  return py::make_tuple(fraction(w.x), fraction(w.y), fraction(w.torque));
}

py::str text(const std::string& bytes) {
  PyObject* decoded =
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

py::object python_of(const Json& json) {
  if (json.is_exact()) return exact_of(json.text());
  if (json.is_string()) return text(json.text());
  if (json.is_null()) return py::none();
  if (json.is_array()) {
    py::tuple values(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) values[i] = python_of(json[i]);
    return std::move(values);
  }
  if (json.is_object()) {
    py::dict members;
    for (const auto& [key, value] : json.members()) members[text(key)] = python_of(value);
    return std::move(members);
  }
  const std::string word = json.dump();
  if (word == "true" || word == "false") return py::bool_(word == "true");
  return python_int(Integer(word));  // a count
}

}  // namespace stickslip::python
