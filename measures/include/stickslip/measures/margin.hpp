// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins: the exact set of multiples l >= 0 for which a grasp is stable under the wrench
/// w + l u and the preloads P + l P^u.
///
/// In one *mode* (which contacts are closed, and the sign of slip or sticking at each of them)
/// the conditions of problem.hpp are linear in motion, forces and l together, so the multiples
/// that a mode resists are a closed interval. There are finitely many modes: the set is a
/// finite union of closed intervals with rational ends, the last of which may have no upper
/// end.
///
/// **Method.** Branch and bound with l as one more unknown (`search_family`) finds an
/// equilibrium in a range not yet settled, or proves that there is none. An equilibrium is
/// extended to all of its mode's interval by an exact ratio test, or by two exact linear
/// programs if the multiple does not fix the motion. From the ends of the interval it is
/// extended into the neighbouring modes, where a contact begins to slip, to stick, to open or
/// to close. The rest of the range is searched again. Nothing is bisected: every end is a zero
/// of a condition of some mode. If equilibria would have numbers of many thousand digits, the
/// multiples from 0 on are proved by degree first, dozens of modes at a time, and only the rest
/// is searched (margin_degree.hpp). Every search settles a range or adds a mode's interval, of
/// which there are finitely many.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "stickslip/engine/branch_and_bound.hpp"
#include "stickslip/engine/proof.hpp"

namespace stickslip {

/// The multiples from low to high, both included; all from low on if there is no high.
struct MarginInterval {
  Rational low;                  ///< >= 0
  std::optional<Rational> high;  ///< >= low
};

/// A proof that each multiple from low to high has an equilibrium, which is not stated: it lies
/// in a parallelepiped of motions whose centre moves linearly with the multiple, by the
/// topological degree of a map (FORMAT.md, section 5, "Segments by degree").
struct SegmentByDegree : DegreeProof {
  RationalRow end_twist{};  ///< the centre at the high end; `twist` is the centre at the low
                            ///< end
};

/// Two equilibria of one mode: every multiple between them is resisted, by a combination of the
/// two. Without `high`, any multiple of `end`, which balances the growing load and preloads
/// alone, may be added to the first (FORMAT.md, section 5: a ray). A segment may instead be a
/// proof by degree for all multiples from low to high.
struct MarginSegment {
  Rational low;                            ///< the multiple at its low end
  ShortWitness start;                      ///< the equilibrium at `low`
  std::optional<Rational> high;            ///< the multiple at its high end
  ShortWitness end;                        ///< the equilibrium at `high`, or the ray
  std::optional<SegmentByDegree> proof{};  ///< a proof by degree; if there is one, `start` and
                                           ///< `end` mean nothing
};

/// A margin with the evidence of certificate/FORMAT.md, section 5.
struct Margin {
  std::vector<MarginInterval> resisted;  ///< increasing, disjoint
  /// Increasing; each begins where the one before it ends, or where an interval begins.
  std::vector<MarginSegment> segments;
  std::vector<Trees> gaps;  ///< a tree for each range from 0 on that is not resisted
};

/// The work of a search for a margin; reproducible.
struct MarginWork {
  std::size_t ranges = 0;  ///< ranges searched
  std::size_t modes = 0;   ///< modes whose ends were looked for
  std::size_t proofs = 0;  ///< proofs by degree that were tried
  BranchWork cone;         ///< the work of all searches
};

/// How to prove what is resisted. kByLength takes equilibria, unless these would be very long,
/// as with many contacts whose numbers have different denominators. Then it takes proofs by
/// degree from multiple 0 until one fails, and equilibria from there.
enum class SegmentForm { kByLength, kEquilibria, kDegree };

/// Returns the margin over all l >= 0, whatever the family's range. Undecided only if the node
/// limit, of all searches together, is reached. Throws ContractError if the problem is no
/// family. Calls `progress` now and then, with the work so far.
std::variant<Margin, Undecided> find_margin(
    const Problem& family, const SearchOptions& options = {}, MarginWork* work = nullptr,
    const std::function<void(const MarginWork&)>& progress = {},
    SegmentForm form = SegmentForm::kByLength);

}  // namespace stickslip
