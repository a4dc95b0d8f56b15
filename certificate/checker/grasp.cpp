// SPDX-License-Identifier: MIT
#include "grasp.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "answer.hpp"
#include "json.hpp"

namespace stickslip_check {
namespace {

constexpr JsonLimits kLimits{std::uint64_t{1} << 28U, 32, std::uint64_t{1} << 28U, 1U << 16U,
                             true};
constexpr std::size_t kMaxContacts = 1'000'000;

using Names = std::vector<std::string>;
using Properties = std::map<std::string, Rational>;  // friction, stiffness, preload

class GraspReader {
 public:
  GraspReader(std::istream& in, const std::string& file) : json_(in, file, kLimits) {}

  Grasp read() {
    Names seen;
    while (const std::optional<std::string> key = json_.next_member()) {
      allow(*key, {"format", "name", "defaults", "contacts", "wrench", "loads", "cases"}, "",
            json_.line());
      seen.push_back(*key);
      if (*key == "contacts") {
        while (json_.next_element()) read_contact(json_.value());
      } else {
        read_member(*key, json_.value());
      }
    }
    const auto has = [&](const char* key) {
      return std::find(seen.begin(), seen.end(), key) != seen.end();
    };
    const auto check = [&](bool good, const std::string& problem) {
      if (!good) throw Malformed{json_.file(), "top level", problem};
    };
    for (const char* key : {"format", "contacts"}) {
      check(has(key), std::string("the member \"") + key + "\" is missing");
    }
    for (const char* key : {"loads", "cases"}) {
      check(version2_ || !has(key),
            std::string("the member \"") + key + "\" needs \"format\": \"stickslip-grasp/2\"");
    }
    check(has("wrench") || has("loads") || has("cases"), "the member \"wrench\" is missing");
    check(!has("wrench") || !has("loads"), "both \"wrench\" and \"loads\"; give one of them");
    for (auto& [name, wrench] : grasp_.cases) add(wrench, grasp_.wrench);
    for (std::size_t i = 0; i < own_.size(); ++i) complete(i);
    return std::move(grasp_);
  }

 private:
  void read_member(const std::string& key, const Value& value) {
    if (key == "format") {
      version2_ = value.is_text("stickslip-grasp/2");
      json_.expect(version2_ || value.is_text("stickslip-grasp/1"), value, key,
                   "\"stickslip-grasp/1\" or \"stickslip-grasp/2\"");
    } else if (key == "name") {
      json_.expect(value.kind == Value::Kind::kString, value, key, "a string");
    } else if (key == "wrench") {
      grasp_.wrench = vector(value, key, 3);
    } else if (key == "loads") {
      grasp_.wrench = sum_of_loads(value, key);
    } else if (key == "cases") {
      read_cases(value);
    } else {
      expect_object(value, key, {"friction", "stiffness", "preload"});
      defaults_ = properties(value, key);
    }
  }

  static void add(Vector& sum, const Vector& term) {
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += term[j];
  }

  void read_cases(const Value& value) {
    json_.expect(value.kind == Value::Kind::kArray && !value.items.empty(), value, "cases",
                 "an array of one case or more");
    for (std::size_t k = 0; k < value.items.size(); ++k) {
      const Value& entry = value.items[k];
      const std::string place = "cases[" + std::to_string(k) + "]";
      expect_object(entry, place, {"name", "wrench", "loads"});
      const Value& name = member(entry, place, "name");
      json_.expect(name.kind == Value::Kind::kString && !name.text.empty(), name,
                   place + ".name", "a string that is not empty");
      const Value* wrench = entry.find("wrench");
      const Value* loads = entry.find("loads");
      if ((wrench == nullptr) == (loads == nullptr)) {
        json_.fail(entry.line, place, R"(expected one of the members "wrench" and "loads")");
      }
      Vector own = wrench != nullptr ? vector(*wrench, place + ".wrench", 3)
                                     : sum_of_loads(*loads, place + ".loads");
      if (!grasp_.cases.emplace(name.text, std::move(own)).second) {
        json_.fail(name.line, place, "the name " + quote(name.text) + " appears twice");
      }
    }
  }

  Vector sum_of_loads(const Value& value, const std::string& place) const {
    json_.expect(value.kind == Value::Kind::kArray, value, place, "an array of loads");
    Vector sum(3);
    for (std::size_t k = 0; k < value.items.size(); ++k) {
      add(sum, load(value.items[k], place + "[" + std::to_string(k) + "]"));
    }
    return sum;
  }

  /// The wrench of a force at a point, of a torque or of a weight.
  Vector load(const Value& value, const std::string& place) const {
    if (const Value* torque = value.find("torque")) {
      expect_object(value, place, {"torque"});
      return {0, 0, number(*torque, place + ".torque")};
    }
    Vector force;
    if (const Value* weight = value.find("weight")) {
      expect_object(value, place, {"weight", "at", "direction"});
      force = pull(value, *weight, place);
    } else {
      expect_object(value, place, {"force", "at"});
      force = vector(member(value, place, "force"), place + ".force", 2);
    }
    const Vector at = vector(member(value, place, "at"), place + ".at", 2);
    return {force[0], force[1], Rational(at[0] * force[1] - at[1] * force[0])};
  }

  Vector pull(const Value& load, const Value& weight, const std::string& place) const {
    const Rational size = number(weight, place + ".weight");
    json_.expect(size >= 0, weight, place + ".weight", "a number of 0 or more");
    const Value* direction = load.find("direction");
    if (direction == nullptr) return {0, Rational(-size)};
    const Vector d = vector(*direction, place + ".direction", 2);
    const std::optional<Rational> length = exact_sqrt(dot(d, d));
    json_.expect(length && *length > 0, *direction, place + ".direction",
                 "a vector of rational length, not 0, such as [3, -4]");
    return {Rational(size * d[0] / *length), Rational(size * d[1] / *length)};
  }

  void read_contact(const Value& value) {
    const std::string place = "contacts[" + std::to_string(own_.size()) + "]";
    if (own_.size() == kMaxContacts) json_.fail(value.line, "contacts", "too many contacts");
    expect_object(value, place, {"position", "normal", "friction", "stiffness", "preload"});
    Contact contact;
    contact.position = vector(member(value, place, "position"), place + ".position", 2);
    contact.normal = vector(member(value, place, "normal"), place + ".normal", 2);
    if (contact.normal == Vector(2)) {
      json_.fail(value.line, place + ".normal",
                 "the normal is (0, 0); give a vector into the object");
    }
    grasp_.contacts.push_back(std::move(contact));
    own_.push_back(properties(value, place));
  }

  /// What a contact does not say itself, defaults say, and else 1 and 0.
  void complete(std::size_t i) {
    Properties all = std::move(own_[i]);
    all.insert(defaults_.begin(), defaults_.end());
    all.insert({{"stiffness", 1}, {"preload", 0}});
    if (all.count("friction") == 0) {
      throw Malformed{json_.file(), "contacts[" + std::to_string(i) + "]",
                      "the member \"friction\" is missing, and \"defaults\" has none"};
    }
    Contact& contact = grasp_.contacts[i];
    contact.friction = all["friction"];
    contact.stiffness = all["stiffness"];
    contact.preload = all["preload"];
  }

  void allow(const std::string& key, const Names& names, const std::string& place,
             std::size_t line) const {
    if (std::find(names.begin(), names.end(), key) != names.end()) return;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    const bool snapping = key == "normals" && place.empty();
    json_.fail(line, place,
               "unknown member " + quote(key) + "; known here are " + list +
                   (snapping ? "; to snap normals, run: stickslip snap GRASP -o FILE" : ""));
  }

  void expect_object(const Value& value, const std::string& place, const Names& names) const {
    json_.expect(value.kind == Value::Kind::kObject, value, place, "an object {...}");
    for (const std::string& key : value.keys) allow(key, names, place, value.line);
  }

  const Value& member(const Value& object, const std::string& place, const char* key) const {
    const Value* value = object.find(key);
    if (value == nullptr) {
      json_.fail(object.line, place, std::string("the member \"") + key + "\" is missing");
    }
    return *value;
  }

  Rational number(const Value& value, const std::string& place) const {
    std::optional<Rational> read;
    if (value.kind == Value::Kind::kNumber || value.kind == Value::Kind::kString) {
      read = parse_decimal(value.text);
    }
    json_.expect(read.has_value(), value, place,
                 "a number such as 0.25 or 1e-3, or a string as \"3/5\"");
    // What rounds to 2^16384 with a mantissa of 64 bits (docs/grasp_file.md).
    static const Integer kBeyond = (Integer(1) << 16384) - (Integer(1) << 16319);
    json_.expect(value.kind == Value::Kind::kString || abs(*read) < kBeyond, value, place,
                 "a number below 2^16384; a string spells larger ones");
    return *read;
  }

  Vector vector(const Value& value, const std::string& place, std::size_t size) const {
    json_.expect(value.is_array(size), value, place,
                 size == 2 ? "an array [x, y]" : "an array [force x, force y, torque]");
    Vector result;
    for (std::size_t j = 0; j < size; ++j) {
      result.push_back(number(value.items[j], place + "[" + std::to_string(j) + "]"));
    }
    return result;
  }

  Properties properties(const Value& object, const std::string& place) const {
    Properties result;
    for (const char* key : {"friction", "stiffness", "preload"}) {
      const Value* value = object.find(key);
      if (value == nullptr) continue;
      const std::string where = place + "." + key;
      const Rational read = number(*value, where);
      const bool above = std::string(key) == "stiffness";
      if (read < 0 || (above && read == 0)) {
        json_.fail(value->line, where,
                   "found " + show(read) + ", expected a number " +
                       (above ? "above 0" : "of 0 or more"));
      }
      result.emplace(key, read);
    }
    return result;
  }

  JsonReader json_;
  Grasp grasp_{{}, Vector(3)};
  bool version2_ = false;
  std::vector<Properties> own_;
  Properties defaults_;
};

}  // namespace

Grasp read_grasp(std::istream& in, const std::string& file) {
  return GraspReader(in, file).read();
}

}  // namespace stickslip_check
