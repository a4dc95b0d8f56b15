// SPDX-License-Identifier: GPL-3.0-or-later
#include "preload_patterns.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "preload_boxes.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip::extent_detail {

using namespace box_detail;
namespace {

/// A side of a friction cone: what its contact adds to each equation with a normal force of 1,
/// first the wrench that it exerts.
struct ConeSide {
  std::size_t contact;
  RationalRow terms;
};

[[noreturn]] void fail_balanced(const std::string& problem, const std::string& remedy) {
  throw InputError("", "balanced", problem, remedy);
}

/// Returns the sides of all cones. Equations after the first three say that contacts of a group
/// press alike.
std::vector<ConeSide> cone_sides(const GraspBox& grasp, const ContactGroups& alike) {
  std::vector<ConeSide> sides;
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const UncertainContact& c = grasp.contacts[i];
    const auto length = exact_sqrt(dot(c.normal, c.normal));
    if (!length) {
      fail_balanced("the normal of contact " + std::to_string(i) + " has an irrational length",
                    "stickslip snap makes normals of rational length");
    }
    for (const int sign : {1, -1}) {
      const Rational mu = sign * c.friction.low;
      const Rational x = (c.normal[0] - mu * c.normal[1]) / *length;
      const Rational y = (c.normal[1] + mu * c.normal[0]) / *length;
      sides.push_back({i, {x, y, c.position[0].low * y - c.position[1].low * x}});
      if (mu.is_zero()) break;
    }
  }
  for (ConeSide& side : sides) {
    for (const std::vector<std::size_t>& group : alike) {
      for (std::size_t k = 1; k < group.size(); ++k) {
        side.terms.emplace_back(side.contact == group[k - 1] ? 1
                                : side.contact == group[k]   ? -1
                                                             : 0);
      }
    }
  }
  return sides;
}

/// Forces along the sides of cones, 0 or more.
struct SideForces {
  RationalRow forces;
  std::uint64_t support;  ///< the forces that are not 0, a bit each
};

std::uint64_t support_of(const RationalRow& forces) {
  std::uint64_t support = 0;
  for (std::size_t k = 0; k < forces.size(); ++k) {
    if (!forces[k].is_zero()) support |= std::uint64_t{1} << k;
  }
  return support;
}

/// Returns the extreme forces among forces that balance: those of which no other has a smaller
/// support.
std::vector<SideForces> extreme(std::vector<SideForces> all) {
  std::sort(all.begin(), all.end(),
            [](const SideForces& a, const SideForces& b) { return a.support < b.support; });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const SideForces& a, const SideForces& b) {
                          return a.support == b.support;
                        }),
            all.end());
  std::vector<SideForces> result;
  for (const SideForces& one : all) {
    const bool is_minimal = std::none_of(all.begin(), all.end(), [&](const SideForces& other) {
      return other.support != one.support && (other.support & ~one.support) == 0;
    });
    if (is_minimal) result.push_back(one);
  }
  return result;
}

/// Returns forces that balance. Adds one equation after the other: two forces on either side of
/// it give their sum on it.
std::vector<SideForces> balanced_forces(const std::vector<ConeSide>& sides) {
  std::vector<SideForces> found;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    RationalRow one(sides.size());
    one[k] = 1;
    found.push_back({std::move(one), std::uint64_t{1} << k});
  }
  const std::size_t equations = sides.empty() ? 0 : sides.front().terms.size();
  for (std::size_t j = 0; j < equations; ++j) {
    std::vector<SideForces> next;
    RationalRow off;
    for (const SideForces& f : found) {
      Rational sum = 0;
      for (std::size_t k = 0; k < sides.size(); ++k) sum += f.forces[k] * sides[k].terms[j];
      if (sum.is_zero()) next.push_back(f);
      off.push_back(std::move(sum));
    }
    for (std::size_t a = 0; a < found.size(); ++a) {
      for (std::size_t b = 0; b < found.size(); ++b) {
        if (off[a].sign() <= 0 || off[b].sign() >= 0) continue;
        RationalRow sum(sides.size());
        for (std::size_t k = 0; k < sides.size(); ++k) {
          sum[k] = off[a] * found[b].forces[k] - off[b] * found[a].forces[k];
        }
        const std::uint64_t support = support_of(sum);
        next.push_back({std::move(sum), support});
      }
    }
    found = extreme(std::move(next));
  }
  return found;
}

}  // namespace

PreloadPatterns::PreloadPatterns(const GraspBox& grasp, bool balanced,
                                 const ContactGroups& alike)
    : are_contacts_(!balanced && alike.empty()), contacts_(grasp.contacts.size()) {
  if (!balanced) {
    std::vector<char> is_grouped(contacts_);
    for (const std::vector<std::size_t>& group : alike) {
      patterns_.emplace_back(contacts_);
      for (const std::size_t i : group) {
        patterns_.back()[i] = Rational(1, static_cast<long long>(group.size()));
        is_grouped[i] = 1;
      }
    }
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (is_grouped[i] != 0) continue;
      patterns_.emplace_back(contacts_);
      patterns_.back()[i] = 1;
    }
    RationalRow given = preloads_of(grasp);
    const Rational sum = sum_of(given);
    if (!sum.is_zero() && !weights(given)) {
      for (Rational& preload : given) preload /= sum;
      patterns_.push_back(std::move(given));
    }
    return;
  }
  if (grasp.mechanism || grasp.in_space()) {
    fail_balanced("there are several bodies, or the grasp is in space",
                  "preloads that balance are sought of one body in the plane");
  }
  constexpr std::size_t kMostContacts = 8;
  if (contacts_ > kMostContacts) {
    fail_balanced(
        "there are " + std::to_string(contacts_) + " contacts",
        "preloads that balance are sought of at most " + std::to_string(kMostContacts));
  }
  const std::vector<ConeSide> sides = cone_sides(grasp, alike);
  for (const SideForces& f : balanced_forces(sides)) {
    RationalRow preloads(contacts_);
    Rational sum = 0;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      preloads[sides[k].contact] += f.forces[k];
      sum += f.forces[k];
    }
    for (Rational& preload : preloads) preload /= sum;
    if (std::find(patterns_.begin(), patterns_.end(), preloads) == patterns_.end()) {
      patterns_.push_back(std::move(preloads));
    }
  }
}

RationalRow PreloadPatterns::preloads(const RationalRow& weights) const {
  require(weights.size() == size(), "a weight for each pattern");
  if (are_contacts_) return weights;
  RationalRow sum(contacts_);
  for (std::size_t k = 0; k < size(); ++k) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weights[k] * patterns_[k][i];
  }
  return sum;
}

std::optional<RationalRow> PreloadPatterns::weights(const RationalRow& preloads) const {
  if (are_contacts_) return preloads;
  LinearProgram program;
  program.add_variables(size(), VariableKind::kNonNegative);
  for (std::size_t i = 0; i < contacts_; ++i) {
    RationalRow row;
    for (const RationalRow& pattern : patterns_) row.push_back(pattern[i]);
    program.add_row(std::move(row), Relation::kEqual, preloads[i]);
  }
  const LpResult found = solve(program);
  const auto* optimal = std::get_if<Optimal>(&found);
  return optimal == nullptr ? std::nullopt : std::optional(optimal->point);
}

}  // namespace stickslip::extent_detail
