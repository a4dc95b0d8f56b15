// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/preload_answer.hpp"

#include <algorithm>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {
namespace {

const char* const kPreloadProducer = "stickslip " STICKSLIP_VERSION ", preload";

using NamedFiles = std::vector<std::pair<std::string, ProvedFiles>>;

void add_boxes(NamedFiles& files, const std::string& name, NormalLaw law,
               const std::vector<ProvedPreloads>& boxes) {
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const auto& [box, proof] = boxes[k];
    files.emplace_back(name + std::to_string(k),
                       proof ? proved_box(box, law, *proof, kPreloadProducer)
                             : proved_grasp(box, law, true, kPreloadProducer));
  }
}

void add_range(NamedFiles& files, NormalLaw law, const PreloadRange& range) {
  for (std::size_t k = 0; k < range.margins.size(); ++k) {
    const auto& [question, margin] = range.margins[k];
    const std::string certificate = std::visit(
        [&question = question](const auto& known) {
          return margin_certificate_text(question, known, kPreloadProducer);
        },
        margin);
    files.emplace_back(
        "range" + std::to_string(k),
        ProvedFiles{
            write_grasp(question.grasp.as_box()), certificate, {}, question.preload_direction});
  }
  add_boxes(files, "range", law, range.boxes);
}

/// Returns the members that all answers begin with.
Json question_json(const Question& question) {
  Json json;
  json["name"] = question.description().name;
  add_conventions(json, question.description());
  if (const Mechanism* mechanism = question.mechanism()) {
    json["coordinates"] = coordinate_names(*mechanism);
  }
  json["normal_law"] = to_string(question.law);
  return json;
}

/// Adds the multiples, and whether each preload may vary for itself between the first and the
/// last.
void add_range(Json& json, const PreloadRange& range) {
  Json& multiples = json["multiples"] = Json::array();
  for (const auto& [low, high] : range.multiples) {
    multiples.push_back({number_json(low), high ? number_json(*high) : Json()});
  }
  json["each_for_itself"] = !range.boxes.empty();
}

void add_alike(Json& json, const ContactGroups& alike) {
  Json& groups = json["equal"] = Json::array();
  for (const std::vector<std::size_t>& group : alike) groups.push_back(group);
}

void add_unbalanced(Json& json, const std::vector<ModelWarning>& warnings) {
  json["warnings"] = warnings_json(warnings);
}

}  // namespace

std::vector<GraspBox> loads_of(const std::vector<Question>& questions,
                               const std::string& file) {
  std::vector<GraspBox> loads;
  for (const Question& question : questions) {
    loads.push_back(question.grasp.as_box());
    GraspBox centre = loads.back();
    centre.ball.reset();
    if (!centre.is_point()) {
      throw InputError(file, "", "some numbers are uncertain",
                       "the best preloads are those of one grasp: give one number for each; "
                       "loads may be in a ball, as in --uncertain wrench=ball:1/2");
    }
    if (centre.contacts.empty()) {
      throw InputError(file, "contacts", "there are none",
                       "the best preloads are those of contacts: give one or more");
    }
  }
  return loads;
}

ContactGroups alike_from(const std::string& text, const GraspBox& grasp) {
  if (text == "normals") return contacts_of_one_direction(grasp);
  if (text == "none") return {};
  const auto refuse = [&](const std::string& problem) {
    throw InputError(
        "", "equal", problem,
        "give normals for contacts whose normals have one direction, none, or groups "
        "of contacts, as in 0,1:2,3");
  };
  ContactGroups groups(1);
  std::vector<char> is_known(grasp.contacts.size());
  std::string digits;
  for (const char c : text + ":") {
    if (c >= '0' && c <= '9' && digits.size() < 9) {
      digits += c;
      continue;
    }
    if ((c != ',' && c != ':') || digits.empty()) refuse("found " + quote(text));
    const std::size_t i = std::stoul(digits);
    digits.clear();
    if (i >= is_known.size()) {
      refuse("there is no contact " + std::to_string(i) + " among " +
             std::to_string(is_known.size()));
    }
    if (is_known[i] != 0) refuse("contact " + std::to_string(i) + " stands twice");
    is_known[i] = 1;
    groups.back().push_back(i);
    if (c == ':') groups.emplace_back();
  }
  groups.pop_back();
  return groups;
}

std::vector<ModelWarning> unbalanced(GraspBox held, NormalLaw law) {
  held.ball.reset();
  QuestionOptions options;
  options.law = law;
  std::vector<ModelWarning> warnings;
  for (const ModelWarning& warning : model_warnings(decide(ask({std::move(held)}, options)))) {
    if (warning.trap == ModelTrap::kUnbalancedPreload) warnings.push_back(warning);
  }
  return warnings;
}

Json preload_json(const std::vector<Question>& questions, const LeastPreload& least,
                  const ContactGroups& alike) {
  Json json = question_json(questions.front());
  const NormalLaw law = questions.front().law;
  Json& loads = json["loads"] = Json::array();
  for (const Question& question : questions) {
    const GraspBox load = question.grasp.as_box();
    Json& entry = loads.emplace_back(Json::object());
    if (!question.case_name.empty()) entry["case"] = question.case_name;
    entry["wrench"] = wrench_json(load.wrench);
    if (load.ball) entry["ball"] = ball_json(*load.ball);
    if (load.is_bounded()) entry["max_motion"] = number_json(load.max_motion);
  }
  json["preloads"] = least.preloads ? number_json(*least.preloads) : Json();
  json["sum"] = least.preloads ? number_json(sum_of(*least.preloads)) : Json();
  json["bound"] = number_json(least.bound);
  json["limit"] = number_json(least.limit);
  add_range(json, least.range);
  json["boxes"] = least.refused.size();
  json["looked"] = least.looked;
  add_alike(json, alike);
  if (least.preloads) add_unbalanced(json, unbalanced(least.held.front().box, law));
  return json;
}

Json preload_json(const Question& question, const Rational& budget, const BallPreload& found,
                  const ContactGroups& alike) {
  const Quality& quality = found.quality;
  Json json = question_json(question);
  if (!question.case_name.empty()) json["case"] = question.case_name;
  json["wrench"] = wrench_json(quality.ball.wrench);
  json["ball"] = ball_json(*quality.ball.ball);
  json["ball"].erase("radius");
  if (question.is_bounded()) json["max_motion"] = number_json(question.box()->max_motion);
  json["budget"] = number_json(budget);
  const bool holds = quality.stable == true;
  json["preloads"] = holds ? number_json(found.preloads) : Json();
  json["sum"] = holds ? number_json(sum_of(found.preloads)) : Json();
  json["proved"] = number_json(quality.proved);
  json["not_resisted_at"] = quality.refuted ? number_json(*quality.refuted) : Json();
  json["bound"] = found.bound ? number_json(*found.bound) : Json();
  add_range(json, found.range);
  json["boxes"] = found.refused.size();
  json["looked"] = found.looked;
  add_alike(json, alike);
  if (holds) add_unbalanced(json, unbalanced(quality.ball, question.law));
  return json;
}

NamedFiles proved_preload(NormalLaw law, const LeastPreload& least) {
  NamedFiles files;
  add_boxes(files, "held", law, least.held);
  add_range(files, law, least.range);
  add_boxes(files, "bound", law, least.refused);
  return files;
}

NamedFiles proved_preload(const Question& question, const BallPreload& found) {
  NamedFiles files;
  if (found.quality.stable == true) files = proved_quality(question, found.quality);
  add_range(files, question.law, found.range);
  add_boxes(files, "bound", question.law, found.refused);
  return files;
}

}  // namespace stickslip
