// SPDX-License-Identifier: GPL-3.0-or-later
#include "law_forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "allowed_wrenches.hpp"
#include "foresight.hpp"
#include "short_plane.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip {
namespace search_detail {

/// A function of points that a contact's uncertain geometry makes uncertain: it lies between
/// low h + middle - far.|d| and high h + middle + far.|d|.
struct Wedge {
  RationalRow middle;  ///< a function of motions d
  Rational low;        ///< the least factor of the height
  Rational high;       ///< the largest factor of the height
  RationalRow far;     ///< >= 0
};

}  // namespace search_detail

using namespace search_detail;

namespace {

/// Returns the mean of the slip over the corners.
Double3 mean_slip(const LawContact& contact, const Reals& motion) {
  Double3 s{};
  for (const CornerRow& row : contact.corners) {
    for (std::size_t k = 0; k < contact.slip_dimension(); ++k) {
      s[k] += row.slip_rounded[k].dot(motion) / static_cast<double>(contact.corners.size());
    }
  }
  return s;
}

void note_bits(std::size_t& most, const Row& x) {
  for (const Integer& entry : x) {
    if (!entry.is_zero()) most = std::max<std::size_t>(most, msb(abs(entry)) + 1);
  }
}

/// Returns the wedge of a function of motions whose row at each corner is `row_at(corner)`.
template <class RowAt>
Wedge wedge_of(const LawContact& c, const RowAt& row_at) {
  Wedge wedge{row_at(c.place->centre), 0, 0, {}};
  wedge.far.resize(wedge.middle.size());
  for (const CornerRow& corner : c.corners) {
    const RationalRow row = row_at(corner);
    for (std::size_t j = 0; j < row.size(); ++j) {
      wedge.far[j] = std::max<Rational>(wedge.far[j], abs(row[j] - wedge.middle[j]));
    }
  }
  return wedge;
}

/// Returns whether the position is certain and the normal is not.
bool turns_alone(const LawContact& c) {
  return !c.tilt.is_zero() && c.corners.size() <= 4;
}

/// Returns planes between which one corner has the least value of a function and one the most.
/// The function has the row `row_at(corner)` at each corner, and the normal alone turns.
template <class RowAt>
std::vector<Row> corner_orders(const LawContact& c, const RowAt& row_at) {
  const RationalRow first = row_at(c.corners.front());
  std::vector<Row> planes;
  for (std::size_t k = 1; k < c.corners.size(); k *= 2) {  // along each turn
    RationalRow difference = row_at(c.corners[k]);
    for (std::size_t j = 0; j < difference.size(); ++j) difference[j] -= first[j];
    planes.push_back(primitive_multiple(difference));
    planes.back().resize(difference.size() + 2);
  }
  return planes;
}

/// Returns the same for the plane, whatever turns or moves: the coordinates that are rotations.
std::vector<Row> corner_orders(const Law& law, const LawContact& c) {
  std::vector<Row> planes;
  for (std::size_t j = 0; !c.geometry_is_certain() && j < law.motions; ++j) {
    if (law.rotates[j] != 0) planes.emplace_back(law.coordinates())[j] = 1;
  }
  return planes;
}

/// Returns the side, 1 or -1, on which a motion clearly is of all planes; 0 if there is none.
int side_of_all(const Law& law, const std::vector<Row>& planes, const Reals& x) {
  constexpr double kClear = 1e-12;
  const double least = kClear * x.norm();
  bool plus = true;
  bool minus = true;
  for (const Row& plane : planes) {
    const double at = law.value_at(plane, x);
    plus = plus && at > least;
    minus = minus && at < -least;
  }
  return plus ? 1 : minus ? -1 : 0;
}

/// Returns a direction across the first: the part of the second that is across it, if that is
/// clear, else any.
Double3 across(const Double3& direction, const Double3& towards) {
  const double square = dot(direction, direction);
  if (!(square > 0)) return towards;
  const auto without = [&](Double3 a) {
    const double part = dot(a, direction) / square;
    for (std::size_t k = 0; k < 3; ++k) a[k] -= part * direction[k];
    return a;
  };
  constexpr double kClear = 1e-6;
  if (const Double3 result = without(towards); norm_of(result) > kClear) return result;
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::fabs(direction[k]) < std::fabs(direction[least])) least = k;
  }
  Double3 unit{};
  unit[least] = 1;
  return without(unit);
}

/// Returns a friction force, in the numbers of the format, near the direction of these
/// coordinates.
Row in_few_numbers(const LawContact& c, const Double3& coordinates, int bits) {
  Reals numbers = Reals::Zero(static_cast<Eigen::Index>(c.slip_numbers()));
  for (std::size_t k = 0; k < c.slip_dimension(); ++k) {
    for (std::size_t j = 0; j < c.slip_numbers(); ++j) {
      numbers[static_cast<Eigen::Index>(j)] += coordinates[k] * c.unit_directions[k][j];
    }
  }
  return in_bits(numbers, bits);
}

/// Returns the slip of a contact, of one number, at all corners as functions of points.
std::vector<Row> slip_planes(const Law& law, const LawContact& contact) {
  std::vector<Row> planes;
  for (const CornerRow& row : contact.corners) {
    planes.push_back(row.slip_planes(law.coordinates()).front());
  }
  return planes;
}

}  // namespace

double LawForces::height(const Relaxation& found) const {
  return found.motion[static_cast<Eigen::Index>(law_.motions)];
}

LawForces::LawForces(const Law& law, const PullRule* pull, SearchWork& work)
    : law_(law),
      pull_(pull),
      work_(work),
      foresight_(std::make_unique<Foresight>(law.contacts.size())) {}
LawForces::~LawForces() = default;
LawForces::LawForces(LawForces&& other) noexcept = default;

/// The depth stays below what the format allows by more than the parts of a box above this tree
/// (32).
std::size_t LawForces::deepest() const {
  return 2 * law_.contacts.size() + 220;
}

bool LawForces::enter(const MotionRegion& region, std::size_t depth) {
  region_ = &region;
  foreseen_ = foresight_->enter(depth);
  ++work_.nodes;
  work_.rays += region.points().size();
  work_.pairs += region.pairs();
  work_.most_rays = std::max(work_.most_rays, region.points().size());
  for (const Row& x : region.points()) note_bits(work_.ray_bits, x);
  if (region.is_barred()) return false;
  wrenches_ = std::make_unique<AllowedWrenches>(law_, region, pull_);
  return true;
}

/// Searches for a twist. `again` asks that wrenches are against it with some to spare, so that
/// it may be rounded.
LawForces::Found LawForces::nearest(bool again) {
  Found found = foreseen_ && !again ? std::move(*foreseen_) : nearest_of(*wrenches_, again);
  while (!found.separated && wrenches_->are_of_springs(found)) {
    found = nearest_of(*wrenches_, again);
  }
  separated_ = found.separated;
  return found;
}

LawForces::Found LawForces::nearest_of(const AllowedWrenches& wrenches, bool again) const {
  Reals start = -law_.growing;
  for (std::size_t j = 0; j < law_.motions; ++j) {
    start[static_cast<Eigen::Index>(j)] -= law_.load[j][0] + law_.load[j][1];
  }
  wrenches.lines().project(start);
  return nearest_wrench(
      start, [&](const Reals& y) { return wrenches.worst(y); }, again);
}

std::optional<Row> LawForces::confirm(const Reals& twist) {
  auto y = in_few_bits(twist);
  if (y) ++work_.leaves;
  return y;
}

/// Returns the twist in the fewest bits that still refute the region. Most candidates fail
/// clearly.
std::optional<Row> LawForces::in_few_bits(const Reals& twist) {
  Reals y = twist;
  law_.scale_function(y);
  Row exact;
  const auto found =
      in_fewest_bits(y, {2, 3, 4, 6, 8, 10, 12, 16, 24, 36, 50}, [&](const Row& rounded) {
        exact = wrenches_->lines().twist_near(rounded);
        if (const std::optional<bool> known = wrenches_->are_refuted_by(exact)) {
          ++work_.filter_hits;
          return *known;
        }
        ++work_.exact_checks;
        return region_->is_refuted(exact, pull_);
      });
  if (!found) return std::nullopt;
  note_bits(work_.twist_bits, exact);
  return exact;
}

/// Returns the node with its children. A leaf has its twist in fewer bits, if these serve.
LawForces::Branch LawForces::branch(const TreeNode& node) {
  if (const auto* slip = std::get_if<SlipSplit>(&node)) {
    return {node, region_->slip_children(slip->contact.index())};
  }
  if (const auto* split = std::get_if<SeparationSplit>(&node)) {
    return {node, region_->halves(law_.contacts[split->contact.index()].separations.front())};
  }
  const TwistLeaf& leaf = std::get<TwistLeaf>(node);
  require(region_->is_refuted(leaf.twist, pull_), "an exact twist does not refute its region");
  Reals near = in_doubles(leaf.twist);
  law_.scale(near);
  ++work_.leaves;
  return {TwistLeaf{in_few_bits(near).value_or(leaf.twist)}, {}};
}

/// Splits by a plane beside the wedge, towards the motion: all that lies beyond it, strictly,
/// has one sign. Coordinates that make the wedge wide are cut to one sign first, so that there
/// is such a plane. Returns nothing if the motion is in the wedge.
std::optional<LawForces::Branch> LawForces::split_wedge(const Relaxation& found,
                                                        const Wedge& wedge) const {
  const MotionRegion& region = *region_;
  const std::size_t d = law_.motions;
  double value = 0;
  double width = 0;
  for (std::size_t j = 0; j < d; ++j) {
    const double motion = found.motion[static_cast<Eigen::Index>(j)] / law_.unit(j);
    value += to_double(wedge.middle[j]) * motion;
    width += to_double(wedge.far[j]) * std::fabs(motion);
  }
  const double h = height(found);
  const int side = value + to_double(wedge.low) * h - width > 0    ? 1
                   : value + to_double(wedge.high) * h + width < 0 ? -1
                                                                   : 0;
  if (side == 0) return std::nullopt;
  RationalRow towards(law_.coordinates());
  for (std::size_t j = 0; j < d; ++j) towards[j] = side * wedge.middle[j];
  towards[d] = side > 0 ? wedge.low : Rational(-wedge.high);
  for (std::size_t j = 0; j < d; ++j) {
    if (wedge.far[j].is_zero()) continue;
    Row coordinate(law_.coordinates());
    coordinate[j] = 1;
    const PlaneSigns signs = region.signs(coordinate);
    if (signs.cuts()) return Branch{PlaneCut{coordinate}, region.halves(coordinate)};
    towards[j] -= (signs.negative ? -1 : 1) * wedge.far[j];
  }
  const Row plane = negated(primitive_multiple(towards));
  if (!region.signs(plane).negative) return std::nullopt;
  return Branch{PlaneCut{plane}, region.halves(plane)};
}

/// Splits by one plane of few bits beyond these. Planes of many bits make exact arithmetic
/// slow, and this one serves as well. Where normals turn, a plane beyond those of all corners
/// spares the cuts between them.
std::optional<LawForces::Branch> LawForces::split_short(const Relaxation& found,
                                                        const std::vector<Row>& planes,
                                                        bool always) const {
  const MotionRegion& region = *region_;
  if (only_contacts_ || !(always || are_long(planes))) return std::nullopt;
  const int side = side_of_all(law_, planes, found.motion);
  if (side == 0) return std::nullopt;
  Row plane = short_plane(law_, region, planes, found.motion, side);
  if (is_zero(plane)) return std::nullopt;
  if (side > 0) plane = negated(std::move(plane));
  return Branch{PlaneCut{plane}, region.halves(plane)};
}

/// Splits at the nearest of these planes, where the motion is on one side of all. An uncertain
/// function is a combination of theirs. The region is cut to one side of `orders` first, as few
/// corners matter then: the others are never the extreme.
std::optional<LawForces::Branch> LawForces::split_corners(const Relaxation& found,
                                                          const std::vector<Row>& planes,
                                                          const std::vector<Row>& orders,
                                                          bool is_slip) const {
  const MotionRegion& region = *region_;
  const bool stands_still =
      !(found.motion.head(static_cast<Eigen::Index>(law_.motions)).squaredNorm() > 0);
  const int side = stands_still ? 1 : side_of_all(law_, planes, found.motion);
  if (side == 0 && !law_.is_family) return std::nullopt;
  for (const Row& plane : orders) {
    if (region.signs(plane).cuts()) return Branch{PlaneCut{plane}, region.halves(plane)};
  }
  const Row* nearest = nullptr;
  double least = HUGE_VAL;
  for (const Row& plane : planes) {
    const double value = law_.value_at(plane, found.motion);
    const double distance = side == 0 ? std::fabs(value) : side * value;
    if (!(distance < least)) continue;
    const PlaneSigns signs = region.signs(plane);
    // A slip's plane also serves if the slip is only 0 somewhere beyond it.
    const bool here = side > 0 ? signs.positive : signs.negative;
    if (!signs.cuts() && !(is_slip && here && !signs.zeros_barred)) continue;
    least = distance;
    nearest = &plane;
  }
  if (nearest == nullptr) return std::nullopt;
  // The strict side is that of the motion.
  const Row plane = is_slip && side > 0 ? negated(*nearest) : *nearest;
  return Branch{PlaneCut{plane}, region.halves(plane)};
}

std::optional<LawForces::Branch> LawForces::split_separation(const Relaxation& found,
                                                             std::size_t contact) const {
  const MotionRegion& region = *region_;
  const LawContact& c = law_.contacts[contact];
  if (auto branch = split_short(found, c.separations, turns_alone(c))) return branch;
  if (c.has_certain_separation) {
    return Branch{SeparationSplit{ContactId(contact)}, region.halves(c.separations.front())};
  }
  const auto row_at = [](const CornerRow& row) { return row.normal; };
  if (turns_alone(c)) {
    return split_corners(found, c.separations, corner_orders(c, row_at), false);
  }
  // (Only a motion can be on one side of a wedge.)
  if (!c.place || c.slip_dimension() == 1 || law_.is_family || found.motion.isZero(0))
    return split_corners(found, c.separations, corner_orders(law_, c), false);
  // The wedge is that of v / k'.
  Wedge wedge = wedge_of(c, row_at);
  for (Rational& entry : wedge.middle) entry = -entry;
  wedge.low = c.preload.low / c.stiffness.high;
  wedge.high = c.preload.high / c.stiffness.low;
  return split_wedge(found, wedge);
}

std::optional<LawForces::Branch> LawForces::split_slip(const Relaxation& found,
                                                       std::size_t contact) const {
  const MotionRegion& region = *region_;
  const LawContact& c = law_.contacts[contact];
  const bool is_known =
      region.slips(contact).moves || region.is_strict(contact) || region.is_still(contact);
  if (c.slip_dimension() == 1) {
    if (is_known) return std::nullopt;
    const std::vector<Row> planes = slip_planes(law_, c);
    if (auto branch = split_short(found, planes)) return branch;
    if (!c.geometry_is_certain()) {
      return split_corners(found, planes, corner_orders(law_, c), true);
    }
  } else if (is_known || !c.geometry_is_certain()) {
    return split_spatial_slip(found, contact);
  }
  return Branch{SlipSplit{ContactId(contact)}, region.slip_children(contact)};
}

/// Splits by the sign of the slip along the mean of its direction and of the one that friction
/// implies; or across that mean, if the cone of slips is narrow already.
std::optional<LawForces::Branch> LawForces::split_spatial_slip(const Relaxation& found,
                                                               std::size_t contact) const {
  const MotionRegion& region = *region_;
  const LawContact& c = law_.contacts[contact];
  const Double3 s = mean_slip(c, found.motion.head(static_cast<Eigen::Index>(law_.motions)));
  const Double3& f = found.friction[contact];
  const double slip_size = norm_of(s);
  const double friction_size = norm_of(f);
  Double3 mean{};
  Double3 apart{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = slip_size > 0 ? s[k] / slip_size : 0;
    const double against = friction_size > 0 ? -f[k] / friction_size : 0;
    mean[k] = along + against;
    apart[k] = along - against;
  }
  constexpr double kOpposed = 1e-6;
  if (!(norm_of(mean) > kOpposed)) mean = s;  // friction along the slip
  const Double3 turned =
      c.slip_dimension() == 2 ? Double3{-mean[1], mean[0], 0} : across(mean, apart);
  // The plane is a.s as a function of points, with a of few bits.
  const auto plane_along = [&](const Double3& a) -> std::optional<Row> {
    for (const int bits : {3, 6, 10, 16, 24, 36, 50}) {
      const Row direction = in_few_numbers(c, a, bits);
      Row plane(law_.coordinates());
      for (std::size_t j = 0; j < law_.motions; ++j) {
        for (std::size_t k = 0; k < direction.size(); ++k) {
          plane[j] += direction[k] * c.corners.front().slip[k][j];
        }
      }
      plane = primitive(std::move(plane));
      if (region.signs(plane).cuts()) return plane;
    }
    return std::nullopt;
  };
  const SlipCone& cone = region.slips(contact);
  const bool narrow = cone.moves && !cone.whole;
  if (!c.geometry_is_certain() && !narrow) {
    const Row direction = in_few_numbers(c, mean, 6);
    const RationalRow along(direction.begin(), direction.end());
    const auto row_at = [&](const CornerRow& row) { return row.wrench_of(along); };
    if (!turns_alone(c)) return split_wedge(found, wedge_of(c, row_at));
    std::vector<Row> planes;
    for (const CornerRow& row : c.corners) {
      planes.push_back(primitive_multiple(row_at(row)));
      planes.back().resize(law_.coordinates());
    }
    if (auto branch = split_short(found, planes, true)) return branch;
    return split_corners(found, planes, corner_orders(c, row_at), false);
  }
  auto plane = plane_along(narrow ? turned : mean);
  if (!plane) plane = plane_along(narrow ? mean : turned);
  if (!plane) return std::nullopt;
  return Branch{PlaneCut{*plane}, region.halves(*plane)};
}

Relaxation LawForces::relaxed(const Found& found) const {
  Relaxation result = wrenches_->combine(found);
  const auto d = static_cast<Eigen::Index>(law_.motions);
  const Reals motion = result.motion.head(d);
  for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
    const LawContact& c = law_.contacts[i];
    const double a = result.normal[i];
    const double stiffness = (c.stiffnesses[0] + c.stiffnesses[1]) / 2;
    if (stiffness > 0) result.energy += a * a / stiffness;
    if (region_->separation(i) == Separation::kMixed) {
      double lawful = result.motion[d] * (c.preloads[0] + c.preloads[1]) / 2 +
                      result.motion[d + 1] * (c.rates[0] + c.rates[1]) / 2;
      for (const CornerRow& row : c.corners) {
        lawful -=
            stiffness * row.normal_rounded.dot(motion) / static_cast<double>(c.corners.size());
      }
      lawful = std::max(0.0, lawful);
      const double gap = std::fabs(a - lawful) * std::max(a, lawful) / stiffness;
      result.separations.emplace_back(gap, i);
    }
    if (c.slopes[1] > 0 && a > 0 && !region_->is_still(i)) {
      const Double3 s = mean_slip(c, motion);
      result.slips.emplace_back(a * c.slopes[0] * norm_of(s) + dot(result.friction[i], s), i);
    }
  }
  for (auto* gaps : {&result.separations, &result.slips}) {
    std::sort(gaps->rbegin(), gaps->rend());
    if (!gaps->empty()) result.gap = std::max(result.gap, gaps->front().first);
  }
  result.gap /= result.energy;
  return result;
}

std::optional<LawForces::Branch> LawForces::split(const Relaxation& found) {
  if (const auto plane = region_->bound_across(found.motion); plane && !only_contacts_) {
    return Branch{PlaneCut{*plane}, region_->halves(*plane)};
  }
  return best_split(found);
}

/// Splits where a law is broken noticeably: where it is broken most or, of many coordinates,
/// where the fewest children are left that are not refuted at once. (Of few, nodes cost less
/// than looking ahead.)
std::optional<LawForces::Branch> LawForces::best_split(const Relaxation& found) {
  constexpr double kNoticeable = 1e-12;  // relative to the energy; only chooses between splits
  constexpr std::size_t kFewMotions = 12;
  constexpr std::size_t kMostTries = 8;
  constexpr std::size_t kManyPoints = 500;  // such a child counts as two
  const bool looks_ahead = law_.motions > kFewMotions;
  std::vector<SplitChoice> splits;
  for (const bool is_slip : {false, true}) {
    for (const auto& [gap, contact] : is_slip ? found.slips : found.separations) {
      if (gap > kNoticeable * found.energy) splits.push_back({is_slip, contact, splits.size()});
    }
  }
  if (looks_ahead) foresight_->sort(splits);
  std::optional<Branch> best;
  Foresight::Children of_best;
  std::pair<std::size_t, std::size_t> least{SIZE_MAX, 0};  // children left, and the order
  std::size_t tries = 0;
  std::vector<std::vector<Row>> slips;  // contacts on one face may slip together
  for (const SplitChoice& split : splits) {
    if (looks_ahead && split.is_slip) {
      const CornerRow& row = law_.contacts[split.contact].corners.front();
      auto planes = row.slip_planes(law_.coordinates());
      if (std::find(slips.begin(), slips.end(), planes) != slips.end()) continue;
      slips.push_back(std::move(planes));
    }
    auto branch = split.is_slip ? split_slip(found, split.contact)
                                : split_separation(found, split.contact);
    if (!branch) continue;
    if (!looks_ahead) return branch;
    Foresight::Children children;
    std::size_t left = 0;
    for (const MotionRegion& child : branch->children) {
      children.emplace_back();
      if (child.is_barred()) continue;
      children.back() = nearest_of(AllowedWrenches(law_, child, pull_), false);
      if (!children.back()->separated) left += child.points().size() > kManyPoints ? 2 : 1;
      if (left > least.first) break;
    }
    foresight_->learn(split, left <= 1);
    if (std::pair(left, split.order) < least) {
      least = {left, split.order};
      best = std::move(branch);
      of_best = std::move(children);
    }
    if (left <= 1 || ++tries == kMostTries) break;
  }
  foresight_->expect(std::move(of_best));
  return best;
}

/// Splits between two generators that take part.
std::optional<LawForces::Branch> LawForces::split_anywhere(const Relaxation& found) const {
  for (const auto& [a, b] : found.pairs) {
    const Row plane =
        law_.plane_between(region_->generators()[a], region_->generators()[b], found.motion);
    if (region_->signs(plane).cuts()) return Branch{PlaneCut{plane}, region_->halves(plane)};
  }
  return std::nullopt;
}

bool LawForces::is_far(const Relaxation& found) const {
  for (std::size_t j = 0; j < law_.far_motion.size(); ++j) {
    const double d = std::fabs(found.motion[static_cast<Eigen::Index>(j)]);
    constexpr double kSurely = 1e3;  // motions only a little beyond may come near again
    if (d > kSurely * height(found) * to_double(law_.far_motion[j]) * law_.unit(j)) return true;
  }
  return false;
}

/// Returns whether the search ends: motions of a margin that grow without end towards one
/// multiple would let the tree grow, too. After keep_near() many far motions end it as well.
bool LawForces::escapes(const Relaxation& found) {
  constexpr std::size_t kManyFar = 80;
  if (keeps_near_ && is_far(found) && ++far_ > kManyFar) return true;
  constexpr double kFar = 1e6;
  const double h = height(found);
  const double stiffest = law_.force / law_.reach;
  const double size = found.motion.head(static_cast<Eigen::Index>(law_.motions)).norm();
  // The forces are of a typical size nevertheless.
  return law_.is_family && size > kFar * law_.reach * h &&
         found.energy < kFar * law_.force * law_.force * h * h / stiffest;
}

/// Takes a relaxed equilibrium at its word: its motion says which contacts slip.
std::optional<NearEquilibrium> LawForces::candidate(const Relaxation& found) const {
  const double h = height(found);
  if (!(h > 0)) return std::nullopt;
  const auto d = static_cast<Eigen::Index>(law_.motions);
  const Reals motion = found.motion.head(d);
  NearEquilibrium near{motion / h, found.normal, found.friction,
                       std::vector<char>(found.normal.size()), found.motion[d + 1] / h};
  for (std::size_t i = 0; i < near.normal.size(); ++i) {
    near.normal[i] /= h;
    for (double& entry : near.friction[i]) entry /= h;
    const LawContact& c = law_.contacts[i];
    const double slip = norm_of(mean_slip(c, motion));
    constexpr double kStill = 1e-7;  // relative to all motion
    const bool rubs = near.normal[i] > 0 && c.slopes[1] > 0;
    near.sticks[i] = rubs && (region_->is_still(i) || slip <= kStill * motion.norm()) ? 1 : 0;
  }
  return near;
}

}  // namespace stickslip
