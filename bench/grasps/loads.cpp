// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads.hpp"

#include <algorithm>
#include <utility>

#include "random_source.hpp"
#include "stickslip/core/contact_row.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::bench {
namespace {

constexpr Layout kGeneralLayouts[] = {Layout::kRound, Layout::kArc, Layout::kEdges,
                                      Layout::kGrid};
constexpr Layout kOpenLayouts[] = {Layout::kArc, Layout::kEdges, Layout::kGrid};

/// To the next direction of the same instance, when one does not serve.
constexpr std::uint64_t kNextPull = 1000;
constexpr std::uint64_t kMostPulls = 40;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Twist small_twist(RandomSource& random) {
  return {Rational(random.between(-8, 8), 8), Rational(random.between(-8, 8), 8),
          Rational(random.between(-8, 8), 8)};
}

/// A motion on which none, one or two contacts stick.
Twist proposed_motion(RandomSource& random, const std::vector<ContactRow>& rows) {
  const int sticking = random.between(0, 2);
  if (sticking == 0) return small_twist(random);
  const Vector3 first = coordinates(random.pick(rows).tangent);
  const Vector3 second =
      sticking == 2 ? coordinates(random.pick(rows).tangent) : coordinates(small_twist(random));
  const Vector3 axis = cross(first, second);
  const Rational scale(random.one_in(2) ? 1 : -1, 4);
  return {scale * axis[0], scale * axis[1], scale * axis[2]};
}

/// d scaled down until no contact opens.
Twist kept_closed(const std::vector<ContactRow>& rows, Twist d) {
  for (const ContactRow& row : rows) {
    const Rational closing = row.stiffness * power(row.normal, d);
    if (closing <= row.preload) continue;
    const Rational factor = floor_to_grid(row.preload / closing, 1024);
    d = {factor * d.x, factor * d.y, factor * d.r};
  }
  return d;
}

Wrench in_millionths(const Wrench& w) {
  constexpr int kMillion = 1000000;
  return {floor_to_grid(w.x, kMillion), floor_to_grid(w.y, kMillion),
          floor_to_grid(w.torque, kMillion)};
}

std::string family_name(Layout layout, bool preloaded, const std::string& load) {
  return std::string(name_of(layout)) + (preloaded ? ", preload, " : ", ") + load;
}

Rational total_preload(const Grasp& grasp) {
  Rational sum;
  for (const Contact& c : grasp.contacts()) sum += c.preload;
  return sum;
}

/// Shares of the total preload are multiples of 1 / kShareSteps.
constexpr int kShareSteps = 64;
constexpr int kMostSteps = 64 * kShareSteps;

Question scaled_pull(Layout layout, std::size_t contacts, std::uint64_t seed,
                     const Wrench& direction, int steps, NormalLaw law) {
  Grasp grasp = make_grasp(layout, contacts, true, seed);
  const Rational share(steps, kShareSteps);
  Wrench pull = (share * total_preload(grasp)) * direction;
  if (layout == Layout::kVaried) pull = in_millionths(pull);
  return plain_question(std::move(grasp), pull, law);
}

/// A pull that is not held, up to a few percent the least along its direction: found on a
/// smaller grasp of the family where `contacts` is large, and raised until it serves.
/// Directions that jam the body, so that any pull is held, are skipped.
Question just_too_much(Layout layout, std::size_t contacts, std::uint64_t seed, NormalLaw law,
                       const StableOracle& is_stable) {
  constexpr std::size_t kMostForBisection = 100;
  const std::size_t small = std::min(contacts, kMostForBisection);
  for (std::uint64_t attempt = 0; attempt < kMostPulls; ++attempt) {
    const Wrench direction = pulling_load(layout, seed + kNextPull * attempt);
    const auto holds = [&](std::size_t size, int steps) {
      return is_stable(scaled_pull(layout, size, seed, direction, steps, law));
    };
    int held = 0;
    int too_much = kMostSteps;
    if (holds(small, too_much)) continue;
    while (too_much - held > 1 + held / 32) {
      const int middle = held + (too_much - held) / 2;
      (holds(small, middle) ? held : too_much) = middle;
    }
    bool is_held = contacts != small && holds(contacts, too_much);
    while (is_held && too_much < kMostSteps) {
      too_much += 1 + too_much / 32;
      is_held = holds(contacts, too_much);
    }
    if (!is_held) return scaled_pull(layout, contacts, seed, direction, too_much, law);
  }
  throw ContractError("a grasp that holds any pull");
}

}  // namespace

Question plain_question(Grasp grasp, const Wrench& wrench, NormalLaw law) {
  Question question;
  question.grasp = LoadedGrasp{std::move(grasp), wrench};
  question.law = law;
  return question;
}

Wrench planted_load(const Grasp& grasp, NormalLaw law, std::uint64_t seed) {
  RandomSource random(seed * 7919 + 17);
  const std::vector<ContactRow> rows = contact_rows(grasp);
  Twist d = proposed_motion(random, rows);
  if (law == NormalLaw::kBilateral) d = kept_closed(rows, d);
  Wrench wrench;
  for (const ContactRow& row : rows) {
    const Rational a = row.normal_coefficient(d);
    if (a.sign() <= 0) continue;
    const int slip = power(row.tangent, d).sign();
    const Rational share = slip != 0 ? Rational(-slip) : Rational(random.between(-8, 8), 8);
    wrench += -a * row.normal + -(share * row.friction * a) * row.tangent;
  }
  return wrench;
}

Wrench pulling_load(Layout layout, std::uint64_t seed) {
  RandomSource random(seed * 104729 + 29);
  const Rational across(random.between(-8, 8), 32);
  const Rational torque(random.between(-8, 8), 32);
  if (layout == Layout::kRound || layout == Layout::kVaried) return {1, across, torque};
  return {across, 1, torque};
}

Wrench threshold_load(Layout layout, const Grasp& grasp) {
  require(layout == Layout::kJaws || layout == Layout::kDisc, "no closed form");
  Rational friction;
  for (const Contact& c : grasp.contacts()) friction += c.friction * c.preload;
  if (layout == Layout::kJaws) return {0, friction, 0};
  return {0, 0, 2 * friction};  // the radius is 2
}

Instance make_stable(std::size_t family, std::size_t contacts, std::uint64_t seed) {
  require(family < kStableFamilies, "no such family");
  Instance instance;
  instance.expected = Expected::kStable;
  if (family < 8) {
    const Layout layout = kGeneralLayouts[family / 2];
    const bool preloaded = family % 2 == 1;
    Grasp grasp = make_grasp(layout, contacts, preloaded, seed);
    const Wrench load = planted_load(grasp, NormalLaw::kUnilateral, seed);
    instance.family = family_name(layout, preloaded, "planted");
    instance.question = plain_question(std::move(grasp), load);
    return instance;
  }
  if (family >= 10) {
    const bool preloaded = family == 11;
    Grasp grasp = make_grasp(Layout::kVaried, contacts, preloaded, seed);
    const Wrench load = in_millionths(planted_load(grasp, NormalLaw::kUnilateral, seed));
    instance.family = family_name(Layout::kVaried, preloaded, "planted");
    instance.question = plain_question(std::move(grasp), load);
    return instance;
  }
  const Layout layout = family == 8 ? Layout::kJaws : Layout::kDisc;
  Grasp grasp = make_grasp(layout, contacts, true, seed);
  const Wrench load = threshold_load(layout, grasp);
  instance.family = family_name(layout, true, "on the threshold");
  instance.question = plain_question(std::move(grasp), load);
  return instance;
}

Instance make_unstable(std::size_t family, std::size_t contacts, std::uint64_t seed,
                       const StableOracle& is_stable) {
  require(family < kUnstableFamilies, "no such family");
  Instance instance;
  instance.expected = Expected::kUnstable;
  if (family < 3) {
    const Layout layout = kOpenLayouts[family];
    instance.family = family_name(layout, false, "pulled");
    // Without preload the size of the pull does not matter, only its direction: a few
    // directions jam the body.
    for (std::uint64_t attempt = 0; attempt < kMostPulls; ++attempt) {
      instance.question = plain_question(make_grasp(layout, contacts, false, seed),
                                         pulling_load(layout, seed + kNextPull * attempt));
      if (!is_stable(instance.question)) return instance;
    }
    throw ContractError("a grasp that holds any pull");
  }
  if (family < 6) {
    const Layout layout = kOpenLayouts[family - 3];
    instance.family = family_name(layout, true, "pulled too far");
    instance.question =
        just_too_much(layout, contacts, seed, NormalLaw::kUnilateral, is_stable);
    return instance;
  }
  if (family >= 9) {
    const Layout layout = family == 9 ? Layout::kRound : Layout::kVaried;
    instance.family = family_name(layout, true, "bilateral, pulled too far");
    instance.question = just_too_much(layout, contacts, seed, NormalLaw::kBilateral, is_stable);
    return instance;
  }
  const bool on_jaws = family == 6 || (family == 8 && seed % 2 == 0);
  const Layout layout = on_jaws ? Layout::kJaws : Layout::kDisc;
  Grasp grasp = make_grasp(layout, contacts, true, seed);
  const Rational beyond = family == 8 ? Rational(21, 20) : 1 + parse_rational("1e-12");
  const Wrench load = beyond * threshold_load(layout, grasp);
  instance.family =
      family_name(layout, true, family == 8 ? "5 % beyond" : "1e-12 beyond the threshold");
  instance.question = plain_question(std::move(grasp), load);
  return instance;
}

std::vector<Instance> stable_instances(std::size_t contacts, std::size_t count) {
  std::vector<Instance> result;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(make_stable(k % kStableFamilies, contacts, 1 + k / kStableFamilies));
  }
  return result;
}

std::vector<Instance> unstable_instances(std::size_t contacts, std::size_t count,
                                         const StableOracle& is_stable) {
  std::vector<Instance> result;
  for (std::size_t k = 0; k < count; ++k) {
    result.push_back(
        make_unstable(k % kUnstableFamilies, contacts, 1 + k / kUnstableFamilies, is_stable));
  }
  return result;
}

}  // namespace stickslip::bench
