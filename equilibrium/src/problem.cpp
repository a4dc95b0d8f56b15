// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/equilibrium/problem.hpp"

#include <utility>

#include "stickslip/core/error.hpp"

namespace stickslip {

LoadRange::LoadRange(const Wrench& wrench) : wrench_(wrench), ends_{{0, wrench}} {}

LoadRange::LoadRange(const Wrench& wrench, const Wrench& direction, const Rational& low,
                     const std::optional<Rational>& high, bool has_low)
    : wrench_(wrench),
      direction_(direction),
      has_high_(high.has_value()),
      low_is_strict_(!has_low) {
  require(!high || low < *high, "a range of loads has an inside");
  ends_.push_back({low, wrench_at(low)});
  if (high) ends_.push_back({*high, wrench_at(*high)});
}

std::optional<Wrench> LoadRange::recession() const {
  if (has_high_) return std::nullopt;
  return direction_;
}

Problem::Problem(const LoadedGrasp& loaded, NormalLaw law)
    : rows_(contact_rows(loaded.grasp)), load_(loaded.wrench), law_(law) {
  for (const ContactRow& row : rows_) {
    const Wrench& n = row.normal;
    const Wrench& t = row.tangent;
    slip_planes_.push_back(primitive_multiple<4>({t.x, t.y, t.torque, 0}));
    separations_.push_back(
        {-row.stiffness * n.x, -row.stiffness * n.y, -row.stiffness * n.torque, row.preload});
    separation_planes_.push_back(primitive_multiple<4>(separations_.back()));
  }
}

const Wrench& Problem::wrench() const {
  require(load_.is_single(), "a range of loads has no one wrench");
  return load_.ends().front().wrench;
}

Problem Problem::with_load(LoadRange load) const {
  Problem other = *this;
  other.load_ = std::move(load);
  return other;
}

Problem Problem::at(const Rational& multiple) const {
  return with_load(LoadRange(load_.wrench_at(multiple)));
}

Wrench Problem::edge_wrench(ContactId contact, int sigma) const {
  const ContactRow& r = row(contact);
  return r.normal + (Rational(sigma) * r.friction) * r.tangent;
}

}  // namespace stickslip
