// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What refutes the walls of a body of motions: the search for laws, or in the plane that for
/// many contacts.
#pragma once

#include "engine/planar/crowd_walls.hpp"
#include "engine/search/law_forces.hpp"
#include "stickslip/engine/search_work.hpp"

namespace stickslip::degree_detail {

/// Trees for the walls of one body after another.
class WallRefuter {
 public:
  WallRefuter() = default;
  virtual ~WallRefuter() = default;
  WallRefuter(const WallRefuter&) = delete;
  WallRefuter& operator=(const WallRefuter&) = delete;

  /// Appends to the proof's trees that of a wall, of list 1 or of list 2, of so many nodes at
  /// most; false if there is none, and then `trees` may have some nodes more.
  virtual bool refute(DegreeProof& proof, std::size_t wall, bool second,
                      std::size_t node_limit) = 0;
  /// `degree-law`.
  virtual bool all_are_closed(const DegreeProof& proof) const = 0;
};

/// For any law.
class LawRefuter final : public WallRefuter {
 public:
  /// Of a box and the grasp in its middle.
  LawRefuter(const Law& box, const Law& middle, SearchWork& work)
      : box_(box), middle_(middle), work_(work) {}

  bool refute(DegreeProof& proof, std::size_t wall, bool second,
              std::size_t node_limit) override;
  bool all_are_closed(const DegreeProof& proof) const override;

 private:
  const Law& box_;
  const Law& middle_;
  SearchWork& work_;
};

/// For one grasp in the plane.
class CrowdRefuter final : public WallRefuter {
 public:
  CrowdRefuter(CrowdWalls& walls, SearchWork& work) : walls_(walls), work_(work) {}

  bool refute(DegreeProof& proof, std::size_t wall, bool second,
              std::size_t node_limit) override;
  bool all_are_closed(const DegreeProof& proof) const override;

 private:
  CrowdWalls& walls_;
  SearchWork& work_;
};

}  // namespace stickslip::degree_detail
