// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The cells of an arrangement cut down to the hemisphere r >= 0, as curves.
///
/// The visible parts of an edge are decided exactly; only the points between its ends are
/// rounded. The other hemisphere needs no code of its own: the visible part of a cell there is
/// the antipode of the visible part here of the antipodal cell.
///
/// No circle may be the rim r = 0, and none is: tangents are not zero.
#pragma once

#include <array>
#include <vector>

#include "stickslip/arrangement/arrangement_structure.hpp"
#include "stickslip/interfaces/svg.hpp"

namespace stickslip::plot_detail {

/// A point of the unit sphere.
using SpherePoint = std::array<double, 3>;

/// Returns Lambert's azimuthal equal-area projection of r >= 0 to the unit disc of the scene (y
/// up), turned so that a rotation lies in the direction of its centre, (-y, x) / r.
InkPoint project(const SpherePoint& p);

class UpperHalf {
 public:
  /// Keeps a reference.
  explicit UpperHalf(const ArrangementStructure& cells);

  /// Returns the sign of r.
  Sign height(VertexId vertex) const { return sign_of(vertices_[vertex.index()][2]); }
  SpherePoint place(VertexId vertex) const;

  /// Returns the visible part from one end to the other; empty if there is none.
  std::vector<SpherePoint> edge(EdgeId edge) const;

  /// Returns the visible part's border, counterclockwise as seen from outside; empty if there
  /// is none.
  std::vector<SpherePoint> face(FaceId face) const;

  /// Returns the point at `angle` on the visible half of a circle, 0 and pi on the rim.
  SpherePoint on_circle(CircleId circle, double angle) const;

 private:
  /// The visible part of a halfedge, as angles on its circle: 0 where the circle rises above
  /// the rim, pi where it sets.
  struct Span {
    bool is_visible = false;
    double begin = 0;
    double end = 0;
    bool ends_at_vertex = false;  ///< and not where the rim cuts the edge
  };
  Span span(HalfedgeId halfedge) const;
  /// Returns the normal of the circle, positive to the left.
  IntegerVector3 normal(HalfedgeId halfedge) const;

  const ArrangementStructure& cells_;
  std::vector<IntegerVector3> vertices_;  ///< positive multiples
};

}  // namespace stickslip::plot_detail
