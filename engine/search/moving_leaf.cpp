// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of a leaf whose twist moves, exactly: certificate/FORMAT.md, section 4.
#include <algorithm>
#include <cmath>

#include "moving_work.hpp"
#include "stickslip/engine/motion_region.hpp"

namespace stickslip {
namespace {

using search_detail::MovingWork;
using search_detail::RoundedLeaf;

/// Returns a motion with the first entries of a point.
Row motion_of(const Row& point, std::size_t motions) {
  return {point.begin(), point.begin() + static_cast<std::ptrdiff_t>(motions)};
}

/// Returns y(x) = c d + h y.
Row twist_at(const MovingLeaf& leaf, const Row& x) {
  Row y;
  for (std::size_t j = 0; j < leaf.twist.size(); ++j) {
    y.emplace_back(leaf.rate * x[j] + x[leaf.twist.size()] * leaf.twist[j]);
  }
  return y;
}

/// Returns a slip with four numbers, of which those that it does not have are 0.
ExactSlip padded(const Row& slip) {
  ExactSlip all{};
  std::copy(slip.begin(), slip.end(), all.begin());
  return all;
}

/// Returns |psi| <= kappa.
bool is_within(const LawContact& c, const MovingLeaf::OwnSlip& own) {
  const ExactSlip psi = padded(own.slip);
  return own.rate.sign() >= 0 &&
         c.product(psi, psi) <= own.rate * own.rate * denominator(c.spin_weight);
}

/// The bounds of one leaf on the points of a region, each computed when it is first asked for.
class ExactWork {
 public:
  ExactWork(const Law& law, const MotionRegion& region, const MovingLeaf& leaf,
            const std::vector<Row>& twists)
      : law_(law),
        region_(region),
        leaf_(leaf),
        twists_(twists),
        values_(twists.size(), std::vector<std::optional<Values>>(law.contacts.size())) {
    for (const Row& y : twists_) load_work_.push_back(law.most_load_work(y));
  }

  /// Returns Lambda(y(r)).
  const Rational& load_work(std::size_t r) const { return load_work_[r]; }
  /// Returns B(r, r').
  Rational bound(std::size_t r, std::size_t other) {
    const std::size_t h = law_.motions;
    Rational twice = Rational(region_.points()[r][h]) * load_work_[other] +
                     Rational(region_.points()[other][h]) * load_work_[r];
    for (std::size_t i = 0; i < law_.contacts.size(); ++i) {
      if (region_.separation(i) == Separation::kOpen) continue;
      const Values& a = values(r, i);
      const Values& b = values(other, i);
      twice += product(a, b.most, i) + product(b, a.most, i);
    }
    return twice / 2;
  }

 private:
  struct Values {
    Rational high;  ///< the largest v
    Rational low;   ///< the least v
    Rational most;  ///< A_i
  };

  Rational product(const Values& of, const Rational& work, std::size_t i) const {
    const bool is_closed = region_.separation(i) == Separation::kClosed;
    if (!is_closed && (work.sign() <= 0 || of.high.sign() <= 0)) return 0;
    return (work.sign() > 0 ? of.high : of.low) * work;
  }

  const Values& values(std::size_t r, std::size_t i) {
    std::optional<Values>& known = values_[r][i];
    if (known) return *known;
    const LawContact& c = law_.contacts[i];
    known.emplace();
    for (std::size_t p = 0; p < c.separations.size(); ++p) {
      const Rational v =
          c.separation_factors[p] * Rational(dot(c.separations[p], region_.points()[r]));
      if (p == 0 || v > known->high) known->high = v;
      if (p == 0 || v < known->low) known->low = v;
    }
    const auto own = std::find_if(leaf_.own.begin(), leaf_.own.end(),
                                  [&](const auto& o) { return o.contact.index() == i; });
    known->most = most_work(c, own == leaf_.own.end() ? nullptr : &*own, r);
    return *known;
  }

  Rational most_work(const LawContact& c, const MovingLeaf::OwnSlip* own, std::size_t r) const {
    constexpr unsigned kBits = 64;
    const Row motion = motion_of(region_.points()[r], law_.motions);
    Row rest = twists_[r];  // y(r) - kappa d
    for (std::size_t j = 0; own != nullptr && j < rest.size(); ++j) {
      rest[j] -= own->rate * motion[j];
    }
    const ExactSlip psi = own != nullptr ? padded(own->slip) : ExactSlip{};
    std::optional<Rational> most;
    for (const CornerRow& row : c.corners) {
      const Rational normal = dot(twists_[r], row.normal);
      Rational along = 0;  // with L: L <psi, s> + (1 + delta / 2) L |S (y - kappa d)|
      if (!c.friction.high.is_zero()) {
        const auto slip_on = [&](const Row& d) {
          ExactSlip s{};
          for (std::size_t k = 0; k < row.slip.size(); ++k) s[k] = dot(row.slip[k], d);
          return s;
        };
        const Rational scale = row.slip_factor * Rational(denominator(c.spin_weight));
        const ExactSlip slid = slip_on(rest);
        const Rational square =
            c.squared_length * Rational(c.product(slid, slid)) / (scale * row.slip_factor);
        along = (1 + c.tilt / 2) * short_sqrt(square, kBits).upper;
        if (own != nullptr) {
          const Rational product = Rational(c.product(psi, slip_on(motion))) / scale;
          const ShortRoot root = short_sqrt(c.squared_length * product * product, kBits);
          along += product.sign() > 0 ? root.upper : Rational(-root.lower);
        }
      }
      Rational work = normal + (along.sign() > 0 ? c.friction.high : c.friction.low) * along;
      if (!most || work > *most) most = std::move(work);
    }
    return *most;
  }

  const Law& law_;
  const MotionRegion& region_;
  const MovingLeaf& leaf_;
  const std::vector<Row>& twists_;
  std::vector<Rational> load_work_;
  std::vector<std::vector<std::optional<Values>>> values_;
};

RoundedLeaf rounded(const Law& law, const MovingLeaf& leaf) {
  const auto as_double = [](const Integer& n) { return to_double(Rational(n)); };
  RoundedLeaf result{Reals(static_cast<Eigen::Index>(law.motions)), as_double(leaf.rate),
                     std::vector<double>(law.contacts.size()),
                     std::vector<Double3>(law.contacts.size())};
  for (std::size_t j = 0; j < law.motions; ++j) {
    result.twist[static_cast<Eigen::Index>(j)] = as_double(leaf.twist[j]) * law.unit(j);
  }
  for (const auto& [contact, rate, slip] : leaf.own) {
    const LawContact& c = law.contacts[contact.index()];
    result.rates[contact.index()] = as_double(rate);
    Double3& psi = result.slips[contact.index()];
    for (std::size_t k = 0; k < c.slip_dimension(); ++k) {
      for (std::size_t j = 0; j < slip.size(); ++j) {
        psi[k] += c.unit_directions[k][j] * as_double(slip[j]);
      }
    }
  }
  return result;
}

}  // namespace

bool MotionRegion::is_refuted(const MovingLeaf& leaf, const PullRule* pull) const {
  if (barred_) return true;
  require(!law_->is_family && !law_->hull, "a twist that moves is for verdicts alone");
  for (std::size_t k = 0; k < leaf.own.size(); ++k) {
    const std::size_t i = leaf.own[k].contact.index();
    if (k > 0 && leaf.own[k - 1].contact.index() >= i) return false;
    if (!is_within(law_->contacts[i], leaf.own[k])) return false;
  }
  std::vector<Row> twists;
  for (const Row& x : points()) twists.push_back(twist_at(leaf, x));
  if (pull != nullptr) {
    std::vector<Row> pulls;
    for (const Row& x : points()) pulls.push_back(pull->at(x));
    for (std::size_t r = 0; r < twists.size(); ++r) {
      for (std::size_t other = 0; other <= r; ++other) {
        if ((dot(twists[r], pulls[other]) + dot(twists[other], pulls[r])).sign() < 0) {
          return false;
        }
      }
    }
  }
  ExactWork exact(*law_, *this, leaf, twists);
  Eigen::MatrixXd upper;
  if (law_->is_moderate) {
    Eigen::VectorXd load_work(static_cast<Eigen::Index>(twists.size()));
    for (std::size_t r = 0; r < twists.size(); ++r) {
      // The generator is a multiple of the point.
      const Reals& x = generators_[r];
      Eigen::Index most = 0;
      x.cwiseAbs().maxCoeff(&most);
      const auto at = static_cast<std::size_t>(most);
      load_work[static_cast<Eigen::Index>(r)] =
          to_double(exact.load_work(r) / Rational(points()[r][at])) * x[most] / law_->unit(at);
    }
    MovingWork work(*law_, generators_, separations_);
    work.set(rounded(*law_, leaf));
    upper = work.upper_bounds(load_work);
  }
  std::vector<std::size_t> zeros;
  for (std::size_t r = 0; r < twists.size(); ++r) {
    for (std::size_t other = 0; other <= r; ++other) {
      constexpr double kLeast = 1e-200;  // underflows are nothing beside it
      if (upper.size() > 0 &&
          upper(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(other)) < -kLeast) {
        continue;
      }
      const Rational bound = exact.bound(r, other);
      if (bound.sign() > 0) return false;
      if (bound.is_zero() && r == other) zeros.push_back(r);
    }
  }
  return bars_all(zeros);
}

}  // namespace stickslip
