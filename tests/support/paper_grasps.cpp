// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper_grasps.hpp"

namespace stickslip::test {
namespace {

const Rational kFriction(1, 2);

}  // namespace

Grasp fig1_grasp(const Rational& preload) {
  return Grasp({{{-1, 0}, {1, 0}, kFriction, 1, preload},
                {{0, -1}, {0, 1}, kFriction, 1, preload},
                {{1, 0}, {-1, 0}, kFriction, 1, preload}},
               "Fig. 1");
}

Grasp fig4_grasp(const Rational& preload) {
  return Grasp({{{-1, 1}, {1, 0}, kFriction, 1, preload},
                {{-1, -1}, {1, 0}, kFriction, 1, preload},
                {{1, -1}, {-1, 0}, kFriction, 1, preload},
                {{1, 1}, {-1, 0}, kFriction, 1, preload}},
               "Fig. 4");
}

}  // namespace stickslip::test
