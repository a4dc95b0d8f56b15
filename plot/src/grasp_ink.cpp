// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_ink.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/error.hpp"
#include "stickslip/core/sign.hpp"

namespace stickslip {
namespace {

constexpr double kLongestCone = 0.7;
const Rational kLongestMotion(3, 10);

Vector2 displacement(const Vector2& point, const Twist& d) {
  return {d.x - d.r * point.y, d.y + d.r * point.x};
}

std::string pair_text(const Vector2& v) {
  return to_string(v.x) + "," + to_string(v.y);
}

class GraspReader {
 public:
  GraspReader(const Question& question, const Verdict& verdict)
      : question_(question),
        verdict_(verdict),
        grasp_(question.loaded.grasp),
        wrench_(question.loaded.wrench),
        rows_(contact_rows(grasp_)) {}

  GraspInk read() {
    ink_.frame = picture_frame(grasp_);
    ink_.contacts = contact_ink(grasp_, ink_.frame);
    ink_.outline = body_outline(ink_.contacts);
    ink_.states.assign(grasp_.size(), ContactState::kUnknown);
    for (std::size_t i = 0; i < grasp_.size(); ++i) ink_.cones.push_back(cone(i));
    choose_force_unit();
    add_load();
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      add_witness(stable->witness);
    } else if (const auto* unstable = std::get_if<Unstable>(&verdict_)) {
      add_refutation(unstable->refutation);
    } else {
      ink_.caption.push_back("Undecided: given up at " + std::get<Undecided>(verdict_).limit +
                             ".");
    }
    return std::move(ink_);
  }

 private:
  /// The force of contact i, exactly.
  Vector2 force(const Witness& witness, std::size_t i) const {
    return force_vector(grasp_.contacts()[i].normal, witness.forces[i]);
  }

  void choose_force_unit() {
    ink_.force_unit = largest_entry({wrench_.x, wrench_.y});
    for (const Contact& c : grasp_.contacts())
      ink_.force_unit = std::max(ink_.force_unit, c.preload);
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      require(stable->witness.forces.size() == grasp_.size(),
              "plot_grasp: the verdict is not about this grasp");
      for (std::size_t i = 0; i < grasp_.size(); ++i) {
        ink_.force_unit = std::max(ink_.force_unit, largest_entry(force(stable->witness, i)));
      }
    }
  }

  /// The wrench as a force at the centre of the scene and a torque about it.
  void add_load() {
    ink_.torque =
        wrench_.torque - (ink_.frame.centre.x * wrench_.y - ink_.frame.centre.y * wrench_.x);
    const Vector2 force{wrench_.x, wrench_.y};
    ink_.arrows.push_back(
        {{0, 0}, ink_.force(force), "load", {{"data-value", pair_text(force)}}});
    ink_.caption.push_back(
        "Applied wrench w = " + short_tuple({wrench_.x, wrench_.y, wrench_.torque}) +
        (ink_.frame.centre == Vector2{}
             ? ""
             : ", drawn at " + short_tuple({ink_.frame.centre.x, ink_.frame.centre.y}) +
                   ", where its torque is " + short_text(ink_.torque)) +
        ". Normal law: " + to_string(question_.law) + ".");
  }

  /// Adds an arrow for the motion of each contact; returns the factor of enlargement.
  Rational add_motion(const Twist& d, const std::string& css_class) {
    // The contacts may move less than the body, and not at all.
    Rational largest = std::max(largest_entry(displacement(ink_.frame.centre, d)),
                                Rational(abs(d.r) * ink_.frame.radius));
    for (const Contact& c : grasp_.contacts()) {
      largest = std::max(largest, largest_entry(displacement(c.position, d)));
    }
    if (largest.is_zero()) return 0;
    const Rational factor = round_down(kLongestMotion * ink_.frame.radius / largest);
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const Vector2 move = displacement(grasp_.contacts()[i].position, d);
      ink_.arrows.push_back(
          {ink_.contacts[i].at,
           ink_.contacts[i].at + ratio({factor * move.x, factor * move.y}, ink_.frame.radius),
           css_class,
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(move)}}});
    }
    return factor;
  }

  void add_witness(const Witness& witness) {
    const Twist& d = witness.twist;
    ink_.motion_factor = add_motion(d, "motion");
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const Sign slip = sign_of(power(rows_[i].tangent, d));
      ink_.states[i] = rows_[i].normal_coefficient(d).sign() < 0 ? ContactState::kOpen
                       : slip == Sign::kPositive                 ? ContactState::kSlipPlus
                       : slip == Sign::kNegative                 ? ContactState::kSlipMinus
                                                                 : ContactState::kStick;
      const Vector2 f = force(witness, i);
      ink_.arrows.push_back(
          {ink_.contacts[i].at,
           ink_.contacts[i].at + ink_.force(f),
           "force",
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(f)}}});
    }
    if (!ink_.motion_factor.is_zero()) ink_.ghost = moved_outline(d);
    ink_.caption.push_back(
        "Motion d = " + short_tuple({d.x, d.y, d.r}) +
        (ink_.motion_factor.is_zero()
             ? ": nothing moves."
             : ", drawn \u00D7\u202F" + short_text(ink_.motion_factor) + ".") +
        " The forces balance w; checked exactly.");
  }

  /// The outline as the motion moves it: linear in d, as the model is.
  std::vector<InkPoint> moved_outline(const Twist& d) const {
    const Vector2 shift = displacement(ink_.frame.centre, d);
    const InkPoint move =
        ratio({ink_.motion_factor * shift.x, ink_.motion_factor * shift.y}, ink_.frame.radius);
    const double turn = to_double(ink_.motion_factor * d.r);
    std::vector<InkPoint> moved = ink_.outline;
    for (InkPoint& p : moved) p = p + move + turn * quarter_turn(p);
    return moved;
  }

  void add_refutation(const Refutation& refutation) {
    const auto* leaf =
        refutation.size() == 1 ? std::get_if<VirtualWorkLeaf>(&refutation[0]) : nullptr;
    if (leaf == nullptr) {
      const auto cases =
          std::count_if(refutation.begin(), refutation.end(), [](const RefutationNode& node) {
            return std::holds_alternative<VirtualWorkLeaf>(node);
          });
      ink_.caption.push_back(cases == 0
                                 ? "The normal law allows no motion at all."
                                 : "No motion and forces satisfy all conditions: proved in " +
                                       std::to_string(cases) + " cases.");
      return;
    }
    // Along the leaf's twist the wrenches of load and contacts together do negative work
    // whatever the contacts do; so against it, the load drives the object.
    const Twist drift{Rational(-leaf->twist[0]), Rational(-leaf->twist[1]),
                      Rational(-leaf->twist[2])};
    ink_.virtual_factor = add_motion(drift, "virtual");
    ink_.caption.push_back("Whatever the contacts do, along the virtual twist " +
                           short_tuple({drift.x, drift.y, drift.r}));
    ink_.caption.push_back("the load does more work than the contacts can take up.");
  }

  /// A sector, so that wide cones look wide.
  std::vector<InkPoint> cone(std::size_t i) const {
    constexpr int kSteps = 12;
    // Shorter when there are many, so that they leave room for the rest.
    const double size =
        kLongestCone * std::min(1.0, 2.2 / std::sqrt(static_cast<double>(grasp_.size())));
    const ContactInk& c = ink_.contacts[i];
    const double half_angle = std::atan(to_double(grasp_.contacts()[i].friction));
    std::vector<InkPoint> sector{c.at};
    for (int step = -kSteps; step <= kSteps; ++step) {
      const double angle = half_angle * step / kSteps;
      sector.push_back(c.at + size * std::cos(angle) * c.normal +
                       size * std::sin(angle) * c.tangent);
    }
    return sector;
  }

  const Question& question_;
  const Verdict& verdict_;
  const Grasp& grasp_;
  const Wrench& wrench_;
  std::vector<ContactRow> rows_;
  GraspInk ink_;
};

}  // namespace

double GraspInk::force_length(const Rational& size) const {
  return size.is_zero() ? 0 : kLongestForce * to_double(size / force_unit);
}

InkPoint GraspInk::force(const Vector2& exact) const {
  return {force_length(exact.x), force_length(exact.y)};
}

GraspInk grasp_ink(const Question& question, const Verdict& verdict) {
  return GraspReader(question, verdict).read();
}

}  // namespace stickslip
