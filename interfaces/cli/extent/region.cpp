// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <iostream>
#include <memory>
#include <string_view>

#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "region_cells.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/region_plot.hpp"
#include "terminal.hpp"
#include "verdict/statics.hpp"

namespace stickslip {
namespace {

struct RegionArguments : RegionAsked {
  QuestionArguments question;
  std::size_t mode_limit = 0;
  bool list = false;
  bool asks_class = false;
  std::string certificate;
  bool svg = false;
  std::string output = "-";

  /// Refuses options that have no meaning for a grasp of this kind.
  void check(const Question& asked) const {
    const auto refuse = [](bool is_given, const char* option, const char* problem,
                           const char* remedy) {
      if (is_given) throw InputError("", option, problem, remedy);
    };
    if (!is_found_in_cells(asked)) {
      const char* problem = "it is about a region that is found cell by cell";
      const char* remedy =
          "leave it out: in the plane the region is exact, and has no window, unless motions "
          "are bounded or a preloaded normal has an irrational length";
      refuse(!within.empty(), "--within", problem, remedy);
      refuse(cells.depth != CellsAsked().depth, "--depth", problem, remedy);
      refuse(!cells.certificates.empty(), "--certificates", problem,
             "write one proof of the whole region with --certificate");
      return;
    }
    const char* problem =
        asked.in_space()     ? "it is done in the plane only, and the grasp is in space"
        : asked.is_bounded() ? "it is done without a bound on motions only"
                             : "a preloaded contact has a normal of irrational length";
    refuse(asked.in_space() && !torque.empty(), "--torque", problem,
           "give --origin, a wrench of six numbers");
    refuse(list, "--list", problem, "print the cells with --json");
    refuse(mode_limit != 0, "--mode-limit", problem,
           "give --depth, or --node-limit for each proof");
    refuse(!certificate.empty(), "--certificate", problem,
           "write a proof of each cell with --certificates");
  }

  /// Returns the plane, through the load of a case if one is chosen.
  WrenchPlane plane(const Question& asked) const {
    Wrench from = asked.loaded().wrench;
    if (!origin.empty()) from = wrench_option("--origin", origin);
    if (!torque.empty()) from.torque = rational_at("--torque", torque);
    try {
      return {from, wrench_option("--u", u.empty() ? "1,0,0" : u),
              wrench_option("--v", v.empty() ? "0,1,0" : v)};
    } catch (const InputError& error) {
      if (!error.place().empty() && error.place().front() == '-') throw;
      throw InputError("", "--u, --v", error.problem(), error.remedy());
    }
  }
};

std::string mode_text(const ResistiblePiece& piece) {
  std::string text;
  for (const ContactMode mode : piece.modes) text += mode.closed ? to_char(mode.slip) : '.';
  return text;
}

std::string text_of(const PlaneCell& cell, NumberText& text) {
  std::string line;
  for (const PlanePoint& point : cell.vertices()) {
    line += (line.empty() ? "" : " ") + text(point);
  }
  for (const PlaneDirection& ray : cell.rays()) line += " towards " + text.direction(ray);
  return line;
}

void print_outline(const Outline& outline, NumberText& text) {
  std::cout << "  " << (outline.is_closed() ? "closed:" : "open:  ");
  if (outline.from)
    std::cout << " from infinity along " << text.direction(*outline.from) << " to";
  for (const PlanePoint& point : outline.vertices) std::cout << ' ' << text(point);
  if (outline.to) std::cout << " to infinity along " << text.direction(*outline.to);
  std::cout << '\n';
}

void print_text(const RegionAnswer& answer, const NumberOptions& output) {
  const auto& [question, plane, found, work, undecided] = answer;
  const auto& [region, pieces] = found;
  NumberText text(output);
  const std::string& name = question.loaded().grasp.name();
  std::cout << (name.empty() ? "" : name + ": ") << "resistible wrenches\n\n"
            << "  plane  " << text(coordinates(plane.origin())) << " + s "
            << text(coordinates(plane.u())) << " + t " << text(coordinates(plane.v()))
            << "\n\n";
  if (undecided) {
    std::cout << "No region is known: " << in_words(*undecided) << ".\n";
  } else if (region.is_empty()) {
    std::cout << "No wrench of the plane is resisted.\n";
  } else if (region.is_whole_plane()) {
    std::cout << "Every wrench of the plane is resisted.\n";
  } else {
    std::cout << "Exactly these (s, t) are resisted, borders included";
    std::cout << (region.areas.empty() ? ":\n" : "; areas lie to the left of outlines:\n");
    for (const PlaneArea& area : region.areas) {
      std::cout << "area\n";
      for (const Outline& outline : area.outlines) print_outline(outline, text);
    }
    for (const PlaneCell& curve : region.curves) {
      std::cout << (curve.is_bounded()         ? "segment "
                    : curve.rays().size() == 1 ? "ray "
                                               : "line ")
                << text_of(curve, text) << '\n';
    }
    for (const PlanePoint& point : region.points) {
      std::cout << "point " << text(point) << '\n';
    }
  }
  if (!pieces.empty())
    std::cout << "\nPieces, by contact mode (+ and - slip, 0 sticks, . has no force):\n";
  for (const ResistiblePiece& piece : pieces) {
    std::cout << "  " << mode_text(piece) << "  " << text_of(piece.cell, text) << '\n';
  }
  std::cout << '\n'
            << work.modes << " contact modes visited, " << work.pieces
            << " of them in the plane; normal law: " << law_text(question.law) << ".\n"
            << conventions_text(question) << text.note();
}

/// Returns the word as a shell reads it.
std::string in_shell(const std::string& word) {
  const bool is_plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_./,:=+-%").find(c) != std::string_view::npos;
  });
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// Returns the checker's command for the certificate.
std::string check_text(const RegionArguments& arguments, const WrenchPlane& plane) {
  const auto numbers = [](const Wrench& w) {
    return to_string(w.x) + "," + to_string(w.y) + "," + to_string(w.torque);
  };
  const QuestionText& asked = arguments.question.text();
  std::string command = "stickslip-check " + in_shell(arguments.question.name_of_argument()) +
                        " " + in_shell(arguments.certificate) +
                        " --plane=" + numbers(plane.u()) + "," + numbers(plane.v());
  if (!asked.case_name.empty()) {
    command += " --case " + in_shell(asked.case_name);
  } else if (!(plane.origin() == Wrench{})) {
    command += " --wrench=" + numbers(plane.origin());
  }
  if (!asked.preload.empty()) command += " --preload " + in_shell(asked.preload);
  if (asked.normal_law != "unilateral") command += " --normal-law " + asked.normal_law;
  return "Check it: " + command + "\n";
}

RegionOptions options_of(const RegionArguments& arguments, LongWork& work) {
  RegionOptions options;
  options.modes.pieces = arguments.list;
  options.modes.mode_limit = arguments.mode_limit;
  options.modes.progress = [&](std::size_t modes) {
    work.say("contact modes: " + std::to_string(modes));
  };
  options.proof.node_limit = arguments.cells.node_limit;
  options.proof.progress = [&](const RegionProofWork& so_far) {
    work.say("refuting cell " + std::to_string(so_far.cells) + ", node " +
             std::to_string(so_far.nodes));
  };
  return options;
}

/// Answers which loads of the plane may stand, under rigid contacts.
int answer_statics_of_plane(const Question& question, const RegionArguments& arguments) {
  if (!arguments.torque.empty()) {
    throw InputError("", "--torque", "it is about the region of the passive model",
                     "give --origin");
  }
  StaticsQuestion asked{question};
  const std::size_t size = question.grasp.wrench().size();
  const auto row = [&](const char* option, const std::string& given, std::size_t unit) {
    if (!given.empty()) return rationals_at(option, given);
    RationalRow result(size);
    if (unit < size) result[unit] = 1;
    return result;
  };
  asked.asked.directions = {row("--u", arguments.u, 0), row("--v", arguments.v, 1)};
  if (!arguments.origin.empty()) {
    const RationalRow origin = rationals_at("--origin", arguments.origin);
    if (origin.size() != size) {
      throw InputError("", "--origin", "it has " + std::to_string(origin.size()) + " numbers",
                       "give " + std::to_string(size));
    }
    set_load(asked.question, origin);
    asked.gives_wrench = true;
  }
  asked.accuracy = Rational(1, 1000);
  return answer_statics(std::move(asked), arguments.certificate,
                        arguments.question.name_of_argument(), arguments.numbers,
                        time_limit_option(arguments.time_limit));
}

int region(const RegionArguments& arguments) {
  const Question asked = arguments.question.any_question();
  if (arguments.asks_class) return answer_statics_of_plane(asked, arguments);
  // A certificate of a region is about a file of one body.
  const Question question = arguments.certificate.empty() ? as_one_body(asked) : asked;
  require_one_body(question, "region");
  arguments.check(question);
  if (is_found_in_cells(question)) return answer_region_in_cells(question, arguments);
  const WrenchPlane plane = arguments.plane(question);
  LongWork work("region", time_limit_option(arguments.time_limit));
  const RegionOptions options = options_of(arguments, work);
  RegionAnswer answer{question, plane, {}, {}, out_of_time(work.limit())};
  work.finishes([&] { answer = region_answer(question, plane, options); });
  if (!arguments.certificate.empty() && !answer.undecided) {
    std::variant<std::string, Undecided> proved = out_of_time(work.limit());
    work.finishes([&] { proved = certificate_of(answer, options); });
    if (const auto* undecided = std::get_if<Undecided>(&proved)) {
      std::cerr << "stickslip: the region has no certificate: " << in_words(*undecided) << '\n';
      return kUndecidedWithinLimit;
    }
    write_whole_file(arguments.certificate, std::get<std::string>(proved));
  }
  if (arguments.numbers.json) {
    std::cout << finished(to_json(answer), arguments.numbers.floats).dump(1) << '\n';
  } else {
    print_text(answer, arguments.numbers);
    if (!arguments.certificate.empty() && !answer.undecided) {
      std::cout << check_text(arguments, plane);
    }
  }
  return answer.undecided ? kUndecidedWithinLimit : kDone;
}

int draw_region(const RegionArguments& arguments) {
  const Question question = as_one_body(arguments.question.any_question());
  require_one_body(question, "region");
  arguments.check(question);
  if (is_found_in_cells(question)) {
    return draw_region_in_cells(question, arguments, arguments.output);
  }
  const WrenchPlane plane = arguments.plane(question);
  LongWork work("region", time_limit_option(arguments.time_limit));
  RegionAnswer answer{question, plane, {}, {}, out_of_time(work.limit())};
  work.finishes([&] { answer = region_answer(question, plane, options_of(arguments, work)); });
  if (answer.undecided) {
    std::cerr << "stickslip: no region is known: " << in_words(*answer.undecided) << '\n';
    return kUndecidedWithinLimit;
  }
  write_whole_file(arguments.output, plot_region(answer.question, plane, answer.found.region));
  return kDone;
}

/// Adds GRASP, the plane and the limit.
void add_region_options(Command& command, RegionArguments& arguments) {
  arguments.question.add_without_wrench_to(command);
  arguments.question.add_max_motion_to(command);
  CommandOption* origin =
      command
          .add_option(
              "--origin", arguments.origin,
              "The plane asked about is ORIGIN + s U + t V; the origin is 0,0,0 by default")
          ->type_name("WX,WY,T");
  CommandOption* torque =
      command.add_option("--torque", arguments.torque, "Short for --origin 0,0,T")
          ->type_name("T")
          ->excludes(origin);
  arguments.question.add_case_to(command, "The origin is the load of this case of the file")
      ->excludes(origin)
      ->excludes(torque);
  command
      .add_option(
          "--u", arguments.u,
          "First direction of the plane; default: a force along x. In space six numbers, "
          "as the origin")
      ->type_name("WX,WY,T");
  command.add_option("--v", arguments.v, "Second direction; default: a force along y")
      ->type_name("WX,WY,T");
  command
      .add_option(
          "--within", arguments.within,
          "In space, or where motions are bounded: the window of s and t that is looked "
          "at, cell by cell; default: as far either way as all preloads together, or 1")
      ->type_name("S0:S1,T0:T1");
  constexpr std::uint64_t kMostDepth = 12;
  add_count_option(command, "--depth", arguments.cells.depth,
                   "Cell by cell: the finest are a 2^N-th of the window", kMostDepth);
  add_count_option(
      command, "--mode-limit", arguments.mode_limit,
      "Give up, undecided, at more than N contact modes (which contacts slip, which way, "
      "stick or are detached); 0 is no limit");
}

}  // namespace

void add_region_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<RegionArguments>();
  Command* command = app.add_subcommand(
      "region",
      "Which wrenches of a plane does the grasp resist? The exact set; in space, and where "
      "motions are bounded, cell by cell");
  add_region_options(*command, *arguments);
  command->add_flag(
      "--class", arguments->asks_class,
      "Ask instead which loads of the plane may stand, under rigid contacts with any "
      "stiffness and preloads, of one body or several (stickslip statics)");
  CommandOption* list = command->add_flag(
      "--list", arguments->list,
      "List the piece of each contact mode: slips, contacts with a force, polygon");
  CommandOption* certificate =
      command
          ->add_option("--certificate", arguments->certificate,
                       "Write a proof that exactly this region is resisted, which "
                       "stickslip-check checks (certificate/FORMAT.md)")
          ->type_name("FILE");
  command
      ->add_option("--certificates", arguments->cells.certificates,
                   "Cell by cell: write each that is proved there, with its certificate")
      ->type_name("DIR")
      ->excludes(certificate);
  add_node_limit_option(*command, arguments->cells.node_limit);
  add_time_limit_option(*command, arguments->time_limit);
  arguments->numbers.add_to(*command);
  command->add_flag("--svg", arguments->svg, "Print a picture, as stickslip plot region does")
      ->excludes(command->get_option("--json"))
      ->excludes(list)
      ->excludes(certificate);
  command->footer(footer_text(
      "By default the plane is that of forces at zero torque. The wrench in the file plays no "
      "part,\n"
      "unless --case chooses one. In space, and where motions are bounded, a window of it is "
      "decided\n"
      "cell by cell, as by stickslip map: cells whose verdict is not the same throughout are "
      "cut, along\n"
      "the border down to the finest.\n",
      kExitCodesWithLimit, "stickslip region fig1.json --preload 1"));
  command->callback([arguments, &exit_code] {
    exit_code = arguments->svg ? draw_region(*arguments) : region(*arguments);
  });
}

void add_region_plot(Command& plot, int& exit_code) {
  auto arguments = std::make_shared<RegionArguments>();
  Command* command = plot.add_subcommand(
      "region", "The resistible wrenches of a plane, by default forces at zero torque");
  add_region_options(*command, *arguments);
  add_time_limit_option(*command, arguments->time_limit);
  add_output_option(*command, arguments->output, "SVG file");
  command->footer(footer_text("", kExitCodesWithLimit,
                              "stickslip plot region fig1.json --preload 1 -o region.svg"));
  command->callback([arguments, &exit_code] { exit_code = draw_region(*arguments); });
}

}  // namespace stickslip
