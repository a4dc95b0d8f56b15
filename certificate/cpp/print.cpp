// SPDX-License-Identifier: MIT
#include "print.hpp"

#include "check.hpp"

namespace stickslip_check {
namespace {

/// In quotation marks, all of it printable ASCII.
std::string json_string(const std::string& text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string list(const Vector& v, const char* open, const char* close, bool quoted) {
  std::string text;
  for (const Rational& c : v) {
    text += text.empty() ? "" : ", ";
    text += quoted ? json_string(c.get_str()) : c.get_str();
  }
  return open + text + close;
}

std::string text_of(const Wrench& wrench) {
  std::string text;
  for (const Bounds& w : wrench) {
    text += text.empty() ? "" : ", ";
    text += w.certain() ? w.low.get_str() : list({w.low, w.high}, "[", "]", false);
  }
  return "(" + text + ")";
}

std::string json_wrench(const Wrench& wrench) {
  std::string text;
  for (const Bounds& w : wrench) {
    text += text.empty() ? "" : ", ";
    text += w.certain() ? json_string(w.low.get_str()) : list({w.low, w.high}, "[", "]", true);
  }
  return "[" + text + "]";
}

std::string text_of(const Ball& ball) {
  return "ball:" + ball.radius.get_str() + ", length " + ball.length.get_str() + ", about " +
         list(ball.about, "(", ")", false) +
         (ball.body ? ", on the body \"" + printable(*ball.body) + '"' : "");
}

std::string json_ball(const Ball& ball) {
  return R"({"ball": )" + json_string(ball.radius.get_str()) + R"(, "length": )" +
         json_string(ball.length.get_str()) + R"(, "about": )" +
         list(ball.about, "[", "]", true) +
         (ball.body ? R"(, "body": )" + json_string(*ball.body) : "") + "}";
}

/// All tolerances that were given, each after its kind and `between`, in their order.
std::string tolerances(const Options& asked, const char* between, bool quoted) {
  std::string text;
  for (const char* kind : kUncertainKinds) {
    const auto found = asked.uncertain.find(kind);
    if (found == asked.uncertain.end()) continue;
    const Tolerance& tolerance = found->second;
    std::string size = tolerance.size.get_str() + (tolerance.percent ? "%" : "");
    if (quoted) size = json_string(size);
    if (tolerance.ball) size = quoted ? json_ball(*tolerance.ball) : text_of(*tolerance.ball);
    text += (text.empty() ? "" : ", ") + (quoted ? json_string(kind) : kind) + between + size;
  }
  return text;
}

std::string in_words(const std::vector<Interval>& intervals) {
  std::string text;
  for (const auto& [low, high] : intervals) {
    text += (text.empty() ? "[" : ", [") + low.get_str() + ", " +
            (high ? high->get_str() + "]" : "oo)");
  }
  return text;
}

std::string in_words(const std::vector<Range>& ranges) {
  std::string text;
  for (const auto& [low, high, open_low, open_high] : ranges) {
    text += (text.empty() ? "" : ", ") + std::string(open_low ? "(" : "[") + low.get_str() +
            ", " + (high ? high->get_str() : "oo") + ")";
  }
  return text;
}

/// "from A to B" with ends that there are.
std::string in_words(const Standing& standing) {
  std::string text = "may stand   ";
  if (standing.any) {
    text += (standing.low_end ? "[" + standing.low.get_str() : "(-oo") + ", " +
            (standing.high_end ? standing.high.get_str() + "]" : "oo)");
  } else {
    text += "none claimed";
  }
  text += "\nmust move   ";
  if (standing.always_moves) return text + "all";
  std::string ends = standing.below ? "below " + standing.below->get_str() : "";
  if (standing.above)
    ends += (ends.empty() ? "above " : ", above ") + standing.above->get_str();
  return text + (ends.empty() ? "none claimed" : ends);
}

std::string json_standing(const Standing& standing) {
  const auto end = [](bool is_there, const Rational& value) {
    return is_there ? json_string(value.get_str()) : "null";
  };
  const auto border = [&](const std::optional<Rational>& value) {
    return end(value.has_value(), value.value_or(0));
  };
  return R"({"stand": )" +
         (standing.any ? "[" + end(standing.low_end, standing.low) + ", " +
                             end(standing.high_end, standing.high) + "]"
                       : "null") +
         R"(, "move": )" +
         (standing.always_moves
              ? "\"all\""
              : "[" + border(standing.below) + ", " + border(standing.above) + "]") +
         "}";
}

std::string json_integers(const std::vector<Integer>& integers) {
  std::string text;
  for (const Integer& x : integers) text += (text.empty() ? "" : ", ") + x.get_str();
  return "[" + text + "]";
}

std::string json_intervals(const std::vector<Interval>& intervals) {
  std::string text;
  for (const auto& [low, high] : intervals) {
    text += (text.empty() ? "[" : ", [") + json_string(low.get_str()) + ", " +
            (high ? json_string(high->get_str()) : "null") + "]";
  }
  return "[" + text + "]";
}

std::string json_ranges(const std::vector<Range>& ranges) {
  std::string text;
  for (const auto& [low, high, open_low, open_high] : ranges) {
    text += (text.empty() ? "[" : ", [") + json_string(low.get_str()) + ", " +
            (high ? json_string(high->get_str()) : "null") +
            (open_low ? ", false]" : ", true]");
  }
  return "[" + text + "]";
}

std::string json_question(const Question& question) {
  const Options& asked = question.asked;
  const auto& growth = asked.preload_direction;
  if (asked.states) {
    return R"({"contacts": )" + std::to_string(question.contacts.size()) + R"(, "states": )" +
           json_string(*asked.states) + "}";
  }
  if (asked.robustness) {
    return R"({"contacts": )" + std::to_string(question.contacts.size()) + R"(, "wrench": )" +
           json_wrench(question.wrench) + R"(, "robustness": )" +
           json_string(*asked.robustness) + R"(, "length": )" +
           json_string(asked.length->get_str()) + R"(, "max_force": )" +
           list(*asked.max_force, "[", "]", true) + "}";
  }
  return R"({"contacts": )" + std::to_string(question.contacts.size()) + R"(, "wrench": )" +
         json_wrench(question.wrench) + R"(, "preload": )" +
         (asked.preload ? json_string(asked.preload->get_str()) : "null") +
         R"(, "normal_law": )" + json_string(law_name(asked.bilateral)) + R"(, "direction": )" +
         (asked.direction ? list(*asked.direction, "[", "]", true) : "null") +
         R"(, "preload_direction": )" +
         (!growth ? "null"
                  : (growth->scale ? "\"scale\"" : list(growth->values, "[", "]", true))) +
         (!asked.plane ? ""
                       : R"(, "plane": [)" + list((*asked.plane)[0], "[", "]", true) + ", " +
                             list((*asked.plane)[1], "[", "]", true) + "]") +
         (!asked.inertia ? "" : R"(, "inertia": )" + list(*asked.inertia, "[", "]", true)) +
         (!asked.statics ? "" : R"(, "statics": )" + json_string(asked.statics->get_str())) +
         R"(, "uncertain": )" +
         (asked.uncertain.empty() ? "null" : "{" + tolerances(asked, ": ", true) + "}") +
         (!asked.max_motion ? ""
                            : R"(, "max_motion": )" + list(*asked.max_motion, "[", "]", true)) +
         "}";
}

/// How many there are; of several bodies, which elements, and the coordinates of their motion.
std::string contacts_of(const Question& question) {
  const std::size_t m = question.contacts.size();
  if (!question.several) return std::to_string(m);
  std::size_t kinds[3]{};
  for (std::size_t i = 0; i < m; ++i) {
    const Sight sight = question.contacts[i].sight;
    ++kinds[is_contact(sight) ? 0 : is_spring(sight) ? 2 : 1];
  }
  std::string text = std::to_string(kinds[0]) + "; ratchets: " + std::to_string(kinds[1]) +
                     "; springs: " + std::to_string(kinds[2]) + "\ncoordinates ";
  for (const std::string& name : question.several->coordinates) {
    text += (text.back() == ' ' ? "" : ", ") + printable(name);
  }
  return text;
}

/// FORMAT.md §17.
std::string text_of_states(const Accepted& a) {
  Integer all = 0;
  std::string numbers;
  for (const Integer& f : a.by_dimension) {
    all += f;
    numbers += (numbers.empty() ? "" : ", ") + f.get_str();
  }
  return "accepted\nverdict     complete: " + all.get_str() + " states, of the set " +
         *a.question.asked.states + "\ncontacts    " + contacts_of(a.question) +
         "\ndimensions  " + numbers + "\nproof       motions: " + std::to_string(a.listed) +
         "\n";
}

/// FORMAT.md §18.
std::string text_of_robustness(const Accepted& a) {
  const Options& asked = a.question.asked;
  return "accepted\nrobustness  of the " + *asked.robustness + ", from " +
         a.bounds->low.get_str() + " to " + a.bounds->high.get_str() + "\ncontacts    " +
         contacts_of(a.question) + "\nwrench      " + text_of(a.question.wrench) +
         "\nlength      " + asked.length->get_str() + "\nmax force   " +
         list(*asked.max_force, "(", ")", false) + "\nproof       forces, and a tree of " +
         std::to_string(a.nodes) + " nodes: " + std::to_string(a.leaves) + " leaves\n";
}

std::string text_of(const Accepted& a) {
  if (a.question.asked.states) return text_of_states(a);
  if (a.question.asked.robustness) return text_of_robustness(a);
  const Options& asked = a.question.asked;
  const auto& growth = asked.preload_direction;
  const bool margin = a.verdict == "margin";
  const bool statics = asked.statics.has_value();
  const bool in_ranges = margin && a.question.claims() && !statics;
  const auto list_or = [](const std::string& listed, const char* none) {
    return listed.empty() ? none : listed;
  };
  std::string text = "accepted\n";
  if (a.standing) {
    text += in_words(*a.standing) + "\nelsewhere   nothing is claimed";
  } else if (statics && asked.plane) {
    text += "may stand   the sums of load points: " + std::to_string(a.stands) +
            "\nmust move   where a load does work on a twist: " + std::to_string(a.moves);
  } else if (in_ranges) {
    text += "resisted    " + list_or(in_words(a.resisted), "none claimed") + "\nrefuted     " +
            list_or(in_words(a.refuted), "none claimed") + "\nelsewhere   nothing is claimed";
  } else if (margin) {
    text += "resisted    " + list_or(in_words(a.resisted), "no multiple");
  } else if (a.verdict == "region") {
    text += "resisted    " +
            (a.pieces == 0 ? "no load of the plane"
                           : "of the plane exactly the pieces: " + std::to_string(a.pieces));
  } else {
    text += "verdict     " + a.verdict;
    if (a.question.is_box) text += ", for every grasp in the box";
  }
  text += "\ncontacts    " + contacts_of(a.question);
  text += "\nwrench      " + text_of(a.question.wrench);
  if (asked.direction) text += "\ndirection   " + list(*asked.direction, "(", ")", false);
  if (asked.plane) {
    text += "\nplane       wrench + s " + list((*asked.plane)[0], "(", ")", false) + " + t " +
            list((*asked.plane)[1], "(", ")", false);
  }
  if (asked.inertia) text += "\ninertia     " + list(*asked.inertia, "(", ")", false);
  if (statics) text += "\nstatics     friction times " + asked.statics->get_str();
  text += "\npreload     ";
  if (growth && growth->scale) text += "f times ";
  text +=
      asked.preload ? asked.preload->get_str() + " at all contacts" : "as in the grasp file";
  if (growth && !growth->scale) text += " + f " + list(growth->values, "(", ")", false);
  text += "\nnormal law  " + law_name(asked.bilateral);
  if (!asked.uncertain.empty()) text += "\nuncertain   " + tolerances(asked, " ", false);
  if (asked.max_motion) text += "\nmax motion  " + list(*asked.max_motion, "(", ")", false);
  text += "\nproof       ";
  const std::string tree =
      std::to_string(a.nodes) + " nodes: " + std::to_string(a.leaves) + " leaves";
  if (statics && (margin || asked.plane)) {
    text += "load points: " + std::to_string(a.stands) + ", twists: " + std::to_string(a.moves);
  } else if (a.verdict == "may stand") {
    text += "forces";
  } else if (in_ranges) {
    text += "intervals by degree: " + std::to_string(a.parts) +
            (a.rests > 0 ? ", at rest: " + std::to_string(a.rests) : "") +
            (a.stickings > 0 ? ", sticking: " + std::to_string(a.stickings) : "") +
            ", refuted: " + std::to_string(a.trees) + "; trees of " + tree;
  } else if (margin) {
    text += "segments: " + std::to_string(a.segments) +
            (a.parts > 0 ? ", by degree: " + std::to_string(a.parts) : "") +
            "; trees: " + std::to_string(a.trees) + ", of " + tree;
  } else if (a.verdict == "region") {
    text += "pieces: " + std::to_string(a.pieces) + "; a tree of " + tree;
  } else if (a.verdict == "must move") {
    text += "a twist";
  } else if (a.verdict == "open") {
    text += "forces at rest, and others with an acceleration";
  } else if (a.verdict == "must hold") {
    text += "forces at rest, and a tree of " + tree;
  } else if (a.rests + a.stickings + a.parts > 0) {
    const auto add = [](std::uint64_t parts, const std::string& kind) {
      return parts > 0 ? kind + ", parts: " + std::to_string(parts) + "; " : "";
    };
    text += add(a.rests, "at rest") + add(a.stickings, "sticking") + add(a.parts, "by degree");
    text += a.parts > 0 ? "trees of " + tree + "; " : "";
    text.resize(text.size() - 2);
  } else {
    text += a.verdict == "stable" ? "an equilibrium" : "a tree of " + tree;
  }
  return text + "\n";
}

std::string text_of(const Rejected& r) {
  std::string text = "rejected\nrule   " + r.rule + "\n";
  if (r.node) text += "node   " + std::to_string(*r.node) + "\n";
  if (!r.path.empty()) text += "path   " + r.path + "\n";
  return text + "found  " + printable(r.found) + "\n";
}

std::string text_of(const Malformed& m) {
  return printable(m.file + ": " + m.place + ": " + m.problem) + "\n";
}

std::string text_of(const NotJudged& n) {
  return "not judged\nwhy    " + printable(n.why) + "\n";
}

}  // namespace

std::string as_json(const Answer& answer) {
  const auto* a = std::get_if<Accepted>(&answer);
  const auto* r = std::get_if<Rejected>(&answer);
  const auto* m = std::get_if<Malformed>(&answer);
  const auto* n = std::get_if<NotJudged>(&answer);
  const bool statics = a != nullptr && a->question.asked.statics;
  const bool margin = a != nullptr && a->verdict == "margin" && !statics;
  const bool region = a != nullptr && a->verdict == "region" && !statics;
  const bool states = a != nullptr && a->question.asked.states;
  const bool tree = a != nullptr && !statics && !states &&
                    (a->verdict != "stable" || a->rests + a->stickings + a->parts > 0);
  const std::string path = r != nullptr ? r->path : (m != nullptr ? m->place : "");
  const std::string result = a != nullptr   ? "accepted"
                             : r != nullptr ? "rejected"
                             : m != nullptr ? "malformed"
                                            : "not judged";
  const auto text = [](bool present, const std::string& content) {
    return present ? json_string(content) : "null";
  };
  const auto number = [](bool present, std::uint64_t value) {
    return present ? std::to_string(value) : "null";
  };
  return R"({"result": )" + json_string(result) + R"(, "rule": )" +
         text(r != nullptr, r != nullptr ? r->rule : "") + R"(, "node": )" +
         number(r != nullptr && r->node, r != nullptr ? r->node.value_or(0) : 0) +
         R"(, "path": )" + text(!path.empty(), path) + R"(, "found": )" +
         text(a == nullptr, r != nullptr
                                ? r->found
                                : (m != nullptr ? m->problem : (n != nullptr ? n->why : ""))) +
         R"(, "verdict": )" + text(a != nullptr, a != nullptr ? a->verdict : "") +
         R"(, "box": )" + (a == nullptr ? "null" : (a->question.is_box ? "true" : "false")) +
         R"(, "nodes": )" + number(tree, tree ? a->nodes : 0) + R"(, "leaves": )" +
         number(tree, tree ? a->leaves : 0) + R"(, "resisted": )" +
         (margin ? json_intervals(a->resisted) : "null") + R"(, "refuted": )" +
         (margin && a->question.claims() ? json_ranges(a->refuted) : "null") +
         R"(, "question": )" + (a != nullptr ? json_question(a->question) : "null") +
         (region ? R"(, "pieces": )" + std::to_string(a->pieces) : "") +
         (statics && (a->verdict == "margin" || a->verdict == "region")
              ? R"(, "points": )" + std::to_string(a->stands) + R"(, "twists": )" +
                    std::to_string(a->moves)
              : "") +
         (a != nullptr && a->bounds
              ? R"(, "bounds": )" + list({a->bounds->low, a->bounds->high}, "[", "]", true)
              : "") +
         (states ? R"(, "by_dimension": )" + json_integers(a->by_dimension) : "") +
         (a != nullptr && a->standing ? R"(, "standing": )" + json_standing(*a->standing)
                                      : "") +
         "}\n";
}

std::string as_text(const Answer& answer) {
  return std::visit([](const auto& any) { return text_of(any); }, answer);
}

}  // namespace stickslip_check
