// SPDX-License-Identifier: GPL-3.0-or-later
// What every engine in C++ is put through in space: as protocol.hpp says.
#pragma once

#include <array>

#include "protocol.hpp"

namespace conformance::solid {

using Vec = std::array<double, 3>;
inline Vec operator+(Vec a, Vec b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec operator-(Vec a, Vec b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec operator*(double s, Vec a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(Vec a, Vec b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Force, and torque about the centre of mass.
struct Load {
  Vec force{}, torque{};
};

struct Obstacle {
  std::vector<Vec> shape;  ///< the corners of a slab
  Vec point, normal;       ///< of its face that touches the body, the unit normal towards it
  double friction = 0;
};

/// Mass 1; the centre of mass at the origin; `inertia` about the axes, which are principal.
struct Case {
  std::string name;
  std::vector<Vec> vertices;
  Vec inertia;
  std::vector<Obstacle> obstacles;
  Load settle, load;
};

struct State {
  Vec position;
  std::array<double, 4> turned;  ///< a quaternion x, y, z, w
};

/// On the body; the normal points into it.
struct ContactForce {
  Vec position, normal, force;
  double friction = 0;
};

/// Obstacles stand back by `gap`, which is the distance that the engine keeps at rest.
inline Case read_case(const nlohmann::json& line, double gap) {
  const auto load = [](const nlohmann::json& w) {
    return Load{{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
  };
  Case c{line["name"], line["vertices"],     line["inertia"],
         {},           load(line["settle"]), load(line["load"])};
  for (const auto& o : line["obstacles"]) {
    Obstacle obstacle{o["shape"], o["point"], o["normal"], o["friction"]};
    const Vec back = gap * obstacle.normal;
    for (Vec& v : obstacle.shape) v = v - back;
    obstacle.point = obstacle.point - back;
    c.obstacles.push_back(obstacle);
  }
  return c;
}

/// A World is made of a case and a time step; it has `step(load)`, `state()` and `contacts()`,
/// and says `gap`. Called as PROGRAM STEPS_PER_SECOND.
template <class World>
int run(int argc, char** argv) {
  const int rate = argc > 1 ? std::atoi(argv[1]) : 60;
  for (std::string text; std::getline(std::cin, text);) {
    const Case c = read_case(nlohmann::json::parse(text), World::gap);
    World world(c, 1.0 / rate);
    const auto step = [&](double share) {
      world.step({(1 - share) * c.settle.force + share * c.load.force,
                  (1 - share) * c.settle.torque + share * c.load.torque});
    };
    const auto sample = [&] {
      const State s = world.state();
      const auto& [p, q] = s;
      nlohmann::json contacts = nlohmann::json::array();
      for (const ContactForce& f : world.contacts())
        contacts.push_back({f.position[0], f.position[1], f.position[2], f.normal[0],
                            f.normal[1], f.normal[2], f.force[0], f.force[1], f.force[2],
                            f.friction});
      return nlohmann::json{{"pose", {p[0], p[1], p[2], q[0], q[1], q[2], q[3]}},
                            {"contacts", contacts}};
    };
    std::cout
        << nlohmann::json{{"name", c.name}, {"samples", put_through(rate, step, sample)}}.dump()
        << '\n';
  }
  return 0;
}

}  // namespace conformance::solid
