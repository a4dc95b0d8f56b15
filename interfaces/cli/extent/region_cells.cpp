// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_cells.hpp"

#include <algorithm>
#include <iostream>

#include "box_numbers.hpp"
#include "commands.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/interfaces/map_plot.hpp"
#include "stickslip/interfaces/plane_answers.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

RationalRow wrench_given(const std::string& option, const std::string& value,
                         const RationalRow& otherwise) {
  if (value.empty()) return otherwise;
  RationalRow w = rationals_at(option, value);
  if (w.size() == otherwise.size()) return w;
  const bool in_space = otherwise.size() == 6;
  throw InputError("", option,
                   "found " + std::to_string(w.size()) + " numbers, and the grasp is in " +
                       (in_space ? "space" : "the plane"),
                   in_space ? "give force x, y, z and torque x, y, z, as in 0,0,1,0,0,0"
                            : "give force x, force y and torque, as in 0,1,0");
}

Interval range_of(const std::string& text, const std::string& whole) {
  const std::size_t colon = text.find(':');
  try {
    if (colon != std::string::npos) {
      const Interval range{parse_rational(text.substr(0, colon)),
                           parse_rational(text.substr(colon + 1))};
      if (range.low < range.high) return range;
    }
  } catch (const NumberError&) {
    // The error is thrown below.
  }
  throw InputError("", "--within", "found " + quote(whole),
                   "give the ends of s and of t, the lower one first, as in -2:2,0:3/2");
}

LoadWindow plane_of(const Question& question, const RegionAsked& asked) {
  const GraspBox& grasp = *question.box();
  if (!grasp.is_point()) {
    throw InputError("", "GRASP", "some of its numbers are uncertain",
                     "a region is about one grasp: give one number for each");
  }
  RationalRow load = middle_of(grasp.wrench);
  RationalRow along_x(load.size());
  RationalRow along_y(load.size());
  along_x[0] = along_y[1] = 1;
  if (!asked.torque.empty()) load.back() = rational_at("--torque", asked.torque);
  LoadWindow plane =
      load_window(question, wrench_given("--origin", asked.origin, load),
                  wrench_given("--u", asked.u, along_x), wrench_given("--v", asked.v, along_y));
  if (are_parallel(plane.s, plane.t)) {
    throw InputError("", "--u, --v", "they span no plane",
                     "give two wrenches that are not multiples of each other");
  }
  const std::string& within = asked.within;
  const std::size_t comma = std::min(within.find(','), within.size());
  for (MapAxis* axis : {&plane.s, &plane.t}) {
    if (within.empty()) continue;
    axis->range = range_of(axis == &plane.s        ? within.substr(0, comma)
                           : comma < within.size() ? within.substr(comma + 1)
                                                   : "",
                           within);
  }
  return plane;
}

std::vector<MapCell> cells_of(const Question& question, const LoadWindow& plane,
                              const RegionAsked& asked, LongWork& work) {
  return proved_cells(plane.grasp, question.law, plane.s, plane.t, asked.cells, work);
}

void print_text(const Question& question, const LoadWindow& plane,
                const std::vector<MapCell>& cells, NumberText& text) {
  const auto ends = [&](const MapAxis& axis) {
    return axis.name + " from " + text(axis.range.low) + " to " + text(axis.range.high);
  };
  std::cout << heading(question) << "resistible wrenches\n\n  plane  " << text(plane.origin)
            << " + s " << text(plane.s.along) << " + t " << text(plane.t.along)
            << ",\n         " << ends(plane.s) << ", " << ends(plane.t) << " (--within)\n\n"
            << shares_text(cells, plane.s, plane.t) << '\n'
            << motions_text(question) << cells.size()
            << " cells (--depth); normal law: " << law_text(question.law) << ".\n"
            << conventions_text(question) << text.note();
}

std::string picture(const Question& question, const LoadWindow& plane,
                    const std::vector<MapCell>& cells) {
  NumberText text(false);
  MapAxis s = plane.s;
  MapAxis t = plane.t;
  s.name = "s along " + text(s.along);
  t.name = "t along " + text(t.along);
  return plot_map(question.description().name, s, t, cells);
}

}  // namespace

int answer_region_in_cells(const Question& question, const RegionAsked& asked) {
  const LoadWindow plane = plane_of(question, asked);
  LongWork work("region", time_limit_option(asked.time_limit));
  const std::vector<MapCell> cells = cells_of(question, plane, asked, work);
  if (asked.numbers.json) {
    Json json = region_json(question, plane, cells);
    work.add_ending(json);
    std::cout << finished(std::move(json), asked.numbers.floats).dump(1) << '\n';
  } else {
    NumberText text(asked.numbers);
    print_text(question, plane, cells, text);
    std::cout << work.ending();
  }
  return kDone;
}

int draw_region_in_cells(const Question& question, const RegionAsked& asked,
                         const std::string& output) {
  const LoadWindow plane = plane_of(question, asked);
  LongWork work("region", time_limit_option(asked.time_limit));
  write_whole_file(output, picture(question, plane, cells_of(question, plane, asked, work)));
  return kDone;
}

}  // namespace stickslip
