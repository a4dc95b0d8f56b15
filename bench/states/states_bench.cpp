// SPDX-License-Identifier: GPL-3.0-or-later
// Seconds and memory of states in space: slip states of contacts in general position, counted
// and with a motion each, and of a cube between six walls, where most planes depend on others;
// contact modes of contacts in a bowl, from below on one side.
//
//     states_bench [rounds, default 1]
//
// Each measurement runs in a process of its own: best processor time of the rounds, and how far
// the peak of its resident memory lies above what it was before. One thread, unless the row
// says otherwise.
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "child.hpp"
#include "stickslip/arrangement/contact_states.hpp"

namespace stickslip::bench {
namespace {

/// Contacts and their lines of slip.
struct Scene {
  GraspBox grasp;
  SlipLines lines;
};

int between(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

RationalRow random_row(std::mt19937& random) {
  RationalRow row;
  for (int j = 0; j < 3; ++j) row.emplace_back(between(random, -100, 100));
  return row;
}

void add_contact(Scene& scene, const RationalRow& position, const RationalRow& normal) {
  UncertainContact contact;
  for (const Rational& x : position) contact.position.push_back(point_interval(x));
  contact.normal = normal;
  scene.grasp.contacts.push_back(std::move(contact));
}

/// Adds a contact with lines of slip in random directions.
void add_contact(Scene& scene, std::mt19937& random, const RationalRow& position,
                 const RationalRow& normal, std::size_t lines) {
  add_contact(scene, position, normal);
  auto& given = scene.lines.given->emplace_back();
  for (std::size_t j = 0; j < lines; ++j) {
    const Vector3 v = cross(vector3(normal), vector3(random_row(random)));
    given.push_back({v[0], v[1], v[2]});
  }
}

Scene empty_scene() {
  Scene scene;
  scene.grasp.wrench.resize(6);
  scene.lines.given.emplace();
  return scene;
}

Scene random_scene(std::size_t contacts, std::size_t lines) {
  std::mt19937 random(1);
  Scene scene = empty_scene();
  for (std::size_t i = 0; i < contacts; ++i) {
    const RationalRow position = random_row(random);
    add_contact(scene, random, position, random_row(random), lines);
  }
  return scene;
}

/// Contacts of a round body that lies in a bowl: normals lean towards the middle.
Scene bowl(std::size_t contacts, std::size_t lines) {
  std::mt19937 random(1);
  Scene scene = empty_scene();
  for (std::size_t i = 0; i < contacts; ++i) {
    RationalRow position = random_row(random);
    const RationalRow normal{-position[0], -position[1], 120 + between(random, 0, 20)};
    position[2] = (position[0] * position[0] + position[1] * position[1]) / 100 +
                  between(random, -10, 10);
    add_contact(scene, random, position, normal, lines);
  }
  return scene;
}

/// A cube between six walls, with contacts at the four corners of each of its faces.
Scene cube(std::size_t lines) {
  Scene scene = empty_scene();
  scene.lines.given.reset();
  scene.lines.count = lines;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      for (const int a : {-1, 1}) {
        for (const int b : {-1, 1}) {
          RationalRow position(3);
          RationalRow normal(3);
          position[axis] = side;
          position[(axis + 1) % 3] = a;
          position[(axis + 2) % 3] = b;
          normal[axis] = -side;
          add_contact(scene, position, normal);
        }
      }
    }
  }
  return scene;
}

void measure(const char* name, const Scene& scene, StateSet set, int rounds) {
  const StatePlanes planes =
      state_planes(6, contact_rows_for_states(scene.grasp, scene.lines), set);
  const auto print = [&](const char* task, const ChildMeasurement& found) {
    const double states = static_cast<double>(found.result);
    std::printf(
        "%-24s %3zu contacts %4zu planes  %-22s %9zu states  %9.4f s  %7.3f us  %4zu MB\n",
        name, planes.contacts.size(), planes.planes.size(), task, found.result, found.seconds,
        found.seconds * 1e6 / states, found.peak_bytes >> 20);
    std::fflush(stdout);
  };
  print("counted",
        measure_in_child([&] { return count_faces(6, planes.planes).total(); }, rounds));
  print("with a motion each", measure_in_child(
                                  [&] {
                                    std::size_t motions = 0;
                                    LongWord words[6];
                                    visit_faces(6, planes.planes, [&](const Face& face) {
                                      if (!face.motion_in_words(words)) face.motion();
                                      ++motions;
                                      return true;
                                    });
                                    return motions;
                                  },
                                  rounds));
}

}  // namespace
}  // namespace stickslip::bench

int main(int argc, char** argv) {
  using namespace stickslip;
  using namespace stickslip::bench;
  stickslip::bench::Arguments arguments(
      "states_bench", "Seconds and memory of slip states and contact modes in space.");
  stickslip::Command& app = arguments.described();
  int rounds = 1;
  app.add_option("ROUNDS", rounds, "Times that each is measured")->capture_default_str();
  if (const auto code = arguments.read(argc, argv)) return *code;
  measure("slip, general position", random_scene(6, 2), StateSet::kSlip, rounds);
  measure("slip, general position", random_scene(10, 2), StateSet::kSlip, rounds);
  measure("slip, general position", random_scene(6, 8), StateSet::kSlip, rounds);
  measure("slip, general position", random_scene(18, 2), StateSet::kSlip, rounds);
  measure("slip, cube in a box", cube(4), StateSet::kSlip, rounds);
  for (const std::size_t contacts : {10, 30}) {
    measure("cs in a bowl", bowl(contacts, 2), StateSet::kOpening, rounds);
    measure("ss in a bowl", bowl(contacts, 2), StateSet::kContact, rounds);
  }
}
