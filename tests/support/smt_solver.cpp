// SPDX-License-Identifier: GPL-3.0-or-later
#include "smt_solver.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace stickslip::test {

std::vector<std::string> ask_solver(const std::string& program, const std::string& options,
                                    const std::string& text) {
  if (program.find("NOTFOUND") != std::string::npos) {
    throw std::runtime_error(
        "this test needs the programs z3 and cvc5. On Debian: apt-get install z3 cvc5; then "
        "run cmake again");
  }
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("stickslip_" + std::to_string(getpid()) + ".smt2");
  {
    std::ofstream file(path);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
  }
  const std::string command = "'" + program + "' " + options + " '" + path.string() + "' 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string output;
  char buffer[4096];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) {
    output.append(buffer, count);
  }
  const int status = pclose(pipe);
  std::filesystem::remove(path);
  if (status != 0) throw std::runtime_error(command + " failed:\n" + output.substr(0, 1000));
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace stickslip::test
