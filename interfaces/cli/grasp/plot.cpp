// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/grasp_plot.hpp"
#include "stickslip/interfaces/states_plot.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {
namespace {

std::string picture_of(const Question& question, const TimeLimit& limit) {
  return plot_grasp(question, decide_in_time(question, to_draw(), limit).verdict);
}

void add_grasp_plot(Command& plot, int& exit_code) {
  struct Arguments {
    QuestionArguments question;
    std::string time_limit;
    std::string output = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  Command* command = plot.add_subcommand("grasp",
                                         "The verdict: contacts, cones, load, and the forces "
                                         "and motion that hold it; in space from "
                                         "three sides");
  arguments->question.add_to(*command);
  add_time_limit_option(*command, arguments->time_limit);
  add_output_option(*command, arguments->output, "SVG file");
  command->footer(
      footer_text("", kExitCodes, "stickslip plot grasp fig1.json --wrench 0,1,0 -o fig1.svg"));
  command->callback([arguments, &exit_code] {
    write_whole_file(arguments->output, picture_of(arguments->question.any_question(),
                                                   time_limit_option(arguments->time_limit)));
    exit_code = kDone;
  });
}

void add_states_plot(Command& plot, int& exit_code) {
  struct Arguments {
    std::string file;
    std::string modes = "slip";
    std::string output = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  Command* command = plot.add_subcommand(
      "states",
      "The slip states: the sphere of motions, cut by one great circle a contact. In space, "
      "of several bodies and with --modes: a row for each dimension");
  add_grasp_argument(*command, arguments->file);
  add_modes_option(*command, arguments->modes);
  add_output_option(*command, arguments->output, "SVG file");
  command->footer(footer_text("", kExitCodes, "stickslip plot states fig1.json -o states.svg"));
  command->callback([arguments, &exit_code] {
    write_whole_file(arguments->output, plot_states(read_contacts(arguments->file).grasp,
                                                   state_set_named(arguments->modes)));
    exit_code = kDone;
  });
}

}  // namespace

void add_plot_command(Command& app, int& exit_code) {
  Command* command = app.add_subcommand(
      "plot",
      "Draw a grasp, its slip states, its resistible wrenches or its quality: SVG for print "
      "and screen");
  command->require_subcommand();
  command->footer(
      footer_text("", kExitCodesWithLimit, "stickslip plot grasp fig1.json -o fig1.svg"));
  add_grasp_plot(*command, exit_code);
  add_states_plot(*command, exit_code);
  add_region_plot(*command, exit_code);
  add_quality_plot(*command, exit_code);
}

}  // namespace stickslip
