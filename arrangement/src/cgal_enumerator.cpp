// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference enumerator. CGAL builds the arrangement of the circles on the sphere; this
// file reads its cells and their signs.
//
// What CGAL 5.5 needs to be right, found by measurement:
//   - all circles at once: inserting them one by one gives wrong arrangements that its own
//     is_valid() accepts;
//   - circles that are distinct, and in generic position with respect to the poles and the
//     meridian where it cuts the sphere (in_generic_position, filtered_normals.hpp). Otherwise
//     preconditions of its geometry traits fail, on two thirds of the grasps with axis-aligned
//     normals; a release build does not look at them and is right by luck at most.
// CGAL cuts every circle in two, at points of the plane y = 0. These artificial vertices are
// not vertices of the arrangement of circles and are skipped: in generic position they are
// exactly the vertices where all halfedges are of one circle.
//
// Signs need no arithmetic. Left of an arc that runs counterclockwise about the normal of its
// circle that circle's sign is +, and crossing an edge changes one sign.
#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_geodesic_arc_on_sphere_traits_2.h>
#include <CGAL/Arr_observer.h>
#include <CGAL/Arr_spherical_topology_traits_2.h>
#include <CGAL/Arrangement_on_surface_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "assemble_states.hpp"
#include "filtered_normals.hpp"
#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"

#ifdef STICKSLIP_CHECKED
static_assert(CGAL_ASSERTIONS_ENABLED, "the checked build needs the assertions of CGAL");
#endif

namespace stickslip {

using arrangement_detail::StateList;

namespace {

constexpr std::size_t kUnset = static_cast<std::size_t>(-1);

/// The label of every arc: the circle that it is a part of.
struct ArcLabel {
  std::size_t circle = kUnset;
};

/// Merges the labels of overlapping arcs, which are always of one circle.
struct MergeLabels {
  ArcLabel operator()(const ArcLabel& a, const ArcLabel& b) const {
    require(a.circle == b.circle, "cgal enumerator: arcs of two circles overlap");
    return a;
  }
};

/// The label of every face: the place of its signs.
struct FaceRow {
  std::size_t row = kUnset;
};

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Geometry =
    CGAL::Arr_curve_data_traits_2<CGAL::Arr_geodesic_arc_on_sphere_traits_2<Kernel>, ArcLabel,
                                  MergeLabels>;
using Topology =
    CGAL::Arr_spherical_topology_traits_2<Geometry,
                                          CGAL::Arr_face_extended_dcel<Geometry, FaceRow>>;
using Sphere = CGAL::Arrangement_on_surface_2<Geometry, Topology>;
using Face = Sphere::Face_handle;
using Halfedge = Sphere::Halfedge_const_handle;
using Vertex = Sphere::Vertex_const_handle;

/// Lets the insertion, which may take long, be broken off.
class Breaker : public CGAL::Arr_observer<Sphere> {
 public:
  explicit Breaker(Sphere& sphere) : CGAL::Arr_observer<Sphere>(sphere) {}
  void before_create_edge(const Geometry::X_monotone_curve_2&, Sphere::Vertex_handle,
                          Sphere::Vertex_handle) override {
    throw_if_cancelled();
  }
};

/// Converts an integer of any size exactly. It goes through the exact type, so that the
/// kernel's lazy number is a leaf and not a history of additions.
Kernel::FT to_kernel(const Integer& value) {
  using Exact = Kernel::FT::ET;
  constexpr unsigned kDigitBits = 24;
  std::vector<int> digits;
  for (Integer rest = abs(value); !rest.is_zero(); rest >>= kDigitBits) {
    digits.push_back((rest & ((1u << kDigitBits) - 1)).convert_to<int>());
  }
  Exact result(0);
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    result = result * Exact(1 << kDigitBits) + Exact(*digit);
  }
  return Kernel::FT(value.sign() < 0 ? Exact(-result) : result);
}

std::vector<Kernel::Direction_3> to_kernel(const std::vector<IntegerVector3>& normals) {
  std::vector<Kernel::Direction_3> directions;
  directions.reserve(normals.size());
  for (const IntegerVector3& n : normals) {
    directions.emplace_back(to_kernel(n[0]), to_kernel(n[1]), to_kernel(n[2]));
  }
  return directions;
}

std::size_t circle_of(Halfedge edge) {
  return edge->curve().data().circle;
}

/// Returns whether the halfedge runs as its arc does, hence counterclockwise about the arc's
/// normal.
bool is_counterclockwise(Halfedge edge) {
  return (edge->direction() == CGAL::ARR_LEFT_TO_RIGHT) == edge->curve().is_directed_right();
}

/// Returns the sign that the circle of the halfedge has on the face to its left.
Sign sign_to_the_left(Halfedge edge) {
  return is_counterclockwise(edge) ? Sign::kPositive : Sign::kNegative;
}

/// Returns whether circles cross at the vertex; it may also be a point where one circle was
/// cut.
bool is_crossing(Vertex vertex) {
  const auto first = vertex->incident_halfedges();
  auto edge = first;
  do {
    if (circle_of(edge) != circle_of(first)) return true;
  } while (++edge != first);
  return false;
}

/// Calls visit(halfedge) for every halfedge that has the face to its left. On a sphere CGAL
/// may call any boundary of a face outer or inner.
template <class Visit>
void for_each_boundary_halfedge(Face face, Visit visit) {
  const auto walk = [&visit](Sphere::Ccb_halfedge_circulator first) {
    auto edge = first;
    do visit(Sphere::Halfedge_handle(edge));
    while (++edge != first);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) walk(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) walk(*ccb);
}

/// Reads the cells of one arrangement into `cells`.
class CellReader {
 public:
  CellReader(Sphere& sphere, const std::vector<Kernel::Direction_3>& normals,
             const GreatCircles& circles, StateList& cells)
      : sphere_(sphere),
        normals_(normals),
        circles_(circles),
        cells_(cells),
        faces_(normals.size()) {}

  void read(ArrangementCounts& counts) {
    counts.faces = read_faces();
    counts.edges = read_edges();
    counts.vertices = read_vertices();
  }

 private:
  std::size_t read_faces() {
    walk_faces();
    require(faces_.size() == sphere_.number_of_faces(),
            "cgal enumerator: the faces are not connected");
    orient_walk();
    for (std::size_t i = 0; i < faces_.size(); ++i)
      cells_.add_over_planes(circles_, faces_[i].unpack());
    return faces_.size();
  }

  /// Gives each face its signs relative to those of the first face.
  void walk_faces() {
    std::vector<Face> reached;
    const auto reach = [&](Face face, std::size_t row) {
      face->set_data({row});
      reached.push_back(face);
    };
    faces_.add(SlipState(normals_.size(), Sign::kPositive));
    reach(sphere_.faces_begin(), 0);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const std::size_t row = reached[next]->data().row;
      for_each_boundary_halfedge(reached[next], [&](Sphere::Halfedge_handle edge) {
        const Face neighbour = edge->twin()->face();
        if (neighbour->data().row != kUnset) return;
        SlipState signs = faces_[row].unpack();
        Sign& crossed = signs[circle_of(edge)];
        crossed = -crossed;
        faces_.add(signs);
        reach(neighbour, faces_.size() - 1);
      });
    }
  }

  /// Turns relative signs into signs: one edge of each circle says which is which.
  void orient_walk() {
    SlipState factor;
    factor.resize(normals_.size(), Sign::kZero);
    for (auto edge = sphere_.edges_begin(); edge != sphere_.edges_end(); ++edge) {
      const std::size_t c = circle_of(edge);
      if (factor[c] != Sign::kZero) continue;
      factor[c] = signs_to_the_left(edge)[c] * sign_to_the_left(edge);
    }
    StateList oriented(normals_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      SlipState signs = faces_[i].unpack();
      for (std::size_t c = 0; c < factor.size(); ++c) signs[c] = signs[c] * factor[c];
      oriented.add(signs);
    }
    faces_ = std::move(oriented);
  }

  /// Checks an edge against the two faces beside it.
  void check_edge(Halfedge edge) const {
    const std::size_t c = circle_of(edge);
    const PackedSigns left = signs_to_the_left(edge);
    const PackedSigns right = signs_to_the_left(edge->twin());
    require(edge->curve().normal() == normals_[c],
            "cgal enumerator: an edge does not lie on its circle");
    require(left[c] == sign_to_the_left(edge) && right[c] == sign_to_the_left(edge->twin()),
            "cgal enumerator: an edge contradicts the sign of its circle beside it");
    std::size_t different_words = 0;
    for (std::size_t w = 0; w < left.word_count(); ++w) {
      different_words += left.words()[w] != right.words()[w] ? 1 : 0;
    }
    const std::size_t w = c / PackedSigns::kSignsPerWord;
    require(different_words == 1 && (left.words()[w] ^ right.words()[w]) ==
                                        PackedSigns::Word{1} << PackedSigns::shift_of(c),
            "cgal enumerator: the faces beside an edge differ in more than its circle");
  }

  /// Checks every edge, the artificial ones included, and returns the number of edges of the
  /// arrangement. Each of these is a chain of CGAL's edges; it is counted where it starts, in
  /// the counterclockwise direction. A circle that crosses no other is one closed edge.
  std::size_t read_edges() {
    std::size_t count = 0;
    for (auto edge = sphere_.edges_begin(); edge != sphere_.edges_end(); ++edge) {
      check_edge(edge);
      const Halfedge forward = is_counterclockwise(edge) ? Halfedge(edge) : edge->twin();
      if (!is_crossing(forward->source())) continue;
      add_edge(forward);
      ++count;
    }
    if (count == 0) {
      add_edge(sphere_.edges_begin());
      ++count;
    }
    return count;
  }

  void add_edge(Halfedge edge) {
    SlipState signs = signs_to_the_left(edge).unpack();
    signs[circle_of(edge)] = Sign::kZero;
    cells_.add_over_planes(circles_, signs);
  }

  std::size_t read_vertices() {
    std::size_t count = 0;
    std::size_t crossings = 0;
    for (auto vertex = sphere_.vertices_begin(); vertex != sphere_.vertices_end(); ++vertex) {
      require(!vertex->is_isolated(), "cgal enumerator: isolated vertex");
      if (!is_crossing(vertex)) continue;
      const std::size_t circles = add_vertex(vertex);
      crossings += circles * (circles - 1) / 2;
      ++count;
    }
    const std::size_t k = normals_.size();
    require(crossings == k * (k - 1),
            "cgal enumerator: two circles do not cross in exactly two points");
    return count;
  }

  /// Adds the vertex's signs, and returns the number of circles through it.
  std::size_t add_vertex(Vertex vertex) {
    const auto first = vertex->incident_halfedges();
    SlipState signs = signs_to_the_left(first).unpack();
    std::size_t circles = 0;
    auto edge = first;
    do {
      const std::size_t c = circle_of(edge);
      if (signs[c] == Sign::kZero) continue;
      signs[c] = Sign::kZero;
      ++circles;
    } while (++edge != first);
    require(vertex->degree() == 2 * circles,
            "cgal enumerator: a circle does not pass straight through a vertex");
    cells_.add_over_planes(circles_, signs);
    return circles;
  }

  PackedSigns signs_to_the_left(Halfedge edge) const {
    return faces_[edge->face()->data().row];
  }

  Sphere& sphere_;
  const std::vector<Kernel::Direction_3>& normals_;
  const GreatCircles& circles_;
  StateList& cells_;
  StateList faces_;  ///< the signs of the circles on each
};

void enumerate_cells(const GreatCircles& circles, StateList& cells, ArrangementCounts& counts) {
  if (circles.normals.empty()) {
    counts.faces = 1;
    cells.add(SlipState());
    return;
  }
  const std::vector<Kernel::Direction_3> normals =
      to_kernel(arrangement_detail::in_generic_position(circles.normals));
  const Geometry geometry;
  const auto great_circle = geometry.construct_curve_2_object();
  std::vector<Geometry::Curve_2> curves;
  curves.reserve(normals.size());
  for (std::size_t c = 0; c < normals.size(); ++c) {
    curves.emplace_back(great_circle(normals[c]), ArcLabel{c});
  }
  Sphere sphere(&geometry);
  const Breaker breaker(sphere);
  CGAL::insert(sphere, curves.begin(), curves.end());
  CellReader(sphere, normals, circles, cells).read(counts);
}

}  // namespace

SlipStates enumerate_slip_states_cgal(const std::vector<Vector3>& plane_normals) {
  const GreatCircles circles = merge_planes(plane_normals);
  StateList cells(plane_normals.size());
  ArrangementCounts counts;
  try {
    enumerate_cells(circles, cells, counts);
    arrangement_detail::complete_counts(counts, circles);
    return arrangement_detail::assemble_states(std::move(cells), counts);
  } catch (const CGAL::Failure_exception& failure) {
    throw ContractError(std::string("cgal enumerator: ") + failure.what());
  }
}

}  // namespace stickslip
