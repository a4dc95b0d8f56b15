// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/motion/dense.hpp"
#include "independent_rows.hpp"
#include "smooth_newton.hpp"

namespace stickslip {
namespace {

/// A slip, or friction across a normal.
using Across = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;
using Curvature = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

Across across(const Double3& f, const RoundedContact& c) {
  return Eigen::Map<const Eigen::Vector3d>(f.data()).head(c.slip.rows());
}

Double3 stored(const Across& f) {
  Double3 result{};
  for (Eigen::Index k = 0; k < f.size(); ++k) result[static_cast<std::size_t>(k)] = f[k];
  return result;
}

/// Returns how the direction of a slip changes with it, times its length.
Curvature across_slip(const Across& direction) {
  return Curvature::Identity(direction.size(), direction.size()) -
         direction * direction.transpose();
}

}  // namespace

/// Returns how the force of a contact grows with the size over which friction is smooth.
double Newton::pressing(const RoundedContact& c) const {
  return c.is_spring ? 0 : press_ * c.stiffness * c.size;
}

/// Returns the load and all forces, with friction smoothed over slips of this size; sets the
/// derivative.
Reals Newton::force(const Reals& motion, double smooth, Eigen::MatrixXd* derivative) const {
  Reals sum = grasp_.load;
  if (derivative != nullptr) derivative->setZero(motion.size(), motion.size());
  for (const RoundedContact& c : grasp_.contacts) {
    const double a = c.separation(motion) + smooth * pressing(c);
    if (!c.acts(a)) continue;
    Reals wrench = c.normal;
    if (c.slope > 0) {
      const Across s = c.slip * motion;
      const double size = s.norm();
      const double over = std::max(size, smooth);
      if (over > 0) {
        wrench -= c.slope / over * (c.slip.transpose() * s);
        if (derivative != nullptr) {
          Curvature change = Curvature::Identity(s.size(), s.size());
          if (size >= smooth) change = across_slip(s / size);
          derivative->noalias() -= a * c.slope / over * (c.slip.transpose() * change * c.slip);
        }
      }
    }
    sum += a * wrench;
    if (derivative != nullptr) *derivative -= c.stiffness * wrench * c.normal.transpose();
  }
  return sum;
}

ModalEquations::ModalEquations(const RoundedGrasp& grasp, NearEquilibrium& near)
    : off_(grasp.load) {
  const Eigen::Index d = grasp.motions();
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    if (near.sticks[i] != 0) size += grasp.contacts[i].slip.rows();
  }
  slips_.resize(size);
  derivative_ = Eigen::MatrixXd::Zero(d, d);
  Eigen::MatrixXd sticking(d, size);  // the wrenches of friction, by columns
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const RoundedContact& c = grasp.contacts[i];
    double a = c.separation(near.motion);
    constexpr double kTouches = 1e-13;  // rounding lets nothing rub
    if (!c.is_spring && a < kTouches * grasp.force / c.size) a = 0;
    near.normal[i] = a;
    if (near.sticks[i] == 0 && !c.is_spring && !(a > 0)) continue;
    const Across s = c.slip * near.motion;
    Reals wrench = c.normal;
    if (near.sticks[i] != 0) {
      off_ += c.slip.transpose() * across(near.friction[i], c);
      slips_.segment(next, s.size()) = s;
      sticking.middleCols(next, s.size()) = c.slip.transpose();
      next += s.size();
    } else if (c.slope > 0 && s.norm() > 0) {
      const Across along = s.normalized();
      wrench -= c.slope * (c.slip.transpose() * along);
      derivative_ -=
          a * c.slope / s.norm() * (c.slip.transpose() * across_slip(along) * c.slip);
      near.friction[i] = stored(-a * c.slope * along);
    }
    off_ += a * wrench;
    derivative_ -= c.stiffness * wrench * c.normal.transpose();
  }
  if (size == 0) {
    free_ = Eigen::MatrixXd::Identity(d, d);
    answer_ = Eigen::MatrixXd::Zero(0, d);
    return;
  }
  answer_ = pseudo_inverse(sticking, {}, &free_);
}

Reals ModalEquations::motion_change(const Reals& off, const Eigen::VectorXd& slips) const {
  Reals change = -answer_.transpose() * slips;
  if (free_.cols() == 0) return change;
  const Eigen::MatrixXd reduced = free_.transpose() * derivative_ * free_;
  const Eigen::VectorXd left = free_.transpose() * (off + derivative_ * change);
  change -= free_ * least_squares(reduced, left);
  return change;
}

Eigen::VectorXd ModalEquations::friction_change(const Reals& off,
                                                const Reals& motion_change) const {
  return -answer_ * (off + derivative_ * motion_change);
}

std::optional<NearEquilibrium> Newton::polish(NearEquilibrium near) const {
  double last = HUGE_VAL;
  constexpr int kMostSteps = 40;
  for (int step = 0; step < kMostSteps; ++step) {
    const ModalEquations equations(grasp_, near);
    const double error =
        equations.off().norm() / grasp_.force + equations.slips().norm() / grasp_.reach;
    constexpr double kBalanced = 1e-13;
    constexpr double kStalled = 1e-9;
    if (error <= kBalanced || (error <= kStalled && error > last / 2)) {
      share_out(near);
      for (std::size_t i = 0; i < near.sticks.size(); ++i) {
        if (near.sticks[i] == 0) continue;
        const double most = grasp_.contacts[i].slope * near.normal[i];
        const Double3& f = near.friction[i];
        if (std::sqrt(dot(f, f)) > most * (1 + 1e-9)) return std::nullopt;
      }
      return near;
    }
    last = error;
    const Reals move = equations.motion_change(equations.off(), equations.slips());
    const Eigen::VectorXd answer = equations.friction_change(equations.off(), move);
    if (!move.allFinite() || !answer.allFinite()) return std::nullopt;
    near.motion += move;
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < near.sticks.size(); ++i) {
      if (near.sticks[i] == 0) continue;
      for (Eigen::Index k = 0; k < grasp_.contacts[i].slip.rows(); ++k) {
        near.friction[i][static_cast<std::size_t>(k)] += answer[next++];
      }
    }
  }
  return std::nullopt;
}

/// Shares out friction among the contacts that stick, with the same sum. The largest share of
/// what there may be is made small, so that it holds with some to spare: by least squares,
/// again and again, in which large shares cost more and more.
void Newton::share_out(NearEquilibrium& near) const {
  const Eigen::Index d = grasp_.motions();
  struct Share {
    std::size_t contact;
    double most;
    Eigen::Index first;
    Eigen::Index size;
  };
  std::vector<Share> sticking;
  Eigen::Index size = 0;
  for (std::size_t i = 0; i < near.sticks.size(); ++i) {
    const RoundedContact& c = grasp_.contacts[i];
    const double most = c.slope * near.normal[i];
    if (near.sticks[i] == 0 || !(most > 0)) continue;
    sticking.push_back({i, most, size, c.slip.rows()});
    size += c.slip.rows();
  }
  if (sticking.empty()) return;
  Eigen::MatrixXd wrenches(d, size);  // wrenches of unit shares
  Eigen::VectorXd shares(size);
  for (const auto& [contact, most, first, count] : sticking) {
    const RoundedContact& c = grasp_.contacts[contact];
    wrenches.middleCols(first, count) = most * c.slip.transpose();
    shares.segment(first, count) = across(near.friction[contact], c) / most;
  }
  const Reals sum = wrenches * shares;
  const auto largest = [&](const Eigen::VectorXd& of) {
    double result = 0;
    for (const Share& s : sticking)
      result = std::max(result, of.segment(s.first, s.size).norm());
    return result;
  };
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(size);
  Eigen::VectorXd best = shares;
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::MatrixXd weighted = wrenches * weights.asDiagonal();
    const Eigen::VectorXd next = weights.asDiagonal() * least_squares(weighted, sum);
    // A result that rounding has put off is not kept.
    constexpr double kBalanced = 1e-12;
    if (!next.allFinite() || !((wrenches * next - sum).norm() <= kBalanced * grasp_.force))
      break;
    const double highest = largest(next);
    if (highest < largest(best)) best = next;
    for (const Share& s : sticking) {
      weights.segment(s.first, s.size) /= 0.3 + next.segment(s.first, s.size).norm() / highest;
    }
  }
  for (const Share& s : sticking) {
    near.friction[s.contact] = stored(s.most * best.segment(s.first, s.size));
  }
}

/// Moves d to where all forces balance, with friction smooth over slips of this size. Returns
/// false if that does not converge.
bool Newton::balance(Reals& d, double smooth) const {
  constexpr int kMostSteps = 30;
  constexpr double kBalanced = 1e-11;
  constexpr double kRounding = 1e-14;  // part of slips, and so of friction over this size
  Eigen::MatrixXd derivative;
  Reals f = force(d, smooth, &derivative);
  for (int step = 0; step < kMostSteps; ++step) {
    const double rounding = press_ > 0 ? kRounding * d.norm() / smooth : 0;
    if (f.norm() <= (kBalanced + rounding) * grasp_.force) return true;
    // A weak spring holds the object where nothing else does.
    Eigen::MatrixXd system = derivative;
    system.diagonal().array() -= 1e-9 * grasp_.force / grasp_.reach;
    const Reals move = -solution(system, f);
    if (!move.allFinite()) return false;
    double part = 1;
    Reals next = d + move;
    Reals there = force(next, smooth, nullptr);
    while (there.norm() > (1 - 1e-4 * part) * f.norm() && part > 1e-4) {
      part /= 2;
      next = d + part * move;
      there = force(next, smooth, nullptr);
    }
    d = next;
    f = force(d, smooth, &derivative);
  }
  return false;
}

/// Returns how d changes with the size over which friction is smooth: contacts that slip less
/// than that go on to have as much friction.
Reals Newton::change_with_smooth(const Reals& d, double smooth) const {
  Reals change = Reals::Zero(d.size());
  for (const RoundedContact& c : grasp_.contacts) {
    const Across s = c.slip * d;
    const double v = c.separation(d) + smooth * pressing(c);
    const double a = c.acts(v) ? v : 0;
    if (s.norm() < smooth) change += a * c.slope / (smooth * smooth) * (c.slip.transpose() * s);
    if (press_ > 0 && a > 0) {
      change += pressing(c) *
                (c.normal - c.slope / std::max(s.norm(), smooth) * (c.slip.transpose() * s));
    }
  }
  Eigen::MatrixXd derivative;
  force(d, smooth, &derivative);
  derivative.diagonal().array() -= 1e-9 * grasp_.force / grasp_.reach;
  return -solution(derivative, change);
}

/// Takes smaller steps where slips become as small as friction is smooth, as many contacts
/// change at once there.
std::optional<NearEquilibrium> Newton::solve(const Reals& start) const {
  constexpr double kLargest = 8;
  constexpr double kSmallest = 1.05;
  constexpr double kLeastSmooth = 1e-10;  // relative to the reach
  Reals d = start;
  double smooth = kLargest * grasp_.reach;
  bool converged = balance(d, smooth);
  double factor = kLargest;
  while (smooth > kLeastSmooth * grasp_.reach) {
    Reals next = d;
    if (converged) {
      const Reals along = (smooth / factor - smooth) * change_with_smooth(d, smooth);
      if (along.allFinite()) next += along;
    }
    const bool is_next = balance(next, smooth / factor);
    if (!next.allFinite()) return std::nullopt;
    if (is_next || !converged) {
      converged = is_next;
      d = std::move(next);
      smooth /= factor;
      factor = std::min(kLargest, factor * factor);
      continue;
    }
    factor = std::sqrt(factor);
    if (factor < kSmallest) return std::nullopt;
  }
  if (!converged) {
    // The rest is rounding where slips are very small.
    constexpr double kNearly = 1e-7;
    if (!(force(d, smooth, nullptr).norm() <= kNearly * grasp_.force)) return std::nullopt;
  }
  return at(d, smooth);
}

/// Returns the forces of a motion, with friction smooth over slips of this size; what slips
/// less sticks.
NearEquilibrium Newton::at(const Reals& d, double smooth) const {
  NearEquilibrium result{d, {}, {}, {}};
  for (const RoundedContact& c : grasp_.contacts) {
    const double a = c.force(d);
    const Across s = c.slip * d;
    result.normal.push_back(a);
    result.friction.push_back(stored(-a * c.slope / std::max(s.norm(), smooth) * s));
    result.sticks.push_back(a > 0 && c.slope > 0 && s.norm() < smooth ? 1 : 0);
  }
  return result;
}

std::optional<NearEquilibrium> Newton::solve_smoothly(const Reals& start) const {
  constexpr double kFirst = 8;
  return sharpened(SmoothNewton(grasp_).settle(start, kFirst));
}

/// Returns the equilibrium near that of smooth laws, if there is one. Friction that sticks with
/// all but a thousandth of what there may be slips thirty times as far as the laws are smooth.
std::optional<NearEquilibrium> Newton::sharpened(const std::optional<Reals>& motion) const {
  if (!motion) return std::nullopt;
  constexpr double kSticks = 30 * SmoothNewton::kLeast;
  NearEquilibrium found = at(*motion, kSticks * grasp_.reach);
  auto polished = polish(found);
  return polished ? std::move(polished) : std::move(found);
}

/// Guesses from the last motion and forces which contacts are closed and which stick, until
/// that is right; returns nothing if it never is.
std::optional<NearEquilibrium> Newton::change_modes(NearEquilibrium near) const {
  constexpr double kStill = 1e-9;  // relative to a typical motion, as all of these
  constexpr double kNear = 0.1;
  constexpr double kSlips = 1e-4;
  constexpr double kLawful = 1e-6;
  const double travel = std::max(grasp_.reach, near.motion.norm());
  std::vector<Across> shares;  // shares of the friction that there may be
  for (std::size_t i = 0; i < grasp_.contacts.size(); ++i) {
    const RoundedContact& c = grasp_.contacts[i];
    const double most = c.slope * near.normal[i];
    shares.push_back(most > 0 ? Across(across(near.friction[i], c) / most)
                              : Across(Across::Zero(c.slip.rows())));
  }
  constexpr int kSteps = 20;
  for (int step = 0; step < kSteps; ++step) {
    Reals sum = grasp_.load;                      // the sum of forces with these shares
    Reals stuck = Reals::Zero(grasp_.motions());  // friction against slips that there still are
    Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(grasp_.motions(), grasp_.motions());
    bool lawful = true;
    for (std::size_t i = 0; i < grasp_.contacts.size(); ++i) {
      const RoundedContact& c = grasp_.contacts[i];
      const double a = c.separation(near.motion);
      const Across slip = c.slip * near.motion;
      // A contact sticks if a small slip back would not make it slip.
      const Across trial = shares[i] - slip / (kNear * travel);
      near.normal[i] = c.force(near.motion);
      near.sticks[i] = a > 0 && c.slope > 0 && trial.norm() < 1 ? 1 : 0;
      if (!c.acts(a)) continue;
      const Reals back = c.slip.transpose() * slip;
      if (near.sticks[i] != 0) {
        lawful = lawful && slip.norm() < kLawful * travel;
        stuck -= a * c.slope / (kStill * travel) * back;
        derivative -= a * c.slope / (kStill * travel) * (c.slip.transpose() * c.slip);
      } else if (c.slope > 0) {
        const Across direction = trial.normalized();
        lawful = lawful && (shares[i] - direction).norm() < kLawful;
        shares[i] = direction;
        derivative -= a * c.slope / std::max(slip.norm(), kSlips * travel) *
                      (c.slip.transpose() * across_slip(direction) * c.slip);
      }
      const Reals wrench = c.normal + c.slope * (c.slip.transpose() * shares[i]);
      sum += a * wrench;
      derivative -= c.stiffness * wrench * c.normal.transpose();
    }
    if (lawful && sum.norm() < kLawful * grasp_.force) {
      for (std::size_t i = 0; i < grasp_.contacts.size(); ++i) {
        near.friction[i] = stored(grasp_.contacts[i].slope * near.normal[i] * shares[i]);
      }
      return near;
    }
    // This keeps the derivative from being singular.
    derivative.diagonal().array() -= 1e-12 * derivative.diagonal().cwiseAbs().sum() + 1e-300;
    const Reals change = -solution(derivative, sum + stuck);
    if (!change.allFinite()) return std::nullopt;
    near.motion += change;
    for (std::size_t i = 0; i < grasp_.contacts.size(); ++i) {
      if (near.sticks[i] == 0) continue;
      shares[i] -= grasp_.contacts[i].slip * near.motion / (kStill * travel);
    }
  }
  return std::nullopt;
}

std::optional<NearEquilibrium> Newton::follow(const NearEquilibrium& near) const {
  auto found = change_modes(near);
  return found ? polish(std::move(*found)) : std::nullopt;
}

/// Works by augmented Lagrangians: beside the friction that they have, sticking contacts have
/// springs, whose forces then become friction. Contacts that break a law change the mode.
NearEquilibrium Newton::settle(NearEquilibrium near) const {
  struct Sticking {
    Reals row;     ///< mu T
    double spare;  ///< friction that is not used
    std::size_t contact;
  };
  const std::size_t m = grasp_.contacts.size();
  std::vector<double> shares(m);  // shares of the friction that there may be
  for (std::size_t i = 0; i < m; ++i) {
    const double most = grasp_.contacts[i].slope * near.normal[i];
    if (most > 0) shares[i] = std::clamp(near.friction[i][0] / most, -1.0, 1.0);
  }
  const auto slip = [&](std::size_t i) {
    return grasp_.contacts[i].slip.row(0).dot(near.motion);
  };
  constexpr int kSteps = 40;
  for (int step = 0; step < kSteps; ++step) {
    Reals sum = grasp_.load;
    Eigen::MatrixXd answer = Eigen::MatrixXd::Zero(grasp_.motions(), grasp_.motions());
    std::vector<Sticking> sticking;
    for (std::size_t i = 0; i < m; ++i) {
      const RoundedContact& c = grasp_.contacts[i];
      const double v = c.separation(near.motion);
      if (!c.acts(v)) continue;
      const Reals friction = c.slope * c.slip.row(0).transpose();
      const Reals edge = c.normal + shares[i] * friction;
      sum += v * edge;
      answer += c.stiffness * edge * c.normal.transpose();
      // Spare is a little more than there is, so that all that stick are taken.
      if (near.sticks[i] != 0) {
        sticking.push_back({friction, v * (1.0000001 - std::fabs(shares[i])), i});
      }
    }
    const double spring = 3 * answer.norm();
    // The others stay if the contacts whose slips are independent do.
    degree_detail::IndependentRows independent(grasp_.motions());
    std::vector<Sticking> chosen;
    constexpr double kIndependent = 1e-3;
    while (const auto which = independent.take_best(sticking, kIndependent)) {
      const Reals row = sticking[*which].row.normalized();
      answer += spring * row * row.transpose();
      sum -= spring * row.dot(near.motion) * row;
      chosen.push_back(sticking[*which]);
    }
    const Reals change = solution(answer, sum);
    if (!change.allFinite()) break;
    near.motion += change;
    for (std::size_t i = 0; i < m; ++i) {
      if (slip(i) * shares[i] >= 0 && grasp_.contacts[i].slope > 0) near.sticks[i] = 1;
    }
    for (const auto& [row, spare, i] : chosen) {
      const double v = grasp_.contacts[i].separation(near.motion);
      shares[i] -= spring * row.dot(near.motion) / (row.squaredNorm() * v);
      near.sticks[i] = std::fabs(shares[i]) <= 1 + 1e-9 ? 1 : 0;
      shares[i] = std::clamp(shares[i], -1.0, 1.0);
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    near.normal[i] = grasp_.contacts[i].force(near.motion);
    near.friction[i] = {shares[i] * grasp_.contacts[i].slope * near.normal[i], 0, 0};
    if (!(near.normal[i] > 0)) near.sticks[i] = 0;
  }
  return polish(near).value_or(near);
}

Eigen::MatrixXd Newton::answer(const Reals& motion, double smooth) const {
  Eigen::MatrixXd derivative;
  force(motion, smooth, &derivative);
  return -derivative;
}

/// Returns the state at rest in which friction holds whatever is closed: Newton's method with
/// smooth friction can miss it.
NearEquilibrium Newton::at_rest() const {
  NearEquilibrium rest{Reals::Zero(grasp_.motions()), {}, {}, {}};
  for (const RoundedContact& c : grasp_.contacts) {
    rest.normal.push_back(c.preload);
    rest.friction.push_back({});
    rest.sticks.push_back(c.preload > 0 && c.slope > 0 ? 1 : 0);
  }
  return rest;
}

namespace {

/// Fixed motions to start from: rest first, then pseudo-random ones of three sizes.
class Starts {
 public:
  explicit Starts(const RoundedGrasp& grasp) : grasp_(grasp) {}

  Reals next() {
    Reals start = Reals::Zero(grasp_.motions());
    const double size = count_ % 3 == 0 ? 0.3 : count_ % 3 == 1 ? 2 : 10;
    for (Eigen::Index j = 0; count_ > 0 && j < start.size(); ++j) {
      start[j] = size * grasp_.reach * random_.next();
    }
    ++count_;
    return start;
  }

 private:
  const RoundedGrasp& grasp_;
  std::size_t count_ = 0;
  Xorshift random_;
};

}  // namespace

std::vector<NearEquilibrium> Newton::solve_from(std::size_t starts, std::size_t enough) const {
  std::vector<NearEquilibrium> result;
  const auto add = [&](NearEquilibrium found) {
    const bool is_known = std::any_of(result.begin(), result.end(), [&](const auto& other) {
      constexpr double kSame = 1e-6;
      return (other.motion - found.motion).norm() <=
             kSame * (grasp_.reach + found.motion.norm());
    });
    if (!is_known) result.push_back(std::move(found));
  };
  const NearEquilibrium rest = at_rest();
  if (auto polished = polish(rest)) add(std::move(*polished));
  if (starts > 0 && result.size() < enough) {
    if (auto near = sharpened(SmoothNewton(grasp_).follow(rest.motion))) add(std::move(*near));
  }
  Starts motions(grasp_);
  for (std::size_t k = 0; k < starts && result.size() < enough; ++k) {
    auto found = solve(motions.next());
    if (!found) continue;
    auto polished = polish(*found);
    add(polished ? std::move(*polished) : std::move(*found));
  }
  const bool is_pressed =
      std::any_of(grasp_.contacts.begin(), grasp_.contacts.end(),
                  [](const RoundedContact& c) { return !c.is_spring && c.preload > 0; });
  if (result.empty() && !is_pressed) {
    Newton pressed(grasp_);
    pressed.press_ = 1;
    const auto found = pressed.solve(Reals::Zero(grasp_.motions()));
    if (auto polished = found ? polish(*found) : std::nullopt) {
      result.push_back(std::move(*polished));
    }
  }
  return result;
}

std::optional<NearEquilibrium> Newton::solve_thoroughly(std::size_t starts) const {
  std::vector<NearEquilibrium> found = solve_from(starts, 1);
  if (!found.empty()) return std::move(found.front());
  Starts motions(grasp_);
  for (std::size_t k = 0; k < starts; ++k) {
    if (auto smoothly = solve_smoothly(motions.next())) return smoothly;
  }
  return std::nullopt;
}

}  // namespace stickslip
