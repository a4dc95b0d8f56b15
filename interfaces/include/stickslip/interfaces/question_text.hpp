// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A question about a grasp, as it is spelled on a command line or in a request.
#pragma once

#include <string>

#include "stickslip/engine/question.hpp"

namespace stickslip {

/// The values of options; an option that is not given is empty.
struct QuestionText {
  std::string wrench;                     ///< "WX,WY,T"; in space six numbers
  std::string case_name;                  ///< the case of the file whose wrench is applied
  std::string preload;                    ///< the preload of every contact
  std::string normal_law = "unilateral";  ///< or "bilateral"
  std::string uncertain;                  ///< "friction=10%,..."
  std::string max_motion;                 ///< "LENGTH,ANGLE", "B1,B2,...", "1000x" or "none"
  std::string direction;                  ///< the direction of a margin, as a wrench
  std::string preload_direction;          ///< the preloads of a margin: "P0,P1,..." or "scale"
};

/// Returns the options that they spell. Throws InputError naming the option, "--wrench".
QuestionOptions question_options(const QuestionText& text);

/// Returns the question about a grasp of which only the contacts matter, under no load; a file
/// of one body alone becomes that of the body. One body in the plane is kept as a LoadedGrasp,
/// whatever the lengths of its normals. Throws InputError as ask() does, and with the
/// place "grasp" if some number of a contact is an interval.
Question contacts_alone(GraspFile file);

}  // namespace stickslip
