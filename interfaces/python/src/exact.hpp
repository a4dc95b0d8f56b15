// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Exact numbers from and to Python.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "stickslip/core/json_value.hpp"
#include "stickslip/core/twist.hpp"

namespace stickslip::python {

/// Returns the number that a Python object is, exactly: an int, a float (the dyadic rational
/// that it is), a Fraction, a Decimal, a NumPy scalar, or a string as in a grasp file ("3/5",
/// "-0.25", "1e-3"). Throws InputError naming `place` for anything else, NaN and infinities
/// included, and for a number that is too long for a grasp file.
Rational exact(pybind11::handle value, const std::string& place);

/// Returns the number of a Fraction of any length.
Rational rational(pybind11::handle fraction);

/// Returns the wrench of a list of three numbers. The place of an error is "name[i]".
Wrench exact_wrench(const pybind11::list& values, const std::string& name);

/// Returns a fractions.Fraction.
pybind11::object fraction(const Rational& value);
pybind11::tuple fractions(const Wrench& wrench);
pybind11::tuple fractions(const Rational& x, const Rational& y);

/// Returns a str; bytes that are not UTF-8 become U+FFFD.
pybind11::str text(const std::string& bytes);

/// Returns an answer as dicts and tuples, with Fractions for exact numbers. Decimals, which
/// bound roots, are strings.
pybind11::object python_of(const Json& json);

}  // namespace stickslip::python
