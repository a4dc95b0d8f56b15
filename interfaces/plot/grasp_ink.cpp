// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_ink.hpp"

#include <algorithm>
#include <cmath>

#include "stickslip/core/error.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/engine/contact_mode.hpp"
#include "stickslip/engine/refutation_summary.hpp"

namespace stickslip::plot_detail {
namespace {

constexpr double kLongestCone = 0.7;
const Rational kLongestMotion(3, 10);
/// A load that would be shorter than this share of the longest force has a scale of its own,
/// with at most the other length.
const Rational kShortestLoad(1, 8);
const Rational kEnlargedLoad(3, 5);
const Rational kFarPivot(3, 2);  ///< the distance from the centre, in scene units
constexpr std::size_t kMostListed = 12;
const Rational kLongTwist(100000);  ///< entries from here on are hard to read

Vector2 displacement(const Vector2& point, const Twist& d) {
  return {d.x - d.r * point.y, d.y + d.r * point.x};
}

class GraspReader {
 public:
  GraspReader(const Question& question, const Verdict& verdict)
      : question_(question),
        verdict_(verdict),
        grasp_(question.loaded().grasp),
        wrench_(question.loaded().wrench),
        problem_(problem_of(question)) {}

  GraspInk read() {
    frame_ = picture_frame(grasp_);
    ink_.set_title(grasp_.name(), question_.case_name);
    ink_.units = grasp_.description().units;
    ink_.outline_is_given = !grasp_.description().outline.empty();
    for (const Contact& c : grasp_.contacts()) ink_.preloads.push_back(c.preload);
    ink_.choose_sizes();
    scene_.contacts = contact_ink(grasp_, frame_);
    scene_.bodies.emplace_back();
    scene_.bodies[0].outline = body_outline(grasp_, frame_, scene_.contacts);
    ink_.marks.assign(grasp_.size(), ContactMark::kUnknown);
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      scene_.cones.push_back(
          planar_cone(scene_.contacts[i], grasp_.contacts()[i].friction, ink_.cone_length));
    }
    choose_force_unit();
    add_load();
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      add_witness(stable->witness());
    } else if (const auto* unstable = std::get_if<Unstable>(&verdict_)) {
      add_refutation(unstable->tree);
    } else {
      ink_.caption.push_back("Undecided: " + in_words(std::get<Undecided>(verdict_)) + ".");
    }
    ink_.scenes.push_back(std::move(scene_));
    return std::move(ink_);
  }

 private:
  /// Returns the force of contact i, exactly.
  Vector2 force(const Witness& witness, std::size_t i) const {
    return force_vector(grasp_.contacts()[i].normal, witness.forces[i]);
  }

  void choose_force_unit() {
    ink_.force_unit = std::max(ink_.force_unit, largest_entry({wrench_.x, wrench_.y}));
    if (const auto* stable = std::get_if<Stable>(&verdict_)) {
      require(stable->witness().forces.size() == grasp_.size(),
              "plot_grasp: the verdict is not about this grasp");
      for (std::size_t i = 0; i < grasp_.size(); ++i) {
        ink_.force_unit = std::max(ink_.force_unit, largest_entry(force(stable->witness(), i)));
      }
    }
  }

  /// Adds the wrench as a force at the centre of the scene and a torque about it.
  void add_load() {
    const Vector2& centre = frame_.centre;
    scene_.torque = wrench_.torque - (centre.x * wrench_.y - centre.y * wrench_.x);
    if (!scene_.torque.is_zero()) ink_.torque = short_text(scene_.torque);
    const Vector2 force{wrench_.x, wrench_.y};
    ink_.choose_load_factor(largest_entry(force));
    scene_.arrows.push_back(
        {{0, 0},
         ink_.force({ink_.load_factor * force.x, ink_.load_factor * force.y}),
         "load",
         {{"data-value", pair_text(force)}, {"data-factor", to_string(ink_.load_factor)}}});
    ink_.describe_load({wrench_.x, wrench_.y, wrench_.torque}, {centre.x, centre.y},
                       short_text(scene_.torque), question_.law);
  }

  /// Adds an arrow for the motion of each contact and the body's ghost; returns the factor of
  /// enlargement.
  Rational add_motion(const Twist& d, const std::string& css_class) {
    // The contacts may move less than the body, or not at all.
    Rational largest = std::max(largest_entry(displacement(frame_.centre, d)),
                                Rational(abs(d.r) * frame_.radius));
    for (const Contact& c : grasp_.contacts()) {
      largest = std::max(largest, largest_entry(displacement(c.position, d)));
    }
    const Rational factor = enlargement(largest, frame_.radius);
    if (factor.is_zero()) return 0;
    for (std::size_t i = 0; i < grasp_.size(); ++i) {
      const Vector2 move = displacement(grasp_.contacts()[i].position, d);
      scene_.arrows.push_back(
          {scene_.contacts[i].at,
           scene_.contacts[i].at + ratio({factor * move.x, factor * move.y}, frame_.radius),
           css_class,
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(move)}}});
    }
    scene_.bodies[0].ghost = moved_outline(d, factor);
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
      scene_.arrows.push_back(
          {scene_.contacts[i].at,
           scene_.contacts[i].at + ink_.force(f),
           "force",
           {{"data-contact", std::to_string(i)}, {"data-value", pair_text(f)}}});
    }
    ink_.describe_motion("Motion d = " + short_tuple({d.x, d.y, d.r}),
                         "The forces balance w; checked exactly.");
  }

  /// Returns the outline as the motion moves it: linear in d, as the model is.
  std::vector<std::vector<InkPoint>> moved_outline(const Twist& d,
                                                   const Rational& factor) const {
    const Vector2 shift = displacement(frame_.centre, d);
    const InkPoint move = ratio({factor * shift.x, factor * shift.y}, frame_.radius);
    const double turn = to_double(factor * d.r);
    std::vector<std::vector<InkPoint>> moved = scene_.bodies[0].outline;
    for (std::vector<InkPoint>& ring : moved) {
      for (InkPoint& p : ring) p = p + move + turn * quarter_turn(p);
    }
    return moved;
  }

  void add_refutation(const Trees& refutation) {
    const RefutationSummary proof = summarize(refutation, &problem_);
    if (proof.leaves == 0) {
      ink_.caption.push_back("The normal law allows no motion at all.");
      return;
    }
    const bool is_whole = proof.largest_leaf.empty();
    if (!is_whole) {
      ink_.caption.push_back(
          "No motion and forces satisfy all conditions: proved by a tree of " +
          std::to_string(proof.leaves) +
          " leaves. Shown is the largest: " + listed(proof.largest_leaf, "conditions") + ".");
    }
    // The wrenches of load and contacts together do negative work along the leaf's twist,
    // whatever the contacts do. So they drive the object against it.
    Twist drift = twist_of(negated(proof.largest_leaf_twist));
    const Rational largest =
        std::max(largest_entry({drift.x, drift.y}), Rational(abs(drift.r)));
    if (largest.is_zero()) return;  // the leaf has no motion
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

  /// Returns true if some force that the contact can have in the leaf does negative work on the
  /// drift.
  bool can_oppose(std::size_t i, const Twist& drift, const RefutationSummary& proof) const {
    const ContactId contact(i);
    if (proof.largest_leaf_open.count(contact) > 0) return false;
    const ContactRow& row = problem_.rows()[i];
    const Rational normal = power(row.normal, drift);
    const Rational friction = row.friction * power(row.tangent, drift);
    const auto slip = proof.largest_leaf_slips.find(contact);
    // Friction opposes the slip of the leaf's motions; without slip it has any direction.
    const Rational least = slip == proof.largest_leaf_slips.end() || slip->second == Sign::kZero
                               ? Rational(normal - abs(friction))
                               : Rational(normal - to_int(slip->second) * friction);
    return least.sign() < 0;
  }

  void add_pivot(const Twist& d) {
    if (d.r.is_zero()) return;
    const Vector2 pivot{-d.y / d.r - frame_.centre.x, d.x / d.r - frame_.centre.y};
    if (largest_entry(pivot) <= kFarPivot * frame_.radius) {
      scene_.pivot = ratio(pivot, frame_.radius);
    }
  }

  /// Returns "a, b", or how many items there are and what they are.
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

  const Question& question_;
  const Verdict& verdict_;
  const Grasp& grasp_;
  const Wrench& wrench_;
  Problem problem_;
  PictureFrame frame_;
  SceneInk scene_;
  GraspInk ink_;
};

}  // namespace

std::string pair_text(const Vector2& v) {
  return to_string(v.x) + "," + to_string(v.y);
}

std::vector<InkPoint> planar_cone(const ContactInk& c, const Rational& friction,
                                  double length) {
  constexpr int kSteps = 12;
  const double half_angle = std::atan(to_double(friction));
  std::vector<InkPoint> sector{c.at};
  for (int step = -kSteps; step <= kSteps; ++step) {
    const double angle = half_angle * step / kSteps;
    sector.push_back(c.at + length * std::cos(angle) * c.normal +
                     length * std::sin(angle) * c.tangent);
  }
  return sector;
}

bool SceneInk::has_outline() const {
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const BodyInk& body) { return !body.outline.empty(); });
}

bool SceneInk::has_ghost() const {
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const BodyInk& body) { return !body.ghost.empty(); });
}

double GraspInk::force_length(const Rational& size) const {
  return size.is_zero() ? 0 : kLongestForce * to_double(size / force_unit);
}

InkPoint GraspInk::force(const Vector2& exact) const {
  return {force_length(exact.x), force_length(exact.y)};
}

void GraspInk::set_title(const std::string& name, const std::string& of_case) {
  title = (name.empty() ? "Grasp" : name) + (of_case.empty() ? "" : ", " + of_case);
}

void GraspInk::choose_sizes() {
  // Cones are shorter if there are many, so that they leave room for the rest.
  const auto count = static_cast<double>(preloads.size());
  cone_length = kLongestCone * std::min(1.0, 2.2 / std::sqrt(count));
  for (const Rational& preload : preloads) force_unit = std::max(force_unit, preload);
}

void GraspInk::choose_load_factor(const Rational& largest) {
  if (!largest.is_zero() && largest < kShortestLoad * force_unit) {
    load_factor = round_down(kEnlargedLoad * force_unit / largest);
  }
}

void GraspInk::describe_load(const std::vector<Rational>& wrench,
                             const std::vector<Rational>& centre,
                             const std::string& torque_there, NormalLaw law) {
  const bool at_origin =
      std::all_of(centre.begin(), centre.end(), [](const Rational& x) { return x.is_zero(); });
  describe_load("Applied wrench w = " + short_tuple(wrench) +
                    (at_origin ? ""
                               : ", drawn at " + short_tuple(centre) +
                                     ", where its torque is " + torque_there),
                law);
}

void GraspInk::describe_load(const std::string& load, NormalLaw law) {
  caption.push_back(
      load + ". Normal law: " + to_string(law) + "." +
      (units ? " Units:" + plot_detail::force_unit(units) + "," + length_unit(units) + "."
             : ""));
}

void GraspInk::describe_motion(const std::string& motion, const std::string& of_forces) {
  caption.push_back(motion +
                    (motion_factor.is_zero()
                         ? ": nothing moves. "
                         : ", drawn \u00D7\u202F" + short_text(motion_factor) + ". ") +
                    of_forces);
}

Rational enlargement(const Rational& largest, const Rational& radius) {
  return largest.is_zero() ? Rational(0) : round_down(kLongestMotion * radius / largest);
}

GraspInk grasp_ink(const Question& question, const Verdict& verdict) {
  return GraspReader(question, verdict).read();
}

}  // namespace stickslip::plot_detail
