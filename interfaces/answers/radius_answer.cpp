// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/radius_answer.hpp"

#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/uncertain_numbers.hpp"

namespace stickslip {

Json radius_json(const Question& question, const Radius& radius) {
  const GraspBox box = question.grasp.as_box();
  Json json;
  json["verdict"] = verdict_name(radius.stable);
  json["name"] = box.description.name;
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_conventions(json, box.description);
  json["engine"] = box_engine(question);
  json["normal_law"] = to_string(question.law);
  json["wrench"] = wrench_json(box.middle().wrench);
  json["uncertain"] = uncertain_json(uncertain_numbers(box));
  if (box.ball) json["ball"] = ball_json(*box.ball);
  json["proved"] = number_json(radius.proved);
  json["refuted"] = radius.refuted ? number_json(*radius.refuted) : Json();
  json["limit"] = number_json(radius.limit);
  if (radius.example) {
    json["counterexample"] = Json::parse(write_grasp(*radius.example));
  }
  return json;
}

}  // namespace stickslip
