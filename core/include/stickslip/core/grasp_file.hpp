// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Reads and writes grasp files (formats "stickslip-grasp/1" to "stickslip-grasp/3",
/// docs/grasp_file.md).
///
/// Numbers are exact: a JSON number is the decimal it spells, taken from its own characters,
/// never through a double; a string may be "3/5", "-0.25" or "1e-3".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/core/box.hpp"
#include "stickslip/core/grasp.hpp"

namespace stickslip {

struct JsonNode;
/// A contact as it is written, without the members that "defaults" give.
struct WrittenContact;

/// A load with a name: a question of its own.
struct NamedLoad {
  std::string name;  ///< not empty
  WrenchBox wrench;  ///< the whole load, with the part that is common to all cases
};

/// The content of a grasp file, in the plane or in space.
struct GraspFile {
  /// The contacts and the load; in a file with cases, the load that they have in common. Places
  /// on the outline have become positions and normals, and loads at points a wrench. A grasp of
  /// one body in the plane is a box only if some number is an interval, a normal has a slope,
  /// or motions are bounded; any other grasp is always a box.
  AnyGrasp content;
  /// The contacts whose stiffness is 1 because nothing gives it; increasing.
  std::vector<ContactId> assumed_stiffness{};
  /// The cases, whose names differ. If there is none, `content` has the only load.
  std::vector<NamedLoad> cases{};

  /// Returns the one grasp in the plane. Throws ContractError if `content` is a box.
  const LoadedGrasp& loaded() const { return content.loaded(); }
  /// Returns the description of the grasp for people.
  const GraspDescription& description() const { return content.description(); }
};

/// The intervals that a reader takes. Code that does not answer for all grasps in a box must
/// refuse intervals: it would take the middle for the answer. With kRefused a bound of the
/// motions of a grasp in the plane is refused as well; with kOnlyBounds only intervals are
/// refused.
enum class Intervals { kRefused, kOnlyBounds, kAllowed };

/// Returns the index of a case, given the names of all cases of a file. Throws InputError with
/// the place "case" if there is no case of that name, or if no name is given.
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

  /// Reads a contact. This is the sink of the stream.
  void add_contact(std::size_t index, const JsonNode& node);
  /// Returns whether the contacts so far are in space, or the wrench if there are no contacts.
  bool in_space(const JsonNode& grasp) const;
  /// Returns the grasp, given the object whose contacts were streamed. Refuses a grasp in space
  /// and one of several bodies.
  GraspFile finish(const JsonNode& grasp, Intervals intervals = Intervals::kRefused);
  /// Returns a grasp of any kind.
  GraspFile finish_any(const JsonNode& grasp, Intervals intervals = Intervals::kAllowed);

 private:
  GraspFile finish_in_space(const JsonNode& grasp, Intervals intervals);
  GraspFile finish_bodies(const JsonNode& grasp, Intervals intervals);

  std::vector<WrittenContact> contacts_;
  bool in_space_ = false;
  std::string first_interval_;  ///< the path of the first interval; empty if there is none
};

/// Reads one grasp in the plane. `file` is the name used in errors. Throws InputError with
/// file, JSON path or line:column, what is wrong, and what would be right. It does so, too, for
/// intervals that are refused, for a grasp in space, and for several bodies.
GraspFile parse_grasp(std::string_view text, const std::string& file,
                      Intervals intervals = Intervals::kRefused);

/// Reads one grasp in the plane from a file; "-" is standard input. Throws InputError as
/// parse_grasp does, and when the file cannot be read.
GraspFile read_grasp_file(const std::string& path, Intervals intervals = Intervals::kRefused);

/// \{ Reads a grasp of any kind: in the plane or in space, of one body or several.
GraspFile parse_any_grasp(std::string_view text, const std::string& file,
                          Intervals intervals = Intervals::kAllowed);
GraspFile read_any_grasp_file(const std::string& path,
                              Intervals intervals = Intervals::kAllowed);
/// \}

/// Returns the grasp as a file's text, one contact a line, ending in a newline. Reading it
/// gives the same grasp, and the same grasp gives the same bytes. Loads are written as the
/// wrench that they sum to, and contacts with their positions and normals. Integers below 2^53
/// are written as JSON numbers, all others as strings "3/5", so that no JSON reader rounds
/// them. Throws InputError for what a file cannot hold: a name that is not UTF-8, or a number
/// longer than kMaxNumberLength.
std::string write_grasp(const AnyGrasp& content);
/// \copydoc write_grasp
std::string write_grasp(const LoadedGrasp& content);
/// Returns the text with the cases and intervals, and without the stiffnesses that were
/// assumed. Reading it gives `file` again.
std::string write_grasp_file(const GraspFile& file);

}  // namespace stickslip
