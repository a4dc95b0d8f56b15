// SPDX-License-Identifier: GPL-3.0-or-later
#include "families.hpp"

#include "loads.hpp"
#include "random_grasps.hpp"

namespace stickslip::bench {
namespace {

/// 10^-k for k from `first` to `last` in turn.
Rational small_number(std::size_t index, std::size_t first, std::size_t last) {
  const std::size_t k = first + index % (last - first + 1);
  return parse_rational("1e-" + std::to_string(k));
}

Wrench any_wrench(test::RandomSource& random, const Grasp& grasp, NormalLaw law) {
  return random.one_in(2) ? test::planted_wrench(random, grasp, law)
                          : test::small_wrench(random);
}

Question jaws(std::size_t index) {
  const Layout layout = index % 2 == 0 ? Layout::kJaws : Layout::kDisc;
  const Grasp grasp = make_grasp(layout, index / 2 % 2 == 0 ? 2 : 4, true, index);
  const int side = static_cast<int>(index / 4 % 3) - 1;
  const Rational factor = 1 + Rational(side) * small_number(index / 12, 6, 13);
  return plain_question(grasp, factor * threshold_load(layout, grasp));
}

}  // namespace

const char* name_of(FloatFamily family) {
  switch (family) {
    case FloatFamily::kRandom:
      return "random";
    case FloatFamily::kGrid:
      return "grid";
    case FloatFamily::kNearDegenerate:
      return "nearly degenerate";
    case FloatFamily::kEdgeOfCones:
      return "edge of cones";
    case FloatFamily::kJaws:
      return "jaws and discs";
  }
  return "";
}

Question float_question(FloatFamily family, std::size_t index) {
  if (family == FloatFamily::kJaws) return jaws(index);
  test::RandomSource random(1000 * static_cast<std::uint64_t>(family) + index);
  const std::size_t contacts = 2 + index % 3;
  const NormalLaw law = random.one_in(3) ? NormalLaw::kBilateral : NormalLaw::kUnilateral;
  if (family == FloatFamily::kEdgeOfCones) {
    const Grasp grasp = test::degenerate_grasp(random, contacts);
    const Rational beside = random.one_in(4) ? Rational(0) : small_number(index, 6, 13);
    return plain_question(grasp, test::threshold_wrench(random, grasp, beside), law);
  }
  const Grasp grasp =
      family == FloatFamily::kRandom ? test::generic_grasp(random, contacts)
      : family == FloatFamily::kGrid
          ? test::degenerate_grasp(random, contacts)
          : test::near_degenerate_grasp(random, contacts, small_number(index, 5, 12));
  return plain_question(grasp, any_wrench(random, grasp, law), law);
}

}  // namespace stickslip::bench
