// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_cases.hpp"

#include <utility>

#include "stickslip/engine/decide_problem.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::test {
namespace {

Wrench any_direction(RandomSource& random) {
  Wrench wrench;
  while (wrench == Wrench{}) wrench = small_wrench(random);
  return wrench;
}

/// The least multiple of the load beyond which none is resisted for a while; 1 if there is
/// none.
Rational first_threshold(const Grasp& grasp, const Wrench& direction, NormalLaw law) {
  const Problem family = Problem({grasp, {}}, law).along({row_of(direction)});
  const auto found = find_margin(family);
  const auto* margin = std::get_if<Margin>(&found);
  if (margin == nullptr || margin->resisted.empty()) return 1;
  const MarginInterval& first = margin->resisted.front();
  return first.high && !first.high->is_zero() ? *first.high : Rational(1);
}

/// With preloads on all contacts, along normals of irrational length too.
Grasp all_preloaded(RandomSource& random, const Grasp& grasp) {
  std::vector<Contact> contacts = grasp.contacts();
  for (Contact& c : contacts) c.preload = Rational(random.between(1, 4), 2);
  return Grasp(std::move(contacts));
}

Tolerance percent(const Rational& size) {
  return {size / 100, true};
}

Rational size_of(const Interval& interval) {
  return interval.high - interval.low;
}

Rational any_in(RandomSource& random, const Interval& interval, bool corner) {
  constexpr int kSteps = 64;
  const int step = corner ? kSteps * random.between(0, 1) : random.between(0, kSteps);
  return interval.low + size_of(interval) * Rational(step, kSteps);
}

/// At most `slope` in size; of those e = 2u / (1 - u^2) for which 1 + e^2 is a square if the
/// length is to stay rational.
Rational any_turn(RandomSource& random, const Rational& slope, bool corner, bool rational) {
  if (!rational) return any_in(random, {-slope, slope}, corner);
  const auto turn = [](int step) {
    const Rational u(step, 1 << 14);
    return Rational(2 * u / (1 - u * u));
  };
  int most = 0;
  while (turn(most + 1) <= slope) ++most;
  return corner ? turn(random.one_in(2) ? most : -most) : turn(random.between(-most, most));
}

bool has_rational_length(const Vector2& v) {
  return exact_sqrt(v.x * v.x + v.y * v.y).has_value();
}

}  // namespace

Question BoxCase::question() const {
  return ask(parse_any_grasp(grasp, "grasp"), options);
}

std::string describe(const BoxCase& box_case) {
  return describe(CheckerInput{box_case.grasp, "", box_case.options});
}

BoxCase random_box(RandomSource& random, Uncertain uncertain) {
  BoxCase result;
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  result.options.law = law;
  Grasp grasp = generic_grasp(random, static_cast<std::size_t>(random.between(3, 6)));
  if (uncertain == Uncertain::kLengths) {
    grasp = all_preloaded(random, grasp);
    if (needs_enclosure(box_of(LoadedGrasp{grasp, {}}))) {
      result.grasp = write_grasp({grasp, small_wrench(random)});
      if (random.one_in(2)) result.options.uncertain.friction = percent(1);
      return result;
    }
    return random_box(random, uncertain);
  }
  const Wrench direction = any_direction(random);
  const Rational multiple =
      first_threshold(grasp, direction, law) * Rational(random.between(50, 120), 100);
  const LoadedGrasp loaded{grasp, multiple * direction};
  result.grasp = write_grasp(loaded);
  const Rational size = random.pick<Rational>({1, 3, 10});
  Tolerances& asked = result.options.uncertain;
  if (uncertain == Uncertain::kFriction) asked.friction = percent(size);
  if (uncertain == Uncertain::kWrench) asked.wrench = percent(size);
  if (uncertain == Uncertain::kAll || uncertain == Uncertain::kInFile) {
    asked.friction = asked.stiffness = percent(size);
    asked.preload = percent(size / 2);
    asked.position = asked.normal = Tolerance{size / 2000};
    asked.wrench = percent(size / 4);
  }
  if (result.question().box() == nullptr) return random_box(random, uncertain);
  if (uncertain == Uncertain::kInFile) {
    result.grasp = file_of(result.box());
    asked = {};
  }
  return result;
}

std::string file_of(const GraspBox& box) {
  return write_grasp_file({box});
}

LoadedGrasp sample(RandomSource& random, const GraspBox& box) {
  const bool corner = random.one_in(2);
  const auto any = [&](const Interval& interval) { return any_in(random, interval, corner); };
  std::vector<Contact> contacts;
  for (const UncertainContact& c : box.contacts) {
    const Vector2 n{c.normal[0], c.normal[1]};
    Contact chosen{{any(c.position[0]), any(c.position[1])},
                   n,
                   any(c.friction),
                   any(c.stiffness),
                   any(c.preload)};
    const Rational e =
        any_turn(random, c.slope, corner, !chosen.preload.is_zero() && has_rational_length(n));
    chosen.normal = {n.x - e * n.y, n.y + e * n.x};
    contacts.push_back(std::move(chosen));
  }
  return {Grasp(std::move(contacts)),
          {any(box.wrench[0]), any(box.wrench[1]), any(box.wrench[2])}};
}

bool lies_in(const LoadedGrasp& grasp, const GraspBox& box) {
  const Wrench& w = grasp.wrench;
  bool inside = grasp.grasp.size() == box.contacts.size() && box.wrench[0].contains(w.x) &&
                box.wrench[1].contains(w.y) && box.wrench[2].contains(w.torque);
  for (std::size_t i = 0; inside && i < box.contacts.size(); ++i) {
    const UncertainContact& c = box.contacts[i];
    const Contact& one = grasp.grasp.contacts()[i];
    const Rational along = c.normal[0] * one.normal.x + c.normal[1] * one.normal.y;
    const Rational across = c.normal[0] * one.normal.y - c.normal[1] * one.normal.x;
    inside = c.position[0].contains(one.position.x) && c.position[1].contains(one.position.y) &&
             c.friction.contains(one.friction) && c.stiffness.contains(one.stiffness) &&
             c.preload.contains(one.preload) && along.sign() > 0 &&
             abs(across) <= c.slope * along;
  }
  return inside;
}

GraspBox two_pads(const Interval& preload, WrenchBox load) {
  GraspBox box;
  for (const int side : {-1, 1}) {
    UncertainContact c;
    c.position = {point_interval(side), point_interval(0)};
    c.normal = {-side, 0};
    if (load.size() == 6) {
      c.position.push_back(point_interval(0));
      c.normal.emplace_back(0);
    }
    c.friction = {Rational(2, 5), Rational(3, 5)};
    c.preload = preload;
    box.contacts.push_back(c);
  }
  box.wrench = std::move(load);
  return box;
}

std::string verdict_of(const LoadedGrasp& grasp, NormalLaw law) {
  const GraspBox box = box_of(grasp);
  if (needs_enclosure(box)) return name_of(decide_box(box, law).verdict);
  return name_of(decide(Problem(grasp, law)).verdict);
}

}  // namespace stickslip::test
