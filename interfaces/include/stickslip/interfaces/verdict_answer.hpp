// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions of any kind with their verdicts, as `decide --json` prints them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/contact_mode.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/uncertain_numbers.hpp"
#include "stickslip/measures/model_warnings.hpp"

namespace stickslip {

/// The warnings; nothing if they were not asked for.
using Warnings = std::optional<std::vector<ModelWarning>>;

/// Adds the reason, as "limit" in words and as "reason" in one; "remedy" and "near" if there
/// are any.
void add_undecided(Json& json, const Undecided& undecided);

/// Adds the contacts as "enclosed", and "bits"; adds nothing if there are none.
void add_enclosed(Json& json, const std::vector<std::size_t>& contacts, unsigned bits);

/// Returns the options for an answer that is drawn: with exact forces, however long they are,
/// and without a second one.
SearchOptions to_draw();

/// Returns the second answer in short: the verdict, with the bound on motions or the load.
Json within_json(const Answer& within);

/// Returns the output of `decide --json`, before finished() writes its numbers as fractions or
/// doubles. It has `warnings` if they were asked for.
Json to_json(const Answer& answer, const Warnings& warnings = {});

/// Returns a list of the warnings, "trap" and "text" each.
Json warnings_json(const std::vector<ModelWarning>& warnings);

/// Returns the work of an engine, or of an answer, by name.
template <class Work>
Json work_json(const Work& work) {
  Json json = Json::object();
  for (const auto& [name, value] : counters(work)) json[name] = value;
  return json;
}

/// One contact of a stable verdict.
struct ContactReport {
  Rational length_squared;  ///< the square of the length of the contact's normal
  ContactForce force;       ///< the force along the contact's own normal and tangent
  Vector2 vector;           ///< the force in the object frame
  ContactMode mode;         ///< its mode in the motion of the witness
};

/// Returns the contacts of an exact equilibrium in the plane, by ContactId.
std::vector<ContactReport> report_contacts(const Answer& answer, const Witness& witness);

/// Returns a motion near that of an equilibrium, for one grasp that is stable by a proof that
/// states none; else nothing.
std::optional<RationalRow> motion_near(const Answer& answer);

/// Returns the contacts whose P / |n| is irrational, and so known as an interval.
std::vector<std::size_t> enclosed_contacts(const GraspBox& box);

}  // namespace stickslip
