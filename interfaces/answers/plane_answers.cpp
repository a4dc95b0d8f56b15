// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/plane_answers.hpp"

#include <utility>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace {

Json json_of(const PlaneCell& cell) {
  Json json{{"vertices", Json::array()}, {"rays", Json::array()}};
  for (const PlanePoint& point : cell.vertices())
    json["vertices"].push_back(number_json(point));
  for (const PlaneDirection& ray : cell.rays()) json["rays"].push_back(number_json(ray));
  return json;
}

Json json_of(const Outline& outline) {
  Json json{{"closed", outline.is_closed()}};
  if (outline.from) json["from"] = number_json(*outline.from);
  json["vertices"] = Json::array();
  for (const PlanePoint& point : outline.vertices)
    json["vertices"].push_back(number_json(point));
  if (outline.to) json["to"] = number_json(*outline.to);
  return json;
}

Json ends_json(const Interval& interval) {
  return Json::array({number_json(interval.low), number_json(interval.high)});
}

}  // namespace

RegionAnswer region_answer(Question question, const WrenchPlane& plane,
                           const RegionOptions& options) {
  RegionAnswer answer{std::move(question), plane};
  auto found = resistible_set(problem_of(answer.question), plane, options.modes, &answer.work);
  if (auto* undecided = std::get_if<Undecided>(&found)) {
    answer.undecided = std::move(*undecided);
  } else {
    answer.found = std::get<ResistibleSet>(std::move(found));
  }
  return answer;
}

std::variant<std::string, Undecided> certificate_of(const RegionAnswer& answer,
                                                    const RegionOptions& options) {
  const auto& [question, plane, found, work, undecided] = answer;
  require(!undecided, "a region that is not known has no certificate");
  const Problem problem = problem_of(question);
  ResistibleOptions with_pieces = options.modes;
  with_pieces.pieces = true;
  const auto again = resistible_set(problem, plane, with_pieces);
  if (const auto* limit = std::get_if<Undecided>(&again)) return *limit;
  auto proof =
      prove_region(problem, plane, std::get<ResistibleSet>(again).pieces, options.proof);
  if (auto* limit = std::get_if<Undecided>(&proof)) return std::move(*limit);
  return region_certificate_text(question, plane, std::get<RegionProof>(proof),
                                 "stickslip " STICKSLIP_VERSION);
}

Json to_json(const RegionAnswer& answer) {
  const auto& [question, plane, found, work, undecided] = answer;
  const auto& [region, pieces] = found;
  Json json{{"name", question.description().name},
            {"normal_law", to_string(question.law)},
            {"plane",
             {{"origin", number_json(coordinates(plane.origin()))},
              {"u", number_json(coordinates(plane.u()))},
              {"v", number_json(coordinates(plane.v()))}}}};
  add_conventions(json, question.description());
  if (undecided) {
    add_undecided(json, *undecided);
  } else {
    json["empty"] = region.is_empty();
    json["whole_plane"] = region.is_whole_plane();
    Json& areas = json["areas"] = Json::array();
    for (const PlaneArea& area : region.areas) {
      Json outlines = Json::array();
      for (const Outline& outline : area.outlines) outlines.push_back(json_of(outline));
      areas.push_back({{"outlines", std::move(outlines)}});
    }
    Json& curves = json["curves"] = Json::array();
    for (const PlaneCell& curve : region.curves) curves.push_back(json_of(curve));
    Json& points = json["points"] = Json::array();
    for (const PlanePoint& point : region.points) points.push_back(number_json(point));
    for (const ResistiblePiece& piece : pieces) {
      Json entry{{"slip", slips_text(piece.modes)}, {"closed", Json::array()}};
      for (const ContactMode mode : piece.modes) entry["closed"].push_back(mode.closed);
      entry.update(json_of(piece.cell));
      json["pieces"].push_back(std::move(entry));
    }
  }
  json["stats"] = {{"nodes", work.nodes},
                   {"borders", work.borders},
                   {"modes", work.modes},
                   {"pieces", work.pieces}};
  return json;
}

Json map_json(const Question& question, const MapAxis& x, const MapAxis& y,
              const std::vector<MapCell>& cells) {
  Json json;
  json["name"] = question.description().name;
  json["normal_law"] = to_string(question.law);
  if (question.is_bounded()) json["max_motion"] = number_json(question.box()->max_motion);
  json["x"] = {{"name", x.name}, {"range", ends_json(x.range)}};
  json["y"] = {{"name", y.name}, {"range", ends_json(y.range)}};
  Json& list = json["cells"] = Json::array();
  for (const MapCell& cell : cells) {
    list.push_back({{"x", ends_json(cell.x)},
                    {"y", ends_json(cell.y)},
                    {"verdict", name_of(cell.decision.verdict)}});
  }
  return json;
}

LoadWindow load_window(const Question& question, RationalRow origin, RationalRow u,
                       RationalRow v) {
  LoadWindow plane{*question.box(), std::move(origin), {}, {}};
  Rational sum = 0;
  for (const UncertainContact& c : plane.grasp.contacts) sum += c.preload.low;
  const Rational reach = sum.is_zero() ? Rational(1) : sum;
  for (std::size_t j = 0; j < plane.origin.size(); ++j)
    plane.grasp.wrench[j] = point_interval(plane.origin[j]);
  plane.s.name = "s";
  plane.s.along = std::move(u);
  plane.t.name = "t";
  plane.t.along = std::move(v);
  for (MapAxis* axis : {&plane.s, &plane.t}) {
    axis->kind = AxisKind::kAlong;
    axis->range = {-reach, reach};
  }
  return plane;
}

Json region_json(const Question& question, const LoadWindow& plane,
                 const std::vector<MapCell>& cells) {
  Json json = map_json(question, plane.s, plane.t, cells);
  json["plane"] = {{"origin", number_json(plane.origin)},
                   {"u", number_json(plane.s.along)},
                   {"v", number_json(plane.t.along)}};
  add_conventions(json, question.description());
  return json;
}

Json states_json(const Enumeration& found, bool listed) {
  const ArrangementCounts& c = found.found.counts;
  Json json{{"contacts", c.planes},  {"circles", c.circles},
            {"rank", c.rank},        {"vertices", c.vertices},
            {"edges", c.edges},      {"faces", c.faces},
            {"cells", c.cells()},    {"distinct_states", c.distinct_states},
            {"engine", found.engine}};
  if (listed) {
    Json& states = json["states"] = Json::array();
    for (const SlipState& state : found.found.states) states.push_back(to_string(state));
  }
  return json;
}

}  // namespace stickslip
