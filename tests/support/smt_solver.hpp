// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// SMT solvers, asked as programs.
#pragma once

#include <string>
#include <vector>

namespace stickslip::test {

/// The lines that `program` prints, errors among them, when it is given `text` in a file.
/// Throws std::runtime_error if the program is missing ("...NOTFOUND", as CMake says) or does
/// not end with exit code 0.
std::vector<std::string> ask_solver(const std::string& program, const std::string& options,
                                    const std::string& text);

}  // namespace stickslip::test
