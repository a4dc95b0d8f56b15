// SPDX-License-Identifier: MIT
#include "sticking.hpp"

#include <algorithm>

#include "work.hpp"

namespace stickslip_check {
namespace {

/// One part, for one multiple after the other.
class Sticking {
 public:
  Sticking(const StickingProof& proof, const Box& box, const std::string& place)
      : proof_(proof), box_(box), place_(place), motion_(make_form(proof.twist, &scale_)) {}

  void check_share();
  void check_motion(bool one_multiple, bool bilateral) const;
  void check_for(const Rational& multiple, const std::optional<Vector>& bound) const;

 private:
  void require(bool good, const char* rule, const std::string& found) const {
    if (!good) throw Rejected{rule, std::nullopt, place_, found};
  }
  Bounds pressure(const BoxContact& contact, const Rational& multiple) const;
  Bounds push(const BoxContact& contact, const Rational& multiple) const;
  Rational slip(const BoxContact& contact) const;
  Rational swing(const BoxContact& contact) const;
  Rational friction(const BoxContact& contact, const Stated& stated) const;
  Rational spare(const BoxContact& contact, const Rational& multiple,
                 const Stated& stated) const;
  Rational share(const BoxContact& contact, const Rational& multiple,
                 const Stated& stated) const;
  void check_press(const Rational& multiple) const;
  void check_energy(const Rational& multiple) const;
  void check_bound(const Rational& multiple, const Vector& left, const Vector& bound) const;

  const StickingProof& proof_;
  const Box& box_;
  const std::string& place_;
  Rational scale_;
  Form motion_;  ///< d0 is scale_ times it
  StatedForces stated_;
};

/// The least and the largest v_i at d0.
Bounds Sticking::pressure(const BoxContact& contact, const Rational& multiple) const {
  spend(kStepsOfRational * box_.dimension() * contact.row.normals.size());
  const Bounds preload = preload_of(contact.box, multiple);
  const Bounds& stiffness = contact.box[Parameter::kStiffness];
  Vector pulls;
  for (const Form& normal : contact.row.normals) {
    const Rational along = contact.row.scale * scale_ * dot(normal, motion_);
    for (const Rational& k : {stiffness.low, stiffness.high}) pulls.emplace_back(-k * along);
  }
  const auto [low, high] = std::minmax_element(pulls.begin(), pulls.end());
  return {preload.low + *low, preload.high + *high};
}

/// From the least to the largest a0.
Bounds Sticking::push(const BoxContact& contact, const Rational& multiple) const {
  const Bounds v = pressure(contact, multiple);
  if (is_spring(contact.box.sight)) return v;
  return {std::max(Rational(0), v.low), std::max(Rational(0), v.high)};
}

/// sigma_i.
Rational Sticking::slip(const BoxContact& contact) const {
  Rational most;
  for (const std::vector<Form>& rows : contact.row.slips) {
    Vector s;
    for (const Form& row : rows) s.emplace_back(contact.row.scale * scale_ * dot(row, motion_));
    const Rational length =
        s.size() == 1 ? Rational(abs(s[0])) : root_above(dot(conjugate(contact.box, s), s));
    most = std::max(most, length);
  }
  return most;
}

/// r_i, the most by which v_i differs from that at d0.
Rational Sticking::swing(const BoxContact& contact) const {
  return root_above(2 * proof_.energy * contact.box[Parameter::kStiffness].high);
}

/// phi_i.
Rational Sticking::friction(const BoxContact& contact, const Stated& stated) const {
  return most_friction(contact.box, stated.friction, proof_.reach);
}

/// s_i, which is what the cone allows and is not needed.
Rational Sticking::spare(const BoxContact& contact, const Rational& multiple,
                         const Stated& stated) const {
  const Rational rho = contact.box[Parameter::kFriction].low * length_of(contact.box).low;
  return rho * (pressure(contact, multiple).low - swing(contact)) - friction(contact, stated);
}

/// gamma_i.
Rational Sticking::share(const BoxContact& contact, const Rational& multiple,
                         const Stated& stated) const {
  const Rational sigma = slip(contact);
  if (sigma == 0 && stated.presses.empty()) return 0;
  const Rational rho = contact.box[Parameter::kFriction].high * length_of(contact.box).high;
  const Rational most = rho * push(contact, multiple).high + friction(contact, stated);
  Rational delta;
  for (std::size_t l = 0; l < stated.presses.size(); ++l) {
    delta += abs(stated.presses[l]) * proof_.reach[l];
  }
  Rational result;
  const Bounds& stiffness = contact.box[Parameter::kStiffness];
  for (const Rational& k : {stiffness.low, stiffness.high}) {
    if (k == 0) continue;
    const Rational both = delta + rho * k * sigma;
    result = std::max(result, Rational(both * both / (2 * k) + most * sigma));
  }
  return result;
}

/// `sticking-share`.
void Sticking::check_share() {
  const char* const rule = "sticking-share";
  take_friction(proof_.friction, 0, rule, box_, place_, stated_);
  Integer above = -1;
  for (const auto& [contact, presses] : proof_.presses) {
    require(contact > above, rule, contact_name(contact) + "not above the one before");
    require(contact < box_.size(), rule, contact_name(contact) + "there is none");
    const std::size_t i = contact.get_ui();
    require(box_.contact(i)[Parameter::kStiffness].low > 0, rule,
            contact_name(contact) + "its stiffness may be 0");
    stated_[i].presses = presses;
    above = contact;
  }
  take_friction(proof_.answers, 1, rule, box_, place_, stated_);
  for (std::size_t k = 0; k < proof_.reach.size(); ++k) {
    require(proof_.reach[k] > 0, rule,
            "Z_" + std::to_string(k + 1) + " = " + show(proof_.reach[k]) + " is not above 0");
  }
  require(proof_.energy > 0, rule, "c = " + show(proof_.energy) + " is not above 0");
}

/// `sticking-motion`.
void Sticking::check_motion(bool one_multiple, bool bilateral) const {
  const char* const rule = "sticking-motion";
  const bool moves = proof_.twist != Vector(proof_.twist.size());
  require(!moves || one_multiple, rule, "d0 is not 0, for more than one multiple");
  for (std::size_t i = 0; (moves || bilateral) && i < box_.size(); ++i) {
    const auto contact = box_.passing(i);
    const std::string name = contact_name(i);
    require(!moves || contact->row.tilt == 0, rule,
            name + "d0 is not 0, and its normal is uncertain");
    require(!bilateral || is_spring(contact->box.sight) || stated_.count(i) > 0, rule,
            name + "it is not listed, under the bilateral law");
  }
}

/// `sticking-press`.
void Sticking::check_press(const Rational& multiple) const {
  const char* const rule = "sticking-press";
  for (const auto& [i, stated] : stated_) {
    const auto contact = box_.passing(i);
    const Rational v = pressure(*contact, multiple).low;
    const Rational r = swing(*contact);
    require(is_spring(contact->box.sight) || v >= r, rule,
            contact_name(i) + "v may be " + show(v) + ", below r = " + show(r));
    if (stated.friction.empty()) continue;
    const Rational phi = friction(*contact, stated);
    const Rational most = spare(*contact, multiple, stated) + phi;
    require(phi < most, rule,
            contact_name(i) + "its friction may be as large as " + show(phi) +
                ", and the cone allows less than " + show(most));
  }
}

/// `sticking-energy`.
void Sticking::check_energy(const Rational& multiple) const {
  PairwiseSum sum;
  sum.add({0});
  for (std::size_t i = 0; i < box_.size(); ++i) {
    const auto found = stated_.find(i);
    const Rational gamma =
        share(*box_.passing(i), multiple, found == stated_.end() ? Stated{} : found->second);
    if (gamma != 0) sum.add({gamma});
  }
  const Rational total = sum.total()[0];
  require(total < proof_.energy, "sticking-energy",
          "c = " + show(proof_.energy) + ", but the sum may be " + show(total));
}

/// `sticking-bound`.
void Sticking::check_bound(const Rational& multiple, const Vector& left,
                           const Vector& bound) const {
  const char* const rule = "sticking-bound";
  const std::size_t dimension = box_.dimension();
  Vector within;  // E
  for (std::size_t l = 0; l < dimension; ++l) {
    within.emplace_back(bound[l] - abs(proof_.twist[l]));
    require(within[l] > 0, rule,
            "d0_" + std::to_string(l + 1) + " is not within " + show(bound[l]));
  }
  Vector most(dimension);
  for (const auto& [i, stated] : stated_) {
    const auto contact = box_.passing(i);
    Rational along;   // |N.e|
    Rational across;  // |S e|
    if (!stated.presses.empty()) {
      along = root_above(2 * proof_.energy / contact->box[Parameter::kStiffness].low);
    }
    if (!stated.friction.empty()) {
      across = proof_.energy / spare(*contact, multiple, stated) + slip(*contact);
    }
    for (std::size_t l = 0; l < dimension; ++l) {
      if (!stated.presses.empty()) most[l] += abs(stated.presses[l]) * along;
      if (!stated.friction.empty()) {
        most[l] += length_above(contact->box, stated.friction[l + 1]) * across;
      }
    }
  }
  for (std::size_t l = 0; l < dimension; ++l) {
    for (std::size_t k = 0; k < dimension; ++k) {
      most[l] += left[dimension * (l + 1) + k] * within[k];
    }
    require(most[l] <= within[l], rule,
            "motion " + std::to_string(l + 1) + " may differ from d0 by " + show(most[l]) +
                ", more than " + show(within[l]));
  }
}

void Sticking::check_for(const Rational& multiple, const std::optional<Vector>& bound) const {
  const auto presses = [&](const BoxContact& contact) { return push(contact, multiple); };
  const Vector left = largest_left(box_, multiple, stated_, presses);
  const Vector& reach = proof_.reach;
  for (std::size_t k = 0; k < reach.size(); ++k) {
    const Rational most = most_left(left, reach, k);
    require(most < reach[k], "sticking-reach",
            "Z_" + std::to_string(k + 1) + " = " + show(reach[k]) + ", but " + show(most) +
                " may be left");
  }
  check_press(multiple);
  check_energy(multiple);
  if (bound) check_bound(multiple, left, *bound);
}

}  // namespace

void check_sticking(const StickingProof& proof, const Box& box, const Range& range,
                    const Options& asked, const std::string& place) {
  Sticking sticking(proof, box, place);
  const bool one_multiple = range.high == range.low;
  sticking.check_share();
  sticking.check_motion(one_multiple, asked.bilateral);
  // Between two multiples d0 is 0, and all is linear in them.
  sticking.check_for(range.low, asked.max_motion);
  if (!one_multiple) sticking.check_for(*range.high, asked.max_motion);
}

}  // namespace stickslip_check
