// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct StatesArguments {
  std::string file;
  std::string engine = "auto";
  unsigned threads = 0;
  bool list = false;
  bool json = false;
};

Enumerator enumerator(const std::string& engine) {
  return engine == "cgal"    ? Enumerator::kCgal
         : engine == "sweep" ? Enumerator::kSweep
         : engine == "paper" ? Enumerator::kPaper
                             : Enumerator::kAuto;
}

void print_text(const StatesArguments& arguments, const std::string& name,
                const Enumeration& report) {
  const ArrangementCounts& c = report.found.counts;
  if (!name.empty()) std::cout << name << '\n';
  std::cout << format_table(
      {{"contacts", "circles", "rank", "vertices", "edges", "faces", "cells",
        "distinct states"},
       {std::to_string(c.planes), std::to_string(c.circles), std::to_string(c.rank),
        std::to_string(c.vertices), std::to_string(c.edges), std::to_string(c.faces),
        std::to_string(c.cells()), std::to_string(c.distinct_states)}});
  if (arguments.list) {
    for (const SlipState& state : report.found.states) std::cout << to_string(state) << '\n';
    std::cout << "A sign a contact: + and - slip along and against the tangent, 0 sticks.\n";
  }
  std::cout
      << "Engine: " << report.engine
      << (enumerator(report.engine) == Enumerator::kPaper
              ? ". What the paper's three steps find; all-stick is not one of their cells.\n"
              : ". Cells are on the sphere of motions; distinct states include all-stick.\n");
}

int states(const StatesArguments& arguments) {
  const Grasp grasp = read_planar_contacts(arguments.file);
  const Enumeration report = enumerate_slip_states(
      stick_planes(grasp), enumerator(arguments.engine), arguments.list, arguments.threads);
  if (arguments.json) {
    std::cout << states_json(report, arguments.list).dump(1) << '\n';
  } else {
    print_text(arguments, grasp.name(), report);
  }
  return kDone;
}

}  // namespace

void add_states_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<StatesArguments>();
  Command* command = app.add_subcommand(
      "states", "Enumerate the slip states consistent with rigid motion, and count cells");
  add_grasp_argument(*command, arguments->file);
  command
      ->add_option("--engine", arguments->engine,
                   "How to enumerate. cgal: CGAL's arrangement on the sphere, the reference. "
                   "sweep: ours, for many "
                   "contacts. paper: the paper's own three steps, a baseline. auto: cgal for "
                   "few contacts, else sweep")
      ->type_name("ENGINE")
      ->choices({"auto", "cgal", "sweep", "paper"})
      ->capture_default_str();
  add_threads_option(*command, arguments->threads,
                     "Threads with which the sweep counts; 0 is one a core");
  command->add_flag("--list", arguments->list,
                    "List the states, one character a contact: + and - slip, 0 stick");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->footer(footer_text(
      "Motions are points of a sphere, which each contact cuts in a great circle: on it the\n"
      "contact sticks, and it slips one way or the other on either side. Cells are the faces,\n"
      "edges and vertices that result. Wrench, friction and preload play no part.\n",
      kExitCodes, "stickslip states fig1.json --list"));
  command->callback([arguments, &exit_code] { exit_code = states(*arguments); });
}

}  // namespace stickslip
