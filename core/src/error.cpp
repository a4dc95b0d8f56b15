// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/error.hpp"

#include <utility>

namespace stickslip {
namespace {

std::string join(const std::string& file, const std::string& place, const std::string& problem,
                 const std::string& remedy) {
  std::string text;
  for (const std::string* part : {&file, &place}) {
    if (!part->empty()) text += *part + ": ";
  }
  text += problem;
  if (!remedy.empty()) text += "; " + remedy;
  return text;
}

}  // namespace

InputError::InputError(std::string file, std::string place, std::string problem,
                       std::string remedy)
    : std::runtime_error(join(file, place, problem, remedy)),
      file_(std::move(file)),
      place_(std::move(place)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

InputError InputError::in_file(const std::string& file) const {
  return {file, place_, problem_, remedy_};
}

std::string quote(std::string_view text) {
  constexpr std::size_t kShown = 40;
  const bool cut = text.size() > kShown;
  if (cut) {
    std::size_t end = kShown;
    // Never through the middle of a UTF-8 character.
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    text = text.substr(0, end);
  }
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      constexpr char kHex[] = "0123456789abcdef";
      result += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 0xFU]};
    } else {
      result += c;
    }
  }
  return result + (cut ? "...\"" : "\"");
}

void require(bool condition, const char* message) {
  if (!condition) throw ContractError(message);
}

}  // namespace stickslip
