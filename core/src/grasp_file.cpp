// SPDX-License-Identifier: GPL-3.0-or-later
#include "stickslip/core/grasp_file.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "loads.hpp"
#include "outline_file.hpp"
#include "stickslip/core/error.hpp"
#include "stickslip/core/file.hpp"
#include "stickslip/core/json.hpp"

namespace stickslip {

using namespace core_detail;

struct WrittenContact {
  /// What "defaults" may give.
  struct Properties {
    std::optional<Rational> friction;
    std::optional<Rational> stiffness;
    std::optional<Rational> preload;
  };

  std::optional<PlaceOnOutline> place;  ///< in place of position and normal
  Vector2 position;
  Vector2 normal;
  Properties own;
};

namespace {

using Properties = WrittenContact::Properties;
using Kind = JsonNode::Kind;

using Names = std::vector<std::string>;

constexpr const char* kVersion1 = "stickslip-grasp/1";
constexpr const char* kVersion2 = "stickslip-grasp/2";

Vector2 read_vector2(const JsonNode& contact, const std::string& path, const char* key,
                     const char* remedy) {
  const JsonNode& node = member(contact, path, key, remedy);
  const std::vector<Rational> v =
      read_vector(node, member_path(path, key), 2, "an array of two numbers [x, y]");
  return {v[0], v[1]};
}

Properties read_properties(const JsonNode& object, const std::string& path) {
  const auto number = [&](const char* key) -> std::optional<Rational> {
    const JsonNode* node = object.find(key);
    if (node == nullptr) return std::nullopt;
    return read_number(*node, member_path(path, key));
  };
  return {number("friction"), number("stiffness"), number("preload")};
}

WrittenContact read_contact(const JsonNode& node, const std::string& path) {
  expect_object(node, path, {"position", "normal", "on", "friction", "stiffness", "preload"});
  if (const JsonNode* on = node.find("on")) {
    for (const char* key : {"position", "normal"}) {
      if (node.find(key) == nullptr) continue;
      fail_at(path, std::string("found both \"on\" and \"") + key + "\"",
              "remove one: a place on the outline has a position and a normal");
    }
    return {read_place(*on, member_path(path, "on")), {}, {}, read_properties(node, path)};
  }
  return {
      std::nullopt, read_vector2(node, path, "position", "add \"position\": [x, y]"),
      read_vector2(node, path, "normal", "add \"normal\": [x, y], pointing into the object"),
      read_properties(node, path)};
}

Properties read_defaults(const JsonNode& root) {
  const JsonNode* node = root.find("defaults");
  if (node == nullptr) return {};
  expect_object(*node, "defaults", {"friction", "stiffness", "preload"});
  Properties read = read_properties(*node, "defaults");
  // The requirements on values are Grasp's own, even where no contact uses the default.
  try {
    const Grasp probe({{{},
                        {1, 0},
                        read.friction.value_or(0),
                        read.stiffness.value_or(1),
                        read.preload.value_or(0)}});
  } catch (const InputError& error) {
    fail_at("defaults" + error.place().substr(error.place().find('.')), error.problem(),
            error.remedy());
  }
  return read;
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
    contact.position = edge.at(contact.place->share);
    contact.normal = edge.inwards;
  }
}

std::vector<Contact> with_defaults(std::vector<WrittenContact> written,
                                   const Properties& defaults,
                                   std::vector<ContactId>& assumed_stiffness) {
  std::vector<Contact> contacts;
  contacts.reserve(written.size());
  for (WrittenContact& w : written) {
    std::optional<Rational>& friction = w.own.friction;
    if (!friction) friction = defaults.friction;
    if (!friction) {
      fail_at(element_path("contacts", contacts.size()), "the key \"friction\" is missing",
              "add it here, or for all contacts in \"defaults\"");
    }
    if (!w.own.stiffness && !defaults.stiffness) {
      assumed_stiffness.push_back(ContactId(contacts.size()));
    }
    contacts.push_back({std::move(w.position), std::move(w.normal), std::move(*friction),
                        w.own.stiffness.value_or(defaults.stiffness.value_or(1)),
                        w.own.preload.value_or(defaults.preload.value_or(0))});
  }
  return contacts;
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

/// Exact: an integer that every JSON reader keeps, else a string. Throws InputError for a
/// number that parse_rational would not read back.
std::string write_number(const Rational& value) {
  constexpr std::int64_t kExactInDouble = std::int64_t{1} << 53;
  std::string text = to_string(value);
  if (text.size() > kMaxNumberLength) {
    throw InputError("", "", "a number of " + std::to_string(text.size()) + " characters",
                     "grasp files hold numbers of at most " + std::to_string(kMaxNumberLength));
  }
  const bool plain =
      boost::multiprecision::denominator(value) == 1 && abs(value) < kExactInDouble;
  return plain ? text : "\"" + text + "\"";
}

std::string write_numbers(std::initializer_list<const Rational*> values) {
  std::string text;
  for (const Rational* value : values)
    text += (text.empty() ? "[" : ", ") + write_number(*value);
  return text + "]";
}

template <class Entry, class Write>
std::string write_list(const std::vector<Entry>& entries, const char* separator, Write write) {
  std::string text;
  for (const Entry& entry : entries) text += (text.empty() ? "[" : separator) + write(entry);
  return text + "]";
}

std::string write_polygon(const Polygon& polygon) {
  const auto write_vertex = [](const Vector2& v) { return write_numbers({&v.x, &v.y}); };
  return write_list(polygon, ", ",
                    [&](const Ring& ring) { return write_list(ring, ", ", write_vertex); });
}

std::string write_wrench(const Wrench& w) {
  return write_numbers({&w.x, &w.y, &w.torque});
}

}  // namespace

StreamedGrasp::StreamedGrasp() = default;
StreamedGrasp::~StreamedGrasp() = default;

void StreamedGrasp::add_contact(std::size_t index, const JsonNode& node) {
  contacts_.push_back(read_contact(node, element_path("contacts", index)));
}

GraspFile StreamedGrasp::finish(const JsonNode& grasp) {
  expect(grasp, Kind::kObject, "", "an object {\"format\": ..., \"contacts\": [...], ...}");
  const bool version2 = read_format(grasp);
  check_keys(grasp, version2);
  expect(member(grasp, "", "contacts", "add \"contacts\": [...], which may be empty"),
         Kind::kArray, "contacts", "an array of contacts [{...}, ...]");
  const Properties defaults = read_defaults(grasp);
  const std::optional<Wrench> wrench = read_load(grasp, "");
  if (!wrench && grasp.find("cases") == nullptr) {
    fail_at("", "the key \"wrench\" is missing",
            std::string("add \"wrench\": [x, y, torque]") +
                (version2 ? " or \"loads\": [...]" : "") + "; no load is [0, 0, 0]");
  }
  std::vector<NamedLoad> cases = read_cases(grasp, wrench.value_or(Wrench{}));
  std::vector<Polygon> outline = read_outline(grasp);
  put_on_outline(contacts_, outline, version2);
  std::vector<ContactId> assumed_stiffness;
  Grasp read(with_defaults(std::move(contacts_), defaults, assumed_stiffness),
             GraspDescription{read_name(grasp), std::move(outline), read_units(grasp)});
  return {{std::move(read), wrench.value_or(Wrench{})},
          std::move(assumed_stiffness),
          std::move(cases)};
}

GraspFile parse_grasp(std::string_view text, const std::string& file) {
  try {
    if (text.size() > kMaxJsonBytes) {
      fail_at("", "more than " + std::to_string(kMaxJsonBytes) + " bytes",
              "split the grasp file; larger ones are not read");
    }
    StreamedGrasp reader;
    return reader.finish(
        parse_json(text, {{{"contacts"}, [&](std::size_t index, const JsonNode& contact) {
                             reader.add_contact(index, contact);
                           }}}));
  } catch (const InputError& error) {
    throw error.in_file(file);
  }
}

GraspFile read_grasp_file(const std::string& path) {
  InputFile file(path, "a grasp file");
  return parse_grasp(read_all(file.stream(), file.name()), file.name());
}

std::string write_grasp(const LoadedGrasp& content) {
  return write_grasp_file({content});
}

std::string write_grasp_file(const GraspFile& file) {
  const Grasp& grasp = file.content.grasp;
  const std::vector<Polygon>& outline = grasp.description().outline;
  const std::optional<Units>& units = grasp.description().units;
  const bool version1 = file.cases.empty() && outline.empty() && !units;
  const char* format = version1 ? kVersion1 : kVersion2;
  std::string text = std::string("{\"format\": \"") + format + "\",\n";
  if (!grasp.name().empty()) text += " \"name\": " + json_string(grasp.name(), "name") + ",\n";
  if (units) {
    text += " \"units\": {\"length\": " + json_string(units->length, "units") +
            ", \"force\": " + json_string(units->force, "units") + "},\n";
  }
  if (!outline.empty()) {
    text += " \"outline\": " + write_list(outline, ",\n  ", write_polygon) + ",\n";
  }
  text += " \"contacts\": [";
  const char* separator = "\n";
  const std::vector<ContactId>& assumed = file.assumed_stiffness;
  for (std::size_t i = 0; i < grasp.size(); ++i) {
    const Contact& c = grasp.contacts()[i];
    const bool given = !std::binary_search(assumed.begin(), assumed.end(), ContactId(i));
    text += separator;
    text += "  {\"position\": " + write_numbers({&c.position.x, &c.position.y}) +
            ", \"normal\": " + write_numbers({&c.normal.x, &c.normal.y}) +
            ", \"friction\": " + write_number(c.friction) +
            (given ? ", \"stiffness\": " + write_number(c.stiffness) : "") +
            ", \"preload\": " + write_number(c.preload) + "}";
    separator = ",\n";
  }
  const Wrench& common = file.content.wrench;
  text += "],\n \"wrench\": " + write_wrench(common);
  separator = ",\n \"cases\": [\n";
  for (const NamedLoad& load : file.cases) {
    text += separator;
    text += "  {\"name\": " + json_string(load.name, "name") +
            ", \"wrench\": " + write_wrench(load.wrench + Rational(-1) * common) + "}";
    separator = ",\n";
  }
  return text + (file.cases.empty() ? "}\n" : "]}\n");
}

}  // namespace stickslip
