// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reading and writing grasp files (formats "stickslip-grasp/1" to "stickslip-grasp/3",
/// docs/grasp_file.md).
///
/// Numbers are exact: a JSON number is the decimal it spells, taken from its own
/// characters, never through a double; a string may be "3/5", "-0.25" or "1e-3".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/grasp.hpp"

namespace stickslip {

struct JsonNode;
/// A contact in which "defaults" may have to be filled in.
struct WrittenContact;

/// A load with a name: a question of its own.
struct NamedLoad {
  std::string name;  ///< not empty
  WrenchBox wrench;  ///< all of it, with what is common to all cases
};

/// What a grasp file says, in the plane or in space.
struct GraspFile {
  /// The contacts; and the load, of cases what is common to them. Places on the outline and
  /// loads at points are positions, normals and a wrench. A box in the plane if some number of
  /// these is an interval.
  AnyGrasp content;
  /// The contacts whose stiffness is 1 because nothing gives it; increasing.
  std::vector<ContactId> assumed_stiffness{};
  std::vector<NamedLoad> cases{};  ///< with different names; none: `content` has the only load

  /// Requires one grasp in the plane.
  const LoadedGrasp& loaded() const;
  /// What is known of the grasp for people.
  const GraspDescription& description() const { return description_of(content); }
};

/// Whether a reader takes files with intervals. What does not answer for all grasps in a box
/// must not: it would take the middle for the answer. Where they are refused, so are bounds of
/// motions of grasps in the plane, unless they alone are taken.
enum class Intervals { kRefused, kOnlyBounds, kAllowed };

/// The index of a case of a file, by the names of all. Throws InputError with the place "case"
/// if it has none of that name, and if no name is given.
std::size_t case_named(const std::vector<std::string>& cases,
                       const std::optional<std::string>& name);

/// Reads a grasp that is part of a JSON text: the contacts while the text is parsed, by a
/// JsonStream of its "contacts", and then the rest. Throws InputError with JSON paths that
/// begin at the grasp.
class StreamedGrasp {
 public:
  StreamedGrasp();
  ~StreamedGrasp();
  StreamedGrasp(const StreamedGrasp&) = delete;
  StreamedGrasp& operator=(const StreamedGrasp&) = delete;

  void add_contact(std::size_t index, const JsonNode& node);  ///< the sink of the stream
  /// Whether the contacts so far are in space, or, if there are none, the wrench.
  bool in_space(const JsonNode& grasp) const;
  /// The object whose contacts were streamed. Refuses one in space.
  GraspFile finish(const JsonNode& grasp, Intervals intervals = Intervals::kRefused);
  /// The same of any.
  GraspFile finish_any(const JsonNode& grasp, Intervals intervals = Intervals::kAllowed);

 private:
  GraspFile finish_in_space(const JsonNode& grasp, Intervals intervals);
  GraspFile finish_bodies(const JsonNode& grasp, Intervals intervals);

  std::vector<WrittenContact> contacts_;
  bool in_space_ = false;
  std::string first_interval_;  ///< its place; empty if there is none
};

/// Reads one grasp in the plane. `file` is the name used in errors. Throws InputError with
/// file, JSON path or line:column, what is wrong, and what would be right; so for intervals
/// that are refused, and for a grasp in space.
GraspFile parse_grasp(std::string_view text, const std::string& file,
                      Intervals intervals = Intervals::kRefused);

/// Reads a file; "-" is standard input. Throws InputError as parse_grasp, and when the file
/// cannot be read.
GraspFile read_grasp_file(const std::string& path, Intervals intervals = Intervals::kRefused);

/// \{ The same, in the plane or in space, of one body or several.
GraspFile parse_any_grasp(std::string_view text, const std::string& file,
                          Intervals intervals = Intervals::kAllowed);
GraspFile read_any_grasp_file(const std::string& path,
                              Intervals intervals = Intervals::kAllowed);
/// \}

/// The grasp as a file's text, one contact a line, ending in a newline. Reading it gives the
/// same grasp, and the same grasp gives the same bytes. Loads are written as the wrench that
/// they sum to, and contacts with their positions and normals. Integers below 2^53 are written
/// as JSON numbers, all others as strings "3/5", so that no JSON reader rounds them. Throws
/// InputError for what a file cannot hold: a name that is not UTF-8, a number longer than
/// kMaxNumberLength.
std::string write_grasp(const AnyGrasp& content);
/// \copydoc write_grasp
std::string write_grasp(const LoadedGrasp& content);
/// The same with the cases and intervals, and without the stiffnesses that were assumed:
/// reading it gives `file` again.
std::string write_grasp_file(const GraspFile& file);

}  // namespace stickslip
