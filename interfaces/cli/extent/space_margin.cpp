// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_margin.hpp"

#include <iostream>
#include <utility>

#include "commands.hpp"
#include "long_work.hpp"
#include "margin_text.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/margin_answer.hpp"
#include "terminal.hpp"
#include "warnings.hpp"

namespace stickslip {
namespace {

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

void print_least(const SpatialMargin& margin, NumberText& text) {
  const std::vector<MarginInterval> resisted = margin.resisted();
  if (resisted.empty()) {
    std::cout << "None: no multiple is known to hold.\n";
    return;
  }
  std::cout << text(resisted.front().low) << '\n' << text.note();
}

}  // namespace

int answer_margin_in_space(const Question& question, const SpaceMarginArguments& arguments) {
  LongWork work("margin", arguments.time);
  const auto show = [&](const SpatialMargin& so_far) {
    work.say(std::to_string(so_far.claims.size()) + " steps proved, " +
             std::to_string(so_far.work.nodes) + " nodes");
  };
  SpatialMargin margin;
  std::optional<SecondMargin> within;
  work.finishes([&] {
    margin = find_spatial_margin(question, arguments.search, [&](const SpatialMargin& so_far) {
      if (arguments.time.seconds()) margin = so_far;
      show(so_far);
    });
    within = margin_within(question, margin, arguments.search, show);
  });
  if (!arguments.certificate.empty()) {
    write_whole_file(
        arguments.certificate,
        margin_certificate_text(question, margin, producer_of(box_engine(question))));
  }
  Warnings warnings;
  if (arguments.warnings) {
    work.finishes([&] { warnings = model_warnings(question, margin); });
  }
  NumberText text(arguments.output);
  if (arguments.output.json) {
    Json json = margin_json(question, margin, warnings);
    if (within) add_within(json, *within);
    work.add_ending(json);
    std::cout << finished(std::move(json), arguments.output.floats).dump(1) << '\n';
  } else if (arguments.least) {
    print_least(margin, text);
  } else {
    print_text(question, margin, within, text);
    std::cout << work.ending();
  }
  if (!arguments.output.json) print(warnings);
  if (margin.claims.empty()) return kUndecidedWithinLimit;
  return arguments.least && margin.resisted().empty() ? kAnswerUnstable : kDone;
}

}  // namespace stickslip
