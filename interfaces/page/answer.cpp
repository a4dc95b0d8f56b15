// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/interfaces/answer.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "cells.hpp"
#include "doubles.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spatial_forces.hpp"
#include "stickslip/earlier/statics.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/engine/near_forces.hpp"
#include "stickslip/interfaces/comparison_answer.hpp"
#include "stickslip/interfaces/margin_answer.hpp"
#include "stickslip/interfaces/option_text.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/quality_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/quality.hpp"
#include "stickslip/measures/spatial_margin.hpp"

namespace stickslip {

using namespace page_detail;

namespace {

/// The depths of the finest cells of maps.
constexpr unsigned kCoarsestMap = 2;
constexpr unsigned kFinestMap = 4;
/// The part by which the proved and the refuted radius may differ.
const Rational kQualityAccuracy(1, 20);

/// The reason why a part cannot be had.
struct NotToBeHad {
  std::string why;
};

/// Returns the text as a file of version 2: one of version 1 differs in the number alone.
std::string in_version2(std::string text) {
  const std::string first = "\"stickslip-grasp/1\"";
  const std::size_t at = text.find(first);
  if (at == std::string("{\"format\": ").size()) text[at + first.size() - 2] = '2';
  return text;
}

std::string text_of(const GraspFile& file) {
  return in_version2(write_grasp_file(file));
}

/// Returns the file without its body: a page has its bodies once, and not with each example of
/// a box.
GraspFile without_body(GraspFile file) {
  GraspBox* box = file.content.box();
  if (box == nullptr) return file;
  box->description.body.reset();
  if (box->mechanism) {
    auto bare = std::make_shared<Mechanism>(*box->mechanism);
    for (Body& body : bare->bodies) body.mesh.reset();
    box->mechanism = std::move(bare);
  }
  return file;
}

std::vector<std::string> case_names(const GraspFile& file) {
  std::vector<std::string> names;
  for (const NamedLoad& each : file.cases) names.push_back(each.name);
  return names;
}

Json or_null(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json or_null(BodyIndex body) {
  return body ? Json(*body) : Json();
}

Json question_json(const QuestionText& asked) {
  return {{"wrench", or_null(asked.wrench)},
          {"case", or_null(asked.case_name)},
          {"preload", or_null(asked.preload)},
          {"normal_law", asked.normal_law},
          {"uncertain", or_null(asked.uncertain)}};
}

Json middles_json(const std::vector<Interval>& numbers) {
  Json json = Json::array();
  for (const Interval& x : numbers) json.push_back(to_double(x.middle()));
  return json;
}

std::array<Rational, 2> planar(const RationalRow& row) {
  return {row.at(0), row.at(1)};
}

Json contacts_json(const GraspBox& grasp) {
  Json contacts = Json::array();
  for (const UncertainContact& c : grasp.contacts) {
    contacts.push_back({{"position", middles_json(c.position)},
                        {"normal", grasp.in_space() ? Json(unit(vector3(c.normal)))
                                                    : Json(unit(planar(c.normal)))},
                        {"friction", to_double(c.friction.middle())},
                        {"stiffness", to_double(c.stiffness.middle())},
                        {"preload", to_double(c.preload.middle())}});
    if (!c.torsion.is_zero()) contacts.back()["torsion"] = to_double(c.torsion);
    if (!grasp.mechanism) continue;
    contacts.back()["of"] = or_null(c.of);
    contacts.back()["by"] = or_null(c.by);
  }
  return contacts;
}

Json outline_json(const std::vector<Polygon>& outline) {
  Json rings = Json::array();
  for (const Polygon& polygon : outline) {
    for (const Ring& ring : polygon) {
      Json points = Json::array();
      for (const Vector2& p : ring) points.push_back({to_double(p.x), to_double(p.y)});
      rings.push_back(std::move(points));
    }
  }
  return rings.empty() ? Json() : rings;
}

Json link_json(const Link& link) {
  return {{"slides", link.slides},
          {"at", in_doubles_json(link.at)},
          {"axis", in_doubles_json(link.axis)},
          {"on", or_null(link.on)}};
}

const char* kind_of(const Spring& spring) {
  return spring.is_ratchet()                   ? "ratchet"
         : spring.kind == Spring::Kind::kJoint ? "joint"
                                               : "tendon";
}

Json mechanism_json(const GraspBox& grasp) {
  if (!grasp.mechanism) return {};
  const Mechanism& mechanism = *grasp.mechanism;
  Json bodies = Json::array();
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    Json motion = Json::array();
    for (const RationalRow& row : mechanism.motion_of(b))
      motion.push_back(in_doubles_json(row));
    bodies.push_back({{"name", body.name},
                      {"outline", outline_json(body.outline)},
                      {"link", body.link ? link_json(*body.link) : Json()},
                      {"motion", std::move(motion)}});
  }
  Json springs = Json::array();
  for (const Spring& spring : grasp.springs) {
    springs.push_back(
        {{"kind", kind_of(spring)}, {"name", spring.name}, {"place", spring.place}});
  }
  return {{"coordinates", coordinate_names(mechanism)},
          {"bodies", std::move(bodies)},
          {"springs", std::move(springs)}};
}

// Motions and forces near an equilibrium may be drawn if the proof states none.

/// Returns a vector with as many coordinates as the file has.
RationalRow in_file(const Question& question, const Vector3& v) {
  return {v.begin(), v.begin() + (question.in_space() ? 3 : 2)};
}

Json near_json(const Answer& answer) {
  const auto* stable = std::get_if<Stable>(&answer.verdict);
  if (stable == nullptr || !std::holds_alternative<StabilityProof>(stable->proof)) return {};
  Json contacts = Json::array();
  for (const SpatialForce& f : near_forces(answer.question, stable->motion)) {
    contacts.push_back({{"force_float", in_doubles_json(in_file(answer.question, f.force))},
                        {"closed", f.normal.sign() > 0}});
  }
  return {{"twist_float", in_doubles_json(stable->motion)}, {"contacts", std::move(contacts)}};
}

/// Returns the claims of a margin on its way, in order; without their proofs, which may be
/// long.
SpatialMargin without_proofs(const SpatialMargin& so_far) {
  SpatialMargin claims;
  claims.work = so_far.work;
  std::multimap<Rational, MultiplesClaim> by_low_end;
  for (const MultiplesClaim& claim : so_far.claims) {
    if (const auto* resisted = std::get_if<ResistedMultiples>(&claim)) {
      by_low_end.emplace(resisted->low, ResistedMultiples{resisted->low, resisted->high, {}});
    } else {
      const auto& refuted = std::get<RefutedMultiples>(claim);
      by_low_end.emplace(refuted.low, RefutedMultiples{refuted.low, refuted.high, {}});
    }
  }
  for (auto& [low, claim] : by_low_end) claims.claims.push_back(std::move(claim));
  return claims;
}

/// Refuses a part about a box: some of its grasps may hold and some not, so only its verdict is
/// shown.
[[noreturn]] void refuse_box() {
  throw NotToBeHad{
      "the question is about more than one grasp, and this is about one: give numbers for all "
      "intervals"};
}

[[noreturn]] void refuse_irrational_lengths() {
  throw NotToBeHad{
      "a preloaded contact has a normal of irrational length; `stickslip snap` writes the "
      "grasp with rational ones"};
}

[[noreturn]] void refuse_space() {
  throw NotToBeHad{"the grasp is in space, and this is found in the plane only"};
}

/// Refuses a part about several bodies; `instead` says what else may be done.
void refuse_several(const Question& question, const std::string& instead = "") {
  if (question.mechanism() == nullptr) return;
  throw NotToBeHad{"there are several bodies, and the page has this of one" +
                   (instead.empty() ? "" : "; " + instead)};
}

/// Returns the one grasp of one body in the plane; refuses any other.
const LoadedGrasp& one_grasp(const Question& question) {
  if (question.in_space()) refuse_space();
  if (const GraspBox* box = question.box()) {
    box->is_point() ? refuse_irrational_lengths() : refuse_box();
  }
  return question.loaded();
}

class PageAnswer {
 public:
  PageAnswer(const GraspFile& file, QuestionText asked, const PageLimits& limits,
             const std::string& name)
      : text_(text_of(file)),
        file_(without_body(file)),
        asked_(std::move(asked)),
        limits_(limits),
        name_(name),
        asked_in_centre_(asked_),
        question_(ask_about(asked_)) {
    Tolerances others = question_.uncertain;
    others.ball.reset();
    if (question_.uncertain.ball && !others.any()) {
      asked_in_centre_.uncertain.clear();
      centre_ = ask_about(asked_in_centre_);
    }
    const bool names_body = question_.uncertain.ball && !question_.uncertain.ball->body.empty();
    if (centre().mechanism() != nullptr && !names_body) centre_ = as_one_body(centre());
  }

  Json answer(const PageParts& parts) {
    Json json{{"format", "stickslip-page/1"},
              {"live", false},
              {"name", file_.description().name},
              {"dimension", question_.in_space() ? 6 : 3},
              {"grasp", text_},
              {"question", question_json(asked_)},
              {"cases", case_names(file_)}};
    const GraspBox grasp = question_.grasp.as_box();
    json["contacts"] = contacts_json(grasp);
    json["wrench"] = middles_json(grasp.wrench);
    json["outline"] = outline_json(grasp.description.outline);
    json["mechanism"] = mechanism_json(grasp);
    const auto asks = [&](PagePart part) { return parts.count(part) != 0; };
    if (asks(PagePart::kDecide)) decide(json, asks(PagePart::kWarnings));
    if (asks(PagePart::kDecide) && grasp.mechanism && grasp.is_point()) {
      part(json, "statics", [&](Json& found) { found = name_of(statics(grasp)); });
    }
    if (asks(PagePart::kStates)) part(json, "states", [&](Json& found) { found = states(); });
    if (asks(PagePart::kRegion)) part(json, "region", [&](Json& found) { region(found); });
    if (asks(PagePart::kMargin)) part(json, "margin", [&](Json& found) { margin(found); });
    if (asks(PagePart::kMap)) part(json, "map", [&](Json& found) { map(found); });
    if (asks(PagePart::kQuality)) quality(json);
    if (asks(PagePart::kCompare)) {
      part(
          json, "compare", [&](Json& found) { found = compared(); }, TimeLimit());
    }
    json["messages"] = std::move(messages_);
    return json;
  }

  void add_message(const std::string& message) { messages_.push_back(message); }

 private:
  /// Returns the question about one grasp, unless more than loads in a ball is uncertain.
  const Question& centre() const { return centre_ ? *centre_ : question_; }

  Question ask_about(const QuestionText& text) const {
    return ask_with_options(file_, question_options(text), name_, true);
  }

  /// Returns the limit from now on; 0 is none.
  static TimeLimit limit_of(std::chrono::milliseconds time) {
    return time.count() > 0 ? TimeLimit(Rational(time.count(), 1000)) : TimeLimit();
  }

  /// Adds a part. It is null if `find` says why, or is not done in time; `find` may give what
  /// it has on its way.
  void part(Json& json, const std::string& name, const std::function<void(Json& found)>& find) {
    part(json, name, find, limit_of(limits_.time));
  }
  void part(Json& json, const std::string& name, const std::function<void(Json& found)>& find,
            const TimeLimit& limit) {
    Json found;
    const auto say = [&](const std::string& why) { add_message(name + ": " + why + "."); };
    try {
      if (!limit.finishes([&] { find(found); })) {
        say((found.is_null() ? "not known within " : "no more is known within ") +
            to_readable_string(Rational(limits_.time.count(), 1000)) +
            (limits_.time.count() == 1000 ? " second" : " seconds"));
      }
    } catch (const NotToBeHad& reason) {
      say(reason.why);
    } catch (const InputError& error) {
      say(error.problem() + (error.remedy().empty() ? "" : "; " + error.remedy()));
    }
    json[name] = finished(found, true);
  }

  void decide(Json& json, bool warnings) {
    std::optional<Answer> answer;
    const auto find = [&](Json& found) {
      // Pictures need exact forces, however long they are.
      SearchOptions options = by(Engine::kBranchAndBound);
      options.node_limit = limits_.node_limit;
      answer =
          stickslip::decide(question_, options, [&](const Answer& first) { answer = first; });
      found = to_json(*answer, warnings ? Warnings(model_warnings(*answer)) : Warnings());
    };
    if (limits_.limits_verdict) {
      part(json, "decide", find);
    } else {
      Json found;
      find(found);
      json["decide"] = finished(found, true);
    }
    json["certificate"] = nullptr;
    json["near"] = nullptr;
    json["examples"] = nullptr;
    if (!answer) return;
    if (const auto certificate = certificate_of(*answer)) json["certificate"] = *certificate;
    part(json, "near", [&](Json& found) { found = near_json(*answer); });
    // A verdict that has to follow a drag comes alone.
    if (limits_.limits_verdict || !json["decide"].contains("examples")) return;
    part(json, "examples", [&](Json& found) { found = examples(json["decide"]["examples"]); });
  }

  /// Returns the answers of a page about each of these grasp files.
  Json examples(const Json& files) const {
    QuestionText asked;
    asked.normal_law = asked_.normal_law;
    Json answers;
    for (const auto& [verdict, file] : files.members()) {
      answers[verdict] = page_answer(parse_any_grasp(file.dump(), name_), asked,
                                     {PagePart::kDecide}, limits_, name_);
    }
    return answers;
  }

  Json states() const {
    refuse_several(centre());
    if (centre().in_space()) refuse_space();
    const AnyGrasp& grasp = centre().grasp;
    if (grasp.contacts() > kMostContactsWithCells) {
      throw NotToBeHad{"the cells of " + std::to_string(grasp.contacts()) +
                       " contacts are too many to show; up to " +
                       std::to_string(kMostContactsWithCells) +
                       " are, and `stickslip states` counts those of any number"};
    }
    return cells_json(loaded_of(grasp.as_box().middle()).grasp);
  }

  void region(Json& found) const {
    refuse_several(centre());
    if (question_.in_space() || question_.is_bounded()) return region_in_cells(found);
    const LoadedGrasp& one = one_grasp(centre());
    if (one.grasp.size() > kMostContactsWithRegion) {
      throw NotToBeHad{"there are more than " + std::to_string(kMostContactsWithRegion) +
                       " contacts; `stickslip region` has no limit"};
    }
    const WrenchPlane plane = WrenchPlane::forces(one.wrench.torque);
    found = to_json(region_answer(centre(), plane));
  }

  /// Finds the region of forces in the plane of axes that the load is in, or nearest to. The
  /// cells are coarse at first, and then finer.
  void region_in_cells(Json& found) const {
    if (!centre().box()->is_point()) refuse_box();
    RationalRow origin = middle_of(centre().grasp.wrench());
    std::vector<std::size_t> axes{0, 1};
    if (question_.in_space()) axes.push_back(2);
    std::stable_sort(axes.begin(), axes.end(), [&](std::size_t i, std::size_t j) {
      return Rational(abs(origin[i])) > Rational(abs(origin[j]));
    });
    std::sort(axes.begin(), axes.begin() + 2);
    const Rational most =
        std::max(Rational(abs(origin[axes[0]])), Rational(abs(origin[axes[1]])));
    RationalRow u(origin.size());
    RationalRow v(origin.size());
    u[axes[0]] = v[axes[1]] = 1;
    origin[axes[0]] = origin[axes[1]] = 0;
    LoadWindow plane = load_window(centre(), origin, u, v);
    // The window shows the load itself.
    for (MapAxis* axis : {&plane.s, &plane.t}) {
      axis->range.high = std::max(axis->range.high, Rational(most * Rational(5, 4)));
      axis->range.low = -axis->range.high;
    }
    cells_finer_and_finer(plane.grasp, plane.s, plane.t,
                          [&](const std::vector<MapCell>& cells) {
                            found = region_json(centre(), plane, cells);
                          });
  }

  /// Returns the question about multiples of the load: the load becomes the direction.
  QuestionText along_the_load() const {
    const GraspBox* box = centre().box();
    if (box != nullptr && !box->is_point()) refuse_box();
    std::string direction;
    bool is_zero = true;
    for (const Rational& w : middle_of(centre().grasp.wrench())) {
      direction += (direction.empty() ? "" : ",") + to_string(w);
      is_zero = is_zero && w.is_zero();
    }
    if (is_zero) throw NotToBeHad{"there is no load, and so no multiple of it"};
    QuestionText text = asked_in_centre_;
    text.wrench.clear();
    text.case_name.clear();
    text.direction = direction;
    return text;
  }

  /// Sets `found` to the margin; claims come first as far as they are known.
  void margin(Json& found) const {
    const Question question = ask_about(along_the_load());
    if (question.has_claims()) {
      SpatialMarginOptions options;
      options.search.node_limit = limits_.node_limit;
      const auto keep = [&](const SpatialMargin& so_far) {
        found = margin_json(question, without_proofs(so_far), std::nullopt);
      };
      found = margin_json(question, find_spatial_margin(question, options, keep), std::nullopt);
      return;
    }
    SearchOptions options;
    options.node_limit = limits_.node_limit;
    MarginWork work;
    const auto margin = find_margin(problem_of(question), options, &work);
    if (const auto* undecided = std::get_if<Undecided>(&margin)) {
      throw NotToBeHad{in_words(*undecided)};
    }
    found = margin_json(question, std::get<Margin>(margin), work, std::nullopt);
  }

  void map(Json& found) const {
    refuse_several(centre(), "`stickslip map` finds it");
    if (question_.is_bounded() && !question_.in_space()) {
      throw NotToBeHad{
          "motions are bounded, and the page has this without a bound; "
          "`stickslip map` finds it"};
    }
    const LoadedGrasp& one = one_grasp(centre());
    if (one.wrench == Wrench{}) throw NotToBeHad{"there is no load to vary"};
    const GraspBox grasp = box_of(one);
    const MapAxis x = parse_axis(grasp, "friction=0:2", "x");
    const MapAxis y = parse_axis(grasp, "load=0:2", "y");
    cells_finer_and_finer(grasp, x, y, [&](const std::vector<MapCell>& cells) {
      found = map_json(centre(), x, y, cells);
    });
  }

  /// Gives what is known so far, and then all.
  void quality(Json& json) {
    std::optional<Quality> quality;
    part(json, "quality", [&](Json& found) {
      const GraspBox grasp = centre().grasp.as_box();
      if (!grasp.is_point()) refuse_box();
      const LoadBall shape = shape_for({question_.uncertain.ball.value_or(LoadBall{1}),
                                        question_.uncertain.ball.has_value()},
                                       centre());
      if (grasp.mechanism && shape.body.empty()) {
        throw NotToBeHad{
            "there are several bodies; `stickslip quality --body NAME` finds that of loads on "
            "one"};
      }
      QualityOptions options;
      options.radius.box.node_limit = limits_.node_limit;
      options.radius.accuracy = kQualityAccuracy;
      quality = find_quality(grasp, question_.law, shape, options, [&](const Quality& so_far) {
        if (so_far.stable) found = quality_json(centre(), so_far);
      });
      found = quality_json(centre(), *quality);
    });
    json["lost"] = nullptr;
    if (!quality || quality->stable != true || !quality->radii.example) return;
    part(json, "lost", [&](Json& found) { found = under(quality->radii.example->wrench); });
  }

  /// Returns what earlier methods say. Each method has an answer, if only that the time was
  /// over.
  Json compared() const {
    refuse_several(centre(), "`stickslip compare` has the class of their load");
    if (!centre().grasp.as_box().is_point()) refuse_box();
    const Question unbounded = without_bound(centre());
    if (!unbounded.in_space() && unbounded.box() != nullptr) refuse_irrational_lengths();
    ComparisonAsked asked;
    if (question_.uncertain.ball) asked.length = question_.uncertain.ball->length;
    CompareOptions options = options_for(asked, centre());
    options.time = limit_of(limits_.time);
    if (limits_.node_limit > 0) {
      options.node_limit = std::min(options.node_limit, limits_.node_limit);
    }
    NumberText text(false);
    const Comparison found = compare_methods(centre(), options, text);
    return comparison_json(centre(), options.length, options.inertia, found);
  }

  /// Returns the answer of a page about the grasp under another load.
  Json under(const WrenchBox& load) const {
    QuestionText text = asked_in_centre_;
    text.case_name.clear();
    text.wrench.clear();
    for (const Interval& w : load) {
      text.wrench += (text.wrench.empty() ? "" : ",") + to_string(w.low);
    }
    return page_answer(file_, text, {PagePart::kDecide}, limits_, name_);
  }

  template <class Keep>
  void cells_finer_and_finer(const GraspBox& grasp, const MapAxis& x, const MapAxis& y,
                             const Keep& keep) const {
    MapOptions options;
    options.box.node_limit = limits_.node_limit;
    for (options.depth = kCoarsestMap; options.depth <= kFinestMap; ++options.depth) {
      std::vector<MapCell> cells;
      map_verdicts(grasp, question_.law, x, y, options,
                   [&](MapCell cell) { cells.push_back(std::move(cell)); });
      keep(cells);
    }
  }

  std::string text_;  ///< the text of the file, with its body
  GraspFile file_;
  QuestionText asked_;
  const PageLimits& limits_;
  const std::string& name_;
  QuestionText asked_in_centre_;  ///< the question without a ball, if nothing else is uncertain
  Question question_;
  std::optional<Question> centre_;  ///< the same as a question, if it is another
  std::vector<std::string> messages_;
};

}  // namespace

PageParts all_page_parts() {
  return {PagePart::kDecide, PagePart::kStates,  PagePart::kRegion,  PagePart::kMargin,
          PagePart::kMap,    PagePart::kQuality, PagePart::kCompare, PagePart::kWarnings};
}

Json page_answer(const GraspFile& file, const QuestionText& asked, const PageParts& parts,
                 const PageLimits& limits, const std::string& name) {
  const std::vector<std::string> cases = case_names(file);
  if (cases.empty() || !asked.wrench.empty() || !asked.case_name.empty()) {
    return PageAnswer(file, asked, limits, name).answer(parts);
  }
  QuestionText first = asked;
  first.case_name = cases.front();
  PageAnswer answer(file, first, limits, name);
  if (cases.size() > 1) {
    answer.add_message("The file has " + std::to_string(cases.size()) + " cases; this is " +
                       quote(cases.front()) + ", the first.");
  }
  return answer.answer(parts);
}

}  // namespace stickslip
