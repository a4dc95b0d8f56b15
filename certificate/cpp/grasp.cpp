// SPDX-License-Identifier: MIT
#include "grasp.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include "answer.hpp"
#include "box.hpp"
#include "json.hpp"

namespace stickslip_check {
namespace {

constexpr JsonLimits kGraspLimits{std::uint64_t{1} << 28U, 32, std::uint64_t{1} << 28U,
                                  1U << 16U, true};
constexpr std::size_t kMaxContacts = 1'000'000;
constexpr const char* kNeeds2 = R"(it needs "format": "stickslip-grasp/2")";
constexpr const char* kNeeds3 = R"(it needs "format": "stickslip-grasp/3")";
constexpr const char* kGround = "ground";

/// Of the outline, in the sense of its ring.
struct Edge {
  Vector from;
  Vector to;
  Vector inwards;  ///< the normal of contacts on it
};

/// Where a value is, such as contacts[3].position: put in words only for a message. What it
/// was made from must outlive it.
class Where {
 public:
  Where(const char* name) : name_(name) {}
  Where operator+(const char* name) const { return {this, name, 0}; }
  Where operator[](std::size_t index) const { return {this, nullptr, index}; }

  operator std::string() const {
    const std::string own = name_ != nullptr ? name_ : "[" + std::to_string(index_) + "]";
    return above_ != nullptr ? std::string(*above_) + own : own;
  }

 private:
  Where(const Where* above, const char* name, std::size_t index)
      : above_(above), name_(name), index_(index) {}

  const Where* above_ = nullptr;
  const char* name_;
  std::size_t index_ = 0;
};

/// "on" of a contact.
struct Place {
  std::size_t line;
  Rational polygon;
  Rational edge;
  Rational share;
};

/// A friction by its name.
struct Named {
  std::size_t line;
  std::string text;
};

/// "of" and "by" of a contact.
struct Pair {
  std::size_t line;
  std::optional<std::string> of;
  std::string by = kGround;
};

Integer floor_of(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

/// FORMAT.md §1, *angles*: the vector that stands for this direction.
Vector direction_at(const Rational& degrees) {
  const Integer quarter = floor_of((degrees + 45) / 90);
  const Rational rest = degrees - 90 * Rational(quarter);
  Vector direction{1, 0};
  if (rest == -45) {
    direction[1] = -1;
  } else if (rest != 0) {
    static const Rational kPi = *parse_decimal("3.14159265358979323846264338328");
    const Rational x = Rational(floor_of(Rational(rest * kPi / 360) << 64)) >> 64;
    const Rational y = x * x;
    Rational cosine = 1;
    Rational sine = 1;  // over x
    for (int k = 4; k >= 0; --k) {
      cosine = 1 - y * cosine / ((2 * k + 1) * (2 * k + 2));
      sine = 1 - y * sine / ((2 * k + 2) * (2 * k + 3));
    }
    const Rational tangent = x * sine / cosine;
    const Rational t = Rational(floor_of((tangent << 32) + Rational(1, 2))) >> 32;
    const Rational over = 1 + t * t;
    direction = {Rational((1 - t * t) / over), Rational(2 * t / over)};
  }
  const unsigned long turns = mpz_fdiv_ui(quarter.get_mpz_t(), 4);
  for (unsigned long k = 0; k < turns; ++k) {
    direction = {Rational(-direction[1]), direction[0]};
  }
  return direction;
}

/// Of arrays, first elements within first elements.
std::size_t depth_of(const Value& value) {
  if (value.kind != Value::Kind::kArray) return 0;
  return 1 + (value.items.empty() ? 0 : depth_of(value.items.front()));
}

Value array_at(std::size_t line) {
  Value array;
  array.kind = Value::Kind::kArray;
  array.line = line;
  return array;
}

/// The value as the only element of an array.
Value enclosed(Value value) {
  Value array = array_at(value.line);
  array.items.push_back(std::move(value));
  return array;
}

using Names = std::initializer_list<const char*>;
/// Those that are given.
using Properties = std::array<std::optional<Bounds>, 3>;
constexpr std::array<const char*, 3> kProperties{"friction", "stiffness", "preload"};
constexpr std::uint8_t kAllOwn = 7;

class GraspReader {
 public:
  GraspReader(std::istream& in, const std::string& file) : json_(in, file, kGraspLimits) {}

  Grasp read() {
    std::vector<std::string> seen;
    std::map<std::string, Value> members;  // what the contacts decide how to read
    while (const std::optional<std::string> key = json_.next_member()) {
      allow(*key,
            {"format", "name", "units", "outline", "body", "defaults", "contacts", "wrench",
             "loads", "cases", "bodies", "joints", "tendons", "ratchets", "max_motion",
             "gravity", "friction"},
            "", json_.line());
      seen.push_back(*key);
      if (*key == "contacts") {
        while (json_.next_element()) read_contact(json_.value());
      } else if (*key == "format") {
        read_member(*key, json_.value());
      } else {
        members.emplace(*key, json_.value());
      }
    }
    const auto load = members.find("wrench");
    if (version_ == 2 && own_.empty() && load != members.end() &&
        load->second.is_array(kSpatial)) {
      put_in_space(load->second, "wrench");
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
    const auto deny = [&](bool denied, Names keys, const char* why) {
      for (const char* key : keys) {
        check(!denied || !has(key), std::string("the member \"") + key + "\": " + why);
      }
    };
    deny(version_ < 3, {"bodies", "joints", "tendons", "ratchets"}, kNeeds3);
    deny(version_ < 2,
         {"units", "outline", "body", "loads", "cases", "max_motion", "gravity", "friction"},
         kNeeds2);
    deny(version_ == 3, {"outline"}, "of several bodies each of \"bodies\" may have one");
    deny(version_ == 3, {"body"}, "of several bodies each of \"bodies\" may have a \"mesh\"");
    if (version_ == 3) check(has("bodies"), "the member \"bodies\" is missing");
    grasp_.wrench = Wrench(dimension_);
    if (version_ == 3) read_mechanism(members);
    for (const char* key : {"gravity", "friction"}) {  // before what they are for
      if (const auto found = members.find(key); found != members.end()) {
        read_member(key, std::move(found->second));
        members.erase(found);
      }
    }
    for (auto& [key, value] : members) read_member(key, std::move(value));
    const bool loaded = has("wrench") || has("loads") || has("cases");
    check(loaded || version_ == 3, "the member \"wrench\" is missing");
    check(!has("wrench") || !has("loads"), "both \"wrench\" and \"loads\"; give one of them");
    if (newer_ && version_ < 2) json_.fail(newer_->first, newer_->second, kNeeds2);
    if (limited_ && version_ < 3) json_.fail(limited_->first, limited_->second, kNeeds3);
    if (soft_ && (version_ < 3 || dimension_ == kPlanar)) {
      json_.fail(
          soft_->first, soft_->second,
          version_ < 3 ? kNeeds3 : "found one, expected none, as the grasp is in the plane");
    }
    for (auto& [name, wrench] : grasp_.cases) add(wrench, grasp_.wrench);
    for (const auto& [i, on] : places_) put_on_outline(i, on);
    for (std::size_t i = 0; i < own_.size(); ++i) complete(i);
    if (version_ == 3) {
      for (std::size_t i = 0; i < own_.size(); ++i) put_between_bodies(i);
      for (const Contact& element : others_) grasp_.contacts.push_back(element);
      grasp_.several->has_loads = has("loads") || has("wrench");
      grasp_.several->names = std::move(names_);
      grasp_.several->mechanism = std::move(mechanism_);
    } else if (!pairs_.empty()) {
      const auto& [i, pair] = *pairs_.begin();
      json_.fail(
          pair.line, "contacts[" + std::to_string(i) + "]",
          std::string(pair.of ? "the member \"of\": " : "the member \"by\": ") + kNeeds3);
    }
    return std::move(grasp_);
  }

 private:
  void read_member(const std::string& key, Value value) {
    if (key == "format") {
      version_ = 3;
      while (version_ > 0 && value.text != "stickslip-grasp/" + std::to_string(version_)) {
        --version_;
      }
      expect(value.kind == Value::Kind::kString && version_ > 0, value, key.c_str(),
             "\"stickslip-grasp/1\", \"stickslip-grasp/2\" or \"stickslip-grasp/3\"");
    } else if (key == "name") {
      expect(value.kind == Value::Kind::kString, value, key.c_str(), "a string");
    } else if (key == "wrench") {
      grasp_.wrench = uncertain_vector(value, key.c_str(), load_numbers());
    } else if (key == "loads") {
      grasp_.wrench = sum_of_loads(value, key.c_str());
    } else if (key == "cases") {
      read_cases(value);
    } else if (key == "gravity") {
      gravity_ = vector(value, key.c_str(), coordinates());
    } else if (key == "friction") {
      read_frictions(value, key.c_str());
    } else if (key == "outline") {
      expect(dimension_ == kPlanar, value, key.c_str(), "none, as the grasp is in space");
      read_outline(std::move(value), key.c_str());
    } else if (key == "body") {
      expect(dimension_ == kSpatial, value, key.c_str(), "none, as the grasp is in the plane");
      read_body(value, key.c_str());
    } else if (key == "units") {
      read_units(value);
    } else if (key == "max_motion") {
      grasp_.max_motion = read_max_motion(value, key.c_str());
    } else if (key == "defaults") {
      expect_object(value, key.c_str(),
                    {"friction", "stiffness", "preload", "torsion", "max_force"});
      std::optional<Named> name;
      defaults_ = properties(value, key.c_str(), name);
      if (name) defaults_[0] = friction_named(*name, "defaults");
      default_torsion_ = read_torsion(value, key.c_str());
      default_limit_ = read_limit(value, key.c_str(), "max_force");
    }
  }

  /// `value` shows that the grasp is.
  void put_in_space(const Value& value, const Where& place) {
    found_newer(value, place);
    dimension_ = kSpatial;
  }

  /// FORMAT.md §1, *friction by name*.
  void read_frictions(const Value& value, const Where& place) {
    expect(value.kind == Value::Kind::kObject, value, place, "an object {...}");
    for (std::size_t k = 0; k < value.keys.size(); ++k) {
      const std::string& name = value.keys[k];
      const Where member = place + ".";
      const Where where = member + name.c_str();
      expect(!begins_as_number(name), value.items[k], where,
             "a name that begins neither with a digit nor with +, - or .");
      frictions_.emplace(name, at_least(value.items[k], where, Least::kZero));
    }
  }

  static bool begins_as_number(const std::string& text) {
    return text.empty() || std::string("+-.0123456789").find(text[0]) != std::string::npos;
  }

  /// The friction that `name` stands for in the object at `place`.
  Bounds friction_named(const Named& name, const std::string& place) const {
    const auto found = frictions_.find(name.text);
    if (found == frictions_.end()) {
      json_.fail(
          name.line, place + ".friction",
          "found " + quote(name.text) + R"(, expected a number, or a name in "friction")");
    }
    return found->second;
  }

  /// They have no meaning here.
  void read_units(const Value& value) const {
    constexpr std::size_t kMostBytes = 16;
    expect_object(value, "units", {"length", "force"});
    for (const char* key : {"length", "force"}) {
      const Value& unit = member(value, "units", key);
      const bool is_unit = unit.kind == Value::Kind::kString && !unit.text.empty() &&
                           unit.text.size() <= kMostBytes;
      expect(is_unit, unit, Where("units.") + key, "a string of 1 to 16 bytes");
    }
  }

  /// FORMAT.md §1, *max motion*: B.
  Vector read_max_motion(const Value& value, const Where& place) const {
    const auto above_zero = [this](const Value& entry, const Where& where) {
      const Rational read = number(entry, where);
      expect(read > 0, entry, where, "a number above 0");
      return read;
    };
    const std::size_t size = load_numbers();
    const bool has_joints = mechanism_ && mechanism_->joints() > 0;
    if (value.kind == Value::Kind::kObject && !has_joints) {
      expect_object(value, place, {"length", "angle"});
      const Rational length = above_zero(member(value, place, "length"), place + ".length");
      const Rational angle = above_zero(member(value, place, "angle"), place + ".angle");
      return bound_of(length, angle, size, dimension_ == kSpatial);
    }
    expect(value.is_array(size), value, place,
           "an array of " + std::to_string(size) + " numbers" +
               (has_joints ? ", one for each coordinate, as there are joints"
                           : R"(, or an object {"length": ..., "angle": ...})"));
    Vector bound;
    for (std::size_t j = 0; j < size; ++j)
      bound.push_back(above_zero(value.items[j], place[j]));
    return bound;
  }

  /// FORMAT.md §1: it has no meaning here.
  void read_body(const Value& value, const Where& body) const {
    expect_object(value, body, {"vertices", "faces"});
    const Value& vertices = member(value, body, "vertices");
    const Value& faces = member(value, body, "faces");
    const Where of_vertices = body + ".vertices";
    const Where of_faces = body + ".faces";
    expect(vertices.kind == Value::Kind::kArray, vertices, of_vertices, "a list of vertices");
    const std::size_t count = vertices.items.size();
    for (std::size_t i = 0; i < count; ++i) vector(vertices.items[i], of_vertices[i], 3);
    expect(faces.kind == Value::Kind::kArray && !faces.items.empty(), faces, of_faces,
           "a list of faces, of one or more");
    for (std::size_t j = 0; j < faces.items.size(); ++j) {
      const Value& face = faces.items[j];
      const Where place = of_faces[j];
      expect(face.kind == Value::Kind::kArray && face.items.size() >= 3, face, place,
             "the numbers of three vertices or more");
      for (std::size_t k = 0; k < face.items.size(); ++k) {
        const Rational index = number(face.items[k], place[k]);
        expect(index.get_den() == 1 && index >= 0 && index < count, face.items[k], place[k],
               "the number of a vertex, counted from 0");
      }
    }
  }

  /// A list of polygons, a list of rings, or a ring.
  void read_outline(Value value, const Where& outline) {
    constexpr std::size_t kDepth = 4;
    expect(depth_of(value) > 1, value, outline, "a list of polygons [[[[x, y], ...]]]");
    while (depth_of(value) < kDepth) value = enclosed(std::move(value));
    for (const Value& polygon : value.items) {
      const Where place = outline[outline_.size()];
      expect(polygon.kind == Value::Kind::kArray && !polygon.items.empty(), polygon, place,
             "a list of rings, of one or more");
      outline_.emplace_back();
      for (std::size_t k = 0; k < polygon.items.size(); ++k) {
        read_ring(polygon.items[k], place[k], k > 0);
      }
    }
  }

  /// FORMAT.md §1: the edges, and on which side of them the body is.
  void read_ring(const Value& value, const Where& place, bool hole) {
    expect(value.kind == Value::Kind::kArray && value.items.size() >= 3, value, place,
           "a ring of three vertices [x, y] or more");
    std::vector<Vector> ring;
    for (const Value& vertex : value.items) {
      ring.push_back(vector(vertex, place[ring.size()], 2));
    }
    Rational area;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector& to = ring[(i + 1) % ring.size()];
      if (ring[i] == to) {
        json_.fail(value.line, place,
                   "vertex " + std::to_string(i) + " is the same as the next");
      }
      area += ring[i][0] * to[1] - ring[i][1] * to[0];
    }
    if (area == 0) json_.fail(value.line, place, "the ring has no area");
    const int side = hole ? -sgn(area) : sgn(area);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector& from = ring[i];
      const Vector& to = ring[(i + 1) % ring.size()];
      Vector n{Rational(side * (from[1] - to[1])), Rational(side * (to[0] - from[0]))};
      const std::optional<Rational> length = exact_sqrt(dot(n, n));
      if (length) {
        for (Rational& c : n) c /= *length;
      }
      outline_.back().push_back({from, to, std::move(n)});
    }
  }

  Place read_place(const Value& value, const Where& place) const {
    Place read{value.line, 0, 0, 0};
    if (value.is_array(2)) {
      read.edge = number(value.items[0], place[0]);
      read.share = number(value.items[1], place[1]);
    } else {
      expect_object(value, place, {"polygon", "edge", "share"});
      const Value* polygon = value.find("polygon");
      if (polygon != nullptr) read.polygon = number(*polygon, place + ".polygon");
      read.edge = number(member(value, place, "edge"), place + ".edge");
      read.share = number(member(value, place, "share"), place + ".share");
    }
    expect(read.share >= 0 && read.share <= 1, value, place, "a share from 0 to 1");
    return read;
  }

  /// Contact i is where `on` says.
  void put_on_outline(std::size_t i, const Place& on) {
    const auto choose = [&](const auto& list, const Rational& index,
                            const char* what) -> auto& {
      const bool known = index.get_den() == 1 && index >= 0 && index < list.size();
      if (!known || version_ != 2) {
        json_.fail(on.line, "contacts[" + std::to_string(i) + "].on",
                   version_ == 3  ? "of several bodies give a \"position\" and a \"normal\""
                   : version_ < 2 ? kNeeds2
                                  : "there is no " + (what + (" " + show(index))));
      }
      return list[index.get_num().get_ui()];
    };
    const Edge& edge = choose(choose(outline_, on.polygon, "polygon"), on.edge, "edge");
    Contact contact = grasp_.contacts[i];
    for (std::size_t j = 0; j < 2; ++j) {
      const Rational p = edge.from[j] + on.share * (edge.to[j] - edge.from[j]);
      contact.position.emplace_back(p);
    }
    contact.normal = edge.inwards;
    grasp_.contacts.set(i, contact);
  }

  static void add(Wrench& sum, const Wrench& term) {
    for (std::size_t j = 0; j < sum.size(); ++j) {
      sum[j].low += term[j].low;
      sum[j].high += term[j].high;
    }
  }

  void read_cases(const Value& value) {
    expect(value.kind == Value::Kind::kArray && !value.items.empty(), value, "cases",
           "an array of one case or more");
    for (std::size_t k = 0; k < value.items.size(); ++k) {
      const Value& entry = value.items[k];
      const Where cases("cases");
      const Where place = cases[k];
      expect_object(entry, place, {"name", "wrench", "loads"});
      const Value& name = member(entry, place, "name");
      expect(name.kind == Value::Kind::kString && !name.text.empty(), name, place + ".name",
             "a string that is not empty");
      const Value* wrench = entry.find("wrench");
      const Value* loads = entry.find("loads");
      if ((wrench == nullptr) == (loads == nullptr)) {
        json_.fail(entry.line, place, R"(expected one of the members "wrench" and "loads")");
      }
      Wrench own = wrench != nullptr
                       ? uncertain_vector(*wrench, place + ".wrench", load_numbers())
                       : sum_of_loads(*loads, place + ".loads");
      if (!grasp_.cases.emplace(name.text, std::move(own)).second) {
        json_.fail(name.line, place, "the name " + quote(name.text) + " appears twice");
      }
    }
  }

  /// D, of the numbers of a wrench of the file.
  std::size_t load_numbers() const { return mechanism_ ? mechanism_->dimension() : dimension_; }

  Wrench sum_of_loads(const Value& value, const Where& place) {
    expect(value.kind == Value::Kind::kArray, value, place, "an array of loads");
    Wrench sum(load_numbers());
    std::vector<Vector> on_links(bodies_.size());
    for (std::size_t k = 0; k < value.items.size(); ++k) {
      const Value& load = value.items[k];
      if (mechanism_) {
        add_load_on_body(sum, on_links, load, place[k]);
      } else {
        add(sum, wrench_of(load, place[k]));
      }
    }
    if (!mechanism_) return sum;
    Vector pulled(sum.size());
    mechanism_->add_pulled(std::move(on_links), pulled);
    for (std::size_t j = 0; j < sum.size(); ++j) {
      sum[j].low += pulled[j];
      sum[j].high += pulled[j];
    }
    return sum;
  }

  /// FORMAT.md §14, `loads`: what acts on a link, whose wrench is certain, is kept by body.
  void add_load_on_body(Wrench& sum, std::vector<Vector>& on_links, Value load,
                        const Where& place) {
    expect(load.kind == Value::Kind::kObject, load, place, "an object {...}");
    const auto name = std::find(load.keys.begin(), load.keys.end(), "body");
    if (name == load.keys.end()) member(load, place, "body");
    const auto value = load.items.begin() + (name - load.keys.begin());
    const std::size_t b = body_named(*value, place + ".body");
    load.items.erase(value);
    load.keys.erase(name);
    Wrench wrench;
    if (const Value* given = load.find("wrench")) {
      expect_object(load, place, {"wrench"});
      if (bodies_[b].way) {
        json_.fail(given->line, place,
                   quote(bodies_[b].name) +
                       " is a link, which takes a force, a weight or a torque, but no wrench");
      }
      wrench = uncertain_vector(*given, place + ".wrench", dimension_);
    } else {
      wrench = wrench_of(load, place);
    }
    if (bodies_[b].way) on_links[b].resize(wrench.size());
    for (std::size_t k = 0; k < wrench.size(); ++k) {
      if (bodies_[b].way) {
        on_links[b][k] += wrench[k].low;
        continue;
      }
      Bounds& component = sum[mechanism_->first_of(b) + k];
      component.low += wrench[k].low;
      component.high += wrench[k].high;
    }
  }

  std::size_t body_named(const Value& value, const Where& place) const {
    const auto found =
        value.kind == Value::Kind::kString ? names_.find(value.text) : names_.end();
    expect(found != names_.end(), value, place, "the name of one of \"bodies\"");
    return found->second;
  }

  /// FORMAT.md §14: bodies, joints, ratchets and tendons; takes them out of `members`.
  void read_mechanism(std::map<std::string, Value>& members) {
    const Value none = array_at(json_.line());
    const auto take = [&](const char* key) {
      const auto found = members.find(key);
      Value value = found == members.end() ? none : std::move(found->second);
      members.erase(key);
      expect(value.kind == Value::Kind::kArray, value, key, "an array");
      return value;
    };
    read_bodies(take("bodies"));
    const Value joints = take("joints");
    std::vector<Turns> all_turns;
    const Where in_joints("joints");
    for (std::size_t q = 0; q < joints.items.size(); ++q) {
      const Value& joint = joints.items[q];
      const Where place = in_joints[q];
      expect_object(joint, place, {"turns", "name", "stiffness", "torque", "max_torque"});
      read_name(joint, place);
      all_turns.push_back(read_turns(member(joint, place, "turns"), place + ".turns"));
    }
    for (const auto& [name, b] : names_) {
      const auto turns = [b = b](const Turns& turned) { return turned.count(b) > 0; };
      if (!bodies_[b].way || std::any_of(all_turns.begin(), all_turns.end(), turns)) continue;
      throw Malformed{json_.file(), "bodies[" + std::to_string(b) + "]",
                      "no joint turns the link " + quote(name) +
                          R"(; expected its name in "turns" of one of "joints")"};
    }
    const bool in_space = dimension_ == kSpatial;
    const std::size_t dimension = dimension_of(bodies_, all_turns.size(), in_space);
    if (dimension > kMostInFile) {
      throw Malformed{json_.file(), "bodies",
                      "found " + std::to_string(dimension) + " coordinates, " +
                          std::to_string(dimension_) +
                          " for each body that is no link and one for each joint; expected "
                          "at most " +
                          std::to_string(kMostInFile)};
    }
    mechanism_ = std::make_shared<const Mechanism>(bodies_, all_turns, in_space);
    grasp_.wrench = Wrench(dimension);
    name_coordinates(joints);
    read_over(take("ratchets"), "ratchets", Element::Kind::kRatchet, "preload");
    for (std::size_t q = 0; q < joints.items.size(); ++q) {
      const Value& joint = joints.items[q];
      if (joint.find("stiffness") == nullptr && joint.find("torque") == nullptr &&
          joint.find("max_torque") == nullptr) {
        continue;
      }
      read_element(
          joint, in_joints[q],
          {Element::Kind::kSpring, one_row(mechanism_->row_of_joint(q)), "", "torque"});
      others_.back().limit = read_limit(joint, in_joints[q], "max_torque");
    }
    read_over(take("tendons"), "tendons", Element::Kind::kSpring, "tension");
  }

  void read_bodies(const Value& list) {
    expect(!list.items.empty(), list, "bodies", "a list of bodies, of one or more");
    const Where in_bodies("bodies");
    for (std::size_t b = 0; b < list.items.size(); ++b) {
      const Value& entry = list.items[b];
      const Where place = in_bodies[b];
      expect_object(entry, place, {"name", "hinge", "slide", "on", "outline", "mesh"});
      const Value& name = member(entry, place, "name");
      expect(name.kind == Value::Kind::kString && !name.text.empty() && name.text != kGround,
             name, place + ".name", "a string that is not empty, and not \"ground\"");
      Body body{name.text, {}, {}};
      const Value* hinge = entry.find("hinge");
      const Value* slide = entry.find("slide");
      if (hinge != nullptr && slide != nullptr) {
        json_.fail(entry.line, place, R"(both "hinge" and "slide"; give one of them)");
      }
      if (hinge != nullptr) body.way = read_hinge(*hinge, place + ".hinge");
      if (slide != nullptr) body.way = way_of_slide(axis(*slide, place + ".slide"));
      if (const Value* on = entry.find("on")) {
        expect(body.way.has_value(), *on, place + ".on",
               "none, as there is neither a \"hinge\" nor a \"slide\"");
        const bool known = on->kind == Value::Kind::kString && names_.count(on->text) > 0;
        expect(known || on->is_text(kGround), *on, place + ".on",
               "the name of a body that stands before this one, or \"ground\"");
        if (known) body.on = names_.at(on->text);
      }
      if (const Value* outline = entry.find("outline")) {
        expect(dimension_ == kPlanar, *outline, place + ".outline",
               "none, as the grasp is in space");
        read_outline(*outline, place + ".outline");
        outline_.clear();
      }
      if (const Value* mesh = entry.find("mesh")) {
        expect(dimension_ == kSpatial, *mesh, place + ".mesh",
               "none, as the grasp is in the plane");
        read_body(*mesh, place + ".mesh");
      }
      if (!names_.emplace(name.text, b).second) {
        json_.fail(name.line, place, "the name " + quote(name.text) + " appears twice");
      }
      bodies_.push_back(std::move(body));
    }
  }

  /// A point, or in space a point and an axis.
  Vector read_hinge(const Value& value, const Where& place) const {
    if (dimension_ == kPlanar) return way_of_hinge(vector(value, place, 2), {});
    expect_object(value, place, {"at", "axis"});
    return way_of_hinge(vector(member(value, place, "at"), place + ".at", 3),
                        axis(member(value, place, "axis"), place + ".axis"));
  }

  Vector axis(const Value& value, const Where& place) const {
    Vector g = vector(value, place, coordinates());
    expect(g != Vector(g.size()), value, place, "a vector other than 0");
    return g;
  }

  /// `turns` or `over`.
  Turns read_turns(const Value& value, const Where& place) const {
    const char* const what = "an object of one number or more, each by the name of a link";
    expect(value.kind == Value::Kind::kObject && !value.items.empty(), value, place, what);
    Turns turns;
    for (std::size_t k = 0; k < value.items.size(); ++k) {
      const std::string& name = value.keys[k];
      const auto found = names_.find(name);
      if (found == names_.end() || !bodies_[found->second].way) {
        json_.fail(value.line, place,
                   "found " + quote(name) +
                       R"(, expected a link, which is a body with a "hinge" or a "slide")");
      }
      const Where member = place + ".";
      const Rational c = number(value.items[k], member + name.c_str());
      expect(c != 0, value.items[k], member + name.c_str(), "a number other than 0");
      turns.emplace(found->second, c);
    }
    return turns;
  }

  /// It has no meaning here.
  void read_name(const Value& object, const Where& place) const {
    const Value* name = object.find("name");
    if (name == nullptr) return;
    expect(name->kind == Value::Kind::kString, *name, place + ".name", "a string");
  }

  void name_coordinates(const Value& joints) {
    grasp_.several.emplace();
    grasp_.several->in_space = dimension_ == kSpatial;
    std::vector<std::string>& names = grasp_.several->coordinates;
    std::vector<const char*> ways{" x", " y", " turn"};
    if (dimension_ == kSpatial) ways = {" x", " y", " z", " turn x", " turn y", " turn z"};
    for (const Body& body : bodies_) {
      if (body.way) continue;
      for (const char* way : ways) names.push_back(body.name + way);
    }
    for (std::size_t q = 0; q < joints.items.size(); ++q) {
      const Value* name = joints.items[q].find("name");
      names.push_back(name != nullptr ? name->text : "joint " + std::to_string(q));
    }
  }

  /// Ratchets or tendons.
  void read_over(const Value& list, const char* key, Element::Kind kind, const char* preload) {
    const Where in_list(key);
    for (std::size_t k = 0; k < list.items.size(); ++k) {
      const Value& entry = list.items[k];
      const Where place = in_list[k];
      expect_object(entry, place, {"over", "name", "stiffness", preload});
      read_name(entry, place);
      if (kind == Element::Kind::kRatchet) member(entry, place, "stiffness");
      const Value& over = member(entry, place, "over");
      SparseRow row = mechanism_->row(read_turns(over, place + ".over"));
      expect(!row.empty(), over, place + ".over",
             "links that some joint turns, so that its length changes");
      read_element(entry, place, {kind, one_row(std::move(row)), "", preload});
    }
  }

  Matrix one_row(SparseRow row) const { return {mechanism_->dimension(), {std::move(row)}}; }

  void read_element(const Value& value, const Where& place, Element element) {
    const bool spring = element.kind == Element::Kind::kSpring;
    const auto read = [&](const char* key, Least least) {
      const Value* found = value.find(key);
      const Where member = place + ".";
      return found != nullptr ? at_least(*found, member + key, least) : Bounds(0);
    };
    Contact contact;
    contact.stiffness = read("stiffness", spring ? Least::kZero : Least::kAboveZero);
    contact.preload = read(element.preload.c_str(), spring ? Least::kAny : Least::kZero);
    element.place = place;
    contact.sight = std::make_shared<const Element>(std::move(element));
    others_.push_back(std::move(contact));
  }

  /// Contact i is between the bodies that it names.
  void put_between_bodies(std::size_t i) {
    const auto pair = pairs_.find(i);
    const std::string place = "contacts[" + std::to_string(i) + "]";
    if (pair == pairs_.end() || !pair->second.of) {
      throw Malformed{json_.file(), place,
                      "the member \"of\" is missing, the name of the body"};
    }
    const auto& [line, of, by] = pair->second;
    const auto require = [&, line = line](bool good, const char* key, const std::string& name,
                                          const char* what) {
      if (good) return;
      json_.fail(line, place + key, "found " + quote(name) + ", expected the name of " + what);
    };
    require(names_.count(*of) > 0, ".of", *of, "one of \"bodies\"");
    require(by == kGround || (names_.count(by) > 0 && by != *of), ".by", by,
            "another of \"bodies\", or \"ground\"");
    Sight& sight = sights_[{*of, by}];
    if (!sight) {
      Element element{Element::Kind::kContact, {}, "", "", names_.at(*of), {}};
      if (by != kGround) element.by = names_.at(by);
      if (mechanism_->dimension() <= kMostCoordinates) {
        element.rows = mechanism_->motion_between(element.of, element.by);
      }
      sight = std::make_shared<const Element>(std::move(element));
    }
    Contact contact = grasp_.contacts[i];
    contact.sight = sight;
    const auto torsion = torsions_.find(i);
    contact.torsion =
        torsion == torsions_.end() ? default_torsion_.value_or(0) : torsion->second;
    const auto limit = limits_.find(i);
    contact.limit = limit == limits_.end() ? default_limit_ : limit->second;
    if (contact.limit) {
      const auto length = exact_sqrt(dot(contact.normal, contact.normal));
      if (!length) {
        json_.fail(line, place + ".max_force",
                   "found a limit, but the normal is " + show(contact.normal) +
                       "; expected one of rational length");
      }
      *contact.limit /= *length;
    }
    grasp_.contacts.set(i, contact);
  }

  /// The wrench of a force at a point, of a torque or of a weight.
  Wrench wrench_of(const Value& value, const Where& place) const {
    if (const Value* torque = value.find("torque")) {
      expect_object(value, place, {"torque"});
      const Where where = place + ".torque";
      if (dimension_ == kPlanar) return {0, 0, number(*torque, where)};
      const Vector t = vector(*torque, where, 3);
      return {0, 0, 0, t[0], t[1], t[2]};
    }
    Vector force;
    if (const Value* weight = value.find("weight")) {
      expect_object(value, place, {"weight", "at", "direction"});
      force = pull(value, *weight, place);
    } else if (const Value* mass = value.find("mass")) {
      expect_object(value, place, {"mass", "at"});
      const Rational size = number(*mass, place + ".mass");
      expect(size >= 0, *mass, place + ".mass", "a number of 0 or more");
      force = gravity_.empty() ? downwards(Rational(981, 100)) : gravity_;
      for (Rational& entry : force) entry *= size;
    } else {
      expect_object(value, place, {"force", "at"});
      force = vector(member(value, place, "force"), place + ".force", coordinates());
    }
    const Vector at = vector(member(value, place, "at"), place + ".at", coordinates());
    const Vector wrench = at_point(at, force);
    return {wrench.begin(), wrench.end()};
  }

  /// Against the last axis.
  Vector downwards(const Rational& size) const {
    Vector force(coordinates());
    force.back() = -size;
    return force;
  }

  Vector pull(const Value& load, const Value& weight, const Where& place) const {
    const Rational size = number(weight, place + ".weight");
    expect(size >= 0, weight, place + ".weight", "a number of 0 or more");
    const Value* direction = load.find("direction");
    if (direction == nullptr && gravity_.empty()) return downwards(size);
    Vector force(coordinates());
    const Vector d = direction == nullptr
                         ? gravity_
                         : vector(*direction, place + ".direction", coordinates());
    const std::optional<Rational> length = exact_sqrt(dot(d, d));
    expect(length && *length > 0, direction == nullptr ? load : *direction,
           place + ".direction", "a vector of rational length, not 0, such as [3, -4]");
    for (std::size_t j = 0; j < d.size(); ++j) force[j] = size * d[j] / *length;
    return force;
  }

  void read_contact(const Value& value) {
    const Where contacts("contacts");
    const Where place = contacts[own_.size()];
    if (own_.size() == kMaxContacts) json_.fail(value.line, "contacts", "too many contacts");
    expect_object(value, place,
                  {"position", "normal", "on", "of", "by", "friction", "stiffness", "preload",
                   "torsion", "max_force"});
    Contact contact;
    const Value* first = own_.empty() ? value.find("position") : nullptr;
    if (version_ > 1 && first != nullptr && first->is_array(3)) {
      put_in_space(*first, place + ".position");
    }
    const Value* of = value.find("of");
    const Value* by = value.find("by");
    for (const Value* name : {of, by}) {
      if (name == nullptr) continue;
      expect(name->kind == Value::Kind::kString, *name, place + (name == of ? ".of" : ".by"),
             "the name of a body");
      Pair& pair = pairs_.try_emplace(own_.size(), Pair{value.line, {}}).first->second;
      (name == of ? pair.of.emplace() : pair.by) = name->text;
    }
    if (const Value* on = value.find("on")) {
      expect(dimension_ == kPlanar, *on, place + ".on",
             "a position and a normal, as the grasp is in space");
      if (value.find("position") != nullptr || value.find("normal") != nullptr) {
        json_.fail(value.line, place, R"("on" stands in place of "position" and "normal")");
      }
      places_.emplace(own_.size(), read_place(*on, place + ".on"));
    } else {
      const Value& position = member(value, place, "position");
      contact.position = uncertain_vector(position, place + ".position", coordinates());
      read_normal(member(value, place, "normal"), place + ".normal", contact);
      if (contact.normal == Vector(coordinates())) {
        json_.fail(value.line, place + ".normal",
                   "the normal is " + show(contact.normal) + "; give a vector into the object");
      }
    }
    std::optional<Named> name;
    Properties given = properties(value, place, name);
    if (name) {
      given[0] = Bounds(0);  // until the file's names are known
      named_.emplace(own_.size(), std::move(*name));
    }
    if (const auto torsion = read_torsion(value, place)) torsions_[own_.size()] = *torsion;
    if (const auto limit = read_limit(value, place, "max_force")) limits_[own_.size()] = limit;
    own_.push_back(0);
    std::array<Bounds*, 3> own{&contact.friction, &contact.stiffness, &contact.preload};
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (!given[k]) continue;
      *own[k] = std::move(*given[k]);
      own_.back() |= static_cast<std::uint8_t>(1U << k);
    }
    grasp_.contacts.push_back(contact);
  }

  std::optional<Rational> read_torsion(const Value& object, const Where& place) {
    const Value* value = object.find("torsion");
    if (value == nullptr) return std::nullopt;
    const Where where = place + ".torsion";
    if (!soft_) soft_.emplace(value->line, where);
    const Rational read = number(*value, where);
    expect(read >= 0, *value, where, "a number of 0 or more");
    return read;
  }

  /// `max_force` or `max_torque`.
  std::optional<Rational> read_limit(const Value& object, const Where& place,
                                     const char* key) {
    const Value* value = object.find(key);
    if (value == nullptr) return std::nullopt;
    const Where member = place + ".";
    const Where where = member + key;
    if (!limited_) limited_.emplace(value->line, where);
    Rational read = number(*value, where);
    expect(read >= 0, *value, where, "a number of 0 or more");
    return read;
  }

  /// [x, y] or [x, y, z], or with a slope.
  void read_normal(const Value& value, const Where& place, Contact& contact) {
    if (value.kind != Value::Kind::kObject) {
      contact.normal = vector(value, place, coordinates());
      return;
    }
    found_newer(value, place);
    if (const Value* angle = value.find("angle")) {
      expect(dimension_ == kPlanar, *angle, place + ".angle", "none, as the grasp is in space");
      expect_object(value, place, {"angle", "slope"});
      contact.normal = direction_at(number(*angle, place + ".angle"));
      if (value.find("slope") == nullptr) return;
    } else {
      expect_object(value, place, {"direction", "slope"});
      contact.normal =
          vector(member(value, place, "direction"), place + ".direction", coordinates());
    }
    const Value& slope = member(value, place, "slope");
    contact.slope = number(slope, place + ".slope");
    expect(contact.slope >= 0 && contact.slope < 1, slope, place + ".slope",
           "a number of 0 or more and below 1");
  }

  /// What a contact does not say itself, defaults say, and else 1 and 0.
  void complete(std::size_t i) {
    const auto named = named_.find(i);
    if (own_[i] == kAllOwn && named == named_.end()) return;
    Contact contact = grasp_.contacts[i];
    if (named != named_.end()) {
      contact.friction = friction_named(named->second, "contacts[" + std::to_string(i) + "]");
    }
    const auto choose = [&](std::size_t k, Bounds& property, const char* otherwise) {
      if (own_[i] >> k & 1U) return;
      if (otherwise == nullptr && !defaults_[k]) {
        throw Malformed{json_.file(), "contacts[" + std::to_string(i) + "]",
                        "the member \"friction\" is missing, and \"defaults\" has none"};
      }
      property = defaults_[k] ? *defaults_[k] : Bounds(Rational(otherwise));
    };
    choose(0, contact.friction, nullptr);
    choose(1, contact.stiffness, "1");
    choose(2, contact.preload, "0");
    grasp_.contacts.set(i, contact);
  }

  /// Throws unless `good`, saying what was found instead of `what`.
  template <typename Text>
  void expect(bool good, const Value& value, const Where& place, const Text& what) const {
    if (!good) json_.expect(false, value, place, what);
  }

  void allow(const std::string& key, Names names, const Where& place, std::size_t line) const {
    if (std::find(names.begin(), names.end(), key) != names.end()) return;
    std::string list;
    for (const char* name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    const bool snapping = key == "normals" && std::string(place).empty();
    json_.fail(line, place,
               "unknown member " + quote(key) + "; known here are " + list +
                   (snapping ? "; to snap normals, run: stickslip snap GRASP -o FILE" : ""));
  }

  void expect_object(const Value& value, const Where& place, Names names) const {
    expect(value.kind == Value::Kind::kObject, value, place, "an object {...}");
    for (const std::string& key : value.keys) allow(key, names, place, value.line);
  }

  const Value& member(const Value& object, const Where& place, const char* key) const {
    const Value* value = object.find(key);
    if (value == nullptr) {
      json_.fail(object.line, place, std::string("the member \"") + key + "\" is missing");
    }
    return *value;
  }

  Rational number(const Value& value, const Where& place) const {
    std::optional<Rational> read;
    if (value.kind == Value::Kind::kNumber || value.kind == Value::Kind::kString) {
      read = parse_decimal(value.text);
    }
    expect(read.has_value(), value, place,
           "a number such as 0.25 or 1e-3, or a string as \"3/5\"");
    // What rounds to 2^16384 with a mantissa of 64 bits (docs/grasp_file.md).
    static const Integer kBeyond = (Integer(1) << 16384) - (Integer(1) << 16319);
    expect(value.kind == Value::Kind::kString || abs(*read) < kBeyond, value, place,
           "a number below 2^16384; a string spells larger ones");
    return *read;
  }

  Vector vector(const Value& value, const Where& place, std::size_t size) const {
    if (!value.is_array(size)) expect(false, value, place, array_of(size));
    Vector result;
    result.reserve(size);
    for (std::size_t j = 0; j < size; ++j) {
      result.push_back(number(value.items[j], place[j]));
    }
    return result;
  }

  /// What the place of so many numbers expects.
  std::string array_of(std::size_t size) const {
    if (size == kSpatial) {
      return "an array [force x, force y, force z, torque x, torque y, torque z]";
    }
    if (size != coordinates()) return "an array [force x, force y, torque]";
    return std::string(size == 3 ? "3 coordinates [x, y, z]" : "2 coordinates [x, y]") +
           (own_.empty() ? "" : ", as the first contact has");
  }

  /// Of positions, normals and points.
  std::size_t coordinates() const { return stickslip_check::coordinates(dimension_); }

  /// Version 1 has no intervals, no slopes and no space; the version may be stated later.
  void found_newer(const Value& value, const Where& place) {
    if (!newer_) newer_.emplace(value.line, place);
  }

  /// A number or an INTERVAL (FORMAT.md §6).
  Bounds bounds(const Value& value, const Where& place) {
    if (value.kind != Value::Kind::kObject) return number(value, place);
    found_newer(value, place);
    expect_object(value, place, {"min", "max"});
    const Bounds read(number(member(value, place, "min"), place + ".min"),
                      number(member(value, place, "max"), place + ".max"));
    if (read.low > read.high) {
      json_.fail(value.line, place,
                 "found min " + show(read.low) + " above max " + show(read.high) +
                     ", expected min <= max");
    }
    return read;
  }

  std::vector<Bounds> uncertain_vector(const Value& value, const Where& place,
                                       std::size_t size) {
    if (!value.is_array(size)) expect(false, value, place, array_of(size));
    std::vector<Bounds> result;
    result.reserve(size);
    for (std::size_t j = 0; j < size; ++j) {
      result.push_back(bounds(value.items[j], place[j]));
    }
    return result;
  }

  /// A friction that is a name is left out, and put into `name`.
  Properties properties(const Value& object, const Where& place, std::optional<Named>& name) {
    Properties result;
    for (std::size_t k = 0; k < kProperties.size(); ++k) {
      const Value* value = object.find(kProperties[k]);
      if (value == nullptr) continue;
      if (k == 0 && value->kind == Value::Kind::kString && !begins_as_number(value->text)) {
        name = Named{value->line, value->text};
        continue;
      }
      const Where member = place + ".";
      const Where where = member + kProperties[k];
      const bool above = value == object.find("stiffness");
      result[k] = at_least(*value, where, above ? Least::kAboveZero : Least::kZero);
    }
    return result;
  }

  enum class Least : std::int8_t { kAny, kZero, kAboveZero };
  Bounds at_least(const Value& value, const Where& place, Least least) {
    Bounds read = bounds(value, place);
    const bool above = least == Least::kAboveZero;
    if (least != Least::kAny && (read.low < 0 || (above && read.low == 0))) {
      json_.fail(value.line, place,
                 "found " + show(read.low) + ", expected a number " +
                     (above ? "above 0" : "of 0 or more"));
    }
    return read;
  }

  JsonReader json_;
  Grasp grasp_;
  std::size_t dimension_ = kPlanar;
  int version_ = 2;                                           ///< until the file says
  std::optional<std::pair<std::size_t, std::string>> newer_;  ///< line and place, the first
  std::vector<std::vector<Edge>> outline_;                    ///< by polygon
  std::map<std::size_t, Place> places_;                       ///< by contact
  std::vector<std::uint8_t> own_;  ///< by contact, which of kProperties it gives: bits
  Properties defaults_;
  Vector gravity_;                           ///< empty if the file has none
  std::map<std::string, Bounds> frictions_;  ///< those with names
  std::map<std::size_t, Named> named_;       ///< by contact, which of them it has

  std::optional<std::pair<std::size_t, std::string>> soft_;     ///< of "torsion", the same
  std::optional<std::pair<std::size_t, std::string>> limited_;  ///< and of "max_force"

  // Of several bodies:
  std::vector<Body> bodies_;
  std::map<std::string, std::size_t> names_;  ///< of bodies
  std::shared_ptr<const Mechanism> mechanism_;
  std::map<std::size_t, Pair> pairs_;         ///< by contact
  std::map<std::size_t, Rational> torsions_;  ///< by contact
  std::optional<Rational> default_torsion_;
  std::map<std::size_t, std::optional<Rational>> limits_;  ///< by contact: `max_force`
  std::optional<Rational> default_limit_;
  std::map<std::pair<std::string, std::string>, Sight> sights_;
  std::vector<Contact> others_;  ///< ratchets and springs
};

}  // namespace

Contacts::Contacts(std::initializer_list<Contact> contacts) {
  for (const Contact& contact : contacts) push_back(contact);
}

Contact Contacts::operator[](std::size_t i) const {
  const Short& numbers = short_[i];
  if (numbers[0].den == 0) return others_.at(i);
  auto next = numbers.begin();
  const auto take = [&] {
    Rational x;
    mpq_set_si(x.get_mpq_t(), next->num, static_cast<unsigned long>(next->den));
    ++next;
    return x;
  };
  Contact contact;
  contact.friction = take();
  contact.stiffness = take();
  contact.preload = take();
  const std::size_t size = numbers.back().den == 0 ? 2 : 3;
  contact.position.reserve(size);
  contact.normal.reserve(size);
  for (std::size_t j = 0; j < size; ++j) contact.position.emplace_back(take());
  for (std::size_t j = 0; j < size; ++j) contact.normal.push_back(take());
  return contact;
}

void Contacts::push_back(const Contact& contact) {
  short_.emplace_back();
  set(short_.size() - 1, contact);
}

void Contacts::set(std::size_t i, const Contact& contact) {
  Short numbers;
  auto next = numbers.begin();
  bool fits = !contact.sight && contact.slope == 0 && contact.torsion == 0 &&
              !contact.limit && contact.position.size() == contact.normal.size() &&
              (contact.normal.size() == 2 || contact.normal.size() == 3);
  const auto put = [&](const Rational& x) {
    fits = fits && x.get_num().fits_slong_p() && x.get_den().fits_slong_p();
    if (fits) *next++ = {x.get_num().get_si(), x.get_den().get_si()};
  };
  const auto put_certain = [&](const Bounds& bounds) {
    fits = fits && bounds.certain();
    put(bounds.low);
  };
  for (const Bounds* bounds : {&contact.friction, &contact.stiffness, &contact.preload}) {
    put_certain(*bounds);
  }
  for (const Bounds& p : contact.position) put_certain(p);
  for (const Rational& n : contact.normal) put(n);
  short_[i] = fits ? numbers : Short{};
  others_.erase(i);
  if (!fits) others_.emplace(i, contact);
}

Grasp read_grasp(std::istream& in, const std::string& file) {
  return GraspReader(in, file).read();
}

}  // namespace stickslip_check
