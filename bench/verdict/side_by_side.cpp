// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>

#include "measure.hpp"
#include "others.hpp"
#include "report.hpp"
#include "statistics.hpp"

namespace stickslip::bench {
namespace {

constexpr double kAnswerSeconds = 20;

/// Nobody but branch and bound, and the weaker question, is asked about more contacts.
constexpr std::size_t kMostContactsForOthers = 24;

/// After so many unanswered questions of one size a competitor is asked no more.
constexpr int kPatience = 3;

/// One series of results of one competitor at one size.
struct Column {
  std::vector<double> ms;
  std::vector<double> ratios;
  int unanswered = 0;
};

/// Three unstable and three stable ones, the same for everybody.
std::vector<Instance> questions(std::size_t contacts) {
  std::vector<Instance> result;
  for (const std::size_t family : {0, 3, 5}) {
    result.push_back(make_unstable(family, contacts, 11, is_stable_by_cones));
  }
  for (const std::size_t family : {1, 3, 6}) {
    result.push_back(make_stable(family, contacts, 11));
  }
  return result;
}

std::string show(const Column& column, std::size_t asked) {
  if (column.ms.empty()) return "-";
  std::vector<double> ratios = column.ratios;
  const double ms = median(column.ms);
  const double ratio = median(ratios);
  char text[64];
  if (std::isinf(ms)) {
    std::snprintf(text, sizeof text, "> %.0f (%zu of %zu answered)", kAnswerSeconds * 1e3,
                  column.ms.size() - static_cast<std::size_t>(column.unanswered), asked);
    return text;
  }
  std::snprintf(text, sizeof text, "%s (%.3gx)", show_ms(ms, 0).c_str(), ratio);
  std::string shown = text;
  if (column.unanswered > 0) {
    shown += ", " + std::to_string(column.unanswered) + " of " + std::to_string(asked) +
             " unanswered";
  }
  return shown;
}

}  // namespace

void report_side_by_side(Report& report) {
  const std::vector<Competitor> others = competitors();
  std::printf("| m | `branch-and-bound`, ms |");
  for (const Competitor& other : others) {
    std::printf(" %s%s%s%s |", other.name.c_str(), other.remark.empty() ? "" : " (",
                other.remark.c_str(), other.remark.empty() ? "" : ")");
  }
  std::printf("\n|--:|--:|");
  for (std::size_t k = 0; k < others.size(); ++k) std::printf("--:|");
  std::printf("\n");
  std::vector<bool> is_out(others.size(), false);
  std::vector<std::string> weaker;
  for (const std::size_t contacts : {4, 6, 8, 12, 16, 24, 100, 1000, 10000}) {
    if (contacts > report.max_contacts) continue;
    const std::vector<Instance> instances = questions(contacts);
    std::vector<Column> columns(others.size());
    for (std::size_t k = 0; k < others.size(); ++k) {
      if (others[k].is_same_question && contacts > kMostContactsForOthers) is_out[k] = true;
    }
    std::vector<double> cone;
    int weakly_stable_only = 0;
    for (const Instance& instance : instances) {
      const std::string expected =
          instance.expected == Expected::kStable ? "stable" : "unstable";
      const auto ours =
          measure_limited(kAnswerSeconds, contacts <= 100 ? 5 : 0, [&] { return instance; });
      cone.push_back(ours ? ours->decide_ms : beyond_limit());
      nlohmann::json json{
          {"contacts", contacts}, {"family", instance.family}, {"expected", expected}};
      if (ours) json["ms"]["cone"] = ours->decide_ms;
      for (std::size_t k = 0; k < others.size(); ++k) {
        Column& column = columns[k];
        if (is_out[k] || column.unanswered >= kPatience) continue;
        const OtherAnswer other = others[k].answer(instance.question, kAnswerSeconds);
        if (other.answer.empty()) {
          ++column.unanswered;
          column.ms.push_back(beyond_limit());
          column.ratios.push_back(beyond_limit());
          continue;
        }
        column.ms.push_back(other.ms);
        column.ratios.push_back(other.ms / cone.back());
        json["ms"][others[k].name] = other.ms;
        json["answers"][others[k].name] = other.answer;
        if (other.answer == expected) continue;
        if (others[k].is_same_question) {
          ++report.failures;
          std::printf("FAILED: m = %zu, %s: %s says %s\n", contacts, instance.family.c_str(),
                      others[k].name.c_str(), other.answer.c_str());
        } else if (expected == "unstable") {
          ++weakly_stable_only;
        } else {
          weaker.push_back("m = " + std::to_string(contacts) + ", " + instance.family);
        }
      }
      report.json["side_by_side"].push_back(std::move(json));
    }
    std::printf("| %zu | %s |", contacts, show_ms(median(cone), kAnswerSeconds * 1e3).c_str());
    for (std::size_t k = 0; k < others.size(); ++k) {
      std::printf(" %s |", is_out[k] ? "-" : show(columns[k], instances.size()).c_str());
      if (columns[k].unanswered >= kPatience) is_out[k] = true;
    }
    std::printf("\n<!-- weakly stable only: %d of 3 unstable loads -->\n", weakly_stable_only);
    std::fflush(stdout);
  }
  for (const std::string& missing : missing_competitors()) {
    std::printf("%s\n", missing.c_str());
  }
  for (const std::string& instance : weaker) {
    std::printf("GLPK calls a stable load not even weakly stable: %s\n", instance.c_str());
  }
  std::printf("\n");
}

}  // namespace stickslip::bench
