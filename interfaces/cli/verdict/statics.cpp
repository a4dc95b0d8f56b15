// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict/statics.hpp"

#include <iostream>
#include <memory>

#include "commands.hpp"
#include "long_work.hpp"
#include "question_options.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/statics_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

struct StaticsArguments {
  QuestionArguments question;
  std::string friction_factor = "1";
  bool least_friction = false;
  std::string direction;
  std::string u;
  std::string v;
  std::string place;
  std::string body;
  std::string accuracy;
  std::string certificate;
  std::string time_limit;
  NumberOptions output;
};

/// Returns "wall: 6 bodies, 16 contacts" and the load, if that is short.
std::string head(const StaticsQuestion& asked, NumberText& text) {
  const Question& question = asked.question;
  const GraspBox box = question.grasp.as_box();
  std::string line = heading(question);
  line += "statics of ";
  if (box.mechanism) line += std::to_string(box.mechanism->bodies.size()) + " bodies, ";
  line += std::to_string(box.contacts.size()) + " contacts\n\n";
  constexpr std::size_t kMostShown = 12;
  const std::size_t components = box.wrench.size();
  if (components <= kMostShown) line += "  load w       " + load_text(box.wrench, text) + "\n";
  const std::vector<RationalRow>& directions = asked.asked.directions;
  const char* const names[] = {"u", "v"};
  for (std::size_t k = 0; k < directions.size() && components <= kMostShown; ++k) {
    line += std::string("  direction ") + names[k] + "  " + text(directions[k]) + "\n";
  }
  if (!asked.least_friction && asked.asked.friction_factor != 1) {
    line += "  friction     times " + text(asked.asked.friction_factor) + "\n";
  }
  return line + "\n";
}

struct FoundText {
  const StaticsAnswer& answer;
  NumberText& text;

  std::string operator()(const RigidForces&) const {
    return answer.asked.question.box() == nullptr ||
                   answer.asked.question.box()->force_limits().empty()
               ? "May stand: forces in the friction cones balance the load, for some stiffness "
                 "and preloads.\n"
               : "May stand: forces in the friction cones and within their limits balance the "
                 "load.\n";
  }
  std::string operator()(const UnopposedMotion& motion) const {
    constexpr std::size_t kMostShown = 12;
    const auto end = motion.twist.begin() +
                     static_cast<std::ptrdiff_t>(answer.asked.question.grasp.wrench().size());
    const RationalRow moved(motion.twist.begin(), end);
    return std::string("Must move, for any stiffness and preloads: ") +
           (end == motion.twist.end() ? "no contact opposes the load"
                                      : "forces within their limits cannot hold the load") +
           " along " +
           (moved.size() <= kMostShown ? text.direction(moved)
                                       : "a motion of " + moving_bodies(moved)) +
           ".\n";
  }
  std::string operator()(const Undecided& undecided) const {
    return "Undecided: " + in_words(undecided) + ".\n";
  }
  std::string operator()(const LoadClass& found) const { return std::visit(*this, found); }
  std::string operator()(const LeastFriction& found) const {
    if (found.high.is_zero()) return "May stand without friction.\n";
    if (found.motion.twist.empty()) {
      return "May stand with all friction times " + text(found.high) +
             "; with less it is undecided.\n";
    }
    const auto [low, high] = text.around(found.low, found.high);
    return "Must move with all friction times " + low + ", and may stand with it times " +
           high + ".\n" + coefficients(found);
  }
  std::string operator()(const LeastFrictionAnswer& found) const {
    if (std::holds_alternative<UnopposedMotion>(found)) {
      return "Must move with any friction, or at least with all of it times a million.\n";
    }
    return std::visit(*this, found);
  }
  std::string operator()(const StandingLoads& found) const {
    const std::vector<RationalRow>& directions = answer.asked.asked.directions;
    std::string lines;
    if (found.is_exact && found.move.empty()) {
      lines = directions.size() == 1 ? "Every l may stand.\n"
                                     : "Every load of the plane may stand.\n";
    } else if (directions.size() == 1) {
      lines =
          multiples(multiples_of(answer.asked.question.grasp.as_box(), found, directions[0]));
    } else if (found.stand.empty()) {
      lines = found.is_complete ? "No load of the plane may stand.\n"
                                : "No load of the plane is known that may stand.\n";
    } else {
      lines = found.is_exact ? "Exactly these (s, t) may stand, the convex hull of\n"
                             : "These (s, t) may stand, the convex hull of\n";
      for (const StandPoint& stand : found.stand) {
        const RationalRow& p = stand.point;
        lines += p[0].is_zero() ? "  towards " + text.direction({p[1], p[2]})
                                : "  " + text(RationalRow{p[1] / p[0], p[2] / p[0]});
        lines += "\n";
      }
      if (!found.is_exact) {
        lines += "and beyond it, at most to an accuracy (--accuracy), all others must move.\n";
      }
    }
    if (!found.is_complete)
      lines += "Not all is known: some loads near the border are undecided.\n";
    return lines;
  }

 private:
  std::string multiples(const StandingMultiples& multiples) const {
    if (multiples.always_moves) return "No l may stand: all must move.\n";
    if (!multiples.any) return "No l is known that may stand.\n";
    std::string lines =
        "May stand: l in " +
        (multiples.low ? "[" + text(*multiples.low) : std::string("(-oo")) + ", " +
        (multiples.high ? text(*multiples.high) + "]" : std::string("oo)")) + "\n";
    std::string borders;
    if (multiples.below) borders = "l below " + text(*multiples.below);
    if (multiples.above) {
      borders += (borders.empty() ? "l above " : ", and above ") + text(*multiples.above);
    }
    if (!borders.empty()) lines += "Must move: " + borders + "\n";
    return lines;
  }

  /// Returns a line with the least coefficient, if all contacts have the same.
  std::string coefficients(const LeastFriction& found) const {
    const GraspBox box = answer.asked.question.grasp.as_box();
    for (const UncertainContact& c : box.contacts) {
      if (c.friction.low != box.contacts.front().friction.low) return "";
    }
    const Rational& mu = box.contacts.front().friction.low;
    if (mu.is_zero()) return "";
    const auto [low, high] = text.around(mu * found.low, mu * found.high);
    return "So the least coefficient of friction is between " + low + " and " + high + ".\n";
  }

  /// Returns the names of the bodies that move most.
  std::string moving_bodies(const RationalRow& motion) const {
    const Mechanism* mechanism = answer.asked.question.mechanism();
    if (mechanism == nullptr) return "the body";
    std::vector<std::pair<double, std::string>> sizes;
    std::size_t first = 0;
    const std::size_t coordinates = mechanism->in_space ? 6 : 3;
    for (const Body& body : mechanism->bodies) {
      if (body.link) continue;
      double size = 0;
      for (std::size_t k = 0; k < coordinates; ++k) {
        size = std::max(size, std::fabs(to_double(motion[first + k])));
      }
      first += coordinates;
      if (size > 0) sizes.emplace_back(-size, body.name);
    }
    std::sort(sizes.begin(), sizes.end());
    constexpr std::size_t kMostNamed = 5;
    std::string names;
    for (std::size_t k = 0; k < std::min(sizes.size(), kMostNamed); ++k) {
      names += (names.empty() ? "" : ", ") + sizes[k].second;
    }
    if (sizes.size() > kMostNamed) {
      names += " and " + std::to_string(sizes.size() - kMostNamed) + " more bodies";
    }
    return names.empty() ? "joints" : names;
  }
};

void write_certificates(const StaticsAnswer& answer, const std::string& file,
                        const std::string& grasp, bool tells) {
  const std::vector<StaticsCertificate> certificates = certificates_of(answer);
  if (certificates.empty())
    say_nothing_written("--certificate", "the answer is undecided, so there is no proof of it");
  for (const StaticsCertificate& certificate : certificates) {
    std::string name = file;
    if (answer.asked.least_friction) {
      const std::size_t dot = name.rfind(".json");
      name.insert(dot == std::string::npos ? name.size() : dot, "." + certificate.name);
    }
    write_whole_file(name, certificate.text);
    if (tells && name != "-") {
      std::cout << "Check it: stickslip-check " << grasp << ' ' << name << ' '
                << certificate.options << '\n';
    }
  }
}

int statics(const StaticsArguments& arguments) {
  StaticsQuestion asked{arguments.question.any_question()};
  asked.asked.friction_factor = rational_at("--friction-factor", arguments.friction_factor);
  asked.least_friction = arguments.least_friction;
  std::vector<RationalRow>& directions = asked.asked.directions;
  for (const auto& [option, value] : {std::pair("--direction", arguments.direction),
                                      {"--u", arguments.u},
                                      {"--v", arguments.v}}) {
    if (!value.empty()) directions.push_back(rationals_at(option, value));
  }
  const bool is_loaded = arguments.question.chooses_load();
  asked.gives_wrench = !arguments.place.empty() || arguments.question.gives_wrench();
  if (!directions.empty() && !is_loaded) {
    set_load(asked.question, RationalRow(asked.question.grasp.wrench().size()));
  }
  if (!arguments.place.empty()) {
    auto [load, ways] = loads_of_places(
        asked.question, rationals_at("--place", arguments.place), arguments.body);
    add_load(asked.question, load);
    directions = std::move(ways);
  }
  asked.accuracy = !arguments.accuracy.empty()
                       ? positive_option("--accuracy", arguments.accuracy)
                   : asked.least_friction ? Rational(1, 1000000)
                                          : Rational(1, 1000);
  return answer_statics(std::move(asked), arguments.certificate,
                        arguments.question.name_of_argument(), arguments.output,
                        time_limit_option(arguments.time_limit));
}

}  // namespace

int answer_statics(StaticsQuestion asked, const std::string& certificate,
                   const std::string& grasp, const NumberOptions& output,
                   const TimeLimit& time) {
  StaticsAnswer answer{asked, LoadClass(out_of_time(time))};
  LongWork work("statics", time);
  try {
    work.finishes([&] { answer = statics(std::move(asked)); });
  } catch (const InputError& error) {
    if (error.place() == "friction") {
      throw InputError("", "--friction-factor", error.problem(), error.remedy());
    }
    throw;
  }
  if (output.json) {
    std::cout << finished(to_json(answer), output.floats).dump(1) << '\n';
  } else {
    NumberText text(output);
    std::cout << head(answer.asked, text) << std::visit(FoundText{answer, text}, answer.found)
              << conventions_text(answer.asked.question) << text.note();
  }
  if (!certificate.empty()) write_certificates(answer, certificate, grasp, !output.json);
  return answer.undecided() ? kUndecidedWithinLimit : kDone;
}

void add_statics_command(Command& app, int& exit_code) {
  auto arguments = std::make_shared<StaticsArguments>();
  Command* command = app.add_subcommand("statics",
                                        "May it stand at all, whatever stiffness and preloads "
                                        "are? With which friction and loads?");
  arguments->question.add_to(*command);
  arguments->question.take_limits();
  command
      ->add_option("--friction-factor", arguments->friction_factor,
                   "Multiply all friction by this number")
      ->type_name("F")
      ->capture_default_str();
  CommandOption* least =
      command->add_flag("--least-friction", arguments->least_friction,
                        "Ask for the least factor of all friction with which it may stand");
  CommandOption* direction =
      command
          ->add_option(
              "--direction", arguments->direction,
              "Load u: which multiples l may stand under the load w + l u? Then w is 0 "
              "unless it or a case is given")
          ->type_name("WX,WY,T")
          ->excludes(least);
  CommandOption* u =
      command
          ->add_option(
              "--u", arguments->u,
              "With --v: which (s, t) may stand under the load w + s u + t v, with w as "
              "above?")
          ->type_name("WX,WY,T")
          ->excludes(least)
          ->excludes(direction);
  CommandOption* v = command->add_option("--v", arguments->v, "The second direction")
                         ->type_name("WX,WY,T")
                         ->needs(u);
  u->needs(v);
  CommandOption* place =
      command
          ->add_option(
              "--place", arguments->place,
              "A force besides the load, such as a weight 0,0,-10: at which places (x, y), "
              "or x in the plane, may it act? So where may the centre of mass be?")
          ->type_name("FX,FY,FZ")
          ->excludes(least)
          ->excludes(direction)
          ->excludes(u);
  command
      ->add_option("--body", arguments->body,
                   "The body of several that the force of --place is on")
      ->type_name("NAME")
      ->needs(place);
  command
      ->add_option(
          "--accuracy", arguments->accuracy,
          "Where ends are not exact: the part of a factor, or of a way to the border, that "
          "may be left; default: 1/1000000 for friction, 1/1000 for loads")
      ->type_name("PART");
  command
      ->add_option(
          "--certificate", arguments->certificate,
          "Write a proof for stickslip-check --statics (certificate/FORMAT.md, section "
          "16); with --least-friction two, FILE.moves and FILE.stands, before .json if it "
          "ends in that")
      ->type_name("FILE");
  add_time_limit_option(*command, arguments->time_limit);
  arguments->output.add_to(*command);
  command->footer(footer_text(
      "It may stand if some forces in Coulomb's cones balance the load; else it must move, "
      "with\n"
      "any stiffness and preloads (docs/statics.md). One body or any number of them, in the "
      "plane\n"
      "and in space, with torsion; joints with stiffness hold, those without exert their "
      "torque.\n"
      "What may stand may still fall: stickslip decide asks about contacts with their "
      "stiffness.\n",
      kExitCodesWithLimit,
      "stickslip statics fig1.json --wrench 0,1,0 --least-friction\n"
      "  $ stickslip statics fig1.json --place 0,-1 --certificate places.json"));
  command->callback([arguments, &exit_code] { exit_code = statics(*arguments); });
}

}  // namespace stickslip
