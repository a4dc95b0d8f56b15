// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the sign vectors of any central planes n.d = 0 in R^3, three numbers a plane:
//
//     list_states 1 0 0  0 1 0  1 1 1/1000000000
#include <exception>
#include <iostream>
#include <stdexcept>

#include "stickslip/arrangement/sweep.hpp"

int main(int argc, char** argv) try {
  if (argc % 3 != 1) throw std::invalid_argument("three numbers a plane, please");
  std::vector<stickslip::Vector3> planes(static_cast<std::size_t>(argc - 1) / 3);
  for (std::size_t i = 0; i < 3 * planes.size(); ++i) {
    planes[i / 3][i % 3] = stickslip::parse_rational(argv[i + 1]);
  }
  const auto [counts, states] = stickslip::enumerate_slip_states_sweep(planes);
  for (const auto& state : states) std::cout << to_string(state) << '\n';
  std::cout << counts.vertices << " vertices, " << counts.edges << " edges, " << counts.faces
            << " faces; " << counts.distinct_states << " states\n";
} catch (const std::exception& error) {
  std::cerr << "list_states: " << error.what() << '\n';
  return 2;
}
