// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/certificate/certificate.hpp"

#include <nlohmann/json.hpp>

#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

/// NUMBER of FORMAT.md: a JSON integer where every JSON reader keeps it exact, else a string.
std::string number(const Rational& value) {
  static const Integer kExactInDoubles = Integer(1) << 53;
  constexpr std::size_t kLongest = 65536;  // FORMAT.md, section 2
  const std::string text = to_string(value);
  if (text.size() > kLongest) {
    throw InputError("", "",
                     "the proof has a number of " + std::to_string(text.size()) +
                         " characters; certificates hold at most " + std::to_string(kLongest),
                     "shorter numbers in the grasp, or --snap-normals, make it shorter");
  }
  if (denominator(value) == 1 && abs(numerator(value)) < kExactInDoubles) return text;
  return '"' + text + '"';
}

template <class Numbers>
std::string list(const Numbers& numbers) {
  std::string text;
  for (const auto& value : numbers) text += (text.empty() ? "" : ",") + number(Rational(value));
  return text;
}

std::string indexed(const char* kind, ContactId contact) {
  return std::string("[\"") + kind + "\"," + std::to_string(contact.index()) + "]";
}

struct NodeText {
  std::string operator()(const SlipSplit& node) const { return indexed("slip", node.contact); }
  std::string operator()(const SeparationSplit& node) const {
    return indexed("separation", node.contact);
  }
  std::string operator()(const PlaneSplit& node) const {
    return "[\"plane\"," + list(node.plane) + "]";
  }
  std::string operator()(const VirtualWorkLeaf& node) const {
    std::string text = "[\"leaf\"," + list(node.twist);
    if (!node.theta.empty()) {
      text += ",[";
      for (const auto& [contact, theta] : node.theta) {
        if (text.back() == ']') text += ',';
        text += "[" + std::to_string(contact.index()) + "," + number(theta) + "]";
      }
      text += "]";
    }
    return text + "]";
  }
  std::string operator()(const VoidLeaf&) const { return "[\"void\"]"; }
};

std::string question_text(const Question& question) {
  std::string text = "{\"contacts\": " + std::to_string(question.loaded.grasp.size()) +
                     ", \"wrench\": [" + list(coordinates(question.loaded.wrench)) + "]";
  if (question.preload) text += ", \"preload\": " + number(*question.preload);
  text += std::string(", \"normal_law\": \"") + to_string(question.law) + "\"";
  if (!question.snapped.empty()) {
    text += ", \"normals\": [";
    for (const SnappedNormal& normal : question.snapped) {
      if (text.back() == ']') text += ", ";
      text += "[" + std::to_string(normal.contact.index()) + "," + number(normal.after.x) +
              "," + number(normal.after.y) + "]";
    }
    text += "]";
  }
  return text + "}";
}

std::string head(const char* format, const Question& question, const std::string& producer) {
  return std::string("{\"format\": \"") + format +
         "\",\n \"producer\": " + nlohmann::json(producer).dump() +
         ",\n \"question\": " + question_text(question) + ",\n";
}

std::string forces_text(const Witness& witness, const char* indent) {
  std::string text = "[";
  std::string separator = indent;
  for (const ContactForce& force : witness.forces) {
    text += separator + "[" + number(force.normal) + "," + number(force.tangential) + "]";
    separator = std::string(",") + indent;
  }
  return text + "]";
}

void append_nodes(std::string& text, const Refutation& refutation, std::string& separator) {
  for (const RefutationNode& node : refutation) {
    text += separator + std::visit(NodeText{}, node);
    separator = ",\n  ";
  }
}

std::string point_text(const std::optional<Rational>& multiple, const Witness& witness) {
  return "[" + (multiple ? number(*multiple) : "null") + ",[" +
         list(coordinates(witness.twist)) + "]," + forces_text(witness, "") + "]";
}

}  // namespace

std::string certificate_text(const Question& question, const Verdict& verdict,
                             const std::string& producer) {
  require(!std::holds_alternative<Undecided>(verdict),
          "an undecided question has no certificate");
  std::string text = head("stickslip-certificate/1", question, producer) + " \"verdict\": \"" +
                     name_of(verdict) + "\",\n";
  if (const auto* stable = std::get_if<Stable>(&verdict)) {
    text += " \"twist\": [" + list(coordinates(stable->witness.twist)) +
            "],\n \"forces\": " + forces_text(stable->witness, "\n  ");
  } else {
    std::string separator = "\n  ";
    text += " \"tree\": [";
    append_nodes(text, std::get<Unstable>(verdict).refutation, separator);
    text += "]";
  }
  return text + "}\n";
}

std::string margin_certificate_text(const Question& question, const Margin& margin,
                                    const std::string& producer) {
  std::string text = head("stickslip-margin/1", question, producer) + " \"direction\": [" +
                     list(coordinates(margin.direction)) + "],\n \"resisted\": [";
  std::string separator;
  for (const LoadInterval& interval : margin.resisted) {
    text += separator + "[" + number(interval.low) + "," +
            (interval.high ? number(*interval.high) : "null") + "]";
    separator = ",";
  }
  text += "],\n \"segments\": [";
  separator = "\n  ";
  for (const LoadSegment& segment : margin.segments) {
    text += separator + "[" + point_text(segment.start.multiple, segment.start.witness) +
            ",\n   " + point_text(segment.high, segment.end) + "]";
    separator = ",\n  ";
  }
  text += "],\n \"tree\": [";
  separator = "\n  ";
  for (const Refutation& gap : margin.gaps) append_nodes(text, gap, separator);
  return text + "]}\n";
}

}  // namespace stickslip
