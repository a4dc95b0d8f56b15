// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/quality_answer.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/interfaces/option_text.hpp"
#include "stickslip/interfaces/uncertain_numbers.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {

namespace {

/// Returns the value of an option, which must be above 0.
Rational positive_option(const std::string& option, const std::string& value,
                         const char* meaning) {
  Rational number = rational_at(option, value);
  if (number.sign() > 0) return number;
  throw InputError("", option, "the value is " + value,
                   std::string(meaning) + ": give a number above 0");
}

}  // namespace

QualityAsked quality_asked(const QualityText& text) {
  QualityAsked asked;
  LoadBall& ball = asked.shape;
  if (!text.length.empty()) {
    ball.length = positive_option("--length", text.length, "torques are divided by it");
    asked.has_length = true;
  }
  if (!text.about.empty()) ball.set_about(rationals_at("--about", text.about));
  ball.body = text.body;
  if (!text.at_most.empty()) {
    asked.options.at_most =
        positive_option("--at-most", text.at_most, "it is the radius of a ball of loads");
  }
  if (!text.accuracy.empty()) asked.options.radius.accuracy = accuracy_option(text.accuracy);
  return asked;
}

LoadBall shape_for(const QualityAsked& asked, const Question& question) {
  LoadBall shape = asked.shape;
  if (!asked.has_length) shape.length = characteristic_length(question.grasp.as_box());
  const Mechanism* mechanism = question.mechanism();
  if (shape.body.empty() && mechanism != nullptr && mechanism->bodies.size() == 1) {
    shape.body = mechanism->bodies.front().name;
  }
  return shape;
}

GraspBox grasp_for_ball(const Question& question, const LoadBall& shape,
                        const std::string& file) {
  GraspBox grasp = question.grasp.as_box();
  if (!grasp.is_point()) {
    throw InputError(file, "", "some numbers are uncertain",
                     "a quality is that of one grasp: give one number for each, or ask "
                     "radius --uncertain wrench=ball:R");
  }
  // GraspBox::check() says the same of a tolerance; this says it of the options.
  const std::size_t coordinates = grasp.in_space() ? 3 : 2;
  if (!shape.about.empty() && shape.about.size() != coordinates) {
    throw InputError("", "--about",
                     "there are " + std::to_string(shape.about.size()) + " coordinates",
                     "give " + std::to_string(coordinates) + ", as in " +
                         (coordinates == 3 ? "1,0,0" : "1,0"));
  }
  if (!grasp.mechanism) {
    if (shape.body.empty()) return grasp;
    throw InputError("", "--body", "the grasp has one body", "leave the option out");
  }
  if (shape.body.empty() || shape.body == "ground") {
    throw InputError("", "--body",
                     shape.body.empty() ? "nobody says which body the loads are on"
                                        : "the ground bears all loads",
                     "name one, as in --body " + grasp.mechanism->bodies.front().name);
  }
  grasp.mechanism->body_named(shape.body, "--body");
  return grasp;
}

Json quality_json(const Question& question, const Quality& quality) {
  const GraspBox& grasp = quality.ball;
  Json json;
  json["verdict"] = verdict_name(quality.stable);
  json["name"] = question.description().name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_conventions(json, question.description());
  if (const Mechanism* mechanism = question.mechanism()) {
    json["coordinates"] = coordinate_names(*mechanism);
  }
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(grasp.wrench);
  json["ball"] = ball_json(*grasp.ball);
  json["ball"].erase("radius");
  json["proved"] = number_json(quality.proved);
  json["refuted"] = quality.refuted ? number_json(*quality.refuted) : Json();
  json["limit"] = number_json(quality.limit);
  if (quality.scales) json["scales"] = true;
  if (quality.radii.example && quality.stable == true) {
    json["not_resisted"] = wrench_json(quality.radii.example->wrench);
  }
  return json;
}

std::vector<std::pair<std::string, ProvedFiles>> proved_quality(const Question& question,
                                                                const Quality& quality) {
  require(quality.stable.has_value(), "the quality of a grasp with a verdict");
  const std::string producer = "stickslip " STICKSLIP_VERSION ", quality";
  const GraspBox centre = quality.ball.middle();
  if (!*quality.stable) {
    return {{"refuted", proved_grasp(centre, question.law, false, producer)}};
  }
  auto proofs = proved_radius(centre, quality.ball, question.law, quality.radii, producer);
  std::vector<std::pair<std::string, ProvedFiles>> files{{"proved", std::move(proofs[0])}};
  if (proofs.size() > 1) files.emplace_back("refuted", std::move(proofs[1]));
  return files;
}

}  // namespace stickslip
