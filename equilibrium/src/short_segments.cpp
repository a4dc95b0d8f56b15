// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_segments.hpp"

#include "few_shares.hpp"
#include "long_rationals.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::equilibrium_detail {
namespace {

using Signs = std::vector<Sign>;

Signs slips_of(const Problem& problem, const Witness& witness) {
  const Twist d = ScaledTwist(witness.twist).twist;
  Signs slips;
  for (const ContactRow& row : problem.rows()) slips.push_back(sign_of(power(row.tangent, d)));
  return slips;
}

/// Of all between two motions, or in two modes at once.
Signs inside(Signs slips, const Signs& others) {
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (slips[i] == Sign::kZero) slips[i] = others[i];
  }
  return slips;
}

/// Whether some friction cannot be on the edges that both ask for.
bool are_opposite(const Problem& problem, const Witness& witness, const Signs& slips,
                  const Signs& others) {
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (slips[i] == Sign::kZero || slips[i] != -others[i]) continue;
    const bool acts = !problem.rows()[i].friction.is_zero();
    if (acts && !witness.forces[i].normal.is_zero()) return true;
  }
  return false;
}

}  // namespace

void shorten(std::vector<MarginSegment>& segments, const Problem& family) {
  const auto few = [&](const Witness& witness, const std::optional<Rational>& multiple,
                       const Signs& slips) {
    const Wrench load =
        multiple ? family.wrench() + *multiple * family.load_growth() : family.load_growth();
    return with_few_shares(family.rows(), load, slips, witness);
  };
  // Friction at the ends of a segment is that of its inside.
  std::vector<Signs> slips;
  for (const MarginSegment& segment : segments) {
    slips.push_back(
        inside(slips_of(family, segment.start.witness), slips_of(family, segment.end)));
  }
  bool starts_as_other_ends = false;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Witness& start = segments[k].start.witness;
    Witness& end = segments[k].end;
    const std::optional<Rational>& high = segments[k].high;
    if (!starts_as_other_ends) {
      if (auto found = few(start, segments[k].start.multiple, slips[k]))
        start = std::move(*found);
    }
    starts_as_other_ends = false;
    MarginSegment* next = k + 1 < segments.size() ? &segments[k + 1] : nullptr;
    if (next != nullptr && high == next->start.multiple &&
        end.twist == next->start.witness.twist &&
        !are_opposite(family, end, slips[k], slips[k + 1])) {
      if (auto found = few(end, high, inside(slips[k], slips[k + 1]))) {
        end = next->start.witness = std::move(*found);
        starts_as_other_ends = true;
        continue;
      }
    }
    if (auto found = few(end, high, slips[k])) end = std::move(*found);
  }
}

}  // namespace stickslip::equilibrium_detail
