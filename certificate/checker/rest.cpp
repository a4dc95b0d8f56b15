// SPDX-License-Identifier: MIT
#include "rest.hpp"

#include <algorithm>
#include <map>

#include "work.hpp"

namespace stickslip_check {
namespace {

[[noreturn]] void break_rule(const char* rule, const std::string& place,
                             const std::string& found) {
  throw Rejected{rule, std::nullopt, place, found};
}

std::string contact_name(const Integer& contact) {
  return "contact " + show(Rational(contact)) + ": ";
}

/// Of a contact 1 + D friction forces: f0, and G_1 to G_D; those that are not stated are 0.
using Friction = std::map<std::size_t, std::vector<Vector>>;

/// `rest-share`: takes a list, whose first force is number `first` of 1 + D.
void take(const RestProof::Forces& list, std::size_t first, const Box& box,
          const std::string& place, Friction& friction) {
  const char* const rule = "rest-share";
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
    auto& all = friction.try_emplace(i, 1 + box.dimension(), Vector(numbers)).first->second;
    std::copy(forces.begin(), forces.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
    above = contact;
  }
}

/// P'_i for this multiple.
Bounds preload_of(const ContactBox& contact, const Rational& multiple) {
  const Bounds& preload = contact[Parameter::kPreload];
  return {preload.low + multiple * contact.growth.low,
          preload.high + multiple * contact.growth.high};
}

/// The least and the largest entries of 1 + D wrenches, one after the other: those of a contact
/// with N P' and the first of its friction forces, and with the others alone.
std::vector<Bounds> wrenches_of(const Row& row, const Bounds& preload,
                                const std::vector<Vector>* friction) {
  const std::size_t dimension = row.normals[0].size();
  std::vector<Bounds> result;
  spend(2 * kStepsOfRational * dimension * (dimension + 1) * row.normals.size());
  for (std::size_t l = 0; l <= dimension; ++l) {
    for (std::size_t k = 0; k < dimension; ++k) {
      Vector values;
      for (std::size_t c = 0; c < row.normals.size(); ++c) {
        Rational along;
        for (std::size_t j = 0; friction != nullptr && j < row.slips[c].size(); ++j) {
          along += (*friction)[l][j] * row.slips[c][j][k];
        }
        for (const Rational& p : {preload.low, preload.high}) {
          values.emplace_back(row.scale * (l == 0 ? along + p * row.normals[c][k] : along));
        }
      }
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      result.emplace_back(*low, *high);
    }
  }
  return result;
}

/// Their sum over all contacts, with the load in the first wrench, and the unit matrix taken
/// away from the others: for each entry the larger of minus the least and the largest.
Vector largest_left(const Box& box, const Rational& multiple, const Friction& friction) {
  const std::size_t dimension = box.dimension();
  const std::size_t entries = dimension * (dimension + 1);
  PairwiseSum sum;  // of minus the least and of the largest
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
    const auto stated = friction.find(i);
    const Bounds preload = preload_of(contact->box, multiple);
    if (preload == Bounds(0) && stated == friction.end()) continue;
    const auto bounds = wrenches_of(contact->row, preload,
                                    stated == friction.end() ? nullptr : &stated->second);
    Vector entry(2 * entries);
    for (std::size_t k = 0; k < entries; ++k) add(entry, k, bounds[k]);
    sum.add(std::move(entry));
  }
  Vector ends = sum.total();
  for (std::size_t k = 0; k < entries; ++k) ends[k] = std::max(ends[k], ends[entries + k]);
  ends.resize(entries);
  return ends;
}

/// `rest-reach`.
void check_reach(const Vector& left, const Vector& reach, const std::string& place) {
  const std::size_t dimension = reach.size();
  for (std::size_t k = 0; k < dimension; ++k) {
    const std::string name = "Z_" + std::to_string(k + 1) + " = " + show(reach[k]);
    if (reach[k] < 0) break_rule("rest-reach", place, name + " is below 0");
    Rational most = left[k];
    for (std::size_t l = 0; l < dimension; ++l) {
      most += left[dimension * (l + 1) + k] * reach[l];
    }
    if (most > reach[k]) {
      break_rule("rest-reach", place, name + ", but " + show(most) + " may be left");
    }
  }
}

/// `rest-cone`.
void check_cones(const Box& box, const Rational& multiple, const Friction& friction,
                 const Vector& reach, const std::string& place) {
  constexpr unsigned kRootBits = 64;
  for (const auto& [i, forces] : friction) {
    const ContactBox& contact = box.contact(i);
    const bool in_space = forces[0].size() > 1;
    Rational most = contact[Parameter::kFriction].low * preload_of(contact, multiple).low;
    if (in_space) most *= root_bounds(dot(contact.normal, contact.normal), kRootBits).low;
    Rational needed;
    for (std::size_t l = 0; l < forces.size(); ++l) {
      const Bounds length = in_space
                                ? root_bounds(friction_square(contact, forces[l]), kRootBits)
                                : Bounds(Rational(abs(forces[l][0])));
      needed += length.high * (l == 0 ? Rational(1) : reach[l - 1]);
    }
    if (needed > most) {
      break_rule("rest-cone", place,
                 contact_name(i) + "its friction may be as large as " + show(needed) +
                     ", and the cone allows " + show(most));
    }
  }
}

}  // namespace

void check_rest(const RestProof& proof, const Box& box, const Range& range,
                const std::string& place) {
  Friction friction;
  take(proof.rest, 0, box, place, friction);
  take(proof.answers, 1, box, place, friction);
  const auto check_for = [&](const Rational& multiple) {
    check_reach(largest_left(box, multiple, friction), proof.reach, place);
    check_cones(box, multiple, friction, proof.reach, place);
  };
  // All is linear in the multiple, so the two ends serve for those between.
  check_for(range.low);
  if (range.high != range.low) check_for(*range.high);
}

}  // namespace stickslip_check
