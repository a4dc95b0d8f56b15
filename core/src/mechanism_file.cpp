// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanism_file.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "outline_file.hpp"
#include "stickslip/core/error.hpp"

namespace stickslip::core_detail {
namespace {

using Kind = JsonNode::Kind;

constexpr std::size_t kMostCoordinates = 65536;  // certificate/FORMAT.md, section 14

const char* vector_form(bool in_space) {
  return in_space ? "an array of three numbers [x, y, z]" : "an array of two numbers [x, y]";
}

/// Returns the elements of a list that may be missing.
const std::vector<JsonNode>& elements_of(const JsonNode& root, const char* key) {
  static const std::vector<JsonNode> kNone;
  const JsonNode* list = root.find(key);
  if (list == nullptr) return kNone;
  expect(*list, Kind::kArray, key, "an array [{...}, ...]");
  return list->children;
}

RationalRow read_direction(const JsonNode& node, const std::string& path, bool in_space) {
  RationalRow axis = read_vector(node, path, in_space ? 3 : 2, vector_form(in_space));
  if (dot(axis, axis).is_zero()) fail_at(path, "the direction is 0", "give one that is not");
  return axis;
}

Link read_link(const JsonNode& body, const std::string& path, bool in_space,
               const Mechanism& before) {
  Link link;
  const JsonNode* hinge = body.find("hinge");
  const JsonNode* slide = body.find("slide");
  if (hinge != nullptr && slide != nullptr) {
    fail_at(path, "found both \"hinge\" and \"slide\"",
            "remove one; a link with both is two links, one on the other");
  }
  if (slide != nullptr) {
    link.slides = true;
    link.axis = read_direction(*slide, member_path(path, "slide"), in_space);
  } else {
    const std::string place = member_path(path, "hinge");
    if (in_space) {
      const char* const form = R"(write "hinge": {"at": [x, y, z], "axis": [x, y, z]})";
      expect(*hinge, Kind::kObject, place, form);
      expect_object(*hinge, place, {"at", "axis"});
      link.at = read_vector(member(*hinge, place, "at", form), member_path(place, "at"), 3,
                            vector_form(true));
      link.axis =
          read_direction(member(*hinge, place, "axis", form), member_path(place, "axis"), true);
    } else {
      link.at = read_vector(*hinge, place, 2, vector_form(false));
    }
  }
  if (const JsonNode* on = body.find("on")) {
    const std::string place = member_path(path, "on");
    expect(*on, Kind::kString, place, "the name of a body");
    if (on->text != "ground") link.on = before.body_named(on->text, place);
  }
  return link;
}

std::string read_body_name(const JsonNode& body, const std::string& path,
                           const Mechanism& before) {
  const JsonNode& name = member(body, path, "name", "add \"name\": \"...\"");
  const std::string place = member_path(path, "name");
  expect(name, Kind::kString, place, "a string");
  if (name.text.empty()) fail_at(place, "the name is empty", "contacts have to name it");
  if (name.text == "ground") {
    fail_at(place, "the name \"ground\" is that of what does not move",
            "give the body another name");
  }
  for (const Body& other : before.bodies) {
    if (other.name == name.text) {
      fail_at(place, "the name " + quote(name.text) + " appears twice",
              "give each body a name of its own");
    }
  }
  return name.text;
}

Body read_one_body(const JsonNode& node, const std::string& path, bool in_space,
                   const Mechanism& before) {
  expect(node, Kind::kObject, path, "an object {\"name\": \"...\"}");
  expect_object(node, path, {"name", "hinge", "slide", "on", in_space ? "mesh" : "outline"});
  Body body;
  body.name = read_body_name(node, path, before);
  if (node.find("hinge") != nullptr || node.find("slide") != nullptr) {
    body.link = read_link(node, path, in_space, before);
  } else if (node.find("on") != nullptr) {
    fail_at(member_path(path, "on"), "the body is on another, but how it moves is missing",
            "add a \"hinge\" or a \"slide\"; a body that lies on another has contacts by it");
  }
  if (in_space) {
    body.mesh = within(path, [&] { return read_surface(node, "mesh"); });
  } else {
    body.outline = within(path, [&] { return read_outline(node); });
  }
  return body;
}

/// Reads {"link": number, ...}, where no number is 0.
LinkRates read_rates(const JsonNode& object, const std::string& path, const char* key,
                     const Mechanism& mechanism) {
  const std::string place = member_path(path, key);
  const std::string form = std::string("write \"") + key + "\": {\"link\": 1, ...}";
  const JsonNode& node = member(object, path, key, form.c_str());
  expect(node, Kind::kObject, place, "an object {\"link\": number, ...}");
  if (node.children.empty()) fail_at(place, "no link is named", form);
  LinkRates rates;
  for (std::size_t k = 0; k < node.keys.size(); ++k) {
    const std::size_t body = mechanism.body_named(node.keys[k], place);
    if (!mechanism.bodies[body].link) {
      fail_at(place, quote(node.keys[k]) + " is no link",
              "name bodies that have a \"hinge\" or a \"slide\"");
    }
    const std::string one = member_path(place, node.keys[k]);
    Rational rate = read_number(node.children[k], one);
    if (rate.is_zero())
      fail_at(one, "the value is 0", "leave the link out, or give another number");
    rates.emplace_back(body, std::move(rate));
  }
  return rates;
}

std::string read_label(const JsonNode& object, const std::string& path) {
  const JsonNode* name = object.find("name");
  if (name == nullptr) return {};
  expect(*name, Kind::kString, member_path(path, "name"), "a string");
  return name->text;
}

Interval read_member(const JsonNode& object, const std::string& path, const char* key,
                     IntervalReader& read) {
  const JsonNode* node = object.find(key);
  return node == nullptr ? Interval{} : read.number(*node, member_path(path, key));
}

void require_row(const Spring& spring, const std::string& path) {
  const bool moves = std::any_of(spring.row.begin(), spring.row.end(),
                                 [](const Rational& entry) { return !entry.is_zero(); });
  if (moves) return;
  fail_at(member_path(path, "over"), "no joint moves it: what the links turn adds up to 0",
          "change a number, or remove it");
}

}  // namespace

Mechanism read_mechanism(const JsonNode& root, bool in_space) {
  Mechanism mechanism;
  mechanism.in_space = in_space;
  const JsonNode& bodies =
      member(root, "", "bodies", "add \"bodies\": [{\"name\": \"...\"}, ...]");
  expect(bodies, Kind::kArray, "bodies", "an array of bodies [{\"name\": \"...\"}, ...]");
  if (bodies.children.empty()) fail_at("bodies", "the list is empty", "give a body");
  for (const JsonNode& node : bodies.children) {
    const std::string path = element_path("bodies", mechanism.bodies.size());
    mechanism.bodies.push_back(read_one_body(node, path, in_space, mechanism));
  }
  std::vector<bool> turned(mechanism.bodies.size());
  for (const JsonNode& node : elements_of(root, "joints")) {
    const std::string path = element_path("joints", mechanism.joints.size());
    expect(node, Kind::kObject, path, "an object {\"turns\": {\"link\": 1}}");
    expect_object(node, path, {"name", "turns", "stiffness", "torque", "max_torque"});
    mechanism.joints.push_back(
        {read_label(node, path), read_rates(node, path, "turns", mechanism)});
    for (const auto& [body, rate] : mechanism.joints.back().turns) turned[body] = true;
  }
  for (std::size_t b = 0; b < turned.size(); ++b) {
    if (turned[b] || !mechanism.bodies[b].link) continue;
    fail_at(element_path("bodies", b),
            "no joint turns the link " + quote(mechanism.bodies[b].name),
            "add {\"turns\": {" + quote(mechanism.bodies[b].name) +
                ": 1}} to \"joints\"; one that is stiff has a large \"stiffness\"");
  }
  if (mechanism.coordinates() > kMostCoordinates) {
    fail_at("bodies",
            "bodies and joints have " + std::to_string(mechanism.coordinates()) +
                " coordinates together",
            "at most " + std::to_string(kMostCoordinates) +
                " are read: " + (in_space ? "6" : "3") +
                " for each body that is no link, and 1 for each joint");
  }
  return mechanism;
}

std::vector<Spring> read_springs(const JsonNode& root, const Mechanism& mechanism,
                                 IntervalReader& read) {
  std::vector<Spring> springs;
  const auto read_list = [&](const char* list, Spring::Kind kind, const char* force) {
    std::size_t next = 0;
    for (const JsonNode& node : elements_of(root, list)) {
      Spring spring;
      spring.kind = kind;
      spring.place = element_path(list, next);
      spring.joint = next++;
      if (kind == Spring::Kind::kJoint) {
        const JsonNode* most = node.find("max_torque");
        if (most != nullptr) {
          spring.max_torque = read_number(*most, member_path(spring.place, "max_torque"));
        } else if (node.find("stiffness") == nullptr && node.find(force) == nullptr) {
          continue;
        }
        spring.row.resize(mechanism.coordinates());
        spring.row[mechanism.joint_coordinate(spring.joint)] = 1;
      } else {
        expect(node, Kind::kObject, spring.place, "an object {\"over\": {\"link\": 1}}");
        expect_object(node, spring.place, {"name", "over", "stiffness", force});
        spring.over = read_rates(node, spring.place, "over", mechanism);
        spring.row = mechanism.row_of(spring.over);
        require_row(spring, spring.place);
      }
      if (kind == Spring::Kind::kRatchet) {
        member(node, spring.place, "stiffness", "add it: a ratchet yields, if only a little");
      }
      spring.name = read_label(node, spring.place);
      spring.stiffness = read_member(node, spring.place, "stiffness", read);
      spring.force = read_member(node, spring.place, force, read);
      springs.push_back(std::move(spring));
    }
  };
  read_list("ratchets", Spring::Kind::kRatchet, "preload");
  read_list("joints", Spring::Kind::kJoint, "torque");
  read_list("tendons", Spring::Kind::kTendon, "tension");
  return springs;
}

}  // namespace stickslip::core_detail
