// SPDX-License-Identifier: MIT
#include "rest.hpp"

#include <algorithm>

#include "work.hpp"

namespace stickslip_check {
namespace {

constexpr unsigned kRootBits = 64;

[[noreturn]] void break_rule(const char* rule, const std::string& place,
                             const std::string& found) {
  throw Rejected{rule, std::nullopt, place, found};
}

/// The least and the largest entries of 1 + D wrenches, one after the other: those of a contact
/// that presses by `push` and has the first of its friction forces, and what else is stated.
std::vector<Bounds> wrenches_of(const Row& row, const Bounds& push, const Stated& stated) {
  const std::size_t dimension = row.normals[0].size();
  std::vector<Bounds> result;
  spend(2 * kStepsOfRational * dimension * (dimension + 1) * row.normals.size());
  for (std::size_t l = 0; l <= dimension; ++l) {
    const Bounds pushes = l == 0                   ? push
                          : stated.presses.empty() ? Bounds(0)
                                                   : Bounds(stated.presses[l - 1]);
    for (std::size_t k = 0; k < dimension; ++k) {
      Vector values;
      for (std::size_t c = 0; c < row.normals.size(); ++c) {
        Rational along;
        for (std::size_t j = 0; !stated.friction.empty() && j < row.slips[c].size(); ++j) {
          along += stated.friction[l][j] * row.slips[c][j][k];
        }
        for (const Rational& p : {pushes.low, pushes.high}) {
          values.emplace_back(row.scale * (along + p * row.normals[c][k]));
          if (pushes.certain()) break;
        }
      }
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      result.emplace_back(*low, *high);
    }
  }
  return result;
}

/// `rest-reach`.
void check_reach(const Vector& left, const Vector& reach, const std::string& place) {
  for (std::size_t k = 0; k < reach.size(); ++k) {
    const std::string name = "Z_" + std::to_string(k + 1) + " = " + show(reach[k]);
    if (reach[k] < 0) break_rule("rest-reach", place, name + " is below 0");
    const Rational most = most_left(left, reach, k);
    if (most > reach[k]) {
      break_rule("rest-reach", place, name + ", but " + show(most) + " may be left");
    }
  }
}

/// `rest-cone`.
void check_cones(const Box& box, const Rational& multiple, const StatedForces& stated,
                 const Vector& reach, const std::string& place) {
  for (const auto& [i, forces] : stated) {
    const ContactBox& contact = box.contact(i);
    const Rational most = contact[Parameter::kFriction].low * length_of(contact).low *
                          preload_of(contact, multiple).low;
    const Rational needed = most_friction(contact, forces.friction, reach);
    if (needed > most) {
      break_rule("rest-cone", place,
                 contact_name(i) + "its friction may be as large as " + show(needed) +
                     ", and the cone allows " + show(most));
    }
  }
}

}  // namespace

std::string contact_name(const Integer& contact) {
  return "contact " + show(Rational(contact)) + ": ";
}

void take_friction(const ContactForces& list, std::size_t first, const char* rule,
                   const Box& box, const std::string& place, StatedForces& stated) {
  Integer above = -1;
  for (const auto& [contact, forces] : list) {
    if (contact <= above)
      break_rule(rule, place, contact_name(contact) + "not above the one before");
    const std::size_t i = contact.get_ui();
    if (contact >= box.size() || !is_contact(box.contact(i).sight)) {
      break_rule(rule, place, contact_name(contact) + "there is none");
    }
    const std::size_t numbers = forces[0].size();
    for (const Vector& f : forces) {
      if (numbers > 1 && dot(f, box.contact(i).normal) != 0) {
        break_rule(rule, place, contact_name(contact) + show(f) + " is not across its normal");
      }
    }
    std::vector<Vector>& all = stated[i].friction;
    all.resize(1 + box.dimension(), Vector(numbers));
    std::copy(forces.begin(), forces.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
    above = contact;
  }
}

Bounds preload_of(const ContactBox& contact, const Rational& multiple) {
  const Bounds& preload = contact[Parameter::kPreload];
  return {preload.low + multiple * contact.growth.low,
          preload.high + multiple * contact.growth.high};
}

Vector largest_left(const Box& box, const Rational& multiple, const StatedForces& stated,
                    const std::function<Bounds(const BoxContact&)>& push) {
  const std::size_t dimension = box.dimension();
  const std::size_t entries = dimension * (dimension + 1);
  PairwiseSum sum;  // of minus the least and of the largest, over the load and all contacts
  Vector load(2 * entries);
  const auto add = [entries](Vector& v, std::size_t k, const Bounds& bounds) {
    v[k] -= bounds.low;
    v[entries + k] += bounds.high;
  };
  for (std::size_t k = 0; k < dimension; ++k) {
    Vector along(dimension);
    along[k] = 1;
    add(load, k, box.load.work(along));
    add(load, k, multiple * box.growths[0][k]);
    add(load, dimension * (k + 1) + k, -1);
  }
  sum.add(std::move(load));
  for (std::size_t i = 0; i < box.size(); ++i) {
    const auto contact = box.passing(i);
    const auto found = stated.find(i);
    const Bounds pushes = push(*contact);
    if (pushes == Bounds(0) && found == stated.end()) continue;
    const auto bounds =
        wrenches_of(contact->row, pushes, found == stated.end() ? Stated{} : found->second);
    Vector entry(2 * entries);
    for (std::size_t k = 0; k < entries; ++k) add(entry, k, bounds[k]);
    sum.add(std::move(entry));
  }
  Vector ends = sum.total();
  for (std::size_t k = 0; k < entries; ++k) ends[k] = std::max(ends[k], ends[entries + k]);
  ends.resize(entries);
  return ends;
}

Rational most_left(const Vector& left, const Vector& reach, std::size_t k) {
  const std::size_t dimension = reach.size();
  Rational most = left[k];
  for (std::size_t l = 0; l < dimension; ++l) most += left[dimension * (l + 1) + k] * reach[l];
  return most;
}

Bounds length_of(const ContactBox& contact) {
  const bool in_space = contact.normal.size() == 3;
  return in_space ? root_bounds(dot(contact.normal, contact.normal), kRootBits) : Bounds(1);
}

Rational length_above(const ContactBox& contact, const Vector& f) {
  if (f.size() == 1) return abs(f[0]);
  return root_bounds(friction_square(contact, f), kRootBits).high;
}

Rational most_friction(const ContactBox& contact, const std::vector<Vector>& friction,
                       const Vector& reach) {
  Rational most;
  for (std::size_t l = 0; l < friction.size(); ++l) {
    most += length_above(contact, friction[l]) * (l == 0 ? Rational(1) : reach[l - 1]);
  }
  return most;
}

void check_rest(const RestProof& proof, const Box& box, const Range& range,
                const std::string& place) {
  StatedForces stated;
  take_friction(proof.rest, 0, "rest-share", box, place, stated);
  take_friction(proof.answers, 1, "rest-share", box, place, stated);
  const auto check_for = [&](const Rational& multiple) {
    const auto push = [&](const BoxContact& contact) {
      return preload_of(contact.box, multiple);
    };
    check_reach(largest_left(box, multiple, stated, push), proof.reach, place);
    check_cones(box, multiple, stated, proof.reach, place);
  };
  // All is linear in the multiple, so the two ends serve for those between.
  check_for(range.low);
  if (range.high != range.low) check_for(*range.high);
}

}  // namespace stickslip_check
