// SPDX-License-Identifier: GPL-3.0-or-later
#include "mode_ends.hpp"

#include <algorithm>

#include "engine/planar/region_program.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::margin_detail {
namespace {

/// Returns a + factor * b.
template <std::size_t n>
std::array<Rational, n> sum(std::array<Rational, n> a, const Rational& factor,
                            const std::array<Rational, n>& b) {
  for (std::size_t j = 0; j < n; ++j) a[j] += factor * b[j];
  return a;
}

Rational value(const IntegerVector5& plane, const Vector5& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < 5; ++j) sum += Rational(plane[j]) * x[j];
  return sum;
}

/// Makes the left square of the rows the unit matrix. Returns false if it is singular.
bool eliminate(std::vector<std::vector<Rational>>& rows) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto pivot =
        std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
                     [&](const std::vector<Rational>& row) { return !row[k].is_zero(); });
    if (pivot == rows.end()) return false;
    std::swap(rows[k], *pivot);
    const Rational divisor = rows[k][k];
    for (std::size_t j = k; j < rows[k].size(); ++j) rows[k][j] /= divisor;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == k || rows[i][k].is_zero()) continue;
      const Rational factor = rows[i][k];
      for (std::size_t j = k; j < rows[i].size(); ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  return true;
}

/// Returns the sign of the edge of its friction cone on which a contact pushes; 0 also if it
/// sticks.
int edge_of(const Problem& family, const FamilyMode& mode, std::size_t contact) {
  if (family.row(ContactId(contact)).friction.is_zero()) return 0;
  return -to_int(mode[contact].slip);
}

/// Returns T_i divided by the primitive vector of its circle, whose first nonzero entry is
/// positive.
Rational scale_on_circle(const ContactRow& row, const IntegerVector5& plane) {
  if (!plane[0].is_zero()) return row.tangent.x / Rational(plane[0]);
  if (!plane[1].is_zero()) return row.tangent.y / Rational(plane[1]);
  return row.tangent.torque / Rational(plane[2]);
}

IntegerVector5 circle_of(const IntegerVector5& slip_plane) {
  const auto first = std::find_if(slip_plane.begin(), slip_plane.end(),
                                  [](const Integer& entry) { return !entry.is_zero(); });
  return first != slip_plane.end() && first->sign() < 0 ? negated(slip_plane) : slip_plane;
}

}  // namespace

std::optional<ModeEnds> ends_by_programs(const Problem& family, const FamilyMode& mode) {
  const std::optional<MultipleExtent> extent =
      multiple_extent(family, Region::of_mode(family, mode));
  if (!extent) return std::nullopt;
  require(!extent->lowest.broken && !extent->highest.broken, "a mode has nothing to split");
  const auto point_of = [&](const RelaxedPoint& end) {
    const Twist& d = end.witness.twist;
    ModePoint point{{d.x, d.y, d.r, end.is_ray ? 0 : 1, end.multiple}, {}};
    for (std::size_t i = 0; i < mode.size(); ++i) {
      if (!sticks(family, mode, i)) continue;
      point.friction.emplace_back(i, end.witness.forces[i].tangential);
    }
    return point;
  };
  return ModeEnds{point_of(extent->lowest), point_of(extent->highest)};
}

const std::array<Vector5, 3>& ForceSum::of(const FamilyMode& mode) {
  mode_.resize(mode.size(), {false, Sign::kZero});
  const auto add = [&](int sign, const FamilyMode& from, std::size_t i) {
    if (!from[i].closed) return;
    const ContactId contact(i);
    const Vector3 wrench = coordinates(family_.edge_wrench(contact, edge_of(family_, from, i)));
    for (std::size_t j = 0; j < 3; ++j) {
      sum_[j] = sum(std::move(sum_[j]), sign * wrench[j], family_.separation(contact));
    }
  };
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (mode[i] == mode_[i]) continue;
    add(-1, mode_, i);
    add(1, mode, i);
  }
  mode_ = mode;
  return sum_;
}

std::optional<ModeLines::Line> ModeLines::line_of(const FamilyMode& mode) {
  Line line;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (!sticks(family_, mode, i)) continue;
    const ContactId contact(i);
    const IntegerVector5 plane = circle_of(family_.slip_plane(contact));
    auto circle = std::find_if(line.circles.begin(), line.circles.end(),
                               [&](const Circle& c) { return c.plane == plane; });
    if (circle == line.circles.end()) {
      // More than three circles are never independent.
      if (line.circles.size() == 3) return std::nullopt;
      line.circles.push_back({plane, {}, {}, 0, 0});
      circle = line.circles.end() - 1;
    }
    circle->contacts.push_back(i);
    const ContactRow& row = family_.row(contact);
    const Rational scale = row.friction * abs(scale_on_circle(row, plane));
    circle->limit = sum(std::move(circle->limit), scale, family_.separation(contact));
  }
  // The unknowns are d and F; the right sides are at h = 1, l = 0 and at h = 0, l = 1.
  const std::array<Vector5, 3>& forces = forces_.of(mode);
  const std::size_t unknowns = 3 + line.circles.size();
  std::vector<std::vector<Rational>> rows(unknowns, std::vector<Rational>(unknowns + 2));
  const Vector3 load = coordinates(family_.wrench());
  const Vector3 growth = coordinates(family_.load_growth());
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 3; ++k) rows[j][k] = forces[j][k];
    for (std::size_t c = 0; c < line.circles.size(); ++c) {
      rows[j][3 + c] = rows[3 + c][j] = Rational(line.circles[c].plane[j]);
    }
    rows[j][unknowns] = -(load[j] + forces[j][3]);
    rows[j][unknowns + 1] = -(growth[j] + forces[j][4]);
  }
  if (!eliminate(rows)) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    line.start[k] = rows[k][unknowns];
    line.rate[k] = rows[k][unknowns + 1];
  }
  line.start[3] = line.rate[4] = 1;
  for (std::size_t c = 0; c < line.circles.size(); ++c) {
    line.circles[c].friction = rows[3 + c][unknowns];
    line.circles[c].friction_rate = rows[3 + c][unknowns + 1];
  }
  return line;
}

/// Returns the first point on which no condition fails, from the line's start upwards or from
/// its end, which is the ray, downwards; nothing if there is none. Each round satisfies a
/// condition that no later one fails.
std::optional<Vector5> ModeLines::within(const std::vector<Condition>& conditions,
                                         const Line& line, bool from_above) {
  const Double5 start = in_doubles(primitive_multiple(line.start));
  const Double5 rate = in_doubles(primitive_multiple(line.rate));
  Vector5 x = from_above ? line.rate : line.start;
  while (true) {
    signs_.go_to(x);
    const Condition* farthest = nullptr;
    double best = 0;
    for (const Condition& condition : conditions) {
      if (signs_.of(condition.function) != condition.failing) continue;
      double root = 0;
      if (const Double5* f = condition.function.rounded) root = -dot(*f, start) / dot(*f, rate);
      if (farthest != nullptr && (from_above ? !(root < best) : !(root > best))) continue;
      farthest = &condition;
      best = root;
    }
    if (farthest == nullptr) return x;
    const IntegerVector5& plane = *farthest->function.plane;
    const Rational slope = value(plane, line.rate);
    const bool gets_better =
        sign_of(slope) == (from_above ? farthest->failing : -farthest->failing);
    if (!gets_better) return std::nullopt;
    const Rational multiple = -value(plane, line.start) / slope;
    if (multiple.sign() < 0) return std::nullopt;
    x = sum(line.start, multiple, line.rate);
  }
}

std::optional<ModeEnds> ModeLines::ends_of(const FamilyMode& mode, const Line& line) {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const bool must_close = family_.law() == NormalLaw::kBilateral || mode[i].closed;
    conditions.push_back(
        {signs_.separation(i), must_close ? Sign::kNegative : Sign::kPositive});
    if (mode[i].closed && edge_of(family_, mode, i) != 0) {
      conditions.push_back({signs_.slip(i), -mode[i].slip});
    }
  }
  std::vector<IntegerVector5> left;  // room for friction, below and above
  for (const Circle& circle : line.circles) {
    for (const int side : {-1, 1}) {
      Vector5 f = circle.limit;
      f[3] += side * circle.friction;
      f[4] += side * circle.friction_rate;
      left.push_back(primitive_multiple(f));
    }
  }
  for (const IntegerVector5& f : left) conditions.push_back({{&f, nullptr}, Sign::kNegative});
  const std::optional<Vector5> low = within(conditions, line, false);
  if (!low) return std::nullopt;
  const std::optional<Vector5> high = within(conditions, line, true);
  const bool holds = high && ((*high)[3].is_zero() || (*low)[4] <= (*high)[4]);
  if (!holds) return std::nullopt;
  return ModeEnds{point_at(line, *low), point_at(line, *high)};
}

ModePoint ModeLines::point_at(const Line& line, const Vector5& x) const {
  ModePoint point{x, {}};
  for (const Circle& circle : line.circles) {
    // All contacts on the circle use the same share of their friction.
    const Rational friction = x[3] * circle.friction + x[4] * circle.friction_rate;
    const Rational share = friction.is_zero() ? Rational(0) : friction / dot(circle.limit, x);
    for (const std::size_t i : circle.contacts) {
      const ContactRow& row = family_.row(ContactId(i));
      const int side = scale_on_circle(row, circle.plane).sign();
      point.friction.emplace_back(
          i, side * share * row.friction * dot(family_.separation(ContactId(i)), x));
    }
  }
  std::sort(point.friction.begin(), point.friction.end());
  return point;
}

std::optional<ModeEnds> ModeLines::ends(const FamilyMode& mode) {
  const std::optional<Line> line = line_of(mode);
  was_line_ = line.has_value();
  return line ? ends_of(mode, *line) : ends_by_programs(family_, mode);
}

}  // namespace stickslip::margin_detail
