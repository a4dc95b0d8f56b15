// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "example_grasps.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

void list_examples() {
  std::vector<std::vector<std::string>> table{{"name", "what it is"}};
  for (const ExampleGrasp& example : example_grasps()) {
    table.push_back(
        {example.name, parse_any_grasp(example.text, example.name).description().name});
  }
  std::cout << format_table(table, Align::kLeft)
            << "\nFor one of them: stickslip example jaw -o jaw.json\n";
}

}  // namespace

const std::string& text_of_example(const std::string& name) {
  std::vector<std::string> known;
  for (const ExampleGrasp& example : example_grasps()) {
    if (example.name == name) return example.text;
    known.push_back(example.name);
  }
  throw InputError("", "", "there is no example " + quote(name),
                   choice_of(name, known, "there are "));
}

void add_example_command(Command& app, int& exit_code) {
  struct Arguments {
    std::string name;
    std::string output = "-";
  };
  auto arguments = std::make_shared<Arguments>();
  Command* command = app.add_subcommand(
      "example", "Write a grasp file to start from, or list those there are");
  command->add_option("NAME", arguments->name, "The example; without it they are listed")
      ->type_name("WORD");
  add_output_option(*command, arguments->output, "Grasp file");
  command->footer(footer_text("", kExitCodes, "stickslip example jaw | stickslip decide -"));
  command->callback([arguments, &exit_code] {
    if (arguments->name.empty()) {
      list_examples();
    } else {
      write_whole_file(arguments->output, text_of_example(arguments->name));
    }
    exit_code = kDone;
  });
}

}  // namespace stickslip
