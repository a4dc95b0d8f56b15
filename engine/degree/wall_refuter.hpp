// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Refutes the walls of a body of motions, by the search for laws, or in the plane by that for
/// many contacts.
#pragma once

#include "engine/planar/crowd_walls.hpp"
#include "engine/search/law_forces.hpp"
#include "stickslip/engine/search_work.hpp"

namespace stickslip::degree_detail {

/// Finds trees for the walls of one body after another.
class WallRefuter {
 public:
  WallRefuter() = default;
  virtual ~WallRefuter() = default;
  WallRefuter(const WallRefuter&) = delete;
  WallRefuter& operator=(const WallRefuter&) = delete;

  /// Appends to the proof's trees that of a wall, of list 1 or, if `second`, of list 2, of so
  /// many nodes at most. Returns false if there is none; then `trees` may have some nodes more.
  virtual bool refute(DegreeProof& proof, std::size_t wall, bool second,
                      std::size_t node_limit) = 0;
  /// Returns whether every contact is closed on all walls (rule `degree-law`).
  virtual bool all_are_closed(const DegreeProof& proof) const = 0;
};

/// Refutes walls for any law.
class LawRefuter : public WallRefuter {
 public:
  /// Takes the laws of a box and of the grasp in its middle.
  LawRefuter(const Law& box, const Law& middle, SearchWork& work)
      : box_(box), middle_(middle), work_(work) {}

  bool refute(DegreeProof& proof, std::size_t wall, bool second,
              std::size_t node_limit) override;
  bool all_are_closed(const DegreeProof& proof) const override;

 protected:
  const Law& box() const { return box_; }        ///< the law of list 1
  const Law& middle() const { return middle_; }  ///< the law of list 2
  SearchWork& work() { return work_; }           ///< the counters to add to

 private:
  const Law& box_;
  const Law& middle_;
  SearchWork& work_;
};

/// Refutes walls for one grasp in the plane.
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
