// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/resistance/resistible_set.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "generated_cone.hpp"
#include "mode_walk.hpp"
#include "stickslip/arrangement/sweep.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/equilibrium/search/region.hpp"

namespace stickslip {

using namespace resistance_detail;

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
  PieceFinder(const Problem& problem, const WrenchPlane& plane,
              const ResistibleOptions& options, ResistibleWork& work)
      : problem_(problem), plane_(plane), options_(options), work_(work) {
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

  /// False if the limit on modes was exceeded.
  bool find() {
    std::vector<Vector3> planes;
    for (const ContactRow& row : problem_.rows()) planes.push_back(coordinates(row.tangent));
    const std::vector<SlipState> states = enumerate_slip_states_sweep(planes).states;
    work_.slip_states = states.size();
    const Region root = Region::root(problem_);
    for (const SlipState& state : states) {
      state_ = &state;
      neighbours_.clear();
      for (const SlipState& face : states) {
        if (!has_stick(face) && is_neighbour(face, *state_)) neighbours_.push_back(&face);
      }
      closed_.assign(problem_.size(), true);
      if (!separate(root.with_slip_state(problem_, *state_), 0)) return false;
    }
    return true;
  }

  std::vector<ResistiblePiece> pieces;

 private:
  /// Depth first over the separations from a contact on.
  bool separate(const Region& region, std::size_t contact) {
    throw_if_cancelled();
    if (!has_motion(region)) return true;
    const ConeSigns signs(region.cone());
    for (; contact < problem_.size(); ++contact) {
      const Separation separation = Region::separation(problem_, ContactId(contact), signs);
      closed_[contact] = separation != Separation::kOpen;
      if (separation != Separation::kMixed) continue;
      for (const bool closed : {true, false}) {
        closed_[contact] = closed;
        if (!separate(region.separation_child(problem_, ContactId(contact),
                                              closed ? Separation::kClosed : Separation::kOpen),
                      contact + 1)) {
          return false;
        }
      }
      return true;
    }
    ++work_.modes;
    if (options_.mode_limit != 0 && work_.modes > options_.mode_limit) return false;
    if (options_.progress) options_.progress(work_.modes);
    if (std::optional<PlaneCell> cell = cell_of(region)) {
      ++work_.pieces;
      std::vector<ContactMode> modes;
      for (std::size_t i = 0; i < closed_.size(); ++i) {
        modes.push_back({closed_[i], (*state_)[i]});
      }
      pieces.push_back({std::move(modes), std::move(*cell)});
    }
    return true;
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
    const std::vector<IntegerVector4> in_plane =
        cut<4>({images.begin(), images.end()}, {0, 0, 1, 0}, Keep::kPlane);
    std::vector<HomogeneousPoint> generators;
    bool has_point = false;
    for (const IntegerVector4& g : in_plane) {
      if (is_zero(g)) continue;
      generators.push_back({g[0], g[1], g[3]});
      has_point = has_point || !g[3].is_zero();
    }
    if (!has_point) return std::nullopt;
    return PlaneCell::hull(std::move(generators));
  }

  const Problem& problem_;
  const WrenchPlane& plane_;
  const ResistibleOptions& options_;
  ResistibleWork& work_;
  Map at_rest_;             ///< no contact wrench
  std::vector<Map> edges_;  ///< what contact i adds while it slips +: 2i, and -: 2i + 1
  const SlipState* state_ = nullptr;
  std::vector<const SlipState*> neighbours_;
  std::vector<bool> closed_;
};

}  // namespace

WrenchPlane::WrenchPlane(const Wrench& origin, const Wrench& u, const Wrench& v)
    : origin_(origin), u_(u), v_(v) {
  const Vector3 a = stickslip::coordinates(u);
  const Vector3 b = stickslip::coordinates(v);
  const Vector3 normal = cross(a, b);
  const Rational area = dot(normal, normal);
  if (area.is_zero()) {
    throw InputError("", "plane", "its two directions are multiples of one another",
                     "give two independent directions, such as 1,0,0 and 0,1,0");
  }
  dual_ = {cross(b, normal), cross(normal, a), normal};
  for (Vector3& vector : dual_) {
    for (Rational& entry : vector) entry /= area;
  }
}

WrenchPlane WrenchPlane::forces(const Rational& torque) {
  return {{0, 0, torque}, {1, 0, 0}, {0, 1, 0}};
}

Wrench WrenchPlane::at(const PlanePoint& point) const {
  return origin_ + (point[0] * u_ + point[1] * v_);
}

Vector4 WrenchPlane::coordinates(const Vector3& w, const Rational& h) const {
  const Vector3 o = stickslip::coordinates(origin_);
  const Vector3 from_origin{w[0] - h * o[0], w[1] - h * o[1], w[2] - h * o[2]};
  return {dot(dual_[0], from_origin), dot(dual_[1], from_origin), dot(dual_[2], from_origin),
          h};
}

std::variant<std::vector<ResistiblePiece>, Undecided> resistible_pieces(
    const Problem& problem, const WrenchPlane& plane, const ResistibleOptions& options,
    ResistibleWork* work) {
  ResistibleWork unused;
  ResistibleWork& counters = work != nullptr ? *work : unused;
  counters = {};
  PieceFinder finder(problem, plane, options, counters);
  if (!finder.find()) {
    return too_many_modes(options);
  }
  return std::move(finder.pieces);
}

}  // namespace stickslip
