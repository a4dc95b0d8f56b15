// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "stickslip/core/error.hpp"

namespace stickslip::core_detail {
namespace {

using Kind = JsonNode::Kind;

/// The form in which loads are written.
struct LoadForms {
  std::size_t coordinates;  ///< the coordinates of a point
  std::size_t components;   ///< the components of a wrench
  const char* point;
  const char* point_in_words;
  const char* wrench;
  const char* direction;
  const char* torque;
};

constexpr LoadForms kPlanar{2,
                            3,
                            "[x, y]",
                            "an array of two numbers [x, y]",
                            "an array of three numbers [force x, force y, torque]",
                            "give a direction of rational length, such as [3, -4]; or a "
                            "\"force\" in place of the weight",
                            "t"};
constexpr LoadForms kSpatial{
    3,
    6,
    "[x, y, z]",
    "an array of three numbers [x, y, z]",
    "an array of six numbers [force x, y, z, torque x, y, z]",
    "give a direction of rational length, such as [2, 1, -2]; or a \"force\" in place of the "
    "weight",
    "[x, y, z]"};

const LoadForms& forms(bool in_space) {
  return in_space ? kSpatial : kPlanar;
}

RationalRow read_coordinates(const JsonNode& object, const std::string& path, const char* key,
                             const LoadForms& forms) {
  const std::string remedy = std::string("add \"") + key + "\": " + forms.point;
  const JsonNode& node = member(object, path, key, remedy.c_str());
  return read_vector(node, member_path(path, key), forms.coordinates, forms.point_in_words);
}

/// Returns the acceleration of masses where a file gives none: 9.81 downwards.
RationalRow standard_gravity(std::size_t coordinates) {
  RationalRow g(coordinates);
  g.back() = Rational(-981, 100);
  return g;
}

/// Returns the force of a mass.
RationalRow read_mass(const JsonNode& load, const std::string& path, const LoadForms& forms,
                      const RationalRow& gravity) {
  const std::string place = member_path(path, "mass");
  const Rational mass = read_number(*load.find("mass"), place);
  if (mass.sign() < 0) {
    fail_at(place, "the value is " + to_string(mass),
            std::string("a mass is 0 or more; \"gravity\": ") + forms.point +
                " of the file says which way all of them are pulled");
  }
  RationalRow force = gravity.empty() ? standard_gravity(forms.coordinates) : gravity;
  for (Rational& entry : force) entry *= mass;
  return force;
}

/// Returns the force of a weight. It pulls along its direction, else along the file's gravity,
/// else along the last axis, downwards.
RationalRow read_weight(const JsonNode& load, const std::string& path, const LoadForms& forms,
                        const RationalRow& gravity) {
  const std::string place = member_path(path, "weight");
  const Rational weight = read_number(*load.find("weight"), place);
  if (weight.sign() < 0) {
    fail_at(place, "the value is " + to_string(weight),
            std::string("a weight is a force of 0 or more; \"direction\": ") + forms.point +
                " says where it pulls");
  }
  RationalRow d = gravity;
  if (gravity.empty()) {
    d.resize(forms.coordinates);
    d.back() = -1;
  }
  if (load.find("direction") != nullptr) d = read_coordinates(load, path, "direction", forms);
  const std::optional<Rational> length = exact_sqrt(dot(d, d));
  if (!length || length->is_zero()) {
    fail_at(member_path(path, "direction"),
            std::string("its length is ") + (length ? "0" : "irrational") +
                (load.find("direction") != nullptr ? "" : ", as it is that of \"gravity\""),
            forms.direction);
  }
  for (Rational& entry : d) entry *= weight / *length;
  return d;
}

RationalRow read_one_load(const JsonNode& load, const std::string& path, const LoadForms& forms,
                          const LoadSpace& space) {
  const auto allow = [&](std::vector<std::string> members) {
    if (space.mechanism != nullptr) members.insert(members.begin(), "body");
    expect_object(load, path, members);
  };
  const std::string point = forms.point;
  const std::string example = "{\"force\": " + point + ", \"at\": " + point + "}";
  expect(load, Kind::kObject, path, ("an object such as " + example).c_str());
  if (const JsonNode* torque = load.find("torque")) {
    allow({"torque"});
    RationalRow turn = forms.coordinates == 2
                           ? RationalRow{read_number(*torque, member_path(path, "torque"))}
                           : read_coordinates(load, path, "torque", forms);
    turn.insert(turn.begin(), forms.coordinates, 0);
    return turn;
  }
  if (load.find("weight") != nullptr) {
    allow({"weight", "at", "direction"});
    const RationalRow at = read_coordinates(load, path, "at", forms);
    return wrench_at(at, read_weight(load, path, forms, space.gravity));
  }
  if (load.find("mass") != nullptr) {
    allow({"mass", "at"});
    const RationalRow at = read_coordinates(load, path, "at", forms);
    return wrench_at(at, read_mass(load, path, forms, space.gravity));
  }
  if (load.find("force") != nullptr) {
    allow({"force", "at"});
    const RationalRow at = read_coordinates(load, path, "at", forms);
    return wrench_at(at, read_coordinates(load, path, "force", forms));
  }
  allow({"force", "at", "torque", "weight", "direction", "mass"});
  fail_at(path, "found " + describe(load) + " that is no load",
          "give " + example + ", {\"torque\": " + forms.torque +
              "}, {\"weight\": w, \"at\": " + point + "} or {\"mass\": m, \"at\": " + point +
              "}");
}

void add(WrenchBox& sum, std::size_t component, const Interval& interval) {
  sum[component].low += interval.low;
  sum[component].high += interval.high;
}

/// Adds a load on one of several bodies to a generalised force.
void add_load(WrenchBox& sum, const JsonNode& load, const std::string& path,
              const LoadSpace& space, IntervalReader& read) {
  const Mechanism& mechanism = *space.mechanism;
  const LoadForms& written = forms(mechanism.in_space);
  expect(load, Kind::kObject, path,
         "an object such as {\"body\": \"box\", \"weight\": 1, \"at\": ...}");
  const JsonNode& name = member(load, path, "body", "add \"body\": \"...\", which it pulls at");
  const std::string place = member_path(path, "body");
  expect(name, Kind::kString, place, "the name of a body");
  const std::size_t body = mechanism.body_named(name.text, place);
  if (const JsonNode* wrench = load.find("wrench")) {
    expect_object(load, path, {"body", "wrench"});
    if (mechanism.bodies[body].link) {
      fail_at(member_path(path, "wrench"), quote(name.text) + " is a link",
              "give {\"force\": ..., \"at\": ...} or {\"torque\": ...}; a wrench is for a body "
              "that is "
              "on no hinge or slide");
    }
    const WrenchBox numbers =
        read.numbers(*wrench, member_path(path, "wrench"), written.components, written.wrench);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      add(sum, mechanism.first_coordinate(body) + k, numbers[k]);
    }
    return;
  }
  const RationalRow force = read_one_load(load, path, written, space);
  for (const auto& [j, component] : mechanism.load_on(body, force)) {
    add(sum, j, point_interval(component));
  }
}

std::string read_case_name(const JsonNode& entry, const std::string& path,
                           std::set<std::string>& names) {
  const JsonNode& name = member(entry, path, "name", "add \"name\": \"...\"");
  const std::string place = member_path(path, "name");
  expect(name, Kind::kString, place, "a string");
  if (name.text.empty())
    fail_at(place, "the name is empty", "who asks about the case has to name it");
  if (!names.insert(name.text).second) {
    fail_at(place, "the name " + quote(name.text) + " appears twice",
            "give each case a name of its own");
  }
  return name.text;
}

/// Calls `visit` for each load of the file and of its cases.
void for_each_load(const JsonNode& root, const std::function<void(const JsonNode&)>& visit) {
  const auto visit_loads_of = [&](const JsonNode& object) {
    const JsonNode* loads = object.find("loads");
    if (loads == nullptr) return;
    for (const JsonNode& load : loads->children) visit(load);
  };
  visit_loads_of(root);
  const JsonNode* cases = root.find("cases");
  if (cases == nullptr) return;
  for (const JsonNode& one : cases->children) visit_loads_of(one);
}

}  // namespace

RationalRow read_gravity(const JsonNode& root, bool in_space) {
  if (root.find("gravity") == nullptr) return {};
  return read_coordinates(root, "", "gravity", forms(in_space));
}

RationalRow gravity_of_masses(const JsonNode& root, const LoadSpace& space) {
  bool any = false;
  for_each_load(root, [&](const JsonNode& load) { any |= load.find("mass") != nullptr; });
  if (!any || !space.gravity.empty()) return any ? space.gravity : RationalRow{};
  return standard_gravity(forms(space.in_space).coordinates);
}

bool is_uncertain(const WrenchBox& wrench) {
  return std::any_of(wrench.begin(), wrench.end(),
                     [](const Interval& component) { return !component.is_point(); });
}

std::optional<WrenchBox> read_load(const JsonNode& object, const std::string& path,
                                   const LoadSpace& space, IntervalReader& read) {
  const LoadForms& written = forms(space.in_space);
  const JsonNode* wrench = object.find("wrench");
  const JsonNode* loads = object.find("loads");
  if (wrench != nullptr && loads != nullptr) {
    fail_at(path, "found both \"wrench\" and \"loads\"", "give one of them");
  }
  if (wrench != nullptr) {
    if (space.mechanism == nullptr) {
      return read.numbers(*wrench, member_path(path, "wrench"), written.components,
                          written.wrench);
    }
    const std::size_t count = space.mechanism->coordinates();
    return read.numbers(*wrench, member_path(path, "wrench"), count,
                        ("an array of " + std::to_string(count) +
                         " numbers, a force for each coordinate of bodies and joints")
                            .c_str());
  }
  if (loads == nullptr) return std::nullopt;
  const std::string place = member_path(path, "loads");
  expect(*loads, Kind::kArray, place, "an array of loads [{...}, ...]");
  WrenchBox sum(space.components());
  for (std::size_t i = 0; i < loads->children.size(); ++i) {
    const std::string one = element_path(place, i);
    if (space.mechanism != nullptr) {
      add_load(sum, loads->children[i], one, space, read);
      continue;
    }
    const RationalRow load = read_one_load(loads->children[i], one, written, space);
    for (std::size_t j = 0; j < sum.size(); ++j) add(sum, j, point_interval(load[j]));
  }
  return sum;
}

std::vector<ReadCase> read_cases(const JsonNode& root, const WrenchBox& common,
                                 const LoadSpace& space, IntervalReader& read) {
  const JsonNode* node = root.find("cases");
  if (node == nullptr) return {};
  expect(*node, Kind::kArray, "cases", "an array of cases [{\"name\": ...}, ...]");
  if (node->children.empty()) fail_at("cases", "the list is empty", "give a case, or no list");
  std::vector<ReadCase> cases;
  std::set<std::string> names;
  for (const JsonNode& entry : node->children) {
    const std::string path = element_path("cases", cases.size());
    expect_object(entry, path, {"name", "wrench", "loads"});
    std::string name = read_case_name(entry, path, names);
    std::optional<WrenchBox> load = read_load(entry, path, space, read);
    if (!load) {
      fail_at(path, "neither \"wrench\" nor \"loads\" is there",
              "add one of them; \"loads\": [] adds nothing to what is common to all cases");
    }
    for (std::size_t j = 0; j < common.size(); ++j) add(*load, j, common[j]);
    cases.push_back({std::move(name), std::move(*load)});
  }
  return cases;
}

std::vector<std::pair<std::size_t, RationalRow>> weight_points(const JsonNode& root,
                                                               const Mechanism& mechanism) {
  std::vector<std::pair<std::size_t, RationalRow>> points;
  for_each_load(root, [&](const JsonNode& load) {
    if (load.find("weight") == nullptr && load.find("mass") == nullptr) return;
    points.emplace_back(mechanism.body_named(load.find("body")->text, "body"),
                        read_coordinates(load, "", "at", forms(mechanism.in_space)));
  });
  return points;
}

}  // namespace stickslip::core_detail
