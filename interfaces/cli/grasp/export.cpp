// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "commands.hpp"
#include "question_options.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/file.hpp"

namespace stickslip {
namespace {

struct ExportArguments {
  QuestionArguments question;
  bool smt2 = false;
  std::string output = "-";
};

}  // namespace

void add_export_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<ExportArguments>();
  Command* command =
      app.add_subcommand("export", "Write the question for other solvers, such as Z3 and cvc5");
  arguments->question.add_to(*command);
  arguments->question.add_max_motion_to(*command);
  command
      ->add_flag("--smt2", arguments->smt2,
                 "SMT-LIB 2, logic QF_LRA, in space QF_NRA: sat means stable, unsat unstable")
      ->required();
  add_output_option(*command, arguments->output, "SMT-LIB file");
  command->footer(
      footer_text("", kExitCodes, "stickslip export fig1.json --smt2 -o fig1.smt2"));
  command->callback([arguments, &exit_code] {
    const Question question = as_one_body(arguments->question.any_question());
    require_one_body(question, "the problem in SMT-LIB");
    write_whole_file(arguments->output, smtlib_text(question));
    exit_code = kDone;
  });
}

}  // namespace stickslip
