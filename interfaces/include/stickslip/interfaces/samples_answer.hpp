// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Statistics beside proofs: grasps drawn from a box, each decided and checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/json_value.hpp"
#include "stickslip/engine/decide.hpp"

namespace stickslip {

/// The verdicts of grasps that were drawn from a box (BoxSampler).
struct Samples {
  std::uint64_t seed = 1;     ///< the seed of the draw
  std::size_t stable = 0;     ///< how many are stable
  std::size_t unstable = 0;   ///< how many are not
  std::size_t undecided = 0;  ///< how many have no verdict within the limits
  /// The files of all that are unstable, with the numbers of the samples, counted from 0.
  std::vector<std::pair<std::size_t, ProvedFiles>> failures{};
  std::optional<GraspBox> stable_example{};    ///< the first one that is stable, if any
  std::optional<GraspBox> unstable_example{};  ///< the first one that is unstable, if any

  /// Returns how many were drawn.
  std::size_t count() const { return stable + unstable + undecided; }
};

/// The share of the grasps that are drawn so that is stable, with a confidence of 95 % (C. J.
/// Clopper and E. S. Pearson, "The use of confidence or fiducial limits illustrated in the case
/// of the binomial", 1934). Each of the three numbers is rounded to a millionth, to
/// the side that claims less.
struct StableShare {
  Rational low;       ///< the lower end of the two-sided interval
  Rational high;      ///< its upper end
  Rational at_least;  ///< the one-sided lower bound
};

/// Returns the share of which the samples tell. Those without a verdict count as unstable below
/// and as stable above. Requires that at least one was drawn.
StableShare stable_share(const Samples& samples);

/// Draws so many grasps from the box of a question, and decides each. Each certificate is
/// judged by the rules of stickslip-check. Calls `progress` after each. Where the time is over
/// before, `samples` has what was decided by then.
void decide_samples(const Question& question, std::size_t count, const SearchOptions& options,
                    Samples& samples, const std::function<void()>& progress = {});

/// Makes a verdict fragile that is undecided where samples of both kinds were found.
void add_samples(Verdict& verdict, const Samples& samples);

/// Returns the samples as `decide --samples --json` prints them, before finished().
Json samples_json(const Samples& samples);

}  // namespace stickslip
