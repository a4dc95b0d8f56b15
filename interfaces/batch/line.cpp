// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/line.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "hash.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/interfaces/option_text.hpp"
#include "stickslip/interfaces/question_text.hpp"
#include "stickslip/interfaces/results.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {
namespace {

constexpr const char* kProducer = "stickslip " STICKSLIP_VERSION ", batch";

std::string text_of(const Json& result) {
  return with_check(result.dump(-1, Json::Utf8::kReplaced) + "\n");
}

}  // namespace

BatchLines::BatchLines(std::istream& in, const FilePart& part)
    : lines_(in, part.lines_before, part.begin), end_(part.end) {
  if (part.begin > 0) in.seekg(static_cast<std::streamoff>(part.begin));
}

void BatchLines::put_back(BatchLine line) {
  put_back_ = std::move(line);
}

std::optional<BatchLine> BatchLines::next() {
  if (put_back_) return std::exchange(put_back_, std::nullopt);
  number_before_ = lines_.number();
  end_before_ = lines_.end();
  BatchLine line;
  if (lines_.end() >= end_) return std::nullopt;
  try {
    if (!lines_.next(line.text)) return std::nullopt;
  } catch (const InputError& error) {
    line.text.clear();
    line.unreadable = error;
  }
  if (lines_.begin() >= end_)
    return std::nullopt;  // the end is behind blank lines, which were
                          // the last
  line.number = lines_.number();
  return line;
}

LineDecider::LineDecider(BatchOptions options) : options_(std::move(options)) {
  const auto spell = [&](const std::optional<Rational>& value) {
    options_text_ += (value ? to_string(*value) : "") + ";";
  };
  const QuestionOptions& asked = options_.question;
  const std::size_t components = asked.wrench ? asked.wrench->size() : 3;
  for (std::size_t j = 0; j < components; ++j) {
    spell(asked.wrench ? std::optional(asked.wrench->at(j)) : std::nullopt);
  }
  spell(asked.preload);
  if (asked.case_name) options_text_ += *asked.case_name + ";";
  options_text_ +=
      std::string(to_string(asked.law)) + ";" + std::to_string(options_.node_limit) + "\n";
  if (const auto& inertia = options_.inertia) {
    for (const Rational& number : inertia->empty() ? RationalRow{0, 0, 1} : *inertia) {
      spell(number);
    }
  }
  if (auto& quality = options_.quality) {
    options_text_ += "quality;";
    spell(quality->options.radius.accuracy);
    spell(quality->options.at_most);
    options_text_ += to_string(quality->shape) + "\n";
    quality->options.radius.box.node_limit = options_.node_limit;
  }
  if (const auto& states = options_.states) {
    options_text_ += std::string("states;") + name_of(states->set) + ";" +
                     std::to_string(states->lines.count) + ";" +
                     (states->lines.snap ? "snap;" : ";") + std::to_string(states->limit) +
                     "\n";
  }
  if (auto& measures = options_.measures) {
    CompareOptions& compared = measures->options;
    options_text_ += "measures;";
    for (const std::string& word : compared.methods) options_text_ += word + ";";
    spell(measures->length);
    for (const Rational& number : measures->inertia.value_or(RationalRow())) spell(number);
    options_text_ += "max-force;";
    for (const Rational& force : compared.most_forces) spell(force);
    spell(compared.accuracy);
    options_text_ += std::to_string(compared.edges) + "\n";
    if (options_.node_limit > 0) compared.node_limit = options_.node_limit;
  }
}

std::string LineDecider::key(const std::string& line) const {
  batch_detail::Hash hash;
  hash.add(options_text_);
  hash.add(line);
  return hash.digits();
}

std::string LineDecider::options_key() const {
  return key(options_.certificates);
}

LineResult LineDecider::failed(const BatchLine& line, const InputError& error) const {
  const Json result = {
      {"line", line.number},
      {"key", key(line.text)},
      {"error",
       {{"place", error.place()}, {"problem", error.problem()}, {"remedy", error.remedy()}}}};
  return {line.number, text_of(result), LineOutcome::kUnreadable};
}

std::string LineDecider::add_quality(Json& result, const Question& question,
                                     const std::string& line) const {
  const LoadBall shape = shape_for(*options_.quality, question);
  const Quality quality =
      find_quality(question.grasp.as_box(), question.law, shape, options_.quality->options);
  const Json found = finished(quality_json(question, quality), false);
  for (const char* field : {"proved", "refuted", "scales", "not_resisted"}) {
    if (found.contains(field)) result[field] = found[field];
  }
  const std::optional<BoxDecision>& proof = quality.radii.proof;
  if (!proof || options_.certificates.empty()) return "";
  // A checker is asked about the line, and told of the ball.
  QuestionOptions asked = options_.question;
  asked.uncertain.ball = shape;
  asked.uncertain.ball->radius = quality.proved;
  result["uncertain"] = "wrench=" + to_string(*asked.uncertain.ball);
  return certificate_text(ask_with_options(parse_any_grasp(line, ""), asked, "", true),
                          proof->verdict, kProducer, proof->bits);
}

LineOutcome LineDecider::add_states(Json& result, const std::string& line) const {
  const StatesAsked& asked = *options_.states;
  const Question contacts = contacts_alone(parse_any_grasp(line, "", Intervals::kRefused));
  const StatesQuestion question =
      states_question(contacts.grasp.as_box(), asked.lines, asked.set);
  const FaceCounts counts = count_states(question, asked.limit);
  const Json found = finished(states_counts_json(question, counts), false);
  result["name"] = contacts.description().name;
  for (const char* field :
       {"by_dimension", "distinct_states", "distinct_planes", "rank", "warnings"}) {
    if (found.contains(field)) result[field] = found[field];
  }
  if (counts.complete) return LineOutcome::kDecided;
  result["limit"] = "there are more than " + std::to_string(asked.limit) + " states";
  return LineOutcome::kUndecided;
}

void LineDecider::add_measures(Json& result, const std::string& line) const {
  const Question question = as_one_body(ask_with_options(
      parse_any_grasp(line, "", Intervals::kOnlyBounds), options_.question, "", false));
  if (question.mechanism() != nullptr) {
    throw InputError("", "--measures", "the grasp is of several bodies",
                     "ask for --class: of them it alone is computed");
  }
  const CompareOptions options = options_for(*options_.measures, question);
  NumberText text(false);
  Comparison found;
  try {
    found = compare_methods(question, options, text);
  } catch (const InputError& error) {
    throw in_options(error, "");
  }
  const Json compared =
      finished(comparison_json(question, options.length, options.inertia, found), false);
  for (const char* field : {"name", "length", "inertia", "class", "methods"}) {
    result[field] = compared.at(field);
  }
}

LineResult LineDecider::decide(const BatchLine& line) const {
  if (line.unreadable) return failed(line, *line.unreadable);
  LineOutcome outcome = LineOutcome::kDecided;
  std::string certificate;
  Json result = {{"line", line.number}, {"key", key(line.text)}};
  try {
    if (options_.states) {
      outcome = add_states(result, line.text);
      return {line.number, text_of(result), outcome};
    }
    if (options_.measures) {
      add_measures(result, line.text);
      return {line.number, text_of(result), outcome};
    }
    const Question question = ask_with_options(
        parse_any_grasp(line.text, "",
                        options_.inertia ? Intervals::kRefused : Intervals::kAllowed),
        options_.question, "", !options_.inertia);
    if (options_.quality) {
      grasp_for_ball(question, shape_for(*options_.quality, question), "");
    }
    result["name"] = question.description().name;
    const auto answer = [&](const char* field, const auto& verdict) {
      result[field] = name_of(verdict);
      if (const auto* undecided = std::get_if<Undecided>(&verdict)) {
        result["limit"] = undecided->limit;
        outcome = LineOutcome::kUndecided;
      }
    };
    const auto wants_certificate = [&] {
      return outcome == LineOutcome::kDecided && !options_.certificates.empty();
    };
    if (!options_.inertia) {
      SearchOptions search;
      search.node_limit = options_.node_limit;
      const Answer found = stickslip::decide(question, search);
      answer("verdict", found.verdict);
      if (found.within) result["within"] = finished(within_json(*found.within), false);
      for (const ModelWarning& warning : model_warnings(found, true)) {
        result["warnings"].push_back(to_string(warning.trap));
      }
      if (options_.quality && is_stable(found.verdict) == true) {
        certificate = add_quality(result, question, line.text);
      }
      if (certificate.empty() && wants_certificate() && is_stable(found.verdict)) {
        certificate = certificate_text(found.question, found.verdict, kProducer, found.bits);
      }
    } else if (question.mechanism() != nullptr) {
      // Rigid contacts of several bodies tell whether they may stand.
      const LoadClass found = statics(question.grasp.as_box());
      answer("class", found);
      if (wants_certificate()) {
        certificate = statics_certificate_text(question, {}, found, kProducer);
      }
    } else {
      const bool in_space = question.in_space();
      const Inertia inertia = options_.inertia->empty()
                                  ? Inertia::of_length(1, in_space)
                                  : inertia_of("--inertia", *options_.inertia, in_space);
      const RigidVerdict verdict = rigid_verdict(question, inertia);
      answer("class", verdict);
      if (wants_certificate()) {
        certificate = class_certificate_text(question, inertia, verdict, kProducer);
      }
    }
  } catch (const InputError& error) {
    return failed(line, error);
  }
  // A file that cannot be written ends the batch, as it is no property of the line.
  if (!certificate.empty()) {
    const std::string name = "/line-" + std::to_string(line.number) + ".json";
    write_whole_file(options_.certificate_folder + name, certificate);
    result["certificate"] = options_.certificates + name;
  }
  return {line.number, text_of(result), outcome};
}

void open_certificate_folder(const std::string& folder, bool resume) {
  make_folder("--certificates", folder);
  if (!resume) return;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string target = target_of_temporary(entry.path().filename().string());
    if (entry.is_regular_file(ignored) && is_numbered(target, "line-", ".json")) {
      std::filesystem::remove(entry.path(), ignored);
    }
  }
}

}  // namespace stickslip
