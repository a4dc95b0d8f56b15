// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/claim_answer.hpp"

#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {
namespace {

Json to_json(const std::optional<Rational>& value) {
  return value ? number_json(*value) : Json();
}

Json to_json(const LargestResidual& residual) {
  Json json;
  json["value"] = number_json(residual.value);
  json["contact"] = residual.contact ? Json(residual.contact->index()) : Json();
  return json;
}

Json to_json(const ClaimResiduals& residuals) {
  Json json = Json::object();
  if (residuals.balance) {
    const RationalRow& wrench = *residuals.balance;
    const auto torque = wrench.begin() + (wrench.size() == 3 ? 2 : 3);
    json["force"] = number_json(RationalRow(wrench.begin(), torque));
    json["torque"] = wrench.size() == 3 ? number_json(*torque)
                                        : number_json(RationalRow(torque, wrench.end()));
  }
  if (residuals.cone) json["cone"] = to_json(*residuals.cone);
  if (residuals.normal_law) json["normal_law"] = to_json(*residuals.normal_law);
  if (residuals.dissipation) json["dissipation"] = to_json(*residuals.dissipation);
  return json;
}

Json to_json(const NearbyEquilibrium& nearby) {
  Json json;
  json["from"] = nearby.from_claim ? "claim" : "engine";
  json["force_distance"] = to_json(nearby.force_distance);
  json["twist_distance"] = to_json(nearby.twist_distance);
  json["same_slip"] = nearby.same_slip ? Json(*nearby.same_slip) : Json();
  json["same_contacts"] = nearby.same_contacts;
  json["twist"] = number_json(nearby.twist);
  json["force_vectors"] = Json::array();
  for (const RationalRow& force : nearby.forces) {
    json["force_vectors"].push_back(number_json(force));
  }
  return json;
}

/// Returns one number if the distance is known exactly; else two that it lies between, the
/// upper one null if it is not known.
Json to_json(const std::optional<DistanceBounds>& distance) {
  if (!distance) return {};
  if (distance->low == distance->high) return number_json(distance->low);
  return Json::array({number_json(distance->low), to_json(distance->high)});
}

Json to_json(const ThresholdDistance& distance) {
  Json json;
  json["smallest"] = to_json(distance.smallest());
  json["along_load"] = to_json(distance.along_load);
  if (distance.all_at_once) {
    json["all_at_once"] = to_json(distance.all_at_once);
  } else {
    json["along_axes"] = to_json(distance.along_axes);
    json["axis"] = distance.along_axes ? number_json(distance.axis) : Json();
  }
  if (distance.limit) json["limit"] = *distance.limit;
  return json;
}

}  // namespace

Json claim_json(const Question& question, const Claim& claim, const ClaimReport& report) {
  Json json;
  json["class"] = name_of(report.claim_class);
  json["name"] = question.description().name;
  json["normal_law"] = to_string(question.law);
  json["claimed"] = claim.stable ? "stable" : "unstable";
  json["verdict"] = name_of(report.answer.verdict);
  json["engine"] = report.answer.engine();
  if (const auto* undecided = std::get_if<Undecided>(&report.answer.verdict)) {
    add_undecided(json, *undecided);
  }
  json["inaccurate"] = report.inaccurate;
  json["residuals"] = to_json(report.residuals);
  json["residual_scale"] = {{"force", number_json(report.scale.force)},
                            {"length", number_json(report.scale.length)},
                            {"motion", number_json(report.scale.motion)}};
  json["claimed_slip"] = report.claimed_slip ? Json(to_string(*report.claimed_slip)) : Json();
  json["nearby"] = report.nearby ? to_json(*report.nearby) : Json();
  if (report.no_nearby) json["no_nearby"] = *report.no_nearby;
  json["distance"] = report.distance ? to_json(*report.distance) : Json();
  return json;
}

}  // namespace stickslip
