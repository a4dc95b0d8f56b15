// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The system of a region of motions as an exact linear program, for motions of any number of
/// coordinates: Haas-Heger et al. 2018, Eqs. 1, 2, 4 and 12-14, with detaching contacts.
///
/// A point of the region is x = sum lambda_r r over its generators, lambda >= 0, h = 1. A
/// contact that is closed has a_i = v_i(x), linear in lambda; an open one has a_i = 0. A mixed
/// one is relaxed to 0 <= a_i <= sum lambda_r max(0, v_i(r)). Friction is on an edge where slip
/// has a sign, else anywhere between the two edges N + mu T and N - mu T. With nothing mixed
/// and all slips of one sign the program is exact.
///
/// **Method.** On each generator the relaxed wrenches are a zonotope, with a corner for every
/// choice of edges. The program asks for a combination of such corners with wrench 0 and h = 1:
/// D + 1 rows, and columns made only when needed (Dantzig and Wolfe 1960). When the columns at
/// hand do not suffice, the Farkas vector's part on the balance is a virtual twist y, and the
/// corner of each generator that does the most work on y is the only one to try. If none of
/// them would help, y satisfies leaf-bound (certificate/FORMAT.md). With an objective, the
/// optimal dual takes the Farkas vector's place. Other functions that have to be positive take
/// the place of h in the last row, one after another. Every round adds a corner that was not
/// there, so the rounds end; in practice after a few tens. Each costs O(m) rational operations
/// and D for each generator and contact that changes edge.
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/core/row.hpp"
#include "stickslip/core/sign.hpp"
#include "stickslip/engine/proof.hpp"
#include "stickslip/lp/linear_program.hpp"

namespace stickslip {

/// A generator of a region's points, and the load there.
struct LoadedGenerator {
  RationalRow x;     ///< d, h and, with multiples, l
  RationalRow load;  ///< the load that acts there; D numbers
  /// The values here of functions, at least one, that are nowhere negative on the region and
  /// positive at solutions; h > 0 has to follow from the others, or be one of them.
  std::vector<Rational> positive;
};

/// A contact that is not open on all of a region.
struct RelaxedContact {
  ContactId contact;      ///< the contact
  bool is_mixed = false;  ///< it is neither closed nor open on all of the region
  /// The sign that its slip has on all of the region; any, if it is without friction.
  std::optional<Sign> slip{};
  std::vector<Rational> separations{};  ///< v_i by generator
  std::array<RationalRow, 2> edges{};   ///< the wrenches N + mu T and N - mu T
  Rational stiffness{1};                ///< k_i, by which breaches become energies

  /// Returns whether its force is known at each point: it is closed, with friction on an edge.
  bool is_settled() const { return !is_mixed && slip.has_value(); }
  /// Returns the edge, 0 or 1, on which friction opposes a slip of this sign.
  static std::size_t edge_against(Sign slip) { return slip == Sign::kPositive ? 1 : 0; }
};

/// A point of the relaxation; an equilibrium if nothing is broken.
struct RelaxedSum {
  RationalRow x;        ///< d, h and, with multiples, l, so that h = 1 or, on a ray, l = 1
  bool is_ray = false;  ///< h = 0: it may be added to a solution without end
  /// The pushes of each contact that is not settled, along its two edges.
  struct Push {
    ContactId contact;              ///< the contact
    std::array<Rational, 2> along;  ///< their sum is a_i
    bool sticks = false;  ///< the region does not say how it slips, and it does not slip here
  };
  std::vector<Push> pushes;  ///< in the order in which contacts were added
  /// The split at the contact that breaks its normal law (a_i > max(0, v_i)) or maximum
  /// dissipation with the most energy, if any does.
  std::optional<ContactSplit> broken;
  std::optional<SeparationSplit> broken_separation;  ///< the same for the normal laws alone
};

/// The linear program of a region.
class RelaxedRegion {
 public:
  /// Takes D. A region without generators has no point, and the twist 0 refutes it.
  RelaxedRegion(std::size_t motions, std::vector<LoadedGenerator> generators);

  /// Adds a contact. Contacts that are open on all of the region push nowhere.
  void add(RelaxedContact contact);

  /// Returns a point at which all functions that have to be positive are; or a twist y whose
  /// bounds() are <= 0, and 0 only where one of these functions is. The twist may be long.
  std::variant<RelaxedSum, RationalRow> solve(LpWork& work);
  /// Returns the point with the largest (sign = 1) or smallest (sign = -1) multiple l, or a ray
  /// on which it grows without end; nothing if there is no point.
  std::optional<RelaxedSum> extreme(int sign, LpWork& work);
  /// Returns the bound of FORMAT.md's rule leaf-bound for this twist on each generator: the
  /// largest work that load and contacts can do there.
  std::vector<Rational> bounds(const RationalRow& twist);
  /// Begins with the corners that do the most work on a twist, where it is positive.
  void start_from(const RationalRow& twist);

 private:
  /// A contact whose force the region leaves open.
  struct OpenContact {
    RelaxedContact contact;
    std::optional<std::size_t> edge{};  ///< that of the current corner; none: a_i = 0

    /// Returns the largest a_i at a generator.
    Rational most(std::size_t generator) const;
  };
  /// An extreme point of the relaxation on one generator.
  struct Column {
    std::size_t generator = 0;
    std::vector<std::optional<std::size_t>> edges;  ///< by open contact
    RationalRow wrench;  ///< the sum of the load and all contacts' wrenches
  };

  std::size_t height() const { return motions_; }  ///< the index of h
  void push(const OpenContact& open, std::size_t edge, int sign);
  void push_against(const RationalRow& twist);
  bool add_columns(const RationalRow& twist, const std::vector<Rational>& scale,
                   const Rational& z, int sign);
  LinearProgram program(const std::vector<Rational>& scale, int sign) const;
  std::variant<Optimal, Unbounded, RationalRow> optimize(const std::vector<Rational>& scale,
                                                         int sign, LpWork& work);
  std::vector<Rational> heights() const;
  RelaxedSum point(const std::vector<Rational>& weights) const;
  void find_breaches(const std::vector<Rational>& by_generator, RelaxedSum& sum) const;

  std::size_t motions_;
  std::vector<LoadedGenerator> generators_;
  std::vector<RationalRow> wrenches_;  ///< by generator, of the current corner
  std::vector<OpenContact> open_;
  std::vector<Column> columns_;
};

}  // namespace stickslip
