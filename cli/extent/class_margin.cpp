// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_margin.hpp"

#include <iostream>

#include "commands.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/earlier/class_margin.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

Json json_of(const Question& question, const Inertia& inertia,
             const std::vector<ClassRange>& ranges) {
  Json json{{"name", question.description().name},
            {"wrench", number_json(coordinates(question.loaded().wrench))},
            {"direction", number_json(*question.direction)},
            {"inertia", inertia_json(inertia)}};
  add_units(json, question.description().units);
  Json& classes = json["classes"] = Json::array();
  for (const ClassRange& range : ranges) {
    classes.push_back({{"class", to_string(range.rigid_class)},
                       {"low", number_json(range.low)},
                       {"high", range.high ? number_json(*range.high) : Json(nullptr)},
                       {"has_low", range.has_low},
                       {"has_high", range.has_high}});
  }
  return json;
}

std::string text_of(const ClassRange& range, NumberText& text) {
  if (range.high == range.low) return text(range.low);
  return (range.has_low ? "[" : "(") + text(range.low) + ", " +
         (range.high ? text(*range.high) : "oo") + (range.has_high ? "]" : ")");
}

}  // namespace

int answer_class_margin(const Question& question, const std::string& inertia_text,
                        const NumberOptions& output) {
  if (!question.direction || question.preload_direction) {
    throw InputError("", "--class", "rigid contacts know no preloads",
                     "say which load grows, as in --direction 0,1,0");
  }
  const Inertia inertia = inertia_option("--inertia", inertia_text);
  const auto result = class_margin(problem_of(question), inertia);
  if (const auto* undecided = std::get_if<Undecided>(&result)) {
    std::cerr << "stickslip: the margin is not known: " << in_words(*undecided) << '\n';
    return kUndecidedWithinLimit;
  }
  const auto& ranges = std::get<std::vector<ClassRange>>(result);
  NumberText text(output);
  if (output.json) {
    std::cout << finished(json_of(question, inertia, ranges), output.floats).dump(1) << '\n';
    return kDone;
  }
  if (const std::string title = heading(question); !title.empty()) std::cout << title << '\n';
  std::cout << "  load w       " << text(coordinates(question.loaded().wrench))
            << "\n  direction u  " << text(*question.direction) << "\n  inertia      centre "
            << text(inertia.centre) << ", squared radius of gyration "
            << text(inertia.gyration_squared) << "\n\nUnder the load w + l u rigid contacts\n";
  std::vector<std::vector<std::string>> table;
  for (const ClassRange& range : ranges) {
    table.push_back({"  " + to_string(range.rigid_class), "l in " + text_of(range, text)});
  }
  std::cout << format_table(table, Align::kLeft) << units_text(question) << text.note();
  return kDone;
}

}  // namespace stickslip
