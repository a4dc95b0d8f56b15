// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "grasp_ink.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/degree/near_forces.hpp"

namespace stickslip::plot_detail {
namespace {

/// A place or a direction in scene coordinates.
using InkVector = std::array<double, 3>;

/// From where the scene is looked at.
struct LineOfSight {
  const char* heading;
  std::size_t right;  ///< the axis of the object frame that points there
  std::size_t up;     ///< likewise
  std::size_t towards;
  int sign;  ///< of the axis `towards` that points at the eye

  InkPoint operator()(const InkVector& v) const { return {v[right], v[up]}; }
};

constexpr std::array<LineOfSight, 3> kSides{{{"from above: x right, y up", 0, 1, 2, 1},
                                             {"from the front: x right, z up", 0, 2, 1, -1},
                                             {"from the right: y right, z up", 1, 2, 0, 1}}};

InkVector sum(InkVector a, double factor, const InkVector& b) {
  for (std::size_t j = 0; j < 3; ++j) a[j] += factor * b[j];
  return a;
}

Rational size_of(const Vector3& v) {
  return std::max({Rational(abs(v[0])), Rational(abs(v[1])), Rational(abs(v[2]))});
}

/// Each component over size > 0.
InkVector over_size(const Vector3& v, const Rational& size) {
  return {to_double(v[0] / size), to_double(v[1] / size), to_double(v[2] / size)};
}

InkVector direction(const Vector3& v) {
  const InkVector near = over_size(v, size_of(v));
  return sum({}, 1 / std::sqrt(stickslip::dot(near, near)), near);
}

std::string text_of(const Vector3& v) {
  return to_string(v[0]) + "," + to_string(v[1]) + "," + to_string(v[2]);
}

/// Rings that wind around all faces counterclockwise, and around nothing else: of the edges of
/// the faces, each run counterclockwise as it is seen, those that no other face runs back
/// along.
std::vector<std::vector<InkPoint>> boundary(
    const std::vector<InkPoint>& vertices, const std::vector<std::vector<std::size_t>>& faces) {
  std::map<std::pair<std::size_t, std::size_t>, int>
      runs;  // of each edge, one way less the other
  for (const std::vector<std::size_t>& face : faces) {
    double area = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const InkPoint& a = vertices[face[k]];
      const InkPoint& b = vertices[face[(k + 1) % face.size()]];
      area += a.x * b.y - a.y * b.x;
    }
    for (std::size_t k = 0; k < face.size() && area != 0; ++k) {
      const std::size_t a = face[k];
      const std::size_t b = face[(k + 1) % face.size()];
      if (a != b) runs[std::minmax(a, b)] += (a < b) == (area > 0) ? 1 : -1;
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> next;
  for (const auto& [edge, times] : runs) {
    const auto [from, to] = times > 0 ? edge : std::pair(edge.second, edge.first);
    next[from].insert(next[from].end(), static_cast<std::size_t>(std::abs(times)), to);
  }
  // As many edges end at a vertex as begin there, so that each way ends where it began.
  std::vector<std::vector<InkPoint>> rings;
  for (auto& [start, ends] : next) {
    while (!ends.empty()) {
      std::vector<InkPoint>& ring = rings.emplace_back();
      std::size_t at = start;
      do {
        ring.push_back(vertices[at]);
        std::vector<std::size_t>& ways = next.at(at);
        at = ways.back();
        ways.pop_back();
      } while (at != start);
    }
  }
  return rings;
}

struct SpatialContactInk {
  Vector3 position;  ///< exactly, in the object frame
  InkVector at;
  InkVector normal;  ///< of length 1, as are the two that span the tangent plane
  InkVector across;
  InkVector along;
};

/// Two directions orthogonal to the normal, of which one is in a coordinate plane.
void add_tangents(SpatialContactInk& c) {
  const InkVector& n = c.normal;
  const auto least = static_cast<std::size_t>(
      std::min_element(n.begin(), n.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      n.begin());
  InkVector axis{};
  axis[least] = 1;
  c.across = sum(axis, -n[least], n);
  c.across = sum({}, 1 / std::sqrt(stickslip::dot(c.across, c.across)), c.across);
  c.along = stickslip::cross(n, c.across);
}

class SpatialReader {
 public:
  SpatialReader(const Question& question, const Verdict& verdict)
      : question_(question), verdict_(verdict), grasp_(*question.box()) {}

  GraspInk read() {
    ink_.set_title(grasp_.description.name, question_.case_name);
    ink_.units = grasp_.description.units;
    add_contacts();
    ink_.marks.assign(contacts_.size(), ContactMark::kUnknown);
    for (const LineOfSight& side : kSides) {
      ink_.scenes.emplace_back();
      ink_.scenes.back().heading = side.heading;
      ink_.scenes.back().axes = {side.right, side.up};
    }
    const auto* stable = std::get_if<Stable>(&verdict_);
    if (stable != nullptr) read_forces(*stable);
    add_load();
    draw_contacts();
    if (stable != nullptr) {
      add_equilibrium(*stable);
    } else if (const auto* unstable = std::get_if<Unstable>(&verdict_)) {
      const std::size_t leaves = leaf_count(unstable->tree);
      ink_.caption.push_back("No motion and forces satisfy all conditions: proved by " +
                             (leaves == 1
                                  ? "one virtual twist."
                                  : "a tree of " + std::to_string(leaves) + " leaves."));
    } else if (std::holds_alternative<Fragile>(verdict_)) {
      ink_.caption.push_back("Some grasps in the box hold the load and some do not.");
    } else {
      ink_.caption.push_back("Undecided: " + in_words(std::get<Undecided>(verdict_)) + ".");
    }
    return std::move(ink_);
  }

 private:
  void add_contacts() {
    std::vector<std::vector<Rational>> points;
    for (const UncertainContact& c : grasp_.contacts) {
      points.push_back(
          {c.position[0].middle(), c.position[1].middle(), c.position[2].middle()});
      ink_.preloads.push_back(c.preload.middle());
    }
    ink_.outline_is_given = grasp_.description.body != nullptr;
    std::vector<std::vector<Rational>> all = points;
    if (ink_.outline_is_given) {
      ink_.body_within = RingsAround::kAnyWinding;
      for (const Vector3& v : grasp_.description.body->vertices) {
        all.emplace_back(v.begin(), v.end());
      }
    }
    const Surroundings around = surroundings(all, 3);
    radius_ = around.radius;
    std::copy(around.centre.begin(), around.centre.end(), centre_.begin());
    ink_.choose_sizes();
    for (std::size_t i = 0; i < points.size(); ++i) {
      SpatialContactInk& c = contacts_.emplace_back();
      Vector3 from_centre;
      for (std::size_t j = 0; j < 3; ++j) {
        c.position[j] = points[i][j];
        from_centre[j] = points[i][j] - centre_[j];
      }
      c.at = over_size(from_centre, radius_);
      c.normal = direction(vector3(grasp_.contacts[i].normal));
      add_tangents(c);
    }
  }

  /// Those of the witness, or near the equilibrium.
  void read_forces(const Stable& stable) {
    if (const auto* witness = std::get_if<ShareWitness>(&stable.proof)) {
      forces_ = forces_of(grasp_, witness->twist, witness->shares);
    } else {
      forces_ = near_forces(question_, stable.motion);
      value_ = "data-near";
    }
    for (const SpatialForce& f : forces_) {
      ink_.force_unit = std::max(ink_.force_unit, size_of(f.force));
    }
  }

  InkVector force(const Vector3& exact) const {
    return {ink_.force_length(exact[0]), ink_.force_length(exact[1]),
            ink_.force_length(exact[2])};
  }

  void add_arrow(const InkVector& tail, const InkVector& along, const std::string& css_class,
                 const Svg::Attributes& attributes) {
    for (std::size_t k = 0; k < kSides.size(); ++k) {
      ink_.scenes[k].arrows.push_back(
          {kSides[k](tail), kSides[k](sum(tail, 1, along)), css_class, attributes});
    }
  }

  /// The wrench as a force at the centre of the scene and a torque about it.
  void add_load() {
    std::array<Rational, 6> w;
    for (std::size_t j = 0; j < 6; ++j) w[j] = grasp_.wrench[j].middle();
    const Vector3 force_there{w[0], w[1], w[2]};
    const Vector3 arm = stickslip::cross(centre_, force_there);
    const Vector3 torque{w[3] - arm[0], w[4] - arm[1], w[5] - arm[2]};
    const Rational largest = size_of(force_there);
    ink_.force_unit = std::max(ink_.force_unit, largest);
    ink_.choose_load_factor(largest);
    add_arrow(
        {}, sum({}, to_double(ink_.load_factor), force(force_there)), "load",
        {{"data-value", text_of(force_there)}, {"data-factor", to_string(ink_.load_factor)}});
    const std::string text = short_tuple({torque[0], torque[1], torque[2]});
    if (!size_of(torque).is_zero()) ink_.torque = text;
    for (std::size_t k = 0; k < kSides.size(); ++k) {
      ink_.scenes[k].torque = kSides[k].sign * torque[kSides[k].towards];
    }
    ink_.describe_load({w.begin(), w.end()}, {centre_[0], centre_[1], centre_[2]}, text,
                       question_.law);
  }

  void draw_contacts() {
    const std::vector<InkVector> body = body_points();
    for (std::size_t k = 0; k < kSides.size(); ++k) {
      SceneInk& scene = ink_.scenes[k];
      for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const SpatialContactInk& c = contacts_[i];
        scene.contacts.push_back({kSides[k](c.at), kSides[k](c.normal), {}});
        scene.cones.push_back(hull(k, cone(i)));
      }
      scene.outline = seen(k, body);
    }
  }

  /// The body, whose points these are: rings as of ink_.body_within.
  std::vector<std::vector<InkPoint>> seen(std::size_t side,
                                          const std::vector<InkVector>& points) const {
    if (points.empty()) return {};
    if (!grasp_.description.body) return {hull(side, points)};
    std::vector<InkPoint> vertices;
    for (const InkVector& p : points) vertices.push_back(kSides[side](p));
    return boundary(vertices, grasp_.description.body->faces);
  }

  static std::vector<InkPoint> hull(std::size_t side, const std::vector<InkVector>& points) {
    std::vector<InkPoint> seen;
    for (const InkVector& p : points) seen.push_back(kSides[side](p));
    return convex_hull(std::move(seen));
  }

  /// Points of which the hull is what of a ball around the contact lies in the cone.
  std::vector<InkVector> cone(std::size_t i) const {
    constexpr int kTurns = 48;
    constexpr int kSteps = 8;
    const SpatialContactInk& c = contacts_[i];
    const double size = ink_.cone_length;
    const double half_angle = std::atan(to_double(grasp_.contacts[i].friction.middle()));
    std::vector<InkVector> points{c.at, sum(c.at, size, c.normal)};
    for (int turn = 0; turn < kTurns; ++turn) {
      const double around = 2 * M_PI * turn / kTurns;
      const InkVector tangent =
          sum(sum({}, std::cos(around), c.across), std::sin(around), c.along);
      for (int step = 1; step <= kSteps; ++step) {
        const double angle = half_angle * step / kSteps;
        points.push_back(
            sum(sum(c.at, size * std::cos(angle), c.normal), size * std::sin(angle), tangent));
      }
    }
    return points;
  }

  /// The vertices of the body. Where nobody gave it, points of which the hull stands for it:
  /// the contacts, and points a little inside of them that are behind no contact; as in the
  /// plane.
  std::vector<InkVector> body_points() const {
    std::vector<InkVector> points;
    if (grasp_.description.body) {
      for (const Vector3& v : grasp_.description.body->vertices) {
        points.push_back(
            over_size({v[0] - centre_[0], v[1] - centre_[1], v[2] - centre_[2]}, radius_));
      }
      return points;
    }
    for (const SpatialContactInk& c : contacts_) points.push_back(c.at);
    const auto is_in_front = [](const InkVector& p, const SpatialContactInk& c) {
      return stickslip::dot(sum(p, -1, c.at), c.normal) >= 0;
    };
    for (const SpatialContactInk& c : contacts_) {
      for (const InkVector* tangent : {&c.across, &c.along}) {
        for (const double side : {-0.3, 0.3, -0.4, 0.4}) {
          const double inwards = std::abs(side) < 0.35 ? 0.12 : 0.5;
          const InkVector p = sum(sum(c.at, inwards, c.normal), side, *tangent);
          if (std::all_of(
                  contacts_.begin(), contacts_.end(),
                  [&](const SpatialContactInk& other) { return is_in_front(p, other); })) {
            points.push_back(p);
          }
        }
      }
    }
    return points;
  }

  void add_equilibrium(const Stable& stable) {
    const RationalRow& d = stable.motion;
    add_motion(d);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const SpatialForce& f = forces_[i];
      ink_.marks[i] = f.normal.is_zero()          ? ContactMark::kOpen
                      : size_of(f.slip).is_zero() ? ContactMark::kStick
                                                  : ContactMark::kSlip;
      add_arrow(contacts_[i].at, force(f.force), "force",
                {{"data-contact", std::to_string(i)}, {value_, text_of(f.force)}});
    }
    const bool exact = std::holds_alternative<ShareWitness>(stable.proof);
    ink_.describe_motion(
        exact ? "Motion d" : "Near the motion d", d,
        exact ? "The forces balance w; checked exactly."
              : "There is an equilibrium near it, proved by degree; what is drawn of it is in "
                "floating point, for people, and proves nothing.");
  }

  void add_motion(const RationalRow& d) {
    // The contacts may move less than the body, and not at all.
    const Vector3 shift = stickslip::displacement(centre_, d);
    const Vector3 turn{d[3], d[4], d[5]};
    Rational largest = std::max(size_of(shift), Rational(size_of(turn) * radius_));
    for (const SpatialContactInk& c : contacts_) {
      largest = std::max(largest, size_of(stickslip::displacement(c.position, d)));
    }
    ink_.motion_factor = enlargement(largest, radius_);
    const Rational& factor = ink_.motion_factor;
    if (factor.is_zero()) return;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vector3 move = stickslip::displacement(contacts_[i].position, d);
      add_arrow(contacts_[i].at,
                over_size({factor * move[0], factor * move[1], factor * move[2]}, radius_),
                "motion", {{"data-contact", std::to_string(i)}, {value_, text_of(move)}});
    }
    // The body as the motion moves it: linear in d, as the model is.
    const InkVector shifted =
        over_size({factor * shift[0], factor * shift[1], factor * shift[2]}, radius_);
    const InkVector turned =
        over_size({factor * turn[0], factor * turn[1], factor * turn[2]}, 1);
    std::vector<InkVector> moved;
    for (const InkVector& p : body_points()) {
      const InkVector by{turned[1] * p[2] - turned[2] * p[1],
                         turned[2] * p[0] - turned[0] * p[2],
                         turned[0] * p[1] - turned[1] * p[0]};
      moved.push_back(sum(sum(p, 1, shifted), 1, by));
    }
    for (std::size_t k = 0; k < kSides.size(); ++k) ink_.scenes[k].ghost = seen(k, moved);
  }

  const Question& question_;
  const Verdict& verdict_;
  const GraspBox& grasp_;
  Vector3 centre_{};
  Rational radius_{1};
  std::vector<SpatialContactInk> contacts_;
  std::vector<SpatialForce> forces_;  ///< of a stable verdict
  const char* value_ = "data-value";  ///< the attribute for what the forces and motions are
  GraspInk ink_;
};

}  // namespace

GraspInk spatial_ink(const Question& question, const Verdict& verdict) {
  return SpatialReader(question, verdict).read();
}

}  // namespace stickslip::plot_detail
