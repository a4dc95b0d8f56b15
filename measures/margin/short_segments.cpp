// SPDX-License-Identifier: GPL-3.0-or-later
#include "short_segments.hpp"

#include <algorithm>

#include "engine/planar/few_shares.hpp"
#include "point_signs.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::margin_detail {
namespace {

using Signs = std::vector<Sign>;

/// Returns the signs of slip of all motions between two, or those that two modes ask for
/// together: a sign other than 0 wins.
Signs inside(Signs slips, const Signs& others) {
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (slips[i] == Sign::kZero) slips[i] = others[i];
  }
  return slips;
}

/// Returns the signs that both have; elsewhere 0.
Signs common(Signs slips, const Signs& others) {
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (slips[i] != others[i]) slips[i] = Sign::kZero;
  }
  return slips;
}

/// One end of a segment, with the numbers that its forces need.
class SegmentEnd {
 public:
  SegmentEnd(const Problem& family, PointSigns& signs, const std::optional<Rational>& multiple,
             const Twist& d)
      : family_(family),
        x_{d.x, d.y, d.r, multiple ? 1 : 0, multiple.value_or(Rational(1))},
        load_(multiple ? family.wrench() + *multiple * family.load_growth()
                       : family.load_growth()) {
    signs.go_to(x_);
    for (std::size_t i = 0; i < family.size(); ++i) {
      const bool acts = !family.row(ContactId(i)).friction.is_zero() &&
                        signs.of(signs.separation(i)) == Sign::kPositive;
      if (acts) has_friction_.push_back(i);
      slips_.push_back(signs.of(signs.slip(i)));
    }
  }

  const Signs& slips() const { return slips_; }

  /// Returns true if some friction cannot be on the edges that both ask for.
  bool are_opposite(const Signs& slips, const Signs& others) const {
    return std::any_of(has_friction_.begin(), has_friction_.end(), [&](std::size_t i) {
      return slips[i] != Sign::kZero && slips[i] == -others[i];
    });
  }

  /// Returns true if these slips leave no choice of friction: where they leave it open, it is
  /// along linearly independent vectors.
  bool is_determined(const Signs& slips) const {
    std::vector<Vector3> open;
    for (const std::size_t i : has_friction_) {
      if (slips[i] != Sign::kZero) continue;
      if (open.size() == 3) return false;
      open.push_back(coordinates(family_.row(ContactId(i)).tangent));
    }
    if (open.size() < 2) return true;
    const Vector3 normal = cross(open[0], open[1]);
    if (open.size() == 2) return normal != Vector3{};
    return !dot(normal, open[2]).is_zero();
  }

  /// Returns forces with few shares of friction; nothing if none are found.
  std::optional<ShortWitness> few(const Signs& slips) const {
    Witness witness{{x_[0], x_[1], x_[2]}, {}};
    for (std::size_t i = 0; i < family_.size(); ++i) {
      const Rational v = dot(family_.separation(ContactId(i)), x_);
      witness.forces.push_back({std::max(v, Rational(0)), 0});
    }
    const auto found = with_few_shares(family_.rows(), load_, slips, std::move(witness));
    if (!found) return std::nullopt;
    return in_short(family_.rows(), *found);
  }

 private:
  const Problem& family_;
  Vector5 x_;
  Wrench load_;
  Signs slips_;
  std::vector<std::size_t> has_friction_;
};

}  // namespace

void shorten(std::vector<MarginSegment>& segments, const Problem& family) {
  PointSigns signs(family);
  const auto start_of = [&](const MarginSegment& s) {
    return SegmentEnd(family, signs, s.low, s.start.twist);
  };
  const auto end_of = [&](const MarginSegment& s) {
    return SegmentEnd(family, signs, s.high, s.end.twist);
  };
  // Friction at the ends of a segment is on the edges that its inside asks for.
  std::vector<Signs> slips;
  for (const MarginSegment& segment : segments) {
    if (segment.proof) {
      slips.emplace_back();
      continue;
    }
    slips.push_back(inside(start_of(segment).slips(), end_of(segment).slips()));
  }
  const auto shorten_alone = [](ShortWitness& witness, const SegmentEnd& end,
                                const Signs& inside) {
    if (end.is_determined(inside)) return;
    if (auto found = end.few(inside)) witness = std::move(*found);
  };
  bool starts_as_other_ends = false;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    if (segments[k].proof) continue;
    if (!starts_as_other_ends) {
      shorten_alone(segments[k].start, start_of(segments[k]), slips[k]);
    }
    starts_as_other_ends = false;
    ShortWitness& witness = segments[k].end;
    const SegmentEnd end = end_of(segments[k]);
    MarginSegment* next = k + 1 < segments.size() ? &segments[k + 1] : nullptr;
    if (next != nullptr && !next->proof && segments[k].high == next->low &&
        witness.twist == next->start.twist && !end.are_opposite(slips[k], slips[k + 1])) {
      // Both forces leave the same contacts open, if that leaves no choice they are one.
      starts_as_other_ends = end.is_determined(common(slips[k], slips[k + 1]));
      if (!starts_as_other_ends) {
        if (auto found = end.few(inside(slips[k], slips[k + 1]))) {
          witness = next->start = std::move(*found);
          starts_as_other_ends = true;
        }
      }
      if (starts_as_other_ends) continue;
    }
    shorten_alone(witness, end, slips[k]);
  }
}

}  // namespace stickslip::margin_detail
