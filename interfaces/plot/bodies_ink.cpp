// SPDX-License-Identifier: GPL-3.0-or-later
// A body in space, and several bodies. Those in the plane are seen from above.
#include <algorithm>
#include <cmath>
#include <utility>

#include "grasp_ink.hpp"
#include "spatial_scene.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/integer_vector.hpp"
#include "stickslip/engine/near_forces.hpp"

namespace stickslip::plot_detail {
namespace {

/// Returns a vector in space; one of the plane has 0 for z.
Vector3 of_space(const RationalRow& v) {
  return {v.at(0), v.at(1), v.size() > 2 ? v[2] : Rational(0)};
}

Vector3 times(const Rational& factor, const Vector3& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

class BodiesReader {
 public:
  BodiesReader(const Question& question, const Verdict& verdict)
      : question_(question),
        verdict_(verdict),
        grasp_(*question.box()),
        mechanism_(question.mechanism()),
        sides_(sides_of(question.in_space())) {}

  GraspInk read() {
    ink_.set_title(grasp_.description.name, question_.case_name);
    ink_.units = grasp_.description.units;
    ink_.of_several = mechanism_ != nullptr;
    add_contacts();
    ink_.marks.assign(contacts_.size(), ContactMark::kUnknown);
    for (std::size_t b = 0; b < bodies(); ++b) shapes_.push_back(shape_of(b));
    for (const LineOfSight& side : sides_) {
      ink_.scenes.emplace_back();
      ink_.scenes.back().heading = side.heading;
      ink_.scenes.back().axes = {side.right, side.up};
    }
    const auto* stable = std::get_if<Stable>(&verdict_);
    if (stable != nullptr) read_forces(*stable);
    add_loads();
    draw_contacts();
    draw_bodies();
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
  std::size_t bodies() const { return mechanism_ == nullptr ? 1 : mechanism_->bodies.size(); }
  const Link* link_of(std::size_t b) const {
    return mechanism_ != nullptr && mechanism_->bodies[b].link ? &*mechanism_->bodies[b].link
                                                               : nullptr;
  }
  const Mesh* mesh_of(std::size_t b) const {
    return mechanism_ == nullptr ? grasp_.description.body.get()
                                 : mechanism_->bodies[b].mesh.get();
  }

  const std::vector<Polygon>& outline_of(std::size_t b) const {
    return mechanism_ == nullptr ? grasp_.description.outline : mechanism_->bodies[b].outline;
  }

  InkVector place(const Vector3& p) const {
    return over_size({p[0] - centre_[0], p[1] - centre_[1], p[2] - centre_[2]}, radius_);
  }

  void add_contacts() {
    std::vector<std::vector<Rational>> all;
    for (const UncertainContact& c : grasp_.contacts) {
      RationalRow middle;
      for (const Interval& x : c.position) middle.push_back(x.middle());
      const Vector3 position = of_space(middle);
      all.emplace_back(position.begin(), position.end());
      contacts_.push_back({position, {}, {}, {}, {}});
      ink_.preloads.push_back(c.preload.middle());
    }
    ink_.outline_is_given = true;
    for (std::size_t b = 0; b < bodies(); ++b) {
      std::size_t given = 0;
      for_each_vertex(b, [&](const Vector3& v) {
        all.emplace_back(v.begin(), v.end());
        ++given;
      });
      ink_.outline_is_given = ink_.outline_is_given && given > 0;
    }
    const Surroundings around = surroundings(all, 3);
    radius_ = around.radius;
    std::copy(around.centre.begin(), around.centre.end(), centre_.begin());
    ink_.choose_sizes();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      SpatialContactInk& c = contacts_[i];
      c = spatial_contact_ink(c.position, place(c.position),
                              of_space(grasp_.contacts[i].normal));
    }
  }

  /// Calls f for each vertex that somebody gave of a body.
  template <class Function>
  void for_each_vertex(std::size_t b, Function f) const {
    if (const Mesh* mesh = mesh_of(b)) {
      for (const Vector3& v : mesh->vertices) f(v);
    }
    for (const Polygon& polygon : outline_of(b)) {
      for (const Ring& ring : polygon) {
        for (const Vector2& v : ring) f(Vector3{v.x, v.y, 0});
      }
    }
  }

  Shape shape_of(std::size_t b) const {
    Shape shape;
    for_each_vertex(b, [&](const Vector3& v) { shape.points.push_back(place(v)); });
    if (const Mesh* mesh = mesh_of(b)) {
      shape.kind = Shape::Kind::kFaces;
      shape.parts = mesh->faces;
      return shape;
    }
    if (!shape.points.empty()) {
      shape.kind = Shape::Kind::kRings;
      std::size_t next = 0;
      for (const Polygon& polygon : outline_of(b)) {
        for (const Ring& ring : polygon) {
          shape.parts.emplace_back();
          for (std::size_t k = 0; k < ring.size(); ++k) shape.parts.back().push_back(next++);
        }
      }
      return shape;
    }
    const std::vector<SpatialContactInk> contacts = contacts_of(b);
    const Link* link = link_of(b);
    if (link == nullptr || link->slides) return sketch(contacts, question_.in_space());
    std::vector<InkVector> points;  // the points from hinge to hinge
    for (const SpatialContactInk& c : contacts) points.push_back(c.at);
    for (std::size_t other = 0; other < bodies(); ++other) {
      const Link* held = link_of(other);
      if (held == nullptr || held->slides || (other != b && held->on != BodyIndex(b))) continue;
      points.push_back(place(of_space(held->at)));
    }
    return sketch_of_link(points, question_.in_space());
  }

  /// Returns the contacts of a body, with normals into it.
  std::vector<SpatialContactInk> contacts_of(std::size_t b) const {
    if (mechanism_ == nullptr) return contacts_;
    std::vector<SpatialContactInk> own;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const UncertainContact& c = grasp_.contacts[i];
      if (c.of != b && c.by != b) continue;
      own.push_back(contacts_[i]);
      if (c.by == b) own.back().normal = sum({}, -1, own.back().normal);
    }
    return own;
  }

  /// Reads the forces of the witness, or those near the equilibrium.
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

  /// Returns "1/2,-3": with as many coordinates as the file has.
  std::string text_of(const Vector3& v) const {
    return to_string(v[0]) + "," + to_string(v[1]) +
           (question_.in_space() ? "," + to_string(v[2]) : "");
  }

  void add_arrow(const InkVector& tail, const InkVector& along, const std::string& css_class,
                 const Svg::Attributes& attributes) {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      ink_.scenes[k].arrows.push_back(
          {sides_[k](tail), sides_[k](sum(tail, 1, along)), css_class, attributes});
    }
  }

  std::vector<Rational> load() const {
    std::vector<Rational> w;
    for (const Interval& interval : grasp_.wrench) w.push_back(interval.middle());
    return w;
  }

  /// \{ Returns the force and the torque of a wrench, whose coordinates come first in the row.
  Vector3 force_in(const RationalRow& w) const {
    return {w[0], w[1], question_.in_space() ? w[2] : Rational(0)};
  }
  Vector3 torque_in(const RationalRow& w) const {
    return question_.in_space() ? Vector3{w[3], w[4], w[5]} : Vector3{0, 0, w[2]};
  }
  /// \}

  void add_loads() {
    const std::vector<Rational> w = load();
    std::vector<std::pair<InkVector, Vector3>> pulls;  // the point and the force of each pull
    if (mechanism_ == nullptr) pulls.push_back({{}, force_in(w)});
    for (std::size_t b = 0; mechanism_ != nullptr && b < bodies(); ++b) {
      if (link_of(b) != nullptr || shapes_[b].points.empty()) continue;
      const RationalRow own(
          w.begin() + static_cast<std::ptrdiff_t>(mechanism_->first_coordinate(b)), w.end());
      pulls.push_back(
          {point_of_pull(shapes_[b], force_in(own), torque_in(own)), force_in(own)});
    }
    Rational largest = 0;
    for (const auto& [at, pull] : pulls) largest = std::max(largest, size_of(pull));
    ink_.force_unit = std::max(ink_.force_unit, largest);
    ink_.choose_load_factor(largest);
    for (const auto& [at, pull] : pulls) {
      if (mechanism_ != nullptr && size_of(pull).is_zero()) continue;
      add_arrow(at, sum({}, to_double(ink_.load_factor), force(pull)), "load",
                {{"data-value", text_of(pull)}, {"data-factor", to_string(ink_.load_factor)}});
    }
    if (mechanism_ == nullptr) {
      describe_load(w);
    } else {
      ink_.describe_load("Load: " + named(w), question_.law);
    }
  }

  /// Returns the point at which a force with this torque about the origin acts on a body: near
  /// its middle, on the line along which it may be shifted, if that meets the body; else in the
  /// middle.
  InkVector point_of_pull(const Shape& shape, const Vector3& pull,
                          const Vector3& torque) const {
    const InkVector middle = shape.middle();
    if (size_of(pull).is_zero()) return middle;
    const Vector3 arm = stickslip::cross(centre_, pull);
    const Vector3 about{torque[0] - arm[0], torque[1] - arm[1], torque[2] - arm[2]};
    const InkVector foot = over_size(stickslip::cross(pull, about),
                                     Rational(stickslip::dot(pull, pull)) * radius_);
    const InkVector along = over_size(pull, size_of(pull));
    const InkVector to_middle = sum(middle, -1, foot);
    const InkVector at =
        sum(foot, stickslip::dot(to_middle, along) / stickslip::dot(along, along), along);
    double reach = 0;  // squared
    for (const InkVector& point : shape.points) {
      const InkVector from = sum(point, -1, middle);
      reach = std::max(reach, stickslip::dot(from, from));
    }
    const InkVector off = sum(at, -1, middle);
    return stickslip::dot(off, off) <= reach ? at : middle;
  }

  /// Describes the load of one body, with the torque about the centre of the scene.
  void describe_load(const std::vector<Rational>& w) {
    const Vector3 arm = stickslip::cross(centre_, force_in(w));
    Vector3 torque = torque_in(w);
    for (std::size_t j = 0; j < 3; ++j) torque[j] -= arm[j];
    const std::string text = question_.in_space()
                                 ? short_tuple({torque[0], torque[1], torque[2]})
                                 : short_text(torque[2]);
    if (!size_of(torque).is_zero()) ink_.torque = text;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      ink_.scenes[k].torque = sides_[k].sign * torque[sides_[k].towards];
    }
    std::vector<Rational> centre{centre_[0], centre_[1]};
    if (question_.in_space()) centre.push_back(centre_[2]);
    ink_.describe_load(w, centre, text, question_.law);
  }

  /// Returns the entries of a load or a state of several bodies that are not 0, with their
  /// names.
  std::string named(const std::vector<Rational>& values) const {
    std::string text;
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (values[j].is_zero()) continue;
      text += (text.empty() ? "" : ", ") + mechanism_->coordinate_name(j) + " " +
              short_text(values[j]);
    }
    return text.empty() ? "0" : text;
  }

  void draw_contacts() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      SceneInk& scene = ink_.scenes[k];
      for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const SpatialContactInk& c = contacts_[i];
        const double angle = std::atan(to_double(grasp_.contacts[i].friction.middle()));
        scene.contacts.push_back(
            {sides_[k](c.at), sides_[k](c.normal), {}, !grasp_.contacts[i].by});
        scene.cones.push_back(hull_seen(sides_[k], cone_around(c, angle, ink_.cone_length)));
      }
    }
  }

  void draw_bodies() {
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      for (std::size_t b = 0; b < bodies(); ++b) {
        BodyInk& body = ink_.scenes[k].bodies.emplace_back();
        body.outline = shapes_[b].seen(sides_[k]);
        body.within = shapes_[b].within();
        if (mechanism_ == nullptr) continue;
        body.name = mechanism_->bodies[b].name;
        if (const Link* link = link_of(b)) body.held = held_by(*link, b, sides_[k]);
      }
    }
  }

  /// Returns the ends of a piece of a hinge's axis, or of the line along which a link slides.
  std::array<InkPoint, 2> held_by(const Link& link, std::size_t b,
                                  const LineOfSight& side) const {
    constexpr double kPin = 0.15;
    constexpr double kRail = 0.5;
    const InkVector at = link.slides ? shapes_[b].middle() : place(of_space(link.at));
    InkVector along{};
    if (!link.axis.empty()) {
      along = over_size(of_space(link.axis), size_of(of_space(link.axis)));
    }
    const double size = link.slides ? kRail : kPin;
    return {side(sum(at, -size, along)), side(sum(at, size, along))};
  }

  void add_equilibrium(const Stable& stable) {
    add_motion(stable.motion);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const SpatialForce& f = forces_[i];
      const bool sticks = size_of(f.slip).is_zero() && f.spin.is_zero();
      ink_.marks[i] = f.normal.is_zero() ? ContactMark::kOpen
                      : sticks           ? ContactMark::kStick
                                         : ContactMark::kSlip;
      add_arrow(contacts_[i].at, force(f.force), "force",
                {{"data-contact", std::to_string(i)}, {value_, text_of(f.force)}});
    }
    const bool exact = std::holds_alternative<ShareWitness>(stable.proof);
    const std::string what =
        mechanism_ == nullptr ? "d = " + short_tuple(stable.motion) : named(stable.motion);
    const std::string of_whom =
        mechanism_ == nullptr ? "" : ", on the bodies that contacts press,";
    ink_.describe_motion(
        (exact ? "Motion " : "Near the motion ") + what,
        exact ? "The forces" + of_whom + " balance " +
                    (mechanism_ == nullptr ? "w" : "the load") + "; checked exactly."
              : "There is an equilibrium near it, proved by degree; what is drawn of it is in "
                "floating point, for people, and proves nothing.");
  }

  /// Returns the motion of a body in space: a shift and a turn about the origin.
  RationalRow twist_of(BodyIndex body, const RationalRow& motion) const {
    RationalRow twist = motion;
    if (mechanism_ != nullptr) {
      twist.clear();
      for (const RationalRow& row : mechanism_->motion_of(body)) {
        twist.push_back(stickslip::dot(row, motion));
      }
    }
    if (twist.size() == 3) return {twist[0], twist[1], 0, 0, 0, twist[2]};
    return twist;
  }

  /// Returns the motion, at the contact, of the body that it presses, seen from the other one.
  Vector3 move_at(std::size_t contact, const RationalRow& motion) const {
    const UncertainContact& c = grasp_.contacts[contact];
    const Vector3& p = contacts_[contact].position;
    Vector3 move = stickslip::displacement(p, twist_of(c.of, motion));
    if (mechanism_ == nullptr) return move;
    const Vector3 other = stickslip::displacement(p, twist_of(c.by, motion));
    for (std::size_t j = 0; j < 3; ++j) move[j] -= other[j];
    return move;
  }

  void add_motion(const RationalRow& motion) {
    // The contacts may move less than the bodies, or not at all.
    Rational largest = 0;
    for (std::size_t b = 0; b < bodies(); ++b) {
      const RationalRow d = twist_of(b, motion);
      largest = std::max({largest, size_of(stickslip::displacement(centre_, d)),
                          Rational(size_of({d[3], d[4], d[5]}) * radius_)});
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      largest = std::max(largest, size_of(move_at(i, motion)));
    }
    ink_.motion_factor = enlargement(largest, radius_);
    const Rational& factor = ink_.motion_factor;
    if (factor.is_zero()) return;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const Vector3 move = move_at(i, motion);
      add_arrow(contacts_[i].at, over_size(times(factor, move), radius_), "motion",
                {{"data-contact", std::to_string(i)}, {value_, text_of(move)}});
    }
    for (std::size_t b = 0; b < bodies(); ++b) {
      const Shape moved = moved_by(shapes_[b], twist_of(b, motion));
      for (std::size_t k = 0; k < sides_.size(); ++k) {
        ink_.scenes[k].bodies[b].ghost = moved.seen(sides_[k]);
      }
    }
  }

  /// Returns the shape moved by the enlarged motion, which is linear in the twist, as the model
  /// is.
  Shape moved_by(Shape shape, const RationalRow& d) const {
    const Rational& factor = ink_.motion_factor;
    const InkVector shifted =
        over_size(times(factor, stickslip::displacement(centre_, d)), radius_);
    const InkVector turned = over_size(times(factor, {d[3], d[4], d[5]}), 1);
    for (InkVector& p : shape.points) {
      const InkVector by{turned[1] * p[2] - turned[2] * p[1],
                         turned[2] * p[0] - turned[0] * p[2],
                         turned[0] * p[1] - turned[1] * p[0]};
      p = sum(sum(p, 1, shifted), 1, by);
    }
    return shape;
  }

  const Question& question_;
  const Verdict& verdict_;
  const GraspBox& grasp_;
  const Mechanism* mechanism_;  ///< null: one body
  std::vector<LineOfSight> sides_;
  Vector3 centre_{};
  Rational radius_{1};
  std::vector<SpatialContactInk> contacts_;
  std::vector<Shape> shapes_;         ///< by body
  std::vector<SpatialForce> forces_;  ///< of a stable verdict
  const char* value_ = "data-value";  ///< the attribute for the values of forces and motions
  GraspInk ink_;
};

}  // namespace

GraspInk bodies_ink(const Question& question, const Verdict& verdict) {
  if (question.mechanism() != nullptr && !question.box()->is_point()) {
    throw InputError("", "", "some numbers are uncertain",
                     "a picture of several bodies needs one number for each");
  }
  return BodiesReader(question, verdict).read();
}

}  // namespace stickslip::plot_detail
