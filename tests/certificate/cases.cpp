// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "paper_grasps.hpp"
#include "random_grasps.hpp"
#include "stickslip/certificate/certificate.hpp"

namespace stickslip::test {
namespace {

constexpr NormalLaw kLaws[] = {NormalLaw::kUnilateral, NormalLaw::kBilateral};

Case make_case(std::string name, const Grasp& grasp, const Wrench& wrench,
               NormalLaw law = NormalLaw::kUnilateral) {
  Case result{std::move(name) + " " + to_string(law), write_grasp({grasp, wrench}), {}};
  result.options.law = law;
  return result;
}

void add_paper_cases(std::vector<Case>& cases) {
  for (const NormalLaw law : kLaws) {
    for (const int preload : {0, 1}) {
      const std::string p = " P=" + std::to_string(preload);
      for (const char* y : {"1", "11/10", "-1"}) {
        cases.push_back(make_case("fig1" + p + " y=" + y, fig1_grasp(preload),
                                  {0, parse_rational(y), 0}, law));
      }
      for (const char* y : {"2", "21/10", "-2"}) {
        cases.push_back(make_case("fig4" + p + " y=" + y, fig4_grasp(preload),
                                  {0, parse_rational(y), 0}, law));
      }
      cases.push_back(make_case("fig4" + p + " turn", fig4_grasp(preload), {0, 0, 3}, law));
      cases.push_back(make_case("fig4" + p + " rest", fig4_grasp(preload), {}, law));
    }
  }
  // The file's wrench and preloads replaced by whoever asks.
  Case replaced = make_case("fig1 replaced", fig1_grasp(0), {});
  replaced.options.wrench = RationalRow{0, 1, 0};
  replaced.options.preload = 1;
  cases.push_back(replaced);
  replaced.options.wrench = RationalRow{0, parse_rational("1.000000000001"), 0};
  replaced.name += " beyond";
  cases.push_back(replaced);
}

void add_odd_cases(std::vector<Case>& cases) {
  const Rational half(1, 2);
  for (const NormalLaw law : kLaws) {
    cases.push_back(make_case("no contact, no load", Grasp(), {}, law));
    cases.push_back(make_case("no contact", Grasp(), {1, 0, 0}, law));
    cases.push_back(make_case("normals of length 5",
                              Grasp({{{-1, 0}, {3, 4}, half, 2, 3},
                                     {{1, 0}, {-3, 4}, half, 1, 2},
                                     {{0, 2}, {0, -5}, half, 1, 1}}),
                              {half, half, 0}, law));
    for (const int load : {-1, 1}) {
      cases.push_back(make_case(
          "normals of length sqrt 2 and sqrt 5",
          Grasp({{{-1, 0}, {1, 1}, half, 1, 0}, {{1, 0}, {-2, 1}, half, Rational(3, 7), 0}}),
          {0, load, 0}, law));
    }
    cases.push_back(make_case("two contacts at one point, no friction",
                              Grasp({{{0, -1}, {0, 1}, 0, 1, 0}, {{0, -1}, {0, 1}, 0, 2, 0}}),
                              {0, -1, 0}, law));
    cases.push_back(make_case(
        "all normals parallel",
        Grasp({{{-1, 0}, {0, 1}, half, 1, 1}, {{1, 0}, {0, 1}, half, 1, 1}}), {1, -3, 0}, law));
  }
}

void add_random_cases(std::vector<Case>& cases) {
  RandomSource random(20180626);
  const Rational epsilon(1, 1000000000);
  for (int round = 0; round < 48; ++round) {
    const NormalLaw law = kLaws[round % 2];
    const auto contacts = static_cast<std::size_t>(1 + round / 2 % 4);
    const int family = round % 3;
    const Grasp grasp = family == 0   ? degenerate_grasp(random, contacts)
                        : family == 1 ? generic_grasp(random, contacts)
                                      : near_degenerate_grasp(random, contacts, epsilon);
    const int load = random.between(0, 2);
    const Wrench wrench = load == 0   ? planted_wrench(random, grasp, law)
                          : load == 1 ? threshold_wrench(random, grasp, epsilon)
                                      : small_wrench(random);
    constexpr const char* kFamilies[] = {"degenerate", "generic", "nearly degenerate"};
    cases.push_back(make_case(std::string(kFamilies[family]) + " " + std::to_string(round),
                              grasp, wrench, law));
  }
}

}  // namespace

Question Case::question() const {
  return ask(parse_grasp(grasp, name), options);
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  add_paper_cases(cases);
  add_odd_cases(cases);
  add_random_cases(cases);
  return cases;
}

std::string Certified::name() const {
  return about.name + " by " +
         (engine == Engine::kBranchAndBound ? "branch-and-bound" : "states");
}

std::size_t Certified::size() const {
  // One a line, and five lines around them.
  const auto lines = std::count(text.begin(), text.end(), '\n');
  return static_cast<std::size_t>(lines) - (verdict == "stable" ? 6 : 4);
}

std::vector<Certified> all_certificates() {
  std::vector<Certified> result;
  for (const Case& one : all_cases()) {
    const Question question = one.question();
    const Problem problem(question.loaded(), question.law);
    for (const Engine engine : {Engine::kStates, Engine::kBranchAndBound}) {
      const Verdict verdict = decide(problem, by(engine)).verdict;
      result.push_back(
          {one, engine, name_of(verdict), certificate_text(question, verdict, "tests")});
    }
    const std::size_t n = result.size();
    if (result[n - 1].verdict != result[n - 2].verdict) {
      throw std::runtime_error("the engines disagree about " + one.name);
    }
  }
  return result;
}

std::vector<CommittedCertificate> committed_certificates() {
  const auto read = [](const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::filesystem::path folder = STICKSLIP_CORPUS "/certificates";
  std::vector<CommittedCertificate> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    const std::string name = file.substr(0, file.find('.'));
    if (file != name + ".certificate.json") continue;
    CheckerInput input{read(folder / (name + ".grasp.json")), read(entry.path()), {}};
    if (name.rfind("bilateral_", 0) == 0) input.options.law = NormalLaw::kBilateral;
    const auto json = nlohmann::json::parse(input.certificate);
    if (json["verdict"] == "margin") {
      const auto& asked = json["question"];
      const auto wrench_in = [](const nlohmann::json& numbers) {
        return RationalRow{numbers[0].get<int>(), numbers[1].get<int>(), numbers[2].get<int>()};
      };
      input.options.wrench = wrench_in(asked["wrench"]);
      if (asked.contains("direction")) input.options.direction = wrench_in(asked["direction"]);
      if (asked.contains("preload_direction")) {
        PreloadDirection& growth = input.options.preload_direction.emplace();
        growth.scale = asked["preload_direction"] == "scale";
        if (!growth.scale) {
          for (const auto& rate : asked["preload_direction"]) {
            growth.preloads.emplace_back(rate.get<int>());
          }
        }
      }
    }
    result.push_back({name, std::move(input)});
  }
  std::sort(result.begin(), result.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return result;
}

std::vector<CommittedCertificate> all_margins() {
  std::vector<CommittedCertificate> result;
  for (CommittedCertificate& one : committed_certificates()) {
    const QuestionOptions& options = one.input.options;
    if (options.direction || options.preload_direction) result.push_back(std::move(one));
  }
  return result;
}

}  // namespace stickslip::test
