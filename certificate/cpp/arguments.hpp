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
  std::vector<std::string>
      files;  ///< GRASP and CERTIFICATE, unless help or a batch is asked for
  Options options;
  bool json = false;
  bool batch = false;
  bool help = false;
};

/// Throws UsageError. --help is a question only before the first file, and after -- nothing is
/// an option, so that no file's name makes the program end with success.
Arguments parse_arguments(const std::vector<std::string>& words);

}  // namespace stickslip_check
