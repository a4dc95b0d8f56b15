// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <iostream>
#include <memory>

#include "box_numbers.hpp"
#include "cells.hpp"
#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/map_plot.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct MapArguments {
  QuestionArguments question;
  std::string x;
  std::string y;
  CellsAsked cells;
  std::string uncertain;
  std::string svg;
  std::string time_limit;
  NumberOptions output;
};

void print_text(const Question& question, const MapAxis& x, const MapAxis& y,
                const std::vector<MapCell>& cells, const CellsAsked& asked,
                const std::string& uncertain) {
  std::cout << heading(question) << "a map of " << cells.size() << " cells over " << x.name
            << " and " << y.name << "\n\n"
            << shares_text(cells, x, y) << '\n';
  if (!uncertain.empty()) {
    std::cout << "Each proof is for all grasps of a cell with " << uncertain << ".\n";
  }
  if (asked.uncertain.ball && !asked.certificates.empty()) {
    std::cout << "Each in " << asked.certificates
              << " is checked with --uncertain wrench=" << to_string(*asked.uncertain.ball)
              << ".\n";
  }
  std::cout << motions_text(question) << engine_text(box_engine(question), question.law);
}

int map(const MapArguments& arguments) {
  QuestionText text;
  text.uncertain = arguments.uncertain;
  CellsAsked asked = arguments.cells;
  asked.uncertain = question_options(text).uncertain;
  const Question question = arguments.question.any_question();
  const GraspBox* box = question.box();
  if (box != nullptr && !box->is_point()) {
    throw InputError("", "GRASP", "some of its numbers are uncertain already",
                     "a map is about one grasp, whose numbers its axes vary: give numbers");
  }
  const GraspBox grasp = question.grasp.as_box();
  const MapAxis x = parse_axis(grasp, arguments.x, "--x");
  const MapAxis y = parse_axis(grasp, arguments.y, "--y");
  LongWork work("map", time_limit_option(arguments.time_limit));
  const std::vector<MapCell> cells = proved_cells(grasp, question.law, x, y, asked, work);
  if (!arguments.svg.empty()) {
    write_whole_file(arguments.svg, plot_map(question.description().name, x, y, cells));
  }
  if (arguments.output.json) {
    Json json = map_json(question, x, y, cells);
    if (!arguments.uncertain.empty()) json["uncertain"] = arguments.uncertain;
    work.add_ending(json);
    std::cout << finished(json, arguments.output.floats).dump(1) << '\n';
  } else {
    print_text(question, x, y, cells, asked, arguments.uncertain);
    std::cout << work.ending();
  }
  return kDone;
}

}  // namespace

void add_map_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<MapArguments>();
  Command* command = app.add_subcommand(
      "map", "Where in a plane of two numbers does it hold? Proved cell by cell");
  arguments->question.add_to(*command);
  arguments->question.add_max_motion_to(*command);
  for (auto& [option, value, words] :
       std::array<std::tuple<const char*, std::string*, const char*>, 2>{
           {{"--x", &arguments->x, "What grows to the right"},
            {"--y", &arguments->y, "What grows upwards"}}}) {
    command->add_option(option, *value, words)->type_name("NAME=FROM:TO")->required();
  }
  add_uncertain_option(*command, arguments->uncertain,
                       "How far numbers of every grasp of the map may be off, as of decide");
  constexpr std::uint64_t kMostDepth = 12;
  add_count_option(*command, "--depth", arguments->cells.depth,
                   "The finest cells are a 2^N-th of an axis", kMostDepth);
  command->add_option("--svg", arguments->svg, "Draw the map")->type_name("FILE");
  command
      ->add_option("--certificates", arguments->cells.certificates,
                   "Write each proved cell there, cell0.json and so on, with its certificate "
                   "for stickslip-check")
      ->type_name("DIR");
  add_node_limit_option(*command, arguments->cells.node_limit);
  add_time_limit_option(*command, arguments->time_limit);
  arguments->output.add_to(*command);
  command->footer(footer_text(
      "NAME is friction, stiffness or preload (a factor on those of all contacts), one of "
      "them\n"
      "with [I] (the value of contact I), wrench[J] (a component), load (a factor on the\n"
      "wrench), direction (of its force, in degrees from the x axis), or a wrench WX,WY,T\n"
      "(a multiple of it, which is added).\n",
      kExitCodes,
      "stickslip map fig1.json --preload 1 --x friction=0:2 --y load=0:2 --depth 4 --svg "
      "map.svg"));
  command->callback([arguments, &exit_code] { exit_code = map(*arguments); });
}

}  // namespace stickslip
