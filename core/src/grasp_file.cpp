// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/grasp_file.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "angle.hpp"
#include "grasp_format.hpp"
#include "intervals.hpp"
#include "loads.hpp"
#include "mechanism_file.hpp"
#include "outline_file.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/grasp_file.hpp"
#include "stickslip/core/json.hpp"
#include "stickslip/core/motion_bound.hpp"
#include "uncertain_contact.hpp"

namespace stickslip {

using namespace core_detail;

/// A number as it is written. An interval is rare, and so kept apart.
struct WrittenNumber {
  Rational middle{};
  std::shared_ptr<const Interval> interval{};  ///< the interval; null if it is one number

  Interval ends() const { return interval ? *interval : point_interval(middle); }
};

struct WrittenContact {
  /// The properties that "defaults" may give.
  struct Properties {
    std::optional<WrittenNumber> friction;
    /// The name of a friction of the file; null if a number is written, or nothing.
    std::shared_ptr<const std::string> friction_name{};
    std::optional<WrittenNumber> stiffness;
    std::optional<WrittenNumber> preload;
    std::shared_ptr<const Rational> torsion{};    ///< in version 3
    std::shared_ptr<const Rational> max_force{};  ///< likewise
  };

  /// The place on the outline, if that is written and not position and normal.
  std::optional<PlaceOnOutline> place;
  WrittenNumber x;
  WrittenNumber y;
  WrittenNumber z;  ///< in space only
  Vector2 normal;
  Rational normal_z{};            ///< in space only
  std::optional<Rational> slope;  ///< the slope of the normal, unless it is 0
  /// The angle of the normal in degrees; null unless it is given by one.
  std::shared_ptr<const Rational> angle{};
  Properties own;
  /// The names in "of" and "by", each of which may be empty; null if neither is written.
  std::shared_ptr<const std::pair<std::string, std::string>> bodies;
};

namespace {

using Properties = WrittenContact::Properties;
using Kind = JsonNode::Kind;

using Names = std::vector<std::string>;
/// The frictions of a file, by name.
using FrictionNames = std::map<std::string, WrittenNumber>;

WrittenNumber read_written(const JsonNode& node, const std::string& path,
                           IntervalReader& read) {
  if (node.kind != Kind::kObject) return {read_number(node, path)};
  Interval interval = read.number(node, path);
  if (interval.is_point()) return {std::move(interval.low)};
  return {interval.middle(), std::make_shared<const Interval>(interval)};
}

constexpr const char* kTwoNumbers = "an array of two numbers [x, y]";
constexpr const char* kThreeNumbers = "an array of three numbers [x, y, z]";

void read_position(const JsonNode& node, const std::string& path, IntervalReader& read,
                   WrittenContact& contact) {
  const JsonNode& position = member(node, path, "position", "add \"position\": [x, y]");
  const std::string place = member_path(path, "position");
  expect_array(position, place, 2, kTwoNumbers);
  contact.x = read_written(position.children[0], element_path(place, 0), read);
  contact.y = read_written(position.children[1], element_path(place, 1), read);
}

/// Reads [x, y], {"direction": [x, y], "slope": E}, or {"angle": A} with a slope or without; in
/// space [x, y, z], and no angle.
void read_normal(const JsonNode& node, const std::string& path, IntervalReader& read,
                 bool in_space, WrittenContact& contact) {
  const JsonNode& normal =
      member(node, path, "normal",
             in_space ? "add \"normal\": [x, y, z], pointing into the object"
                      : "add \"normal\": [x, y], pointing into the object");
  const std::string place = member_path(path, "normal");
  const auto read_direction = [&](const JsonNode& at, const std::string& where) {
    std::vector<Rational> n =
        read_vector(at, where, in_space ? 3 : 2, in_space ? kThreeNumbers : kTwoNumbers);
    contact.normal = {std::move(n[0]), std::move(n[1])};
    if (in_space) contact.normal_z = std::move(n[2]);
  };
  if (normal.kind != Kind::kObject) {
    read_direction(normal, place);
    return;
  }
  const JsonNode* angle = normal.find("angle");
  if (angle == nullptr || normal.find("slope") != nullptr) read.note(place);
  if (angle != nullptr) {
    const std::string at = member_path(place, "angle");
    if (in_space) fail_at(at, "an angle, but the grasp is in space", "give [x, y, z]");
    expect_object(normal, place, {"angle", "slope"});
    contact.angle = std::make_shared<const Rational>(read_number(*angle, at));
    contact.normal = direction_at(*contact.angle).vector;
    if (normal.find("slope") == nullptr) return;
  } else {
    expect_object(
        normal, place,
        in_space ? Names{"direction", "slope"} : Names{"direction", "slope", "angle"});
  }
  const char* const form = in_space ? R"(write {"direction": [x, y, z], "slope": E})"
                                    : R"(write {"direction": [x, y], "slope": E})";
  if (angle == nullptr) {
    read_direction(member(normal, place, "direction", form), member_path(place, "direction"));
  }
  contact.slope =
      read_number(member(normal, place, "slope", form), member_path(place, "slope"));
  if (contact.slope->is_zero()) contact.slope.reset();
}

/// Reads position and normal in space. (All contacts are in space, or none: the first one says
/// which.)
void read_place_in_space(const JsonNode& node, const std::string& path, IntervalReader& read,
                         WrittenContact& contact) {
  const JsonNode& position = member(node, path, "position", "add \"position\": [x, y, z]");
  const std::string place = member_path(path, "position");
  expect_array(position, place, 3, kThreeNumbers);
  contact.x = read_written(position.children[0], element_path(place, 0), read);
  contact.y = read_written(position.children[1], element_path(place, 1), read);
  contact.z = read_written(position.children[2], element_path(place, 2), read);
  read_normal(node, path, read, true, contact);
}

/// Returns whether the text begins as numbers do, and names of frictions do not.
bool begins_as_number(const std::string& text) {
  return text.empty() || std::string_view("+-.0123456789").find(text[0]) != std::string::npos;
}

Properties read_properties(const JsonNode& object, const std::string& path,
                           IntervalReader& read) {
  const auto number = [&](const char* key) -> std::optional<WrittenNumber> {
    const JsonNode* node = object.find(key);
    if (node == nullptr) return std::nullopt;
    return read_written(*node, member_path(path, key), read);
  };
  Properties result;
  const JsonNode* friction = object.find("friction");
  if (friction != nullptr && friction->kind == Kind::kString &&
      !begins_as_number(friction->text)) {
    result.friction_name = std::make_shared<const std::string>(friction->text);
  } else {
    result.friction = number("friction");
  }
  result.stiffness = number("stiffness");
  result.preload = number("preload");
  const auto certain = [&](const char* key) -> std::shared_ptr<const Rational> {
    const JsonNode* node = object.find(key);
    if (node == nullptr) return nullptr;
    return std::make_shared<const Rational>(read_number(*node, member_path(path, key)));
  };
  result.torsion = certain("torsion");
  result.max_force = certain("max_force");
  return result;
}

WrittenContact read_contact(const JsonNode& node, const std::string& path, IntervalReader& read,
                            bool in_space) {
  static const Names kMembers{"position", "normal", "on", "friction", "stiffness",
                              "preload",  "of",     "by", "torsion",  "max_force"};
  expect_object(node, path, kMembers);
  WrittenContact contact;
  const auto body = [&](const char* key) -> std::string {
    const JsonNode* name = node.find(key);
    if (name == nullptr) return {};
    expect(*name, Kind::kString, member_path(path, key), "the name of a body");
    if (name->text.empty()) fail_at(member_path(path, key), "the name is empty", "name a body");
    return name->text;
  };
  std::pair<std::string, std::string> bodies{body("of"), body("by")};
  if (!bodies.first.empty() || !bodies.second.empty()) {
    contact.bodies =
        std::make_shared<const std::pair<std::string, std::string>>(std::move(bodies));
  }
  const JsonNode* on = node.find("on");
  if (in_space) {
    if (on != nullptr) {
      fail_at(member_path(path, "on"), "a place on an outline, but the grasp is in space",
              "give \"position\": [x, y, z] and \"normal\": [x, y, z]");
    }
    read_place_in_space(node, path, read, contact);
  } else if (on != nullptr) {
    for (const char* key : {"position", "normal"}) {
      if (node.find(key) == nullptr) continue;
      fail_at(path, std::string("found both \"on\" and \"") + key + "\"",
              "remove one: a place on the outline has a position and a normal");
    }
    contact.place = read_place(*on, member_path(path, "on"));
  } else {
    read_position(node, path, read, contact);
    read_normal(node, path, read, false, contact);
  }
  contact.own = read_properties(node, path, read);
  return contact;
}

/// Returns the contact with the middles of its numbers, and with 1 for a stiffness and 0 for
/// other numbers that are not given.
Contact middle_of(WrittenContact c) {
  const auto value = [](std::optional<WrittenNumber>& number, int otherwise) {
    return number ? std::move(number->middle) : Rational(otherwise);
  };
  return {{std::move(c.x.middle), std::move(c.y.middle)},
          std::move(c.normal),
          value(c.own.friction, 0),
          value(c.own.stiffness, 1),
          value(c.own.preload, 0)};
}

bool is_certain(const WrittenContact& c) {
  bool certain = !c.slope && !c.x.interval && !c.y.interval;
  for (const auto* number : {&c.own.friction, &c.own.stiffness, &c.own.preload}) {
    certain = certain && !(*number && (*number)->interval);
  }
  return certain;
}

/// Returns the contact with its intervals, checked, with errors at `path`.
UncertainContact uncertain_of(const WrittenContact& c, bool in_space, const std::string& path) {
  const auto ends = [](const std::optional<WrittenNumber>& number, int otherwise) {
    return number ? number->ends() : point_interval(otherwise);
  };
  UncertainContact contact{{c.x.ends(), c.y.ends()}, {c.normal.x, c.normal.y},
                           ends(c.own.friction, 0),  ends(c.own.stiffness, 1),
                           ends(c.own.preload, 0),   c.slope.value_or(0)};
  if (in_space) {
    contact.position.push_back(c.z.ends());
    contact.normal.push_back(c.normal_z);
  }
  if (c.own.torsion) {
    if (!in_space) {
      fail_at(member_path(path, "torsion"), "torsion, but the grasp is in the plane",
              "remove it: in the plane no contact turns about its normal");
    }
    contact.torsion = *c.own.torsion;
  }
  if (c.own.max_force) contact.max_force = *c.own.max_force;
  check_contact(contact, path);
  return contact;
}

/// Reads the frictions that have names.
FrictionNames read_friction_names(const JsonNode& root, IntervalReader& read) {
  FrictionNames names;
  const JsonNode* node = root.find("friction");
  if (node == nullptr) return names;
  expect(*node, Kind::kObject, "friction", R"(an object such as {"wood-steel": "2/5"})");
  for (std::size_t k = 0; k < node->keys.size(); ++k) {
    const std::string& name = node->keys[k];
    const std::string place = member_path("friction", name);
    if (begins_as_number(name)) {
      fail_at(place, "the name " + quote(name) + " may be taken for a number",
              "give one that begins with a letter, such as \"wood-steel\"");
    }
    WrittenNumber value = read_written(node->children[k], place, read);
    if (value.ends().low.sign() < 0) {
      fail_at(place, "the value is " + to_readable_string(value.ends().low),
              "friction must be 0 or more");
    }
    names.emplace(name, std::move(value));
  }
  return names;
}

/// Gives the number in place of the name of a friction.
void look_up(Properties& properties, const FrictionNames& frictions, const std::string& path) {
  if (!properties.friction_name) return;
  const std::string& name = *properties.friction_name;
  const auto found = frictions.find(name);
  if (found == frictions.end()) {
    Names known;
    for (const auto& [other, value] : frictions) known.push_back(other);
    fail_at(member_path(path, "friction"),
            quote(name) + " is neither a number nor a name in the file's \"friction\"",
            known.empty() ? "write a number such as 0.25 or \"3/5\"; or in version 2 or 3 add "
                            "\"friction\": {" +
                                quote(name) + ": 0.25} to the file"
                          : choice_of(name, known, "its names are "));
  }
  properties.friction = found->second;
  properties.friction_name.reset();
}

/// Reads "defaults". `in_space` says whether the contacts are in space.
Properties read_defaults(const JsonNode& root, IntervalReader& read,
                         const FrictionNames& frictions, bool in_space = false) {
  const JsonNode* node = root.find("defaults");
  if (node == nullptr) return {};
  expect_object(*node, "defaults",
                {"friction", "stiffness", "preload", "torsion", "max_force"});
  WrittenContact probe;
  probe.normal = {1, 0};
  probe.own = read_properties(*node, "defaults", read);
  look_up(probe.own, frictions, "defaults");
  // The requirements on values are Grasp's own, even where no contact uses the default.
  if (probe.own.torsion || probe.own.max_force || !is_certain(probe)) {
    uncertain_of(probe, in_space, "defaults");
  }
  try {
    const Grasp grasp({middle_of(probe)});
  } catch (const InputError& error) {
    fail_at("defaults" + error.place().substr(error.place().find('.')), error.problem(),
            error.remedy());
  }
  return std::move(probe.own);
}

std::optional<Units> read_units(const JsonNode& root) {
  const JsonNode* node = root.find("units");
  if (node == nullptr) return std::nullopt;
  expect_object(*node, "units", {"length", "force"});
  const auto unit = [&](const char* key) {
    const JsonNode& name =
        member(*node, "units", key, R"(give both, as in {"length": "mm", "force": "N"})");
    expect(name, Kind::kString, member_path("units", key), "a string, such as \"mm\" or \"N\"");
    return name.text;
  };
  return Units{unit("length"), unit("force")};
}

std::string read_name(const JsonNode& root) {
  const JsonNode* node = root.find("name");
  if (node == nullptr) return {};
  expect(*node, Kind::kString, "name", "a string");
  return node->text;
}

/// Returns the version of the file, 1 to 3.
int read_format(const JsonNode& root) {
  const std::string remedy = std::string("write \"format\": \"") + kVersion1 + "\" or \"" +
                             kVersion2 + "\", or of several bodies \"" + kVersion3 + "\"";
  const JsonNode& node = member(root, "", "format", remedy.c_str());
  int version = 1;
  for (const char* known : {kVersion1, kVersion2, kVersion3}) {
    if (node.kind == Kind::kString && node.text == known) return version;
    ++version;
  }
  fail_at("format", "found " + describe(node), remedy);
}

bool has_several_bodies(const JsonNode& root) {
  const JsonNode* format = root.find("format");
  return format != nullptr && format->kind == Kind::kString && format->text == kVersion3;
}

std::string newer_format() {
  return std::string("write \"format\": \"") + kVersion2 + "\", which has it";
}

/// Throws InputError for a key that version 1 does not have.
[[noreturn]] void fail_as_newer(const std::string& path, const std::string& key) {
  fail_at(path, "unknown key " + quote(key), newer_format());
}

constexpr const char* kOfBodies[] = {"bodies", "joints", "tendons", "ratchets"};

void check_keys(const JsonNode& root, bool version2) {
  for (const char* key : kOfBodies) {
    if (root.find(key) == nullptr) continue;
    fail_at("", "unknown key " + quote(key),
            std::string("write \"format\": \"") + kVersion3 + "\", which has it");
  }
  Names allowed{"format", "name", "defaults", "contacts", "wrench"};
  for (const char* key :
       {"units", "outline", "body", "loads", "cases", "max_motion", "gravity", "friction"}) {
    if (version2) allowed.emplace_back(key);
    if (!version2 && root.find(key) != nullptr) fail_as_newer("", key);
  }
  if (root.find("normals") != nullptr) {
    fail_at("", "unknown key \"normals\"",
            "remove it; to snap normals, run stickslip snap GRASP -o FILE");
  }
  expect_object(root, "", allowed);
}

void check_members(const JsonNode& root, bool version2) {
  check_keys(root, version2);
  expect(member(root, "", "contacts", "add \"contacts\": [...], which may be empty"),
         Kind::kArray, "contacts", "an array of contacts [{...}, ...]");
}

/// Reads the load; in a file with cases, the load that they have in common.
WrenchBox read_whole_load(const JsonNode& root, const LoadSpace& space, IntervalReader& read,
                          const std::string& remedy) {
  const std::optional<WrenchBox> load = read_load(root, "", space, read);
  if (!load && root.find("cases") == nullptr) {
    fail_at("", "the key \"wrench\" is missing", remedy);
  }
  return load.value_or(WrenchBox(space.components()));
}

/// Reads "max_motion", if it is there.
void read_max_motion(const JsonNode& root, GraspBox& box) {
  const JsonNode* node = root.find("max_motion");
  if (node == nullptr) return;
  const std::string path = "max_motion";
  const std::string all =
      "an array of " + std::to_string(box.wrench.size()) + " numbers, one for each coordinate";
  const auto read_above_0 = [](const JsonNode& number, const std::string& place) {
    Rational value = read_number(number, place);
    if (value.sign() <= 0) {
      fail_at(place, "the value is " + to_readable_string(value),
              "a bound of motions is above 0");
    }
    return value;
  };
  RationalRow numbers;
  if (node->kind == Kind::kObject) {
    expect_object(*node, path, {"length", "angle"});
    for (const char* key : {"length", "angle"}) {
      const JsonNode& number =
          member(*node, path, key, "give both \"length\" and \"angle\", numbers above 0");
      numbers.push_back(read_above_0(number, member_path(path, key)));
    }
    if (box.mechanism && !box.mechanism->joints.empty()) {
      fail_at(path, "a length and an angle, but there are joints", "give " + all);
    }
  } else {
    expect(*node, Kind::kArray, path,
           R"(an array of numbers, or {"length": ..., "angle": ...})");
    const std::size_t count = node->children.size();
    if (count != box.wrench.size()) {
      fail_at(path, "found an array of " + std::to_string(count) + " values",
              "give " + all + R"(, or {"length": ..., "angle": ...})");
    }
    for (std::size_t j = 0; j < count; ++j) {
      numbers.push_back(read_above_0(node->children[j], element_path(path, j)));
    }
  }
  box.max_motion = bound_of(box, {std::move(numbers)});
}

/// Gives contacts with a place on the outline their position and normal.
void put_on_outline(std::vector<WrittenContact>& contacts, const std::vector<Polygon>& outline,
                    bool version2) {
  const std::vector<std::vector<OutlineEdge>> edges = outline_edges(outline);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    WrittenContact& contact = contacts[i];
    if (!contact.place) continue;
    const std::string path = element_path("contacts", i);
    if (!version2) fail_as_newer(path, "on");
    const OutlineEdge& edge = edge_at(edges, *contact.place, member_path(path, "on"));
    const Vector2 position = edge.at(contact.place->share);
    contact.x.middle = position.x;
    contact.y.middle = position.y;
    contact.normal = edge.inwards;
  }
}

/// Refuses members that only files of several bodies have.
void refuse_bodies(const std::vector<WrittenContact>& contacts, const Properties& defaults) {
  const auto refuse = [](const std::string& place, const std::string& key) {
    fail_at(place, "unknown key \"" + key + "\"",
            std::string("write \"format\": \"") + kVersion3 +
                "\", which has \"bodies\", soft fingers and limits of forces");
  };
  if (defaults.torsion) refuse("defaults", "torsion");
  if (defaults.max_force) refuse("defaults", "max_force");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::string place = element_path("contacts", i);
    if (contacts[i].bodies) refuse(place, contacts[i].bodies->first.empty() ? "by" : "of");
    if (contacts[i].own.torsion) refuse(place, "torsion");
    if (contacts[i].own.max_force) refuse(place, "max_force");
  }
}

/// Sets the bodies that a contact is between.
void put_between(UncertainContact& contact, const WrittenContact& written,
                 const Mechanism& mechanism, const std::string& path) {
  if (!written.bodies || written.bodies->first.empty()) {
    fail_at(path, "the key \"of\" is missing",
            "name the body that is pressed, into which the normal points");
  }
  const auto& [of, by] = *written.bodies;
  contact.of = mechanism.body_named(of, member_path(path, "of"));
  if (!by.empty() && by != "ground") {
    contact.by = mechanism.body_named(by, member_path(path, "by"));
  }
  if (contact.of == contact.by) {
    fail_at(path, "a contact of " + quote(of) + " with itself",
            "name another body in \"by\", or leave it out for the ground");
  }
}

void fill_in(std::vector<WrittenContact>& contacts, const Properties& defaults,
             const FrictionNames& frictions) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Properties& own = contacts[i].own;
    if (own.friction_name) look_up(own, frictions, element_path("contacts", i));
    if (!own.friction) own.friction = defaults.friction;
    if (!own.stiffness) own.stiffness = defaults.stiffness;
    if (!own.preload) own.preload = defaults.preload;
    if (!own.torsion) own.torsion = defaults.torsion;
    if (!own.max_force) own.max_force = defaults.max_force;
    if (own.friction) continue;
    fail_at(element_path("contacts", i), "the key \"friction\" is missing",
            "add it here, or for all contacts in \"defaults\"");
  }
}

/// Returns the normals that were given by an angle and rounded. Version 1 has no angles.
std::vector<RoundedNormal> rounded_normals(const std::vector<WrittenContact>& contacts,
                                           bool version2) {
  std::vector<RoundedNormal> rounded;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].angle) continue;
    if (!version2) fail_as_newer(element_path("contacts", i) + ".normal", "angle");
    if (!direction_at(*contacts[i].angle).is_rounded) continue;
    rounded.push_back({ContactId(i), *contacts[i].angle});
  }
  return rounded;
}

void refuse_intervals(const std::string& first, bool version2, Intervals intervals) {
  if (first.empty()) return;
  if (!version2) {
    fail_at(first, "an interval, or a normal with a slope",
            std::string("write \"format\": \"") + kVersion2 + "\", which has them");
  }
  if (intervals == Intervals::kAllowed) return;
  fail_at(first, "the number is uncertain",
          "stickslip decide, radius and batch answer for all numbers of an interval: "
          "give one here");
}

}  // namespace

std::size_t case_named(const std::vector<std::string>& cases,
                       const std::optional<std::string>& name) {
  const auto found = std::find(cases.begin(), cases.end(), name);
  if (found != cases.end()) return static_cast<std::size_t>(found - cases.begin());
  // The remedy names the cases, the first of them if there are many, and the one that may have
  // been meant.
  constexpr std::size_t kMostNamed = 12;
  std::string choice = did_you_mean(name.value_or(""), cases) + "its cases are ";
  for (std::size_t i = 0; i < std::min(cases.size(), kMostNamed); ++i) {
    choice += (i == 0 ? "" : ", ") + quote(cases[i]);
  }
  if (cases.size() > kMostNamed) choice += ", ...";
  throw InputError("", "case",
                   name ? "the grasp has no case " + quote(*name)
                        : "the grasp has cases, and none is chosen",
                   cases.empty() ? "it has no cases at all" : choice);
}

GraspFile StreamedGrasp::finish_any(const JsonNode& grasp, Intervals intervals) {
  if (grasp.kind == Kind::kObject && has_several_bodies(grasp)) {
    return finish_bodies(grasp, intervals);
  }
  if (grasp.kind == Kind::kObject && in_space(grasp)) return finish_in_space(grasp, intervals);
  return finish(grasp, intervals);
}

StreamedGrasp::StreamedGrasp() = default;
StreamedGrasp::~StreamedGrasp() = default;

void StreamedGrasp::add_contact(std::size_t index, const JsonNode& node) {
  std::string interval;
  IntervalReader read(interval);
  if (index == 0) {
    const JsonNode* position = node.find("position");
    in_space_ =
        position != nullptr && position->kind == Kind::kArray && position->children.size() == 3;
  }
  // Errors name places within the contact, and the path of the contact is put before them only
  // when needed: to spell the paths of all numbers would take as long as to read them.
  const std::string path = element_path("contacts", index);
  contacts_.push_back(within(path, [&] { return read_contact(node, "", read, in_space_); }));
  if (first_interval_.empty() && !interval.empty()) first_interval_ = path + "." + interval;
}

bool StreamedGrasp::in_space(const JsonNode& grasp) const {
  if (!contacts_.empty()) return in_space_;
  const JsonNode* wrench = grasp.find("wrench");
  return wrench != nullptr && wrench->kind == Kind::kArray && wrench->children.size() == 6;
}

GraspFile StreamedGrasp::finish(const JsonNode& grasp, Intervals intervals) {
  expect(grasp, Kind::kObject, "", "an object {\"format\": ..., \"contacts\": [...], ...}");
  const int version = read_format(grasp);
  if (version == 3) {
    fail_at("bodies", "the grasp has several bodies",
            "this is done for one body only; stickslip decide answers for several");
  }
  const bool version2 = version == 2;
  check_members(grasp, version2);
  if (in_space(grasp)) {
    fail_at(contacts_.empty() ? "wrench" : "contacts[0].position", "the grasp is in space",
            version2 ? "this is done in the plane only; stickslip decide answers in space"
                     : newer_format());
  }
  IntervalReader read(first_interval_);
  const FrictionNames frictions = read_friction_names(grasp, read);
  const Properties defaults = read_defaults(grasp, read, frictions);
  refuse_bodies(contacts_, defaults);
  const LoadSpace space{false, nullptr, read_gravity(grasp, false)};
  const WrenchBox wrench =
      read_whole_load(grasp, space, read,
                      std::string("add \"wrench\": [x, y, torque]") +
                          (version2 ? " or \"loads\": [...]" : "") + "; no load is [0, 0, 0]");
  GraspFile file;
  for (ReadCase& one : read_cases(grasp, wrench, space, read)) {
    file.cases.push_back({std::move(one.name), std::move(one.load)});
  }
  if (grasp.find("body") != nullptr) {
    fail_at("body", "a body in space, but the grasp is in the plane",
            "give \"outline\": [[x, y], ...], or remove it");
  }
  std::vector<Polygon> outline = read_outline(grasp);
  put_on_outline(contacts_, outline, version2);
  fill_in(contacts_, defaults, frictions);
  std::vector<RoundedNormal> rounded = rounded_normals(contacts_, version2);
  refuse_intervals(first_interval_, version2, intervals);

  std::vector<std::pair<std::size_t, UncertainContact>> uncertain;
  std::vector<Contact> contacts;
  contacts.reserve(contacts_.size());
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    WrittenContact& contact = contacts_[i];
    if (!is_certain(contact)) {
      uncertain.emplace_back(i, uncertain_of(contact, false, element_path("contacts", i)));
    }
    if (!contact.own.stiffness) file.assumed_stiffness.emplace_back(i);
    contacts.push_back(middle_of(std::move(contact)));
  }
  contacts_.clear();
  LoadedGrasp middle{
      Grasp(std::move(contacts),
            GraspDescription{read_name(grasp), std::move(outline), read_units(grasp), nullptr,
                             gravity_of_masses(grasp, space), std::move(rounded)}),
      wrench_of(middle_of(wrench))};
  const bool is_bounded = grasp.find("max_motion") != nullptr;
  if (is_bounded && intervals == Intervals::kRefused) {
    fail_at("max_motion", "motions are bounded",
            "this is done without a bound: remove it, or ask stickslip decide");
  }
  if (uncertain.empty() && !is_uncertain(wrench) && !is_bounded) {
    file.content = std::move(middle);
    return file;
  }
  GraspBox box = box_of(middle);
  box.wrench = wrench;
  for (auto& [i, contact] : uncertain) box.contacts[i] = std::move(contact);
  read_max_motion(grasp, box);
  file.content = std::move(box);
  return file;
}

GraspFile StreamedGrasp::finish_in_space(const JsonNode& grasp, Intervals intervals) {
  const bool version2 = read_format(grasp) == 2;
  check_members(grasp, version2);
  if (!version2) fail_at("contacts[0].position", "three coordinates", newer_format());
  if (grasp.find("outline") != nullptr) {
    fail_at("outline", "an outline, but the grasp is in space",
            R"(remove it; in space there is "body": {"vertices": [...], "faces": [...]})");
  }
  IntervalReader read(first_interval_);
  const FrictionNames frictions = read_friction_names(grasp, read);
  const Properties defaults = read_defaults(grasp, read, frictions, true);
  refuse_bodies(contacts_, defaults);
  const LoadSpace space{true, nullptr, read_gravity(grasp, true)};
  GraspFile result;
  result.content = GraspBox();
  GraspBox& box = *result.content.box();
  box.wrench = read_whole_load(
      grasp, space, read,
      "add \"wrench\": [force x, y, z, torque x, y, z] or \"loads\": [...]; no load is [0, 0, "
      "0, 0, 0, 0]");
  for (ReadCase& one : read_cases(grasp, box.wrench, space, read)) {
    result.cases.push_back({std::move(one.name), std::move(one.load)});
  }
  fill_in(contacts_, defaults, frictions);
  refuse_intervals(first_interval_, version2, intervals);
  for (const WrittenContact& c : contacts_) {
    const std::size_t i = box.contacts.size();
    if (!c.own.stiffness) result.assumed_stiffness.emplace_back(i);
    box.contacts.push_back(uncertain_of(c, true, element_path("contacts", i)));
  }
  contacts_.clear();
  // The requirements on units are Grasp's own.
  box.description = Grasp({}, GraspDescription{read_name(grasp),
                                               {},
                                               read_units(grasp),
                                               read_surface(grasp),
                                               gravity_of_masses(grasp, space)})
                        .description();
  box.check();
  read_max_motion(grasp, box);
  return result;
}

GraspFile StreamedGrasp::finish_bodies(const JsonNode& grasp, Intervals intervals) {
  Names allowed{"format", "name",  "units",      "defaults", "contacts", "wrench",
                "loads",  "cases", "max_motion", "gravity",  "friction"};
  allowed.insert(allowed.end(), std::begin(kOfBodies), std::end(kOfBodies));
  expect_object(grasp, "", allowed);
  expect(member(grasp, "", "contacts", "add \"contacts\": [...], which may be empty"),
         Kind::kArray, "contacts", "an array of contacts [{...}, ...]");
  const bool spatial = !contacts_.empty() && in_space_;
  IntervalReader read(first_interval_);
  const FrictionNames frictions = read_friction_names(grasp, read);
  const Properties defaults = read_defaults(grasp, read, frictions, spatial);
  GraspFile result;
  result.content = GraspBox();
  GraspBox& box = *result.content.box();
  const auto mechanism = std::make_shared<Mechanism>(read_mechanism(grasp, spatial));
  box.mechanism = mechanism;
  box.springs = read_springs(grasp, *mechanism, read);
  const LoadSpace space{spatial, mechanism.get(), read_gravity(grasp, spatial)};
  box.wrench = read_load(grasp, "", space, read).value_or(WrenchBox(mechanism->coordinates()));
  for (ReadCase& one : read_cases(grasp, box.wrench, space, read)) {
    result.cases.push_back({std::move(one.name), std::move(one.load)});
  }
  for (auto& [body, point] : weight_points(grasp, *mechanism)) {
    mechanism->bodies[body].weights.push_back(std::move(point));
  }
  fill_in(contacts_, defaults, frictions);
  std::vector<RoundedNormal> rounded = rounded_normals(contacts_, true);
  refuse_intervals(first_interval_, true, intervals);
  for (const WrittenContact& c : contacts_) {
    const std::size_t i = box.contacts.size();
    const std::string path = element_path("contacts", i);
    if (c.place) {
      fail_at(member_path(path, "on"), "a place on an outline",
              "of several bodies give \"position\" and \"normal\"");
    }
    if (!c.own.stiffness) result.assumed_stiffness.emplace_back(i);
    box.contacts.push_back(uncertain_of(c, spatial, path));
    put_between(box.contacts.back(), c, *mechanism, path);
  }
  contacts_.clear();
  // The requirements on units are Grasp's own.
  box.description = Grasp({}, GraspDescription{read_name(grasp),
                                               {},
                                               read_units(grasp),
                                               nullptr,
                                               gravity_of_masses(grasp, space),
                                               std::move(rounded)})
                        .description();
  box.check();
  read_max_motion(grasp, box);
  return result;
}

namespace {

/// Returns what `finish` makes of the text. Errors name `file`.
template <class Finish>
GraspFile parse_with(std::string_view text, const std::string& file, const Finish& finish) {
  try {
    if (text.size() > kMaxJsonBytes) {
      fail_at("", "more than " + std::to_string(kMaxJsonBytes) + " bytes",
              "split the grasp file; larger ones are not read");
    }
    StreamedGrasp reader;
    const JsonNode grasp =
        parse_json(text, {{{"contacts"}, [&](std::size_t index, const JsonNode& contact) {
                             reader.add_contact(index, contact);
                           }}});
    return finish(reader, grasp);
  } catch (const InputError& error) {
    throw error.in_file(file);
  }
}

}  // namespace

GraspFile parse_grasp(std::string_view text, const std::string& file, Intervals intervals) {
  return parse_with(text, file, [&](StreamedGrasp& reader, const JsonNode& grasp) {
    return reader.finish(grasp, intervals);
  });
}

GraspFile parse_any_grasp(std::string_view text, const std::string& file, Intervals intervals) {
  return parse_with(text, file, [&](StreamedGrasp& reader, const JsonNode& grasp) {
    return reader.finish_any(grasp, intervals);
  });
}

GraspFile read_grasp_file(const std::string& path, Intervals intervals) {
  InputFile file(path, "a grasp file");
  return parse_grasp(file.read(kMaxJsonBytes), file.name(), intervals);
}

GraspFile read_any_grasp_file(const std::string& path, Intervals intervals) {
  InputFile file(path, "a grasp file");
  return parse_any_grasp(file.read(kMaxJsonBytes), file.name(), intervals);
}

}  // namespace stickslip
