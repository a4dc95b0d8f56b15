// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "engine/box/single_grasp.hpp"
#include "preload_boxes.hpp"

namespace stickslip::extent_detail {

using namespace box_detail;
namespace {

/// Returns the multiples that are in both.
std::vector<MarginInterval> common(const std::vector<MarginInterval>& some,
                                   const std::vector<MarginInterval>& others) {
  std::vector<MarginInterval> both;
  for (const MarginInterval& a : some) {
    for (const MarginInterval& b : others) {
      MarginInterval part{std::max(a.low, b.low), a.high};
      if (b.high && (!part.high || *b.high < *part.high)) part.high = b.high;
      if (!part.high || part.low <= *part.high) both.push_back(std::move(part));
    }
  }
  return both;
}

/// Returns the margin of multiples of the preloads. The family begins with no preloads, so that
/// forces of springs stay as they are. Nothing if the search ended at its limit.
std::optional<PreloadMargin> margin_of(const GraspBox& load, NormalLaw law,
                                       const SearchOptions& options) {
  PreloadDirection growth;
  growth.preloads = preloads_of(load);
  growth.preloads.resize(load.elements());
  QuestionOptions asked;
  asked.law = law;
  asked.preload_direction = std::move(growth);
  Question question = ask({with_preloads(load, RationalRow(load.contacts.size()))}, asked);
  if (question.has_claims()) {
    SpatialMarginOptions search;
    search.search = options;
    SpatialMargin margin = find_spatial_margin(question, search);
    return PreloadMargin{std::move(question), std::move(margin)};
  }
  SearchOptions search;
  search.node_limit = options.node_limit;
  auto found = find_margin(problem_of(question), search);
  if (std::holds_alternative<Undecided>(found)) return std::nullopt;
  return PreloadMargin{std::move(question), std::get<Margin>(std::move(found))};
}

std::vector<MarginInterval> resisted(const PreloadMargin& of) {
  if (const auto* exact = std::get_if<Margin>(&of.margin)) return exact->resisted;
  return std::get<SpatialMargin>(of.margin).resisted();
}

/// Proves every choice of preloads up to a multiple of them, as far as one proof for each load
/// leads.
PreloadRange boxes_above(const std::vector<GraspBox>& held, NormalLaw law,
                         const SearchOptions& options) {
  PreloadRange range;
  for (const Rational& most : {Rational(4), Rational(2), Rational(3, 2), Rational(5, 4),
                               Rational(9, 8), Rational(17, 16)}) {
    for (const GraspBox& load : held) {
      ProvedPreloads wide{load};
      for (UncertainContact& c : wide.box.contacts) c.preload.high *= most;
      wide.proof = prove_box(wide.box, law, options, 0);
      if (stickslip::is_stable(wide.proof->verdict) != true) break;
      range.boxes.push_back(std::move(wide));
    }
    if (range.boxes.size() == held.size()) {
      range.multiples.push_back({1, most});
      return range;
    }
    range.boxes.clear();
  }
  return range;
}

}  // namespace

PreloadRange range_of(const std::vector<GraspBox>& held, NormalLaw law,
                      const SearchOptions& options) {
  const bool has_margins = std::none_of(held.begin(), held.end(), [](const GraspBox& load) {
    return load.ball || needs_enclosure(load);
  });
  if (!has_margins) return boxes_above(held, law, options);
  PreloadRange range;
  range.multiples.push_back({0, std::nullopt});
  if (sum_of(preloads_of(held.front())).is_zero()) return range;
  for (const GraspBox& load : held) {
    std::optional<PreloadMargin> margin = margin_of(load, law, options);
    if (!margin) return {};
    range.multiples = common(range.multiples, resisted(*margin));
    range.margins.push_back(std::move(*margin));
  }
  return range;
}

}  // namespace stickslip::extent_detail
