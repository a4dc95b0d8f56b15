// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the rows of a comparison have in common, in the plane and in space.
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
};

/// How a method is named, and what it asks.
struct Method {
  MethodId id;
  const char* name;
  const char* source;  ///< who proposed it
  bool about_the_load;
  bool in_space;  ///< whether it is done there

  std::string word() const;  ///< "grasp-wrench-space-L1"
};

const std::vector<Method>& all_methods();

/// What a method says: verdict, reason, evidence.
struct MethodAnswer {
  std::string verdict;
  std::string why;
  Json evidence{};
};

/// \{ "stable" or "unstable"; that it was given up; that a number does not serve it.
MethodAnswer of_load(bool accepts, std::string why, Json evidence);
MethodAnswer given_up(const Undecided& undecided);
MethodAnswer not_for(const InputError& error);
/// \}

std::string contact_name(std::size_t index);  ///< "contact 0"
/// What is to be said of a motion that a method found and the question does not count.
inline constexpr const char* kBeyondBound = ", but that moves beyond the bound";
/// "(7 leaves refuted)"
std::string leaves_refuted(std::size_t count);
/// `why`, and in parentheses how many leaves were refuted.
MethodAnswer refuted(const Trees& refutation, const std::string& why);

/// \{ What these find says, in the plane and in space.
MethodAnswer closure_answer(const std::variant<FormClosure, FreeMotion>& found,
                            NumberText& text);
MethodAnswer unresisted_answer(const UnresistedMotion& found, NumberText& text);
/// \}

/// The verdict of the passive model about one grasp, by what decides boxes, which knows bounds
/// on motions.
MethodAnswer passive_answer(const GraspBox& grasp, NormalLaw law, NumberText& text);

/// The answers of those of `among` whose words are given, or of all, and whether they agree
/// with the first, if that is the passive model. Throws InputError ("methods") at a word of no
/// method.
std::vector<MethodRow> asked(const std::vector<Method>& among,
                             const std::vector<std::string>& words,
                             const std::function<MethodAnswer(MethodId)>& answer);

/// \{ As compare_methods(), in the plane and in space. `bounded` is the grasp if motions are
/// bounded, of which the problem knows nothing; else null.
Comparison compare_in_plane(const Problem& problem, const GraspBox* bounded,
                            const CompareOptions& options, NumberText& text);
Comparison compare_in_space(const GraspBox& grasp, NormalLaw law, const CompareOptions& options,
                            NumberText& text);
/// \}

/// By what weak and strong stability say, as far as they were asked.
std::optional<std::string> class_of(std::optional<bool> weakly, std::optional<bool> strongly);

}  // namespace stickslip::earlier_detail
