// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_ink.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/error.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/equilibrium/contact_mode.hpp"
#include "stickslip/equilibrium/decide.hpp"

namespace stickslip::plot_detail {
namespace {

constexpr double kLongestCone = 0.7;
const Rational kLongestMotion(3, 10);
/// A load that would be shorter than this share of the longest force has a scale of its own,
/// with at most the other length.
const Rational kShortestLoad(1, 8);
const Rational kEnlargedLoad(3, 5);
const Rational kFarPivot(3, 2);  ///< from the centre, in scene units
constexpr std::size_t kMostListed = 12;
const Rational kLongTwist(100000);  ///< entries from here on are hard to read

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
        problem_(problem_of(question)) {}

  GraspInk read() {
    ink_.frame = picture_frame(grasp_);
    ink_.contacts = contact_ink(grasp_, ink_.frame);
    ink_.outline = body_outline(grasp_, ink_.frame, ink_.contacts);
    ink_.marks.assign(grasp_.size(), ContactMark::kUnknown);
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
    const Rational size = largest_entry(force);
    if (!size.is_zero() && size < kShortestLoad * ink_.force_unit) {
      ink_.load_factor = round_down(kEnlargedLoad * ink_.force_unit / size);
    }
    ink_.arrows.push_back(
        {{0, 0},
         ink_.force({ink_.load_factor * force.x, ink_.load_factor * force.y}),
         "load",
         {{"data-value", pair_text(force)}, {"data-factor", to_string(ink_.load_factor)}}});
    ink_.caption.push_back(
        "Applied wrench w = " + short_tuple({wrench_.x, wrench_.y, wrench_.torque}) +
        (ink_.frame.centre == Vector2{}
             ? ""
             : ", drawn at " + short_tuple({ink_.frame.centre.x, ink_.frame.centre.y}) +
                   ", where its torque is " + short_text(ink_.torque)) +
        ". Normal law: " + to_string(question_.law) + "." + units_text());
  }

  std::string units_text() const {
    if (!grasp_.description().units) return "";
    return " Units:" + force_unit(grasp_) + "," + length_unit(grasp_) + ".";
  }

  /// Adds an arrow for the motion of each contact and the body's ghost; returns the factor of
  /// enlargement.
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
    ink_.ghost = moved_outline(d, factor);
    return factor;
  }

  void add_witness(const Witness& witness) {
    const Twist& d = witness.twist;
    ink_.motion_factor = add_motion(d, "motion");
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const ContactMode mode = mode_of(problem_, ContactId(i), d);
      ink_.marks[i] = !mode.closed                   ? ContactMark::kOpen
                      : mode.slip == Sign::kPositive ? ContactMark::kSlipPlus
                      : mode.slip == Sign::kNegative ? ContactMark::kSlipMinus
                                                     : ContactMark::kStick;
      const Vector2 f = force(witness, i);
      ink_.arrows.push_back(
          {ink_.contacts[i].at,
           ink_.contacts[i].at + ink_.force(f),
           "force",
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(f)}}});
    }
    ink_.caption.push_back(
        "Motion d = " + short_tuple({d.x, d.y, d.r}) +
        (ink_.motion_factor.is_zero()
             ? ": nothing moves."
             : ", drawn \u00D7\u202F" + short_text(ink_.motion_factor) + ".") +
        " The forces balance w; checked exactly.");
  }

  /// The outline as the motion moves it: linear in d, as the model is.
  std::vector<std::vector<InkPoint>> moved_outline(const Twist& d,
                                                   const Rational& factor) const {
    const Vector2 shift = displacement(ink_.frame.centre, d);
    const InkPoint move = ratio({factor * shift.x, factor * shift.y}, ink_.frame.radius);
    const double turn = to_double(factor * d.r);
    std::vector<std::vector<InkPoint>> moved = ink_.outline;
    for (std::vector<InkPoint>& ring : moved) {
      for (InkPoint& p : ring) p = p + move + turn * quarter_turn(p);
    }
    return moved;
  }

  void add_refutation(const Refutation& refutation) {
    const RefutationSummary proof = summarize(refutation, &problem_);
    if (proof.leaves == 0) {
      ink_.caption.push_back("The normal law allows no motion at all.");
      return;
    }
    const bool is_whole = proof.largest_case.empty();
    if (!is_whole) {
      ink_.caption.push_back("No motion and forces satisfy all conditions: proved in " +
                             std::to_string(proof.leaves) +
                             " cases. Shown is the largest one: " +
                             listed(proof.largest_case, "conditions") + ".");
    }
    // Along the leaf's twist the wrenches of load and contacts together do negative work
    // whatever the contacts do; so against it, they drive the object.
    Twist drift = twist_of(negated(proof.largest_case_twist));
    const Rational largest =
        std::max(largest_entry({drift.x, drift.y}), Rational(abs(drift.r)));
    if (largest.is_zero()) return;  // the case has no motion
    if (largest >= kLongTwist) {
      const Rational unit = round_down(largest);
      drift = {drift.x / unit, drift.y / unit, drift.r / unit};
    }
    ink_.virtual_factor = add_motion(drift, "virtual");
    add_pivot(drift);
    std::vector<std::string> losing;
    std::vector<std::string> idle;
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const bool opposes = can_oppose(i, drift, proof);
      ink_.marks[i] = opposes ? ContactMark::kLoses : ContactMark::kCannotOppose;
      (opposes ? losing : idle).push_back(std::to_string(i));
    }
    ink_.caption.push_back(
        std::string(is_whole ? "Whatever forces the contacts have, load and contacts"
                             : "Whatever forces the contacts have in it, load and contacts") +
        " together do positive work along the virtual twist " +
        short_tuple({drift.x, drift.y, drift.r}) + ", so they never balance.");
    const int work = power(wrench_, drift).sign();
    ink_.caption.push_back(
        std::string("The load ") +
        (work > 0   ? "drives"
         : work < 0 ? "works against"
                    : "does no work on") +
        " this motion" +
        contacts_text("; ", losing, "opposes it and loses", "oppose it and lose") +
        contacts_text("; ", idle, "cannot oppose it", "cannot oppose it") + ".");
  }

  /// Whether some force that the contact can have in the case does negative work on the drift.
  bool can_oppose(std::size_t i, const Twist& drift, const RefutationSummary& proof) const {
    const ContactId contact(i);
    if (proof.largest_case_open.count(contact) > 0) return false;
    const ContactRow& row = problem_.rows()[i];
    const Rational normal = power(row.normal, drift);
    const Rational friction = row.friction * power(row.tangent, drift);
    const auto slip = proof.largest_case_slips.find(contact);
    // Friction opposes the slip of the case's motions; without slip it has any direction.
    const Rational least = slip == proof.largest_case_slips.end() || slip->second == Sign::kZero
                               ? Rational(normal - abs(friction))
                               : Rational(normal - to_int(slip->second) * friction);
    return least.sign() < 0;
  }

  void add_pivot(const Twist& d) {
    if (d.r.is_zero()) return;
    const Vector2 pivot{-d.y / d.r - ink_.frame.centre.x, d.x / d.r - ink_.frame.centre.y};
    if (largest_entry(pivot) <= kFarPivot * ink_.frame.radius) {
      ink_.pivot = ratio(pivot, ink_.frame.radius);
    }
  }

  /// "a, b", or how many of what they are.
  static std::string listed(const std::vector<std::string>& items, const std::string& what) {
    if (items.size() > kMostListed) return std::to_string(items.size()) + " " + what;
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
    return text;
  }

  static std::string contacts_text(const std::string& before,
                                   const std::vector<std::string>& contacts,
                                   const std::string& one, const std::string& many) {
    if (contacts.empty()) return "";
    if (contacts.size() > kMostListed)
      return before + listed(contacts, "contacts") + " " + many;
    return before + (contacts.size() == 1 ? "contact " : "contacts ") + listed(contacts, "") +
           " " + (contacts.size() == 1 ? one : many);
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
  Problem problem_;
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

}  // namespace stickslip::plot_detail
