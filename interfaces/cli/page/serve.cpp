// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "grasp/example_grasps.hpp"
#include "interruption.hpp"
#include "long_work.hpp"
#include "page_server.hpp"
#include "question_options.hpp"
#include "stickslip/interfaces/answer.hpp"
#include "stickslip/interfaces/html.hpp"

namespace stickslip {
namespace {

struct ServeArguments {
  std::string file;
  int port = 0;
  std::size_t node_limit = 100000;
  std::string seconds = "10";
};

GraspFile grasp_of(const ServeArguments& arguments) {
  if (!arguments.file.empty()) return read_any_grasp_file(arguments.file);
  return parse_any_grasp(text_of_example("jaw"), "jaw");
}

void serve(const ServeArguments& arguments) {
  PageLimits limits;
  limits.node_limit = arguments.node_limit;
  limits.time = milliseconds_option(arguments.seconds);
  limits.limits_verdict = true;
  const std::string name = arguments.file == "-" ? "<stdin>" : arguments.file;
  // The page asks for the rest, which may take seconds.
  const PageParts first{PagePart::kDecide, PagePart::kStates, PagePart::kWarnings};
  Json answer = page_answer(grasp_of(arguments), {}, first, limits, name);
  answer["live"] = true;
  PageServer server({[&](const std::string& nonce) { return page_html(answer, nonce); },
                     [&](const std::string& request) {
                       PageReply reply = reply_to(request, limits);
                       return std::pair{reply.status, std::move(reply.body)};
                     }},
                    arguments.port);
  const InterruptionStop stop([&] { server.stop(); });
  std::cout << "http://127.0.0.1:" << server.port() << "/ (Ctrl-C ends it)" << std::endl;
  server.run();
}

}  // namespace

void add_serve_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<ServeArguments>();
  Command* command = app.add_subcommand(
      "serve", "The page, live: drag contacts and loads, and the verdict follows, exactly");
  command
      ->add_option("GRASP", arguments->file,
                   "Grasp file to begin with; - is standard input. Without it, an example")
      ->type_name("FILE");
  constexpr std::uint64_t kMostPort = 65535;
  add_count_option(*command, "--port", arguments->port, "Port to listen on; 0 is any free one",
                   kMostPort);
  add_node_limit_option(*command, arguments->node_limit);
  add_time_limit_option(*command, arguments->seconds,
                        "Give up each part of an answer after so many seconds; 0 is no limit");
  command->footer(footer_text(
      "It prints the address, which a browser on this machine opens, and no other machine: it\n"
      "listens on 127.0.0.1 and answers to its own page alone. No file is read or written for\n"
      "what it is asked (docs/page.md).\n",
      kExitCodes, "stickslip serve fig1.json"));
  command->callback([arguments, &exit_code] {
    serve(*arguments);
    exit_code = kDone;
  });
}

}  // namespace stickslip
