// SPDX-License-Identifier: MIT
/// \file
/// The words of the command line of stickslip-check.
#pragma once

#include <string>
#include <vector>

#include "question.hpp"

namespace stickslip_check {

/// Words that make no sense; `problem` names the option.
struct UsageError {
  std::string problem;
};

struct Arguments {
  std::vector<std::string> files;  ///< GRASP and CERTIFICATE, unless help is asked for
  QuestionOptions options;
  bool json = false;
  bool help = false;
};

/// Throws UsageError.
Arguments parse_arguments(const std::vector<std::string>& words);

/// WX,WY,T, the value of an option. Throws UsageError.
Vector3 parse_wrench(const std::string& option, const std::string& text);

}  // namespace stickslip_check
