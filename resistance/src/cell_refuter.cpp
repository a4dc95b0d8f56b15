// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_refuter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/search/nearest_wrench.hpp"
#include "stickslip/equilibrium/search/region_program.hpp"

namespace stickslip::resistance_detail {

using namespace equilibrium_detail;

/// The generators of a cell's cone.
struct CellRefuter::Loads {
  struct Load {
    Vector3 wrench;                ///< of a corner at h = 1; of a direction at h = 0
    std::vector<Rational> strict;  ///< values of the cell's strict functions
  };
  std::vector<Load> corners;
  std::vector<Load> directions;
  std::size_t strict = 0;  ///< how many such functions there are

  Loads(const LoadCell& cell, const WrenchPlane& plane) : strict(cell.strict().size()) {
    for (const HomogeneousPoint& g : cell.closure().generators) {
      const bool at_infinity = is_at_infinity(g);
      const Rational scale = at_infinity ? Rational(1) : Rational(1) / Rational(g[2]);
      const Rational s = Rational(g[0]) * scale;
      const Rational t = Rational(g[1]) * scale;
      Load load{coordinates(s * plane.u() + t * plane.v()), {}};
      if (!at_infinity) load.wrench = coordinates(plane.at({s, t}));
      for (const LoadFunction& f : cell.strict()) {
        load.strict.push_back(Rational(dot(f, g)) * scale);
      }
      (at_infinity ? directions : corners).push_back(std::move(load));
    }
  }
};

namespace {

Double3 rounded(const Vector3& w, double length) {
  return {to_double(w[0]), to_double(w[1]), to_double(w[2]) / length};
}

double norm(const Double3& a) {
  return std::sqrt(dot(a, a));
}

}  // namespace

/// A region with all loads of a cell.
class CellRefuter::View {
 public:
  /// A wrench that a region allows on one of its generators.
  struct Support {
    double work = -HUGE_VAL;
    Double3 wrench{};
    std::size_t ray = 0;     ///< rays_.size() for a direction
    double scale = 1;        ///< by which the wrench was divided
    std::vector<int> edges;  ///< by pusher; 2 where it does not push
  };
  using Found = NearestWrench<Double3, Support>;

 private:
  /// A contact that may push somewhere on a region.
  struct Pusher {
    ContactId contact;
    bool mixed = false;
    std::optional<Sign> slip;
    std::vector<Rational> most;        ///< by ray: max(0, v)
    std::vector<double> most_rounded;  ///< the same
    Double3 normal{}, tangent{};       ///< N and mu T, rounded
  };

 public:
  View(const Problem& problem, const Region& region, const Loads& loads, double length)
      : problem_(problem),
        region_(region),
        signs_(region.cone()),
        loads_(loads),
        length_(length),
        rays_(region.generators(problem)) {
    for (std::size_t i = 0; i < problem.size(); ++i) add_pusher(ContactId(i));
    for (const Ray& ray : rays_) {
      heights_.push_back(Rational(ray.x[3]));
      heights_rounded_.push_back(to_double(heights_.back()));
    }
    for (const auto& load : loads.corners) corners_.push_back(rounded(load.wrench, length));
    for (const auto& load : loads.directions)
      directions_.push_back(rounded(load.wrench, length));
    for (std::size_t r = 0; r < heights_.size(); ++r) {
      double scale = 0;
      for (const Double3& w : corners_) {
        scale = std::max(scale, heights_rounded_[r] * norm(w));
      }
      for (const Pusher& p : pushers_) scale += p.most_rounded[r] * norm(p.normal);
      scales_.push_back(scale);
    }
  }

  std::vector<LoadedGenerator> generators() const;
  /// The rule leaf-bound, with g = 0 where h = 0 and nothing else acts.
  bool is_refuted(const IntegerVector3& y) const;
  /// By rounded numbers, that it is not.
  bool is_hopeless(const IntegerVector3& y) const;
  Found search() const;
  /// Where the combination of wrenches breaks a law with the most energy.
  std::optional<ContactSplit> broken_law(const Found& found) const;
  /// Near a multiple of y.
  std::optional<IntegerVector3> confirm(const std::array<double, 3>& y) const {
    return in_fewest_bits(y, {3, 6, 10, 16, 24, 36, 50},
                             [&](const IntegerVector3& candidate) {
                               return !is_hopeless(candidate) && is_refuted(candidate);
                             });
  }

 private:
  void add_pusher(ContactId contact) {
    const Separation separation = Region::separation(problem_, contact, signs_);
    if (separation == Separation::kOpen) return;
    const ContactRow& row = problem_.row(contact);
    Pusher p{contact,
             separation == Separation::kMixed,
             region_.slip_sign(problem_, contact, signs_),
             {},
             {},
             rounded(coordinates(row.normal), length_),
             rounded(coordinates(row.friction * row.tangent), length_)};
    const Vector5& v = problem_.separation(contact);
    for (const Ray& ray : rays_) {
      Rational value = 0;
      for (std::size_t j = 0; j < 4; ++j) value += v[j] * Rational(ray.x[j]);
      p.most.push_back(std::max(Rational(0), value));
      p.most_rounded.push_back(to_double(p.most.back()));
    }
    pushers_.push_back(std::move(p));
  }

  /// The edge on which it does the most work, and the work there.
  std::pair<int, double> strongest(const Pusher& p, const Double3& y) const {
    const double normal = dot(p.normal, y);
    const double tangent = dot(p.tangent, y);
    const int edge = p.slip ? -to_int(*p.slip) : tangent < 0 ? -1 : 1;
    const double work = normal + edge * tangent;
    return p.mixed && work <= 0 ? std::pair(2, 0.0) : std::pair(edge, work);
  }

  Support worst(const Double3& y) const;

  const Problem& problem_;
  const Region& region_;
  ConeSigns signs_;
  const Loads& loads_;
  double length_;
  std::vector<Ray> rays_;  ///< lines both ways as well
  std::vector<Pusher> pushers_;
  std::vector<Rational> heights_;  ///< by ray, as all that follow
  std::vector<double> heights_rounded_;
  std::vector<double> scales_;
  std::vector<Double3> corners_;
  std::vector<Double3> directions_;
};

std::vector<LoadedGenerator> CellRefuter::View::generators() const {
  std::vector<LoadedGenerator> result;
  const auto add = [&](const IntegerVector5& x, const Vector3& load,
                       std::vector<Rational> positive) {
    LoadedGenerator g;
    for (std::size_t j = 0; j < 5; ++j) g.x[j] = Rational(x[j]);
    g.load = load;
    g.positive = std::move(positive);
    g.positive.push_back(g.x[3]);
    result.push_back(std::move(g));
  };
  const std::vector<Rational> zeros(loads_.strict);
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    const Rational& h = heights_[r];
    if (h.is_zero()) {
      add(rays_[r].x, {}, zeros);
      continue;
    }
    for (const auto& corner : loads_.corners) {
      std::vector<Rational> positive;
      for (const Rational& value : corner.strict) positive.push_back(h * value);
      add(rays_[r].x, {h * corner.wrench[0], h * corner.wrench[1], h * corner.wrench[2]},
          std::move(positive));
    }
  }
  for (const auto& direction : loads_.directions) {
    add({0, 0, 0, 0, 0}, direction.wrench, direction.strict);
  }
  return result;
}

bool CellRefuter::View::is_refuted(const IntegerVector3& y) const {
  const Vector3 twist{Rational(y[0]), Rational(y[1]), Rational(y[2])};
  std::vector<Rational> works(rays_.size());
  for (const Pusher& p : pushers_) {
    const ContactRow& row = problem_.row(p.contact);
    const Rational friction = row.friction * dot(coordinates(row.tangent), twist);
    Rational alpha = dot(coordinates(row.normal), twist);
    alpha += p.slip ? Rational(-to_int(*p.slip)) * friction : abs(friction);
    if (p.mixed && alpha.sign() <= 0) continue;
    for (std::size_t r = 0; r < works.size(); ++r) works[r] += alpha * p.most[r];
  }
  // Where g = 0: rays, and which of the strict functions of loads is 0 everywhere.
  std::vector<const Ray*> flat;
  std::vector<char> is_zero(loads_.strict, 1);
  const auto note = [&](const Loads::Load& load) {
    for (std::size_t k = 0; k < loads_.strict; ++k) {
      if (!load.strict[k].is_zero()) is_zero[k] = 0;
    }
  };
  for (std::size_t r = 0; r < works.size(); ++r) {
    if (heights_[r].is_zero()) {
      if (works[r].sign() > 0) return false;
      if (works[r].is_zero()) flat.push_back(&rays_[r]);
      continue;
    }
    bool flat_here = false;
    for (const auto& corner : loads_.corners) {
      const Rational g = works[r] + heights_[r] * dot(twist, corner.wrench);
      if (g.sign() > 0) return false;
      if (!g.is_zero()) continue;
      flat_here = true;
      note(corner);
    }
    if (flat_here) flat.push_back(&rays_[r]);
  }
  // At infinity h and all functions of the motion are 0.
  for (const auto& direction : loads_.directions) {
    const Rational g = dot(twist, direction.wrench);
    if (g.sign() > 0) return false;
    if (g.is_zero()) note(direction);
  }
  return region_.is_barred(flat) ||
         std::any_of(is_zero.begin(), is_zero.end(), [](char zero) { return zero != 0; });
}

bool CellRefuter::View::is_hopeless(const IntegerVector3& candidate) const {
  Double3 y = in_doubles(candidate);
  y[2] *= length_;
  constexpr double kClear = 1e-9;
  std::vector<double> works(rays_.size());
  std::vector<double> sizes(rays_.size());
  for (const Pusher& p : pushers_) {
    const double work = strongest(p, y).second;
    for (std::size_t r = 0; r < works.size(); ++r) {
      works[r] += work * p.most_rounded[r];
      sizes[r] += std::fabs(work) * p.most_rounded[r];
    }
  }
  for (std::size_t r = 0; r < works.size(); ++r) {
    double load = corners_.empty() ? 0 : -HUGE_VAL;
    double size = 0;
    for (const Double3& w : corners_) {
      load = std::max(load, dot(w, y));
      size = std::max(size, norm(w) * norm(y));
    }
    const double h = heights_rounded_[r];
    if (works[r] + h * load > kClear * (sizes[r] + h * size)) return true;
  }
  return std::any_of(directions_.begin(), directions_.end(),
                     [&](const Double3& w) { return dot(w, y) > kClear * norm(w) * norm(y); });
}

CellRefuter::View::Support CellRefuter::View::worst(const Double3& y) const {
  std::vector<std::pair<int, double>> strengths;
  for (const Pusher& p : pushers_) strengths.push_back(strongest(p, y));
  std::size_t corner = 0;
  for (std::size_t k = 1; k < corners_.size(); ++k) {
    if (dot(corners_[k], y) > dot(corners_[corner], y)) corner = k;
  }
  Support best;
  for (std::size_t r = 0; r < rays_.size(); ++r) {
    if (!(scales_[r] > 0)) continue;
    double work = heights_rounded_[r] * dot(corners_[corner], y);
    bool acts = heights_rounded_[r] > 0;
    for (std::size_t k = 0; k < pushers_.size(); ++k) {
      work += strengths[k].second * pushers_[k].most_rounded[r];
      acts = acts || (strengths[k].first != 2 && pushers_[k].most_rounded[r] > 0);
    }
    work /= scales_[r];
    if (!acts || !(work > best.work)) continue;
    best.work = work;
    best.ray = r;
  }
  const Double3* direction = nullptr;
  for (const Double3& w : directions_) {
    const double work = dot(w, y) / norm(w);
    if (!(work > best.work)) continue;
    best.work = work;
    direction = &w;
  }
  if (direction != nullptr) {
    best.ray = rays_.size();
    best.scale = norm(*direction);
    best.wrench = *direction;
  } else if (best.work > -HUGE_VAL) {
    best.scale = scales_[best.ray];
    for (std::size_t j = 0; j < 3; ++j) {
      best.wrench[j] = heights_rounded_[best.ray] * corners_[corner][j];
    }
    for (std::size_t k = 0; k < pushers_.size(); ++k) {
      const Pusher& p = pushers_[k];
      best.edges.push_back(strengths[k].first);
      if (strengths[k].first == 2) continue;
      for (std::size_t j = 0; j < 3; ++j) {
        best.wrench[j] +=
            p.most_rounded[best.ray] * (p.normal[j] + strengths[k].first * p.tangent[j]);
      }
    }
  }
  for (double& entry : best.wrench) entry /= best.scale;
  return best;
}

CellRefuter::View::Found CellRefuter::View::search() const {
  Double3 start{};
  for (const Double3& w : corners_) {
    for (std::size_t j = 0; j < 3; ++j) start[j] -= w[j];
  }
  return nearest_wrench(start, [&](const Double3& y) -> std::optional<Support> {
    Support support = worst(y);
    if (support.work == -HUGE_VAL) return std::nullopt;
    return support;
  });
}

std::optional<ContactSplit> CellRefuter::View::broken_law(const Found& found) const {
  std::array<double, 4> x{};
  std::vector<double> normal(pushers_.size());
  std::vector<double> tangential(pushers_.size());  // b / mu
  for (const auto& [part, s] : found.parts) {
    if (s.ray == rays_.size()) continue;
    const double weight = part / s.scale;
    for (std::size_t j = 0; j < 4; ++j) {
      x[j] += weight * rays_[s.ray].x[j].convert_to<double>();
    }
    for (std::size_t k = 0; k < pushers_.size(); ++k) {
      if (s.edges[k] == 2) continue;
      const double a = weight * pushers_[k].most_rounded[s.ray];
      normal[k] += a;
      tangential[k] += s.edges[k] * a;
    }
  }
  double energy = 0;
  double widest = 0;
  std::optional<ContactSplit> split;
  for (std::size_t k = 0; k < pushers_.size(); ++k) {
    const Pusher& p = pushers_[k];
    const ContactRow& row = problem_.row(p.contact);
    const double stiffness = to_double(row.stiffness);
    const double a = normal[k];
    energy += a * a / stiffness;
    const auto consider = [&](double gap, ContactSplit at) {
      if (!(gap > widest)) return;
      widest = gap;
      split = at;
    };
    if (p.mixed) {
      const Vector5& v = problem_.separation(p.contact);
      double lawful = 0;
      for (std::size_t j = 0; j < 4; ++j) lawful += to_double(v[j]) * x[j];
      lawful = std::max(0.0, lawful);
      consider(std::fabs(a - lawful) * std::max(a, lawful) / stiffness,
               SeparationSplit{p.contact});
    }
    const bool may_split = !p.slip && !region_.label(p.contact) && row.friction.sign() > 0;
    if (!may_split) continue;
    const double slip = to_double(row.tangent.x) * x[0] + to_double(row.tangent.y) * x[1] +
                        to_double(row.tangent.torque) * x[2];
    const double gap = to_double(row.friction) * (a * std::fabs(slip) + tangential[k] * slip);
    if (gap > widest && !signs_.on(problem_.slip_plane(p.contact)).is_zero()) {
      consider(gap, SlipSplit{p.contact});
    }
  }
  constexpr double kNoticeable = 1e-9;  // of the energy; only chooses between splits
  if (!(widest > kNoticeable * energy)) return std::nullopt;
  return split;
}

CellRefuter::CellRefuter(const Problem& problem, const WrenchPlane& plane,
                         const RegionProofOptions& options, RegionProofWork& work)
    : problem_(problem), plane_(plane), options_(options), work_(work) {
  double most = 0;
  for (const ContactRow& row : problem.rows()) {
    for (const Wrench& w : {row.normal, row.tangent}) {
      const Double3 c = rounded(coordinates(w), 1);
      most = std::max(most, std::fabs(c[2]) / std::hypot(c[0], c[1]));
    }
  }
  if (most > 0 && std::isfinite(most)) length_ = most;
}

CellRefuter::Step CellRefuter::split_at(const Region& region, const ContactSplit& at) const {
  return {std::visit([](const auto& split) { return RegionNode(split); }, at),
          region.children(problem_, at)};
}

/// Closes or splits one node; nothing at the limit.
std::optional<CellRefuter::Step> CellRefuter::examine(const Region& region,
                                                      const Loads& loads) {
  if (options_.node_limit != 0 && work_.nodes >= options_.node_limit) return std::nullopt;
  ++work_.nodes;
  if (options_.progress && work_.nodes % 64 == 0) options_.progress(work_);
  if (region.is_void()) return Step{VirtualWorkLeaf{}, {}};
  const View view(problem_, region, loads, length_);
  const auto found = view.search();
  if (found.separated) {
    if (const auto y =
            view.confirm({found.twist[0], found.twist[1], found.twist[2] / length_})) {
      return Step{VirtualWorkLeaf{*y}, {}};
    }
  } else if (const auto split = view.broken_law(found)) {
    return split_at(region, *split);
  }
  ++work_.programs;
  const auto outcome = solve_loaded_region(problem_, region, view.generators());
  if (const auto* leaf = std::get_if<VirtualWorkLeaf>(&outcome)) {
    require(view.is_refuted(leaf->twist), "a Farkas vector does not refute its region");
    const std::array<double, 3> near = in_doubles(leaf->twist);
    const auto y = view.confirm(near);
    return Step{y ? VirtualWorkLeaf{*y} : *leaf, {}};
  }
  const auto& point = std::get<RelaxedPoint>(outcome);
  require(point.broken.has_value(), "a load outside of all pieces is resisted");
  return split_at(region, *point.broken);
}

bool CellRefuter::refute(const LoadCell& cell, std::vector<RegionNode>& tree) {
  const Loads loads(cell, plane_);
  return append_tree(Region::root(problem_), tree,
                     [&](const Region& region, std::size_t) { return examine(region, loads); });
}

}  // namespace stickslip::resistance_detail
