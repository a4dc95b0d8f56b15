// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "double_model.hpp"

namespace stickslip {
namespace {

/// The number of coefficients of one contact's functions: separation 5, slip 3, friction 3.
constexpr std::size_t kCoefficients = 11;
using Coefficients = std::array<double, kCoefficients>;
/// The number of features that tell contacts apart.
constexpr std::size_t kFeatures = 6;
using Features = std::array<double, kFeatures>;

class GroupMaker {
 public:
  GroupMaker(const Problem& problem, const std::vector<ContactDoubles>& contacts, double length,
             std::size_t smallest, std::vector<std::uint32_t>& order,
             std::vector<ContactGroup>& groups)
      : problem_(problem),
        contacts_(contacts),
        smallest_(smallest),
        order_(order),
        groups_(groups) {
    coefficients_.reserve(contacts.size());
    features_.reserve(contacts.size());
    double largest_preload = std::numeric_limits<double>::min();
    for (const ContactDoubles& c : contacts) {
      const double size = std::hypot(c.normal[0], c.normal[1]);
      const double scale = size > 0 ? 1 / size : 1;
      Coefficients& all = coefficients_.emplace_back();
      for (std::size_t j = 0; j < 3; ++j) {
        all[j] = -c.normal[j] * scale;
        all[5 + j] = c.slip[j] * scale;
        all[8 + j] = c.friction[j] * scale;
      }
      for (std::size_t j = 3; j < 5; ++j) all[j] = c.separation[j] / c.stiffness * scale;
      largest_preload = std::max(largest_preload, all[3]);
      features_.push_back({all[0], all[1], all[2] / length, all[7] / length, all[3],
                           std::hypot(all[8], all[9])});
    }
    // Preloads tell nothing if all are one, and else about as much as directions do.
    for (Features& features : features_) {
      features[4] /= largest_preload;
      for (double& feature : features) feature = std::isfinite(feature) ? feature : 0;
    }
  }

  /// Adds the group of order[begin, end), and its parts.
  void add(std::uint32_t begin, std::uint32_t end) { add_with_parts(begin, end); }

 private:
  struct Bounds {
    Coefficients low;
    Coefficients high;

    void include(const Bounds& other) {
      for (std::size_t j = 0; j < kCoefficients; ++j) {
        low[j] = std::min(low[j], other.low[j]);
        high[j] = std::max(high[j], other.high[j]);
      }
    }
  };

  Bounds add_with_parts(std::uint32_t begin, std::uint32_t end) {
    const std::size_t index = groups_.size();
    groups_.emplace_back();
    ContactGroup group;
    group.begin = begin;
    group.end = end;
    const Coefficients& first = coefficients_[order_[begin]];
    Bounds bounds{first, first};
    if (end - begin >= 2 * smallest_) {
      const std::uint32_t middle = begin + (end - begin) / 2;
      part(begin, middle, end);
      bounds = add_with_parts(begin, middle);
      group.second = static_cast<std::uint32_t>(groups_.size());
      bounds.include(add_with_parts(middle, end));
      add_parts(group, groups_[index + 1], groups_[group.second]);
    } else {
      for (std::uint32_t k = begin; k < end; ++k) {
        add_contact(group, order_[k]);
        bounds.include({coefficients_[order_[k]], coefficients_[order_[k]]});
      }
    }
    group.separation = box<5>(bounds, 0);
    group.slip = box<3>(bounds, 5);
    group.friction = box<3>(bounds, 8);
    groups_[index] = group;
    return bounds;
  }

  /// Puts contacts that differ the most, in some feature, on different sides of the middle.
  void part(std::uint32_t begin, std::uint32_t middle, std::uint32_t end) {
    constexpr std::uint32_t kSample = 64;
    const std::uint32_t step = std::max(1U, (end - begin) / kSample);
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t j = 0; j < kFeatures; ++j) {
      double low = HUGE_VAL;
      double high = -HUGE_VAL;
      for (std::uint32_t k = begin; k < end; k += step) {
        low = std::min(low, features_[order_[k]][j]);
        high = std::max(high, features_[order_[k]][j]);
      }
      if (high - low > most) {
        most = high - low;
        widest = j;
      }
    }
    const auto at = [&](std::uint32_t k) {
      return order_.begin() + static_cast<std::ptrdiff_t>(k);
    };
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(features_[a][widest], a) < std::pair(features_[b][widest], b);
    });
  }

  void add_contact(ContactGroup& group, std::uint32_t contact) {
    const ContactDoubles& c = contacts_[contact];
    for (std::size_t k = 0; k < 5; ++k) {
      group.law[k] += c.separation[k];
      for (std::size_t j = 0; j < 3; ++j) {
        group.normal_work[j][k] += c.normal[j] * c.separation[k];
        group.friction_work[j][k] += c.friction[j] * c.separation[k];
        group.magnitude[j][k] +=
            (std::fabs(c.normal[j]) + std::fabs(c.friction[j])) * std::fabs(c.separation[k]);
      }
    }
    group.stiffness += c.stiffness;
    group.stiffest = std::max(
        group.stiffest, c.stiffness * (c.normal[0] * c.normal[0] + c.normal[1] * c.normal[1]));
    group.is_frictionless = group.is_frictionless && c.frictionless;
    group.has_one_slip_plane =
        group.has_one_slip_plane && share_slip_plane(contact, order_[group.begin]);
  }

  void add_parts(ContactGroup& group, const ContactGroup& a, const ContactGroup& b) const {
    for (std::size_t k = 0; k < 5; ++k) {
      group.law[k] = a.law[k] + b.law[k];
      for (std::size_t j = 0; j < 3; ++j) {
        group.normal_work[j][k] = a.normal_work[j][k] + b.normal_work[j][k];
        group.friction_work[j][k] = a.friction_work[j][k] + b.friction_work[j][k];
        group.magnitude[j][k] = a.magnitude[j][k] + b.magnitude[j][k];
      }
    }
    group.stiffness = a.stiffness + b.stiffness;
    group.stiffest = std::max(a.stiffest, b.stiffest);
    group.is_frictionless = a.is_frictionless && b.is_frictionless;
    group.has_one_slip_plane = a.has_one_slip_plane && b.has_one_slip_plane &&
                               share_slip_plane(order_[a.begin], order_[b.begin]);
  }

  bool share_slip_plane(std::uint32_t a, std::uint32_t b) const {
    return problem_.slip_plane(ContactId(a)) == problem_.slip_plane(ContactId(b));
  }

  template <std::size_t n>
  static CoefficientBox<n> box(const Bounds& bounds, std::size_t first) {
    CoefficientBox<n> result;
    double magnitude = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double low = bounds.low[first + j];
      const double high = bounds.high[first + j];
      // Differences are rounded down by less than this.
      constexpr double kUp = 1 + 4 * std::numeric_limits<double>::epsilon();
      const double center = low / 2 + high / 2;
      result.center[j] = center;
      if (low < high) result.radius[j] = kUp * std::max(high - center, center - low);
      magnitude += std::fabs(center) + result.radius[j];
    }
    // The relative errors are 4u for coefficients, 2u for the ray, u for products, 11u for
    // sums, and this bound's own: below 27u, with u = 2^-53. An underflow, 2^-1073 in an entry
    // of the ray, is at most 2^-471 in a product, as coefficients are at most 2^602.
    constexpr double kRelativeError = 3e-15;
    constexpr double kUnderflow = 1e-140;
    result.error = kRelativeError * magnitude + kUnderflow;
    return result;
  }

  const Problem& problem_;
  const std::vector<ContactDoubles>& contacts_;
  std::size_t smallest_;
  std::vector<std::uint32_t>& order_;
  std::vector<ContactGroup>& groups_;
  std::vector<Coefficients> coefficients_;
  std::vector<Features> features_;
};

}  // namespace

ShortVector5::ShortVector5(const IntegerVector5& x) {
  constexpr std::size_t kBits = 61;  // five products stay below 2^125
  for (std::size_t j = 0; j < 5 && is_short; ++j) {
    const auto* entry = x[j].gmp();
    is_short = mpz_sizeinbase(entry, 2) <= kBits;
    entries[j] = mpz_get_si(entry);
  }
}

ContactGroups::ContactGroups(const Problem& problem,
                             const std::vector<ContactDoubles>& contacts, double length,
                             std::size_t smallest)
    : are_single_(smallest == 1), order_(contacts.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (contacts.empty()) return;
  GroupMaker(problem, contacts, length, smallest, order_, groups_)
      .add(0, static_cast<std::uint32_t>(order_.size()));
  rows_.reserve(order_.size());
  planes_.reserve(order_.size());
  for (const std::uint32_t i : order_) {
    planes_.push_back({ShortVector5(problem.slip_plane(ContactId(i))),
                       ShortVector5(problem.separation_plane(ContactId(i)))});
    const ContactDoubles& c = contacts[i];
    rows_.push_back({c.separation,
                     c.separation_error,
                     {c.slip[0], c.slip[1], c.slip[2]},
                     c.slip_error,
                     c.normal,
                     c.friction,
                     c.frictionless});
  }
}

}  // namespace stickslip
