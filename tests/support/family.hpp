// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins as questions, and the members of their families as grasps of their own.
#pragma once

#include <vector>

#include "stickslip/engine/question.hpp"
#include "stickslip/measures/margin.hpp"

namespace stickslip::test {

/// The margin from this load and these preloads, which are none if the direction is to scale.
inline Question margin_question(const LoadedGrasp& loaded, NormalLaw law,
                                const std::optional<Wrench>& direction,
                                const std::optional<PreloadDirection>& growth = std::nullopt) {
  return ask(GraspFile{loaded},
             {row_of(loaded.wrench), std::nullopt, law,
              direction ? std::optional(row_of(*direction)) : std::nullopt, growth});
}

/// With w + l u and P + l P^u, as the certificate format states them.
inline LoadedGrasp member(const Question& margin, const Rational& multiple) {
  std::vector<Contact> contacts = margin.loaded().grasp.contacts();
  for (std::size_t i = 0; i < margin.preload_growth.size(); ++i) {
    contacts[i].preload += multiple * margin.preload_growth[i];
  }
  const Wrench direction = margin.direction ? wrench_of(*margin.direction) : Wrench{};
  return {Grasp(std::move(contacts)), margin.loaded().wrench + multiple * direction};
}

/// What is left of l >= 0.
inline std::vector<MultipleRange> gaps_of(const Margin& margin) {
  std::vector<MultipleRange> gaps;
  MultipleRange rest;
  for (const MarginInterval& interval : margin.resisted) {
    rest.high = interval.low;
    if (rest.low < interval.low) gaps.push_back(rest);
    if (!interval.high) return gaps;
    rest = {*interval.high, std::nullopt, false};
  }
  gaps.push_back(rest);
  return gaps;
}

}  // namespace stickslip::test
