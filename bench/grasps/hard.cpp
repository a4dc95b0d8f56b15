// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "random_source.hpp"
#include "stickslip/core/contact_row.hpp"

namespace stickslip::bench {
namespace {

const Rational kNano(1, 1000000000);

/// The unit vector at about 2 t from (1, 0).
Vector2 turn_by(const Rational& t) {
  const Rational scale = 1 + t * t;
  return {(1 - t * t) / scale, 2 * t / scale};
}

std::vector<Contact> contacts_of(Layout layout, std::size_t contacts, std::uint64_t seed) {
  return make_grasp(layout, contacts, true, seed).contacts();
}

std::vector<Contact> floor(RandomSource& random, std::size_t contacts) {
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c;
    c.position = {Rational(random.between(-2000, 2000), 1000), -1};
    c.normal = {0, 1};
    c.friction = Rational(random.between(0, 9), 10);
    c.stiffness = random.between(1, 5);
    c.preload = Rational(random.between(0, 8), 4);
    result.push_back(std::move(c));
  }
  return result;
}

std::vector<Contact> facing_pairs(RandomSource& random, std::size_t contacts) {
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c;
    if (i % 2 == 0) {
      c.position = {Rational(random.between(-2000, 2000), 1000),
                    Rational(random.between(-2000, 2000), 1000)};
      c.normal = random.pick(unit_directions());
      c.friction = Rational(random.between(1, 9), 10);
      c.stiffness = random.between(1, 5);
      c.preload = Rational(random.between(1, 8), 4);
    } else {
      c = result.back();
      // The plate is 1/10 thick.
      c.position.x += c.normal.x / 10;
      c.position.y += c.normal.y / 10;
      c.normal = {-c.normal.x, -c.normal.y};
    }
    result.push_back(std::move(c));
  }
  return result;
}

std::vector<Contact> wheel(std::size_t contacts) {
  const std::vector<Vector2>& all = unit_directions();
  std::vector<Contact> result;
  for (std::size_t i = 0; i < contacts; ++i) {
    Contact c;
    c.normal = all[(i * all.size() / contacts) % all.size()];
    // The wheel's hub is not the origin, so that motions have no symmetry to hide behind.
    c.position = {Rational(1, 3) - c.normal.x, Rational(1, 7) - c.normal.y};
    c.friction = Rational(1, 2);
    c.preload = 1;
    result.push_back(std::move(c));
  }
  return result;
}

Rational power_of(const Rational& base, std::size_t exponent) {
  Rational result = 1;
  for (std::size_t k = 0; k < exponent; ++k) result *= base;
  return result;
}

std::vector<Contact> make_contacts(HardFamily family, RandomSource& random,
                                   std::size_t contacts, std::uint64_t seed) {
  std::vector<Contact> result = contacts_of(Layout::kArc, contacts, seed);
  switch (family) {
    case HardFamily::kFrictionless:
      for (Contact& c : result) c.friction = 0;
      return result;
    case HardFamily::kHalfFrictionless:
      for (std::size_t i = 0; i < contacts; i += 2) result[i].friction = 0;
      return result;
    case HardFamily::kNearlyParallel:
      result = floor(random, contacts);
      for (Contact& c : result) {
        c.normal = rotated(c.normal, turn_by(random.between(-8, 8) * kNano / 8));
        c.position.y += random.between(-8, 8) * kNano;
      }
      return result;
    case HardFamily::kNearlyCoincident:
      result = contacts_of(Layout::kEdges, contacts, seed);
      for (Contact& c : result) {
        const Rational off = random.between(-8, 8) * kNano;
        c.position.x += off * c.normal.x;
        c.position.y += off * c.normal.y;
      }
      return result;
    case HardFamily::kStiffness:
      for (Contact& c : result) c.stiffness = random.pick<Rational>({kNano, 1, 1 / kNano});
      return result;
    case HardFamily::kPreload:
      for (Contact& c : result) c.preload = random.pick<Rational>({kNano, 1, 1 / kNano});
      return result;
    case HardFamily::kFacingPairs:
      return facing_pairs(random, contacts);
    case HardFamily::kOnePoint:
      for (std::size_t i = 1; i < contacts; ++i) {
        Vector2& p = result[i].position;
        p = {p.x / 1000000, p.y / 1000000};
      }
      return result;
    case HardFamily::kFloor:
      return floor(random, contacts);
    case HardFamily::kLattice: {
      result = contacts_of(Layout::kGrid, contacts, seed);
      const std::vector<Vector2> axes{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
      for (Contact& c : result) c.normal = random.pick(axes);
      return result;
    }
    case HardFamily::kSticky:
      for (Contact& c : result) c.friction = random.between(2, 10);
      return result;
    case HardFamily::kSlippery:
      result = contacts_of(Layout::kRound, contacts, seed);
      for (Contact& c : result) c.friction = Rational(random.between(1, 9), 1000);
      return result;
    case HardFamily::kWheel:
      return wheel(contacts);
    case HardFamily::kNested:
      for (std::size_t i = 0; i < contacts; ++i) {
        // Ten sizes, however many contacts there are.
        const std::size_t level = i % 10;
        const Rational size = power_of(2, level) / 32;
        result[i].position = {size * result[i].position.x, size * result[i].position.y};
        result[i].stiffness *= power_of(10, level);
      }
      return result;
  }
  return result;
}

constexpr int kThresholdBits = 40;
constexpr int kMostDoublings = 20;

}  // namespace

const char* name_of(HardFamily family) {
  static constexpr const char* kNames[kHardFamilies] = {"frictionless",    "half frictionless",
                                                        "nearly parallel", "nearly coincident",
                                                        "stiffness",       "preload",
                                                        "facing pairs",    "one point",
                                                        "floor",           "lattice",
                                                        "sticky",          "slippery",
                                                        "wheel",           "nested"};
  return kNames[static_cast<std::size_t>(family)];
}

HardGrasp hard_grasp(HardFamily family, std::size_t contacts, std::uint64_t seed) {
  RandomSource random(seed * 1000003 + contacts * 64 + static_cast<std::size_t>(family));
  std::vector<Contact> result = make_contacts(family, random, contacts, seed);
  HardGrasp hard;
  do {
    hard.direction = {Rational(random.between(-8, 8), 8), Rational(random.between(-8, 8), 8),
                      Rational(random.between(-8, 8), 8)};
  } while (hard.direction == Wrench{});
  std::string name = std::string(name_of(family)) + " " + std::to_string(contacts) + " " +
                     std::to_string(seed);
  hard.grasp = Grasp(std::move(result), std::move(name));
  for (const ContactRow& row : contact_rows(hard.grasp)) {
    hard.held += -row.preload * row.normal;
  }
  return hard;
}

std::optional<Threshold> find_threshold(const HardGrasp& hard, NormalLaw law,
                                        const StableOracle& is_stable) {
  const auto pulled = [&](const Rational& s) {
    return plain_question(hard.grasp, hard.held + s * hard.direction, law);
  };
  Rational held = 0;
  Rational too_much = 1;
  for (int doubling = 0; is_stable(pulled(too_much)); ++doubling) {
    if (doubling == kMostDoublings) return std::nullopt;
    held = too_much;
    too_much *= 2;
  }
  for (int step = 0; step < kThresholdBits; ++step) {
    const Rational middle = (held + too_much) / 2;
    (is_stable(pulled(middle)) ? held : too_much) = middle;
  }
  return Threshold{pulled(held), pulled(too_much)};
}

}  // namespace stickslip::bench
