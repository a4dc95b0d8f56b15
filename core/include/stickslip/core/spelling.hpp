// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What may have been meant by a word that is none of those that are known.
#pragma once

#include <string>
#include <vector>

namespace stickslip {

/// `did you mean "..."? `, of the known word that is nearest to this one. Nothing if none is
/// near: at most half of its characters may be wrong, not counting the dashes of options.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// The same, and then all that is known: `introduction`, and the words with commas between.
std::string choice_of(const std::string& word, const std::vector<std::string>& known,
                      const std::string& introduction);

}  // namespace stickslip
