// SPDX-License-Identifier: GPL-3.0-or-later
#include "spool.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

namespace stickslip::test {
namespace {

/// Bytes as the characters U+0000 to U+00FF, since files under test need not be UTF-8.
std::string as_characters(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0U | (byte >> 6U));
      text += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return text;
}

}  // namespace

std::string spool_line(const std::string& grasp, const std::string& certificate,
                       const std::vector<std::string>& options, const std::string& expected) {
  nlohmann::json json{{"grasp", as_characters(grasp)},
                      {"certificate", as_characters(certificate)},
                      {"options", options}};
  if (!expected.empty()) json["expected"] = expected;
  return json.dump(-1, ' ', true) + "\n";
}

bool append_to_spool(const std::string& line) {
  const char* folder = std::getenv("STICKSLIP_SPOOL");
  if (folder == nullptr) return true;  // started by hand: the C++ checker alone
  static std::ofstream file(std::string(folder) + "/" + std::to_string(getpid()) + ".jsonl",
                            std::ios::app | std::ios::binary);
  file << line << std::flush;
  return file.good();
}

}  // namespace stickslip::test
