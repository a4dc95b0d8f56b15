// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/statics_answer.hpp"

#include "stickslip/core/error.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"

namespace stickslip {
namespace {

const char* const kProducer = "stickslip " STICKSLIP_VERSION;

Json rows_json(const std::vector<RationalRow>& rows) {
  Json json = Json::array();
  for (const RationalRow& row : rows) json.push_back(number_json(row));
  return json;
}

/// Returns the forces that are not 0, each with its contact.
Json forces_json(const RigidForces& forces) {
  Json json = Json::array();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].normal.is_zero()) continue;
    json.push_back({{"contact", i},
                    {"normal", number_json(forces[i].normal)},
                    {"friction", number_json(forces[i].friction)}});
  }
  return json;
}

Json end_json(const std::optional<Rational>& end) {
  return end ? number_json(*end) : Json();
}

Json multiples_json(const StandingMultiples& multiples) {
  Json json{{"stand", Json()}, {"below", Json()}, {"above", Json()}};
  if (multiples.any) {
    json["stand"] = Json::array({end_json(multiples.low), end_json(multiples.high)});
  }
  json["below"] = end_json(multiples.below);
  json["above"] = end_json(multiples.above);
  json["always_moves"] = multiples.always_moves;
  return json;
}

struct FoundJson {
  Json& json;
  const StaticsAnswer& answer;

  void operator()(const RigidForces& forces) const {
    json["class"] = "may stand";
    json["forces"] = forces_json(forces);
  }
  void operator()(const UnopposedMotion& motion) const {
    json["class"] = "must move";
    json["motion"] = number_json(motion.twist);
  }
  void operator()(const Undecided& undecided) const {
    json["class"] = Json();
    json["reason"] = undecided.reason;
    json["limit"] = undecided.limit;
  }
  void operator()(const LoadClass& found) const { std::visit(*this, found); }
  void operator()(const LeastFriction& found) const {
    json["least_friction"] = {{"low", number_json(found.low)},
                              {"high", number_json(found.high)}};
    if (!found.motion.twist.empty()) json["motion"] = number_json(found.motion.twist);
    json["forces"] = forces_json(found.forces);
  }
  void operator()(const LeastFrictionAnswer& found) const {
    json["least_friction"] = Json();
    std::visit(*this, found);
  }
  void operator()(const StandingLoads& found) const {
    const std::vector<RationalRow>& directions = answer.asked.asked.directions;
    if (directions.size() == 1) {
      json["multiples"] = multiples_json(
          multiples_of(answer.asked.question.grasp.as_box(), found, directions[0]));
    }
    json["exact"] = found.is_exact;
    json["complete"] = found.is_complete;
    Json& stand = json["stand"] = Json::array();
    for (const StandPoint& point : found.stand) {
      stand.push_back(
          {{"point", number_json(point.point)}, {"forces", forces_json(point.forces)}});
    }
    json["move"] = rows_json(found.move);
  }
};

std::string row_text(const RationalRow& row) {
  std::string text;
  for (const Rational& entry : row) text += (text.empty() ? "" : ",") + to_string(entry);
  return text;
}

/// Returns the options of a checker but for the factor of friction.
std::string options_of(const StaticsQuestion& asked) {
  std::string options;
  const std::vector<RationalRow>& directions = asked.asked.directions;
  RationalRow wrench;
  for (const Interval& w : asked.question.grasp.wrench()) wrench.push_back(w.low);
  if (asked.gives_wrench) {
    options += " --wrench " + row_text(wrench);
  } else if (!asked.question.case_name.empty()) {
    options += " --case '" + asked.question.case_name + "'";
  }
  if (directions.size() == 1) options += " --direction " + row_text(directions[0]);
  if (directions.size() == 2) {
    options += " --plane " + row_text(directions[0]) + "," + row_text(directions[1]);
  }
  if (asked.question.preload) options += " --preload " + to_string(*asked.question.preload);
  if (asked.question.law == NormalLaw::kBilateral) options += " --normal-law bilateral";
  return options;
}

}  // namespace

std::optional<Undecided> StaticsAnswer::undecided() const {
  if (const auto* one = std::get_if<LoadClass>(&found)) {
    if (const auto* undecided = std::get_if<Undecided>(one)) return *undecided;
  }
  if (const auto* least = std::get_if<LeastFrictionAnswer>(&found)) {
    if (const auto* undecided = std::get_if<Undecided>(least)) return *undecided;
  }
  return std::nullopt;
}

StaticsAnswer statics(StaticsQuestion asked) {
  GraspBox box = asked.question.grasp.as_box();
  if (!box.is_point()) {
    throw InputError("", "uncertain", "some numbers are uncertain, and statics needs one grasp",
                     "give one number for each");
  }
  const Rational& factor = asked.asked.friction_factor;
  if (factor.sign() < 0) {
    throw InputError("", "friction", "the factor is " + to_string(factor),
                     "all friction is multiplied by a factor of 0 or more");
  }
  const std::vector<RationalRow>& directions = asked.asked.directions;
  if (asked.least_friction && !directions.empty()) {
    throw InputError("", "friction", "the least friction is asked for, and loads as well",
                     "ask for one of the two");
  }
  for (const RationalRow& direction : directions) {
    if (direction.size() == box.wrench.size()) continue;
    throw InputError("", directions.size() == 1 ? "direction" : "plane",
                     "it has " + std::to_string(direction.size()) + " numbers",
                     "give " + std::to_string(box.wrench.size()) +
                         ", as many as the load of this grasp has");
  }
  if (asked.least_friction) {
    auto found = least_friction(box, asked.accuracy);
    return {std::move(asked), std::move(found)};
  }
  if (directions.empty()) {
    LoadClass found = statics(box, factor);
    return {std::move(asked), std::move(found)};
  }
  StandingLoads found = standing_loads(box, directions, factor, asked.accuracy);
  return {std::move(asked), std::move(found)};
}

std::pair<RationalRow, std::vector<RationalRow>> loads_of_places(const Question& question,
                                                                 const RationalRow& force,
                                                                 const std::string& body) {
  const bool in_space = question.in_space();
  const std::size_t points = in_space ? 3 : 2;
  if (force.size() != points) {
    throw InputError("", "place", "the force has " + std::to_string(force.size()) + " numbers",
                     in_space ? "give its x, y and z" : "give its x and y");
  }
  const Mechanism* mechanism = question.mechanism();
  if (mechanism == nullptr && !body.empty()) {
    throw InputError("", "body", "the grasp has one body", "leave it out");
  }
  const std::size_t components = question.grasp.wrench().size();
  const auto load_of = [&](const RationalRow& wrench) {
    if (mechanism == nullptr) return wrench;
    RationalRow load(components);
    add_multiple(load, 1, mechanism->load_on(mechanism->body_named(body, "body"), wrench));
    return load;
  };
  RationalRow at_origin = force;
  at_origin.resize(in_space ? 6 : 3);
  std::vector<RationalRow> directions;
  if (!in_space) return {load_of(at_origin), {load_of({0, 0, force[1]})}};
  // (1, 0, 0) x f and (0, 1, 0) x f
  directions.push_back(load_of({0, 0, 0, 0, -force[2], force[1]}));
  directions.push_back(load_of({0, 0, 0, force[2], 0, -force[0]}));
  return {load_of(at_origin), std::move(directions)};
}

void set_load(Question& question, const RationalRow& load) {
  GraspBox box = question.grasp.as_box();
  for (std::size_t j = 0; j < load.size(); ++j) box.wrench[j] = point_interval(load[j]);
  question.grasp = std::move(box);
}

void add_load(Question& question, const RationalRow& load) {
  GraspBox box = question.grasp.as_box();
  for (std::size_t j = 0; j < load.size(); ++j) {
    box.wrench[j].low += load[j];
    box.wrench[j].high += load[j];
  }
  question.grasp = std::move(box);
}

Json to_json(const StaticsAnswer& answer) {
  const Question& question = answer.asked.question;
  Json json{{"name", question.description().name}};
  if (!question.case_name.empty()) json["case"] = question.case_name;
  add_conventions(json, question.description());
  json["wrench"] = wrench_json(question.grasp.wrench());
  if (!answer.asked.least_friction) {
    json["friction_factor"] = number_json(answer.asked.asked.friction_factor);
  }
  if (!answer.asked.asked.directions.empty()) {
    json["directions"] = rows_json(answer.asked.asked.directions);
  }
  std::visit(FoundJson{json, answer}, answer.found);
  return json;
}

std::vector<StaticsCertificate> certificates_of(const StaticsAnswer& answer) {
  std::vector<StaticsCertificate> result;
  const StaticsQuestion& asked = answer.asked;
  const auto add = [&](const std::string& name, const Rational& factor, const auto& found) {
    StaticsAsked about = asked.asked;
    about.friction_factor = factor;
    result.push_back({name, statics_certificate_text(asked.question, about, found, kProducer),
                      "--statics " + to_string(factor) + options_of(asked)});
  };
  if (answer.undecided()) return result;
  if (const auto* one = std::get_if<LoadClass>(&answer.found)) {
    add("statics", asked.asked.friction_factor, *one);
  } else if (const auto* loads = std::get_if<StandingLoads>(&answer.found)) {
    add("statics", asked.asked.friction_factor, *loads);
  } else {
    const auto& least = std::get<LeastFrictionAnswer>(answer.found);
    if (const auto* motion = std::get_if<UnopposedMotion>(&least)) {
      add("moves", 1, LoadClass(*motion));
    } else {
      const auto& found = std::get<LeastFriction>(least);
      if (!found.motion.twist.empty()) add("moves", found.low, LoadClass(found.motion));
      add("stands", found.high, LoadClass(found.forces));
    }
  }
  return result;
}

}  // namespace stickslip
