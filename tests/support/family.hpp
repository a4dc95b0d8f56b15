// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Margins as questions, and the members of their families as grasps of their own.
#pragma once

#include "stickslip/equilibrium/question.hpp"

namespace stickslip::test {

/// The margin from this load and these preloads, which are none if the direction is to scale.
inline Question margin_question(const LoadedGrasp& loaded, NormalLaw law,
                                const std::optional<Wrench>& direction,
                                const std::optional<PreloadDirection>& growth = std::nullopt) {
  return ask(GraspFile{loaded, {}}, {loaded.wrench, std::nullopt, law, direction, growth});
}

/// With w + l u and P + l P^u, as the certificate format states them.
inline LoadedGrasp member(const Question& margin, const Rational& multiple) {
  std::vector<Contact> contacts = margin.loaded.grasp.contacts();
  for (std::size_t i = 0; i < margin.preload_growth.size(); ++i) {
    contacts[i].preload += multiple * margin.preload_growth[i];
  }
  return {Grasp(std::move(contacts)),
          margin.loaded.wrench + multiple * margin.direction.value_or(Wrench{})};
}

}  // namespace stickslip::test
