// SPDX-License-Identifier: GPL-3.0-or-later
// What every engine in C++ is put through: 1 s under a load that must hold, 0.25 s from there
// to the load of the case, 3 s under that. Cases come a line each, and so do their results;
// run.py writes and reads them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace conformance {

struct Vec {
  double x = 0, y = 0;
};
inline Vec operator+(Vec a, Vec b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec operator*(double s, Vec a) {
  return {s * a.x, s * a.y};
}
inline double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y;
}

/// Force, and torque about the centre of mass.
struct Load {
  Vec force;
  double torque = 0;
};

struct Obstacle {
  std::vector<Vec> shape;  ///< convex, counterclockwise
  Vec point, normal;       ///< where it touches the body, and the unit normal towards it
  double friction = 0;
  bool tip = false;
};

/// Mass 1; the centre of mass at the origin. A disc has no vertices.
struct Case {
  std::string name;
  std::vector<Vec> vertices;
  double radius = 0, inertia = 0;
  std::vector<Obstacle> obstacles;
  Load settle, load;
};

struct State {
  Vec position;
  double angle = 0;
  Vec velocity;
  double spin = 0;
};

/// On the body; the normal points into it.
struct ContactForce {
  Vec position, normal, force;
  double friction = 0;
};

/// Lengths times `scale`, forces too: time stays. Obstacles stand back by `gap`, which is the
/// distance that the engine keeps between shapes at rest (negative: by how much they overlap).
inline Case read_case(const nlohmann::json& line, double scale, double gap) {
  const auto vec = [&](const nlohmann::json& v, double s) {
    return Vec{s * v[0].get<double>(), s * v[1].get<double>()};
  };
  const auto load = [&](const nlohmann::json& w) {
    return Load{vec(w, scale), scale * scale * w[2].get<double>()};
  };
  Case c;
  c.name = line["name"];
  for (const auto& v : line["vertices"]) c.vertices.push_back(vec(v, scale));
  c.radius = scale * line["radius"].get<double>();
  c.inertia = scale * scale * line["inertia"].get<double>();
  for (const auto& o : line["obstacles"]) {
    Obstacle obstacle;
    obstacle.normal = vec(o["normal"], 1);
    const Vec back = -gap * obstacle.normal;
    for (const auto& v : o["shape"]) obstacle.shape.push_back(vec(v, scale) + back);
    obstacle.point = vec(o["point"], scale) + back;
    obstacle.friction = o["friction"];
    obstacle.tip = o["tip"];
    c.obstacles.push_back(obstacle);
  }
  c.settle = load(line["settle"]);
  c.load = load(line["load"]);
  return c;
}

/// How many times its own number of iterations an engine is to make: STICKSLIP_ITERATIONS,
/// or 1.
inline int iterations() {
  const char* times = std::getenv("STICKSLIP_ITERATIONS");
  return times == nullptr ? 1 : std::atoi(times);
}

/// The samples of one case: step(share) with how far the load has gone from `settle` to `load`,
/// then sample(), eight times a second from the end of settling on.
template <class Step, class Sample>
nlohmann::json put_through(int rate, const Step& step, const Sample& sample) {
  const double settling = 1, ramp = 0.25, end = 4.25;
  nlohmann::json samples = nlohmann::json::array();
  const int steps = static_cast<int>(std::lround(end * rate));
  for (int i = 1; i <= steps; ++i) {
    step(std::clamp((i / double(rate) - settling) / ramp, 0.0, 1.0));
    if (i < settling * rate || (8 * i) / rate == (8 * (i - 1)) / rate) continue;
    samples.push_back(sample());
    samples.back()["t"] = i / double(rate);
  }
  return samples;
}

/// A World is made of a case and a time step; it has `step(load)`, `state()` and `contacts()`,
/// and says `scale` and, of a disc or a polygon, `gap(is_disc)`. Called as PROGRAM
/// STEPS_PER_SECOND.
template <class World>
int run(int argc, char** argv) {
  const int rate = argc > 1 ? std::atoi(argv[1]) : 60;
  for (std::string text; std::getline(std::cin, text);) {
    const nlohmann::json line = nlohmann::json::parse(text);
    const Case c = read_case(line, World::scale, World::gap(line["vertices"].empty()));
    World world(c, 1.0 / rate);
    const auto step = [&](double share) {
      world.step({c.settle.force + share * (c.load.force - c.settle.force),
                  c.settle.torque + share * (c.load.torque - c.settle.torque)});
    };
    const auto sample = [&] {
      const State s = world.state();
      nlohmann::json contacts = nlohmann::json::array();
      for (const ContactForce& f : world.contacts())
        contacts.push_back({f.position.x / World::scale, f.position.y / World::scale,
                            f.normal.x, f.normal.y, f.force.x / World::scale,
                            f.force.y / World::scale, f.friction});
      return nlohmann::json{
          {"pose", {s.position.x / World::scale, s.position.y / World::scale, s.angle}},
          {"velocity", {s.velocity.x / World::scale, s.velocity.y / World::scale, s.spin}},
          {"contacts", contacts}};
    };
    std::cout
        << nlohmann::json{{"name", c.name}, {"samples", put_through(rate, step, sample)}}.dump()
        << '\n';
  }
  return 0;
}

}  // namespace conformance
