// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/box.hpp"

#include <algorithm>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "uncertain_contact.hpp"

namespace stickslip {

using namespace core_detail;

namespace core_detail {

namespace {

std::string ends_text(const Interval& interval) {
  return "[" + to_readable_string(interval.low) + ", " + to_readable_string(interval.high) +
         "]";
}

void check_low(bool good, const Interval& interval, const std::string& place,
               const char* remedy) {
  if (good) return;
  throw InputError("", place,
                   interval.is_point() ? "the value is " + to_readable_string(interval.low)
                                       : "the interval is " + ends_text(interval),
                   remedy);
}

}  // namespace

void check_ends(const Interval& interval, const std::string& place) {
  if (interval.low <= interval.high) return;
  throw InputError("", place,
                   "the interval from " + to_readable_string(interval.low) + " to " +
                       to_readable_string(interval.high) + " is empty",
                   "its min must be at most its max");
}

void check_contact(const UncertainContact& contact, const std::string& path) {
  for (std::size_t j = 0; j < contact.position.size(); ++j) {
    check_ends(contact.position[j], path + ".position[" + std::to_string(j) + "]");
  }
  if (dot(contact.normal, contact.normal).is_zero()) {
    throw InputError(
        "", path + ".normal",
        contact.normal.size() == 3 ? "the normal is (0, 0, 0)" : "the normal is (0, 0)",
        "give a nonzero vector that points into the object");
  }
  check_ends(contact.friction, path + ".friction");
  check_ends(contact.stiffness, path + ".stiffness");
  check_ends(contact.preload, path + ".preload");
  check_low(contact.friction.low.sign() >= 0, contact.friction, path + ".friction",
            "friction must be 0 or more everywhere in the box");
  check_low(contact.stiffness.low.sign() > 0, contact.stiffness, path + ".stiffness",
            "stiffness must be above 0 everywhere in the box");
  check_low(contact.preload.low.sign() >= 0, contact.preload, path + ".preload",
            "a preload is a normal force and must be 0 or more everywhere in the box");
  if (contact.torsion.sign() < 0) {
    throw InputError("", path + ".torsion",
                     "the torsion is " + to_readable_string(contact.torsion),
                     "it is a length, the moment of friction over its force, and 0 or more");
  }
  if (!contact.torsion.is_zero() && !contact.slope.is_zero()) {
    throw InputError("", path + ".normal", "the normal of a contact with torsion is uncertain",
                     "give the normal without a slope, or remove the torsion");
  }
  if (contact.max_force) {
    const std::string place = path + ".max_force";
    check_low(contact.max_force->sign() >= 0, point_interval(*contact.max_force), place,
              "the most that a normal force may be is 0 or more");
    if (!exact_sqrt(dot(contact.normal, contact.normal))) {
      throw InputError("", place, "the force is limited, and its normal has no rational length",
                       "give a normal such as [3, 4], or [\"3/5\", \"4/5\"]");
    }
  }
  if (contact.slope.sign() >= 0 && contact.slope < 1) return;
  throw InputError("", path + ".normal", "the slope is " + to_readable_string(contact.slope),
                   "a normal turns to either side by 0 or more and less than 1, which is 45 "
                   "degrees");
}

void check_spring(const Spring& spring) {
  const std::string& path = spring.place;
  const std::string force = path + "." + force_name(spring);
  check_ends(spring.stiffness, path + ".stiffness");
  check_ends(spring.force, force);
  if (spring.is_ratchet()) {
    check_low(spring.stiffness.low.sign() > 0, spring.stiffness, path + ".stiffness",
              "a ratchet yields: its stiffness must be above 0 everywhere in the box");
    check_low(spring.force.low.sign() >= 0, spring.force, force,
              "a ratchet only pushes: its preload must be 0 or more everywhere in the box");
  }
  check_low(spring.stiffness.low.sign() >= 0, spring.stiffness, path + ".stiffness",
            "stiffness must be 0 or more everywhere in the box");
  if (!spring.max_torque) return;
  check_low(spring.max_torque->sign() >= 0, point_interval(*spring.max_torque),
            path + ".max_torque", "the most that a torque may be is 0 or more");
}

void check_widened(const Tolerances& tolerances, const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    const std::string& place = error.place();
    for (const NamedTolerance& asked : given(tolerances)) {
      const std::string kind = asked.kind;
      const bool is_of_kind = place.size() > kind.size() &&
                              place.compare(place.size() - kind.size(), kind.size(), kind) == 0;
      if (!is_of_kind || asked.tolerance.relative || asked.tolerance.amount < 1) continue;
      const std::string amount = to_string(asked.tolerance.amount);
      throw InputError(error.file(), place, error.problem(),
                       "did you mean " + kind + "=" + amount + "%, and not " + amount +
                           " up and down? " + error.remedy());
    }
    throw;
  }
}

}  // namespace core_detail

namespace {

struct Tolerated {
  const char* name;
  std::optional<Tolerance> Tolerances::*tolerance;
};

constexpr Tolerated kTolerated[] = {
    {"friction", &Tolerances::friction}, {"stiffness", &Tolerances::stiffness},
    {"preload", &Tolerances::preload},   {"position", &Tolerances::position},
    {"normal", &Tolerances::normal},     {"wrench", &Tolerances::wrench}};

[[noreturn]] void fail(const std::string& problem, const std::string& remedy) {
  throw InputError("", "uncertain", problem, remedy);
}

/// Reads a number in the text of a ball; `name` is its name in errors.
Rational ball_number(const std::string& name, std::string_view text) {
  try {
    return parse_rational(text);
  } catch (const NumberError& error) {
    fail("the " + name + " of the ball of loads: " + error.what(),
         "write numbers, as in wrench=ball:1/2:length=2:about=3:0");
  }
}

/// Reads the text of a ball that follows "ball:".
LoadBall parse_ball(std::string_view text) {
  const auto next = [&] {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view word = text.substr(0, colon);
    text.remove_prefix(std::min(colon + 1, text.size()));
    return word;
  };
  LoadBall ball{ball_number("radius", next())};
  std::vector<std::string> given;
  while (!text.empty()) {
    const std::size_t equals = text.find('=');
    const std::string name(text.substr(0, equals));
    if (equals == std::string_view::npos ||
        (name != "length" && name != "about" && name != "body")) {
      fail("of a ball of loads there is no " + quote(std::string(next())),
           "write wrench=ball:R, and perhaps :length=L, :about=X:Y (in space X:Y:Z) and, of "
           "several bodies, :body=NAME at the end");
    }
    if (std::find(given.begin(), given.end(), name) != given.end()) {
      fail("the " + name + " of the ball of loads is given twice", "give it once");
    }
    given.push_back(name);
    text.remove_prefix(equals + 1);
    if (name == "body") {
      ball.body = text;
      break;
    }
    if (name == "length") ball.length = ball_number(name, next());
    if (name != "about") continue;
    RationalRow point;
    while (!text.empty() &&
           text.substr(0, text.find(':')).find('=') == std::string_view::npos) {
      point.push_back(ball_number("point", next()));
    }
    ball.set_about(std::move(point));
  }
  return ball;
}

const Tolerated& kind_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Tolerated& kind : kTolerated) {
    if (name == kind.name) return kind;
    names.emplace_back(kind.name);
  }
  fail("there is no kind of number " + quote(name), choice_of(name, names, "the kinds are "));
}

Tolerance parse_tolerance(const std::string& name, std::string_view text) {
  Tolerance tolerance;
  tolerance.relative = !text.empty() && text.back() == '%';
  if (tolerance.relative) text.remove_suffix(1);
  try {
    tolerance.amount = parse_rational(text);
  } catch (const NumberError& error) {
    fail("the tolerance of " + name + ": " + error.what(),
         "write a number, or a percentage such as 10%, as in " + name + "=0.01");
  }
  if (tolerance.amount.sign() < 0) {
    fail("the tolerance of " + name + " is " + to_string(tolerance.amount),
         "it goes both ways: give 0 or more");
  }
  if (tolerance.relative) tolerance.amount /= 100;
  if (tolerance.relative && name == "normal") {
    fail("a percentage of a normal",
         "give a slope, the tangent of the angle by which it may turn, such as 0.0175 for a "
         "degree");
  }
  return tolerance;
}

}  // namespace

Interval Tolerance::widen(const Interval& interval) const {
  const auto off = [&](const Rational& end) {
    return relative ? Rational(amount * abs(end)) : amount;
  };
  return {interval.low - off(interval.low), interval.high + off(interval.high)};
}

std::vector<NamedTolerance> given(const Tolerances& tolerances) {
  std::vector<NamedTolerance> result;
  for (const Tolerated& kind : kTolerated) {
    const std::optional<Tolerance>& tolerance = tolerances.*kind.tolerance;
    if (tolerance) result.push_back({kind.name, *tolerance});
  }
  return result;
}

std::vector<Turn> turns_of(const UncertainContact& contact) {
  const RationalRow& n = contact.normal;
  if (n.size() == 2) return {{{-n[1], n[0]}, contact.slope}};
  std::size_t least = 0;
  for (std::size_t j = 1; j < 3; ++j) {
    if (abs(n[j]) < abs(n[least])) least = j;
  }
  Vector3 axis{};
  axis[least] = 1;
  const Vector3 u = cross(vector3(n), axis);
  const Vector3 v = cross(vector3(n), u);
  constexpr unsigned kBits = 64;
  const auto most = [&](const Rational& square) {
    return square.is_zero() ? Rational(0) : short_sqrt(square, kBits).upper;
  };
  const Rational square = contact.slope * contact.slope / dot(u, u);
  return {{{u.begin(), u.end()}, most(square * dot(n, n))},
          {{v.begin(), v.end()}, most(square)}};
}

RationalRow turned(RationalRow normal, const std::vector<Turn>& turns, const RationalRow& e) {
  for (std::size_t k = 0; k < turns.size(); ++k) {
    for (std::size_t j = 0; j < normal.size(); ++j) normal[j] += e[k] * turns[k].direction[j];
  }
  return normal;
}

Tolerances parse_tolerances(std::string_view text) {
  Tolerances tolerances;
  for (bool last = false; !last;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view entry = text.substr(0, comma);
    const std::size_t equals = entry.find('=');
    if (equals == std::string_view::npos) {
      fail("found " + quote(entry),
           "write kinds and their tolerances, as in friction=10%,"
           "position=0.001");
    }
    const std::string name(entry.substr(0, equals));
    std::optional<Tolerance>& tolerance = tolerances.*kind_named(name).tolerance;
    if (tolerance || (name == "wrench" && tolerances.ball)) {
      fail("the tolerance of " + name + " is given twice", "give it once");
    }
    const std::string_view value = entry.substr(equals + 1);
    constexpr std::string_view kBall = "ball:";
    if (name == "wrench" && value.substr(0, kBall.size()) == kBall) {
      tolerances.ball = parse_ball(value.substr(kBall.size()));
    } else {
      tolerance = parse_tolerance(name, value);
    }
    last = comma == text.size();
    if (!last) text.remove_prefix(comma + 1);
  }
  return tolerances;
}

void LoadBall::set_about(RationalRow point) {
  const bool is_origin =
      (point.size() == 2 || point.size() == 3) &&
      std::all_of(point.begin(), point.end(), [](const Rational& x) { return x.is_zero(); });
  about = is_origin ? RationalRow{} : std::move(point);
}

Rational LoadBall::squared_norm(const RationalRow& z) const {
  const std::size_t forces = z.size() == 6 ? 3 : 2;
  Rational sum = 0;
  for (std::size_t j = 0; j < z.size(); ++j) {
    const Rational size = j < forces ? z[j] : Rational(z[j] / length);
    sum += size * size;
  }
  return sum;
}

std::string to_string(const LoadBall& ball) {
  std::string text = "ball:" + to_string(ball.radius) + ":length=" + to_string(ball.length);
  for (std::size_t j = 0; j < ball.about.size(); ++j) {
    text += (j == 0 ? ":about=" : ":") + to_string(ball.about[j]);
  }
  return ball.body.empty() ? text : text + ":body=" + ball.body;
}

std::vector<RationalRow> GraspBox::ball_motion() const {
  require(ball.has_value(), "there is no ball of loads");
  const std::size_t forces = in_space() ? 3 : 2;
  std::vector<RationalRow> rows;
  if (mechanism) {
    rows = mechanism->motion_of(mechanism->body_named(ball->body, "uncertain"));
  } else {
    rows.assign(wrench.size(), RationalRow(wrench.size()));
    for (std::size_t j = 0; j < rows.size(); ++j) rows[j][j] = 1;
  }
  if (ball->about.empty()) return rows;
  // The point moves by what the origin does and omega x c.
  const RationalRow& c = ball->about;
  const auto add = [&](std::size_t to, std::size_t turn, const Rational& arm) {
    for (std::size_t j = 0; j < rows[to].size(); ++j) rows[to][j] += arm * rows[turn][j];
  };
  if (forces == 2) {
    add(0, 2, -c[1]);
    add(1, 2, c[0]);
    return rows;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    add(k, 3 + (k + 1) % 3, c[(k + 2) % 3]);
    add(k, 3 + (k + 2) % 3, -c[(k + 1) % 3]);
  }
  return rows;
}

RationalRow GraspBox::ball_reach() const {
  require(ball.has_value(), "there is no ball of loads");
  RationalRow reach(in_space() ? 6 : 3, ball->radius);
  for (std::size_t j = in_space() ? 3 : 2; j < reach.size(); ++j) reach[j] *= ball->length;
  return reach;
}

namespace {

void check_ball(const GraspBox& box) {
  const LoadBall& ball = *box.ball;
  const auto check_above = [](const char* name, const Rational& value) {
    if (value.sign() > 0) return;
    fail(std::string("the ") + name + " of the ball of loads is " + to_readable_string(value),
         "give a number above 0");
  };
  check_above("radius", ball.radius);
  check_above("length", ball.length);
  const std::size_t coordinates = box.in_space() ? 3 : 2;
  if (!ball.about.empty() && ball.about.size() != coordinates) {
    fail("the point of the ball of loads has " + std::to_string(ball.about.size()) +
             " coordinates",
         "give " + std::to_string(coordinates) +
             ", as in about=" + (coordinates == 3 ? "1:0:0" : "1:0"));
  }
  for (const Interval& component : box.wrench) {
    if (component.is_point()) continue;
    fail("the load is known to an interval, and a ball is given",
         "give a certain load, or no ball");
  }
  if (!box.mechanism && !ball.body.empty()) {
    fail("the ball of loads is on the body " + quote(ball.body) + ", but there is one body",
         "leave out :body=");
  }
  if (!box.mechanism) return;
  if (ball.body.empty() || ball.body == "ground") {
    fail(ball.body.empty() ? "the ball of loads is on no body" : "a load on the ground",
         "say on which, as in :body=" + box.mechanism->bodies.front().name);
  }
  box.mechanism->body_named(ball.body, "uncertain");
}

}  // namespace

bool GraspBox::allows(const RationalRow& motion) const {
  return is_within(motion, max_motion);
}

std::vector<std::pair<std::size_t, Rational>> GraspBox::force_limits() const {
  std::vector<std::pair<std::size_t, Rational>> limits;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].max_force) continue;
    const auto length = exact_sqrt(dot(contacts[i].normal, contacts[i].normal));
    require(length.has_value(), "the length of a limited contact's normal is rational");
    limits.emplace_back(i, *contacts[i].max_force / *length);
  }
  for (std::size_t s = 0; s < springs.size(); ++s) {
    if (springs[s].max_torque) limits.emplace_back(contacts.size() + s, *springs[s].max_torque);
  }
  return limits;
}

bool GraspBox::is_point() const {
  bool all = !ball && std::all_of(contacts.begin(), contacts.end(),
                                  [](const UncertainContact& c) { return c.slope.is_zero(); });
  for_each_number(*this, [&](const Interval& interval) { all = all && interval.is_point(); });
  return all;
}

void GraspBox::check() const {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    check_contact(contacts[i], "contacts[" + std::to_string(i) + "]");
  }
  for (std::size_t i = 0; i < springs.size(); ++i) check_spring(springs[i]);
  for (std::size_t j = 0; j < wrench.size(); ++j) {
    check_ends(wrench[j], "wrench[" + std::to_string(j) + "]");
  }
  if (ball) check_ball(*this);
}

GraspBox GraspBox::widened(const Tolerances& tolerances) const {
  check();
  GraspBox box = *this;
  const auto widen = [](const std::optional<Tolerance>& tolerance, Interval& interval) {
    if (tolerance) interval = tolerance->widen(interval);
  };
  for (UncertainContact& c : box.contacts) {
    for (Interval& coordinate : c.position) widen(tolerances.position, coordinate);
    widen(tolerances.friction, c.friction);
    widen(tolerances.stiffness, c.stiffness);
    widen(tolerances.preload, c.preload);
    if (tolerances.normal) {
      require(!tolerances.normal->relative, "the tolerance of normals is not relative");
      c.slope += tolerances.normal->amount;
    }
  }
  for (Spring& spring : box.springs) {
    widen(tolerances.stiffness, spring.stiffness);
    widen(tolerances.preload, spring.force);
  }
  for (Interval& component : box.wrench) widen(tolerances.wrench, component);
  if (tolerances.ball) box.ball = tolerances.ball;
  check_widened(tolerances, [&] { box.check(); });
  return box;
}

GraspBox GraspBox::scaled(const GraspBox& centre, const Rational& factor) const {
  require(centre.contacts.size() == contacts.size() && centre.is_point(),
          "the centre is one grasp with as many contacts");
  require(factor.sign() >= 0, "a box is scaled by 0 or more");
  std::vector<Rational> middles;
  for_each_number(centre, [&](const Interval& number) { middles.push_back(number.low); });
  GraspBox box = *this;
  std::size_t next = 0;
  for_each_number(box, [&](Interval& interval) {
    const Rational& middle = middles[next++];
    require(interval.contains(middle), "the centre is not in the box");
    interval = {middle + factor * (interval.low - middle),
                middle + factor * (interval.high - middle)};
  });
  for (UncertainContact& c : box.contacts) c.slope *= factor;
  if (box.ball && factor.is_zero()) box.ball.reset();
  if (box.ball) box.ball->radius *= factor;
  box.check();
  return box;
}

GraspBox GraspBox::middle() const {
  GraspBox box = *this;
  for_each_number(box,
                  [](Interval& interval) { interval = point_interval(interval.middle()); });
  for (UncertainContact& c : box.contacts) c.slope = 0;
  box.ball.reset();
  return box;
}

RationalRow middle_of(const std::vector<Interval>& intervals) {
  RationalRow middle;
  middle.reserve(intervals.size());
  for (const Interval& interval : intervals) middle.push_back(interval.middle());
  return middle;
}

RationalRow UncertainContact::point() const {
  RationalRow point;
  for (const Interval& coordinate : position) point.push_back(coordinate.low);
  return point;
}

RationalRow wrench_at(const RationalRow& p, const RationalRow& f) {
  if (p.size() == 2) return {f[0], f[1], p[0] * f[1] - p[1] * f[0]};
  const Vector3 torque = cross(vector3(p), vector3(f));
  return {f[0], f[1], f[2], torque[0], torque[1], torque[2]};
}

RationalRow row_of(const Wrench& wrench) {
  return {wrench.x, wrench.y, wrench.torque};
}

Wrench wrench_of(const RationalRow& row) {
  require(row.size() == 3, "a wrench in the plane");
  return {row[0], row[1], row[2]};
}

WrenchBox box_of(const Wrench& wrench) {
  return {point_interval(wrench.x), point_interval(wrench.y), point_interval(wrench.torque)};
}

UncertainContact box_of(const Contact& contact) {
  return {{point_interval(contact.position.x), point_interval(contact.position.y)},
          {contact.normal.x, contact.normal.y},
          point_interval(contact.friction),
          point_interval(contact.stiffness),
          point_interval(contact.preload)};
}

GraspBox box_of(const LoadedGrasp& loaded) {
  GraspBox box;
  box.contacts.reserve(loaded.grasp.size());
  for (const Contact& contact : loaded.grasp.contacts()) {
    box.contacts.push_back(box_of(contact));
  }
  box.wrench = box_of(loaded.wrench);
  box.description = loaded.grasp.description();
  return box;
}

LoadedGrasp loaded_of(const GraspBox& point) {
  require(!point.mechanism && !point.in_space() && point.is_point(),
          "one grasp of one body in the plane");
  std::vector<Contact> contacts;
  contacts.reserve(point.contacts.size());
  for (const UncertainContact& c : point.contacts) {
    contacts.push_back({{c.position[0].low, c.position[1].low},
                        {c.normal[0], c.normal[1]},
                        c.friction.low,
                        c.stiffness.low,
                        c.preload.low});
  }
  return {Grasp(std::move(contacts), point.description), wrench_of(middle_of(point.wrench))};
}

const LoadedGrasp& AnyGrasp::loaded() const {
  require(single() != nullptr, "one grasp in the plane");
  return *single();
}

const Mechanism* AnyGrasp::mechanism() const {
  return box() != nullptr ? box()->mechanism.get() : nullptr;
}

bool AnyGrasp::has_certain_elements() const {
  return box() == nullptr || GraspBox{box()->contacts, {}, {}, {}, box()->springs}.is_point();
}

const GraspDescription& AnyGrasp::description() const {
  return box() != nullptr ? box()->description : single()->grasp.description();
}

WrenchBox AnyGrasp::wrench() const {
  return box() != nullptr ? box()->wrench : box_of(single()->wrench);
}

std::size_t AnyGrasp::contacts() const {
  return box() != nullptr ? box()->contacts.size() : single()->grasp.size();
}

UncertainContact AnyGrasp::contact(ContactId id) const {
  return box() != nullptr ? box()->contacts.at(id.index()) : box_of(single()->grasp[id]);
}

std::size_t AnyGrasp::pushing_elements() const {
  if (box() == nullptr) return contacts();
  return contacts() + static_cast<std::size_t>(
                          std::count_if(box()->springs.begin(), box()->springs.end(),
                                        [](const Spring& s) { return s.is_ratchet(); }));
}

std::vector<Rational> AnyGrasp::preloads() const {
  std::vector<Rational> preloads;
  if (box() == nullptr) {
    for (const Contact& c : single()->grasp.contacts()) preloads.push_back(c.preload);
    return preloads;
  }
  for (const UncertainContact& c : box()->contacts) preloads.push_back(c.preload.low);
  for (const Spring& spring : box()->springs) preloads.push_back(spring.force.low);
  return preloads;
}

void AnyGrasp::set_preload(const Rational& preload) {
  if (LoadedGrasp* one = single()) {
    one->grasp = one->grasp.with_preload(preload);
    return;
  }
  for (UncertainContact& c : box()->contacts) c.preload = point_interval(preload);
}

bool needs_enclosure(const GraspBox& box) {
  return std::any_of(box.contacts.begin(), box.contacts.end(), [](const UncertainContact& c) {
    return !c.preload.high.is_zero() && !exact_sqrt(dot(c.normal, c.normal));
  });
}

}  // namespace stickslip
