// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL builds the arrangement of the cells' edges; this file reads it. All edges are segments:
// the aggregate insertion of rays is not reliable in CGAL 5.5 (CGAL issue 7311), so unbounded
// cells come cut off by a frame (plane_cover.cpp). Coordinates are rationals in intervals of
// doubles, and exact numbers if the intervals do not decide (Lazy_exact_nt). Each number is
// filtered by itself: the filtered kernel (Epeck) misses intersections of lines when its
// doubles overflow.
//
// Insides need no point location. Each edge knows by how much the number of cells to its left
// exceeds that to its right, and no cell is in the unbounded face. The numbers of all other
// faces follow, the same along every path.
#include "plane_overlay.hpp"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include "stickslip/core/error.hpp"

#ifdef STICKSLIP_CHECKED
static_assert(CGAL_ASSERTIONS_ENABLED, "the checked build needs the assertions of CGAL");
#endif

namespace stickslip::resistance_detail {
namespace {

constexpr std::size_t kUnset = static_cast<std::size_t>(-1);

/// The number that an edge carries, directed from its lexicographically smaller end to the
/// other: cells to its left less cells to its right. Numbers of overlapping edges add.
using Step = int;

struct FaceLabel {
  bool reached = false;
  int cells = 0;
  std::size_t area = kUnset;
};

using Coordinate = CGAL::Lazy_exact_nt<CGAL::Exact_rational>;
using Kernel = CGAL::Cartesian<Coordinate>;
using Geometry =
    CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, Step, std::plus<Step>>;
using Dcel = CGAL::Arr_extended_dcel<Geometry, bool, bool, FaceLabel>;
using Arrangement = CGAL::Arrangement_2<Geometry, Dcel>;
using Face = Arrangement::Face_handle;
using Halfedge = Arrangement::Halfedge_handle;

// CGAL's exact rational is Boost's over GMP, or its own Gmpq, as it is configured.
template <class Exact>
auto raw(Exact& value) -> decltype(value.backend().data()) {
  return value.backend().data();
}
template <class Exact>
auto raw(Exact& value) -> decltype(value.mpq()) {
  return value.mpq();
}

Coordinate to_kernel(const Rational& value) {
  CGAL::Exact_rational result;
  mpq_set(raw(result), value.gmp());
  return Coordinate(result);
}

Rational from_kernel(const Coordinate& value) {
  const CGAL::Exact_rational& exact = value.exact();
  Rational result;
  mpq_set(result.mutable_gmp(), raw(exact));
  return result;
}

PlanePoint from_kernel(const Kernel::Point_2& point) {
  return {from_kernel(point.x()), from_kernel(point.y())};
}

int step_over(Halfedge edge) {
  const Step step = edge->curve().data();
  return edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? step : -step;
}

/// Calls visit(halfedge) for all halfedges that have the face to their left.
template <class Visit>
void for_each_halfedge(Face face, Visit visit) {
  const auto walk = [&](Arrangement::Ccb_halfedge_circulator first) {
    auto edge = first;
    do {
      visit(Halfedge(edge));
    } while (++edge != first);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) walk(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) walk(*ccb);
}

class OverlayReader {
 public:
  OverlayReader(Arrangement& arrangement, const Integer& frame, int least)
      : arrangement_(arrangement),
        least_(least),
        has_frame_(!frame.is_zero()),
        side_(to_kernel(Rational(frame))) {}

  Overlay read() {
    label_vertices();
    count_cells();
    number_areas();
    // Borders that begin on the frame come first; a closed border may begin anywhere.
    for (const bool from_frame : {true, false}) {
      for (Halfedge edge : arrangement_.halfedge_handles()) {
        if (edge->data() || !is_border(edge)) continue;
        if (edge->source()->data() == from_frame) trace(edge);
      }
    }
    for (Halfedge edge : arrangement_.edge_handles()) {
      if (is_inside(edge->face()) || is_inside(edge->twin()->face())) continue;
      result_.thin_edges.emplace_back(from_kernel(edge->source()->point()),
                                      from_kernel(edge->target()->point()));
    }
    return std::move(result_);
  }

 private:
  bool is_inside(Face face) const { return face->data().cells >= least_; }

  void count_cells() {
    std::vector<Face> open{arrangement_.unbounded_face()};
    open.front()->data().reached = true;
    std::size_t reached = 0;
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      ++reached;
      for_each_halfedge(face, [&](Halfedge edge) {
        const Face across = edge->twin()->face();
        const int cells = face->data().cells - step_over(edge);
        if (across->data().reached) {
          require(across->data().cells == cells, "overlay: a face is in two numbers of cells");
          return;
        }
        require(cells >= 0, "overlay: a face is in less than no cell");
        across->data().reached = true;
        across->data().cells = cells;
        open.push_back(across);
      });
    }
    require(reached == arrangement_.number_of_faces(), "overlay: a face was not reached");
  }

  void number_areas() {
    for (Face first : arrangement_.face_handles()) {
      if (!is_inside(first) || first->data().area != kUnset) continue;
      first->data().area = result_.areas;
      std::vector<Face> open{first};
      while (!open.empty()) {
        const Face face = open.back();
        open.pop_back();
        for_each_halfedge(face, [&](Halfedge edge) {
          const Face across = edge->twin()->face();
          if (!is_inside(across) || across->data().area != kUnset) return;
          across->data().area = result_.areas;
          open.push_back(across);
        });
      }
      ++result_.areas;
    }
  }

  bool is_side(const Coordinate& value) const { return value == side_ || value == -side_; }

  /// Marks the vertices that are on the frame.
  void label_vertices() {
    for (Arrangement::Vertex_handle vertex : arrangement_.vertex_handles()) {
      const Kernel::Point_2& p = vertex->point();
      vertex->set_data(has_frame_ && (is_side(p.x()) || is_side(p.y())));
    }
  }

  /// Returns true if the edge lies along one side of the frame.
  bool is_along_frame(Halfedge edge) const {
    if (!edge->source()->data() || !edge->target()->data()) return false;
    const Kernel::Point_2& a = edge->source()->point();
    const Kernel::Point_2& b = edge->target()->point();
    return (a.x() == b.x() && is_side(a.x())) || (a.y() == b.y() && is_side(a.y()));
  }

  /// Returns true if the edge is between an area to its left and the outside.
  bool is_border(Halfedge edge) const {
    return is_inside(edge->face()) && !is_inside(edge->twin()->face()) && !is_along_frame(edge);
  }

  /// Returns the next edge of the border; edges inside of the area are crossed.
  Halfedge next_on_border(Halfedge edge) const {
    Halfedge next = edge->next();
    while (is_inside(next->twin()->face())) next = next->twin()->next();
    return next;
  }

  void trace(Halfedge first) {
    OverlayChain chain;
    chain.area = first->face()->data().area;
    Halfedge edge = first;
    while (true) {
      edge->set_data(true);
      chain.points.push_back(from_kernel(edge->source()->point()));
      if (edge->target()->data()) {
        chain.points.push_back(from_kernel(edge->target()->point()));
        break;
      }
      edge = next_on_border(edge);
      require(edge->face()->data().area == chain.area, "overlay: a border changes its area");
      if (edge == first) {
        chain.is_closed = true;
        break;
      }
      require(!edge->data(), "overlay: a border runs into another");
    }
    result_.chains.push_back(std::move(chain));
  }

  Arrangement& arrangement_;
  const int least_;
  const bool has_frame_;
  const Coordinate side_;
  Overlay result_;
};

}  // namespace

Overlay overlay(const std::vector<PlanePoint>& points, const std::vector<OverlayEdge>& edges,
                const Integer& frame, int least) {
  std::vector<Kernel::Point_2> ends;
  for (const PlanePoint& point : points)
    ends.emplace_back(to_kernel(point[0]), to_kernel(point[1]));
  std::vector<Geometry::Curve_2> curves;
  for (const OverlayEdge& edge : edges) {
    const Kernel::Point_2& from = ends[edge.from];
    const Kernel::Point_2& to = ends[edge.to];
    curves.emplace_back(Kernel::Segment_2(from, to), from < to ? edge.cells : -edge.cells);
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  for (Halfedge edge : arrangement.halfedge_handles()) edge->set_data(false);
  return OverlayReader(arrangement, frame, least).read();
}

}  // namespace stickslip::resistance_detail
