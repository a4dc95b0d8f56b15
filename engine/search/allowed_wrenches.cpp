// SPDX-License-Identifier: GPL-3.0-or-later
#include "allowed_wrenches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/motion/dense.hpp"
#include "nearest_in_cone.hpp"

namespace stickslip::search_detail {
Actions::Actions(const Law& law, const MotionRegion& region, const Reals& y)
    : law_(law), region_(region), all_(law.contacts.size()), pairs_(law.contacts.size()) {
  for (std::size_t i = 0; i < law.contacts.size(); ++i) {
    if (region.separation(i) == Separation::kOpen) continue;
    const LawContact& c = law.contacts[i];
    if (!c.whole) {
      all_[i] = action(i, y);
      continue;
    }
    PairsAction& pairs = pairs_[i].emplace(
        PairsAction{{c.preloads, c.stiffnesses}, region.slopes(i, c.slopes), {}});
    std::vector<std::vector<double>> alpha;
    for (const double slope : pairs.slopes) {
      std::vector<double>& of = alpha.emplace_back();
      for (const CornerRow& row : c.corners) {
        of.push_back(row.normal_rounded.dot(y) + slope * row.slip_rounded.front().dot(y));
      }
    }
    pairs.work.emplace(pairs.ends, std::move(alpha),
                       region.separation(i) == Separation::kMixed);
  }
}

Action Actions::action(std::size_t i, const Reals& y) const {
  const LawContact& c = law_.contacts[i];
  const SlipCone& cone = region_.slips(i);
  constexpr double kVanishing = 1e-12;
  Action best{-HUGE_VAL, {}, 0};
  for (std::size_t k = 0; k < c.corners.size(); ++k) {
    const CornerRow& row = c.corners[k];
    const double normal = row.normal_rounded.dot(y);
    Double3 slid{};
    for (std::size_t j = 0; j < c.slip_dimension(); ++j) slid[j] = row.slip_rounded[j].dot(y);
    double most = norm_of(slid);
    Double3 along = slid;
    for (double& entry : along) entry = most > 0 ? entry / most : 0;
    const Double3 straight = along;
    const double beside = c.tilted * most;
    // (Where y sees no slip any friction does the same work, but not all is allowed.)
    const bool is_bound = cone.moves && !cone.whole && !cone.sides.empty();
    const Double3 nearest =
        is_bound && c.slip_dimension() == 3
            ? nearest_in_cone(cone.units, {-slid[0], -slid[1], -slid[2]}).point
            : Double3{};
    if (const double near = norm_of(nearest); near > kVanishing * most) {
      most = near;
      for (std::size_t j = 0; j < 3; ++j) along[j] = -nearest[j] / near;
    } else if (is_bound && (most == 0 || !is_against(i, slid))) {
      most = -HUGE_VAL;
      for (const auto& [g, corner] : cone.sides) {
        const Double3& s = region_.slip(i, g, corner);
        const double length = norm_of(s);
        const double work = -dot(s, slid) / length;
        if (!(work > most)) continue;
        most = work;
        for (std::size_t j = 0; j < 3; ++j) along[j] = -s[j] / length;
      }
    }
    most += beside;
    for (std::size_t j = 0; j < 3; ++j) along[j] += c.tilted * straight[j];
    const double slope = most > 0 ? c.slopes[1] : c.slopes[0];
    const double alpha = normal + slope * most;
    if (!(alpha > best.alpha)) continue;
    best = {alpha, along, k};
    for (double& entry : best.friction) entry *= slope;
  }
  return best;
}

/// Returns whether -slid lies in the cone of slips. In two dimensions the angles of its sides
/// tell; in three it does not, as no point of the cone is near.
bool Actions::is_against(std::size_t i, const Double3& slid) const {
  const LawContact& c = law_.contacts[i];
  const auto& sides = region_.slips(i).sides;
  if (c.slip_dimension() == 1) {
    return region_.slip(i, sides.front().first, sides.front().second)[0] * slid[0] < 0;
  }
  if (c.slip_dimension() == 3) return false;
  const auto angle = [](const Double3& s) { return std::atan2(s[1], s[0]); };
  constexpr double kPi = 3.14159265358979323846;
  const double at = angle(slid) + kPi;
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const auto& [g, corner] : sides) {
    const double off = std::remainder(angle(region_.slip(i, g, corner)) - at, 2 * kPi);
    least = std::min(least, off);
    most = std::max(most, off);
  }
  return least <= 0 && most >= 0 && most - least < kPi + 1e-7;
}

/// Returns the contact's normal coefficient at a generator where its force does the most work.
double Actions::normal(std::size_t contact, std::size_t generator) const {
  const double alpha = all_[contact].alpha;
  if (region_.separation(contact) == Separation::kMixed) {
    return alpha > 0 ? std::max(0.0, region_.most_separation(contact, generator)) : 0;
  }
  return alpha > 0 ? region_.most_separation(contact, generator)
                   : region_.least_separation(contact, generator);
}

double Actions::work(std::size_t contact, std::size_t generator) const {
  if (region_.separation(contact) == Separation::kOpen) return 0;
  if (!pairs_[contact]) return normal(contact, generator) * all_[contact].alpha;
  const CornerWork<double>& work = *pairs_[contact]->work;
  const Strongest<double> strongest =
      work.at(height(generator), region_.rises(contact, generator));
  if (strongest.friction == 2) return 0;
  return strongest.bound / static_cast<double>(work.pairs().corners);
}

bool Actions::acts(std::size_t contact, std::size_t generator) const {
  if (region_.separation(contact) == Separation::kOpen) return false;
  return (pairs_[contact] ? work(contact, generator) : normal(contact, generator)) != 0;
}

void Actions::add_work(std::size_t contact, std::vector<double>& works) const {
  if (region_.separation(contact) == Separation::kOpen) return;
  if (pairs_[contact]) {
    for (std::size_t g = 0; g < works.size(); ++g) works[g] += work(contact, g);
    return;
  }
  const double alpha = all_[contact].alpha;
  const bool is_mixed = region_.separation(contact) == Separation::kMixed;
  if (is_mixed && !(alpha > 0)) return;
  const double* normals = alpha > 0 ? region_.most_separations(contact)  //
                                    : region_.least_separations(contact);
  const double least = is_mixed ? 0 : -HUGE_VAL;
  for (std::size_t g = 0; g < works.size(); ++g) {
    works[g] += alpha * std::max(least, normals[g]);
  }
}

bool Actions::is_clear(std::size_t contact, double error) const {
  if (!pairs_[contact] || region_.separation(contact) != Separation::kMixed) return true;
  return pairs_[contact]->work->is_clear(error);
}

bool Actions::is_idle(std::size_t contact, std::size_t generator) const {
  const Separation separation = region_.separation(contact);
  if (separation == Separation::kOpen) return true;
  const bool is_mixed = separation == Separation::kMixed;
  const bool pushes =
      pairs_[contact] ? pairs_[contact]->work->pushes() : all_[contact].alpha > 0;
  if (is_mixed && !pushes) return true;
  if (region_.most_separation(contact, generator) > 0) return false;
  return is_mixed || region_.least_separation(contact, generator) == 0;
}

void Actions::add_force(std::size_t contact, std::size_t generator, double& normal_sum,
                        Double3& friction, Reals& wrench) const {
  if (region_.separation(contact) == Separation::kOpen) return;
  const LawContact& c = law_.contacts[contact];
  if (!pairs_[contact]) {
    const double a = normal(contact, generator);
    if (a == 0) return;
    const CornerRow& row = c.corners[all_[contact].corner];
    normal_sum += a;
    wrench += a * row.normal_rounded;
    for (std::size_t k = 0; k < c.slip_dimension(); ++k) {
      friction[k] += a * all_[contact].friction[k];
      wrench += a * all_[contact].friction[k] * row.slip_rounded[k];
    }
    return;
  }
  const PairsAction& all = *pairs_[contact];
  const double h = height(generator);
  const double* rises = region_.rises(contact, generator);
  const Strongest<double> s = all.work->at(h, rises);
  if (s.friction == 2 ||
      (region_.separation(contact) == Separation::kMixed && !(s.bound > 0))) {
    return;
  }
  const double slope = all.slopes[s.friction];
  const CornerPairs& pairs = all.work->pairs();
  const double preload = h * c.preloads[s.preload];
  const double stiffness = c.stiffnesses[s.stiffness];
  const auto add = [&](double a, std::size_t corner) {
    normal_sum += a;
    friction[0] += slope * a;
    const CornerRow& row = c.corners[corner];
    wrench += a * (row.normal_rounded + slope * row.slip_rounded.front());
  };
  if (s.product) {
    add(preload - stiffness * *std::min_element(rises, rises + pairs.corners), s.corner);
    return;
  }
  for (std::size_t pair = 0; pair < pairs.cell.size(); ++pair) {
    if (pairs.cell[pair] != s.cell) continue;
    const double v = preload - stiffness * rises[pair % pairs.corners];
    add(v * static_cast<double>(pairs.share[s.cell]) / static_cast<double>(pairs.corners),
        pair / pairs.corners);
  }
}

AllowedWrenches::AllowedWrenches(const Law& law, const MotionRegion& region,
                                 const PullRule* pull)
    : law_(law), region_(region), lines_(law, region) {
  // The scales are comparable sizes of the wrenches at the generators; 0 where there are none.
  const auto d = static_cast<Eigen::Index>(law.motions);
  for (std::size_t g = 0; g < region.generators().size(); ++g) {
    const Reals& x = region.generators()[g];
    double scale = x[d] * law.force + std::fabs(x[d + 1]) * law.growing.norm();
    for (std::size_t i = 0; i < law.contacts.size(); ++i) {
      if (region.separation(i) == Separation::kOpen) continue;
      const double size = law.contacts[i].corners[0].normal_rounded.norm();
      const double most = region.most_separation(i, g);
      scale += (law.contacts[i].is_spring ? std::fabs(most) : std::max(0.0, most)) * size;
    }
    scales_.push_back(scale);
    if (pull != nullptr) {
      Reals& against = against_.emplace_back(pull->against(region.points()[g]));
      law.scale_function(against);
      normalize(against);
    }
  }
  if (law.hull) {
    for (const LoadGenerator& direction : law.hull->directions) {
      against_.push_back(direction.rounded);
    }
  }
  may_certify_ = law.is_moderate && !law.is_family && are_small(region.points()) &&
                 std::all_of(law.contacts.begin(), law.contacts.end(),
                             [](const LawContact& c) { return c.slip_dimension() == 1; });
}

bool AllowedWrenches::are_small(const std::vector<Row>& points) const {
  constexpr std::size_t kMostBits = 200;
  for (const Row& x : points) {
    for (const Integer& entry : x) {
      if (!entry.is_zero() && msb(abs(entry)) >= kMostBits) return false;
    }
  }
  return true;
}

namespace {

/// Returns the largest |alpha| of a contact in the plane, without cancellation.
double most_alpha(const LawContact& c, const Reals& y) {
  double most = 0;
  for (const CornerRow& row : c.corners) {
    double size = 0;
    for (Eigen::Index j = 0; j < y.size(); ++j) {
      size += std::fabs(y[j]) * (std::fabs(row.normal_rounded[j]) +
                                 c.slopes[1] * std::fabs(row.slip_rounded.front()[j]));
    }
    most = std::max(most, size);
  }
  return most;
}

/// Returns the largest |v| at a point, without cancellation.
double most_separation(const LawContact& c, const Reals& x) {
  double rise = 0;
  for (const CornerRow& row : c.corners) {
    double size = 0;
    for (Eigen::Index j = 0; j < row.normal_rounded.size(); ++j) {
      size += std::fabs(row.normal_rounded[j] * x[j]);
    }
    rise = std::max(rise, size);
  }
  return x[x.size() - 2] * c.preloads[1] + c.stiffnesses[1] * rise;
}

}  // namespace

/// Returns the largest |v|, without cancellation, by generator and contact.
const std::vector<double>& AllowedWrenches::sizes() const {
  if (!sizes_.empty()) return sizes_;
  for (const Reals& x : region_.generators()) {
    for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
      const bool acts = region_.separation(i) != Separation::kOpen;
      sizes_.push_back(acts ? most_separation(law_.contacts[i], x) : 0);
    }
  }
  return sizes_;
}

std::optional<bool> AllowedWrenches::are_refuted_by(const Row& exact) const {
  Reals y = in_doubles(exact);
  law_.scale(y);
  // Every number is within four roundings of the exact one, up to the factors of the rays. A
  // term has fewer than ten factors and sums; a mean over the corners is a sum of 64 at most.
  // Underflows are far below kUnderflow.
  constexpr double kUnitRoundoff = 1.2e-16;
  constexpr double kUnderflow = 1e-250;
  constexpr double kDoubtful = 1e-9;  // used if no error is bounded
  const std::size_t m = law_.contacts.size();
  const double part = may_certify_ ? kUnitRoundoff * (300 + static_cast<double>(m)) : kDoubtful;
  const Actions actions(law_, region_, y);
  bool certain = may_certify_;
  std::vector<double> alphas;
  for (std::size_t i = 0; certain && i < m; ++i) {
    alphas.push_back(most_alpha(law_.contacts[i], y));
    certain = actions.is_clear(i, part * alphas.back());
  }
  if (may_certify_ && !certain) return std::nullopt;
  for (const Reals& against : against_) {
    const double work = against.dot(y);
    const double error = part * y.norm();
    if (work > error) return false;
    if (!(work < -error)) certain = false;
  }
  const auto d = static_cast<Eigen::Index>(law_.motions);
  const double load_size = law_.load_size(y);
  for (std::size_t g = 0; g < region_.generators().size(); ++g) {
    const Reals& x = region_.generators()[g];
    double work = load_at(g, y).dot(y);
    double size =
        std::fabs(x[d + 1]) * law_.growing.cwiseAbs().dot(y.cwiseAbs()) + x[d] * load_size;
    bool is_idle = x[d] == 0;
    for (std::size_t i = 0; i < m; ++i) {
      const double here = actions.work(i, g);
      work += here;
      size += may_certify_ ? alphas[i] * sizes()[g * m + i] : std::fabs(here);
      is_idle = is_idle && actions.is_idle(i, g);
    }
    if (may_certify_ && is_idle) continue;  // g and h are 0: the ray is barred
    const double error = part * size + kUnderflow;
    if (work > error) return false;
    if (!(work < -error)) certain = false;
  }
  if (certain) return true;
  return std::nullopt;
}

Reals AllowedWrenches::load_at(std::size_t generator, const Reals& y) const {
  const Reals& x = region_.generators()[generator];
  const auto d = static_cast<Eigen::Index>(law_.motions);
  return law_.load_at(x[d], x[d + 1], y);
}

std::optional<AllowedWrench> AllowedWrenches::worst(const Reals& y) const {
  const Actions actions(law_, region_, y);
  const auto d = static_cast<Eigen::Index>(law_.motions);
  // No twist that matters sees what springs do along lines.
  const auto is_left_out = [&](std::size_t contact, std::size_t generator) {
    return law_.contacts[contact].is_spring && lines_.has(generator);
  };
  const Reals load = law_.load_at(1, 0, y);
  const double load_work = load.dot(y);
  const double growing_work = law_.growing.dot(y);
  std::vector<double> works;  // by generator
  for (const Reals& x : region_.generators()) {
    works.push_back(x[d] * load_work + x[d + 1] * growing_work);
  }
  for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
    if (!lines_.empty() && law_.contacts[i].is_spring) {
      for (std::size_t g = 0; g < works.size(); ++g) {
        if (!lines_.has(g)) works[g] += actions.work(i, g);
      }
    } else {
      actions.add_work(i, works);
    }
  }
  // A generator where nothing acts is an equilibrium, unless strict functions bar it.
  const auto is_allowed = [&](std::size_t g) {
    if (!region_.bars_point(g) || load_at(g, y).squaredNorm() > 0) return true;
    for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
      if (!is_left_out(i, g) && actions.acts(i, g)) return true;
    }
    return false;
  };
  AllowedWrench best;
  best.work = -HUGE_VAL;
  for (std::size_t g = 0; g < scales_.size(); ++g) {
    if (!(scales_[g] > 0)) continue;
    const double work = works[g] / scales_[g];
    if (work > best.work && is_allowed(g)) {
      best.work = work;
      best.generator = g;
    }
  }
  const std::size_t none = region_.generators().size();
  const std::size_t pulls = against_.size() - (law_.hull ? law_.hull->directions.size() : 0);
  for (std::size_t k = 0; k < against_.size(); ++k) {
    if (against_[k].squaredNorm() == 0) continue;  // a free motion
    const double work = against_[k].dot(y);
    if (work > best.work) best = {work, against_[k], {}, k < pulls ? k : none, true};
  }
  if (best.work == -HUGE_VAL) return std::nullopt;  // nothing acts
  if (best.against) return best;
  const std::size_t m = law_.contacts.size();
  best.normal.resize(m);
  best.friction.resize(m);
  best.wrench = load_at(best.generator, y);
  for (std::size_t i = 0; i < m; ++i) {
    if (is_left_out(i, best.generator)) continue;
    actions.add_force(i, best.generator, best.normal[i], best.friction[i], best.wrench);
  }
  if (!lines_.empty()) {
    best.whole = best.wrench;
    lines_.project(best.wrench);
  }
  best.wrench /= scales_[best.generator];
  return best;
}

bool AllowedWrenches::are_of_springs(const NearestWrench<Reals, AllowedWrench>& found) {
  constexpr double kTakesPart = 1e-9;
  const auto d = static_cast<Eigen::Index>(law_.motions);
  std::vector<std::size_t> generators;
  for (const auto& [part, s] : found.parts) {
    if (part < kTakesPart) continue;
    if (s.against || region_.generators()[s.generator][d] != 0) return false;
    for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
      if (!law_.contacts[i].is_spring && s.normal[i] != 0) return false;
    }
    generators.push_back(s.generator);
  }
  return lines_.add(generators);
}

/// Moves along the lines until what springs do there balances the wrench that is left over.
void AllowedWrenches::balance_along_lines(Relaxation& relaxed, const Reals& wrench) const {
  const auto d = static_cast<Eigen::Index>(law_.motions);
  const auto count = static_cast<Eigen::Index>(lines_.generators().size());
  const auto line = [&](Eigen::Index k) -> const Reals& {
    return region_.generators()[lines_.generators()[static_cast<std::size_t>(k)]];
  };
  Eigen::MatrixXd answers = Eigen::MatrixXd::Zero(d, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (const LawContact& c : law_.contacts) {
      if (!c.is_spring) continue;
      const Reals& normal = c.corners.front().normal_rounded;
      const double stiffness = (c.stiffnesses[0] + c.stiffnesses[1]) / 2;
      answers.col(k) -= stiffness * normal.dot(line(k).head(d)) * normal;
    }
  }
  const Eigen::VectorXd parts = -least_squares(answers, wrench);
  if (!parts.allFinite()) return;
  for (Eigen::Index k = 0; k < count; ++k) relaxed.motion += parts[k] * line(k);
  for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
    const LawContact& c = law_.contacts[i];
    if (!c.is_spring) continue;
    const double stiffness = (c.stiffnesses[0] + c.stiffnesses[1]) / 2;
    for (Eigen::Index k = 0; k < count; ++k) {
      relaxed.normal[i] -=
          stiffness * parts[k] * c.corners.front().normal_rounded.dot(line(k).head(d));
    }
  }
}

Relaxation AllowedWrenches::combine(const NearestWrench<Reals, AllowedWrench>& found) const {
  const std::size_t m = law_.contacts.size();
  Relaxation result;
  result.motion = Reals::Zero(static_cast<Eigen::Index>(law_.coordinates()));
  result.normal.resize(m);
  result.friction.resize(m);
  Reals wrench = Reals::Zero(static_cast<Eigen::Index>(law_.motions));
  for (const auto& [part, s] : found.parts) {
    if (s.against) continue;
    const double weight = part / scales_[s.generator];
    if (s.whole.size() > 0) wrench += weight * s.whole;
    result.motion += weight * region_.generators()[s.generator];
    for (std::size_t i = 0; i < m; ++i) {
      result.normal[i] += weight * s.normal[i];
      for (std::size_t j = 0; j < 3; ++j) result.friction[i][j] += weight * s.friction[i][j];
    }
  }
  if (!lines_.empty()) balance_along_lines(result, wrench);
  // Wrenches with `against` are paired from the first generator, and from their own after that:
  // as measured, that takes fewer nodes.
  for (const bool where_against : {false, true}) {
    const std::size_t none = region_.generators().size();
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> pairs;
    for (std::size_t a = 0; a < found.parts.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const auto& [part_a, wrench_a] = found.parts[a];
        const auto& [part_b, wrench_b] = found.parts[b];
        const bool has_against = wrench_a.against || wrench_b.against;
        if (where_against && !has_against) continue;
        const auto generator = [&](const AllowedWrench& s) {
          return s.against && !where_against ? 0 : s.generator;
        };
        const std::size_t one = generator(wrench_a);
        const std::size_t other = generator(wrench_b);
        if (one == none || other == none) continue;
        const double distance =
            (region_.generators()[one] - region_.generators()[other]).squaredNorm();
        if (distance > 0) pairs.push_back({-distance * std::min(part_a, part_b), {one, other}});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [size, pair] : pairs) result.pairs.push_back(pair);
  }
  return result;
}

}  // namespace stickslip::search_detail
