// SPDX-License-Identifier: GPL-3.0-or-later
#include "margin_text.hpp"

#include <algorithm>
#include <iostream>

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

/// Returns the lines above the answer.
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

/// Returns "[1, 5/4]", "from 15/4" or "2".
std::string multiples_text(const Rational& low, const std::optional<Rational>& high,
                           NumberText& text) {
  if (!high) return "from " + text(low);
  if (low == *high) return text(low);
  return "[" + text(low) + ", " + text(*high) + "]";
}

/// Returns the parts with "and" before the last.
std::string joined(const std::vector<std::string>& parts) {
  std::string result;
  for (const std::string& part : parts) {
    if (!result.empty()) result += &part == &parts.back() ? " and " : ", ";
    result += part;
  }
  return result;
}

std::string multiples_text(const Margin& margin, NumberText& text) {
  std::vector<std::string> parts;
  for (const MarginInterval& interval : margin.resisted) {
    parts.push_back(multiples_text(interval.low, interval.high, text));
  }
  return joined(parts);
}

/// Returns two lines that say which multiples are resisted and which are not.
std::string known_text(const SpatialMargin& margin, NumberText& text) {
  std::vector<std::string> resisted;
  for (const auto& [low, high] : margin.resisted()) {
    resisted.push_back(multiples_text(low, high, text));
  }
  std::vector<std::string> refuted;
  for (const auto& [low, high] : margin.refuted()) {
    refuted.push_back(!high           ? "above " + text(low)
                      : low.is_zero() ? "below " + text(*high)
                                      : "between " + text(low) + " and " + text(*high));
  }
  return (resisted.empty() ? "No l is known to be resisted.\n"
                           : "Resisted: l = " + joined(resisted) + "\n") +
         (refuted.empty() ? "No l is known not to be.\n"
                          : "Not resisted: l " + joined(refuted) + "\n");
}

}  // namespace

void print_text(const Question& question, const Margin& margin, NumberText& text) {
  std::cout << head_text(question, text);
  if (margin.resisted.empty()) {
    std::cout << "No l is resisted.\n";
  } else if (question.preload_direction) {
    const MarginInterval& first = margin.resisted.front();
    const bool at_all = first.low.is_zero() && !first.high;
    std::cout << "Holds at "
              << (at_all ? "every multiple" : "multiples " + multiples_text(margin, text))
              << (question.preload_direction->scale && !question.direction ? " of the preloads"
                                                                           : "")
              << ".\n";
  } else {
    for (const MarginInterval& interval : margin.resisted) {
      std::cout << "Resisted: l in [" << text(interval.low) << ", "
                << (interval.high ? text(*interval.high) + "]" : "oo)") << '\n';
    }
  }
  std::size_t nodes = 0;
  for (const Trees& gap : margin.gaps) nodes += gap.size();
  const auto count = [](std::size_t n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  const auto proofs = static_cast<std::size_t>(
      std::count_if(margin.segments.begin(), margin.segments.end(),
                    [](const MarginSegment& segment) { return segment.proof.has_value(); }));
  const std::size_t modes = margin.segments.size() - proofs;
  std::cout << "\nProved ";
  if (modes > 0 || proofs == 0)
    std::cout << "by equilibria in " << count(modes, "contact mode");
  if (proofs > 0) {
    std::cout << (modes > 0 ? " and " : "") << "by degree over " << count(proofs, "range");
  }
  std::cout << (margin.gaps.empty() ? ", with nothing left to refute"
                                    : ", and by trees of " + count(nodes, "node") +
                                          " that nothing else is resisted")
            << ".\nNormal law: " << law_text(question.law) << ".\n"
            << conventions_text(question) << text.note();
}

void print_text(const Question& question, const SpatialMargin& margin,
                const std::optional<SecondMargin>& within, NumberText& text) {
  std::cout << head_text(question, text) << known_text(margin, text) << motions_text(question);
  if (within) {
    const bool is_along = within->question.direction != question.direction;
    std::cout
        << (is_along
                ? "\nWithout a part of u that is rounding, and that no contact opposes, and"
                  "\nwithin "
                : "\nWithin ")
        << kFarMotion << " times what the load would press the softest contact:\n"
        << known_text(within->margin, text)
        << (is_along ? "That direction is \"within\" in the answer with --json; ask with "
                     : "This second answer, with its proof: ")
        << "--max-motion " << bound_text(*within->question.box()) << " --certificate FILE.\n";
  }
  const std::size_t nodes = margin.work.nodes + (within ? within->margin.work.nodes : 0);
  const std::size_t claims = margin.claims.size() + (within ? within->margin.claims.size() : 0);
  std::cout << "\nOf other multiples nothing is known. Proved in " << std::to_string(claims)
            << " steps and " << nodes << " nodes.\nNormal law: " << law_text(question.law)
            << ".\n"
            << conventions_text(question) << text.note();
}

void print_least(const Margin& margin, NumberText& text) {
  const std::optional<Rational> smallest = least(margin);
  if (!smallest) {
    std::cout << "None: no multiple holds.\n";
    return;
  }
  std::cout << text(*smallest) << '\n';
  if (margin.resisted.front().high) {
    std::cout << "Not all above it: holds at multiples " << multiples_text(margin, text)
              << ".\n";
  }
  std::cout << text.note();
}

void print_least(const SpatialMargin& margin, NumberText& text) {
  const std::vector<MarginInterval> resisted = margin.resisted();
  if (resisted.empty()) {
    std::cout << "None: no multiple is known to hold.\n";
    return;
  }
  std::cout << text(resisted.front().low) << '\n' << text.note();
}

}  // namespace stickslip
