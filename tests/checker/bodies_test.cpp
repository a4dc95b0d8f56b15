// SPDX-License-Identifier: MIT
// Grasps of several bodies (FORMAT.md §14): what a file may say, rows against velocities that
// are found another way, trees against the naive twin, and answers known in closed form.
#include "bodies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "leaf.hpp"
#include "naive.hpp"
#include "support.hpp"

namespace stickslip_check {
namespace {

using Members = std::map<std::string, std::string>;

std::string object(const Members& members) {
  std::string text;
  for (const auto& [key, value] : members) {
    text += (text.empty() ? "{" : ",\n ") + ("\"" + key + "\": " + value);
  }
  return text + "}\n";
}

/// A file of version 3 in which these members replace or complete those of one link on a slide
/// along (0, 1).
std::string slide(Members members) {
  members.insert({{"format", R"("stickslip-grasp/3")"},
                  {"bodies", R"([{"name": "l", "slide": [0, 1]}])"},
                  {"joints", R"([{"turns": {"l": 1}}])"},
                  {"contacts", "[]"}});
  return object(members);
}

std::string load(const std::string& force) {
  return R"([{"body": "l", "force": [)" + force + R"(], "at": [0, 0]}])";
}

std::string stable(const std::string& head, const std::string& twist,
                   const std::string& shares = "") {
  return head + R"( "verdict": "stable", "twist": [)" + twist + R"(], "shares": [)" + shares +
         "]}\n";
}

std::string in_parts(const std::string& head, const std::string& parts) {
  return head + R"( "verdict": "stable", "parts": [)" + parts + "]}\n";
}

std::string margin(std::size_t contacts, const std::string& direction,
                   const std::string& claims) {
  return R"({"format": "stickslip-certificate/2", "question": {"contacts": )" +
         std::to_string(contacts) + R"(, "wrench": [0], "normal_law": "unilateral", )" +
         R"("direction": [)" + direction + R"(]}, "verdict": "margin", "intervals": [)" +
         claims + "]}\n";
}

void expect_outcome(const std::string& expected, const std::string& grasp,
                    const std::string& certificate, const Options& options = {}) {
  const Answer answer = ask(grasp, certificate, options);
  EXPECT_EQ(outcome(answer), expected) << explain(answer) << "\n" << certificate;
}

// ---- what a file may say

TEST(Bodies, WhatAFileMayNotSay) {
  const std::string contact = R"("position": [0, 0], "normal": [0, 1], "friction": 0)";
  const std::string pin = R"({"name": "p", "hinge": [0, 0]})";
  const std::string body = R"({"name": "b"})";
  struct Case {
    Members members;
    std::string place;    ///< ends so
    std::string problem;  ///< is in it
  };
  const std::vector<Case> cases{
      {{{"bodies", "[]"}}, "bodies", "one or more"},
      {{{"bodies", "3"}}, "bodies", "an array"},
      {{{"bodies", R"([{"slide": [0, 1]}])"}}, "bodies[0]", "\"name\" is missing"},
      {{{"bodies", R"([{"name": ""}])"}}, "bodies[0].name", "not empty"},
      {{{"bodies", R"([{"name": "ground"}])"}}, "bodies[0].name", "not \"ground\""},
      {{{"bodies", R"([{"name": 1}])"}}, "bodies[0].name", "a string"},
      {{{"bodies", "[" + body + ", " + body + "]"}}, "bodies[1]", "appears twice"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1], "hinge": [0, 0]}])"}},
       "bodies[0]",
       "give one of them"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 0]}])"}}, "bodies[0].slide", "other than 0"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1, 0]}])"}}, "bodies[0].slide", "2 coord"},
      {{{"bodies", R"([{"name": "l", "hinge": {"at": [0, 0]}}])"}},
       "bodies[0].hinge",
       "[x, y]"},
      {{{"bodies", R"([{"name": "l", "slide": [0, {"min": 1, "max": 2}]}])"}},
       "bodies[0].slide[1]",
       "a number"},
      {{{"bodies", R"([{"name": "l", "on": "ground"}])"}}, "bodies[0].on", "neither"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1], "on": "b"}, {"name": "b"}])"}},
       "bodies[0].on",
       "stands before this one"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1], "on": "l"}])"}},
       "bodies[0].on",
       "before"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1], "mesh": {}}])"}},
       "bodies[0].mesh",
       "none"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1], "outline": [[0, 0], [1, 1], [2, 2]]}])"}},
       "bodies[0].outline[0][0]",
       "no area"},
      {{{"bodies", R"([{"name": "l", "mass": 1}])"}}, "bodies[0]", "unknown member"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1]}, )" + pin + "]"}},
       "bodies[1]",
       "no joint turns the link \"p\""},
      {{{"bodies", "[" + body + "]"}}, "joints[0].turns", "\"l\""},
      {{{"bodies", R"([{"name": "l"}])"}}, "joints[0].turns", "expected a link"},
      {{{"joints", "{}"}}, "joints", "an array"},
      {{{"joints", "[{}]"}}, "joints[0]", "\"turns\" is missing"},
      {{{"joints", R"([{"turns": {}}])"}}, "joints[0].turns", "one number or more"},
      {{{"joints", R"([{"turns": {"l": 0}}])"}}, "joints[0].turns.l", "other than 0"},
      {{{"joints", R"([{"turns": {"l": {"min": 1, "max": 2}}}])"}},
       "joints[0].turns.l",
       "number"},
      {{{"joints", R"([{"turns": {"ground": 1}}])"}}, "joints[0].turns", "\"ground\""},
      {{{"joints", R"([{"turns": {"l": 1}, "stiffness": -1}])"}},
       "joints[0].stiffness",
       "0 or more"},
      {{{"joints", R"([{"turns": {"l": 1}, "tension": 1}])"}}, "joints[0]", "unknown member"},
      {{{"joints", R"([{"turns": {"l": 1}, "name": 1}])"}}, "joints[0].name", "a string"},
      {{{"tendons", R"([{"stiffness": 1}])"}}, "tendons[0]", "\"over\" is missing"},
      {{{"tendons", R"([{"over": {"l": 1}, "torque": 1}])"}}, "tendons[0]", "unknown member"},
      {{{"tendons", R"([{"over": {"l": 1}, "stiffness": {"min": -1, "max": 1}}])"}},
       "tendons[0].stiffness",
       "0 or more"},
      {{{"tendons", R"([{"over": {"l": 1, "p": -1}}])"},
        {"bodies", R"([{"name": "l", "slide": [0, 1]}, )" + pin + "]"},
        {"joints", R"([{"turns": {"l": 1, "p": 1}}])"}},
       "tendons[0].over",
       "its length changes"},
      {{{"ratchets", R"([{"over": {"l": 1}}])"}}, "ratchets[0]", "\"stiffness\" is missing"},
      {{{"ratchets", R"([{"over": {"l": 1}, "stiffness": 0}])"}},
       "ratchets[0].stiffness",
       "above 0"},
      {{{"ratchets", R"([{"over": {"l": 1}, "stiffness": 1, "preload": -1}])"}},
       "ratchets[0].preload",
       "0 or more"},
      {{{"contacts", "[{" + contact + "}]"}}, "contacts[0]", "\"of\" is missing"},
      {{{"contacts", "[{" + contact + R"(, "by": "l"}])"}}, "contacts[0]", "\"of\" is missing"},
      {{{"contacts", "[{" + contact + R"(, "of": "x"}])"}}, "contacts[0].of", "found \"x\""},
      {{{"contacts", "[{" + contact + R"(, "of": "ground"}])"}}, "contacts[0].of", "bodies"},
      {{{"contacts", "[{" + contact + R"(, "of": 1}])"}}, "contacts[0].of", "name of a body"},
      {{{"contacts", "[{" + contact + R"(, "of": "l", "by": "l"}])"}},
       "contacts[0].by",
       "another"},
      {{{"contacts", "[{" + contact + R"(, "of": "l", "by": "x"}])"}},
       "contacts[0].by",
       "ground"},
      {{{"contacts", R"([{"on": [0, 0], "friction": 0, "of": "l"}])"}},
       "contacts[0].on",
       "positi"},
      {{{"contacts", "[{" + contact + R"(, "of": "l", "name": "c"}])"}},
       "contacts[0]",
       "unknown"},
      {{{"loads", "{}"}}, "loads", "an array"},
      {{{"loads", R"([{"force": [0, 1], "at": [0, 0]}])"}}, "loads[0]", "\"body\" is missing"},
      {{{"loads", R"([{"body": "ground", "torque": 1}])"}}, "loads[0].body", "bodies"},
      {{{"loads", R"([{"body": "l", "wrench": [0, 0, 0]}])"}}, "loads[0]", "is a link"},
      {{{"loads", R"([{"body": "l", "torque": {"min": 0, "max": 1}}])"}},
       "loads[0].torque",
       "a number"},
      {{{"loads", R"([{"body": "l", "wrench": [0, 0, 0], "torque": 1}])"}},
       "loads[0]",
       "unknown"},
      {{{"bodies", R"([{"name": "l", "slide": [0, 1]}, {"name": "b"}])"},
        {"loads", R"([{"body": "b", "wrench": [0]}])"}},
       "loads[0].wrench",
       "[force x, force y, torque]"},
      {{{"cases", "[]"}}, "cases", "one case or more"},
      {{{"cases", R"([{"name": "c"}])"}}, "cases[0]", "\"loads\""},
      {{{"cases", R"([{"name": "c", "loads": [], "wrench": [0]}])"}}, "cases[0]", "\"loads\""},
      {{{"wrench", "[0, 0]"}}, "wrench", "array"},
      {{{"wrench", "[0]"}, {"loads", "[]"}}, "top level", "\"loads\""},
      {{{"outline", "[[0, 0], [1, 0], [0, 1]]"}}, "top level", "\"bodies\""},
      {{{"body", "{}"}}, "top level", "\"mesh\""},
      {{{"format", R"("stickslip-grasp/4")"}}, "format", "\"stickslip-grasp/3\""},
      {{{"format", R"("stickslip-grasp/2")"}}, "top level", "stickslip-grasp/3"},
      {{{"format", R"("stickslip-grasp/1")"}}, "top level", "stickslip-grasp/3"},
  };
  for (const auto& [members, place, problem] : cases) {
    try {
      read(slide(members));
      ADD_FAILURE() << "read: " << slide(members);
    } catch (const Malformed& error) {
      const std::string end = " " + place;
      EXPECT_EQ(
          (" " + error.place)
              .substr(error.place.size() + 1 - std::min(error.place.size() + 1, end.size())),
          end)
          << error.place << ": " << error.problem;
      EXPECT_NE(error.problem.find(problem), std::string::npos)
          << error.place << ": " << error.problem << " (" << problem << ")";
    }
  }
  for (const char* key : {"bodies", "contacts"}) {
    const std::string left_out = key == std::string("bodies") ? "contacts" : "bodies";
    EXPECT_THROW(read(object({{"format", R"("stickslip-grasp/3")"}, {left_out, "[]"}})),
                 Malformed);
  }
  std::string many;
  for (int k = 0; k < 10; ++k)
    many += (k > 0 ? ", " : "") + replaced(body, "b", "b" + std::to_string(k));
  EXPECT_THROW(read(slide({{"bodies", R"([{"name": "l", "slide": [0, 1]}, )" + many + "]"}})),
               Malformed);
  EXPECT_EQ(read(slide({{"bodies", "[" + many + "]"}, {"joints", "[]"}})).dimension(), 30U);
}

TEST(Bodies, MembersOfOneBodyAndOfSeveralDoNotMix) {
  const std::string one = R"({"format": "stickslip-grasp/2", "wrench": [0, 0, 0], "contacts": [
 {"position": [0, 0], "normal": [0, 1], "friction": 0}]})";
  EXPECT_NO_THROW(read(one));
  const auto refused = [](const std::string& text) {
    try {
      read(text);
    } catch (const Malformed& error) {
      return error.problem;
    }
    return std::string("read");
  };
  for (const char* version : {"/1", "/2"}) {
    const std::string old = replaced(one, "/2", version);
    const std::string needs = "it needs \"format\": \"stickslip-grasp/3\"";
    for (const char* key : {"\"of\"", "\"by\""}) {
      EXPECT_EQ(
          refused(replaced(old, "\"friction\"", key + std::string(": \"b\", \"friction\""))),
          "the member " + std::string(key) + ": " + needs);
    }
    for (const char* key : {"bodies", "joints", "tendons", "ratchets"}) {
      const std::string member = "\"" + std::string(key) + "\"";
      EXPECT_EQ(refused(replaced(old, "\"wrench\"", member + ": [], \"wrench\"")),
                "the member " + member + ": " + needs);
    }
  }
  EXPECT_NE(refused(replaced(one, "\"wrench\": [0, 0, 0]",
                             R"("loads": [{"body": "b", "torque": 0}])")),
            "read");
}

TEST(Bodies, CasesAndLoads) {
  const std::string cases = R"([{"name": "up", "loads": )" + load("0, 2") + "}]";
  const std::string three = stable(header(1, "3"), "3");
  const std::string spring = R"([{"turns": {"l": 1}, "stiffness": 1}])";
  Options up;
  up.case_name = "up";
  const std::string with_loads =
      slide({{"joints", spring}, {"loads", load("5, 1")}, {"cases", cases}});
  expect_outcome("accepted", with_loads, three, up);
  expect_outcome("accepted", with_loads, stable(header(1, "1"), "1"));
  const std::string without = slide({{"joints", spring}, {"cases", cases}});
  expect_outcome("accepted", without, stable(header(1, "2"), "2"), up);
  expect_outcome("malformed", without, stable(header(1, "0"), "0"));
  expect_outcome("accepted", slide({{"joints", spring}}), stable(header(1, "0"), "0"));
}

TEST(Bodies, WhatCannotBeAsked) {
  const std::string grasp = slide(
      {{"joints", R"([{"turns": {"l": 1}, "stiffness": 1, "torque": {"min": -1, "max": 1}}])"},
       {"ratchets", R"([{"over": {"l": 1}, "stiffness": 1}])"}});
  const auto problem = [&](const Options& options, const std::string& text) {
    try {
      pose(read(text), options, "grasp");
    } catch (const Malformed& error) {
      return error.place + ": " + error.problem;
    }
    return std::string("asked");
  };
  Options options;
  EXPECT_EQ(problem(options, grasp), "asked");
  options.wrench = Vector{1, 2, 3};
  EXPECT_EQ(
      problem(options, grasp),
      "wrench: found 3 numbers, expected 1, one for each coordinate of its bodies and joints");
  options.wrench = Vector{1};
  options.plane = {Vector{1, 0, 0}, Vector{0, 1, 0}};
  EXPECT_NE(problem(options, grasp).find("plane: the grasp is of several bodies"),
            std::string::npos);
  options.plane.reset();
  options.inertia = Vector{0, 0, 1};
  EXPECT_NE(problem(options, grasp).find("inertia: the grasp is of several bodies"),
            std::string::npos);
  options.inertia.reset();
  options.direction = Vector{1};
  EXPECT_NE(problem(options, grasp).find("joints[0].torque: found the interval"),
            std::string::npos);
  // Numbers for the ratchet and the spring, of which the second may be any.
  const std::string certain = replaced(grasp, R"({"min": -1, "max": 1})", "-1");
  options.preload_direction = PreloadDirection{false, {1, -1}};
  EXPECT_EQ(problem(options, certain), "asked");
  options.preload_direction = PreloadDirection{false, {-1, 1}};
  EXPECT_NE(problem(options, certain), "asked");
  options.preload_direction = PreloadDirection{false, {1}};
  EXPECT_NE(problem(options, certain), "asked");
  // What is uncertain.
  Options uncertain;
  const auto widened = [&](const std::string& file) {
    return [&uncertain, &problem, file](const char* kind, const Rational& size) {
      uncertain.uncertain = {{kind, Tolerance{size, false}}};
      return problem(uncertain, file);
    };
  };
  const auto with = widened(grasp);
  EXPECT_EQ(with("preload", 0), "asked");
  EXPECT_EQ(with("preload", 1), "ratchets[0].preload: it may be -1, expected 0 or more");
  EXPECT_EQ(with("stiffness", 1), "ratchets[0].stiffness: it may be 0, expected above 0");
  EXPECT_EQ(with("friction", 1), "asked");
  EXPECT_EQ(with("normal", 5), "asked");
  const auto of_spring =
      widened(slide({{"joints", R"([{"turns": {"l": 1}, "stiffness": 1}])"}}));
  EXPECT_EQ(of_spring("preload", 3), "asked");
  EXPECT_EQ(of_spring("stiffness", 1), "asked");
  EXPECT_EQ(of_spring("stiffness", 2), "joints[0].stiffness: it may be -1, expected 0 or more");
}

TEST(Bodies, OptionsReachTheElementsTheyAreAbout) {
  const std::string grasp =
      slide({{"contacts", R"([{"position": [0, 0], "normal": [0, 2],
 "friction": {"min": 1, "max": 2}, "preload": 6, "of": "l"}])"},
             {"joints", R"([{"turns": {"l": 1}, "torque": -4}])"},
             {"ratchets", R"([{"over": {"l": 1}, "stiffness": 3, "preload": 5}])"}});
  Options options;
  options.preload = 8;
  options.uncertain = {{"preload", {Rational(1, 2), true}},
                       {"stiffness", {Rational(50), true}},
                       {"friction", {Rational(1), false}}};
  const Question question = pose(read(grasp), options, "grasp");
  ASSERT_TRUE(question.is_box);
  Question enlarged = question;
  enlarge(enlarged);
  const Box& box = *enlarged.box;
  ASSERT_EQ(box.size(), 3U);
  const auto at = [&](std::size_t i, Parameter name) { return show(box.contact(i)[name]); };
  EXPECT_EQ(at(0, Parameter::kFriction), "[0, 3]");
  EXPECT_EQ(at(0, Parameter::kPreload), "[199/50, 201/50]");
  EXPECT_EQ(at(0, Parameter::kStiffness), "[1/8, 3/8]");
  EXPECT_EQ(at(1, Parameter::kFriction), "0");
  EXPECT_EQ(at(1, Parameter::kPreload), "[199/40, 201/40]");
  EXPECT_EQ(at(1, Parameter::kStiffness), "[3/2, 9/2]");
  EXPECT_EQ(at(2, Parameter::kPreload), "[-201/50, -199/50]");
  EXPECT_EQ(at(2, Parameter::kStiffness), "0");
}

// ---- rows, and trees, against velocities

/// A mechanism that knows how each point moves, without any matrix.
struct Velocities {
  struct Part {
    char kind;  ///< 'f'ree, 'h'inge or 's'lide
    int on;     ///< or -1
    Vector at;  ///< of a hinge; the direction of a slide
    Vector axis;
  };
  bool in_space = false;
  std::vector<Part> parts;
  std::vector<Vector> turns;  ///< by joint, of each part

  std::size_t coordinates() const { return in_space ? 3 : 2; }
  std::size_t of_free() const { return in_space ? 6 : 3; }

  /// A turn about a point that moves p.
  static Vector turned(const Vector& axis, const Vector& p, const Vector& about) {
    Vector r;
    for (std::size_t k = 0; k < p.size(); ++k) r.emplace_back(p[k] - about[k]);
    if (p.size() == 2) return {Rational(-r[1]), r[0]};
    return {Rational(axis[1] * r[2] - axis[2] * r[1]),
            Rational(axis[2] * r[0] - axis[0] * r[2]),
            Rational(axis[0] * r[1] - axis[1] * r[0])};
  }

  /// Of p on this part, when coordinate j grows.
  Vector of(int part, const Vector& p, std::size_t j) const {
    if (part < 0) return Vector(coordinates());
    const Part& it = parts[static_cast<std::size_t>(part)];
    std::size_t first = 0;
    std::size_t mine = 0;
    for (std::size_t b = 0; b < parts.size(); ++b) {
      if (b == static_cast<std::size_t>(part)) mine = first;
      if (parts[b].kind == 'f') first += of_free();
    }
    if (it.kind == 'f') {
      Vector v(coordinates());
      if (j < mine || j >= mine + of_free()) return v;
      if (j - mine < coordinates()) {
        v[j - mine] = 1;
        return v;
      }
      Vector axis(3);
      if (in_space) axis[j - mine - 3] = 1;
      return turned(axis, p, Vector(coordinates()));
    }
    Vector v = of(it.on, p, j);
    if (j < first) return v;
    const Rational& rate = turns[j - first][static_cast<std::size_t>(part)];
    const Vector own = it.kind == 's' ? it.at : turned(it.axis, p, it.at);
    for (std::size_t k = 0; k < v.size(); ++k) v[k] += rate * own[k];
    return v;
  }

  std::size_t dimension() const {
    std::size_t d = turns.size();
    for (const Part& part : parts) d += part.kind == 'f' ? of_free() : 0;
    return d;
  }

  /// What the force does at the point, for each coordinate.
  Vector work(int of_part, int by, const Vector& p, const Vector& force) const {
    Vector w;
    for (std::size_t j = 0; j < dimension(); ++j) {
      w.emplace_back(dot(force, of(of_part, p, j)) - dot(force, of(by, p, j)));
    }
    return w;
  }
};

std::string text_of(const Vector& v) {
  std::string text;
  for (const Rational& c : v) text += (text.empty() ? "\"" : ", \"") + c.get_str() + "\"";
  return "[" + text + "]";
}

Vector small(Random& random, std::size_t size, bool nonzero = false) {
  Vector v;
  for (std::size_t k = 0; k < size; ++k) v.emplace_back(between(random, -2, 2));
  return nonzero && v == Vector(size) ? small(random, size, true) : v;
}

/// A random grasp as a text, and what follows from velocities.
struct Mechanical {
  std::string text;
  std::vector<NaiveRow> rows;
  std::vector<Vector> normals;             ///< n0 of each contact
  std::vector<std::vector<Vector>> slips;  ///< in space, S by its three rows
  Vector wrench;
};

Mechanical random_grasp(Random& random, bool in_space, int most_bodies, int most_contacts) {
  Velocities moves;
  moves.in_space = in_space;
  const std::size_t n = moves.coordinates();
  const int bodies = between(random, 1, most_bodies);
  const int joints = between(random, 1, 3);  // so that links alone may have D = 3
  const auto name = [](int b) {
    return b < 0 ? std::string("ground") : "b" + std::to_string(b);
  };
  std::string bodies_text;
  for (int b = 0; b < bodies; ++b) {
    Velocities::Part part{"fhs"[between(random, b == 0 ? 1 : 0, 2)], between(random, -1, b - 1),
                          small(random, n, true), small(random, 3, true)};
    bodies_text += (b > 0 ? ", " : "") + (R"({"name": ")" + name(b) + "\"");
    if (part.kind == 's') bodies_text += R"(, "slide": )" + text_of(part.at);
    if (part.kind == 'h' && !in_space) bodies_text += R"(, "hinge": )" + text_of(part.at);
    if (part.kind == 'h' && in_space) {
      bodies_text += R"(, "hinge": {"at": )" + text_of(part.at) + R"(, "axis": )" +
                     text_of(part.axis) + "}";
    }
    if (part.kind != 'f' && part.on >= 0) bodies_text += R"(, "on": ")" + name(part.on) + "\"";
    bodies_text += "}";
    moves.parts.push_back(part);
  }
  Mechanical grasp;
  // Numbers for links, and what they are in the text.
  const auto numbers = [&](bool all) {
    Vector c(moves.parts.size());
    std::string text;
    for (std::size_t b = 0; b < c.size(); ++b) {
      if (moves.parts[b].kind == 'f' || (!all && b > 0 && between(random, 0, 1) == 0)) continue;
      c[b] = between(random, 0, 1) == 0 ? Rational(-1) : Rational(between(random, 1, 2));
      text +=
          (text.empty() ? "{\"" : ", \"") + name(static_cast<int>(b)) + "\": " + c[b].get_str();
    }
    return std::pair{c, text + "}"};
  };
  // Now and then all stiffnesses and preloads have many digits.
  Rational factor = 1;
  if (between(random, 0, 3) == 0) {
    mpz_ui_pow_ui(factor.get_num_mpz_t(), 3, 60);
    mpz_ui_pow_ui(factor.get_den_mpz_t(), 7, 50);
  }
  const auto times_factor = [&](int low, int high) {
    return Rational(factor * between(random, low, high));
  };
  const auto quoted = [](const Rational& x) { return "\"" + x.get_str() + "\""; };
  std::vector<NaiveRow> springs;
  std::string joints_text;
  for (int q = 0; q < joints; ++q) {
    const auto [c, turns] = numbers(q == 0);
    moves.turns.push_back(c);
    joints_text += (q > 0 ? ", " : "") + (R"({"turns": )" + turns);
    const int kind = between(random, 0, 3);
    NaiveRow row;
    row.spring = true;
    const Rational stiffness = kind == 1 ? Rational(0) : times_factor(0, 2);
    const Rational torque = kind == 2 ? Rational(0) : times_factor(-2, 2);
    row.v = {stiffness, torque};
    if (kind == 0 || kind == 2) joints_text += R"(, "stiffness": )" + quoted(stiffness);
    if (kind == 0 || kind == 1) joints_text += R"(, "torque": )" + quoted(torque);
    joints_text += "}";
    if (kind == 3) continue;
    row.normal = {q};
    springs.push_back(row);
  }
  const std::size_t d = moves.dimension();
  for (NaiveRow& row : springs) {
    Vector unit(d);
    unit[d - static_cast<std::size_t>(joints) + row.normal[0].get_num().get_ui()] = 1;
    row.normal = unit;
  }
  // Those over links: the row is how fast the sum of the links' numbers times their turns
  // grows.
  std::string over_text[2];
  for (const int kind : {0, 1}) {
    for (int k = between(random, 0, 1); k > 0; --k) {
      const auto [r, over] = numbers(false);
      NaiveRow row;
      row.spring = kind == 1;
      row.normal = Vector(d);
      for (std::size_t q = 0; q < moves.turns.size(); ++q) {
        row.normal[d - moves.turns.size() + q] = dot(r, moves.turns[q]);
      }
      if (row.normal == Vector(d)) continue;
      const Rational stiffness = times_factor(1, 2);
      const Rational preload = times_factor(kind == 0 ? 0 : -2, 2);
      row.v = {stiffness, preload};
      over_text[kind] = R"({"over": )" + over + R"(, "stiffness": )" + quoted(stiffness) +
                        (kind == 0 ? R"(, "preload": )" : R"(, "tension": )") +
                        quoted(preload) + "}";
      (kind == 0 ? grasp.rows : springs).push_back(row);
    }
  }
  std::vector<NaiveRow> contacts;
  std::string contacts_text;
  for (int i = between(random, in_space ? 1 : 0, most_contacts); i > 0; --i) {
    const int of = between(random, 0, bodies - 1);
    int by = between(random, -1, bodies - 1);
    if (by == of) by = -1;
    const Vector p = small(random, n);
    constexpr int kNormals[][3] = {{1, 0, 0}, {0, -1, 0}, {3, 4, 0}, {0, 2, 0}, {-3, 4, 0}};
    const int* of_n = kNormals[between(random, 0, 4)];
    const Vector normal(of_n, of_n + n);
    grasp.normals.push_back(normal);
    NaiveRow row;
    row.friction = Rational(between(random, 0, 2)) / 2;
    row.normal = moves.work(of, by, p, normal);
    const Rational square = dot(normal, normal);
    if (in_space) {
      grasp.slips.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        Vector along = normal;
        for (Rational& c : along) c *= -normal[k] / square;
        along[k] += 1;
        grasp.slips.back().push_back(moves.work(of, by, p, along));
      }
    } else {
      row.tangent = moves.work(of, by, p, {Rational(-normal[1]), normal[0]});
    }
    const Rational stiffness = times_factor(1, 2);
    const Rational preload = times_factor(0, 2);
    row.v = {Rational(stiffness / square), Rational(preload / *exact_sqrt(square))};
    contacts.push_back(row);
    contacts_text += (contacts_text.empty() ? "" : ",\n  ") +
                     (R"({"position": )" + text_of(p)) + R"(, "normal": )" + text_of(normal) +
                     R"(, "friction": ")" + row.friction.get_str() + R"(", "stiffness": )" +
                     quoted(stiffness) + R"(, "preload": )" + quoted(preload) + R"(, "of": ")" +
                     name(of) + "\"" + (by < 0 ? "" : R"(, "by": ")" + name(by) + "\"") + "}";
  }
  grasp.rows.insert(grasp.rows.begin(), contacts.begin(), contacts.end());
  grasp.rows.insert(grasp.rows.end(), springs.begin(), springs.end());
  for (NaiveRow& row : grasp.rows) {
    if (row.tangent.empty()) row.tangent = Vector(d);
    Vector v;
    for (const Rational& c : row.normal) v.emplace_back(-row.v[0] * c);
    v.insert(v.end(), {row.v[1], 0});
    row.v = v;
  }
  for (std::size_t i = contacts.size(); i < grasp.rows.size(); ++i) grasp.rows[i].slips = false;
  // Forces at points, and couples for torques.
  grasp.wrench = Vector(d);
  std::string loads_text;
  for (int k = between(random, 0, 3); k > 0; --k) {
    const int on = between(random, 0, bodies - 1);
    const Vector p = small(random, n);
    const Vector force = small(random, n);
    const bool torque = between(random, 0, 2) == 0;
    const auto add = [&](const Vector& at, const Vector& f) {
      const Vector w = moves.work(on, -1, at, f);
      for (std::size_t j = 0; j < d; ++j) grasp.wrench[j] += w[j];
    };
    loads_text += (loads_text.empty() ? "" : ", ") + (R"({"body": ")" + name(on) + "\", ");
    if (!torque) {
      add(p, force);
      loads_text += R"("force": )" + text_of(force) + R"(, "at": )" + text_of(p) + "}";
      continue;
    }
    const Vector t = small(random, in_space ? 3 : 1);
    for (std::size_t a = 0; a < t.size(); ++a) {
      Vector arm(n);
      Vector f(n);
      arm[in_space ? (a + 1) % 3 : 0] = 1;
      f[in_space ? (a + 2) % 3 : 1] = t[a];
      add(arm, f);
      for (Rational& c : f) c = -c;
      add(Vector(n), f);
    }
    loads_text += R"("torque": )" + (in_space ? text_of(t) : t[0].get_str()) + "}";
  }
  grasp.text = object({{"format", R"("stickslip-grasp/3")"},
                       {"bodies", "[" + bodies_text + "]"},
                       {"joints", "[" + joints_text + "]"},
                       {"ratchets", "[" + over_text[0] + "]"},
                       {"tendons", "[" + over_text[1] + "]"},
                       {"contacts", "[" + contacts_text + "]"},
                       {"loads", "[" + loads_text + "]"}});
  return grasp;
}

Vector times(const Rational& scale, const Form& x) {
  Vector v;
  for (const Integer& c : x) v.emplace_back(scale * c);
  return v;
}

TEST(Bodies, RowsAreTheWorkOfForcesOnMotions) {
  Random random(271);
  std::size_t slipping = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const bool in_space = trial % 2 == 0;
    const Mechanical grasp = random_grasp(random, in_space, 4, 3);
    const Question question = pose(read(grasp.text), {}, "grasp");
    EXPECT_EQ(question.in_space, in_space);
    EXPECT_EQ(question.several->coordinates.size(), grasp.wrench.size());
    ASSERT_EQ(question.wrench, Wrench(grasp.wrench.begin(), grasp.wrench.end())) << grasp.text;
    ASSERT_EQ(question.box->size(), grasp.rows.size()) << grasp.text;
    for (std::size_t i = 0; i < grasp.rows.size(); ++i) {
      const Row& row = question.box->row(i);
      const NaiveRow& expected = grasp.rows[i];
      ASSERT_EQ(times(row.scale, row.normals[0]), expected.normal) << i << " of " << grasp.text;
      ASSERT_EQ(row.v, (std::vector<Form>{make_form(expected.v)})) << i << " of " << grasp.text;
      EXPECT_EQ(is_spring(question.box->contact(i).sight), expected.spring);
      EXPECT_EQ(is_contact(question.box->contact(i).sight), expected.slips);
      const bool three = in_space && expected.slips;
      ASSERT_EQ(row.slips[0].size(), three ? 3U : 1U);
      for (std::size_t k = 0; k < row.slips[0].size(); ++k) {
        ASSERT_EQ(times(row.scale, row.slips[0][k]),
                  three ? grasp.slips[i][k] : expected.tangent)
            << i << " of " << grasp.text;
      }
      slipping += row.slips[0][0] == Form(grasp.wrench.size()) ? 0 : 1;
    }
  }
  EXPECT_GT(slipping, 300U);
}

TEST(Bodies, TreesAgreeWithTheNaiveTwin) {
  Random random(828);
  std::size_t accepted = 0;
  std::size_t rejected = 0;
  for (int trial = 0; trial < rounds(400); ++trial) {
    const Mechanical grasp = random_grasp(random, false, 2, 2);
    Options options;
    options.bilateral = trial % 4 == 0;
    Range range{0, 0};
    const Vector zero(grasp.wrench.size());
    if (trial % 2 == 1 && grasp.wrench != zero) {
      options.wrench = zero;
      options.direction = grasp.wrench;
      range = {Rational(between(random, 0, 2)), std::nullopt, true, true};
      if (between(random, 0, 1) == 0) range.high = range.low + 1;
    }
    Question question = pose(read(grasp.text), options, "grasp");
    const NaiveQuestion q(question, range, grasp.rows);
    const RandomTree tree(random, q);
    accepted += tree.accepted;
    rejected += tree.rejected;
  }
  EXPECT_GT(accepted, rounds(500U));
  EXPECT_GT(rejected, rounds(500U));
}

/// Vectors of friction at a contact with such a normal force, times its length, that the laws
/// allow: one number in the plane. Nothing where it has an irrational length.
std::optional<Vector> friction_at(Random& random, const Mechanical& grasp, std::size_t i,
                                  const Vector& d) {
  const NaiveRow& row = grasp.rows[i];
  if (grasp.slips.empty()) {
    const int slip = sgn(dot(row.tangent, d));
    return Vector{slip != 0 ? Rational(-slip) : Rational(Rational(between(random, -2, 2)) / 2)};
  }
  Vector s;
  for (const Vector& along : grasp.slips[i]) s.push_back(dot(along, d));
  if (s != Vector(3)) {
    const auto over = exact_sqrt(dot(grasp.normals[i], grasp.normals[i]) / dot(s, s));
    if (!over) return std::nullopt;
    for (Rational& c : s) c *= -*over;
    return s;
  }
  Vector axis(3);
  axis[static_cast<std::size_t>(between(random, 0, 2))] = between(random, -1, 1);
  const Vector& m = grasp.normals[i];
  return Vector{m[1] * axis[2] - m[2] * axis[1], m[2] * axis[0] - m[0] * axis[2],
                m[0] * axis[1] - m[1] * axis[0]};
}

// Where an equilibrium is at home, no leaf holds, whatever its twist: of one grasp, and of
// boxes around it.
TEST(Bodies, NoLeafRefutesAnEquilibrium) {
  Random random(577);
  std::size_t leaves = 0;
  std::size_t tight = 0;
  for (int trial = 0; trial < rounds(900); ++trial) {
    const bool in_space = trial % 2 == 0;
    const Mechanical grasp = random_grasp(random, in_space, 3, 2);
    const std::size_t n = grasp.wrench.size();
    Vector x(n);
    for (int k = between(random, 0, 3); k > 0; --k) {
      x[static_cast<std::size_t>(between(random, 0, static_cast<int>(n) - 1))] =
          between(random, -2, 2);
    }
    x.insert(x.end(), {1, 0});
    Options options;
    options.wrench = Vector(n);
    std::string shares;
    bool rational = true;
    for (std::size_t i = 0; i < grasp.rows.size(); ++i) {
      const NaiveRow& row = grasp.rows[i];
      Rational a = dot(row.v, x);
      if (!row.spring && a < 0) a = 0;
      for (std::size_t j = 0; j < n; ++j) (*options.wrench)[j] -= a * row.normal[j];
      if (!row.slips || row.friction == 0 || a == 0) continue;
      const auto share = friction_at(random, grasp, i, x);
      rational = rational && share;
      if (!rational) break;
      for (std::size_t k = 0; k < share->size(); ++k) {
        const Vector& along = in_space ? grasp.slips[i][k] : row.tangent;
        for (std::size_t j = 0; j < n; ++j) {
          (*options.wrench)[j] -= row.friction * a * (*share)[k] * along[j];
        }
      }
      const bool sticks = in_space ? std::all_of(grasp.slips[i].begin(), grasp.slips[i].end(),
                                                 [&](auto& s) { return dot(s, x) == 0; })
                                   : dot(row.tangent, x) == 0;
      if (!sticks) continue;
      shares += (shares.empty() ? "[" : ", [") + std::to_string(i) + ", " +
                (in_space ? text_of(*share) : "\"" + (*share)[0].get_str() + "\"") + "]";
    }
    if (!rational) continue;
    const auto bare = [](const std::string& list) { return list.substr(1, list.size() - 2); };
    const Vector d(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n));
    const Answer answer = ask(grasp.text,
                              stable(header(grasp.rows.size(), bare(text_of(*options.wrench))),
                                     bare(text_of(d)), shares),
                              options);
    ASSERT_EQ(outcome(answer), "accepted") << explain(answer) << "\n" << grasp.text;
    if (trial % 3 == 0) {
      options.uncertain = {{"friction", {Rational(1, 2), true}},
                           {"stiffness", {Rational(1, 2), true}},
                           {"preload", {Rational(1, 2), true}},
                           {"wrench", {Rational(between(random, 0, 1), 100), false}}};
      if (grasp.slips.size() < 2) {
        options.uncertain["position"] = {Rational(between(random, 0, 1), 50), false};
        options.uncertain["normal"] = {Rational(between(random, 0, 1), 50), false};
      }
    }
    Question question = pose(read(grasp.text), options, "grasp");
    if (question.is_box) enlarge(question);
    const Box& box = *question.box;
    Cone cone(n + 2);
    Strict strict;
    const auto cut = [&](const Vector& a, bool equality) {
      if (dot(a, x) > 0) insert(strict.conditions, cone.cuts());
      cone = cone.cut(make_form(a), equality);
    };
    Vector h(n + 2);
    h[n] = 1;
    cut(h, false);
    Vector l(n + 2);
    l[n + 1] = 1;
    cut(l, true);
    for (int cuts = between(random, 0, 5); cuts > 0; --cuts) {
      Vector a = small(random, n + 1);
      a.resize(n + 2);
      if (!grasp.rows.empty() && between(random, 0, 2) > 0) {
        const auto i = static_cast<std::size_t>(
            between(random, 0, static_cast<int>(grasp.rows.size()) - 1));
        a = grasp.rows[i].v;
        if (between(random, 0, 1) == 0 && grasp.rows[i].slips) {
          a = in_space ? grasp.slips[i][static_cast<std::size_t>(between(random, 0, 2))]
                       : grasp.rows[i].tangent;
          a.resize(n + 2);
        }
      }
      const int side = sgn(dot(a, x));
      for (Rational& c : a) c *= side < 0 ? -1 : 1;
      cut(a, side == 0 && between(random, 0, 1) == 0);
    }
    for (std::size_t i = 0; in_space && i < grasp.slips.size(); ++i) {
      const std::vector<Form>& rows = box.row(i).slips[0];
      const bool slips = std::any_of(rows.begin(), rows.end(), [&](const Form& s) {
        return sign_of_dot(s, make_form(x)) != 0;
      });
      if (slips && box.row(i).slip_certain) strict.slips.push_back(i);
    }
    const Generators region(box, cone, strict);
    ASSERT_FALSE(region.barred());
    for (int k = 0; k < 20; ++k) {
      const Vector y = small(random, n);
      ASSERT_TRUE(leaf_refusal(box, region, y)) << show(y) << " of " << grasp.text;
      ++leaves;
      // Under another load it may well hold.
      Box other = box;
      Vector w = box.load.lowest();
      for (std::size_t j = 0; j < n; ++j) w[j] -= y[j] / 2;
      other.load = Load({w.begin(), w.end()});
      tight += leaf_refusal(other, region, y) ? 0 : 1;
    }
  }
  EXPECT_GT(leaves, rounds(4000U));
  EXPECT_GT(tight, rounds(400U));
}

// ---- answers in closed form

TEST(Bodies, FalseProofOfASpringThatPulls) {
  const std::string grasp =
      slide({{"joints", R"([{"turns": {"l": 1}, "stiffness": 1}])"}, {"loads", load("0, 1")}});
  expect_outcome("accepted", grasp, stable(header(1, "1"), "1"));
  expect_outcome(
      "leaf-bound", grasp,
      refutation(header(1, "1"), {R"(["plane", 1, 0])", R"(["leaf", -1])", R"(["leaf", -1])"}));
}

// A spring pulls with a number of many digits; a load is the same, or more by next to nothing.
// What is rounded up is not to make the pull larger.
TEST(Bodies, RoundingUpMakesNoSpringPullMore) {
  Rational k;
  mpz_ui_pow_ui(k.get_num_mpz_t(), 3, 200);
  mpz_ui_pow_ui(k.get_den_mpz_t(), 7, 150);
  Rational more = k + Rational(1, Integer(1) << 400U);
  const std::string grasp =
      slide({{"joints", R"([{"turns": {"l": 1}, "torque": "-)" + k.get_str() + "\"}]"}});
  for (const Rational& pull : {k, more}) {
    Options options;
    options.wrench = Vector{pull};
    const std::string head = header(1, "\"" + pull.get_str() + "\"");
    expect_outcome("leaf-bound", grasp, refutation(head, {R"(["leaf", 1])"}), options);
    expect_outcome(pull == k ? "leaf-bound" : "accepted", grasp,
                   refutation(head, {R"(["leaf", -1])"}), options);
  }
}

/// A body without a joint, with a weight on a link, as FORMAT.md has it.
std::string body_on_a_link() {
  return slide(
      {{"bodies", R"([{"name": "b"}, {"name": "l", "slide": [0, 1]}])"},
       {"joints", R"([{"turns": {"l": 1}, "stiffness": 1}])"},
       {"contacts", R"([{"position": [0, 0], "normal": [0, 1], "friction": 0, "of": "b",
 "by": "l"}])"},
       {"loads", R"([{"body": "b", "weight": 1, "at": [0, 0]}])"}});
}

TEST(Bodies, FalseProofOfAContactThatPressesOneBody) {
  const std::string head = header(2, "0, -1, 0, 0");
  expect_outcome("accepted", body_on_a_link(), stable(head, "0, -2, 0, -1"));
  expect_outcome("witness-balance", body_on_a_link(), stable(head, "0, -1, 0, -1"));
  expect_outcome("leaf-bound", body_on_a_link(),
                 refutation(head, {R"(["leaf", 0, -1, 0, 0])"}));
}

/// The lower one on two contacts with the ground, the upper on two with the lower; each weighs
/// 2, and the upper is pushed where they meet.
std::string blocks(const std::string& push) {
  return R"({"format": "stickslip-grasp/3", "bodies": [{"name": "low"}, {"name": "high"}],
 "defaults": {"friction": "1/2"},
 "contacts": [{"position": [-1, 0], "normal": [0, 1], "of": "low"},
  {"position": [1, 0], "normal": [0, 1], "of": "low", "by": "ground"},
  {"position": [-1, 1], "normal": [0, 1], "of": "high", "by": "low"},
  {"position": [1, 1], "normal": [0, 1], "of": "high", "by": "low"}],
 "loads": [{"body": "low", "weight": 2, "at": [0, 0]}, {"body": "high", "weight": 2, "at": [0, 1]},
  {"body": "high", "force": [)" +
         push + R"(, 0], "at": [0, 1]}]})";
}

TEST(Bodies, ABlockOnABlockSlidesWhereCoulombSays) {
  // At most half of its weight. The lower one is turned by the pair of forces, and leans.
  const std::string shares = R"([0, "1/2"], [1, "1/2"], [2, 1], [3, 1])";
  const std::string at_most = header(4, R"(0, -2, 0, 1, -2, -1)");
  expect_outcome("accepted", blocks("1"),
                 stable(at_most, R"(0, -2, "-1/2", 0, -3, "-1/2")", shares));
  const std::vector<std::string> slides{R"(["leaf", 0, 0, 0, -2, -1, 0])"};
  expect_outcome("leaf-bound", blocks("1"), refutation(at_most, slides));
  const std::string beyond = header(4, R"(0, -2, 0, "101/100", -2, "-101/100")");
  expect_outcome("accepted", blocks("1.01"), refutation(beyond, slides));
  expect_outcome("witness-balance", blocks("1.01"),
                 stable(beyond, R"(0, -2, "-1/2", 0, -3, "-1/2")", shares));
}

TEST(Bodies, ALinkOnAHingeIsHeldByASpring) {
  // The torque -6 about (1, 0), per turn of the joint half of it: -3 + 1 - 2 z = 0.
  const std::string grasp =
      slide({{"bodies", R"([{"name": "l", "hinge": [1, 0], "on": "ground"}])"},
             {"joints", R"([{"turns": {"l": 0.5}, "stiffness": 2, "torque": 1}])"},
             {"loads", R"([{"body": "l", "force": [7, -3], "at": [3, 0]}])"}});
  expect_outcome("accepted", grasp, stable(header(1, "-3"), "-1"));
  expect_outcome("witness-balance", grasp, stable(header(1, "-3"), "1"));
  expect_outcome("accepted", grasp, stable(header(1, "-3", "bilateral"), "-1"), [] {
    Options options;
    options.bilateral = true;
    return options;
  }());
}

TEST(Bodies, ARatchetPushesAndDoesNotPull) {
  const auto grasp = [](const std::string& force) {
    return slide({{"ratchets", R"([{"over": {"l": 1}, "stiffness": 2, "preload": 1}])"},
                  {"loads", load("0, " + force)}});
  };
  const std::string leaf = R"(["leaf", -1])";
  expect_outcome("accepted", grasp("-5"), stable(header(1, "-5"), "-2"));
  expect_outcome("leaf-bound", grasp("-5"), refutation(header(1, "-5"), {leaf}));
  expect_outcome("witness-balance", grasp("1"), stable(header(1, "1"), "1"));
  expect_outcome("accepted", grasp("1"), refutation(header(1, "1"), {leaf}));
  const std::string separation = R"(["separation", 0])";
  expect_outcome("accepted", grasp("1"), refutation(header(1, "1"), {separation, leaf, leaf}));
  expect_outcome("node-contact", grasp("1"),
                 refutation(header(1, "1"), {R"(["slip", 0])", leaf, leaf, leaf}));
  expect_outcome("witness-share", grasp("-5"), stable(header(1, "-5"), "-2", "[0, 0]"));
  // A spring does not open.
  const std::string spring =
      slide({{"joints", R"([{"turns": {"l": 1}, "torque": 1}])"}, {"loads", load("0, 1")}});
  expect_outcome("accepted", spring, refutation(header(1, "1"), {leaf}));
  expect_outcome("node-contact", spring, refutation(header(1, "1"), {separation, leaf, leaf}));
  expect_outcome("witness-share", spring, stable(header(1, "1"), "0", "[0, 0]"));
}

TEST(Bodies, TheBilateralLawIsNotAboutSprings) {
  Options bilateral;
  bilateral.bilateral = true;
  // The spring pulls with 3, against the ratchet and a load.
  const auto grasp = [](const std::string& force) {
    return slide({{"ratchets", R"([{"over": {"l": 1}, "stiffness": 1, "preload": 4}])"},
                  {"joints", R"([{"turns": {"l": 1}, "torque": -3}])"},
                  {"loads", load("0, " + force)}});
  };
  const auto head = [](const std::string& force) { return header(2, force, "bilateral"); };
  // a = 3 - f = 4 - z.
  expect_outcome("accepted", grasp("2"), stable(head("2"), "3"), bilateral);
  expect_outcome("witness-normal", grasp("4"), stable(head("4"), "5"), bilateral);
  expect_outcome("accepted", grasp("4"), refutation(head("4"), {R"(["leaf", -1])"}), bilateral);
  const std::string part = R"({"twist": [3], "walls": [[E]], "direction": [[1]],
 "tree": [["leaf", 1], ["leaf", -1]]})";
  expect_outcome("accepted", grasp("2"), in_parts(head("2"), replaced(part, "E", "1")),
                 bilateral);
  expect_outcome("degree-law", grasp("2"), in_parts(head("2"), replaced(part, "E", "\"1/2\"")),
                 bilateral);
}

TEST(Bodies, ATendonOverTwoJoints) {
  const auto grasp = [](const std::string& second) {
    return slide(
        {{"bodies", R"([{"name": "l", "slide": [1, 0]}, {"name": "m", "slide": [1, 0]}])"},
         {"joints", R"([{"turns": {"l": 1}}, {"turns": {"m": 1}}])"},
         {"tendons", R"([{"over": {"l": 1, "m": -2}, "stiffness": 1, "tension": 3}])"},
         {"loads", R"([{"body": "l", "force": [2, 0], "at": [0, 0]},
 {"body": "m", "force": [)" +
                       second + R"(, 0], "at": [0, 5]}])"}});
  };
  // a (1, -2) balances (2, -4) with a = -2 = 3 - (z1 - 2 z2), and nothing that is no multiple.
  expect_outcome("accepted", grasp("-4"), stable(header(1, "2, -4"), "5, 0"));
  expect_outcome("accepted", grasp("-4"), stable(header(1, "2, -4"), "7, 1"));
  expect_outcome("leaf-bound", grasp("-4"),
                 refutation(header(1, "2, -4"), {R"(["leaf", -2, -1])"}));
  expect_outcome("accepted", grasp("-3"),
                 refutation(header(1, "2, -3"), {R"(["leaf", -2, -1])"}));
  // The motion (2, 1) is free, unless the load works on it.
  const std::string part =
      R"({"twist": [5, 0], "walls": [[1, -2]], "direction": [[1, -2], [-2, 4]],
 "tree": [["leaf", 1, 0], ["leaf", -1, 0]]})";
  expect_outcome("accepted", grasp("-4"), in_parts(header(1, "2, -4"), part));
  expect_outcome("degree-free", grasp("-3"), in_parts(header(1, "2, -3"), part));
}

/// A body that stands on a link, which a spring holds up; the normal has the length 2.
std::string in_space(const std::string& push) {
  return R"({"format": "stickslip-grasp/3",
 "bodies": [{"name": "b"}, {"name": "l", "slide": [0, 0, 1]}],
 "joints": [{"turns": {"l": 1}, "stiffness": 1}],
 "contacts": [{"position": [1, 2, 0], "normal": [0, 0, 2], "friction": 0.5, "stiffness": 4, "of": "b", "by": "l"}],
 "loads": [{"body": "b", "weight": 1, "at": [1, 2, 5]}, {"body": "b", "force": [)" +
         push + R"(, 0, 0], "at": [1, 2, 0]}]})";
}

TEST(Bodies, AContactInSpaceBetweenTwoBodies) {
  // Half of its weight at most. The contact gives by 1/4, the spring by 1.
  const std::string half = header(2, R"("1/2", 0, -1, -2, 1, -1, 0)");
  const std::string twist = R"(0, 0, "-5/4", 0, 0, 0, -1)";
  expect_outcome("accepted", in_space("0.5"), stable(half, twist, "[0, [-2, 0, 0]]"));
  expect_outcome("witness-share", in_space("0.5"), stable(half, twist, "[1, [0, 0, 0]]"));
  const std::vector<std::string> leaf{R"(["leaf", -2, 0, -1, 0, 0, 0, 0])"};
  expect_outcome("leaf-bound", in_space("0.5"), refutation(half, leaf));
  const std::string more = header(2, R"("51/100", 0, -1, -2, 1, "-51/50", 0)");
  expect_outcome("accepted", in_space("0.51"), refutation(more, leaf));
  // It slips, or it does not; a spring does neither.
  expect_outcome("accepted", in_space("0.51"),
                 refutation(more, {R"(["slip", 0])", leaf[0], leaf[0]}));
  expect_outcome("node-contact", in_space("0.51"),
                 refutation(more, {R"(["slip", 1])", leaf[0], leaf[0]}));
}

TEST(Bodies, ALinkInSpaceThatMustSlip) {
  // The normal force is 2, friction takes up from 1/2 to 1 of the load 3, and the spring the
  // rest: z is from 1 to 5/2, and at all of these friction is against the slip.
  const std::string grasp =
      slide({{"bodies", R"([{"name": "l", "slide": [1, 0, 0]}])"},
             {"joints", R"([{"turns": {"l": 1}, "stiffness": {"min": 1, "max": 2}}])"},
             {"contacts", R"([{"position": [{"min": 0, "max": 1}, 0, 0], "normal": [0, 0, 2],
 "friction": {"min": 0.25, "max": 0.5}, "preload": 2, "of": "l"}])"},
             {"loads", R"([{"body": "l", "force": [3, 1, 1], "at": [4, 5, 6]}])"}});
  const std::string head = header(2, "3");
  const std::string part = R"({"twist": ["7/4"], "walls": [["4/5"]], "direction": [[1]],
 "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]})";
  expect_outcome("accepted", grasp, in_parts(head, part));
  expect_outcome("leaf-bound", grasp, in_parts(head, replaced(part, "4/5", "4/3")));  // to 5/2
  expect_outcome("leaf-bound", grasp, in_parts(head, replaced(part, "7/4", "9/4")));  // from 1
  // Where it need not slip, it may stick.
  const std::vector<std::string> sides{R"(["plane", 1, 0])", R"(["leaf", 1])",
                                       R"(["leaf", -1])"};
  expect_outcome("leaf-bound", grasp, refutation(head, sides));
  expect_outcome("node-certain", grasp,
                 refutation(head, {R"(["slip", 0])", R"(["leaf", 1])", R"(["leaf", -1])"}));
  // A contact of two bodies that move as one presses and rubs for nobody.
  const std::string inside =
      replaced(replaced(replaced(grasp, R"("slide": [1, 0, 0]})",
                                 R"("slide": [1, 0, 0]}, {"name": "k", "slide": [1, 0, 0]})"),
                        R"("of": "l")", R"("of": "l", "by": "k")"),
               R"("turns": {"l": 1})", R"("turns": {"l": 1, "k": 1})");
  const std::string free = R"({"twist": ["9/4"], "walls": [["4/5"]], "direction": [[1]],
 "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]})";
  expect_outcome("accepted", inside, in_parts(head, free));  // z from 3/2 to 3
  expect_outcome("leaf-bound", grasp, in_parts(head, free));
}

/// A link that slides on a contact with the normal force 2 and is pulled back by a torque of 3.
std::string dragged(const std::string& torque = "-3") {
  return slide(
      {{"bodies", R"([{"name": "l", "slide": [1, 0]}])"},
       {"joints", R"([{"turns": {"l": 1}, "torque": )" + torque + "}]"},
       {"contacts", R"([{"position": [0, 0], "normal": [0, 1], "friction": 0.5, "preload": 2,
 "of": "l"}])"}});
}

TEST(Bodies, AMarginInThePlane) {
  // Friction takes up 1: exactly the multiples from 2 to 4.
  Options along;
  along.direction = Vector{1};
  const std::string below = R"(["unstable", 0, 2, [["leaf", 1]]])";
  const std::string between = R"(["stable", 2, 4, {"twist": [0], "shares": [[0, -1]]},
 {"twist": [0], "shares": [[0, 1]]}])";
  const std::string above = R"(["unstable", 4, null, [["leaf", -1]]])";
  const Answer answer =
      ask(dragged(), margin(2, "1", below + ", " + between + ", " + above), along);
  ASSERT_EQ(outcome(answer), "accepted") << explain(answer);
  const Accepted& accepted = std::get<Accepted>(answer);
  ASSERT_EQ(accepted.resisted.size(), 1U);
  EXPECT_EQ(accepted.resisted[0].low, 2);
  EXPECT_EQ(accepted.resisted[0].high, Rational(4));
  ASSERT_EQ(accepted.refuted.size(), 2U);
  EXPECT_FALSE(accepted.refuted[0].open_low);
  const auto fails = [&](const std::string& rule, const std::string& claim) {
    expect_outcome(rule, dragged(), margin(2, "1", claim), along);
  };
  fails("leaf-bound", replaced(below, "0, 2", "0, \"201/100\""));
  fails("leaf-bound", replaced(above, "4", "\"399/100\""));
  fails("witness-balance", replaced(between, "2, 4", "2, 5"));
  fails("witness-share", replaced(between, "[0, -1]", "[0, -2]"));
  fails("interval-whole", R"(["stable", 0, null, {"twist": [0], "shares": []}])");
  const std::string rest =
      R"(["stable", LOW, HIGH, {"rest": [], "answers": [[0, [-1]]], "reach": [1]}])";
  fails("accepted", replaced(replaced(rest, "LOW", "2"), "HIGH", "4"));
  fails("rest-reach", replaced(replaced(rest, "LOW", "\"199/100\""), "HIGH", "4"));
  fails("rest-cone",
        replaced(replaced(replaced(rest, "LOW", "2"), "HIGH", "4"), "[1]}", "[\"101/100\"]}"));
  fails("rest-share",
        replaced(replaced(replaced(rest, "LOW", "2"), "HIGH", "4"), "[[0,", "[[1,"));
  // The spring alone grows: 1 and 3 times -1 against the load 2.
  Options torque;
  torque.wrench = Vector{2};
  torque.preload_direction = PreloadDirection{false, {0, -1}};
  const std::string growing =
      R"({"format": "stickslip-certificate/2", "question": {"contacts": 2,
 "wrench": [2], "normal_law": "unilateral", "preload_direction": [0, -1]}, "verdict": "margin",
 "intervals": [["unstable", 0, 1, [["leaf", -1]]],
  ["stable", 1, 3, {"twist": [0], "shares": [[0, 1]]}, {"twist": [0], "shares": [[0, -1]]}],
  ["unstable", 3, null, [["leaf", 1]]]]})";
  expect_outcome("accepted", dragged("0"), growing, torque);
  const std::string beyond = growing.substr(0, growing.find("[[\"unstable\"")) +
                             R"([["unstable", LOW, null, [["leaf", 1]]]]})";
  expect_outcome("accepted", dragged("0"), replaced(beyond, "LOW", "3"), torque);
  expect_outcome("leaf-bound", dragged("0"), replaced(beyond, "LOW", "\"299/100\""), torque);
  // All preloads grow, that of the spring as well: without a load, (3 - 1) l is never held.
  Options scaled;
  scaled.preload_direction = PreloadDirection{true, {}};
  const std::string scale = R"({"format": "stickslip-certificate/2", "question": {"contacts": 2,
 "wrench": [0], "normal_law": "unilateral", "preload_direction": "scale"}, "verdict": "margin",
 "intervals": [["unstable", 0, null, [["leaf", 1]]]]})";
  expect_outcome("accepted", dragged(), scale, scaled);
  expect_outcome("leaf-bound", dragged("-1"), scale, scaled);
}

TEST(Bodies, ASpringThatPushesAndPullsIsOneMode) {
  // l - 2 - z = 0: from 2 to -2.
  const std::string grasp =
      slide({{"joints", R"([{"turns": {"l": 1}, "stiffness": 1}])"}, {"ratchets", "[]"}});
  Options along;
  along.direction = Vector{1};
  along.wrench = Vector{-2};
  const std::string claim = R"(["stable", 0, 4, {"twist": [-2], "shares": []},
 {"twist": [2], "shares": []}])";
  const std::string whole =
      replaced(margin(1, "1", claim), "\"wrench\": [0]", "\"wrench\": [-2]");
  expect_outcome("accepted", grasp, whole, along);
  // A ratchet that opens between has another mode.
  const std::string ratchet =
      replaced(grasp, "\"ratchets\": []",
               R"("ratchets": [{"over": {"l": 1}, "stiffness": 1, "preload": 1}])");
  expect_outcome("segment-mode", ratchet,
                 replaced(replaced(replaced(whole, "\"contacts\": 1", "\"contacts\": 2"),
                                   "[-2], \"shares\"", "[\"-1/2\"], \"shares\""),
                          "[2], \"shares\"", "[2], \"shares\""),
                 along);
}

TEST(Bodies, AtRestWithAnUncertainSpringThatPulls) {
  const std::string grasp = dragged(R"({"min": -1, "max": 0})");
  const std::string rest =
      R"({"rest": [[0, "-1/2"]], "answers": [[0, [-1]]], "reach": ["1/2"]})";
  const std::string head = header(2, "0");
  expect_outcome("accepted", grasp, in_parts(head, rest));
  expect_outcome("rest-reach", grasp, in_parts(head, replaced(rest, "[\"1/2\"]", "[\"2/5\"]")));
  expect_outcome("rest-reach", grasp, in_parts(head, replaced(rest, "[[0, \"-1/2\"]]", "[]")));
  expect_outcome(
      "rest-cone", dragged(R"({"min": "-3/2", "max": 0})"),
      in_parts(head, replaced(replaced(rest, "-1/2", "-3/4"), "[\"1/2\"]", "[\"3/4\"]")));
}

TEST(Bodies, ABoxWithAnUncertainRatchet) {
  // Pulled, it is open at all of them; pushed by 1, z is (P - 1) / k, from -1 to 0.
  const auto grasp = [](const std::string& force) {
    return slide({{"ratchets", R"([{"over": {"l": 1}, "stiffness": {"min": 1, "max": 2},
 "preload": {"min": 0, "max": 1}}])"},
                  {"loads", load("0, " + force)}});
  };
  expect_outcome("accepted", grasp("1"), refutation(header(1, "1"), {R"(["leaf", -1])"}));
  expect_outcome(
      "accepted", grasp("1"),
      refutation(header(1, "1"), {R"(["part", "stiffness", 0, "3/2"])", R"(["leaf", -1])",
                                  R"(["plane", 1, 0])", R"(["leaf", -1])", R"(["leaf", -1])"}));
  expect_outcome("leaf-bound", grasp("-1"), refutation(header(1, "-1"), {R"(["leaf", 1])"}));
  const std::string part = R"({"twist": ["-1/2"], "walls": [["4/5"]], "direction": [[1]],
 "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]})";
  expect_outcome("accepted", grasp("-1"), in_parts(header(1, "-1"), part));
  expect_outcome("leaf-bound", grasp("-1"),
                 in_parts(header(1, "-1"), replaced(part, "\"4/5\"", "2")));
}

TEST(Bodies, AMarginInThePlaneWithANormalOfIrrationalLength) {
  // z = 16/sqrt(2) - l: of l > 0 alone there is no other.
  const std::string grasp = slide(
      {{"bodies", R"([{"name": "l", "slide": [1, 0]}])"},
       {"contacts", R"([{"position": [0, 0], "normal": [1, 1], "friction": 0, "stiffness": 2,
 "preload": 16, "of": "l"}])"}});
  Options along;
  along.direction = Vector{-1};
  const std::string claim = R"(["stable", "1/2", 1, {"twist": [11], "walls": [["1/2"]],
 "direction": [[1]], "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]}])";
  expect_outcome("accepted", grasp, margin(1, "-1", claim), along);
  expect_outcome("leaf-bound", grasp, margin(1, "-1", replaced(claim, "[11]", "[8]")), along);
  expect_outcome("leaf-bound", grasp, margin(1, "-1", replaced(claim, "\"1/2\", 1", "0, 1")),
                 along);
  expect_outcome("witness-box", grasp,
                 margin(1, "-1", R"(["stable", 1, 1, {"twist": [10], "shares": []}])"), along);
  // Of a preload that grows, against the load 1: z = 16/sqrt(2) l - 1.
  const std::string none = replaced(grasp, "\"preload\": 16", "\"preload\": 0");
  Options growing;
  growing.wrench = Vector{-1};
  growing.preload_direction = PreloadDirection{false, {16}};
  const auto grown = [](const std::string& of) {
    return R"({"format": "stickslip-certificate/2", "question": {"contacts": 1, "wrench": [-1],
 "normal_law": "unilateral", "preload_direction": [16]}, "verdict": "margin", "intervals": [)" +
           of + "]}\n";
  };
  const std::string one = R"(["stable", 1, 1, {"twist": ["21/2"], "walls": [["2/3"]],
 "direction": [[1]], "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]}])";
  expect_outcome("accepted", none, grown(one), growing);
  expect_outcome("leaf-bound", none, grown(replaced(one, "1, 1", "1, 2")), growing);
  expect_outcome("leaf-bound", none, grown(replaced(one, "2/3", "6")), growing);
  // Where it pulls, nothing holds it, whatever its length.
  along.direction = Vector{1};
  expect_outcome("accepted", grasp, margin(1, "1", R"(["unstable", 1, null, [["leaf", -1]]])"),
                 along);
}

TEST(Bodies, ABoxWithAnUncertainSpring) {
  // z = (1 + tau) / kappa, from 0 to 2.
  const std::string grasp = slide(
      {{"joints",
        R"([{"turns": {"l": 1}, "stiffness": {"min": 1, "max": 2}, "torque": {"min": -1, "max": 1}}])"},
       {"loads", load("0, 1")}});
  const std::string head = header(1, "1");
  const std::string part = R"({"twist": [1], "walls": [["1/2"]], "direction": [[1]],
 "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]})";
  expect_outcome("accepted", grasp, in_parts(head, part));
  expect_outcome("leaf-bound", grasp, in_parts(head, replaced(part, "\"1/2\"", "1")));
  expect_outcome("witness-box", grasp, stable(head, "1"));
  const auto cut = [&](const std::string& by, const std::string& first,
                       const std::string& second) {
    return in_parts(head, by + ", " + first + ", " + second);
  };
  expect_outcome("accepted", grasp, cut(R"(["part", "preload", 0, 0])", part, part));
  // Of the torques above 0 alone z is from 1/2 to 2, else up to 1.
  const std::string high = replaced(replaced(part, "[1]", "[\"3/2\"]"), "\"1/2\"", "\"4/5\"");
  const std::string low = replaced(replaced(part, "[1]", "[\"1/2\"]"), "\"1/2\"", "\"4/3\"");
  expect_outcome("accepted", grasp, cut(R"(["part", "preload", 0, 0])", low, high));
  expect_outcome("leaf-bound", grasp, cut(R"(["part", "preload", 0, 0])", high, high));
  expect_outcome("part-contact", grasp, cut(R"(["part", "friction", 0, 0])", part, part));
  expect_outcome("part-contact", grasp, cut(R"(["part", "x", 0, 0])", part, part));
  expect_outcome("part-contact", grasp, cut(R"(["part", "wrench", 1, 0])", part, part));
  expect_outcome("part-inside", grasp, cut(R"(["part", "stiffness", 0, 2])", part, part));
  // At the stiffness 0 a torque of its own never balances the load.
  const std::string loose =
      replaced(replaced(grasp, R"({"min": 1, "max": 2})", "0"), R"({"min": -1, "max": 1})",
               R"({"min": "-1/2", "max": 1})");
  expect_outcome("accepted", loose, refutation(head, {R"(["leaf", -1])"}));
  expect_outcome("leaf-bound", replaced(loose, "-1/2", "-1"),
                 refutation(head, {R"(["leaf", -1])"}));
}

TEST(Bodies, AnUncertainWrenchOnABody) {
  const std::string grasp = slide(
      {{"bodies", R"([{"name": "b"}])"},
       {"joints", "[]"},
       {"loads",
        R"([{"body": "b", "wrench": [{"min": 0, "max": 1}, 1, 0]}, {"body": "b", "torque": 2}])"}});
  const std::string head = header(0, "[0, 1], 1, 2");
  expect_outcome("accepted", grasp, refutation(head, {R"(["leaf", 0, -1, 0])"}));
  expect_outcome("leaf-bound", grasp, refutation(head, {R"(["leaf", -1, 0, 0])"}));
  expect_outcome("question-wrench", grasp,
                 refutation(header(0, "0, 1, 2"), {R"(["leaf", 0, -1, 0])"}));
  expect_outcome("malformed", grasp, refutation(header(0, "0, 1"), {}));
}

TEST(Bodies, TheCornersOfAnUncertainContactOfALink) {
  // A link on a hinge at the origin, held at (x, 0) from below: N = x, v = -x r, and the torque
  // -x^2 r + w = 0. Its slip T = 0 is certain, and N is not.
  const std::string grasp = slide(
      {{"bodies", R"([{"name": "l", "hinge": [0, 0]}])"},
       {"contacts", R"([{"position": [{"min": 1, "max": 2}, 0], "normal": [0, 1], "friction": 1,
 "of": "l"}])"},
       {"loads", R"([{"body": "l", "torque": -4}])"}});
  const std::string head = header(1, "-4");
  // r from -4 to -1.
  const std::string part = R"({"twist": ["-5/2"], "walls": [["1/2"]], "direction": [[1]],
 "tree": [["leaf", 1], ["leaf", -1], ["leaf", 1], ["leaf", -1]]})";
  expect_outcome("accepted", grasp, in_parts(head, part));
  expect_outcome("leaf-bound", grasp, in_parts(head, replaced(part, "\"1/2\"", "1")));
  const std::vector<std::string> leaves(3, R"(["leaf", 1])");
  expect_outcome("leaf-bound", grasp,
                 refutation(head, {R"(["slip", 0])", leaves[0], leaves[1], leaves[2]}));
  expect_outcome("node-certain", grasp,
                 refutation(head, {R"(["separation", 0])", leaves[0], leaves[1]}));
  expect_outcome("accepted", replaced(grasp, "-4", "4"),
                 refutation(header(1, "4"), {R"(["leaf", -1])"}));
}

}  // namespace
}  // namespace stickslip_check
