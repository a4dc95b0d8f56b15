// SPDX-License-Identifier: GPL-3.0-or-later
#include "warnings.hpp"

#include <iostream>

namespace stickslip {

void add_no_warnings_option(Command& command, bool& no_warnings) {
  command.add_flag("--no-warnings", no_warnings,
                   "Do not look for traps of the model, such as a large motion, or a preload "
                   "that does not balance (docs/model.md)");
}

void print(const Warnings& warnings) {
  if (!warnings) return;
  for (const ModelWarning& warning : *warnings) {
    std::cout << "Warning: " << warning.text << ".\n";
  }
}

}  // namespace stickslip
