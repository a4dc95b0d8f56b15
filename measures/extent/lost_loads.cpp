// SPDX-License-Identifier: GPL-3.0-or-later
#include "lost_loads.hpp"

#include <utility>
#include <vector>

#include "engine/box/short_numbers.hpp"
#include "engine/box/single_grasp.hpp"
#include "engine/degree/newton.hpp"

namespace stickslip::extent_detail {

using namespace box_detail;

namespace {

/// The motions from which a longer search begins.
constexpr std::size_t kManyStarts = 12;

}  // namespace

LostLoads::LostLoads(const GraspBox& centre, const GraspBox& box, NormalLaw law,
                     const Rational& accuracy, const Rational& limit, NearEquilibrium at_centre)
    : centre_(centre),
      box_(box),
      law_(law),
      accuracy_(accuracy),
      limit_(limit),
      at_centre_(std::move(at_centre)),
      last_(at_centre_) {}

std::optional<LostLoads> LostLoads::of(const GraspBox& centre, const GraspBox& box,
                                       NormalLaw law, const Rational& accuracy,
                                       const Rational& limit) {
  std::vector<NearEquilibrium> known =
      equilibria_in_doubles(GraspLaw(centre, law).middle(), true);
  if (known.empty()) return std::nullopt;
  return LostLoads(centre, box, law, accuracy, limit, std::move(known.front()));
}

bool LostLoads::contains(const Suspect& load) const {
  if (looks_longer_) return !has_equilibrium(load);
  for (const int beyond : {0, 4, 16}) {
    if (has_equilibrium({load.place, load.factor * (1 + Rational(beyond, 1000))})) return false;
  }
  return true;
}

bool LostLoads::has_equilibrium(const Suspect& load) const {
  const GraspBox box = box_.scaled(centre_, load.factor);
  const GraspBox grasp = Examples(box, law_).at(load.place);
  const RoundedGrasp rounded = rounded_middle(GraspLaw(grasp, law_).middle());
  const Newton newton(rounded);
  std::optional<NearEquilibrium> found = newton.follow(last_);
  if (!found) found = newton.follow(at_centre_);
  if (!found) {
    constexpr std::size_t kFewStarts = 3;
    std::vector<NearEquilibrium> all = newton.solve_from(kFewStarts, 1);
    if (!all.empty()) {
      found = std::move(all.front());
    } else if (looks_longer_) {
      found = newton.solve_thoroughly(kManyStarts);
    }
  }
  if (found) last_ = std::move(*found);
  return found.has_value();
}

bool LostLoads::has_none(const Suspect& load) const {
  const GraspBox grasp = Examples(box_.scaled(centre_, load.factor), law_).at(load.place);
  return !Newton(rounded_middle(GraspLaw(grasp, law_).middle())).solve_thoroughly(kManyStarts);
}

std::optional<Suspect> LostLoads::first_along(const Place& place) const {
  last_ = at_centre_;
  constexpr int kDoublings = 12;
  Suspect load{place, limit_ / (1 << kDoublings)};
  while (load.factor < limit_ && !contains(load)) load.factor *= 2;
  if (!(load.factor < limit_)) return std::nullopt;
  return load;
}

std::vector<Suspect> LostLoads::at_random(const Rational& factor) const {
  constexpr std::size_t kMost = 4;
  const GraspBox box = box_.scaled(centre_, factor);
  std::vector<Suspect> found;
  Examples(box, law_).visit_random_corners(at_centre_, [&](const Place& place) {
    found.push_back({place, factor});
    return found.size() < kMost;
  });
  return found;
}

void LostLoads::draw_in(Suspect& load) const {
  const Rational part = looks_longer_ ? Rational(4 * accuracy_) : Rational(accuracy_ / 8);
  Rational low = 0;
  Rational& high = load.factor;
  for (Rational step = 2 * part; step < 1; step *= 4) {
    const Rational nearer = short_middle(high * (1 - step), high * (1 - step / 2));
    if (!contains({load.place, nearer})) {
      low = nearer;
      break;
    }
    high = nearer;
  }
  const Rational least = limit_ / (1 << 20);
  while (high - low > part * high && high > least) {
    const Rational middle = short_middle(low, high);
    (contains({load.place, middle}) ? high : low) = middle;
  }
}

}  // namespace stickslip::extent_detail
