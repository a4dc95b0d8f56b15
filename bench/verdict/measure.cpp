// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "check.hpp"
#include "limited.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/engine/decide.hpp"

namespace stickslip::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostRepetitions = 20;

/// Milliseconds of the fastest of a few calls.
template <class Work>
double fastest_ms(double patience_ms, Work work) {
  double best = 0;
  double total = 0;
  for (int k = 0; k < kMostRepetitions && (k == 0 || total < patience_ms); ++k) {
    const Clock::time_point start = Clock::now();
    work();
    const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    total += ms;
    best = k == 0 ? ms : std::min(best, ms);
  }
  return best;
}

bool checks(const Question& question, const std::string& grasp, const std::string& proof,
            const std::string& verdict) {
  std::istringstream grasp_in(grasp);
  std::istringstream proof_in(proof);
  stickslip_check::Options options;
  options.bilateral = question.law == NormalLaw::kBilateral;
  const auto answer = stickslip_check::check(grasp_in, proof_in, options);
  const auto* accepted = std::get_if<stickslip_check::Accepted>(&answer);
  return accepted != nullptr && accepted->verdict == verdict;
}

std::string to_json(const Measurement& m) {
  nlohmann::json json{{"verdict", m.verdict},
                      {"read_ms", m.read_ms},
                      {"decide_ms", m.decide_ms},
                      {"certificate_ms", m.certificate_ms},
                      {"file_ms", m.file_ms},
                      {"check_ms", m.check_ms},
                      {"certificate_bytes", m.certificate_bytes},
                      {"is_accepted", m.is_accepted},
                      {"is_reproducible", m.is_reproducible},
                      {"counters", m.counters}};
  return json.dump();
}

Measurement from_json(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  Measurement m;
  json.at("verdict").get_to(m.verdict);
  json.at("read_ms").get_to(m.read_ms);
  json.at("decide_ms").get_to(m.decide_ms);
  json.at("certificate_ms").get_to(m.certificate_ms);
  json.at("file_ms").get_to(m.file_ms);
  json.at("check_ms").get_to(m.check_ms);
  json.at("certificate_bytes").get_to(m.certificate_bytes);
  json.at("is_accepted").get_to(m.is_accepted);
  json.at("is_reproducible").get_to(m.is_reproducible);
  json.at("counters").get_to(m.counters);
  return m;
}

}  // namespace

double Measurement::counter(const std::string& name) const {
  for (const auto& [key, value] : counters) {
    if (key == name) return value;
  }
  return 0;
}

namespace {

/// Returns what `stickslip decide` finds first.
Answer judged(const Question& question) {
  SearchOptions options;
  options.second = false;
  return decide(question, options);
}

}  // namespace

Measurement measure(const Question& question, double patience_ms) {
  Measurement result;
  Answer first;
  result.decide_ms = fastest_ms(patience_ms, [&] { first = judged(question); });
  result.verdict = name_of(first.verdict);
  for (const auto& [name, value] : counters(first)) {
    result.counters.emplace_back(name, static_cast<double>(value));
  }
  std::string proof;
  result.certificate_ms =
      fastest_ms(patience_ms, [&] { proof = certificate_of(first).value(); });
  result.certificate_bytes = static_cast<double>(proof.size());

  const auto directory = std::filesystem::temp_directory_path();
  const auto file = directory / ("verdict_bench_" +
                                 std::to_string(std::hash<std::string>{}(proof)) + ".json");
  result.file_ms = fastest_ms(0, [&] {
    std::ofstream out(file, std::ios::binary);
    out << proof;
  });
  std::filesystem::remove(file);

  const std::string grasp = write_grasp(question.loaded());
  result.read_ms = fastest_ms(patience_ms, [&] { parse_grasp(grasp, "grasp"); });
  result.check_ms = fastest_ms(patience_ms, [&] {
    result.is_accepted = checks(question, grasp, proof, result.verdict);
  });

  const Answer second = judged(question);
  result.is_reproducible =
      counters(second) == counters(first) && certificate_of(second) == proof;
  return result;
}

std::optional<Measurement> measure_limited(double seconds, double patience_ms,
                                           const std::function<Instance()>& make) {
  const auto text =
      run_limited(seconds, [&] { return to_json(measure(make().question, patience_ms)); });
  if (!text) return std::nullopt;
  return from_json(*text);
}

bool is_stable_by_cones(const Question& question) {
  return std::holds_alternative<Stable>(
      branch_and_bound(Problem(question.loaded(), question.law)));
}

}  // namespace stickslip::bench
