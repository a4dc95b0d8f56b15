// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads.hpp"

#include <algorithm>
#include <set>

#include "stickslip/core/error.hpp"

namespace stickslip::core_detail {
namespace {

using Kind = JsonNode::Kind;

Vector2 read_pair(const JsonNode& object, const std::string& path, const char* key) {
  const std::string remedy = std::string("add \"") + key + "\": [x, y]";
  const JsonNode& node = member(object, path, key, remedy.c_str());
  const std::vector<Rational> v =
      read_vector(node, member_path(path, key), 2, "an array of two numbers [x, y]");
  return {v[0], v[1]};
}

Wrench force_at(const Vector2& force, const Vector2& point) {
  return {force.x, force.y, point.x * force.y - point.y * force.x};
}

/// Along -y unless it has a direction of its own.
Vector2 read_weight(const JsonNode& load, const std::string& path) {
  const std::string place = member_path(path, "weight");
  const Rational weight = read_number(*load.find("weight"), place);
  if (weight.sign() < 0) {
    fail_at(place, "the value is " + to_string(weight),
            "a weight is a force of 0 or more; \"direction\": [x, y] says where it pulls");
  }
  if (load.find("direction") == nullptr) return {0, -weight};
  const Vector2 d = read_pair(load, path, "direction");
  const std::optional<Rational> length = exact_sqrt(d.x * d.x + d.y * d.y);
  if (!length || length->is_zero()) {
    fail_at(member_path(path, "direction"),
            std::string("its length is ") + (length ? "0" : "irrational"),
            "give a direction of rational length, such as [3, -4]; or a \"force\" in place of "
            "the weight");
  }
  return {weight * d.x / *length, weight * d.y / *length};
}

Wrench read_one_load(const JsonNode& load, const std::string& path) {
  expect(load, Kind::kObject, path, "an object such as {\"force\": [x, y], \"at\": [x, y]}");
  if (const JsonNode* torque = load.find("torque")) {
    expect_object(load, path, {"torque"});
    return {0, 0, read_number(*torque, member_path(path, "torque"))};
  }
  if (load.find("weight") != nullptr) {
    expect_object(load, path, {"weight", "at", "direction"});
    return force_at(read_weight(load, path), read_pair(load, path, "at"));
  }
  if (load.find("force") != nullptr) {
    expect_object(load, path, {"force", "at"});
    return force_at(read_pair(load, path, "force"), read_pair(load, path, "at"));
  }
  expect_object(load, path, {"force", "at", "torque", "weight", "direction"});
  fail_at(
      path, "found " + describe(load) + " that is no load",
      R"(give {"force": [x, y], "at": [x, y]}, {"torque": t} or {"weight": w, "at": [x, y]})");
}

std::string read_case_name(const JsonNode& entry, const std::string& path,
                           std::set<std::string>& names) {
  const JsonNode& name = member(entry, path, "name", "add \"name\": \"...\"");
  const std::string place = member_path(path, "name");
  expect(name, Kind::kString, place, "a string");
  if (name.text.empty()) fail_at(place, "the name is empty", "--case has to name it");
  if (!names.insert(name.text).second) {
    fail_at(place, "the name " + quote(name.text) + " appears twice",
            "give each case a name of its own");
  }
  return name.text;
}

}  // namespace

bool is_uncertain(const WrenchBox& wrench) {
  return std::any_of(wrench.begin(), wrench.end(),
                     [](const Interval& component) { return !component.is_point(); });
}

std::optional<WrenchBox> read_load(const JsonNode& object, const std::string& path,
                                   IntervalReader& read) {
  const JsonNode* wrench = object.find("wrench");
  const JsonNode* loads = object.find("loads");
  if (wrench != nullptr && loads != nullptr) {
    fail_at(path, "found both \"wrench\" and \"loads\"", "give one of them");
  }
  if (wrench != nullptr) {
    const std::vector<Interval> v =
        read.numbers(*wrench, member_path(path, "wrench"), 3,
                     "an array of three numbers [force x, force y, torque]");
    return WrenchBox{v[0], v[1], v[2]};
  }
  if (loads == nullptr) return std::nullopt;
  const std::string place = member_path(path, "loads");
  expect(*loads, Kind::kArray, place, "an array of loads [{...}, ...]");
  Wrench sum;
  for (std::size_t i = 0; i < loads->children.size(); ++i) {
    sum += read_one_load(loads->children[i], element_path(place, i));
  }
  return box_of(sum);
}

std::vector<NamedLoad> read_cases(const JsonNode& root, const WrenchBox& common,
                                  IntervalReader& read) {
  const JsonNode* node = root.find("cases");
  if (node == nullptr) return {};
  expect(*node, Kind::kArray, "cases", "an array of cases [{\"name\": ...}, ...]");
  if (node->children.empty()) fail_at("cases", "the list is empty", "give a case, or no list");
  std::vector<NamedLoad> cases;
  std::set<std::string> names;
  for (const JsonNode& entry : node->children) {
    const std::string path = element_path("cases", cases.size());
    expect_object(entry, path, {"name", "wrench", "loads"});
    std::string name = read_case_name(entry, path, names);
    std::optional<WrenchBox> load = read_load(entry, path, read);
    if (!load) {
      fail_at(path, "neither \"wrench\" nor \"loads\" is there",
              "add one of them; \"loads\": [] adds nothing to what is common to all cases");
    }
    for (std::size_t j = 0; j < common.size(); ++j) {
      (*load)[j].low += common[j].low;
      (*load)[j].high += common[j].high;
    }
    const Wrench wrench = middle(*load);
    if (!is_uncertain(*load)) load.reset();
    cases.push_back({std::move(name), wrench, std::move(load)});
  }
  return cases;
}

}  // namespace stickslip::core_detail
