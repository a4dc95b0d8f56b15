// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "hard.hpp"
#include "limited.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "statistics.hpp"
#include "stickslip/engine/branch_and_bound.hpp"

namespace stickslip::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// For one family at one size: no further load is tried after the first, the process ends at
/// the second.
constexpr double kSearchSeconds = 2;
constexpr double kLimitSeconds = 8;
constexpr std::size_t kNodeLimit = 100000;

/// The largest of everything, over all loads tried while thresholds are bisected.
struct Worst {
  double nodes = 0;
  double exact_programs = 0;
  double ms = 0;
  bool is_complete = true;  ///< false: the time was up before the thresholds were found
};

struct TimeIsUp {};

Worst search_threshold(HardFamily family, std::size_t contacts, NormalLaw law) {
  Worst worst;
  const Clock::time_point begin = Clock::now();
  const auto is_stable = [&](const Question& question) {
    const Clock::time_point start = Clock::now();
    if (std::chrono::duration<double>(start - begin).count() > kSearchSeconds) throw TimeIsUp{};
    BranchWork work;
    SearchOptions options;
    options.node_limit = kNodeLimit;
    const Verdict verdict =
        branch_and_bound(Problem(question.loaded(), question.law), options, &work);
    worst.ms = std::max(
        worst.ms, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    worst.nodes = std::max(worst.nodes, static_cast<double>(work.nodes));
    worst.exact_programs =
        std::max(worst.exact_programs, static_cast<double>(work.exact_programs));
    return std::holds_alternative<Stable>(verdict);
  };
  try {
    for (const std::uint64_t seed : {1, 2}) {
      find_threshold(hard_grasp(family, contacts, seed), law, is_stable);
    }
  } catch (const TimeIsUp&) {
    worst.is_complete = false;
  }
  return worst;
}

std::optional<Worst> search_limited(HardFamily family, std::size_t contacts, NormalLaw law) {
  const auto text = run_limited(kLimitSeconds, [&] {
    const Worst worst = search_threshold(family, contacts, law);
    return nlohmann::json{worst.nodes, worst.exact_programs, worst.ms, worst.is_complete}
        .dump();
  });
  if (!text) return std::nullopt;
  const nlohmann::json json = nlohmann::json::parse(*text);
  return Worst{json[0], json[1], json[2], json[3]};
}

}  // namespace

void report_growth(Report& report) {
  std::vector<std::size_t> sizes{10, 20, 40};
  if (report.large_growth) sizes.push_back(80);
  std::printf("| family | law |");
  for (const std::size_t m : sizes) std::printf(" m = %zu |", m);
  std::printf(" exponent |\n|---|---|");
  for (std::size_t k = 0; k < sizes.size() + 1; ++k) std::printf("--:|");
  std::printf("\n");
  for (std::size_t f = 0; f < kHardFamilies; ++f) {
    const auto family = static_cast<HardFamily>(f);
    for (const NormalLaw law : {NormalLaw::kUnilateral, NormalLaw::kBilateral}) {
      std::printf("| %s | %s |", name_of(family), to_string(law));
      std::vector<std::pair<double, double>> points;
      bool is_out = false;
      for (const std::size_t m : sizes) {
        if (is_out || m > report.max_contacts) {
          std::printf(" - |");
          continue;
        }
        const auto worst = search_limited(family, m, law);
        if (!worst) {
          std::printf(" > %.0f s |", kLimitSeconds);
          is_out = true;
          continue;
        }
        points.emplace_back(static_cast<double>(m), worst->nodes);
        std::printf(" %.0f (%s ms, %.0f)%s |", worst->nodes, show_ms(worst->ms, 0).c_str(),
                    worst->exact_programs, worst->is_complete ? "" : " +");
        report.json["growth"].push_back({{"family", name_of(family)},
                                         {"normal_law", to_string(law)},
                                         {"contacts", m},
                                         {"nodes", worst->nodes},
                                         {"exact_programs", worst->exact_programs},
                                         {"ms", worst->ms}});
      }
      std::printf(" %.2f |\n", log_log_slope(points));
      std::fflush(stdout);
    }
  }
  std::printf("\n");
}

}  // namespace stickslip::bench
