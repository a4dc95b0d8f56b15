// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/error.hpp"

#include <algorithm>
#include <cstddef>
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

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string_view without_dashes(std::string_view word) {
  return word.substr(std::min(word.find_first_not_of('-'), word.size()));
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
    // The cut is never in the middle of a UTF-8 character.
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

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 40;
  if (known.empty() || word.size() > kLongest) return {};
  const auto distance = [&](const std::string& other) {
    return edit_distance(without_dashes(word), without_dashes(other));
  };
  const std::string& nearest = *std::min_element(
      known.begin(), known.end(),
      [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (2 * distance(nearest) > without_dashes(nearest).size()) return {};
  return "did you mean \"" + nearest + "\"? ";
}

std::string choice_of(const std::string& word, const std::vector<std::string>& known,
                      const std::string& introduction) {
  std::string text = did_you_mean(word, known) + introduction;
  for (const std::string& name : known) text += (name == known.front() ? "" : ", ") + name;
  return text;
}

void require(bool condition, const char* message) {
  if (!condition) throw ContractError(message);
}

}  // namespace stickslip
