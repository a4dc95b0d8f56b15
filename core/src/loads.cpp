// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads.hpp"

#include <algorithm>
#include <set>

#include "stickslip/core/error.hpp"

namespace stickslip::core_detail {
namespace {

using Kind = JsonNode::Kind;

/// How loads are written, in the plane (n = 2) and in space.
template <std::size_t n>
struct LoadForms {
  static constexpr bool kPlanar = n == 2;
  static constexpr const char* kPoint = kPlanar ? "[x, y]" : "[x, y, z]";
  static constexpr const char* kPointInWords =
      kPlanar ? "an array of two numbers [x, y]" : "an array of three numbers [x, y, z]";
  static constexpr const char* kWrench =
      kPlanar ? "an array of three numbers [force x, force y, torque]"
              : "an array of six numbers [force x, y, z, torque x, y, z]";
  static constexpr const char* kDirection =
      kPlanar
          ? "give a direction of rational length, such as [3, -4]; or a \"force\" in place of "
            "the weight"
          : "give a direction of rational length, such as [2, 1, -2]; or a \"force\" in place "
            "of the weight";
  static constexpr const char* kTorque = kPlanar ? "t" : "[x, y, z]";
};

template <std::size_t n>
using Coordinates = std::array<Rational, n>;
template <std::size_t n>
using Load = std::array<Rational, n == 2 ? 3 : 6>;

template <std::size_t n>
Coordinates<n> read_coordinates(const JsonNode& object, const std::string& path,
                                const char* key) {
  const std::string remedy = std::string("add \"") + key + "\": " + LoadForms<n>::kPoint;
  const JsonNode& node = member(object, path, key, remedy.c_str());
  const std::vector<Rational> v =
      read_vector(node, member_path(path, key), n, LoadForms<n>::kPointInWords);
  Coordinates<n> result;
  std::copy(v.begin(), v.end(), result.begin());
  return result;
}

Load<2> force_at(const Coordinates<2>& f, const Coordinates<2>& p) {
  return {f[0], f[1], p[0] * f[1] - p[1] * f[0]};
}

Load<3> force_at(const Coordinates<3>& f, const Coordinates<3>& p) {
  const Coordinates<3> torque = cross(p, f);
  return {f[0], f[1], f[2], torque[0], torque[1], torque[2]};
}

/// Along the last axis, downwards, unless it has a direction of its own.
template <std::size_t n>
Coordinates<n> read_weight(const JsonNode& load, const std::string& path) {
  const std::string place = member_path(path, "weight");
  const Rational weight = read_number(*load.find("weight"), place);
  if (weight.sign() < 0) {
    fail_at(place, "the value is " + to_string(weight),
            std::string("a weight is a force of 0 or more; \"direction\": ") +
                LoadForms<n>::kPoint + " says where it pulls");
  }
  Coordinates<n> d{};
  d[n - 1] = -1;
  if (load.find("direction") != nullptr) d = read_coordinates<n>(load, path, "direction");
  const std::optional<Rational> length = exact_sqrt(dot(d, d));
  if (!length || length->is_zero()) {
    fail_at(member_path(path, "direction"),
            std::string("its length is ") + (length ? "0" : "irrational"),
            LoadForms<n>::kDirection);
  }
  for (Rational& entry : d) entry *= weight / *length;
  return d;
}

template <std::size_t n>
Load<n> read_one_load(const JsonNode& load, const std::string& path) {
  const std::string point = LoadForms<n>::kPoint;
  const std::string example = "{\"force\": " + point + ", \"at\": " + point + "}";
  expect(load, Kind::kObject, path, ("an object such as " + example).c_str());
  if (const JsonNode* torque = load.find("torque")) {
    expect_object(load, path, {"torque"});
    Load<n> result{};
    if constexpr (n == 2) {
      result[2] = read_number(*torque, member_path(path, "torque"));
    } else {
      const Coordinates<n> t = read_coordinates<n>(load, path, "torque");
      std::copy(t.begin(), t.end(), result.begin() + n);
    }
    return result;
  }
  if (load.find("weight") != nullptr) {
    expect_object(load, path, {"weight", "at", "direction"});
    return force_at(read_weight<n>(load, path), read_coordinates<n>(load, path, "at"));
  }
  if (load.find("force") != nullptr) {
    expect_object(load, path, {"force", "at"});
    return force_at(read_coordinates<n>(load, path, "force"),
                    read_coordinates<n>(load, path, "at"));
  }
  expect_object(load, path, {"force", "at", "torque", "weight", "direction"});
  fail_at(path, "found " + describe(load) + " that is no load",
          "give " + example + ", {\"torque\": " + LoadForms<n>::kTorque +
              "} or {\"weight\": w, \"at\": " + point + "}");
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

template <std::size_t n>
std::optional<LoadBox<n>> read_load(const JsonNode& object, const std::string& path,
                                    IntervalReader& read) {
  LoadBox<n> sum{};
  const JsonNode* wrench = object.find("wrench");
  const JsonNode* loads = object.find("loads");
  if (wrench != nullptr && loads != nullptr) {
    fail_at(path, "found both \"wrench\" and \"loads\"", "give one of them");
  }
  if (wrench != nullptr) {
    const std::vector<Interval> v =
        read.numbers(*wrench, member_path(path, "wrench"), sum.size(), LoadForms<n>::kWrench);
    std::copy(v.begin(), v.end(), sum.begin());
    return sum;
  }
  if (loads == nullptr) return std::nullopt;
  const std::string place = member_path(path, "loads");
  expect(*loads, Kind::kArray, place, "an array of loads [{...}, ...]");
  for (std::size_t i = 0; i < loads->children.size(); ++i) {
    const Load<n> load = read_one_load<n>(loads->children[i], element_path(place, i));
    for (std::size_t j = 0; j < sum.size(); ++j) {
      sum[j] = point_interval(Rational(sum[j].low + load[j]));
    }
  }
  return sum;
}

template <std::size_t n>
std::vector<ReadCase<n>> read_cases(const JsonNode& root, const LoadBox<n>& common,
                                    IntervalReader& read) {
  const JsonNode* node = root.find("cases");
  if (node == nullptr) return {};
  expect(*node, Kind::kArray, "cases", "an array of cases [{\"name\": ...}, ...]");
  if (node->children.empty()) fail_at("cases", "the list is empty", "give a case, or no list");
  std::vector<ReadCase<n>> cases;
  std::set<std::string> names;
  for (const JsonNode& entry : node->children) {
    const std::string path = element_path("cases", cases.size());
    expect_object(entry, path, {"name", "wrench", "loads"});
    std::string name = read_case_name(entry, path, names);
    std::optional<LoadBox<n>> load = read_load<n>(entry, path, read);
    if (!load) {
      fail_at(path, "neither \"wrench\" nor \"loads\" is there",
              "add one of them; \"loads\": [] adds nothing to what is common to all cases");
    }
    for (std::size_t j = 0; j < common.size(); ++j) {
      (*load)[j].low += common[j].low;
      (*load)[j].high += common[j].high;
    }
    cases.push_back({std::move(name), std::move(*load)});
  }
  return cases;
}

template std::optional<LoadBox<2>> read_load<2>(const JsonNode&, const std::string&,
                                                IntervalReader&);
template std::optional<LoadBox<3>> read_load<3>(const JsonNode&, const std::string&,
                                                IntervalReader&);
template std::vector<ReadCase<2>> read_cases<2>(const JsonNode&, const LoadBox<2>&,
                                                IntervalReader&);
template std::vector<ReadCase<3>> read_cases<3>(const JsonNode&, const LoadBox<3>&,
                                                IntervalReader&);

}  // namespace stickslip::core_detail
