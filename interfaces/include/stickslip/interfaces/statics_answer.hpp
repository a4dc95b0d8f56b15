// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Statics of a question: whether its bodies may stand, with which friction, and under which
/// loads.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "stickslip/certificate/certificate.hpp"
#include "stickslip/core/number_text.hpp"
#include "stickslip/earlier/statics.hpp"
#include "stickslip/engine/question.hpp"

namespace stickslip {

/// A question of statics.
struct StaticsQuestion {
  Question question;              ///< the grasp and its load; its preloads and law play no part
  StaticsAsked asked{};           ///< the factor of friction, and directions of loads
  bool gives_wrench = false;      ///< whether the load is not that of the file or of a case
  bool least_friction = false;    ///< whether the least factor of friction is asked for
  Rational accuracy{1, 1000000};  ///< how exact a factor of friction is, or an end of loads
};

/// The least factor of friction, or the motion or reason why there is none.
using LeastFrictionAnswer = std::variant<LeastFriction, UnopposedMotion, Undecided>;

/// The answer to a question of statics: about one load, the least friction, or many loads.
struct StaticsAnswer {
  StaticsQuestion asked;                                              ///< the question
  std::variant<LoadClass, LeastFrictionAnswer, StandingLoads> found;  ///< the evidence

  /// Returns why it is not known, if so.
  std::optional<Undecided> undecided() const;
};

/// Answers it. Throws InputError ("uncertain") if some number is uncertain, ("friction") for a
/// factor below 0 or both least friction and directions, and as standing_loads() does.
StaticsAnswer statics(StaticsQuestion question);

/// Returns the load of a force f at the origin and, for each coordinate of its place but the
/// last, the load that is added as it moves by one: the directions of loads of a body whose
/// weight may be at any place (x, y), in the plane at any x. `body` names the one of several.
/// Throws InputError
/// ("place", "body").
std::pair<RationalRow, std::vector<RationalRow>> loads_of_places(const Question& question,
                                                                 const RationalRow& force,
                                                                 const std::string& body);

/// \{ Sets the load of a question, or adds one to it, with as many numbers as it has.
void set_load(Question& question, const RationalRow& load);
void add_load(Question& question, const RationalRow& load);
/// \}

/// Returns the answer as `stickslip statics --json` prints it, before finished().
Json to_json(const StaticsAnswer& answer);

/// A certificate of an answer, and the options with which checkers judge it.
struct StaticsCertificate {
  std::string name;     ///< "statics", or of least friction "moves" and "stands"
  std::string text;     ///< the certificate
  std::string options;  ///< "--statics 1 --direction 0,1,0"
};
/// Returns the certificates of an answer; none of one that is undecided.
std::vector<StaticsCertificate> certificates_of(const StaticsAnswer& answer);

}  // namespace stickslip
