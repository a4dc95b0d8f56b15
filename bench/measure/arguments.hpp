// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "interfaces/cli/command_line.hpp"

namespace stickslip::bench {

/// The command line of a benchmark. Nothing here includes the parser, which takes longer to
/// compile than all else in most benchmarks.
class Arguments {
 public:
  Arguments(const std::string& name, const std::string& description)
      : line_(name, description, "of stickslip " STICKSLIP_VERSION) {}

  /// The place to describe options; each sets a variable that it is given.
  Command& described() { return line_.program(); }
  /// Reads a command line. Returns the exit code if it asks for help or has an error, with what
  /// is to be said printed; else nothing.
  std::optional<int> read(int argc, const char* const* argv);

 private:
  CommandLine line_;
};

}  // namespace stickslip::bench
