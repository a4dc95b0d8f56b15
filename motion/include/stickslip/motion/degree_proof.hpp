// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Proofs by degree, in the plane and in space: a parallelepiped of motions on whose walls
/// there is no equilibrium (certificate/FORMAT.md, section 6).
#pragma once

#include <vector>

#include "stickslip/motion/strict_cone.hpp"

namespace stickslip {

/// There is an equilibrium in a body of motions; with trees of such nodes.
template <class Node>
struct DegreeProofIn : ConvexBody {
  std::vector<RationalRow> direction{};  ///< A, by rows
  std::vector<Node> trees{};  ///< list 1 unless it is not needed, and list 2; one for each wall
};

/// The exact rank of a matrix of these rows.
std::size_t rank_of(const std::vector<RationalRow>& rows);

/// `degree-walls` and `degree-direction`: both have this rank, that of all forces.
template <class Node>
bool has_rank(const DegreeProofIn<Node>& proof, std::size_t rank) {
  return rank_of(proof.walls) == rank && rank_of(proof.direction) == rank;
}

/// `degree-law`: every contact is closed at the vertices of the body, which are the rays of the
/// walls' regions.
template <class Region, class Model, class Proof>
bool all_closed_inside(const Model& model, const Proof& proof) {
  for (std::size_t wall = 0; wall < proof.wall_count(); ++wall) {
    const Region region = Region::wall(model, proof, wall);
    for (std::size_t i = 0; i < model.contacts.size(); ++i) {
      if (region.separation(i) != Separation::kClosed) return false;
    }
  }
  return true;
}

}  // namespace stickslip
