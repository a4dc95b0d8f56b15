// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "measure.hpp"
#include "report.hpp"
#include "statistics.hpp"
#include "stickslip/core/grasp_file.hpp"

namespace stickslip::bench {
namespace {

struct Row {
  std::size_t contacts;
  bool stable;
  std::size_t count;
  double limit_seconds;
  double patience_ms;
};

struct Result {
  std::size_t index;
  std::string family;
  std::optional<Measurement> measured;
};

Instance make_instance(const Row& row, std::size_t k) {
  if (row.stable) {
    return make_stable(k % kStableFamilies, row.contacts, 1 + k / kStableFamilies);
  }
  return make_unstable(k % kUnstableFamilies, row.contacts, 1 + k / kUnstableFamilies,
                       is_stable_by_cones);
}

/// Its name says what bench/verdict/checkers.py has to know: 100_stable_3_unilateral.json.
void save(const std::string& folder, const Row& row, std::size_t k, const Question& question) {
  const std::string name = std::to_string(row.contacts) +
                           (row.stable ? "_stable_" : "_unstable_") + std::to_string(k) + "_" +
                           to_string(question.law) + ".json";
  std::ofstream out(std::filesystem::path(folder) / name, std::ios::binary);
  out << write_grasp(question.loaded());
  if (!out.flush()) throw std::runtime_error("cannot write " + name + " in " + folder);
}

/// Every family's name, from its smallest member.
std::string family_of(bool stable, std::size_t k) {
  Row smallest{4, stable, 1, 0, 0};
  return make_instance(smallest, k).family;
}

template <class Value>
double median_of(const std::vector<Result>& results, Value value) {
  std::vector<double> values;
  for (const Result& r : results) {
    values.push_back(r.measured ? value(*r.measured) : beyond_limit());
  }
  return median(std::move(values));
}

/// The ratio of sums would be that of the slowest instance; this is the typical one.
template <class Over, class Under>
double median_ratio(const std::vector<Result>& results, Over over, Under under) {
  std::vector<double> values;
  for (const Result& r : results) {
    if (r.measured) values.push_back(over(*r.measured) / under(*r.measured));
  }
  return values.empty() ? std::nan("") : median(std::move(values));
}

double largest_counter(const std::vector<Result>& results, const char* name) {
  double largest = 0;
  for (const Result& r : results) {
    if (r.measured) largest = std::max(largest, r.measured->counter(name));
  }
  return largest;
}

void judge(Report& report, const Row& row, const Result& result) {
  if (!result.measured) return;
  const Measurement& m = *result.measured;
  const std::string expected = row.stable ? "stable" : "unstable";
  const auto fail = [&](const std::string& what) {
    ++report.failures;
    std::printf("FAILED: m = %zu, %s (%zu): %s\n", row.contacts, result.family.c_str(),
                result.index, what.c_str());
  };
  if (m.verdict != expected) fail(m.verdict + " where " + expected + " is right");
  if (!m.is_accepted) fail("the checker does not accept the certificate");
  if (!m.is_reproducible) fail("two runs differ");
}

void print_instance(const Row& row, const Result& r) {
  if (!r.measured) {
    std::printf("    %-42s > %.0f s\n", r.family.c_str(), row.limit_seconds);
    return;
  }
  const Measurement& m = *r.measured;
  std::printf(
      "    %-42s %9.2f ms, check %9.2f, nodes %6.0f, leaves %6.0f, misses %4.0f, exact "
      "%3.0f, witness %3.0f, bits %2.0f\n",
      r.family.c_str(), m.total_ms(), m.check_ms, m.counter("nodes"), m.counter("leaves"),
      m.counter("filter_misses"), m.counter("exact_programs"), m.counter("witness_attempts"),
      m.counter("largest_twist_bits"));
}

void print_row(const Row& row, const std::vector<Result>& results) {
  std::size_t done = 0;
  const Result* slowest = nullptr;
  for (const Result& r : results) {
    if (r.measured) ++done;
    if (slowest == nullptr || !r.measured ||
        (slowest->measured && r.measured->total_ms() > slowest->measured->total_ms())) {
      slowest = &r;
    }
  }
  const double limit = row.limit_seconds * 1e3;
  const auto counter = [&](const char* name) {
    return median_of(results, [name](const Measurement& m) { return m.counter(name); });
  };
  const auto total = [](const Measurement& m) { return m.total_ms(); };
  const auto from_file = [](const Measurement& m) { return m.from_file_ms(); };
  std::printf(
      "| %zu | %s | %zu/%zu | %s | %s | %s | %.2f | %s | %.0f | %.0f | %.0f | %.0f | "
      "%.0f | %.0f | %.0f | %.0f | %.1f |\n",
      row.contacts, row.stable ? "stable" : "unstable", done, results.size(),
      show_ms(median_of(results, total), limit).c_str(),
      show_ms(median_of(results, [](const Measurement& m) { return m.read_ms; }), limit)
          .c_str(),
      show_ms(median_of(results, [](const Measurement& m) { return m.check_ms; }), limit)
          .c_str(),
      median_ratio(
          results, [](const Measurement& m) { return m.check_ms; }, from_file),
      show_ms(slowest->measured ? slowest->measured->total_ms() : beyond_limit(), limit)
          .c_str(),
      counter("nodes"), counter("leaves"), counter("searches"), counter("support_points"),
      counter("filter_hits"), largest_counter(results, "filter_misses"),
      largest_counter(results, "exact_programs"),
      largest_counter(results, "largest_twist_bits"),
      median_of(results, [](const Measurement& m) { return m.certificate_bytes; }) / 1024);
  std::printf("<!-- slowest: %s -->\n", slowest->family.c_str());
  std::fflush(stdout);
}

nlohmann::json to_json(const Row& row, const Result& r) {
  nlohmann::json json{{"contacts", row.contacts},
                      {"expected", row.stable ? "stable" : "unstable"},
                      {"family", r.family},
                      {"seed", 1 + r.index / 10}};
  if (!r.measured) {
    json["beyond_seconds"] = row.limit_seconds;
    return json;
  }
  const Measurement& m = *r.measured;
  json["read_ms"] = m.read_ms;
  json["decide_ms"] = m.decide_ms;
  json["certificate_ms"] = m.certificate_ms;
  json["file_ms"] = m.file_ms;
  json["check_ms"] = m.check_ms;
  json["certificate_bytes"] = m.certificate_bytes;
  for (const auto& [name, value] : m.counters) json["work"][name] = value;
  return json;
}

std::vector<Row> rows_of(const Report& report) {
  if (report.quick) return {{4, false, 10, 60, 0}, {10, false, 10, 60, 0}};
  return {{10, false, 20, 20, 10},     {100, false, 20, 20, 40},
          {1000, false, 20, 20, 0},    {10000, false, 12, 120, 0},
          {100000, false, 12, 600, 0}, {1000000, false, 4, 3600, 0}};
}

}  // namespace

void report_targets(Report& report) {
  std::printf(
      "| m | verdict | ended | decide + certificate, ms | read, ms | check, ms | check / (read "
      "+ decide + certificate) | slowest, ms | nodes | leaves | searches | support points | "
      "filter hits | "
      "misses, max | exact LPs, max | twist bits, max | certificate, KiB |\n"
      "|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  std::vector<std::pair<double, double>> medians;
  std::vector<std::pair<double, double>> means;
  for (Row row : rows_of(report)) {
    if (row.contacts > report.max_contacts || row.contacts < report.min_contacts) continue;
    for (const bool stable : {false, true}) {
      row.stable = stable;
      std::vector<Result> results;
      for (std::size_t k = 0; k < row.count; ++k) {
        results.push_back(
            {k, family_of(stable, k), measure_limited(row.limit_seconds, row.patience_ms, [&] {
               Instance made = make_instance(row, k);
               if (!report.folder.empty()) {
                 save(report.folder, row, k, made.question);
               }
               return made;
             })});
        judge(report, row, results.back());
        if (report.verbose) print_instance(row, results.back());
        report.json["targets"].push_back(to_json(row, results.back()));
        if (report.quick && !results.back().measured) ++report.failures;
      }
      print_row(row, results);
      if (stable || row.contacts > 1000) continue;
      const double m = static_cast<double>(row.contacts);
      const auto leaves = [](const Measurement& r) { return r.counter("leaves"); };
      medians.emplace_back(m, median_of(results, leaves));
      double sum = 0;
      double ended = 0;
      for (const Result& r : results) {
        if (!r.measured) continue;
        sum += leaves(*r.measured);
        ++ended;
      }
      means.emplace_back(m, ended > 0 ? sum / ended : 0);
    }
  }
  std::printf("\nLeaves of unstable verdicts grow as m^%.2f (medians), m^%.2f (means).\n\n",
              log_log_slope(medians), log_log_slope(means));
  report.json["leaves_exponent"] = log_log_slope(medians);
}

}  // namespace stickslip::bench
