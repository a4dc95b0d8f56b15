// SPDX-License-Identifier: GPL-3.0-or-later
// The judgement of another program's answer against the exact one (measures/claim.hpp).
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/measures/claim.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

/// Reads a row; the package has checked the lengths.
RationalRow exact_row(const py::list& values, const std::string& name,
                      const std::string& separator) {
  RationalRow row;
  for (const py::handle value : values) {
    row.push_back(exact(value, name + separator + std::to_string(row.size()) + "]"));
  }
  return row;
}

py::tuple fractions_of(const RationalRow& row) {
  return tuple_of(row, [](const Rational& x) { return fraction(x); });
}

Rational not_negative(const py::object& value, const std::string& place) {
  const Rational number = exact(value, place);
  if (number.sign() >= 0) return number;
  throw InputError("", place, "the value is " + to_string(number), "it must be 0 or more");
}

/// Returns (squared, contact); or two numbers between which the square lies, if that is
/// irrational.
py::object residual(const std::optional<LargestResidual>& found) {
  if (!found) return py::none();
  const py::object contact =
      found->contact ? py::object(py::int_(found->contact->index())) : py::object(py::none());
  if (const auto square = found->value.rational_square()) {
    return py::make_tuple(fraction(*square), contact);
  }
  // The numbers are closer than doubles can tell.
  const Rational close = 1 + Rational(1, Integer(1) << 60U);
  for (unsigned bits = 64;; bits *= 2) {
    const auto [low, high] = found->value.between(bits);
    if (low.sign() <= 0 || high > close * low) continue;
    return py::make_tuple(py::make_tuple(fraction(low * low), fraction(high * high)), contact);
  }
}

/// Returns a number if the distance is known exactly, else two numbers that it lies between.
py::object distance(const std::optional<DistanceBounds>& found) {
  if (!found) return py::none();
  if (found->low == found->high) return fraction(found->low);
  return py::make_tuple(fraction(found->low), fraction_or_none(found->high));
}

py::dict nearby_fields(const NearbyEquilibrium& nearby) {
  const py::object same_slip =
      nearby.same_slip ? py::object(py::bool_(*nearby.same_slip)) : py::object(py::none());
  return py::dict("twist"_a = fractions_of(nearby.twist),
                  "forces"_a = tuple_of(nearby.forces, fractions_of),
                  "from_claim"_a = nearby.from_claim,
                  "force_distance"_a = fraction_or_none(nearby.force_distance),
                  "twist_distance"_a = fraction_or_none(nearby.twist_distance),
                  "same_slip"_a = same_slip, "same_contacts"_a = nearby.same_contacts);
}

py::dict crosscheck(const GraspFile& grasp, bool stable, const py::object& twist,
                    const py::object& forces, const py::object& wrench,
                    const py::object& preload, bool bilateral, const py::object& tie,
                    const py::object& tolerance, std::size_t node_limit, bool distances) {
  const Question question = question_about(grasp, question_options(wrench, preload, bilateral));
  Claim claim;
  claim.stable = stable;
  if (!twist.is_none()) claim.twist = exact_row(twist.cast<py::list>(), "twist", "[");
  if (!forces.is_none()) {
    claim.forces.emplace();
    for (const py::handle force : forces.cast<py::list>()) {
      const std::string place = "forces[" + std::to_string(claim.forces->size());
      claim.forces->push_back(exact_row(force.cast<py::list>(), place, ", "));
    }
  }
  ClaimOptions options;
  options.tie_distance = not_negative(tie, "tie");
  options.residual_tolerance = not_negative(tolerance, "tolerance");
  options.node_limit = node_limit;
  options.all_distances = distances;

  const auto [report, certificate] = without_gil([&] {
    ClaimReport judged = judge_claim(question, claim, options);
    std::string proof = certificate_of(judged.answer).value_or("");
    return std::pair(std::move(judged), std::move(proof));
  });
  const ClaimResiduals& r = report.residuals;
  py::dict result("outcome"_a = name_of(report.claim_class),
                  "inaccurate"_a = report.inaccurate);
  result["decision"] = decision_fields(report.answer, certificate);
  result["balance"] = r.balance ? py::object(fractions_of(*r.balance)) : py::object(py::none());
  result["cone"] = residual(r.cone);
  result["normal_law"] = residual(r.normal_law);
  result["dissipation"] = residual(r.dissipation);
  if (report.claimed_slip) result["claimed_slip"] = to_string(*report.claimed_slip);
  if (report.nearby) result["nearby"] = nearby_fields(*report.nearby);
  if (report.distance) {
    result["distance"] = distance(report.distance->smallest());
    result["distance_along_load"] = distance(report.distance->along_load);
  }
  return result;
}

}  // namespace

void bind_crosscheck(py::module_& module) {
  module.def("crosscheck", &crosscheck);
}

}  // namespace stickslip::python
