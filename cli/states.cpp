// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/arrangement/paper_enumerator.hpp"
#include "stickslip/arrangement/sweep.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "table.hpp"

namespace stickslip {
namespace {

struct StatesArguments {
  std::string file;
  std::string engine = "auto";
  unsigned threads = 0;
  bool list = false;
  bool json = false;
};

/// CGAL, the reference, takes some ten milliseconds up to here (bench/README.md); the sweep
/// takes over beyond.
constexpr std::size_t kMostContactsForCgal = 40;

struct StatesReport {
  std::string engine;  ///< the one that ran
  SlipStates found;    ///< states only if they are to be listed
};

/// The paper's three steps, reported as what they find: lines as vertices, facets as edges,
/// regions as faces. All-stick is not among its states unless a step gives it.
SlipStates by_the_paper(const std::vector<Vector3>& planes) {
  const GreatCircles circles = merge_planes(planes);
  PaperEnumeration paper = enumerate_slip_states_paper(planes);
  SlipStates result;
  result.counts = {planes.size(),      circles.normals.size(), circles.rank,
                   paper.lines.size(), paper.facets.size(),    paper.regions.size(),
                   paper.states.size()};
  result.states = std::move(paper.states);
  return result;
}

StatesReport enumerate(const StatesArguments& arguments, const std::vector<Vector3>& planes) {
  std::string engine = arguments.engine;
  if (engine == "auto") engine = planes.size() <= kMostContactsForCgal ? "cgal" : "sweep";
  if (engine == "cgal") return {engine, enumerate_slip_states_cgal(planes)};
  if (engine == "paper") return {engine, by_the_paper(planes)};
  if (arguments.list) return {engine, enumerate_slip_states_sweep(planes)};
  const unsigned threads =
      arguments.threads != 0 ? arguments.threads : std::thread::hardware_concurrency();
  return {engine, {count_cells(planes, std::max(1U, threads)), {}}};
}

void print_json(const StatesArguments& arguments, const StatesReport& report) {
  const ArrangementCounts& c = report.found.counts;
  nlohmann::ordered_json json{{"contacts", c.planes},   {"circles", c.circles},
                              {"rank", c.rank},         {"vertices", c.vertices},
                              {"edges", c.edges},       {"faces", c.faces},
                              {"cells", c.cells()},     {"distinct_states", c.distinct_states},
                              {"engine", report.engine}};
  if (arguments.list) {
    nlohmann::ordered_json& states = json["states"] = nlohmann::ordered_json::array();
    for (const SlipState& state : report.found.states) states.push_back(to_string(state));
  }
  std::cout << json.dump(1) << '\n';
}

void print_text(const StatesArguments& arguments, const std::string& name,
                const StatesReport& report) {
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
  }
  std::cout
      << "Engine: " << report.engine
      << (report.engine == "paper"
              ? ". What the paper's three steps find; all-stick is not one of their cells.\n"
              : ". Cells are on the sphere of motions; distinct states include all-stick.\n");
}

int states(const StatesArguments& arguments) {
  const GraspFile file = read_grasp_file(arguments.file);
  const Grasp& grasp = file.content.grasp;
  const StatesReport report = enumerate(arguments, stick_planes(grasp));
  if (arguments.json) {
    print_json(arguments, report);
  } else {
    print_text(arguments, grasp.name(), report);
  }
  return kDone;
}

}  // namespace

void add_states_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<StatesArguments>();
  CLI::App* command = app.add_subcommand(
      "states", "Enumerate the slip states consistent with rigid motion, and count cells");
  add_grasp_argument(*command, arguments->file);
  command
      ->add_option(
          "--engine", arguments->engine,
          "cgal: CGAL's arrangement on the sphere, the reference. sweep: ours, for many "
          "contacts. paper: the paper's own three steps, a baseline. auto: cgal for "
          "few contacts, else sweep")
      ->check(CLI::IsMember({"auto", "cgal", "sweep", "paper"}))
      ->capture_default_str();
  command
      ->add_option("--threads", arguments->threads,
                   "Threads of the sweep's counts; 0 is one a core")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--list", arguments->list,
                    "List the states, one character a contact: + and - slip, 0 stick");
  command->add_flag("--json", arguments->json, "Print one JSON object");
  command->callback([arguments, &exit_code] { exit_code = states(*arguments); });
}

}  // namespace stickslip
