// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_answer.hpp"

#include <algorithm>
#include <iostream>
#include <utility>
#include <vector>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/equilibrium/decide.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

constexpr const char* kProducer = "stickslip " STICKSLIP_VERSION ", engine box";

/// A number of the box that is an interval, under its name in a grasp file.
struct UncertainNumber {
  std::string place;
  Interval interval;
  bool is_slope = false;  ///< of a normal: the interval is [-E, E]
};

std::vector<UncertainNumber> uncertain_numbers(const GraspBox& box) {
  std::vector<UncertainNumber> all;
  const auto add = [&](const std::string& place, const Interval& interval,
                       bool is_slope = false) {
    if (!interval.is_point()) all.push_back({place, interval, is_slope});
  };
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const std::string contact = "contacts[" + std::to_string(i) + "].";
    add(contact + "position[0]", c.x);
    add(contact + "position[1]", c.y);
    add(contact + "normal", {-c.slope, c.slope}, true);
    add(contact + "friction", c.friction);
    add(contact + "stiffness", c.stiffness);
    add(contact + "preload", c.preload);
  }
  for (std::size_t j = 0; j < box.wrench.size(); ++j) {
    add("wrench[" + std::to_string(j) + "]", box.wrench[j]);
  }
  return all;
}

/// The value of each uncertain number, in their order, in a grasp of the box.
std::vector<Rational> values_in(const GraspBox& box, const LoadedGrasp& loaded) {
  std::vector<Rational> values;
  const auto add = [&](const Interval& interval, const Rational& value) {
    if (!interval.is_point()) values.push_back(value);
  };
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const Contact& at = loaded.grasp.contacts()[i];
    const Vector2& n = c.normal;
    const Rational along = n.x * at.normal.x + n.y * at.normal.y;
    const Rational across = n.x * at.normal.y - n.y * at.normal.x;
    add(c.x, at.position.x);
    add(c.y, at.position.y);
    add({-c.slope, c.slope}, across / along);
    add(c.friction, at.friction);
    add(c.stiffness, at.stiffness);
    add(c.preload, at.preload);
  }
  const Vector3 w = coordinates(loaded.wrench);
  for (std::size_t j = 0; j < w.size(); ++j) add(box.wrench[j], w[j]);
  return values;
}

/// A number in which two grasps differ.
struct Difference {
  UncertainNumber number;
  Rational stable;
  Rational unstable;

  /// As part of the interval.
  Rational size() const {
    return abs(unstable - stable) / (number.interval.high - number.interval.low);
  }
};

/// Those that differ most, first.
std::vector<Difference> differences(const GraspBox& box, const Fragile& fragile) {
  const std::vector<UncertainNumber> numbers = uncertain_numbers(box);
  const std::vector<Rational> stable = values_in(box, fragile.stable);
  const std::vector<Rational> unstable = values_in(box, fragile.unstable);
  std::vector<Difference> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (stable[i] != unstable[i]) all.push_back({numbers[i], stable[i], unstable[i]});
  }
  std::stable_sort(all.begin(), all.end(), [](const Difference& a, const Difference& b) {
    return a.size() > b.size();
  });
  return all;
}

std::vector<std::size_t> enclosed_contacts(const GraspBox& box) {
  std::vector<std::size_t> contacts;
  for (std::size_t i = 0; i < box.contacts.size(); ++i) {
    if (needs_enclosure({{box.contacts[i]}, {}})) contacts.push_back(i);
  }
  return contacts;
}

Json interval_json(const Interval& interval) {
  if (interval.is_point()) return number_json(interval.low);
  return Json::array({number_json(interval.low), number_json(interval.high)});
}

std::size_t count_parts(const StabilityProof& proof) {
  return static_cast<std::size_t>(std::count_if(
      proof.begin(), proof.end(),
      [](const auto& part) { return std::holds_alternative<DegreeProof>(part); }));
}

std::string in_words(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// The first rows of a table, its heading not counted.
std::string short_table(std::vector<std::vector<std::string>> rows) {
  constexpr std::size_t kMostRows = 12;
  const std::size_t left_out = rows.size() - 1 > kMostRows ? rows.size() - 1 - kMostRows : 0;
  rows.resize(rows.size() - left_out);
  std::string text;
  std::string table = format_table(rows, Align::kLeft);
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = table.find('\n', begin) + 1;
    text += "  " + table.substr(begin, end - begin);
    begin = end;
  }
  if (left_out > 0) text += "  and " + std::to_string(left_out) + " more, which --json lists\n";
  return text;
}

std::string label(const UncertainNumber& number) {
  return number.place + (number.is_slope ? ", slope" : "");
}

std::string fragile_text(const BoxAnswer& answer, const Fragile& fragile, NumberText& text,
                         const std::string& examples) {
  std::vector<std::vector<std::string>> rows{{"differs", "stable", "unstable"}};
  for (const Difference& d : differences(*answer.question.box, fragile)) {
    rows.push_back({label(d.number), text(d.stable), text(d.unstable)});
  }
  return "Some grasps in the box hold the load and some do not. Two of them, what differs most "
         "first:\n\n" +
         short_table(rows) + "\n" +
         (examples.empty()
              ? "--examples DIR writes both, each with a certificate of its verdict.\n"
              : "Both are in " + examples + ", each with a certificate of its verdict.\n");
}

struct Meaning {
  bool wide;  ///< some number is an interval

  std::string operator()(const StableThroughout& stable) const {
    const std::size_t parts = count_parts(stable.parts);
    return (wide ? "Every grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp holds the load. Proved")) +
           (parts == 1 ? "" : ", in " + in_words(parts, "part")) +
           ": the forces on\nthe walls of a box of motions leave no way out but an equilibrium "
           "inside.\n";
  }
  std::string operator()(const UnstableThroughout& unstable) const {
    return (wide ? "No grasp in the box holds the load. Proved for all of them at once"
                 : std::string("The grasp does not hold the load. Proved")) +
           ", by a tree of " + in_words(unstable.tree.size(), "node") +
           ":\nwherever the object moves, along some virtual twist the load does more work "
           "than "
           "the\ncontacts can take up.\n";
  }
  std::string operator()(const Undecided& undecided) const {
    return "Not decided: " + undecided.limit + ".\n" +
           (wide ? "Neither is the whole box proved, nor are two grasps with opposite verdicts "
                   "known.\n"
                 : "");
  }
  std::string operator()(const Fragile& /*fragile*/) const { return ""; }
};

std::string enclosure_text(const BoxAnswer& answer) {
  const std::vector<std::size_t> contacts = enclosed_contacts(*answer.question.box);
  if (contacts.empty()) return "";
  constexpr std::size_t kMostNamed = 8;
  std::string names;
  for (std::size_t i = 0; i < std::min(contacts.size(), kMostNamed); ++i) {
    names += (i == 0 ? "" : ", ") + std::to_string(contacts[i]);
  }
  if (contacts.size() > kMostNamed) names += ", ...";
  const bool proved = !std::holds_alternative<Undecided>(answer.decision.verdict);
  return (contacts.size() == 1 ? "The normal of contact " : "The normals of contacts ") +
         names +
         (contacts.size() == 1 ? " has an irrational length" : " have irrational lengths") +
         " |n|: P/|n| was enclosed to " + std::to_string(answer.decision.bits) + " bits" +
         (proved ? ",\nand the verdict is proved for all numbers in there.\n" : ".\n");
}

/// The grasp as its file, and the certificate that it has this verdict.
std::pair<std::string, std::string> example_files(const BoxAnswer& answer,
                                                  const LoadedGrasp& loaded,
                                                  const char* verdict) {
  const LoadedGrasp named{
      Grasp(loaded.grasp.contacts(), answer.question.loaded.grasp.description()),
      loaded.wrench};
  QuestionOptions options;
  options.law = answer.question.law;
  const Question question = ask({named}, options);
  std::string found;
  std::string certificate;
  if (question.box) {
    const BoxDecision decision = decide_box(*question.box, question.law);
    found = name_of(decision.verdict);
    if (found == verdict) certificate = box_certificate_text(question, decision, kProducer);
  } else {
    const Decision decision = decide(problem_of(question));
    found = name_of(decision.verdict);
    if (found == verdict) certificate = certificate_text(question, decision.verdict, kProducer);
  }
  require(found == verdict, "the example of a fragile box has another verdict");
  return {write_grasp(named), certificate};
}

}  // namespace

BoxAnswer answer_box(Question question, std::size_t node_limit) {
  BoxOptions options;
  options.node_limit = node_limit;
  BoxDecision decision = decide_box(*question.box, question.law, options);
  return {std::move(question), std::move(decision)};
}

std::string load_text(const BoxAnswer& answer, NumberText& text) {
  std::string result;
  for (const Interval& w : answer.question.box->wrench) {
    result += (result.empty() ? "(" : ", ") +
              (w.is_point() ? text(w.low) : "[" + text(w.low) + ", " + text(w.high) + "]");
  }
  return result + ")";
}

Json to_json(const BoxAnswer& answer) {
  const auto& [question, decision] = answer;
  const GraspBox& box = *question.box;
  Json json;
  json["verdict"] = name_of(decision.verdict);
  json["box"] = true;
  json["name"] = question.loaded.grasp.name();
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_units(json, question.loaded.grasp);
  json["engine"] = "box";
  json["normal_law"] = to_string(question.law);
  json["wrench"] = Json::array();
  for (const Interval& w : box.wrench) json["wrench"].push_back(interval_json(w));
  json["uncertain"] = Json::array();
  for (const UncertainNumber& number : uncertain_numbers(box)) {
    json["uncertain"].push_back({{"place", number.place},
                                 {number.is_slope ? "slope" : "interval",
                                  number.is_slope ? number_json(number.interval.high)
                                                  : interval_json(number.interval)}});
  }
  if (needs_enclosure(box)) {
    json["enclosed"] = enclosed_contacts(box);
    json["bits"] = decision.bits;
  }
  if (const auto* stable = std::get_if<StableThroughout>(&decision.verdict)) {
    json["proof"] = {{"parts", count_parts(stable->parts)}};
  } else if (const auto* unstable = std::get_if<UnstableThroughout>(&decision.verdict)) {
    json["refutation"] = {{"nodes", unstable->tree.size()}};
  } else if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    json["examples"] = {{"stable", Json::parse(write_grasp(fragile->stable))},
                        {"unstable", Json::parse(write_grasp(fragile->unstable))}};
    Json& all = json["differences"] = Json::array();
    for (const Difference& d : differences(box, *fragile)) {
      all.push_back({{"place", d.number.place},
                     {"stable", number_json(d.stable)},
                     {"unstable", number_json(d.unstable)}});
    }
  } else {
    json["limit"] = std::get<Undecided>(decision.verdict).limit;
  }
  const BoxWork& work = decision.work;
  json["stats"] = {{"nodes", work.nodes},
                   {"proofs", work.proofs},
                   {"examples", work.examples},
                   {"parts", work.parts}};
  return json;
}

void print_text(const BoxAnswer& answer, const NumberOptions& output,
                const std::string& examples) {
  const auto& [question, decision] = answer;
  NumberText text(output);
  const std::vector<UncertainNumber> uncertain = uncertain_numbers(*question.box);
  std::cout << heading(question) << name_of(decision.verdict) << "\n\n"
            << "  load w    " << load_text(answer, text) << "\n\n";
  if (!uncertain.empty()) {
    std::vector<std::vector<std::string>> rows{{"uncertain", "from", "to"}};
    for (const UncertainNumber& number : uncertain) {
      rows.push_back({label(number), text(number.interval.low), text(number.interval.high)});
    }
    std::cout << short_table(rows) << '\n';
  }
  if (const auto* fragile = std::get_if<Fragile>(&decision.verdict)) {
    std::cout << fragile_text(answer, *fragile, text, examples);
  } else {
    std::cout << std::visit(Meaning{!uncertain.empty()}, decision.verdict);
  }
  std::cout << enclosure_text(answer) << text.note() << units_text(question.loaded.grasp)
            << engine_text("box", question.law);
}

void write_examples(const BoxAnswer& answer, const std::string& folder) {
  const auto* fragile = std::get_if<Fragile>(&answer.decision.verdict);
  if (fragile == nullptr) {
    std::cerr << "stickslip: --examples: nothing is written: the box is "
              << name_of(answer.decision.verdict)
              << ", and only one that is fragile has two examples\n";
    return;
  }
  std::vector<std::pair<std::string, std::string>> files;  // names and contents
  for (const auto& [verdict, loaded] :
       {std::pair{"stable", &fragile->stable}, std::pair{"unstable", &fragile->unstable}}) {
    auto [grasp, certificate] = example_files(answer, *loaded, verdict);
    files.emplace_back(std::string(verdict) + ".json", std::move(grasp));
    files.emplace_back(std::string(verdict) + ".certificate.json", std::move(certificate));
  }
  make_folder("--examples", folder);
  const FileWrite all;
  for (const auto& [name, content] : files) write_whole_file(folder + "/" + name, content);
}

void write_certificate(const BoxAnswer& answer, const std::string& file) {
  if (file.empty() || std::holds_alternative<Undecided>(answer.decision.verdict)) return;
  if (std::holds_alternative<Fragile>(answer.decision.verdict)) {
    std::cerr << "stickslip: --certificate: nothing is written: what proves that a box is "
                 "fragile is two grasps, each with a certificate; --examples DIR writes them\n";
    return;
  }
  write_whole_file(file, box_certificate_text(answer.question, answer.decision, kProducer));
}

}  // namespace stickslip
