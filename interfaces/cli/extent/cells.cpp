// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells.hpp"

#include "question_options.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

/// Returns the part of the rectangle that has this verdict.
Rational share_of(const std::vector<MapCell>& cells, std::size_t verdict, const MapAxis& x,
                  const MapAxis& y) {
  const auto area = [](const Interval& a, const Interval& b) -> Rational {
    return (a.high - a.low) * (b.high - b.low);
  };
  Rational sum = 0;
  for (const MapCell& cell : cells) {
    if (cell.decision.verdict.index() == verdict) sum += area(cell.x, cell.y);
  }
  return sum / area(x.range, y.range);
}

}  // namespace

std::vector<MapCell> proved_cells(const GraspBox& grasp, NormalLaw law, const MapAxis& x,
                                  const MapAxis& y, const CellsAsked& asked, LongWork& work) {
  MapOptions options;
  options.depth = asked.depth;
  options.box.node_limit = asked.node_limit;
  options.uncertain = asked.uncertain;
  if (!asked.certificates.empty()) make_folder("--certificates", asked.certificates);
  std::vector<MapCell> cells;
  const auto take = [&](MapCell cell) {
    const bool proved = !std::holds_alternative<Undecided>(cell.decision.verdict);
    if (proved && !asked.certificates.empty()) {
      const std::string producer = "stickslip " STICKSLIP_VERSION ", map";
      const GraspBox box = box_of_cell(grasp, x, y, cell.x, cell.y, asked.uncertain);
      const ProvedFiles files = proved_box(box, law, cell.decision, producer);
      write_proved_files("--certificates", asked.certificates,
                         {{"cell" + std::to_string(cells.size()), files}});
    }
    if (proved && std::holds_alternative<Stable>(cell.decision.verdict)) {
      cell.decision.verdict = Stable{};
    } else if (proved) {
      cell.decision.verdict = Unstable{};
    }
    cells.push_back(std::move(cell));
  };
  work.finishes([&] {
    map_verdicts(grasp, law, x, y, options, take, [&](double done) {
      work.say(std::to_string(static_cast<int>(100 * done)) + " % of the area, " +
               std::to_string(cells.size()) + " cells");
    });
  });
  return cells;
}

std::string shares_text(const std::vector<MapCell>& cells, const MapAxis& x, const MapAxis& y) {
  std::vector<std::vector<std::string>> rows{{"proved", "part of the area"}};
  std::size_t verdict = 0;
  for (const char* words : {"stable", "unstable", "", "nothing"}) {
    const Rational share = share_of(cells, verdict++, x, y);
    if (*words != '\0') rows.push_back({words, to_percent_string(share)});
  }
  return format_table(rows);
}

}  // namespace stickslip
