// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_region.hpp"

#include <algorithm>
#include <iostream>

#include "commands.hpp"
#include "stickslip/answers/plane_answers.hpp"
#include "stickslip/answers/verdict_answer.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/motion/exact_system.hpp"
#include "stickslip/plot/map_plot.hpp"
#include "terminal.hpp"

namespace stickslip {
namespace {

RationalRow wrench_in_space(const std::string& option, const std::string& value,
                            const RationalRow& otherwise) {
  if (value.empty()) return otherwise;
  RationalRow w = numbers_option(option, value);
  if (w.size() == 6) return w;
  throw InputError("", option,
                   "found " + std::to_string(w.size()) + " numbers, and the grasp is in space",
                   "give force x, y, z and torque x, y, z, as in 0,0,1,0,0,0");
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
    // Said below.
  }
  throw InputError("", "--within", "found " + quote(whole),
                   "give the ends of s and of t, the lower one first, as in -2:2,0:3/2");
}

PlaneInSpace plane_of(const Question& question, const SpaceRegionArguments& arguments) {
  const GraspBox& grasp = *question.box();
  if (!grasp.is_point()) {
    throw InputError("", "GRASP", "some of its numbers are uncertain",
                     "a region is about one grasp: give one number for each");
  }
  RationalRow load;
  for (const Interval& w : grasp.wrench) load.push_back(w.low);
  PlaneInSpace plane =
      plane_in_space(question, wrench_in_space("--origin", arguments.origin, load),
                     wrench_in_space("--u", arguments.u, {1, 0, 0, 0, 0, 0}),
                     wrench_in_space("--v", arguments.v, {0, 1, 0, 0, 0, 0}));
  if (rank_of(std::vector<RationalRow>{plane.s.along, plane.t.along}) < 2) {
    throw InputError("", "--u, --v", "they span no plane",
                     "give two wrenches that are not multiples of each other");
  }
  const std::string& within = arguments.within;
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

std::vector<MapCell> cells_of(const Question& question, const PlaneInSpace& plane,
                              const SpaceRegionArguments& arguments) {
  return proved_cells(plane.grasp, question.law, plane.s, plane.t, arguments.cells);
}

void print_text(const Question& question, const PlaneInSpace& plane,
                const std::vector<MapCell>& cells, NumberText& text) {
  const auto ends = [&](const MapAxis& axis) {
    return axis.name + " from " + text(axis.range.low) + " to " + text(axis.range.high);
  };
  std::cout << heading(question) << "resistible wrenches\n\n  plane  " << text(plane.origin)
            << " + s " << text(plane.s.along) << " + t " << text(plane.t.along)
            << ",\n         " << ends(plane.s) << ", " << ends(plane.t) << " (--within)\n\n"
            << shares_text(cells, plane.s, plane.t) << '\n'
            << cells.size() << " cells (--depth); normal law: " << law_text(question.law)
            << ".\n"
            << units_text(question) << text.note();
}

std::string picture(const Question& question, const PlaneInSpace& plane,
                    const std::vector<MapCell>& cells) {
  NumberText text(false);
  MapAxis s = plane.s;
  MapAxis t = plane.t;
  s.name = "s along " + text(s.along);
  t.name = "t along " + text(t.along);
  return plot_map(question.description().name, s, t, cells);
}

}  // namespace

int answer_region_in_space(const Question& question, const SpaceRegionArguments& arguments) {
  const PlaneInSpace plane = plane_of(question, arguments);
  const std::vector<MapCell> cells = cells_of(question, plane, arguments);
  if (arguments.numbers.json) {
    std::cout << finished(region_json(question, plane, cells), arguments.numbers.floats).dump(1)
              << '\n';
  } else {
    NumberText text(arguments.numbers);
    print_text(question, plane, cells, text);
  }
  return kDone;
}

int draw_region_in_space(const Question& question, const SpaceRegionArguments& arguments,
                         const std::string& output) {
  const PlaneInSpace plane = plane_of(question, arguments);
  write_whole_file(output, picture(question, plane, cells_of(question, plane, arguments)));
  return kDone;
}

}  // namespace stickslip
