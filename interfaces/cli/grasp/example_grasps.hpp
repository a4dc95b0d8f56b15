// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The grasps of examples/grasps/ and paper_examples/grasps/, which CMake puts into the
/// program.
#pragma once

#include <string>
#include <vector>

namespace stickslip {

struct ExampleGrasp {
  std::string name;  ///< the name of the file, without .json
  std::string text;
};

/// Returns the grasps in the order of their names.
const std::vector<ExampleGrasp>& example_grasps();

/// Returns the text of the grasp. Throws InputError if there is none of that name.
const std::string& text_of_example(const std::string& name);

}  // namespace stickslip
