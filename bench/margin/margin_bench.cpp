// SPDX-License-Identifier: GPL-3.0-or-later
// Load margins of generated grasps with preload: time to find one with its certificate, time to
// check that, and work. Exit code 1 if the checker rejects one.
//
//     margin_bench [largest m, default 100]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <sstream>
#include <vector>

#include "arguments.hpp"
#include "check.hpp"
#include "grasps.hpp"
#include "loads.hpp"
#include "statistics.hpp"
#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::bench {
namespace {

double milliseconds(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from)
      .count();
}

stickslip_check::Rational for_checker(const Rational& value) {
  return stickslip_check::Rational(to_string(value));
}

struct Row {
  double find = 0;   ///< margin and certificate, ms
  double check = 0;  ///< reading included, ms
  MarginWork work;
  std::size_t segments = 0;
  std::size_t proofs = 0;  ///< segments by degree
  std::size_t certificate_bytes = 0;
  bool accepted = false;
};

Row measure(Layout layout, std::size_t contacts, std::uint64_t seed) {
  Question question = plain_question(make_grasp(layout, contacts, true, seed), {});
  const Wrench direction = pulling_load(layout, seed);
  question.direction = row_of(direction);
  Row row;
  const auto start = std::chrono::steady_clock::now();
  const auto result = find_margin(problem_of(question), {}, &row.work);
  const auto& margin = std::get<Margin>(result);
  const std::string certificate = margin_certificate_text(question, margin, "bench");
  row.find = milliseconds(start);
  row.segments = margin.segments.size();
  for (const MarginSegment& segment : margin.segments) row.proofs += segment.proof ? 1 : 0;
  row.certificate_bytes = certificate.size();
  std::istringstream grasp(write_grasp(question.loaded()));
  std::istringstream proof(certificate);
  stickslip_check::Options options;
  options.direction = stickslip_check::Vector{
      for_checker(direction.x), for_checker(direction.y), for_checker(direction.torque)};
  const auto check_start = std::chrono::steady_clock::now();
  const auto answer = stickslip_check::check(grasp, proof, options);
  row.check = milliseconds(check_start);
  row.accepted = std::holds_alternative<stickslip_check::Accepted>(answer);
  return row;
}

template <class Value>
double median_of(const std::vector<Row>& rows, Value value) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(static_cast<double>(value(row)));
  return median(std::move(values));
}

int run(std::size_t largest) {
  std::puts(
      "| family | m | margin + certificate, ms | slowest, ms | check, ms | ranges | mode "
      "programs | nodes | segments | by degree | certificate, KiB |");
  std::puts("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  bool all_accepted = true;
  for (const Layout layout : {Layout::kRound, Layout::kVaried, Layout::kArc, Layout::kEdges,
                              Layout::kGrid, Layout::kJaws}) {
    for (const std::size_t m : {10, 100, 300, 1000, 3000, 10000}) {
      if (m > largest) break;
      std::vector<Row> rows;
      const std::uint64_t seeds = m < 1000 ? 9 : 3;
      for (std::uint64_t s = 1; s <= seeds; ++s) rows.push_back(measure(layout, m, s));
      double slowest = 0;
      for (const Row& row : rows) {
        slowest = std::max(slowest, row.find);
        all_accepted = all_accepted && row.accepted;
      }
      std::printf(
          "| %s | %zu | %.3g | %.3g | %.3g | %.0f | %.0f | %.0f | %.0f | %.0f | %.1f |\n",
          name_of(layout), m, median_of(rows, [](const Row& r) { return r.find; }), slowest,
          median_of(rows, [](const Row& r) { return r.check; }),
          median_of(rows, [](const Row& r) { return r.work.ranges; }),
          median_of(rows, [](const Row& r) { return r.work.modes; }),
          median_of(rows, [](const Row& r) { return r.work.cone.nodes; }),
          median_of(rows, [](const Row& r) { return r.segments; }),
          median_of(rows, [](const Row& r) { return r.proofs; }),
          median_of(rows, [](const Row& r) { return r.certificate_bytes; }) / 1024);
      std::fflush(stdout);
    }
  }
  return all_accepted ? 0 : 1;
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  stickslip::bench::Arguments arguments(
      "margin_bench",
      "Load margins of generated grasps: time to find, time to check, and work.");
  stickslip::Command& app = arguments.described();
  std::size_t largest = 100;
  app.add_option("LARGEST_M", largest, "Contacts: 10, 100, ... up to this")
      ->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  return stickslip::bench::run(largest);
}
