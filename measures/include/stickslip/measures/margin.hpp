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
/// extended to all of its mode's interval by an exact ratio test, or two exact linear programs
/// where the multiple does not fix the motion, and from the ends of that into the modes next to
/// it, where a contact begins to slip, to stick, to open or to close; what is left of the range
/// is searched again. Nothing is bisected: every end is where a condition of some mode has its
/// zero. Where equilibria would have numbers of many thousand digits, what is resisted from 0
/// on is proved by degree first, dozens of modes at a time, and only what that does not reach
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

/// A parallelepiped of motions that moves with the multiple and holds an equilibrium of each
/// (FORMAT.md, section 5, "Segments by degree").
struct SegmentByDegree : DegreeProof {
  RationalRow end_twist{};  ///< where its centre is at the high end; `twist`: at the low end
};

/// Two equilibria of one mode: between them every multiple is resisted, by a combination of the
/// two. Without `high`, `end` is what may be added to the first without end, for the
/// family's sake alone (FORMAT.md, section 5: a ray). Or a proof by degree for all from low to
/// high.
struct MarginSegment {
  Rational low;                            ///< the multiple at its low end
  ShortWitness start;                      ///< for that multiple
  std::optional<Rational> high;            ///< the multiple at its high end
  ShortWitness end;                        ///< for that multiple, or a ray
  std::optional<SegmentByDegree> proof{};  ///< and then `start` and `end` mean nothing
};

/// With the evidence of certificate/FORMAT.md, section 5.
struct Margin {
  std::vector<MarginInterval> resisted;  ///< increasing, disjoint
  /// Increasing; each begins where one ends or an interval begins.
  std::vector<MarginSegment> segments;
  std::vector<Trees> gaps;  ///< one tree for each gap between the intervals, increasing
};

/// What the search for a margin did; reproducible.
struct MarginWork {
  std::size_t ranges = 0;  ///< searched
  std::size_t modes = 0;   ///< whose ends were looked for
  std::size_t proofs = 0;  ///< by degree, that were tried
  ConeWork cone;           ///< of all searches
};

/// How what is resisted is proved: kByLength by equilibria or, where these would be very long
/// (numbers that have nothing in common, of many contacts), by degree as far as that leads.
enum class SegmentForm { kByLength, kEquilibria, kDegree };

/// Of all l >= 0, whatever the family's range. Throws ContractError if the problem is no
/// family. Undecided only when the node limit, of all searches together, is reached. `progress`
/// is called now and then, with the work so far.
std::variant<Margin, Undecided> find_margin(
    const Problem& family, const ConeOptions& options = {}, MarginWork* work = nullptr,
    const std::function<void(const MarginWork&)>& progress = {},
    SegmentForm form = SegmentForm::kByLength);

}  // namespace stickslip
