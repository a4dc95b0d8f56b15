// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The arrangement of great circles as a combinatorial structure: vertices, edges and faces
/// with their incidences. Exact, for any central planes n_i.d = 0 of R^3, degenerate ones
/// included. Coincident planes lie on one circle (great_circles.hpp).
///
/// An edge is two halfedges, twins, that run along it in opposite directions, each with one
/// face to its left. All circles are oriented so that one vector, the pole, is on the positive
/// side of each; the first halfedge of an edge is the one that runs counterclockwise about
/// that side. Seen from outside the sphere, `next` keeps the face to the left.
///
/// With k distinct circles:
///
///     k = 0   one face without boundary; nothing else
///     k = 1   two faces and one closed edge: both halfedges are their own next and have no
///             origin, and there is no vertex
///     pencil  two vertices, joined by 2k edges; 2k faces with two edges each
///     rank 3  a polyhedron's graph: no two edges join the same two vertices
///
/// Memory is about 48 bytes for each pair (ordered) of circles, 48 MB for 1000 circles in
/// general position, and some 12 MB more while it is built. Ids count from 0, the same on every
/// machine and for any number of threads. Immutable, so that threads may share it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "stickslip/arrangement/slip_states.hpp"
#include "stickslip/core/ids.hpp"

namespace stickslip {

/// \{ The id of a cell of an arrangement, or of one of the two directions of an edge.
using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using HalfedgeId = Id<struct HalfedgeTag>;
using FaceId = Id<struct FaceTag>;
/// \}

/// The cells of an arrangement and their incidences. Functions that take an id require that it
/// is one of this arrangement.
class ArrangementStructure {
 public:
  /// Builds the arrangement in O(m + k^2 log k). Throws ContractError if a normal is zero, if
  /// there are more than kMaxCircles circles, or if an internal check fails: every crossing of
  /// two circles must be found from both, every point of a circle must be filled by one vertex,
  /// and the faces that are traced must give V - E + F = 2.
  explicit ArrangementStructure(const std::vector<Vector3>& plane_normals,
                                unsigned threads = 1);

  /// The most distinct circles that there may be.
  static constexpr std::size_t kMaxCircles = 32768;

  /// Returns the circles of the planes, merged.
  const GreatCircles& circles() const { return circles_; }
  /// Returns the counts of cells and states.
  const ArrangementCounts& counts() const { return counts_; }

  /// \{ Returns how many there are; ids are below this.
  std::size_t vertices() const { return counts_.vertices; }
  std::size_t edges() const { return counts_.edges; }
  std::size_t halfedges() const { return 2 * counts_.edges; }
  std::size_t faces() const { return counts_.faces; }
  /// \}

  // The following are incidences, each found in O(1).

  /// Returns the halfedge of the edge that runs counterclockwise about the pole's side.
  static HalfedgeId first_halfedge(EdgeId edge) { return HalfedgeId(2 * edge.index()); }
  /// Returns the edge that the halfedge runs along.
  static EdgeId edge(HalfedgeId halfedge) { return EdgeId(halfedge.index() / 2); }
  /// Returns the other halfedge of the same edge.
  static HalfedgeId twin(HalfedgeId halfedge) { return HalfedgeId(halfedge.index() ^ 1); }

  /// Returns the next halfedge around the face to the left.
  HalfedgeId next(HalfedgeId halfedge) const { return HalfedgeId(next_[halfedge.index()]); }
  /// Returns the next halfedge with the same origin, clockwise.
  HalfedgeId clockwise(HalfedgeId halfedge) const { return next(twin(halfedge)); }
  /// Returns the face to the left.
  FaceId face(HalfedgeId halfedge) const { return FaceId(face_[halfedge.index()]); }
  /// \{ \brief Returns the vertex where the halfedge starts, or where it ends. Throws
  /// ContractError when there is no vertex.
  VertexId origin(HalfedgeId halfedge) const;
  VertexId target(HalfedgeId halfedge) const { return origin(twin(halfedge)); }
  /// \}

  /// Returns the circle that the edge lies on.
  CircleId circle(EdgeId edge) const { return CircleId(circle_of_edge_[edge.index()]); }
  /// Returns the sign of circles().normals[circle] on the face to the left.
  Sign sign_to_the_left(HalfedgeId halfedge) const;

  /// Returns a halfedge that starts at the vertex.
  HalfedgeId outgoing(VertexId vertex) const { return HalfedgeId(outgoing_[vertex.index()]); }
  /// Returns a positive multiple of the point of the sphere where the vertex is. Exact.
  IntegerVector3 ray(VertexId vertex) const;
  /// Returns a halfedge with the face to its left; none for the one face of no circle.
  std::optional<HalfedgeId> boundary(FaceId face) const;

  /// \{ \brief Returns the image under the antipodal map d -> -d, in O(1). Without circles the
  /// one face is its own antipode, and with one circle so is its one edge.
  VertexId antipode(VertexId vertex) const { return VertexId(vertex.index() ^ 1); }
  EdgeId antipode(EdgeId edge) const;
  FaceId antipode(FaceId face) const;
  /// \}

  /// \{ \brief Returns the signs of all planes on a cell, from the order of crossings on one of
  /// its circles. Takes O(m + k), and more where many circles are concurrent: one step for each
  /// circle through a vertex that is passed.
  SlipState signs(VertexId vertex) const;
  SlipState signs(EdgeId edge) const;
  SlipState signs(FaceId face) const;
  /// \}

  /// Returns the heap memory for the cells and incidences, without the normals.
  std::size_t memory_bytes() const;

 private:
  class Builder;

  std::size_t edge_count_of(std::size_t circle) const {
    return first_edge_[circle + 1] - first_edge_[circle];
  }
  bool side(std::size_t circle, std::size_t other) const {
    return side_[circle * circles_.normals.size() + other];
  }
  /// Returns the signs on an edge by circle, each oriented to the pole.
  std::vector<Sign> circle_signs(EdgeId edge) const;
  SlipState over_planes(const std::vector<Sign>& circle_signs) const;

  GreatCircles circles_;
  ArrangementCounts counts_;
  /// Whether the pole has the sign - on circles_.normals[c], by circle c.
  std::vector<bool> reversed_;
  std::vector<bool> side_;  ///< k x k: whether CircleOrder::side is +1
  /// The first edge of a circle; the others follow in its order.
  std::vector<std::uint32_t> first_edge_;
  std::vector<std::uint16_t> circle_of_edge_;
  std::vector<std::uint32_t> origin_;    ///< the origin of the first halfedge of an edge
  std::vector<std::uint32_t> next_;      ///< the next halfedge of a halfedge
  std::vector<std::uint32_t> face_;      ///< the face of a halfedge
  std::vector<std::uint32_t> outgoing_;  ///< a halfedge that starts at a vertex
  std::vector<std::uint32_t> boundary_;  ///< a halfedge with a face to its left
};

}  // namespace stickslip
