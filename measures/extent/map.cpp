// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/measures/map.hpp"

#include <mpfr.h>

#include <algorithm>
#include <map>
#include <utility>

#include "engine/box/single_grasp.hpp"
#include "in_parallel.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/number_list.hpp"
#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/lp/exact_system.hpp"

namespace stickslip {

using namespace box_detail;
using namespace extent_detail;

namespace {

struct AxisName {
  const char* name;
  AxisKind kind;
  bool of_contacts;  ///< may have the index of one contact
};

constexpr AxisName kNames[] = {
    {"friction", AxisKind::kFriction, true}, {"stiffness", AxisKind::kStiffness, true},
    {"preload", AxisKind::kPreload, true},   {"wrench", AxisKind::kWrench, false},
    {"load", AxisKind::kLoad, false},        {"direction", AxisKind::kDirection, false}};

/// Returns cos of an angle in degrees, to within 2^-100.
Interval cosine(const Rational& degrees) {
  constexpr mpfr_prec_t kPrecision = 192;
  // |degrees| <= 360: the angle is off by less than 2^-180, and the cosine changes no faster.
  const Rational turns = degrees / 360;
  Integer whole = numerator(turns) / denominator(turns);
  const Rational rest = degrees - 360 * Rational(whole);
  mpfr_t angle;
  mpfr_t pi;
  mpfr_init2(angle, kPrecision);
  mpfr_init2(pi, kPrecision);
  mpfr_const_pi(pi, MPFR_RNDN);
  mpfr_set_q(angle, rest.gmp(), MPFR_RNDN);
  mpfr_mul(angle, angle, pi, MPFR_RNDN);
  mpfr_div_ui(angle, angle, 180, MPFR_RNDN);
  mpfr_cos(angle, angle, MPFR_RNDN);
  constexpr unsigned long kBits = 110;
  mpfr_mul_2ui(angle, angle, kBits, MPFR_RNDN);
  Integer scaled;
  mpfr_get_z(scaled.mutable_gmp(), angle, MPFR_RNDN);
  mpfr_clear(angle);
  mpfr_clear(pi);
  const Integer unit = Integer(1) << kBits;
  return {Rational(scaled - 2, unit), Rational(scaled + 2, unit)};
}

/// Returns cos over an interval of degrees, whose extremes are at its ends and at multiples of
/// 180 inside.
Interval cosine(const Interval& degrees) {
  const Interval first = cosine(degrees.low);
  const Interval last = cosine(degrees.high);
  Interval range{std::min(first.low, last.low), std::max(first.high, last.high)};
  const Rational from = degrees.low / 180;
  Integer half_turns = numerator(from) / denominator(from) - 1;
  for (; Rational(180 * half_turns) <= degrees.high; ++half_turns) {
    if (Rational(180 * half_turns) < degrees.low) continue;
    (half_turns % 2 == 0 ? range.high : range.low) = half_turns % 2 == 0 ? 1 : -1;
  }
  return {std::max(range.low, Rational(-1)), std::min(range.high, Rational(1))};
}

Interval product(const Interval& a, const Interval& b) {
  const std::array<Rational, 4> ends{a.low * b.low, a.low * b.high, a.high * b.low,
                                     a.high * b.high};
  return {*std::min_element(ends.begin(), ends.end()),
          *std::max_element(ends.begin(), ends.end())};
}

/// Returns sqrt(square), or a decimal interval around it.
Interval root(const Rational& square) {
  if (const auto exact = exact_sqrt(square)) return point_interval(*exact);
  constexpr int kDigits = 40;
  const DecimalEnclosure near = enclose_sqrt(1, square, kDigits);
  return {parse_rational(near.lower), parse_rational(near.upper)};
}

void apply(const MapAxis& axis, const Interval& range, GraspBox& box) {
  const auto vary = [&](Interval UncertainContact::*number) {
    for (std::size_t i = 0; i < box.contacts.size(); ++i) {
      Interval& interval = box.contacts[i].*number;
      if (!axis.index) interval = product(interval, range);
      if (axis.index == i) interval = range;
    }
  };
  WrenchBox& w = box.wrench;
  switch (axis.kind) {
    case AxisKind::kFriction:
      return vary(&UncertainContact::friction);
    case AxisKind::kStiffness:
      return vary(&UncertainContact::stiffness);
    case AxisKind::kPreload:
      return vary(&UncertainContact::preload);
    case AxisKind::kWrench:
      w[*axis.index] = range;
      return;
    case AxisKind::kLoad:
      for (Interval& component : w) component = product(component, range);
      return;
    case AxisKind::kAlong:
      for (std::size_t j = 0; j < w.size(); ++j) {
        const Interval off = product(point_interval(axis.along[j]), range);
        w[j] = {w[j].low + off.low, w[j].high + off.high};
      }
      return;
    case AxisKind::kDirection: {
      const Rational square = w[0].low * w[0].low + w[1].low * w[1].low;
      const Interval size = root(square);
      w[0] = product(size, cosine(range));
      w[1] = product(size, cosine(Interval{range.low - 90, range.high - 90}));
    }
  }
}

bool varies_load(const MapAxis& axis) {
  return axis.kind == AxisKind::kWrench || axis.kind == AxisKind::kLoad ||
         axis.kind == AxisKind::kDirection || axis.kind == AxisKind::kAlong;
}

/// Returns the order in which an axis acts. A direction turns the wrench of the grasp before
/// anything else; a multiple that is added comes last, so that no factor multiplies it.
int place_of(const MapAxis& axis) {
  return axis.kind == AxisKind::kDirection ? 0 : axis.kind == AxisKind::kAlong ? 2 : 1;
}

/// A cell that is not decided yet.
struct OpenCell {
  Interval x;
  Interval y;
};

class Quadtree {
 public:
  Quadtree(const GraspBox& grasp, NormalLaw law, const MapAxis& x_axis, const MapAxis& y_axis,
           const MapOptions& options, const std::function<void(MapCell)>& take,
           const std::function<void(double)>& progress)
      : grasp_(grasp),
        law_(law),
        x_axis_(x_axis),
        y_axis_(y_axis),
        options_(options),
        take_(take),
        progress_(progress) {}

  /// Goes level by level, some cells at a time, on as many threads as there are.
  void run() {
    std::vector<OpenCell> open{{x_axis_.range, y_axis_.range}};
    std::vector<OpenCell> next;
    std::size_t from = 0;
    try {
      for (unsigned depth = 0; !open.empty(); ++depth) {
        constexpr std::size_t kAtATime = 64;
        while (from < open.size()) {
          const auto first = open.begin() + static_cast<std::ptrdiff_t>(from);
          const std::size_t count = std::min(kAtATime, open.size() - from);
          visit({first, first + static_cast<std::ptrdiff_t>(count)}, depth, next);
          from += count;
        }
        open = std::exchange(next, {});
        from = 0;
      }
    } catch (const Cancelled&) {
      // Undecided cells stand for what is left, to whoever keeps what is known.
      open.erase(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(from));
      for (const auto* left : {&open, &next}) {
        for (const auto& [x, y] : *left) {
          take_({x, y, BoxDecision{Undecided{"the work ended before this cell", "time"}}});
        }
      }
      throw;
    }
  }

 private:
  using Point = std::pair<Rational, Rational>;

  void visit(const std::vector<OpenCell>& cells, unsigned depth, std::vector<OpenCell>& next) {
    std::vector<std::optional<BoxDecision>> decisions = prove(cells, depth);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto& [x, y] = cells[c];
      std::optional<BoxDecision>& decision = decisions[c];
      if (!decision && depth < options_.depth) {
        for (const Interval& upper :
             {Interval{y.low, y.middle()}, Interval{y.middle(), y.high}}) {
          next.push_back({{x.low, x.middle()}, upper});
          next.push_back({{x.middle(), x.high}, upper});
        }
        continue;
      }
      if (!decision) decision = BoxDecision{Undecided{"no proof in the finest cell"}};
      done_ += 1.0 / static_cast<double>(std::size_t{1} << (2 * depth));
      take_({x, y, std::move(*decision)});
    }
    if (progress_) progress_(done_);
  }

  /// Tries to prove the cells whose corners, and middle, have one verdict. Others need no
  /// search for a proof.
  std::vector<std::optional<BoxDecision>> prove(const std::vector<OpenCell>& cells,
                                                unsigned depth) {
    std::vector<Point> corners;
    for (const auto& [x, y] : cells) {
      for (const Rational& px : {x.low, x.high}) {
        for (const Rational& py : {y.low, y.high}) corners.emplace_back(px, py);
      }
    }
    decide(corners);
    std::vector<std::size_t> agree;
    std::vector<Point> middles;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Point* corner = &corners[4 * c];
      const std::optional<bool> first = points_.at(corner[0]);
      if (!first || points_.at(corner[1]) != first || points_.at(corner[2]) != first ||
          points_.at(corner[3]) != first)
        continue;
      agree.push_back(c);
      middles.emplace_back(cells[c].x.middle(), cells[c].y.middle());
    }
    if (depth < options_.depth) decide(middles);
    std::vector<std::optional<BoxDecision>> decisions(cells.size());
    in_parallel(agree.size(), [&](std::size_t k) {
      const OpenCell& cell = cells[agree[k]];
      const auto middle = points_.find(middles[k]);
      if (middle != points_.end() && middle->second != points_.at(corners[4 * agree[k]]))
        return;
      BoxDecision decision = prove_box(box_of(cell.x, cell.y), law_, options_.box, 0);
      if (!std::holds_alternative<Undecided>(decision.verdict)) {
        decisions[agree[k]] = std::move(decision);
      }
    });
    return decisions;
  }

  /// Decides the points that are not known yet: each corner is one of several cells.
  void decide(const std::vector<Point>& points) {
    std::vector<std::pair<const Point, std::optional<bool>>*> added;
    for (const Point& point : points) {
      const auto [entry, is_new] = points_.try_emplace(point);
      if (is_new) added.push_back(&*entry);
    }
    in_parallel(added.size(), [&](std::size_t k) {
      const auto& [x, y] = added[k]->first;
      added[k]->second = is_stable_at(x, y);
    });
  }

  std::optional<bool> is_stable_at(const Rational& x, const Rational& y) const {
    const GraspBox box = box_of(point_interval(x), point_interval(y));
    if (options_.uncertain.any()) {
      return stickslip::is_stable(prove_box(box, law_, options_.box, 0).verdict);
    }
    return is_stable(box.middle(), law_, options_.box);
  }

  GraspBox box_of(const Interval& x, const Interval& y) const {
    return box_of_cell(grasp_, x_axis_, y_axis_, x, y, options_.uncertain);
  }

  const GraspBox& grasp_;
  NormalLaw law_;
  const MapAxis& x_axis_;
  const MapAxis& y_axis_;
  const MapOptions& options_;
  const std::function<void(MapCell)>& take_;
  const std::function<void(double)>& progress_;
  double done_ = 0;
  std::map<Point, std::optional<bool>> points_;
};

/// Returns the ends behind the equals sign.
Interval axis_range(std::string_view text, std::size_t equals, std::size_t colon,
                    const std::string& axis) {
  const auto fail = [&](const std::string& problem, const std::string& remedy) {
    throw InputError("", axis, problem, remedy);
  };
  Interval range;
  try {
    range = {parse_rational(text.substr(equals + 1, colon - equals - 1)),
             parse_rational(text.substr(colon + 1))};
  } catch (const NumberError& error) {
    fail(std::string("its range: ") + error.what(), "write two numbers, as in 0:1 or 1/2:3/2");
  }
  if (!(range.low < range.high)) fail("its range is empty", "give the lower end first");
  return range;
}

/// Returns the wrench "WX,WY,T", or six numbers in space.
RationalRow wrench_along(const GraspBox& grasp, const std::string& text,
                         const std::string& axis) {
  RationalRow w = rationals_at(axis, text);
  if (w.size() != grasp.wrench.size()) {
    throw InputError("", axis, "found a wrench of " + std::to_string(w.size()) + " numbers",
                     grasp.mechanism    ? "give one for each coordinate of bodies and joints"
                     : grasp.in_space() ? "give force x, y, z and torque x, y, z"
                                        : "give force x, force y and torque");
  }
  if (is_zero(primitive_multiple(w))) {
    throw InputError("", axis, "its wrench is 0", "give one along which the load changes");
  }
  return w;
}

}  // namespace

MapAxis parse_axis(const GraspBox& grasp, std::string_view text, const std::string& place) {
  const auto fail = [&](const std::string& problem, const std::string& remedy) {
    throw InputError("", place, problem, remedy);
  };
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':', std::min(equals, text.size()));
  if (equals == std::string_view::npos || colon == std::string_view::npos) {
    fail("found " + quote(std::string(text)), "write NAME=FROM:TO, as in friction=0:1");
  }
  MapAxis result;
  result.name = std::string(text.substr(0, equals));
  result.place = place;
  if (result.name.find(',') != std::string::npos) {
    result.kind = AxisKind::kAlong;
    result.along = wrench_along(grasp, result.name, place);
    result.range = axis_range(text, equals, colon, place);
    return result;
  }
  const std::size_t bracket = std::min(result.name.find('['), result.name.size());
  const std::string word = result.name.substr(0, bracket);
  std::vector<std::string> names;
  const AxisName* found = nullptr;
  for (const AxisName& name : kNames) {
    names.emplace_back(name.name);
    if (word == name.name) found = &name;
  }
  if (found == nullptr) {
    fail("there is nothing called " + quote(word), choice_of(word, names, "the names are "));
  }
  result.kind = found->kind;
  if (result.kind == AxisKind::kDirection && (grasp.in_space() || grasp.mechanism)) {
    fail(grasp.in_space() ? "a direction, but the grasp is in space"
                          : "a direction, but there are several bodies",
         "vary components of the load: wrench[0]");
  }
  const bool of_wrench = found->kind == AxisKind::kWrench;
  const std::size_t count = of_wrench ? grasp.wrench.size() : grasp.contacts.size();
  const std::string index =
      bracket < result.name.size() ? result.name.substr(bracket) : std::string();
  if (!index.empty() && (found->of_contacts || of_wrench)) {
    for (std::size_t i = 0; i < count; ++i) {
      if (index == "[" + std::to_string(i) + "]") result.index = i;
    }
  }
  if (!result.index && (of_wrench || !index.empty())) {
    fail("found " + quote(result.name),
         of_wrench && grasp.mechanism
             ? "write wrench[0] to wrench[" + std::to_string(count - 1) +
                   "]; the JSON of decide names the coordinates"
         : of_wrench && grasp.in_space()
             ? "write wrench[0] to wrench[5]; the last three are the torque"
         : of_wrench          ? "write wrench[0], wrench[1] or wrench[2], which is the torque"
         : found->of_contacts ? "contacts are counted from 0: the last is " + word + "[" +
                                    std::to_string(count - 1) + "]"
                              : word + " has no parts");
  }
  result.range = axis_range(text, equals, colon, place);
  const bool is_positive = result.kind == AxisKind::kStiffness;
  const bool is_nonnegative =
      is_positive || result.kind == AxisKind::kFriction || result.kind == AxisKind::kPreload;
  if (is_nonnegative && result.range.low.sign() < (is_positive ? 1 : 0)) {
    fail("it begins at " + to_readable_string(result.range.low),
         is_positive ? "a stiffness is above 0" : "it is 0 or more");
  }
  const Rational most = 720;
  if (result.kind == AxisKind::kDirection &&
      (result.range.high - result.range.low > most || abs(result.range.low) > most)) {
    fail("its range is beyond two turns", "give degrees, as in direction=0:360");
  }
  return result;
}

bool are_parallel(const MapAxis& a, const MapAxis& b) {
  return rank_of(std::vector<RationalRow>{a.along, b.along}) < 2;
}

GraspBox box_of_cell(const GraspBox& grasp, const MapAxis& x_axis, const MapAxis& y_axis,
                     const Interval& x, const Interval& y, const Tolerances& uncertain) {
  GraspBox box = grasp;
  const bool y_first = place_of(y_axis) < place_of(x_axis);
  apply(y_first ? y_axis : x_axis, y_first ? y : x, box);
  apply(y_first ? x_axis : y_axis, y_first ? x : y, box);
  return uncertain.any() ? box.widened(uncertain) : box;
}

void map_verdicts(const GraspBox& grasp, NormalLaw law, const MapAxis& x_axis,
                  const MapAxis& y_axis, const MapOptions& options,
                  const std::function<void(MapCell)>& take,
                  const std::function<void(double)>& progress) {
  const bool same_kind = x_axis.kind == y_axis.kind;
  const auto turns_wrench = [](const MapAxis& axis) {
    return axis.kind == AxisKind::kDirection || axis.kind == AxisKind::kWrench;
  };
  const auto are_of_one_number = [&] {  // of the same kind
    return x_axis.kind == AxisKind::kAlong
               ? are_parallel(x_axis, y_axis)
               : x_axis.index == y_axis.index || !x_axis.index || !y_axis.index;
  };
  const bool clash =
      same_kind ? are_of_one_number() : turns_wrench(x_axis) && turns_wrench(y_axis);
  if (clash) {
    throw InputError("", y_axis.place, "both axes vary " + x_axis.name,
                     "choose two numbers that do not depend on each other");
  }
  for (const MapAxis& axis : {x_axis, y_axis}) {
    if (!options.uncertain.ball || !varies_load(axis)) continue;
    throw InputError("", axis.place,
                     axis.name + " varies the load in the centre of a ball of loads",
                     "let axes vary friction, stiffness or preload; or give wrench=T, a "
                     "tolerance of each component");
  }
  // Any error of a cell is an error of the whole rectangle, so the whole is checked first.
  box_of_cell(grasp, x_axis, y_axis, x_axis.range, y_axis.range, options.uncertain);
  Quadtree(grasp, law, x_axis, y_axis, options, take, progress).run();
}

}  // namespace stickslip
