// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_margin.hpp"

#include <iostream>

#include "commands.hpp"
#include "long_work.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/comparison_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

std::optional<std::string> class_of(const ClassRange& range) {
  return to_string(range.rigid_class);
}
std::optional<std::string> class_of(const FactorRange& range) {
  if (!range.rigid_class) return std::nullopt;
  return to_string(*range.rigid_class);
}

template <class Range>
std::string text_of(const Range& range, NumberText& text) {
  if (range.high == range.low) return text(range.low);
  return (range.has_low ? "[" : "(") + text(range.low) + ", " +
         (range.high ? text(*range.high) : "oo") + (range.has_high ? "]" : ")");
}

template <class Range>
void print(const Question& question, const Inertia& inertia, const std::vector<Range>& ranges,
           const NumberOptions& output) {
  if (output.json) {
    std::cout << finished(classes_json(question, inertia, ranges), output.floats).dump(1)
              << '\n';
    return;
  }
  NumberText text(output);
  if (const std::string title = heading(question); !title.empty()) std::cout << title << '\n';
  std::cout << "  load w       " << text(coordinates(question.loaded().wrench)) << '\n';
  if (question.direction) std::cout << "  direction u  " << text(*question.direction) << '\n';
  std::cout << "  inertia      centre " << text(inertia.centre)
            << ", squared radius of gyration " << text(inertia.gyration[0][0])
            << (question.direction ? "\n\nUnder the load w + l u rigid contacts\n"
                                   : "\n\nWith all friction times s rigid contacts\n");
  std::vector<std::vector<std::string>> table;
  for (const Range& range : ranges) {
    table.push_back({"  " + class_of(range).value_or("not known"),
                     (question.direction ? "l in " : "s in ") + text_of(range, text)});
  }
  std::cout << format_table(table, Align::kLeft) << conventions_text(question) << text.note();
}

/// Says that the margin is not known, and why. Returns the exit code.
int say_not_known(const Undecided& why) {
  std::cerr << "stickslip: the margin is not known: " << in_words(why) << '\n';
  return kUndecidedWithinLimit;
}

}  // namespace

int answer_class_margin(const Question& question, const ClassMarginOptions& options,
                        const NumberOptions& output) {
  const Inertia inertia =
      inertia_of("--inertia", rationals_at("--inertia", options.inertia), false);
  LongWork work("classes", options.time);
  if (options.friction) {
    if (question.direction || question.preload_direction) {
      throw InputError("", "--friction", "friction changes, and the load as well",
                       "leave out --direction and --preload-direction");
    }
    std::vector<FactorRange> ranges;
    if (!work.finishes([&] {
          ranges = friction_margin(problem_of(question), inertia, options.accuracy);
        })) {
      return say_not_known(out_of_time(options.time));
    }
    print(question, inertia, ranges, output);
    return kDone;
  }
  if (!question.direction || question.preload_direction) {
    throw InputError("", "--class", "rigid contacts know no preloads",
                     "say which load grows, as in --direction 0,1,0, or ask with --friction "
                     "which factors of friction are of which class");
  }
  std::variant<std::vector<ClassRange>, Undecided> result = out_of_time(options.time);
  work.finishes([&] { result = class_margin(problem_of(question), inertia); });
  if (const auto* undecided = std::get_if<Undecided>(&result)) return say_not_known(*undecided);
  print(question, inertia, std::get<std::vector<ClassRange>>(result), output);
  return kDone;
}

}  // namespace stickslip
