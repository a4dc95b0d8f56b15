// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halfedge 2e runs along edge e counterclockwise about the oriented normal of its circle,
// halfedge 2e + 1 back. The edges of a circle with h points on its first half are numbered in
// its direction, edge q from point q to point q + 1; point q + h is the antipode of point q.
//
// Around a vertex the t directions that lead east come first, by slope, then in the same order
// the t that lead west: counterclockwise in all. A halfedge h arrives against one of them,
// twin(h), and its face continues along the one clockwise of it.
#include "stickslip/arrangement/arrangement_structure.hpp"

#include <algorithm>

#include "assemble_states.hpp"
#include "circle_order.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

using arrangement_detail::CircleOrder;
using arrangement_detail::FilteredNormals;

namespace {

constexpr std::uint32_t kUnset = 0xFFFFFFFF;

}  // namespace

class ArrangementStructure::Builder {
 public:
  Builder(ArrangementStructure& result, const FilteredNormals& normals)
      : s_(result), normals_(normals), k_(normals.size()) {}

  void build(unsigned threads) {
    order_circles(threads);
    number_edges();
    make_vertices();
    trace_faces();
  }

 private:
  /// The part of a circle's order that is kept until the vertices are numbered.
  struct CircleRecord {
    std::uint32_t half_points = 0;
    /// The data of each point of the first half whose lowest circle this is: the point, the
    /// number t of circles, and these by slope.
    std::vector<std::uint32_t> owned_points;
    std::size_t owned_count = 0;
  };

  void order_circles(unsigned threads) {
    records_.resize(k_);
    point_on_.assign(k_ * k_, kUnset);
    std::vector<std::uint8_t> sides(k_ * k_, 0);  // not bits: threads write side by side
    arrangement_detail::over_circles(
        k_, threads, [this] { return CircleOrder(normals_); },
        [&](CircleOrder& order, std::size_t i) {
          order.sort(i);
          record(order, i);
          for (std::size_t j = 0; j < k_; ++j) sides[i * k_ + j] = j != i && order.side(j) > 0;
        },
        [](CircleOrder&) {});
    s_.side_.assign(sides.begin(), sides.end());
  }

  void record(CircleOrder& order, std::size_t i) {
    CircleRecord& own = records_[i];
    own.half_points = static_cast<std::uint32_t>(order.half_points());
    for (std::uint32_t q = 0; q < own.half_points; ++q) {
      for (const std::uint32_t* j = order.begin(q); j != order.end(q); ++j) {
        point_on_[i * k_ + *j] = q;
      }
      if (!order.is_lowest(q)) continue;
      const std::vector<std::uint32_t>& slopes = order.by_slope(q);
      ++own.owned_count;
      own.owned_points.push_back(q);
      own.owned_points.push_back(static_cast<std::uint32_t>(slopes.size()));
      own.owned_points.insert(own.owned_points.end(), slopes.begin(), slopes.end());
    }
  }

  void number_edges() {
    std::size_t total = 0;
    for (const CircleRecord& record : records_) total += 2 * record.half_points;
    s_.circle_of_edge_.reserve(total);
    for (std::size_t i = 0; i < k_; ++i) {
      const std::uint32_t count = 2 * records_[i].half_points;
      s_.first_edge_.push_back(s_.first_edge_.back() + count);
      s_.circle_of_edge_.insert(s_.circle_of_edge_.end(), count, static_cast<std::uint16_t>(i));
    }
    s_.counts_.edges = s_.first_edge_.back();
    s_.origin_.assign(s_.edges(), kUnset);
    s_.next_.assign(s_.halfedges(), kUnset);
  }

  void make_vertices() {
    std::size_t total = 0;
    for (const CircleRecord& record : records_) total += record.owned_count;
    s_.outgoing_.reserve(2 * total);
    for (std::size_t i = 0; i < k_; ++i) {
      const std::vector<std::uint32_t>& owned = records_[i].owned_points;
      for (std::size_t at = 0; at < owned.size(); at += 2 + owned[at + 1]) {
        slopes_.assign(owned.data() + at + 2, owned.data() + at + 2 + owned[at + 1]);
        make_vertex(i, owned[at], false);
        std::reverse(slopes_.begin(), slopes_.end());
        make_vertex(i, owned[at], true);
      }
      records_[i] = {};
    }
    require(std::find(s_.origin_.begin(), s_.origin_.end(), kUnset) == s_.origin_.end(),
            "arrangement structure: a point of a circle has no vertex");
    s_.counts_.vertices = s_.outgoing_.size();
  }

  /// Makes the vertex at point q of circle i, or at its antipode, with its circles in slopes_.
  void make_vertex(std::size_t i, std::uint32_t q, bool is_antipode) {
    const auto vertex = static_cast<std::uint32_t>(s_.outgoing_.size());
    const std::size_t t = slopes_.size();
    around_.resize(2 * t);
    for (std::size_t b = 0; b < t; ++b) {
      const std::uint32_t c = slopes_[b];
      const std::uint32_t begin = s_.first_edge_[c];
      const std::uint32_t count = s_.first_edge_[c + 1] - begin;
      const std::uint32_t point = point_on(c, i, q, is_antipode);
      const std::uint32_t edge = begin + point;
      const std::uint32_t edge_before = begin + (point == 0 ? count : point) - 1;
      require(s_.origin_[edge] == kUnset,
              "arrangement structure: a point of a circle has two vertices");
      s_.origin_[edge] = vertex;
      around_[b] = 2 * edge;
      around_[t + b] = 2 * edge_before + 1;
    }
    s_.outgoing_.push_back(around_.front());
    for (std::size_t m = 0; m < around_.size(); ++m) {
      const std::uint32_t arriving = around_[m] ^ 1;
      s_.next_[arriving] = around_[m == 0 ? around_.size() - 1 : m - 1];
    }
  }

  /// Returns the point of circle c that is point q of circle i (or its antipode), where they
  /// cross. On its first half circle i meets c at side(i, c) * (n_i x n_c), and circle c meets
  /// i at side(c, i) * (n_c x n_i).
  std::uint32_t point_on(std::size_t c, std::size_t i, std::uint32_t q,
                         bool is_antipode) const {
    bool on_second_half = is_antipode;
    std::uint32_t point = q;
    if (c != i) {
      point = point_on_[c * k_ + i];
      require(point_on_[i * k_ + c] == q,
              "arrangement structure: the circles through a vertex disagree");
      if (s_.side(i, c) == s_.side(c, i)) on_second_half = !on_second_half;
    }
    return on_second_half ? point + (s_.first_edge_[c + 1] - s_.first_edge_[c]) / 2 : point;
  }

  void trace_faces() {
    s_.face_.assign(s_.halfedges(), kUnset);
    s_.boundary_.reserve(s_.edges() + 2 - s_.vertices());
    for (std::size_t start = 0; start < s_.halfedges(); ++start) {
      if (s_.face_[start] != kUnset) continue;
      const auto face = static_cast<std::uint32_t>(s_.boundary_.size());
      s_.boundary_.push_back(static_cast<std::uint32_t>(start));
      auto h = static_cast<std::uint32_t>(start);
      do {
        s_.face_[h] = face;
        h = s_.next_[h];
      } while (s_.face_[h] == kUnset);
      require(h == start, "arrangement structure: a boundary does not close");
    }
    s_.counts_.faces = s_.boundary_.size();
    require(s_.vertices() + s_.faces() == s_.edges() + 2,
            "arrangement structure: V - E + F must be 2");
  }

  ArrangementStructure& s_;
  const FilteredNormals& normals_;
  std::size_t k_;
  std::vector<CircleRecord> records_;
  std::vector<std::uint32_t> point_on_;  ///< [i * k + j]: the first point of i that is on j
  std::vector<std::uint32_t> slopes_, around_;
};

ArrangementStructure::ArrangementStructure(const std::vector<Vector3>& plane_normals,
                                           unsigned threads)
    : circles_(merge_planes(plane_normals)), first_edge_{0} {
  const std::size_t k = circles_.normals.size();
  require(k <= kMaxCircles, "arrangement structure: too many circles");
  const FilteredNormals normals(circles_.normals);
  for (std::size_t c = 0; c < k; ++c) reversed_.push_back(normals.is_reversed(c));
  if (k >= 2) {
    Builder(*this, normals).build(threads);
  } else if (k == 1) {
    side_ = {false};
    first_edge_ = {0, 1};
    circle_of_edge_ = {0};
    next_ = {0, 1};
    face_ = {0, 1};
    boundary_ = {0, 1};
  }
  counts_.edges = first_edge_.back();
  counts_.faces = k == 0 ? 1 : boundary_.size();
  arrangement_detail::complete_counts(counts_, circles_);
}

VertexId ArrangementStructure::origin(HalfedgeId halfedge) const {
  require(vertices() > 0, "arrangement structure: one circle has no vertex");
  std::size_t e = halfedge.index() / 2;
  if (halfedge.index() % 2 == 1) {
    // It starts where the circle's next edge starts.
    const std::size_t c = circle_of_edge_[e];
    e = e + 1 == first_edge_[c + 1] ? first_edge_[c] : e + 1;
  }
  return VertexId(origin_[e]);
}

Sign ArrangementStructure::sign_to_the_left(HalfedgeId halfedge) const {
  const bool is_first = halfedge.index() % 2 == 0;
  const bool is_reversed = reversed_[circle(edge(halfedge)).index()];
  return is_first != is_reversed ? Sign::kPositive : Sign::kNegative;
}

IntegerVector3 ArrangementStructure::ray(VertexId vertex) const {
  const auto positive_to_the_left = [&](HalfedgeId halfedge) {
    const IntegerVector3& n = circles_.normals[circle(edge(halfedge)).index()];
    return sign_to_the_left(halfedge) == Sign::kPositive ? n : negated(n);
  };
  // The halfedge clockwise of h turns right: det(N_h, N_g, d) < 0.
  const HalfedgeId h = outgoing(vertex);
  const IntegerVector3 ray = cross(positive_to_the_left(clockwise(h)), positive_to_the_left(h));
  require(!is_zero(ray), "neighbouring edges on one circle");
  return ray;
}

std::optional<HalfedgeId> ArrangementStructure::boundary(FaceId face) const {
  if (boundary_.empty()) return std::nullopt;
  return HalfedgeId(boundary_[face.index()]);
}

EdgeId ArrangementStructure::antipode(EdgeId edge) const {
  const std::size_t c = circle(edge).index();
  const std::size_t count = edge_count_of(c);
  const std::size_t place = edge.index() - first_edge_[c];
  return EdgeId(first_edge_[c] + (place + count / 2) % count);
}

FaceId ArrangementStructure::antipode(FaceId face_id) const {
  const std::optional<HalfedgeId> h = boundary(face_id);
  if (!h) return face_id;
  // The image of a halfedge runs the same way about its circle, on the other side of which
  // the image of the face lies.
  const HalfedgeId image(2 * antipode(edge(*h)).index() + h->index() % 2);
  return face(twin(image));
}

std::vector<Sign> ArrangementStructure::circle_signs(EdgeId edge) const {
  const std::size_t i = circle(edge).index();
  const std::size_t half = edge_count_of(i) / 2;
  std::size_t last = edge.index() - first_edge_[i];
  const bool on_second_half = half > 0 && last >= half;
  if (on_second_half) last -= half;

  std::vector<Sign> signs(circles_.normals.size());
  for (std::size_t j = 0; j < signs.size(); ++j) {
    signs[j] = side(i, j) ? Sign::kPositive : Sign::kNegative;
  }
  if (half > 0) {
    for (std::size_t q = 0; q <= last; ++q) {
      const HalfedgeId along(2 * (first_edge_[i] + q));
      for (HalfedgeId h = clockwise(along); h != along; h = clockwise(h)) {
        // Each other circle through the vertex leaves it twice.
        if (h.index() % 2 == 1) continue;
        Sign& sign = signs[circle(this->edge(h)).index()];
        sign = -sign;
      }
    }
  }
  if (on_second_half) {
    for (Sign& sign : signs) sign = -sign;
  }
  signs[i] = Sign::kZero;
  return signs;
}

SlipState ArrangementStructure::over_planes(const std::vector<Sign>& circle_signs) const {
  SlipState state;
  state.reserve(circles_.circle.size());
  for (std::size_t p = 0; p < circles_.circle.size(); ++p) {
    const std::size_t c = circles_.circle[p].index();
    const Sign sign = circles_.orientation[p] * circle_signs[c];
    state.push_back(reversed_[c] ? -sign : sign);
  }
  return state;
}

SlipState ArrangementStructure::signs(EdgeId edge) const {
  return over_planes(circle_signs(edge));
}

SlipState ArrangementStructure::signs(FaceId face) const {
  const std::optional<HalfedgeId> h = boundary(face);
  if (!h) return {};
  std::vector<Sign> signs = circle_signs(edge(*h));
  signs[circle(edge(*h)).index()] = h->index() % 2 == 0 ? Sign::kPositive : Sign::kNegative;
  return over_planes(signs);
}

SlipState ArrangementStructure::signs(VertexId vertex) const {
  const HalfedgeId first = outgoing(vertex);
  std::vector<Sign> signs = circle_signs(edge(first));
  HalfedgeId h = first;
  do {
    signs[circle(edge(h)).index()] = Sign::kZero;
    h = clockwise(h);
  } while (h != first);
  return over_planes(signs);
}

std::size_t ArrangementStructure::memory_bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v.front()); };
  return of(first_edge_) + of(circle_of_edge_) + of(origin_) + of(next_) + of(face_) +
         of(outgoing_) + of(boundary_) + (reversed_.capacity() + side_.capacity()) / 8;
}

}  // namespace stickslip
