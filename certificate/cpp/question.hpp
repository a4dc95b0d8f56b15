// SPDX-License-Identifier: MIT
/// \file
/// The question (FORMAT.md §1, §6 and §14): what the grasp file says, what whoever asks
/// replaces, and the box that follows from it. The certificate plays no part here.
///
/// A *point* x = (d, h, l) is a motion d with two more coordinates, h = 1 and l = lambda. All
/// conditions are homogeneous in it; a point of a verdict has l = 0. A point of a region is
/// x = (d, h, s, t).
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "box.hpp"
#include "grasp.hpp"
#include "number.hpp"

namespace stickslip_check {

/// The kinds of numbers that the option `uncertain` may widen.
inline constexpr std::array<const char*, 6> kUncertainKinds{"friction", "stiffness", "preload",
                                                            "position", "normal",    "wrench"};

/// The sets of states (FORMAT.md §17).
inline constexpr std::array<const char*, 3> kStateSets{"slip", "full", "closed"};

/// The robustnesses (FORMAT.md §18): that of contacts, PCR, and that of a grasp, PGR.
inline constexpr std::array<const char*, 2> kRobustnesses{"contact", "grasp"};

/// The bits of an enclosure, unless a certificate says.
inline constexpr unsigned kDefaultBits = 128;

struct Tolerance {
  Rational size;
  bool percent = false;
  std::optional<Ball> ball = {};  ///< of the wrench, in place of these

  bool operator==(const Tolerance& other) const {
    return size == other.size && percent == other.percent && ball == other.ball;
  }
};
/// For messages: as the option `uncertain` spells it.
std::string show(const Tolerance& tolerance);

/// How the preloads grow: by these numbers, one for each element, or in proportion to
/// themselves.
struct PreloadDirection {
  bool scale = false;
  Vector values;  ///< unless scale

  bool operator==(const PreloadDirection& other) const {
    return scale == other.scale && values == other.values;
  }
};

/// What whoever asks may choose. Unset members leave the grasp file's own values.
struct Options {
  std::optional<Vector> wrench;
  std::optional<Rational> preload;  ///< for all contacts, >= 0; not for other elements
  bool bilateral = false;           ///< the normal law
  std::optional<Vector> direction;  ///< of wrenches
  std::optional<PreloadDirection> preload_direction;
  std::optional<std::vector<Vector>> plane;  ///< u and v, of wrenches
  std::optional<Vector> inertia;         ///< of a class: centre of mass and squared gyration
  std::optional<Rational> statics;       ///< of statics: the factor of all friction
  std::optional<std::string> states;     ///< one of kStateSets: nothing else is asked then
  /// One of kRobustnesses; with it a length, and f, of a question one for each contact.
  std::optional<std::string> robustness;
  std::optional<Rational> length;
  std::optional<Vector> max_force;
  std::optional<std::string> case_name;  ///< whose wrench is asked about, if none is given
  std::map<std::string, Tolerance> uncertain;  ///< by kind; empty if not given
  /// B. Of whoever asks also a length and an angle, or for none an empty list, in place of the
  /// file's; of a question nothing if motions are not bounded.
  std::optional<Vector> max_motion;

  /// Whether the margin along a direction is asked for, and not one verdict.
  bool margin() const { return direction || preload_direction; }
  /// Whether the class of a load under rigid contacts is asked for, and nothing else.
  bool rigid() const { return inertia && !margin() && !plane && !statics; }
  /// Whether it is no verdict, and so about one grasp: a margin, a region, a class or statics.
  bool family() const {
    return margin() || plane || inertia || statics || states || robustness;
  }
};

/// A list that nobody changes any more; copies are the same list.
template <typename List>
class Fixed {
 public:
  Fixed() : list_(std::make_shared<const List>()) {}
  explicit Fixed(List list) : list_(std::make_shared<const List>(std::move(list))) {}

  std::size_t size() const { return list_->size(); }
  decltype(auto) operator[](std::size_t i) const { return (*list_)[i]; }

 private:
  std::shared_ptr<const List> list_;
};

struct Question {
  Options asked;
  std::optional<Bodies> several;
  bool in_space = false;
  Fixed<Contacts> contacts;        ///< with what was replaced and widened
  Wrench wrench;                   ///< w, before it was widened
  Load load;                       ///< w
  Vector growth;                   ///< u; 0 for one verdict
  Fixed<Vector> preload_growth;    ///< P^u; empty if none is asked for
  std::size_t limits = 0;          ///< n (FORMAT.md §16)
  bool is_box = false;             ///< FORMAT.md §6; of claims §5
  bool encloses_lengths = false;   ///< of normals, where they are irrational
  std::shared_ptr<const Box> box;  ///< what trees are about; of a box, by enlarge()

  std::size_t dimension() const { return wrench.size(); }
  /// Whether it is a verdict of more coordinates than boxes and trees have (FORMAT.md §14).
  bool large() const { return !asked.statics && dimension() > kMostCoordinates; }
  /// Whether a margin would be a list of claims (FORMAT.md §5), not all that is resisted.
  bool claims() const { return in_space || several || asked.max_motion || encloses_lengths; }
};

/// Throws Malformed, with "the question" or with `file`, if it cannot be asked of this grasp.
Question pose(Grasp grasp, const Options& options, const std::string& file);

/// A contact of the enlarged box (FORMAT.md §6), whose preload grows with a margin's multiple.
ContactBox enlarged(const Contact& contact, const Rational& growth = 0,
                    unsigned bits = kDefaultBits);

/// Sets `question.box` to the enlarged box, with so many bits for lengths that are irrational.
void enlarge(Question& question, unsigned bits = kDefaultBits);

}  // namespace stickslip_check
