// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "table.hpp"

namespace stickslip {
namespace {

struct StatesArguments {
  std::string file;
  std::string engine = "cgal";
  bool list = false;
  bool json = false;
};

void print_json(const StatesArguments& arguments, const SlipStates& result) {
  const ArrangementCounts& c = result.counts;
  nlohmann::ordered_json json{{"contacts", c.planes},
                              {"circles", c.circles},
                              {"rank", c.rank},
                              {"vertices", c.vertices},
                              {"edges", c.edges},
                              {"faces", c.faces},
                              {"cells", c.cells()},
                              {"distinct_states", c.distinct_states},
                              {"engine", arguments.engine}};
  if (arguments.list) {
    nlohmann::ordered_json& states = json["states"] = nlohmann::ordered_json::array();
    for (const SlipState& state : result.states) states.push_back(to_string(state));
  }
  std::cout << json.dump(1) << '\n';
}

void print_text(const StatesArguments& arguments, const std::string& name,
                const SlipStates& result) {
  const ArrangementCounts& c = result.counts;
  if (!name.empty()) std::cout << name << '\n';
  std::cout << format_table(
      {{"contacts", "circles", "rank", "vertices", "edges", "faces", "cells",
        "distinct states"},
       {std::to_string(c.planes), std::to_string(c.circles), std::to_string(c.rank),
        std::to_string(c.vertices), std::to_string(c.edges), std::to_string(c.faces),
        std::to_string(c.cells()), std::to_string(c.distinct_states)}});
  if (arguments.list) {
    for (const SlipState& state : result.states) std::cout << to_string(state) << '\n';
  }
  std::cout << "Engine: " << arguments.engine
            << ". Cells are on the sphere of motions; distinct states include all-stick.\n";
}

int states(const StatesArguments& arguments) {
  const GraspFile file = read_grasp_file(arguments.file);
  const Grasp& grasp = file.content.grasp;
  const SlipStates result = enumerate_slip_states_cgal(stick_planes(grasp));
  if (arguments.json) {
    print_json(arguments, result);
  } else {
    print_text(arguments, grasp.name(), result);
  }
  return kDone;
}

}  // namespace

void add_states_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<StatesArguments>();
  CLI::App* command = app.add_subcommand(
      "states", "Enumerate the slip states consistent with rigid motion, and count cells");
  add_grasp_argument(*command, arguments->file);
  command->add_option("--engine", arguments->engine, "cgal: CGAL's arrangement on the sphere")
      ->check(CLI::IsMember({"cgal"}))
      ->capture_default_str();
  command->add_flag("--list", arguments->list,
                    "List the states, one character a contact: + and - slip, 0 stick");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->callback([arguments, &exit_code] { exit_code = states(*arguments); });
}

}  // namespace stickslip
