// SPDX-License-Identifier: GPL-3.0-or-later
#include "all_modes.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "engine/planar/region.hpp"
#include "stickslip/arrangement/sweep.hpp"

namespace stickslip::test {
namespace {

/// x -> the plane's coordinates of a wrench, times a common factor: rows.
using Map = std::array<IntegerVector5, 4>;

using IntegerVector4 = IntegerVector<4>;

IntegerVector4 image(const Map& map, const IntegerVector5& x) {
  return primitive<4>({dot(map[0], x), dot(map[1], x), dot(map[2], x), dot(map[3], x)});
}

void add(Map& sum, const Map& map) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 5; ++j) sum[i][j] += map[i][j];
  }
}

bool has_stick(const SlipState& state) {
  return std::find(state.begin(), state.end(), Sign::kZero) != state.end();
}

/// Whether contacts may slip as in `face` beside motions on which they slip as in `state`.
bool is_neighbour(const SlipState& face, const SlipState& state) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (state[i] != Sign::kZero && state[i] != face[i]) return false;
  }
  return true;
}

/// Some motion, not only directions of motions.
bool has_motion(const Region& region) {
  const std::vector<Ray>& rays = region.cone().rays();
  return std::any_of(rays.begin(), rays.end(), [](const Ray& ray) { return ray.x[3] > 0; });
}

using RationalMap = std::array<Vector5, 4>;

RationalMap outer(const Vector4& column, const Vector5& row) {
  RationalMap map;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 5; ++j) map[i][j] = column[i] * row[j];
  }
  return map;
}

/// `factor` is a multiple of all denominators.
Map scaled(const RationalMap& map, const Integer& factor) {
  Map result;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 5; ++j) {
      result[i][j] = numerator(map[i][j]) * (factor / denominator(map[i][j]));
    }
  }
  return result;
}

class PieceFinder {
 public:
  PieceFinder(const Problem& problem, const WrenchPlane& plane) : problem_(problem) {
    // A contact's wrench is v(x) times one of two constant wrenches, on either edge.
    RationalMap at_rest = outer(plane.coordinates({0, 0, 0}, 1), {0, 0, 0, 1, 0});
    std::vector<RationalMap> edges;
    for (std::size_t i = 0; i < problem.size(); ++i) {
      for (const int sigma : {-1, 1}) {
        const Vector3 edge =
            coordinates(Rational(-1) * problem.edge_wrench(ContactId(i), sigma));
        edges.push_back(outer(plane.coordinates(edge, 0), problem.separation(ContactId(i))));
      }
    }
    Integer factor = 1;
    const auto include_in_factor = [&](const RationalMap& map) {
      for (const Vector5& row : map) {
        for (const Rational& entry : row) factor = lcm(factor, denominator(entry));
      }
    };
    include_in_factor(at_rest);
    for (const RationalMap& map : edges) include_in_factor(map);
    at_rest_ = scaled(at_rest, factor);
    for (const RationalMap& map : edges) edges_.push_back(scaled(map, factor));
  }

  void find() {
    std::vector<Vector3> planes;
    for (const ContactRow& row : problem_.rows()) planes.push_back(coordinates(row.tangent));
    const std::vector<SlipState> states = enumerate_slip_states_sweep(planes).states;
    const Region root = Region::root(problem_);
    for (const SlipState& state : states) {
      state_ = &state;
      neighbours_.clear();
      for (const SlipState& face : states) {
        if (!has_stick(face) && is_neighbour(face, *state_)) neighbours_.push_back(&face);
      }
      closed_.assign(problem_.size(), true);
      separate(root.with_slip_state(problem_, *state_), 0);
    }
  }

  std::vector<ResistiblePiece> pieces;

 private:
  /// Depth first over the separations from a contact on.
  void separate(const Region& region, std::size_t contact) {
    if (!has_motion(region)) return;
    const ConeSigns signs(region.cone());
    for (; contact < problem_.size(); ++contact) {
      const Separation separation = Region::separation(problem_, ContactId(contact), signs);
      closed_[contact] = separation != Separation::kOpen;
      if (separation != Separation::kMixed) continue;
      for (const bool closed : {true, false}) {
        closed_[contact] = closed;
        separate(region.separation_child(problem_, ContactId(contact),
                                         closed ? Separation::kClosed : Separation::kOpen),
                 contact + 1);
      }
      return;
    }
    if (std::optional<PlaneCell> cell = cell_of(region)) {
      std::vector<ContactMode> modes;
      for (std::size_t i = 0; i < closed_.size(); ++i) {
        modes.push_back({closed_[i], (*state_)[i]});
      }
      pieces.push_back({std::move(modes), std::move(*cell)});
    }
  }

  /// What the mode resists in the plane.
  std::optional<PlaneCell> cell_of(const Region& region) const {
    std::set<IntegerVector4> images;
    for (const SlipState* face : neighbours_) {
      Map map = at_rest_;
      for (std::size_t i = 0; i < problem_.size(); ++i) {
        if (closed_[i]) add(map, edges_[2 * i + ((*face)[i] == Sign::kNegative ? 1 : 0)]);
      }
      for (const Ray& ray : region.cone().rays()) images.insert(image(map, ray.x));
    }
    // Where n = 0: of them, and of sums of two on either side.
    std::vector<HomogeneousPoint> generators;
    const auto add_section = [&](const IntegerVector4& a, const IntegerVector4& b) {
      HomogeneousPoint g;
      for (const std::size_t j : {0, 1, 2}) {
        const std::size_t from = j == 2 ? 3 : j;
        g[j] = abs(b[2]) * a[from] + abs(a[2]) * b[from];
      }
      if (!is_zero(g)) generators.push_back(std::move(g));
    };
    for (const IntegerVector4& a : images) {
      if (a[2].is_zero() && !is_zero(a)) generators.push_back({a[0], a[1], a[3]});
      for (const IntegerVector4& b : images) {
        if (a[2].sign() > 0 && b[2].sign() < 0) add_section(a, b);
      }
    }
    if (std::all_of(generators.begin(), generators.end(), is_at_infinity)) return std::nullopt;
    return PlaneCell::hull(std::move(generators));
  }

  const Problem& problem_;
  Map at_rest_;             ///< no contact wrench
  std::vector<Map> edges_;  ///< what contact i adds while it slips +: 2i, and -: 2i + 1
  const SlipState* state_ = nullptr;
  std::vector<const SlipState*> neighbours_;
  std::vector<bool> closed_;
};

}  // namespace

std::vector<ResistiblePiece> pieces_of_all_modes(const Problem& problem,
                                                 const WrenchPlane& plane) {
  PieceFinder finder(problem, plane);
  finder.find();
  return std::move(finder.pieces);
}

}  // namespace stickslip::test
