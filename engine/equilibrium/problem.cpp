// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/engine/problem.hpp"

#include <utility>

#include "stickslip/core/box.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {

Problem::Problem(const LoadedGrasp& loaded, NormalLaw law)
    : Problem(contact_rows(loaded.grasp), loaded.wrench, law) {}

Problem::Problem(std::vector<ContactRow> rows, const Wrench& wrench, NormalLaw law)
    : rows_(std::move(rows)), wrench_(wrench), law_(law) {
  // The lists are filled one after the other, so that the numbers of each lie together in
  // memory: a search that goes through one at every node waits for memory otherwise.
  slip_planes_.reserve(size());
  for (const ContactRow& row : rows_) {
    const Wrench& t = row.tangent;
    slip_planes_.push_back(primitive_multiple<5>({t.x, t.y, t.torque, {}, {}}));
  }
  separations_.reserve(size());
  for (const ContactRow& row : rows_) {
    const Wrench& n = row.normal;
    const Rational k = -row.stiffness;
    separations_.push_back({k * n.x, k * n.y, k * n.torque, row.preload, {}});
  }
  separation_planes_.reserve(size());
  for (const Vector5& v : separations_) separation_planes_.push_back(primitive_multiple(v));
}

bool Problem::is_family() const {
  return preloads_grow_ || !(load_growth_ == Wrench{});
}

Problem Problem::with_wrench(const Wrench& wrench) const {
  require(!is_family(), "a family has no one wrench to replace");
  Problem other = *this;
  other.wrench_ = wrench;
  return other;
}

Problem Problem::along(const Growth& growth) const {
  require(!is_family(), "a family cannot grow in two directions");
  require(growth.preloads.empty() || growth.preloads.size() == size(),
          "the preloads of all contacts grow, or of none");
  Problem family = *this;
  if (!growth.load.empty()) family.load_growth_ = wrench_of(growth.load);
  for (std::size_t i = 0; i < growth.preloads.size(); ++i) {
    const Rational& rate = growth.preloads[i];
    require(rate.sign() >= 0, "preloads grow, and do not fall");
    family.preloads_grow_ = family.preloads_grow_ || !rate.is_zero();
    family.separations_[i][4] = rate;
    family.separation_planes_[i] = primitive_multiple(family.separations_[i]);
  }
  require(family.is_family(), "a family grows in some direction");
  return family;
}

Problem Problem::within(MultipleRange multiples) const {
  require(is_family(), "a range of multiples is of a family");
  require(!multiples.high || multiples.low < *multiples.high,
          "a range of multiples has an inside");
  Problem other = *this;
  other.multiples_ = std::move(multiples);
  return other;
}

Problem Problem::at(const Rational& multiple) const {
  Problem member = *this;
  member.wrench_ = wrench_ + multiple * load_growth_;
  member.load_growth_ = {};
  member.preloads_grow_ = false;
  member.multiples_ = {};
  if (!preloads_grow_) return member;
  for (std::size_t i = 0; i < size(); ++i) {
    Vector5& v = member.separations_[i];
    member.rows_[i].preload += multiple * v[4];
    v[3] = member.rows_[i].preload;
    v[4] = 0;
    member.separation_planes_[i] = primitive_multiple(v);
  }
  return member;
}

Wrench Problem::edge_wrench(ContactId contact, int sigma) const {
  const ContactRow& r = row(contact);
  return r.normal + (Rational(sigma) * r.friction) * r.tangent;
}

}  // namespace stickslip
