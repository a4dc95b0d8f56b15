// SPDX-License-Identifier: MIT
// Grasps of several bodies (FORMAT.md §14): rows against velocities that are found another way,
// and leaves against equilibria. What files may say, and answers in closed form, are for
// tests/rules.
#include "bodies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "leaf.hpp"
#include "question.hpp"
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

std::string stable(const std::string& head, const std::string& twist,
                   const std::string& shares = "") {
  return head + R"( "verdict": "stable", "twist": [)" + twist + R"(], "shares": [)" + shares +
         "]}\n";
}

void expect_outcome(const std::string& expected, const std::string& grasp,
                    const std::string& certificate, const Options& options = {}) {
  const Answer answer = ask(grasp, certificate, options);
  EXPECT_EQ(outcome(answer), expected) << explain(answer) << "\n" << certificate;
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

// ---- rows, and leaves, against velocities

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

/// FORMAT.md §1; of what does not slip, the tangent is 0.
struct NaiveRow {
  Vector normal;
  Vector tangent;
  Rational friction;
  Vector v;  ///< while it is made, the stiffness and the preload
  bool slips = true;
  bool spring = false;
};

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

}  // namespace
}  // namespace stickslip_check
