// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/snap.hpp"

#include <iostream>
#include <memory>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/core/file.hpp"

namespace stickslip {
namespace {

struct SnapArguments {
  std::string file;
  std::string output;
  std::string within = "1e-9";
  NumberOptions numbers;
};

Json report_json(const std::string& name, const std::vector<SnappedNormal>& snapped) {
  Json moved = Json::array();
  for (const SnappedNormal& normal : snapped) {
    moved.push_back({{"contact", normal.contact.index()},
                     {"normal", number_json(normal.after)},
                     {"moved_at_most", decimal_json(normal.moved)}});
  }
  return {{"name", name}, {"moved", std::move(moved)}};
}

std::string report_text(const std::vector<SnappedNormal>& snapped, NumberText text) {
  std::string lines;
  for (const SnappedNormal& normal : snapped) {
    lines += "contact " + std::to_string(normal.contact.index()) + ": normal " +
             text(normal.before) + " moved by at most " + normal.moved + ", to " +
             text(normal.after) + '\n';
  }
  if (lines.empty()) lines = "nothing to snap: every normal has a rational length\n";
  return lines + text.note();
}

/// Gives the grasp new normals. Returns a report on them.
std::string snap(AnyGrasp& content, const SnapArguments& arguments) {
  const Rational within = rational_at("--within", arguments.within);
  const auto snapped_in = [&](auto& grasp) {
    auto result = [&] {
      try {
        return snap_normals(grasp, within);
      } catch (const InputError& error) {
        throw InputError("", "--within", error.problem(), error.remedy());
      }
    }();
    grasp = std::move(result.grasp);
    if (!arguments.numbers.json) {
      return report_text(result.snapped, NumberText(arguments.numbers));
    }
    const Json report = report_json(content.description().name, result.snapped);
    return finished(report, arguments.numbers.floats).dump(1) + "\n";
  };
  LoadedGrasp* one = content.single();
  return one != nullptr ? snapped_in(one->grasp) : snapped_in(*content.box());
}

void snap(const SnapArguments& arguments) {
  GraspFile file = read_any_grasp_file(arguments.file, Intervals::kRefused);
  const std::string report = snap(file.content, arguments);
  write_whole_file(arguments.output, write_grasp_file(file));
  (arguments.output == "-" ? std::cerr : std::cout) << report;
}

}  // namespace

void add_snap_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<SnapArguments>();
  Command* command = app.add_subcommand(
      "snap",
      "Write the grasp with rational unit normals, where the length of one is irrational");
  add_grasp_argument(*command, arguments->file);
  add_output_option(*command, arguments->output, "Grasp file")->required();
  command
      ->add_option("--within", arguments->within,
                   "The distance between the true unit normal and its replacement is at most "
                   "this, between 0 and 1")
      ->type_name("EPS")
      ->capture_default_str();
  arguments->numbers.add_to(*command);
  command->footer(footer_text(
      "In the plane the forces of preloaded contacts, exact margins, regions and pictures need\n"
      "normals of rational length; that of (1, 1) is irrational (docs/grasp_file.md). The\n"
      "report, how far each normal moved, goes to standard error if the grasp goes to standard\n"
      "output.\n",
      kExitCodes, "stickslip snap grasp.json -o snapped.json"));
  command->callback([arguments, &exit_code] {
    snap(*arguments);
    exit_code = kDone;
  });
}

}  // namespace stickslip
