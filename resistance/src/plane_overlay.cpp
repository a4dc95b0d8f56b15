// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL builds the arrangement of the cells' edges; this file reads it. All edges are segments:
// the aggregate insertion of rays is not reliable in CGAL 5.5 (CGAL issue 7311), so unbounded
// cells come cut off by a frame (plane_union.cpp). Coordinates are plain rationals: where the
// doubles of the filtered kernel (Epeck) overflow, as those of lines to the frame do, it finds
// no intersection of lines that have one.
//
// Insides need no point location. Each edge knows by how much the number of cells to its left
// exceeds that to its right; no cell is in the unbounded face; the numbers of all other faces
// follow, along every path the same.
#include "plane_overlay.hpp"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Exact_rational.h>

#include "stickslip/core/error.hpp"

#ifdef STICKSLIP_CHECKED
static_assert(CGAL_ASSERTIONS_ENABLED, "the checked build needs the assertions of CGAL");
#endif

namespace stickslip::resistance_detail {
namespace {

constexpr std::size_t kUnset = static_cast<std::size_t>(-1);

/// What an edge carries, directed from its lexicographically smaller end to the other: cells to
/// its left less cells to its right. Where edges overlap these add.
using Step = int;

struct VertexLabel {
  PlanePoint point;
  bool on_frame = false;
};

struct FaceLabel {
  bool reached = false;
  int cells = 0;
  std::size_t area = kUnset;
};

using Kernel = CGAL::Cartesian<CGAL::Exact_rational>;
using Geometry =
    CGAL::Arr_curve_data_traits_2<CGAL::Arr_segment_traits_2<Kernel>, Step, std::plus<Step>>;
using Dcel = CGAL::Arr_extended_dcel<Geometry, VertexLabel, bool, FaceLabel>;
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

Kernel::Point_2 to_kernel(const PlanePoint& point) {
  Kernel::FT x;
  Kernel::FT y;
  mpq_set(raw(x), point[0].backend().data());
  mpq_set(raw(y), point[1].backend().data());
  return {x, y};
}

PlanePoint from_kernel(const Kernel::Point_2& point) {
  PlanePoint result;
  mpq_set(result[0].backend().data(), raw(point.x()));
  mpq_set(result[1].backend().data(), raw(point.y()));
  return result;
}

int step_over(Halfedge edge) {
  const Step step = edge->curve().data();
  return edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? step : -step;
}

/// Calls visit(halfedge) for all that have the face to their left.
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
  OverlayReader(Arrangement& arrangement, const Integer& frame)
      : arrangement_(arrangement), frame_(frame) {}

  Overlay read() {
    label_vertices();
    count_cells();
    number_areas();
    // Those that begin on the frame first: a closed one has no better place to begin.
    for (const bool from_frame : {true, false}) {
      for (Halfedge edge : arrangement_.halfedge_handles()) {
        if (edge->data() || !is_border(edge)) continue;
        if (edge->source()->data().on_frame == from_frame) trace(edge);
      }
    }
    for (Halfedge edge : arrangement_.edge_handles()) {
      if (is_inside(edge->face()) || is_inside(edge->twin()->face())) continue;
      result_.thin_edges.emplace_back(edge->source()->data().point,
                                      edge->target()->data().point);
    }
    return std::move(result_);
  }

 private:
  static bool is_inside(Face face) { return face->data().cells > 0; }

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

  void label_vertices() {
    const Rational side(frame_);
    for (Arrangement::Vertex_handle vertex : arrangement_.vertex_handles()) {
      const PlanePoint point = from_kernel(vertex->point());
      vertex->set_data(
          {point, side.sign() > 0 && (abs(point[0]) == side || abs(point[1]) == side)});
    }
  }

  /// On one side of it, then.
  bool is_along_frame(Halfedge edge) const {
    const VertexLabel& a = edge->source()->data();
    const VertexLabel& b = edge->target()->data();
    if (!a.on_frame || !b.on_frame) return false;
    const PlanePoint middle{(a.point[0] + b.point[0]) / 2, (a.point[1] + b.point[1]) / 2};
    return abs(middle[0]) == Rational(frame_) || abs(middle[1]) == Rational(frame_);
  }

  /// Between an area to its left and the outside.
  bool is_border(Halfedge edge) const {
    return is_inside(edge->face()) && !is_inside(edge->twin()->face()) && !is_along_frame(edge);
  }

  /// The next edge of the border: edges inside of the area are crossed.
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
      chain.points.push_back(edge->source()->data().point);
      if (edge->target()->data().on_frame) {
        chain.points.push_back(edge->target()->data().point);
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
  const Integer frame_;
  Overlay result_;
};

}  // namespace

Overlay overlay(const std::vector<PlaneCell>& cells, const Integer& frame) {
  std::vector<Geometry::Curve_2> curves;
  for (const PlaneCell& cell : cells) {
    require(cell.is_bounded() && cell.dimension() > 0, "overlay: bounded cells, no points");
    for (const PlaneEdge& edge : cell.edges()) {
      const PlanePoint from = point_of(edge.from);
      const PlanePoint to = point_of(edge.to);
      // The cell is to the left of the edge.
      const Step step = cell.dimension() < 2 ? 0 : from < to ? 1 : -1;
      curves.emplace_back(Kernel::Segment_2(to_kernel(from), to_kernel(to)), step);
    }
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  for (Halfedge edge : arrangement.halfedge_handles()) edge->set_data(false);
  return OverlayReader(arrangement, frame).read();
}

}  // namespace stickslip::resistance_detail
