// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/answer.hpp"
#include "stickslip/interfaces/html.hpp"

namespace stickslip {

void add_page_command(Command& app, int& exit_code) {
  struct Arguments {
    QuestionArguments question;
    std::string output = "-";
    std::size_t node_limit = 0;
    std::string seconds = "30";
  };
  auto arguments = std::make_shared<Arguments>();
  Command* command = app.add_subcommand(
      "page", "A page to look at and to turn, with the verdict and its proof: one HTML file");
  arguments->question.add_with_uncertain_to(*command);
  add_output_option(*command, arguments->output, "HTML file");
  add_node_limit_option(*command, arguments->node_limit);
  add_time_limit_option(
      *command, arguments->seconds,
      "Give up regions, margins, maps, qualities and comparisons after so many "
      "seconds each, and show what is known by then; 0 is no limit");
  command->footer(footer_text(
      "The file loads nothing from elsewhere. Of a grasp file with cases the first is shown,\n"
      "unless --case or --wrench is given. What is left out is said on the page\n"
      "(docs/page.md).\n",
      kExitCodes, "stickslip page fig1.json -o fig1.html"));
  command->callback([arguments, &exit_code] {
    const GraspFile file = arguments->question.file();
    if (arguments->output != "-") require_unprotected(arguments->output);
    PageLimits limits;
    limits.node_limit = arguments->node_limit;
    limits.time = milliseconds_option(arguments->seconds);
    LongWork work("page");
    Json answer;
    work.finishes([&] {
      answer = page_answer(file, arguments->question.text(), all_page_parts(), limits,
                           arguments->question.name_of_file());
    });
    write_whole_file(arguments->output, page_html(answer));
    exit_code = kDone;
  });
}

}  // namespace stickslip
