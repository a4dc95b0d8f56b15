// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rows of a comparison.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/core/error.hpp"
#include "stickslip/earlier/comparison.hpp"
#include "stickslip/earlier/compliance.hpp"
#include "stickslip/earlier/form_closure.hpp"

namespace stickslip::earlier_detail {

/// The methods, in the order in which they are asked.
enum class MethodId {
  kPassive,
  kFormClosure,
  kFrictionless,
  kStronglyStable,
  kWeaklyStable,
  kWrenchSpaceL1,
  kWrenchSpaceLinf,
  kLinearCompliance,
  kThreeStates,
  kFrictionCones,
  kContactRobustness,
  kGraspRobustness,
  kRigidMotionRobustness,
  kGraspMap,
  kWrenchVolume,
  kLeastForce,
  kInternalMargin,
  kCentroid,
};

/// The name of a method, and the question that it asks.
struct Method {
  MethodId id;
  const char* name;
  const char* source;  ///< who proposed it
  bool about_the_load;
  bool in_space;                     ///< whether it applies in space
  const char* short_name = nullptr;  ///< "PCR", if it has one

  std::string word() const;  ///< "grasp-wrench-space-L1"
  /// Returns whether one of the words is its word or its short name.
  bool is_among(const std::vector<std::string>& words) const;
};

const std::vector<Method>& all_methods();

/// The answer of a method: verdict, reason, evidence.
struct MethodAnswer {
  std::string verdict;
  std::string why;
  Json evidence{};
};

/// \{ Return the answer "stable" or "unstable"; that of a search that was given up; that of a
/// method that a number does not serve.
MethodAnswer of_load(bool accepts, std::string why, Json evidence);
MethodAnswer given_up(const Undecided& undecided);
MethodAnswer not_for(const InputError& error);
/// \}

std::string contact_name(std::size_t index);  ///< "contact 0"
/// The words for a motion that a method found beyond the question's bound.
inline constexpr const char* kBeyondBound = ", but that moves beyond the bound";
/// Returns "(7 leaves refuted)".
std::string leaves_refuted(std::size_t count);
/// Returns an answer with `why`, and in parentheses how many leaves were refuted.
MethodAnswer refuted(const Trees& refutation, const std::string& why);

/// \{ Return the answers for these results, in the plane and in space.
MethodAnswer closure_answer(const std::variant<FormClosure, FreeMotion>& found,
                            NumberText& text);
MethodAnswer unresisted_answer(const UnresistedMotion& found, NumberText& text);
/// \}

/// \{ Return the singular values of the grasp map; and the distance of the centroid.
MethodAnswer grasp_map_answer(const GraspBox& grasp, const Rational& length, NumberText& text);
MethodAnswer centroid_answer(const GraspBox& grasp, const RationalRow& centre,
                             NumberText& text);
/// \}

/// \{ Return the measures of force_measures.hpp.
MethodAnswer wrench_volume_answer(const GraspBox& grasp, const CompareOptions& options,
                                  NumberText& text);
MethodAnswer least_force_answer(const GraspBox& grasp, const CompareOptions& options,
                                NumberText& text);
MethodAnswer internal_margin_answer(const GraspBox& grasp, const CompareOptions& options,
                                    NumberText& text);
/// \}

/// Throws InputError ("max_force") unless there is one largest force, or one for each contact,
/// and ("edges") at edges that no pyramid has.
void check_options(const Question& question, const CompareOptions& options);

/// Returns the grasp of a question in the plane or in space. Throws as problem_of() and
/// point_in_space() do.
GraspBox point_grasp(const Question& question);

/// Returns PCR or PGR, or the robustness of rigid motions.
MethodAnswer robustness_answer(const GraspBox& grasp, MethodId method,
                               const CompareOptions& options, NumberText& text);

/// Returns the answers of those of `among` that the options name, or of all, and whether they
/// agree with the first, if that is the passive model. Those that the time does not suffice for
/// are not computed. Throws InputError ("methods") at a word of no method.
std::vector<MethodRow> asked(const std::vector<Method>& among, const CompareOptions& options,
                             const std::function<MethodAnswer(MethodId)>& answer);

/// Returns the class by weak and strong stability, as far as they were asked.
std::optional<std::string> class_of(std::optional<bool> weakly, std::optional<bool> strongly);

}  // namespace stickslip::earlier_detail
