// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions of any kind with their verdicts, as `decide --json` prints them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/contact_mode.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/uncertain_numbers.hpp"
#include "stickslip/measures/model_warnings.hpp"
#include "stickslip/measures/spatial_warnings.hpp"

namespace stickslip {

/// Nothing when they were not asked for.
using Warnings = std::optional<std::vector<ModelWarning>>;

/// \{ The engine whose numbers may be intervals, in the plane, in space and of several bodies.
inline constexpr const char* kIntervalsEngine = "intervals";
inline constexpr const char* kSpaceEngine = "space";
inline constexpr const char* kBodiesEngine = "bodies";
inline const char* box_engine(const Question& question) {
  return question.mechanism() != nullptr ? kBodiesEngine
         : question.in_space()           ? kSpaceEngine
                                         : kIntervalsEngine;
}
/// \}

/// To one question. What is about one grasp in the plane is a question about a box of one point
/// if some lengths are irrational and known as intervals, or if it is stable and an exact
/// equilibrium would be too long (has_long_equilibria).
struct Answer {
  Question question;                 ///< as asked, or about a box of one point, see above
  Verdict verdict;                   ///< with its evidence
  std::string engine;                ///< "states", "branch-and-bound", "intervals" or "space"
  Json stats;                        ///< what it took, by name
  unsigned bits = kDefaultBits;      ///< as of BoxDecision
  std::optional<Problem> problem{};  ///< of a question about no box
  Warnings warnings{};               ///< about one grasp
  /// The answer to a second question where rounding of the data alone decides the first: with
  /// motions bounded by natural_bound(), if the grasp is not decided without a bound, or holds
  /// by far motions only; or under the nearest load that contacts oppose, if it does not hold
  /// for a part of the load that is smaller than 1e-12 of it.
  std::shared_ptr<const Answer> within{};
};

/// The traps of the model that are looked for.
enum class WarningsAsked {
  kNone,
  kOfMotion,  ///< those that the motion shows: quick
  kAll        ///< all, which take as long as the verdict
};

/// How to answer.
struct AnswerOptions {
  Engine engine = Engine::kAuto;                 ///< of one grasp in the plane
  std::size_t node_limit = 0;                    ///< as of each engine; 0: its own, or none
  WarningsAsked warnings = WarningsAsked::kAll;  ///< of one grasp
  bool within = true;  ///< answer a second question where that says more
};

/// The verdict about one grasp: by the engine; or with kAuto, where an exact equilibrium would
/// be too long (has_long_equilibria), that it is stable, by degree.
std::variant<Decision, BoxDecision> judge(const Problem& problem, Engine engine,
                                          std::size_t node_limit);

/// Decides.
Answer answer_to(Question question, const AnswerOptions& options);

/// Why, as "limit" in words and as "reason" in one; "remedy" and "near" if there are any.
void add_undecided(Json& json, const Undecided& undecided);

/// The contacts as "enclosed", and "bits"; nothing if there are none.
void add_enclosed(Json& json, const std::vector<std::size_t>& contacts, unsigned bits);

/// Returns by how much the loads of two questions differ: the square of the length of the
/// difference of forces, and of torques over a typical length of the grasp.
Rational squared_distance(const Question& a, const Question& b);

/// The second answer in short: the bound and the verdict.
Json within_json(const Answer& within);

/// What `decide --json` prints, before finished().
Json to_json(const Answer& answer);

/// The certificate; nothing if the verdict has none: undecided or fragile.
std::optional<std::string> certificate_of(const Answer& answer);

/// Who wrote a certificate: "stickslip 0.1.0, engine space".
std::string producer_of(const std::string& engine);

/// A list of them, "trap" and "text" each.
Json warnings_json(const std::vector<ModelWarning>& warnings);

/// The work of an engine by name.
template <class Work>
Json work_json(const Work& work) {
  Json json = Json::object();
  for (const auto& [name, value] : counters(work)) json[name] = value;
  return json;
}

/// One contact of a stable verdict.
struct ContactReport {
  Rational length_squared;  ///< of the contact's normal
  ContactForce force;       ///< by the contact's own normal and tangent
  Vector2 vector;           ///< the force in the object frame
  ContactMode mode;         ///< in the motion of the witness
};

/// By ContactId, of an exact equilibrium in the plane.
std::vector<ContactReport> report_contacts(const Answer& answer, const Witness& witness);

/// Of one grasp that is stable, and of which no equilibrium is known: a motion near that of
/// one.
std::optional<RationalRow> motion_near(const Answer& answer);

/// The contacts whose preload over the length of the normal is enclosed.
std::vector<std::size_t> enclosed_contacts(const GraspBox& box);

}  // namespace stickslip
