// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/grasp_file.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "grasp_format.hpp"
#include "intervals.hpp"
#include "loads.hpp"
#include "outline_file.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/json.hpp"
#include "uncertain_contact.hpp"

namespace stickslip {

using namespace core_detail;

/// A number; or an interval, which is rare and kept apart.
struct WrittenNumber {
  Rational middle{0};
  std::shared_ptr<const Interval> interval{};  ///< unless it is one number

  Interval ends() const { return interval ? *interval : point_interval(middle); }
};

struct WrittenContact {
  /// What "defaults" may give.
  struct Properties {
    std::optional<WrittenNumber> friction;
    std::optional<WrittenNumber> stiffness;
    std::optional<WrittenNumber> preload;
  };

  std::optional<PlaceOnOutline> place;  ///< in place of position and normal
  WrittenNumber x;
  WrittenNumber y;
  Vector2 normal;
  std::optional<Rational> slope;  ///< of the normal, unless it is 0
  Properties own;
};

namespace {

using Properties = WrittenContact::Properties;
using Kind = JsonNode::Kind;

using Names = std::vector<std::string>;

WrittenNumber written(const Interval& interval) {
  if (interval.is_point()) return {interval.low};
  return {interval.middle(), std::make_shared<const Interval>(interval)};
}

Vector2 read_direction(const JsonNode& node, const std::string& path) {
  const std::vector<Rational> v = read_vector(node, path, 2, "an array of two numbers [x, y]");
  return {v[0], v[1]};
}

void read_position(const JsonNode& node, const std::string& path, IntervalReader& read,
                   WrittenContact& contact) {
  const JsonNode& position = member(node, path, "position", "add \"position\": [x, y]");
  const std::vector<Interval> v = read.numbers(position, member_path(path, "position"), 2,
                                               "an array of two numbers [x, y]");
  contact.x = written(v[0]);
  contact.y = written(v[1]);
}

/// [x, y], or {"direction": [x, y], "slope": E}.
void read_normal(const JsonNode& node, const std::string& path, IntervalReader& read,
                 WrittenContact& contact) {
  const JsonNode& normal =
      member(node, path, "normal", "add \"normal\": [x, y], pointing into the object");
  const std::string place = member_path(path, "normal");
  if (normal.kind != Kind::kObject) {
    contact.normal = read_direction(normal, place);
    return;
  }
  read.note(place);
  expect_object(normal, place, {"direction", "slope"});
  constexpr const char* kForm = R"(write {"direction": [x, y], "slope": E})";
  contact.normal = read_direction(member(normal, place, "direction", kForm),
                                  member_path(place, "direction"));
  contact.slope =
      read_number(member(normal, place, "slope", kForm), member_path(place, "slope"));
  if (contact.slope->is_zero()) contact.slope.reset();
}

Properties read_properties(const JsonNode& object, const std::string& path,
                           IntervalReader& read) {
  const auto number = [&](const char* key) -> std::optional<WrittenNumber> {
    const JsonNode* node = object.find(key);
    if (node == nullptr) return std::nullopt;
    return written(read.number(*node, member_path(path, key)));
  };
  return {number("friction"), number("stiffness"), number("preload")};
}

WrittenContact read_contact(const JsonNode& node, const std::string& path,
                            IntervalReader& read) {
  expect_object(node, path, {"position", "normal", "on", "friction", "stiffness", "preload"});
  WrittenContact contact;
  if (const JsonNode* on = node.find("on")) {
    for (const char* key : {"position", "normal"}) {
      if (node.find(key) == nullptr) continue;
      fail_at(path, std::string("found both \"on\" and \"") + key + "\"",
              "remove one: a place on the outline has a position and a normal");
    }
    contact.place = read_place(*on, member_path(path, "on"));
  } else {
    read_position(node, path, read, contact);
    read_normal(node, path, read, contact);
  }
  contact.own = read_properties(node, path, read);
  return contact;
}

/// The contact, with 1 and 0 for what is not given.
Contact middle_of(const WrittenContact& c) {
  const auto value = [](const std::optional<WrittenNumber>& number, int otherwise) {
    return number ? number->middle : Rational(otherwise);
  };
  return {{c.x.middle, c.y.middle},
          c.normal,
          value(c.own.friction, 0),
          value(c.own.stiffness, 1),
          value(c.own.preload, 0)};
}

/// Its intervals, if it has any; checked, with errors at `path`.
std::optional<UncertainContact> uncertain_of(const WrittenContact& c, const std::string& path) {
  bool is_point = !c.slope && !c.x.interval && !c.y.interval;
  for (const auto* number : {&c.own.friction, &c.own.stiffness, &c.own.preload}) {
    is_point = is_point && !(*number && (*number)->interval);
  }
  if (is_point) return std::nullopt;
  const auto ends = [](const std::optional<WrittenNumber>& number, int otherwise) {
    return number ? number->ends() : point_interval(otherwise);
  };
  UncertainContact contact{c.x.ends(),
                           c.y.ends(),
                           c.normal,
                           c.slope.value_or(0),
                           ends(c.own.friction, 0),
                           ends(c.own.stiffness, 1),
                           ends(c.own.preload, 0)};
  check_uncertain(contact, path);
  return contact;
}

Properties read_defaults(const JsonNode& root, IntervalReader& read) {
  const JsonNode* node = root.find("defaults");
  if (node == nullptr) return {};
  expect_object(*node, "defaults", {"friction", "stiffness", "preload"});
  WrittenContact probe;
  probe.normal = {1, 0};
  probe.own = read_properties(*node, "defaults", read);
  // The requirements on values are Grasp's own, even where no contact uses the default.
  uncertain_of(probe, "defaults");
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

/// Whether the file is of version 2.
bool read_format(const JsonNode& root) {
  const std::string remedy =
      std::string("write \"format\": \"") + kVersion1 + "\" or \"" + kVersion2 + "\"";
  const JsonNode& node = member(root, "", "format", remedy.c_str());
  const bool known =
      node.kind == Kind::kString && (node.text == kVersion1 || node.text == kVersion2);
  if (!known) fail_at("format", "found " + describe(node), remedy);
  return node.text == kVersion2;
}

/// What version 1 does not have.
[[noreturn]] void fail_as_newer(const std::string& path, const std::string& key) {
  fail_at(path, "unknown key " + quote(key),
          std::string("write \"format\": \"") + kVersion2 + "\", which has it");
}

void check_keys(const JsonNode& root, bool version2) {
  Names allowed{"format", "name", "defaults", "contacts", "wrench"};
  for (const char* key : {"units", "outline", "loads", "cases"}) {
    if (version2) allowed.emplace_back(key);
    if (!version2 && root.find(key) != nullptr) fail_as_newer("", key);
  }
  if (root.find("normals") != nullptr) {
    fail_at("", "unknown key \"normals\"",
            "remove it; to snap normals, run stickslip snap GRASP -o FILE");
  }
  expect_object(root, "", allowed);
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

void fill_in(std::vector<WrittenContact>& contacts, const Properties& defaults) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Properties& own = contacts[i].own;
    if (!own.friction) own.friction = defaults.friction;
    if (!own.stiffness) own.stiffness = defaults.stiffness;
    if (!own.preload) own.preload = defaults.preload;
    if (own.friction) continue;
    fail_at(element_path("contacts", i), "the key \"friction\" is missing",
            "add it here, or for all contacts in \"defaults\"");
  }
}

void refuse_intervals(const std::string& first, bool version2, Intervals intervals) {
  if (first.empty()) return;
  if (!version2) {
    fail_at(first, "an interval, or a normal with a slope",
            std::string("write \"format\": \"") + kVersion2 + "\", which has them");
  }
  if (intervals == Intervals::kAllowed) return;
  fail_at(
      first, "the number is uncertain",
      "only stickslip decide and radius answer for all numbers of an interval: give one here");
}

std::string read_all(std::istream& in, const std::string& file) {
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16);
  while (in) {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
    // parse_grasp has the message; what matters here is to stop.
    if (text.size() > kMaxJsonBytes) break;
  }
  if (in.bad()) throw InputError(file, "", "reading failed", "is it a readable file?");
  return text;
}

}  // namespace

StreamedGrasp::StreamedGrasp() = default;
StreamedGrasp::~StreamedGrasp() = default;

void StreamedGrasp::add_contact(std::size_t index, const JsonNode& node) {
  IntervalReader read(first_interval_);
  contacts_.push_back(read_contact(node, element_path("contacts", index), read));
}

GraspFile StreamedGrasp::finish(const JsonNode& grasp, Intervals intervals) {
  expect(grasp, Kind::kObject, "", "an object {\"format\": ..., \"contacts\": [...], ...}");
  const bool version2 = read_format(grasp);
  check_keys(grasp, version2);
  expect(member(grasp, "", "contacts", "add \"contacts\": [...], which may be empty"),
         Kind::kArray, "contacts", "an array of contacts [{...}, ...]");
  IntervalReader read(first_interval_);
  const Properties defaults = read_defaults(grasp, read);
  const std::optional<WrenchBox> load = read_load(grasp, "", read);
  if (!load && grasp.find("cases") == nullptr) {
    fail_at("", "the key \"wrench\" is missing",
            std::string("add \"wrench\": [x, y, torque]") +
                (version2 ? " or \"loads\": [...]" : "") + "; no load is [0, 0, 0]");
  }
  const WrenchBox wrench = load.value_or(WrenchBox{});
  GraspFile file;
  file.cases = read_cases(grasp, wrench, read);
  std::vector<Polygon> outline = read_outline(grasp);
  put_on_outline(contacts_, outline, version2);
  fill_in(contacts_, defaults);
  refuse_intervals(first_interval_, version2, intervals);

  std::vector<std::pair<std::size_t, UncertainContact>> uncertain;
  std::vector<Contact> contacts;
  contacts.reserve(contacts_.size());
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const WrittenContact& contact = contacts_[i];
    if (auto box = uncertain_of(contact, element_path("contacts", i))) {
      uncertain.emplace_back(i, std::move(*box));
    }
    if (!contact.own.stiffness) file.assumed_stiffness.emplace_back(i);
    contacts.push_back(middle_of(contact));
  }
  contacts_.clear();
  file.content = {
      Grasp(std::move(contacts),
            GraspDescription{read_name(grasp), std::move(outline), read_units(grasp)}),
      middle(wrench)};
  if (uncertain.empty() && !is_uncertain(wrench)) return file;
  file.box = box_of(file.content);
  file.box->wrench = wrench;
  for (auto& [i, contact] : uncertain) file.box->contacts[i] = std::move(contact);
  return file;
}

GraspFile parse_grasp(std::string_view text, const std::string& file, Intervals intervals) {
  try {
    if (text.size() > kMaxJsonBytes) {
      fail_at("", "more than " + std::to_string(kMaxJsonBytes) + " bytes",
              "split the grasp file; larger ones are not read");
    }
    StreamedGrasp reader;
    return reader.finish(parse_json(text, {{{"contacts"},
                                            [&](std::size_t index, const JsonNode& contact) {
                                              reader.add_contact(index, contact);
                                            }}}),
                         intervals);
  } catch (const InputError& error) {
    throw error.in_file(file);
  }
}

GraspFile read_grasp_file(const std::string& path, Intervals intervals) {
  InputFile file(path, "a grasp file");
  return parse_grasp(read_all(file.stream(), file.name()), file.name(), intervals);
}

}  // namespace stickslip
