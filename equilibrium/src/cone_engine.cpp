// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/cone_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "double_model.hpp"
#include "nearest_point.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/equilibrium/region_system.hpp"
#include "witness_recovery.hpp"

namespace stickslip {
namespace {

/// A contact whose part in the bounds is not yet one linear form.
struct OpenQuestion {
  std::uint32_t contact;
  Separation separation = Separation::kMixed;
  std::int8_t slip = 0;   ///< -1, 1: the sign that slip has; 0: none
  bool slip_cuts = true;  ///< a slip split would make progress
};

/// Sum over the settled contacts of (N + sigma mu T) (x) v: y.aggregate.x is their work.
struct Aggregate {
  double value[3][4] = {};
  double magnitude[3][4] = {};  ///< sums of absolute values, for error bounds
  std::size_t terms = 0;
  /// Sum of the settled contacts' separation planes: 0 at a ray iff none of them pushes there.
  IntegerVector4 push{};
};

struct Node {
  Region region;
  std::vector<OpenQuestion> questions;
  Aggregate settled;
};

/// What a search for a virtual twist ended with.
struct SearchResult {
  bool separated = false;
  Double3 twist{};   ///< physical units, if separated
  Double4 motion{};  ///< otherwise a relaxed equilibrium: x ...
  std::vector<double>
      normal;  ///< ... and the forces a_i, mu-scaled b_i / mu_i of the questions
  std::vector<double> tangential;
};

class ConeEngine {
 public:
  ConeEngine(const Problem& problem, const ConeOptions& options, ConeWork& work)
      : problem_(problem), options_(options), work_(work), model_(problem) {}

  Verdict decide() {
    Node root{Region::root(problem_), {}, {}};
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      root.questions.push_back({static_cast<std::uint32_t>(i)});
    }
    if (!try_witness({0, 0, 0})) explore(std::move(root), 0);
    if (witness_) return Stable{std::move(*witness_)};
    if (limit_reached_) {
      return Undecided{"the limit of " + std::to_string(options_.node_limit) + " nodes"};
    }
    return Unstable{std::move(tree_)};
  }

 private:
  bool finished() const { return witness_.has_value() || limit_reached_; }

  void explore(Node node, std::size_t depth) {
    if (options_.node_limit != 0 && work_.nodes >= options_.node_limit) limit_reached_ = true;
    if (finished()) return;
    ++work_.nodes;
    work_.depth = std::max(work_.depth, depth);
    if (node.region.is_void()) {
      ++work_.voids;
      tree_.emplace_back(VoidLeaf{});
      return;
    }
    evaluate_rays(node);
    const SearchResult found = search(node);
    if (found.separated) {
      if (auto leaf = confirmed_leaf(node, found.twist)) {
        ++work_.leaves;
        tree_.emplace_back(std::move(*leaf));
        return;
      }
    }
    std::optional<ContactSplit> split;
    if (!found.separated) {
      if (is_power_of_two(work_.nodes) && try_witness_at(found.motion)) return;
      split = widest_gap(node, found);
      if (!split && try_witness_at(found.motion)) return;
    }
    if (!split) {
      split = solve_exactly(node);
      if (!split) return;  // a leaf or a witness
    }
    branch(node, *split, depth);
  }

  static bool is_power_of_two(std::size_t n) { return (n & (n - 1)) == 0; }

  void branch(const Node& node, const ContactSplit& split, std::size_t depth) {
    if (const auto* slip = std::get_if<SlipSplit>(&split)) {
      ++work_.slip_splits;
      tree_.emplace_back(*slip);
      for (const Sign sign : {Sign::kPositive, Sign::kZero, Sign::kNegative}) {
        Node child{node.region.slip_child(problem_, slip->contact, sign), node.questions,
                   node.settled};
        for (OpenQuestion& q : child.questions) {
          if (q.contact != slip->contact.index()) continue;
          q.slip = static_cast<std::int8_t>(to_int(sign));
          q.slip_cuts = false;
        }
        explore(std::move(child), depth + 1);
        if (finished()) return;
      }
    } else {
      const ContactId contact = std::get<SeparationSplit>(split).contact;
      ++work_.separation_splits;
      tree_.emplace_back(SeparationSplit{contact});
      for (const Separation side : {Separation::kClosed, Separation::kOpen}) {
        Node child{node.region.separation_child(problem_, contact, side), node.questions,
                   node.settled};
        explore(std::move(child), depth + 1);
        if (finished()) return;
      }
    }
  }

  // ---- the rays of the current node, and what they say of each contact ----

  Sign exact_or_certain(const Double4& function, const IntegerVector4& plane, std::size_t ray,
                        double& value) const {
    if (const std::optional<Sign> sign = certain_sign(function, rays_[ray], value))
      return *sign;
    const int exact = dot(plane, directions_[ray]).sign();
    value = exact * std::max(std::fabs(value), std::numeric_limits<double>::min());
    return sign_of_int(exact);
  }

  /// Fills rays_ and heights_, updates what is known of the questions, and settles those known.
  void evaluate_rays(Node& node) {
    directions_ = node.region.cone().directions();
    rays_.clear();
    for (const IntegerVector4& x : directions_) rays_.push_back(to_doubles(x));
    const std::size_t ray_count = rays_.size();
    heights_.clear();
    std::size_t kept = 0;
    for (OpenQuestion q : node.questions) {
      const ContactDoubles& c = model_.contacts[q.contact];
      const ContactId contact(q.contact);
      heights_.resize((kept + 1) * ray_count);
      double* heights = &heights_[kept * ray_count];
      SignRange range;
      for (std::size_t r = 0; r < ray_count; ++r) {
        const Sign sign =
            exact_or_certain(c.separation, problem_.separation_plane(contact), r, heights[r]);
        (sign == Sign::kNegative   ? range.negative
         : sign == Sign::kPositive ? range.positive
                                   : range.zero) = true;
      }
      if (q.separation == Separation::kMixed) {
        if (range.is_nonnegative()) q.separation = Separation::kClosed;
        if (range.is_nonpositive()) continue;  // open: no force
      }
      if (q.slip == 0 && c.frictionless) q.slip = 1;
      if (q.slip == 0 && q.slip_cuts) find_slip_sign(node, q);
      if (q.separation == Separation::kClosed && q.slip != 0) {
        settle(node, q);
        continue;
      }
      node.questions[kept++] = q;
    }
    node.questions.resize(kept);
    heights_.resize(kept * ray_count);
    loaded_.assign(ray_count, false);
    const Double4 push = to_doubles(node.settled.push);
    for (std::size_t r = 0; r < ray_count; ++r) {
      double value = 0;
      loaded_[r] = rays_[r][3] != 0 ||
                   exact_or_certain(push, node.settled.push, r, value) == Sign::kPositive;
    }
  }

  /// The rule "has the sign" of FORMAT.md, on the rays at hand.
  void find_slip_sign(const Node& node, OpenQuestion& q) {
    const ContactId contact(q.contact);
    if (node.region.label(contact)) {
      q.slip_cuts = false;
      return;
    }
    bool positive = false;
    bool negative = false;
    zero_rays_.clear();
    const std::size_t first_ray = 2 * node.region.cone().lines().size();
    for (std::size_t r = 0; r < rays_.size() && !(positive && negative); ++r) {
      double value = 0;
      const Sign sign = exact_or_certain(model_.contacts[q.contact].slip,
                                         problem_.slip_plane(contact), r, value);
      positive = positive || sign == Sign::kPositive;
      negative = negative || sign == Sign::kNegative;
      if (sign == Sign::kZero && r >= first_ray) {
        zero_rays_.push_back(&node.region.cone().rays()[r - first_ray]);
      }
    }
    if (positive && negative) return;
    if (!positive && !negative) {
      q.slip_cuts = false;  // sticks everywhere: friction is free, and a split would not help
    } else if (node.region.is_barred(zero_rays_)) {
      q.slip = positive ? 1 : -1;
    }
  }

  void settle(Node& node, const OpenQuestion& q) const {
    const ContactDoubles& c = model_.contacts[q.contact];
    for (std::size_t j = 0; j < 3; ++j) {
      const double edge = c.normal[j] - q.slip * c.friction[j];
      const double edge_magnitude = std::fabs(c.normal[j]) + std::fabs(c.friction[j]);
      for (std::size_t k = 0; k < 4; ++k) {
        node.settled.value[j][k] += edge * c.separation[k];
        node.settled.magnitude[j][k] += edge_magnitude * std::fabs(c.separation[k]);
      }
    }
    ++node.settled.terms;
    const IntegerVector4& plane = problem_.separation_plane(ContactId(q.contact));
    for (std::size_t k = 0; k < 4; ++k) node.settled.push[k] += plane[k];
  }

  // ---- search for a virtual twist in double precision ----

  /// The work of question q's contact per unit of normal coefficient, at most.
  double alpha(const OpenQuestion& q, const Double3& y, std::int8_t& sigma) const {
    const ContactDoubles& c = model_.contacts[q.contact];
    const double friction = dot(c.friction, y);
    sigma = q.slip != 0 ? static_cast<std::int8_t>(-q.slip)
                        : static_cast<std::int8_t>(friction >= 0 ? 1 : -1);
    return dot(c.normal, y) + sigma * friction;
  }

  /// The share of v that counts as the normal coefficient at a ray of height v.
  static double share(const OpenQuestion& q, double height, double alpha_value) {
    if (q.separation == Separation::kClosed) return height;
    return alpha_value > 0 ? std::max(0.0, height) : 0.0;
  }

  struct SupportPoint {
    std::size_t ray;
    Double3 twist;
    double weight;  ///< 1 / omega
  };

  SearchResult search(const Node& node) {
    ++work_.searches;
    const std::size_t ray_count = rays_.size();
    const std::vector<OpenQuestion>& questions = node.questions;
    SearchResult result;
    // Rays are scaled to comparable wrenches; a ray on which no contact pushes has none.
    omegas_.assign(ray_count, 0.0);
    for (std::size_t r = 0; r < ray_count; ++r) {
      double push = std::fabs(rays_[r][3]) * model_.force;
      for (std::size_t q = 0; q < questions.size(); ++q) {
        push += std::max(0.0, heights_[q * ray_count + r]);
      }
      for (std::size_t j = 0; j < 2; ++j) {
        double settled = 0;
        for (std::size_t k = 0; k < 4; ++k) settled += node.settled.value[j][k] * rays_[r][k];
        push += std::fabs(settled);
      }
      if (!(push > 0)) push = std::numeric_limits<double>::min();
      omegas_[r] = push;
    }
    std::vector<SupportPoint> supports;
    NearestPoint hull;
    Double3 y{-model_.load[0], -model_.load[1],
              -model_.load[2] / (model_.length * model_.length)};
    if (dot(y, y) == 0) y = {1, 0, 0};
    constexpr std::size_t kMostSteps = 60;
    std::vector<double> alphas(questions.size());
    std::vector<std::int8_t> sigmas(questions.size());
    double largest_point = 0;
    for (std::size_t step = 0; step < kMostSteps; ++step) {
      ++work_.support_points;
      for (std::size_t q = 0; q < questions.size(); ++q)
        alphas[q] = alpha(questions[q], y, sigmas[q]);
      Double4 form{0, 0, 0, dot(model_.load, y)};
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t j = 0; j < 3; ++j) form[k] += y[j] * node.settled.value[j][k];
      }
      double worst = -HUGE_VAL;
      std::size_t worst_ray = ray_count;
      for (std::size_t r = 0; r < ray_count; ++r) {
        double g = dot(form, rays_[r]);
        bool acts = loaded_[r];
        for (std::size_t q = 0; q < questions.size(); ++q) {
          const double height = heights_[q * ray_count + r];
          const double a = share(questions[q], height, alphas[q]);
          g += alphas[q] * a;
          acts = acts || a > 0;
        }
        if (!acts) continue;  // g is 0 there, and h is 0, so the ray is barred
        const double scaled = g / omegas_[r];
        if (scaled > worst) {
          worst = scaled;
          worst_ray = r;
        }
      }
      if (worst < 0 || worst_ray == ray_count) {
        result.separated = true;
        result.twist = y;
        return result;
      }
      Double3 point{};
      for (std::size_t j = 0; j < 3; ++j) {
        double sum = rays_[worst_ray][3] * model_.load[j];
        for (std::size_t k = 0; k < 4; ++k) {
          sum += node.settled.value[j][k] * rays_[worst_ray][k];
        }
        for (std::size_t q = 0; q < questions.size(); ++q) {
          const ContactDoubles& c = model_.contacts[questions[q].contact];
          const double a = share(questions[q], heights_[q * ray_count + worst_ray], alphas[q]);
          if (a != 0) sum += a * (c.normal[j] + sigmas[q] * c.friction[j]);
        }
        point[j] = sum / omegas_[worst_ray] * model_.force;
      }
      point[2] /= model_.length;
      supports.push_back({worst_ray, y, 1 / omegas_[worst_ray]});
      largest_point = std::max(largest_point, dot(point, point));
      const bool progress = hull.add(point);
      const Double3& z = hull.nearest();
      if (!progress || dot(z, z) <= 1e-24 * largest_point) break;
      y = {-z[0], -z[1], -z[2] / model_.length};
    }
    relax(node, hull, supports, result);
    return result;
  }

  /// The combination of support points that (nearly) vanishes, as a motion and forces.
  void relax(const Node& node, const NearestPoint& hull,
             const std::vector<SupportPoint>& supports, SearchResult& result) const {
    const std::size_t ray_count = rays_.size();
    const std::size_t count = node.questions.size();
    result.normal.assign(count, 0.0);
    result.tangential.assign(count, 0.0);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const SupportPoint& s = supports[hull.order(k)];
      const double weight = hull.weight(k) * s.weight;
      for (std::size_t j = 0; j < 4; ++j) result.motion[j] += weight * rays_[s.ray][j];
      for (std::size_t q = 0; q < count; ++q) {
        std::int8_t sigma = 0;
        const double a = alpha(node.questions[q], s.twist, sigma);
        const double normal =
            weight * share(node.questions[q], heights_[q * ray_count + s.ray], a);
        result.normal[q] += normal;
        result.tangential[q] += sigma * normal;
      }
    }
  }

  /// The split whose law the relaxed equilibrium breaks with the most energy; nothing if it
  /// breaks none noticeably.
  std::optional<ContactSplit> widest_gap(const Node& node, const SearchResult& found) const {
    double widest = 0;
    std::optional<ContactSplit> split;
    double energy = 0;
    for (std::size_t q = 0; q < node.questions.size(); ++q) {
      const OpenQuestion& question = node.questions[q];
      const ContactDoubles& c = model_.contacts[question.contact];
      const ContactId contact(question.contact);
      const double a = found.normal[q];
      const double v = dot(c.separation, found.motion);
      energy += a * a / c.stiffness;
      if (question.slip == 0 && question.slip_cuts) {
        // T scaled by mu: mu a |tau| + b tau, the dissipation that is missing.
        const double slip = c.friction[0] * found.motion[0] + c.friction[1] * found.motion[1] +
                            c.friction[2] * found.motion[2];
        const double gap = a * std::fabs(slip) + found.tangential[q] * slip;
        if (gap > widest) {
          widest = gap;
          split = SlipSplit{contact};
        }
      }
      if (question.separation == Separation::kMixed) {
        // The search lets a be anything from 0 up; a = max(0, v) is the law.
        const double closed = std::max(0.0, v);
        const double gap = std::fabs(a - closed) * std::max(a, closed) / c.stiffness;
        if (gap > widest) {
          widest = gap;
          split = SeparationSplit{contact};
        }
      }
    }
    if (widest <= 1e-12 * energy) return std::nullopt;
    return split;
  }

  // ---- leaves ----

  /// Rounds the twist to integers of growing size until the leaf is confirmed.
  std::optional<VirtualWorkLeaf> confirmed_leaf(const Node& node, const Double3& twist) {
    const double largest =
        std::max({std::fabs(twist[0]), std::fabs(twist[1]), std::fabs(twist[2])});
    if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
    for (const int bits : {3, 6, 10, 16, 24, 36, 50}) {
      VirtualWorkLeaf leaf;
      for (std::size_t j = 0; j < 3; ++j) {
        leaf.twist[j] = std::llround(std::ldexp(twist[j] / largest, bits));
      }
      leaf.twist = primitive(std::move(leaf.twist));
      const int filter = leaf_filter(node, leaf);
      if (filter < 0) continue;
      if (!options_.verify || filter > 0) {
        ++work_.filter_hits;
      } else if (refutes(problem_, node.region, leaf)) {
        ++work_.filter_misses;
      } else {
        continue;
      }
      for (const Integer& entry : leaf.twist) {
        if (!entry.is_zero()) {
          work_.largest_twist_bits =
              std::max<std::size_t>(work_.largest_twist_bits, msb(abs(entry)) + 1);
        }
      }
      return leaf;
    }
    return std::nullopt;
  }

  /// 1: certainly below 0 on every ray with a push; -1: certainly above 0 on some; 0: unknown.
  int leaf_filter(const Node& node, const VirtualWorkLeaf& leaf) const {
    const std::size_t ray_count = rays_.size();
    const Double3 y{leaf.twist[0].convert_to<double>(), leaf.twist[1].convert_to<double>(),
                    leaf.twist[2].convert_to<double>()};
    const double work = dot(model_.load, y);
    const double work_magnitude = std::fabs(model_.load[0] * y[0]) +
                                  std::fabs(model_.load[1] * y[1]) +
                                  std::fabs(model_.load[2] * y[2]);
    const double terms = static_cast<double>(node.settled.terms + node.questions.size() + 32);
    int answer = 1;
    for (std::size_t r = 0; r < ray_count; ++r) {
      const Double4& x = rays_[r];
      double g = x[3] * work;
      double magnitude = std::fabs(x[3]) * work_magnitude;
      bool acts = loaded_[r];
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t j = 0; j < 3; ++j) {
          g += y[j] * node.settled.value[j][k] * x[k];
          magnitude += std::fabs(y[j]) * node.settled.magnitude[j][k] * std::fabs(x[k]);
        }
      }
      for (std::size_t q = 0; q < node.questions.size(); ++q) {
        const OpenQuestion& question = node.questions[q];
        const ContactDoubles& c = model_.contacts[question.contact];
        std::int8_t sigma = 0;
        const double a = alpha(question, y, sigma);
        const double alpha_magnitude = magnitude_of(c, y);
        const double height = heights_[q * ray_count + r];
        const double height_magnitude = magnitude_of(c.separation, x);
        if (question.separation == Separation::kMixed) {
          // alpha max(0, v) if alpha > 0, else 0; the signs of heights are exact.
          if (height <= 0 || a < -alpha_error(alpha_magnitude)) continue;
          g += std::max(0.0, a) * height;
        } else {
          g += a * height;
        }
        acts = acts || height > 0;
        magnitude += alpha_magnitude * height_magnitude;
      }
      if (!acts) continue;  // g is 0 exactly, and so is h: the ray is barred
      // Each term has fewer than 16 roundings and each is summed at most `terms` times.
      const double bound = 1.2e-16 * (terms + 32) * magnitude + 1e-280;
      if (g > bound) return -1;
      if (!(g < -bound)) answer = 0;
    }
    return answer;
  }

  /// alpha has 6 products of two factors each rounded once: below 16 roundings.
  static double alpha_error(double magnitude) { return 2e-15 * magnitude + 1e-290; }

  static double magnitude_of(const ContactDoubles& c, const Double3& y) {
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      sum += (std::fabs(c.normal[j]) + std::fabs(c.friction[j])) * std::fabs(y[j]);
    }
    return sum;
  }
  static double magnitude_of(const Double4& function, const Double4& x) {
    double sum = 0;
    for (std::size_t j = 0; j < 4; ++j) sum += std::fabs(function[j] * x[j]);
    return sum;
  }

  // ---- witnesses and the exact program ----

  bool try_witness(const Double3& start) {
    ++work_.witness_attempts;
    witness_ = find_witness_near(problem_, model_, start);
    return witness_.has_value();
  }

  bool try_witness_at(const Double4& motion) {
    if (!(motion[3] > 0)) return false;
    return try_witness({motion[0] / motion[3], motion[1] / motion[3], motion[2] / motion[3]});
  }

  /// The exact program of the region: a leaf, a witness, or the split that its point asks for.
  std::optional<ContactSplit> solve_exactly(const Node& node) {
    ++work_.exact_programs;
    auto outcome = solve_region(problem_, node.region, nullptr);
    if (auto* leaf = std::get_if<VirtualWorkLeaf>(&outcome)) {
      ++work_.leaves;
      ++work_.filter_misses;
      tree_.emplace_back(std::move(*leaf));
      return std::nullopt;
    }
    auto& point = std::get<RelaxedPoint>(outcome);
    if (point.broken) return point.broken;
    witness_ = std::move(point.witness);
    require(!find_violation(problem_, *witness_), "an unbroken point is not an equilibrium");
    return std::nullopt;
  }

  const Problem& problem_;
  const ConeOptions& options_;
  ConeWork& work_;
  DoubleModel model_;
  Refutation tree_;
  std::optional<Witness> witness_;
  bool limit_reached_ = false;
  // Of the current node.
  std::vector<IntegerVector4> directions_;
  std::vector<Double4> rays_;
  std::vector<double> heights_;  ///< v_i(r), questions by rays
  std::vector<bool> loaded_;     ///< whether the load or a settled contact acts at the ray
  std::vector<double> omegas_;
  std::vector<const Ray*> zero_rays_;
};

}  // namespace

Verdict decide_by_cones(const Problem& problem, const ConeOptions& options, ConeWork* work) {
  ConeWork unused;
  ConeWork& counters = work != nullptr ? *work : unused;
  counters = {};
  return ConeEngine(problem, options, counters).decide();
}

}  // namespace stickslip
