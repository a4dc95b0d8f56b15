// SPDX-License-Identifier: GPL-3.0-or-later
// Several bodies in the plane.
#include <algorithm>
#include <utility>

#include "grasp_ink.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/spatial_forces.hpp"

namespace stickslip::plot_detail {
namespace {

Vector2 in_plane(const Vector3& v) {
  return {v[0], v[1]};
}

class BodiesReader {
 public:
  BodiesReader(const Question& question, const Verdict& verdict)
      : question_(question),
        verdict_(verdict),
        box_(*question.box()),
        mechanism_(*box_.mechanism) {}

  GraspInk read() {
    const Grasp all = drawn(std::nullopt);
    frame_ = picture_frame(all);
    ink_.set_title(all.name(), question_.case_name);
    ink_.units = all.description().units;
    ink_.outline_is_given = !all.description().outline.empty();
    ink_.body_within = RingsAround::kAnyWinding;
    for (const Contact& c : all.contacts()) ink_.preloads.push_back(c.preload);
    ink_.choose_sizes();
    scene_.contacts = contact_ink(all, frame_);
    ink_.marks.assign(all.size(), ContactMark::kUnknown);
    for (std::size_t i = 0; i < all.size(); ++i) {
      scene_.cones.push_back(
          planar_cone(scene_.contacts[i], all.contacts()[i].friction, ink_.cone_length));
    }
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) rings_.push_back(rings_of(b));
    for (const auto& rings : rings_) {
      scene_.outline.insert(scene_.outline.end(), rings.begin(), rings.end());
    }
    choose_force_unit();
    add_loads();
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      add_motion(stable->motion);
      add_forces(*stable);
    } else if (std::holds_alternative<Unstable>(verdict_)) {
      ink_.caption.push_back("No motion and forces satisfy all conditions.");
    } else if (const auto* undecided = std::get_if<Undecided>(&verdict_)) {
      ink_.caption.push_back("Undecided: " + in_words(*undecided) + ".");
    }
    ink_.scenes.push_back(std::move(scene_));
    return std::move(ink_);
  }

 private:
  /// All contacts and outlines as of one body; or those of one body, with what presses it.
  Grasp drawn(BodyIndex body) const {
    std::vector<Contact> contacts;
    for (const UncertainContact& c : box_.contacts) {
      if (body && c.of != body && c.by != body) continue;
      const int sign = body && c.by == body ? -1 : 1;
      contacts.push_back({{c.position[0].middle(), c.position[1].middle()},
                          {sign * c.normal[0], sign * c.normal[1]},
                          c.friction.middle(),
                          c.stiffness.middle(),
                          c.preload.middle()});
    }
    GraspDescription description = box_.description;
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      if (body && b != *body) continue;
      const std::vector<Polygon>& outline = mechanism_.bodies[b].outline;
      description.outline.insert(description.outline.end(), outline.begin(), outline.end());
    }
    return Grasp(std::move(contacts), std::move(description));
  }

  /// Of a body its outline, or what stands for it; of a link without one, from its hinge on.
  std::vector<std::vector<InkPoint>> rings_of(std::size_t b) const {
    const Body& body = mechanism_.bodies[b];
    const Grasp alone = drawn(b);
    if (body.outline.empty() && body.link && !body.link->slides) {
      std::vector<InkPoint> points;
      const auto add = [&](const RationalRow& p) {  // a little around it, so that it is seen
        constexpr double kAround = 0.03;
        const InkPoint at = frame_.place({p[0], p[1]});
        for (const double x : {-kAround, kAround}) {
          for (const double y : {-kAround, kAround}) points.push_back(at + InkPoint{x, y});
        }
      };
      add(body.link->at);
      for (const Contact& c : alone.contacts()) add({c.position.x, c.position.y});
      for (const Body& other : mechanism_.bodies) {
        if (other.link && other.link->on == BodyIndex(b) && !other.link->slides) {
          add(other.link->at);
        }
      }
      return {convex_hull(std::move(points))};
    }
    if (body.outline.empty() && alone.size() == 0) return {};
    return body_outline(alone, frame_, contact_ink(alone, frame_));
  }

  std::vector<SpatialForce> forces() const {
    const auto* stable = std::get_if<Stable>(&verdict_);
    const auto* witness =
        stable != nullptr ? std::get_if<ShareWitness>(&stable->proof) : nullptr;
    if (witness == nullptr) return {};
    return forces_of(box_, witness->twist, witness->shares);
  }

  Vector2 load_on(std::size_t body) const {
    const std::size_t first = mechanism_.first_coordinate(body);
    return {box_.wrench[first].middle(), box_.wrench[first + 1].middle()};
  }

  void choose_force_unit() {
    for (const SpatialForce& f : forces()) {
      ink_.force_unit = std::max(ink_.force_unit, largest_entry(in_plane(f.force)));
    }
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      if (mechanism_.bodies[b].link) continue;
      ink_.force_unit = std::max(ink_.force_unit, largest_entry(load_on(b)));
    }
  }

  /// At each body that is no link the force on it, in its middle; all else is in the caption.
  void add_loads() {
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      if (mechanism_.bodies[b].link || rings_[b].empty()) continue;
      const Vector2 force = load_on(b);
      if (largest_entry(force).is_zero()) continue;
      InkPoint middle{0, 0};
      const std::vector<InkPoint>& ring = rings_[b].front();
      for (const InkPoint& p : ring) middle = middle + 1 / static_cast<double>(ring.size()) * p;
      scene_.arrows.push_back({middle,
                               middle + ink_.force(force),
                               "load",
                               {{"data-value", pair_text(force)}, {"data-factor", "1"}}});
    }
    std::string load;
    for (std::size_t j = 0; j < box_.wrench.size(); ++j) {
      const Rational w = box_.wrench[j].middle();
      if (w.is_zero()) continue;
      load += (load.empty() ? "" : ", ") + mechanism_.coordinate_name(j) + " " + short_text(w);
    }
    ink_.caption.push_back((load.empty() ? "No load" : "Load: " + load) +
                           ". Normal law: " + to_string(question_.law) + "." +
                           (ink_.units ? " Units:" + plot_detail::force_unit(ink_.units) + "," +
                                             length_unit(ink_.units) + "."
                                       : ""));
  }

  RationalRow twist_of_body(BodyIndex body, const RationalRow& z) const {
    RationalRow twist;
    for (const RationalRow& row : mechanism_.motion_of(body)) twist.push_back(dot(row, z));
    return twist;
  }

  /// The bodies as they are moved, all by one factor: linear in z, as the model is.
  void add_motion(const RationalRow& z) {
    Rational largest = 0;
    std::vector<RationalRow> twists;
    for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
      const RationalRow& d = twists.emplace_back(twist_of_body(b, z));
      const Vector2 shift{d[0] - d[2] * frame_.centre.y, d[1] + d[2] * frame_.centre.x};
      largest = std::max({largest, largest_entry(shift), Rational(abs(d[2]) * frame_.radius)});
    }
    ink_.motion_factor = enlargement(largest, frame_.radius);
    if (ink_.motion_factor.is_zero()) return;
    for (std::size_t b = 0; b < twists.size(); ++b) {
      const RationalRow& d = twists[b];
      const Vector2 shift{d[0] - d[2] * frame_.centre.y, d[1] + d[2] * frame_.centre.x};
      const InkPoint move =
          ratio({ink_.motion_factor * shift.x, ink_.motion_factor * shift.y}, frame_.radius);
      const double turn = to_double(ink_.motion_factor * d[2]);
      for (std::vector<InkPoint> ring : rings_[b]) {
        for (InkPoint& p : ring) p = p + move + turn * quarter_turn(p);
        scene_.ghost.push_back(std::move(ring));
      }
    }
  }

  void add_forces(const Stable& stable) {
    const std::vector<SpatialForce> all = forces();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vector2 f = in_plane(all[i].force);
      ink_.marks[i] = all[i].normal.is_zero()                          ? ContactMark::kOpen
                      : largest_entry(in_plane(all[i].slip)).is_zero() ? ContactMark::kStick
                                                                       : ContactMark::kSlip;
      scene_.arrows.push_back(
          {scene_.contacts[i].at,
           scene_.contacts[i].at + ink_.force(f),
           "force",
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(f)}}});
    }
    std::string moves;
    for (std::size_t j = 0; j < stable.motion.size(); ++j) {
      if (stable.motion[j].is_zero()) continue;
      moves += (moves.empty() ? "" : ", ") + mechanism_.coordinate_name(j) + " " +
               short_text(stable.motion[j]);
    }
    ink_.caption.push_back(
        (moves.empty() ? "Nothing moves. "
                       : "Motion: " + moves + ", drawn \u00D7\u202F" +
                             short_text(ink_.motion_factor) + ". ") +
        (all.empty() ? "There is an equilibrium near it, proved by degree."
                     : "The forces are those on the body that a contact presses; they balance "
                       "the load, checked exactly."));
  }

  const Question& question_;
  const Verdict& verdict_;
  const GraspBox& box_;
  const Mechanism& mechanism_;
  PictureFrame frame_;
  std::vector<std::vector<std::vector<InkPoint>>> rings_;  ///< by body
  SceneInk scene_;
  GraspInk ink_;
};

}  // namespace

GraspInk bodies_ink(const Question& question, const Verdict& verdict) {
  if (question.in_space()) {
    throw InputError("", "", "there are several bodies in space",
                     "pictures of several bodies are drawn in the plane only");
  }
  if (!question.box()->is_point()) {
    throw InputError("", "", "some numbers are uncertain",
                     "a picture of several bodies needs one number for each");
  }
  return BodiesReader(question, verdict).read();
}

}  // namespace stickslip::plot_detail
