// SPDX-License-Identifier: GPL-3.0-or-later
#include "crosscheck_report.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/interfaces/claim_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

/// Returns the force of a wrench.
RationalRow force_of(const RationalRow& wrench) {
  return {wrench.begin(), wrench.begin() + (wrench.size() == 3 ? 2 : 3)};
}

/// Returns the torque of a wrench about the axis of the plane, or about three axes.
RationalRow torque_of(const RationalRow& wrench) {
  return {wrench.begin() + (wrench.size() == 3 ? 2 : 3), wrench.end()};
}

/// Returns the JSON on one line; names of files may be any bytes.
std::string line_of(const Json& json) {
  return json.dump(-1, Json::Utf8::kReplaced);
}

std::string residual_text(const LargestResidual& residual, NumberText& number) {
  std::string text = number(residual.value);
  if (residual.contact) text += " at contact " + std::to_string(residual.contact->index());
  return text;
}

/// Returns each condition that could be computed, and by how much it is missed.
std::vector<std::pair<ResidualCondition, std::string>> residual_texts(
    const ClaimResiduals& residuals, NumberText& number) {
  std::vector<std::pair<ResidualCondition, std::string>> texts;
  if (const auto& b = residuals.balance) {
    const RationalRow torque = torque_of(*b);
    texts.emplace_back(ResidualCondition::kBalance,
                       "force " + number(force_of(*b)) + ", torque " +
                           (torque.size() == 1 ? number(torque[0]) : number(torque)));
  }
  const auto add = [&](ResidualCondition condition, const auto& residual) {
    if (residual) texts.emplace_back(condition, residual_text(*residual, number));
  };
  add(ResidualCondition::kCone, residuals.cone);
  add(ResidualCondition::kNormalLaw, residuals.normal_law);
  add(ResidualCondition::kDissipation, residuals.dissipation);
  return texts;
}

std::string residuals_text(const ClaimResiduals& residuals, NumberText& number) {
  std::vector<std::vector<std::string>> rows;
  for (auto& [condition, missed_by] : residual_texts(residuals, number)) {
    rows.push_back({std::string("  ") + name_of(condition), missed_by});
  }
  return rows.empty() ? ""
                      : "  What the claimed solution misses, at most:\n" +
                            format_table(rows, Align::kLeft);
}

/// Returns the conditions that are missed by more than the tolerance, on one line.
std::string inaccuracy_text(const ClaimReport& report, const ClaimOptions& options,
                            NumberText& number) {
  const auto missed = report.residuals.missed(options.residual_tolerance, report.scale);
  std::string text;
  for (auto& [condition, missed_by] : residual_texts(report.residuals, number)) {
    if (std::find(missed.begin(), missed.end(), condition) == missed.end()) continue;
    text += (text.empty() ? "" : "; ") + std::string(name_of(condition)) + " " + missed_by;
  }
  return ", but its solution misses: " + text;
}

std::string distance_text(const DistanceBounds& distance, const std::string& of,
                          NumberText& number) {
  std::string text = number(distance.low);
  if (!distance.high) {
    return distance.low.is_zero()
               ? ""
               : "  The verdict stays until the load changes by " + text + of + ".\n";
  }
  if (distance.low != *distance.high) text += " to " + number(*distance.high);
  return "  The verdict changes when the load changes by " + text + of + ".\n";
}

std::string distance_text(const ThresholdDistance& distance, const ClaimOptions& options,
                          NumberText& number) {
  const auto& along_load = distance.along_load;
  const auto& along_axes = distance.along_axes;
  std::string text;
  if (along_axes && !(along_load && *along_load->high <= *along_axes->high)) {
    text = distance_text(*along_axes, " times " + number(distance.axis), number);
  } else if (along_load) {
    text = distance_text(*along_load, " of itself", number);
  } else if (!distance.limit) {
    text = std::string("  No change of the load along itself") +
           (distance.all_at_once ? "" : " or an axis") + " changes the verdict.\n";
  }
  const std::string within = " within " + number(options.tie_distance) + " of its size ";
  if (distance.all_at_once && distance.all_at_once->high) {
    text += "  A load" + within + "has another verdict.\n";
  } else if (distance.all_at_once && !distance.limit) {
    text += "  All loads" + within + "have this verdict.\n";
  }
  if (distance.limit) text += "  The threshold was not found: " + *distance.limit + ".\n";
  return text;
}

/// Returns how far off an inaccurate solution is.
std::string nearby_text(const NearbyEquilibrium& nearby, NumberText& number) {
  if (!nearby.from_claim) return "; no exact equilibrium of its kind was found nearby";
  std::string text = "; an exact equilibrium of its kind is within";
  if (nearby.force_distance) text += " " + number(*nearby.force_distance) + " in the forces";
  if (nearby.force_distance && nearby.twist_distance) text += " and";
  if (nearby.twist_distance) text += " " + number(*nearby.twist_distance) + " in the twist";
  return text;
}

}  // namespace

void ClaimCounts::add(const ClaimReport& report) {
  if (report.inaccurate) ++inaccurate;
  ++judged[static_cast<std::size_t>(report.claim_class)];
}

std::size_t ClaimCounts::claims() const {
  return std::accumulate(judged.begin(), judged.end(), unreadable);
}

int ClaimCounts::exit_code() const {
  if (of(ClaimClass::kWrong) > 0) return kClaimsWrong;
  if (unreadable > 0) return kBadInput;
  return of(ClaimClass::kUndecided) > 0 ? kUndecidedWithinLimit : kDone;
}

std::string to_json_line(const JudgedLine& judged, bool floats) {
  Json json;
  json["line"] = judged.number;
  json.update(claim_json(judged.line.question, judged.line.claim, judged.report));
  if (!judged.saved.empty()) json["saved"] = judged.saved;
  return line_of(finished(json, floats));
}

std::string to_json_line(std::size_t number, const InputError& error) {
  return line_of({{"line", number},
                  {"class", "unreadable"},
                  {"file", error.file()},
                  {"place", error.place()},
                  {"problem", error.problem()},
                  {"remedy", error.remedy()}});
}

std::string to_json_line(const ClaimCounts& counts) {
  Json json;
  json["summary"] = {{"claims", counts.claims()},
                     {"right", counts.of(ClaimClass::kRight)},
                     {"inaccurate", counts.inaccurate},
                     {"tie", counts.of(ClaimClass::kTie)},
                     {"wrong", counts.of(ClaimClass::kWrong)},
                     {"undecided", counts.of(ClaimClass::kUndecided)},
                     {"unreadable", counts.unreadable}};
  return line_of(json);
}

std::string to_text(const JudgedLine& judged, const ClaimOptions& options, NumberText& number) {
  const ClaimReport& report = judged.report;
  if (report.claim_class == ClaimClass::kRight && !report.inaccurate && !report.distance) {
    return {};
  }
  const std::string& name = judged.line.question.description().name;
  std::string text = "line " + std::to_string(judged.number) + ": " +
                     name_of(report.claim_class) + ": claimed " +
                     (judged.line.claim.stable ? "stable" : "unstable");
  if (const auto* undecided = std::get_if<Undecided>(&report.answer.verdict)) {
    text += ", not decided: " + in_words(*undecided);
  } else {
    text += std::string(", exactly ") + name_of(report.answer.verdict);
  }
  if (!name.empty()) text += " (" + quote(name) + ")";
  if (report.inaccurate) text += inaccuracy_text(report, options, number);
  if (report.inaccurate && report.nearby) text += nearby_text(*report.nearby, number);
  if (report.inaccurate && report.no_nearby) text += "; " + *report.no_nearby;
  text += '\n';
  if (report.distance) text += distance_text(*report.distance, options, number);
  if (report.claim_class == ClaimClass::kRight) return text;
  text += residuals_text(report.residuals, number);
  if (report.claimed_slip && !report.claimed_slip->empty()) {
    text += "  The claimed twist slips " + to_string(*report.claimed_slip) + ".\n";
  }
  for (const std::string& file : judged.saved) text += "  Saved " + file + "\n";
  return text;
}

std::string to_text(std::size_t number, const InputError& error) {
  std::string message = error.what();
  // The name of a grasp file may hold anything, and a report is to be one line.
  for (char& c : message) {
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return "line " + std::to_string(number) + ": unreadable: " + message + "\n";
}

std::string to_text(const ClaimCounts& counts) {
  const auto with = [](std::size_t count, const char* word) {
    return std::to_string(count) + ' ' + word;
  };
  std::string text = with(counts.claims(), counts.claims() == 1 ? "claim: " : "claims: ") +
                     with(counts.of(ClaimClass::kRight), "right");
  if (counts.inaccurate > 0) {
    text += " (" + with(counts.inaccurate, "of them with an inaccurate solution)");
  }
  return text + ", " + with(counts.of(ClaimClass::kTie), "tie, ") +
         with(counts.of(ClaimClass::kWrong), "wrong, ") +
         with(counts.of(ClaimClass::kUndecided), "undecided, ") +
         with(counts.unreadable, "unreadable\n");
}

}  // namespace stickslip
