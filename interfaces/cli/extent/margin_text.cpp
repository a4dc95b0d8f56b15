// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_text.hpp"

#include <algorithm>

#include "box_numbers.hpp"

namespace stickslip {
namespace {

/// Returns "1 at each contact", "(1, 0, 2)", or for many contacts "from 0 to 2".
std::string preloads_text(const std::vector<Rational>& preloads, NumberText& text) {
  const auto [smallest, largest] = std::minmax_element(preloads.begin(), preloads.end());
  if (preloads.empty()) return "none";
  if (*smallest == *largest) return text(*smallest) + " at each contact";
  constexpr std::size_t kMostShown = 8;
  if (preloads.size() <= kMostShown) return text(preloads);
  return "from " + text(*smallest) + " to " + text(*largest);
}

std::string family_text(const Question& question) {
  std::string text;
  if (question.direction) text = "loads w + l u";
  if (const auto& preloads = question.preload_direction) {
    text += text.empty() ? "" : " and ";
    text += preloads->scale ? "preloads l P" : "preloads P + l Q";
  }
  return text + " with l >= 0";
}

/// Returns P; or P^u if the preloads grow in proportion.
std::vector<Rational> preloads_of(const Question& question) {
  if (question.preload_direction->scale) return question.preload_growth;
  std::vector<Rational> preloads;
  for (const UncertainContact& c : question.grasp.as_box().contacts) {
    preloads.push_back(c.preload.low);
  }
  return preloads;
}

}  // namespace

std::string head_text(const Question& question, NumberText& text) {
  std::string head = heading(question) + family_text(question) + "\n\n" + "  wrench w     " +
                     load_text(question.grasp.wrench(), text) + '\n';
  if (question.direction) head += "  direction u  " + text(*question.direction) + '\n';
  if (const auto& direction = question.preload_direction) {
    head += "  preloads P   " + preloads_text(preloads_of(question), text) + '\n';
    if (!direction->scale) {
      head += "  growth Q     " + preloads_text(question.preload_growth, text) + '\n';
    }
  }
  return head + '\n';
}

std::string multiples_text(const Rational& low, const std::optional<Rational>& high,
                           NumberText& text) {
  if (!high) return "from " + text(low);
  if (low == *high) return text(low);
  return "[" + text(low) + ", " + text(*high) + "]";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string result;
  for (const std::string& part : parts) {
    if (!result.empty()) result += &part == &parts.back() ? " and " : ", ";
    result += part;
  }
  return result;
}

}  // namespace stickslip
