// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The slip states and contact modes of `states` in space and of several bodies: questions as
/// they are spelled, and answers as JSON.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/arrangement/contact_states.hpp"
#include "stickslip/arrangement/state_graph.hpp"
#include "stickslip/core/box.hpp"
#include "stickslip/core/json_value.hpp"

namespace stickslip {

/// The sets of states by their names.
inline constexpr std::array<std::pair<const char*, StateSet>, 5> kStateSets{
    {{"slip", StateSet::kSlip},
     {"full", StateSet::kFull},
     {"closed", StateSet::kClosed},
     {"cs", StateSet::kOpening},
     {"ss", StateSet::kContact}}};

/// Returns the name of a set of states.
const char* name_of(StateSet set);
/// Returns the set of states of this name, which has to be one.
StateSet state_set_named(const std::string& name);

/// A question about states, and the arrangement that answers it.
struct StatesQuestion {
  GraspBox grasp;                 ///< one grasp, without intervals
  SlipLines lines{};              ///< the choice of lines
  std::vector<ContactRows> rows;  ///< of its contacts
  StatePlanes planes;             ///< with the set of states
  FaceOptions faces{};            ///< the choice among them

  /// Keeps the modes in which at least so many contacts are closed. Throws InputError with the
  /// place "at_least_closed" if there are fewer contacts, or if the set is neither "cs" nor
  /// "ss".
  void require_closed(std::size_t contacts);
  /// Keeps the states of this dimension. Throws InputError with the place "dimension" if it is
  /// above that of motions.
  void require_dimension(std::size_t dimension);
};

/// Returns the question. Throws InputError as contact_rows_for_states() and state_planes() do.
StatesQuestion states_question(GraspBox grasp, SlipLines lines, StateSet set);

/// The states that are counted of each of many grasps.
struct StatesAsked {
  StateSet set = StateSet::kSlip;  ///< the set of states
  SlipLines lines{};               ///< the choice of lines, for every grasp
  std::size_t limit = 0;           ///< the largest number of states to count; 0 is no limit
};

/// Returns the counts of states, or of the first `limit` in the order of visit_faces(). 0 is no
/// limit.
FaceCounts count_states(const StatesQuestion& question, std::size_t limit);

/// Reads directions of lines: a JSON array with a list for each contact, of vectors across its
/// normal. Throws InputError naming the file.
std::vector<std::vector<RationalRow>> read_directions(const std::string& file);

/// Returns what a JSON answer says before its states: the set, coordinates, and the rows of all
/// planes in their order.
Json states_head_json(const StatesQuestion& question);
/// Appends a state as one line of JSON: its text and dimension, a motion, and the numbers of
/// the rows that are 0, positive and negative on it.
void append_state_json(std::string& text, const StatesQuestion& question, const Face& face);
/// Appends a state as people read it: its text, its dimension, and a motion as "(1, 0, -2)".
void append_state_line(std::string& text, const StatesQuestion& question, const Face& face);
/// Returns what a JSON answer says after its states: counts.
Json states_counts_json(const StatesQuestion& question, const FaceCounts& counts);
/// Returns a certificate (FORMAT.md, section 17) up to its states. Throws InputError with the
/// place "certificate" if the question is about modes, or about some of the states only.
std::string states_certificate_head(const StatesQuestion& question);
/// Appends what a certificate says of a state, after `separator`; nothing of one whose first
/// sign that is not 0 is -, as its opposite is stated.
void append_proved_state(std::string& text, const char* separator,
                         const StatesQuestion& question, const Face& face);
/// Returns what a certificate says after its states.
std::string states_certificate_end(const FaceCounts& counts);

/// Returns the graph of states: its cells and, of each facet, the numbers of its two.
Json state_graph_json(const StatesQuestion& question, const StateGraph& graph);
/// Returns it in the language of Graphviz.
std::string state_graph_dot(const StatesQuestion& question, const StateGraph& graph);

/// Returns a sentence if some plane nearly contains a line of the others, so nearly that chance
/// would not have it: a different rounding of the grasp's numbers has other states.
std::optional<std::string> near_miss_warning(const StatesQuestion& question,
                                             const FaceCounts& counts);

}  // namespace stickslip
