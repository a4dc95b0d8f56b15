// SPDX-License-Identifier: GPL-3.0-or-later
#include "effort.hpp"

#include <cstdint>

namespace stickslip::box_detail {

Effort effort_for(const GraspBox& box) {
  Effort effort{};
  if (!box.mechanism && !box.in_space()) {
    effort.nodes = 500 + 50 * box.contacts.size();
    effort.walls = 8;
    effort.trees = 8;
    effort.may_refine = true;
    effort.exact_contacts = 64;  // proofs by degree suit crowds
    effort.single_ends = 12;
    effort.decides_singles = true;
    effort.margins_come_soon = !box.ball && !box.is_bounded();
    effort.cuts_boxes = true;
    effort.retries = true;
    effort.tries_for_ball = 400;
  } else {
    const bool is_wide = !box.is_point();
    // A wide box that is neither stable nor unstable is to be told soon.
    effort.nodes = is_wide ? 1000 : 20000;
    // Few walls are proposed for a ball, and each takes many nodes.
    effort.walls = !is_wide ? 24 : box.ball ? 2 : 8;
    effort.trees = 4;
    effort.quick_nodes = 100;
    effort.rest_first = true;
    effort.exact_contacts = SIZE_MAX;
    effort.nodes_of_many = 1000;
    effort.nodes_of_single = box.ball ? 2000 : 0;
    // A proof of a whole ball takes all nodes that there are: none are left for parts.
    effort.cuts_boxes = !box.ball;
    effort.tries_for_ball = 60;
  }
  effort.tries = effort.margins_come_soon ? 3000 : 200;
  effort.last_step = effort.margins_come_soon ? 32 : 8;
  return effort;
}

}  // namespace stickslip::box_detail
