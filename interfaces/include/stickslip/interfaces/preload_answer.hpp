// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The best preloads of a grasp as JSON, and their proofs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/preload.hpp"

namespace stickslip {

/// Returns the loads of questions that differ in their loads alone, as find_least_preload()
/// takes them. Throws InputError about the file if more is uncertain than loads in a ball, and
/// if there are no contacts.
std::vector<GraspBox> loads_of(const std::vector<Question>& questions, const std::string& file);

/// Returns the groups of contacts that are to press alike, by a word: "normals" for those whose
/// normals have one direction, "none", or groups as in "0,1:2,3". Throws InputError at "equal".
ContactGroups alike_from(const std::string& text, const GraspBox& grasp);

/// Returns the warning that the preloads found do not balance each other, if they do not: the
/// model does not require it (docs/model.md).
std::vector<ModelWarning> unbalanced(GraspBox held, NormalLaw law);

/// Returns the preloads of least sum, the bound, and which multiples hold.
Json preload_json(const std::vector<Question>& questions, const LeastPreload& least,
                  const ContactGroups& alike);

/// Returns the preloads of a ball, the radii, the bound, and which multiples hold.
Json preload_json(const Question& question, const Rational& budget, const BallPreload& found,
                  const ContactGroups& alike);

/// \{ Return grasp files with certificates by name: "held0" and so on, a load each, or "proved"
/// and "refuted" of a quality; "range0", and so on; and "bound0" and so on, boxes of preloads
/// that refuse a load. The files of margins have preloads of 0; they are checked with the
/// option --preload-direction and the preloads that are found.
std::vector<std::pair<std::string, ProvedFiles>> proved_preload(NormalLaw law,
                                                                const LeastPreload& least);
std::vector<std::pair<std::string, ProvedFiles>> proved_preload(const Question& question,
                                                                const BallPreload& found);
/// \}

}  // namespace stickslip
