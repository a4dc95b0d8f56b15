// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about a grasp, by name. Each reads its options, which are values of Python, and
// returns its work, which is done without Python and ends in JSON.
#include <pybind11/stl.h>

#include <map>

#include "bindings.hpp"
#include "exact.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "stickslip/earlier/friction_margin.hpp"
#include "stickslip/engine/decide_in_time.hpp"
#include "stickslip/interfaces/answer.hpp"
#include "stickslip/interfaces/claim_answer.hpp"
#include "stickslip/interfaces/comparison_answer.hpp"
#include "stickslip/interfaces/grasp_plot.hpp"
#include "stickslip/interfaces/html.hpp"
#include "stickslip/interfaces/map_plot.hpp"
#include "stickslip/interfaces/margin_answer.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/preload_answer.hpp"
#include "stickslip/interfaces/question_text.hpp"
#include "stickslip/interfaces/radius_answer.hpp"
#include "stickslip/interfaces/region_plot.hpp"
#include "stickslip/interfaces/samples_answer.hpp"
#include "stickslip/interfaces/states_answer.hpp"
#include "stickslip/interfaces/states_plot.hpp"
#include "stickslip/interfaces/statics_answer.hpp"

namespace stickslip::python {
namespace {

namespace py = pybind11;

using Work = std::function<Json()>;

const char* const kProducer = "stickslip " STICKSLIP_VERSION;

/// The grasp and the options of a question, as Python gives them. The grasp outlives the work.
class Given {
 public:
  Given(const GraspFile& file, py::dict options)
      : grasp(file), options_(std::move(options)), asked_(question_options(options_)) {}

  py::object operator[](const char* name) const { return options_[name]; }
  template <class Value>
  Value as(const char* name) const {
    return options_[name].cast<Value>();
  }
  SearchOptions search() const {
    SearchOptions options;
    options.node_limit = as<std::size_t>("node_limit");
    return options;
  }
  /// Returns the limit of the work's time, from now on.
  TimeLimit time() const {
    if (!options_.contains("time_limit") || options_["time_limit"].is_none()) return {};
    return TimeLimit(exact(options_["time_limit"], "time_limit"));
  }
  /// Returns a number that is above 0, and below 1 if it is a part of a whole.
  Rational positive(const char* name, const char* remedy, bool is_part = false) const {
    Rational number = exact(options_[name], name);
    if (number.sign() > 0 && !(is_part && number >= 1)) return number;
    throw InputError("", name, "the value is " + to_string(number), remedy);
  }
  Inertia inertia(bool in_space = false) const {
    return inertia_of("inertia", numbers(options_["inertia"], 0, "inertia"), in_space);
  }
  /// Returns the length by which torques are divided: that given, or what suits the grasp.
  Rational length(const char* remedy) const {
    if (!options_["length"].is_none()) return positive("length", remedy);
    return characteristic_length(about().grasp.as_box());
  }
  /// Returns the shape of a ball of loads.
  LoadBall ball() const {
    LoadBall shape{1, length("give a number above 0")};
    if (!options_["about"].is_none()) {
      shape.set_about(numbers(options_["about"], 0, "about"));
    }
    shape.body = as<std::string>("body");
    return shape;
  }

  const QuestionOptions& asked() const { return asked_; }
  /// Returns the question about rigid contacts, which know no preloads.
  Question rigid() const {
    QuestionOptions options = asked_;
    options.preload = 0;
    return question_of(grasp, options);
  }
  /// Returns the question for statics, which takes limits of forces.
  Question about_statics() const {
    QuestionOptions options = asked_;
    options.takes_limits = true;
    return question_about(grasp, options);
  }
  Question about() const { return question_about(grasp, asked_); }

  const GraspFile& grasp;

 private:
  py::dict options_;
  QuestionOptions asked_;
};

/// Does the work, which sets what is known when it ends, and before. Returns the limit that
/// ended it, or nothing.
std::string ended_by(const TimeLimit& limit, const std::function<void()>& work) {
  return limit.finishes(work) ? "" : limit.in_words();
}

Json with_end(Json json, const std::string& ended_by) {
  if (!ended_by.empty()) json["ended_by"] = ended_by;
  return json;
}

/// Returns what the work returns. Throws LimitError if its time is over first.
template <class Result>
Result in_time(const TimeLimit& limit, const std::function<Result()>& work) {
  std::optional<Result> result;
  if (!limit.finishes([&] { result = work(); })) throw LimitError(out_of_time(limit));
  return std::move(*result);
}

/// Sets the texts of proofs by name.
void set_proofs(Json& json, const std::vector<std::pair<std::string, ProvedFiles>>& proofs) {
  json = Json::object();
  for (const auto& [name, files] : proofs) json[name] = files_json(files);
}

Work decide_asked(const Given& given) {
  SearchOptions options = given.search();
  options.engine = engine_for(given.grasp, given.as<std::string>("engine"));
  const bool warns = given.as<bool>("warnings");
  // Warnings need an exact equilibrium.
  if (warns && options.engine == Engine::kAuto) options.engine = Engine::kBranchAndBound;
  return [&given, options, warns, limit = given.time()] {
    Warnings warnings;
    const auto warn = [&](const Answer& answer) {
      if (warns) warnings = model_warnings(answer);
    };
    const Answer found = decide_in_time(given.about(), options, limit, warn);
    return decision_json(found, warnings);
  };
}

/// Decides a box. Irrational lengths or a bound on motions are enough to make one.
Work box_asked(const Given& given) {
  const Question asked = given.about();
  const GraspBox box = asked.grasp.as_box();
  if (box.is_point() && !box.is_bounded() && !needs_enclosure(box)) refuse_certain();
  const auto count = given.as<std::size_t>("samples");
  Samples samples{given.as<std::uint64_t>("seed")};
  if (count != 0 && box.is_point()) refuse_certain();
  return [asked, box, count, samples, options = given.search(),
          limit = given.time()]() mutable {
    BoxDecision found{out_of_time(limit)};
    limit.finishes([&] { found = decide_box(box, asked.law, options); });
    const bool draws = count != 0 && !is_stable(found.verdict);
    if (draws) {
      limit.finishes([&] { decide_samples(asked, count, options, samples); });
      add_samples(found.verdict, samples);
    }
    Json json{{"verdict", name_of(found.verdict)},
              {"engine", box_engine(asked)},
              {"normal_law", to_string(asked.law)},
              {"wrench", wrench_json(box.middle().wrench)}};
    if (draws) {
      json["samples"] = samples_json(samples);
      json["samples"]["failures"] = Json::array();
      for (const auto& [number, files] : samples.failures) {
        json["samples"]["failures"].push_back(files_json(files));
      }
    }
    const auto proofs = proved_decision(box, asked.law, found, producer_of(box_engine(asked)));
    if (proofs.size() == 1) json["proof"] = files_json(proofs[0]);
    if (proofs.size() == 2) {
      json["examples"] = Json::array({files_json(proofs[0]), files_json(proofs[1])});
    }
    if (const auto* undecided = std::get_if<Undecided>(&found.verdict)) {
      add_undecided(json, *undecided);
    }
    json["stats"] = work_json(found.work);
    return json;
  };
}

const char* const kPartOfRadius =
    "it is a part of the radius: give more than 0 and less than 1";

Work radius_asked(const Given& given) {
  RadiusOptions options;
  options.box = given.search();
  options.accuracy = given.positive("accuracy", kPartOfRadius, true);
  const Question asked = given.about();
  if (asked.grasp.as_box().is_point()) refuse_certain();
  return [asked, options, limit = given.time()] {
    const GraspBox box = asked.grasp.as_box();
    Radius found;
    const auto end = ended_by(limit, [&] {
      found = find_radius(box.middle(), box, asked.law, options,
                          [&](const Radius& so_far) { found = so_far; });
    });
    Json json = with_end(radius_json(asked, found), end);
    json.erase("counterexample");
    if (!found.stable) return json;
    const auto proofs =
        proved_radius(box.middle(), box, asked.law, found, producer_of(box_engine(asked)));
    json["proof"] = files_json(proofs[0]);
    if (found.refuted) json["counterexample"] = files_json(proofs[1]);
    return json;
  };
}

Work quality_asked_of(const Given& given) {
  QualityOptions options;
  options.radius.box = given.search();
  options.radius.accuracy = given.positive("accuracy", kPartOfRadius, true);
  if (!given["at_most"].is_none()) {
    options.at_most = given.positive("at_most", "give a number above 0");
  }
  return [asked = given.about(), shape = given.ball(), options, limit = given.time()] {
    Quality found;
    const auto end = ended_by(limit, [&] {
      found = find_quality(asked.grasp.as_box(), asked.law, shape, options,
                           [&](const Quality& so_far) { found = so_far; });
    });
    Json json = with_end(quality_json(asked, found), end);
    if (found.stable) set_proofs(json["proofs"], proved_quality(asked, found));
    return json;
  };
}

/// Finds the best preloads; with a budget, those under the first load alone.
Work preload_asked(const Given& given) {
  PreloadOptions options;
  options.box = given.search();
  options.most_boxes = given.as<std::size_t>("boxes");
  options.balanced = given.as<bool>("balanced");
  options.accuracy = given.positive(
      "accuracy", "it is a part of the sum or the radius: give more than 0 and less than 1",
      true);
  std::vector<Question> asked;
  QuestionOptions with_load = given.asked();
  for (const py::handle load : given["loads"]) {
    with_load.wrench.reset();
    if (!load.is_none()) {
      with_load.wrench = numbers(py::reinterpret_borrow<py::object>(load), 0, "wrench");
    }
    asked.push_back(question_about(given.grasp, with_load));
  }
  const std::vector<GraspBox> of_loads = loads_of(asked, "");
  options.alike = alike_from(given.as<std::string>("equal"), of_loads.front());
  if (given["budget"].is_none()) {
    return [asked, options, limit = given.time()] {
      const NormalLaw law = asked.front().law;
      LeastPreload found;
      const auto end = ended_by(limit, [&] {
        found = find_least_preload(loads_of(asked, ""), law, options,
                                   [&](const LeastPreload& so_far) { found = so_far; });
      });
      Json json = with_end(preload_json(asked, found, options.alike), end);
      set_proofs(json["proofs"], proved_preload(law, found));
      return json;
    };
  }
  const Rational budget =
      given.positive("budget", "it is the sum of preloads: give a number above 0");
  return [one = asked.front(), options, budget, shape = given.ball(), limit = given.time()] {
    BallPreload found;
    const auto end = ended_by(limit, [&] {
      found = find_ball_preload(loads_of({one}, "").front(), one.law, shape, budget, options,
                                [&](const BallPreload& so_far) { found = so_far; });
    });
    Json json = with_end(preload_json(one, budget, found, options.alike), end);
    set_proofs(json["proofs"], proved_preload(one, found));
    return json;
  };
}

Work map_asked(const Given& given) {
  MapOptions options;
  options.depth = given.as<unsigned>("depth");
  options.box = given.search();
  QuestionOptions certain = given.asked();
  options.uncertain = certain.uncertain;
  certain.uncertain = {};
  const Question asked = question_about(given.grasp, certain);
  const GraspBox centre = asked.grasp.as_box();
  const MapAxis x = parse_axis(centre, given.as<std::string>("x"), "x");
  const MapAxis y = parse_axis(centre, given.as<std::string>("y"), "y");
  return [=, with_proofs = given.as<bool>("proofs"), limit = given.time()] {
    std::vector<MapCell> cells;
    std::vector<Json> proofs;
    const auto take = [&](MapCell cell) {
      const bool decided = !std::holds_alternative<Undecided>(cell.decision.verdict);
      proofs.emplace_back();
      if (with_proofs && decided) {
        const GraspBox box = box_of_cell(centre, x, y, cell.x, cell.y, options.uncertain);
        proofs.back() = files_json(
            proved_box(box, asked.law, cell.decision, producer_of(box_engine(asked))));
      }
      cells.push_back(std::move(cell));
    };
    const auto end =
        ended_by(limit, [&] { map_verdicts(centre, asked.law, x, y, options, take); });
    Json json = with_end(map_json(asked, x, y, cells), end);
    json["wrench"] = wrench_json(centre.wrench);
    json["proofs"] = proofs;
    json["picture"] = plot_map(asked.description().name, x, y, cells);
    return json;
  };
}

Work states_asked(const Given& given) {
  const auto name = given.as<std::string>("engine");
  const Enumerator engine = name == "cgal"    ? Enumerator::kCgal
                            : name == "sweep" ? Enumerator::kSweep
                            : name == "paper" ? Enumerator::kPaper
                                              : Enumerator::kAuto;
  return [&given, engine, list = given.as<bool>("list"),
          threads = given.as<unsigned>("threads"), limit = given.time()] {
    return states_json(in_time<Enumeration>(limit,
                                            [&] {
                                              return enumerate_slip_states(
                                                  stick_planes(given.grasp.loaded().grasp),
                                                  engine, list, threads);
                                            }),
                       list);
  };
}

/// Adds what Python knows of a margin besides.
Json with_certificate(Json json, const Question& question, std::string certificate) {
  json["certificate"] = std::move(certificate);
  if (question.preload) json["preload"] = number_json(*question.preload);
  return json;
}

Work margin_by_claims(const Given& given, const Question& question, bool warns) {
  SpatialMarginOptions options;
  options.search = given.search();
  options.accuracy = given.positive("accuracy", "give a number above 0, such as 1/1000");
  return [question, options, warns, limit = given.time()] {
    const auto json_of = [](const Question& asked, const SpatialMargin& margin,
                            const Warnings& warnings) {
      return with_certificate(
          margin_json(asked, margin, warnings), asked,
          margin_certificate_text(asked, margin, producer_of(box_engine(asked))));
    };
    SpatialMargin found;
    std::optional<SecondMargin> second;
    Warnings warnings;
    const auto end = ended_by(limit, [&] {
      found = find_spatial_margin(question, options, [&](const SpatialMargin& so_far) {
        if (limit.seconds()) found = so_far;
      });
      second = margin_within(question, found, options);
      if (warns) warnings = model_warnings(question, found);
    });
    Json json = with_end(json_of(question, found, warnings), end);
    if (second) json["within"] = json_of(second->question, second->margin, {});
    return json;
  };
}

Work margin_asked(const Given& given) {
  const Question question = given.about();
  const bool warns = given.as<bool>("warnings");
  if (question.has_claims()) return margin_by_claims(given, question, warns);
  return [question, warns, options = given.search(), limit = given.time()] {
    MarginWork work;
    using Found = std::variant<Margin, Undecided>;
    const auto found = in_time<Found>(
        limit, [&] { return find_margin(problem_of(question), options, &work); });
    if (const auto* undecided = std::get_if<Undecided>(&found)) throw LimitError(*undecided);
    const auto& margin = std::get<Margin>(found);
    Warnings traps;
    if (warns) limit.finishes([&] { traps = model_warnings(question, margin); });
    return with_certificate(margin_json(question, margin, work, traps), question,
                            margin_certificate_text(question, margin, kProducer));
  };
}

Work region_asked(const Given& given) {
  QuestionOptions any_load = given.asked();
  any_load.wrench = RationalRow(3);  // the plane stands for all loads of the grasp
  const auto wrench = [&given](const char* name) {
    return exact_wrench(given.as<py::list>(name), name);
  };
  const WrenchPlane plane(wrench("origin"), wrench("u"), wrench("v"));
  RegionOptions options;
  options.modes.pieces = given.as<bool>("pieces");
  options.modes.mode_limit = given.as<std::size_t>("mode_limit");
  options.proof.node_limit = given.as<std::size_t>("node_limit");
  return [&given, any_load, plane, options, proves = given.as<bool>("certificate"),
          draws = given.as<bool>("picture"), limit = given.time()] {
    const auto found = in_time<RegionAnswer>(limit, [&] {
      return region_answer(question_of(given.grasp, any_load), plane, options);
    });
    if (found.undecided) throw LimitError(*found.undecided);
    Json json = to_json(found);
    if (proves) {
      const auto proved = in_time<std::variant<std::string, Undecided>>(
          limit, [&] { return certificate_of(found, options); });
      if (const auto* undecided = std::get_if<Undecided>(&proved)) throw LimitError(*undecided);
      json["certificate"] = std::get<std::string>(proved);
    }
    if (draws) json["picture"] = plot_region(found.question, plane, found.found.region);
    return json;
  };
}

Work compare_asked(const Given& given) {
  const bool space = given.grasp.content.in_space();
  CompareOptions options;
  options.methods = given.as<std::vector<std::string>>("methods");
  options.length = given.length("a characteristic length must be above 0");
  options.most_forces = numbers(given["max_force"], 1, "max_force");
  for (const Rational& f : options.most_forces) {
    if (f.sign() > 0) continue;
    throw InputError("", "max_force", "there is the value " + to_string(f),
                     "a largest force must be above 0");
  }
  options.accuracy = given.positive("accuracy", "give a number above 0, such as 1/100");
  options.edges = given.as<std::size_t>("edges");
  options.time = given.time();
  options.inertia = given["inertia"].is_none() ? Inertia::of_length(options.length, space)
                                               : given.inertia(space);
  return [&given, options, space, proves = given.as<bool>("certificate")]() mutable {
    NumberText readable(false);
    const Question question = space ? given.about() : question_of(given.grasp, given.asked());
    std::optional<RigidVerdict> verdict;
    const Question of_all = without_bound(question);  // classes are about all motions
    const std::optional<RobustnessKind> kind = options.only_robustness();
    Robustness robustness;
    if (proves && kind) {
      robustness = in_time<Robustness>(
          options.time, [&] { return robustness_to_prove(question, *kind, options); });
      options.robustness = &robustness;
    }
    if (proves && !kind) {
      verdict = out_of_time(options.time);
      options.time.finishes([&] { verdict = rigid_verdict(of_all, options.inertia); });
    }
    options.verdict = verdict ? &*verdict : nullptr;
    const Comparison found = compare_methods(question, options, readable);
    Json json = comparison_json(question, options.length, options.inertia, found);
    for (std::size_t i = 0; i < found.methods.size(); ++i) {
      // The numbers of evidence are strings, as the command prints them.
      json["methods"][i]["evidence"] = finished(found.methods[i].evidence, false).dump();
    }
    if (proves && kind) {
      json["certificate"] = robustness_certificate_text(
          question, *kind, options.for_robustness(), robustness, kProducer);
    }
    if (!verdict) return json;
    if (const auto* undecided = std::get_if<Undecided>(&*verdict)) throw LimitError(*undecided);
    json["certificate"] = class_certificate_text(of_all, options.inertia, *verdict, kProducer);
    return json;
  };
}

Work classes_asked(const Given& given) {
  return [question = given.rigid(), mass = given.inertia()] {
    const auto found = class_margin(problem_of(question), mass);
    if (const auto* undecided = std::get_if<Undecided>(&found)) throw LimitError(*undecided);
    return classes_json(question, mass, std::get<std::vector<ClassRange>>(found));
  };
}

Work factors_asked(const Given& given) {
  return [question = given.rigid(), mass = given.inertia(),
          part = given.positive("accuracy", "give a number above 0, such as 1/1000")] {
    return classes_json(question, mass, friction_margin(problem_of(question), mass, part));
  };
}

Work statics_asked(const Given& given) {
  StaticsQuestion asked{given.about_statics()};
  asked.asked.friction_factor = exact(given["friction_factor"], "friction_factor");
  asked.least_friction = given.as<bool>("least_friction");
  for (const py::handle direction : given["directions"]) {
    const std::string place =
        "directions[" + std::to_string(asked.asked.directions.size()) + "]";
    asked.asked.directions.push_back(
        numbers(py::reinterpret_borrow<py::list>(direction), 0, place));
  }
  if (!given["place"].is_none()) {
    auto [load, ways] = loads_of_places(asked.question, numbers(given["place"], 0, "place"),
                                        given.as<std::string>("body"));
    add_load(asked.question, load);
    asked.asked.directions = std::move(ways);
  }
  if (!given["accuracy"].is_none()) {
    asked.accuracy = given.positive("accuracy", "give a number above 0, such as 1/1000");
  } else if (!asked.least_friction) {
    asked.accuracy = Rational(1, 1000);
  }
  return [asked, proves = given.as<bool>("certificate"), limit = given.time()] {
    StaticsAnswer answer{asked, LoadClass(out_of_time(limit))};
    limit.finishes([&] { answer = statics(asked); });
    Json json = to_json(answer);
    if (!proves) return json;
    Json& certificates = json["certificates"] = Json::object();
    for (const StaticsCertificate& certificate : certificates_of(answer)) {
      certificates[certificate.name] = certificate.text;
    }
    return json;
  };
}

/// Returns the square of a residual; or two numbers between which it lies, if it is irrational.
Json square_json(const RootSum& residual) {
  if (const auto square = residual.rational_square()) return number_json(*square);
  // The numbers are closer than doubles can tell.
  const Rational close = 1 + Rational(1, Integer(1) << 60U);
  for (unsigned bits = 64;; bits *= 2) {
    const auto [low, high] = residual.between(bits);
    if (low.sign() <= 0 || high > close * low) continue;
    return Json::array({number_json(Rational(low * low)), number_json(Rational(high * high))});
  }
}

RationalRow claimed_row(const py::handle& values, const std::string& place,
                        const std::string& separator) {
  RationalRow row;
  for (const py::handle value : values) {
    row.push_back(exact(value, place + separator + std::to_string(row.size()) + "]"));
  }
  return row;
}

Work crosscheck_asked(const Given& given) {
  Claim claim;
  claim.stable = given.as<std::string>("verdict") == "stable";
  if (!given["twist"].is_none()) claim.twist = claimed_row(given["twist"], "twist", "[");
  if (!given["forces"].is_none()) {
    claim.forces.emplace();
    for (const py::handle force : given["forces"]) {
      const std::string place = "forces[" + std::to_string(claim.forces->size());
      claim.forces->push_back(claimed_row(force, place, ", "));
    }
  }
  const auto not_negative = [&given](const char* name) {
    Rational number = exact(given[name], name);
    if (number.sign() >= 0) return number;
    throw InputError("", name, "the value is " + to_string(number), "it must be 0 or more");
  };
  ClaimOptions options;
  options.tie_distance = not_negative("tie");
  options.residual_tolerance = not_negative("tolerance");
  options.node_limit = given.as<std::size_t>("node_limit");
  options.all_distances = given.as<bool>("distances");
  return [question = given.about(), claim, options] {
    const ClaimReport report = judge_claim(question, claim, options);
    Json json = claim_json(question, claim, report);
    json["decision"] = decision_json(report.answer);
    const ClaimResiduals& r = report.residuals;
    Json& residuals = json["residuals"];
    for (const auto& [name, residual] : {std::pair{"cone", &r.cone},
                                         {"normal_law", &r.normal_law},
                                         {"dissipation", &r.dissipation}}) {
      if (*residual) residuals[name]["value"] = square_json((*residual)->value);
    }
    return json;
  };
}

/// Draws a verdict. `limit` is that of an answer that is known to be undecided; then nothing is
/// decided again.
Work picture_asked(const Given& given) {
  SearchOptions options = to_draw();
  if (const auto engine = given.as<std::string>("engine"); engine != "auto") {
    options.engine = engine_named(engine);
  }
  return [&given, options, limit = given.as<std::optional<std::string>>("limit")] {
    const Question question = given.about();
    return Json(
        plot_grasp(question, limit ? Undecided{*limit} : decide(question, options).verdict));
  };
}

Work states_picture_asked(const Given& given) {
  return [&given, set = state_set_named(given.as<std::string>("modes"))] {
    return Json(plot_states(contacts_alone(given.grasp).grasp, set));
  };
}

Work smtlib_asked(const Given& given) {
  return [&given] { return Json(smtlib_text(given.about())); };
}

/// Returns a page, from words of a command line; a time limit of 0 is none.
Work page_asked(const Given& given) {
  QuestionText asked;
  asked.wrench = given.as<std::string>("load");
  asked.case_name = given.as<std::string>("case");
  asked.preload = given.as<std::string>("preloads");
  if (given.asked().law == NormalLaw::kBilateral) asked.normal_law = "bilateral";
  asked.uncertain = given.as<std::string>("tolerances");
  PageLimits limits;
  limits.node_limit = given.as<std::size_t>("node_limit");
  limits.time = std::chrono::milliseconds(
      static_cast<std::int64_t>(1000 * given.as<double>("time_limit")));
  return [&given, asked, limits] {
    try {
      return Json(
          page_html(page_answer(given.grasp, asked, all_page_parts(), limits, "grasp")));
    } catch (const InputError& error) {
      // The place is spelled in the words of a command line.
      const std::string& place = error.place();
      if (place.rfind("--", 0) != 0) throw;
      throw InputError(error.file(), place.substr(2), error.problem(), error.remedy());
    }
  };
}

/// Answers a question as the command does with --json, with exact numbers as Fractions; proofs,
/// pictures and pages are texts.
py::object ask_by_name(const GraspFile& grasp, const std::string& question,
                       const py::dict& options) {
  static const std::map<std::string, Work (*)(const Given&)> questions{
      {"decide", decide_asked},   {"decide_box", box_asked},
      {"radius", radius_asked},   {"quality", quality_asked_of},
      {"preload", preload_asked}, {"map", map_asked},
      {"states", states_asked},   {"margin", margin_asked},
      {"region", region_asked},   {"compare", compare_asked},
      {"classes", classes_asked}, {"factors", factors_asked},
      {"statics", statics_asked}, {"crosscheck", crosscheck_asked},
      {"picture", picture_asked}, {"states picture", states_picture_asked},
      {"smtlib", smtlib_asked},   {"page", page_asked}};
  const Given given(grasp, options);
  return python_of(without_gil(questions.at(question)(given)));
}

}  // namespace

void bind_ask(py::module_& module) {
  module.def("ask", &ask_by_name);
}

}  // namespace stickslip::python
