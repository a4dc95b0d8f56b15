// SPDX-License-Identifier: GPL-3.0-or-later
// Another program's answer held against the exact one (crosscheck/claim.hpp).
#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/crosscheck/claim.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;
using py::literals::operator""_a;

/// Coefficients of the contacts' own normals and tangents.
std::vector<ContactForce> claimed_forces(const Grasp& grasp, const py::list& vectors) {
  std::vector<ContactForce> forces;
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const std::string place = "forces[" + std::to_string(i) + ", ";
    const py::list vector = vectors[i].cast<py::list>();
    const Rational x = exact(vector[0], place + "0]");
    const Rational y = exact(vector[1], place + "1]");
    const Vector2& n = grasp.contacts()[i].normal;
    const Rational length_squared = n.x * n.x + n.y * n.y;
    forces.push_back(
        {(x * n.x + y * n.y) / length_squared, (y * n.x - x * n.y) / length_squared});
  }
  return forces;
}

py::object fraction_or_none(const std::optional<Rational>& value) {
  return value ? fraction(*value) : py::object(py::none());
}

Rational not_negative(const py::object& value, const std::string& place) {
  const Rational number = exact(value, place);
  if (number.sign() >= 0) return number;
  throw InputError("", place, "the value is " + to_string(number), "it must be 0 or more");
}

/// (squared, contact)
py::object residual(const std::optional<LargestResidual>& found) {
  if (!found) return py::none();
  const Magnitude& m = found->value;
  const py::object contact =
      found->contact ? py::object(py::int_(found->contact->index())) : py::object(py::none());
  return py::make_tuple(fraction(m.coefficient * m.coefficient * m.radicand), contact);
}

py::dict nearby_fields(const NearbyEquilibrium& nearby, const Grasp& grasp) {
  const py::object same_slip =
      nearby.same_slip ? py::object(py::bool_(*nearby.same_slip)) : py::object(py::none());
  return py::dict("twist"_a = fractions(nearby.witness.twist),
                  "forces"_a = force_vectors(grasp, nearby.witness.forces),
                  "from_claim"_a = nearby.from_claim,
                  "force_distance"_a = fraction_or_none(nearby.force_distance),
                  "twist_distance"_a = fraction_or_none(nearby.twist_distance),
                  "same_slip"_a = same_slip, "same_contacts"_a = nearby.same_contacts);
}

py::dict crosscheck(const GraspFile& grasp, bool stable, const py::object& twist,
                    const py::object& forces, const py::object& wrench,
                    const py::object& preload, bool bilateral, const py::object& tie,
                    const py::object& tolerance, std::size_t node_limit, bool distances) {
  const Question question = question_of(grasp, question_options(wrench, preload, bilateral));
  Claim claim;
  claim.stable = stable;
  if (!twist.is_none()) {
    const Wrench numbers = exact_wrench(twist.cast<py::list>(), "twist");
    claim.solution.twist = Twist{numbers.x, numbers.y, numbers.torque};
  }
  if (!forces.is_none()) {
    claim.solution.forces = claimed_forces(question.loaded().grasp, forces.cast<py::list>());
  }
  ClaimOptions options;
  options.tie_distance = not_negative(tie, "tie");
  options.residual_tolerance = not_negative(tolerance, "tolerance");
  options.node_limit = node_limit;
  options.all_distances = distances;

  const auto [report, decided, certificate] = without_gil([&] {
    ClaimReport judged = judge_claim(question, claim, options);
    const Decision& decision = judged.decision;
    Answer answer{question,
                  decision.verdict,
                  decision.engine(),
                  std::visit([](const auto& work) { return work_json(work); }, decision.work),
                  kDefaultBits,
                  problem_of(question),
                  {}};
    std::string proof = certificate_of(answer).value_or("");
    return std::tuple(std::move(judged), std::move(answer), std::move(proof));
  });
  const ClaimResiduals& r = report.residuals;
  py::dict result("outcome"_a = name_of(report.claim_class),
                  "inaccurate"_a = report.inaccurate);
  result["decision"] = decision_fields(decided, certificate);
  result["balance"] = r.balance ? py::object(fractions(*r.balance)) : py::object(py::none());
  result["cone"] = residual(r.cone);
  result["normal_law"] = residual(r.normal_law);
  result["dissipation"] = residual(r.dissipation);
  if (report.claimed_slip) result["claimed_slip"] = to_string(*report.claimed_slip);
  if (report.nearby) {
    result["nearby"] = nearby_fields(*report.nearby, question.loaded().grasp);
  }
  if (report.distance) {
    result["distance"] = fraction_or_none(report.distance->smallest());
    result["distance_along_load"] = fraction_or_none(report.distance->along_load);
  }
  return result;
}

}  // namespace

void bind_crosscheck(py::module_& module) {
  module.def("crosscheck", &crosscheck);
}

}  // namespace stickslip::python
