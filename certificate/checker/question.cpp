// SPDX-License-Identifier: MIT
#include "question.hpp"

#include <algorithm>
#include <utility>

#include "answer.hpp"
#include "json.hpp"

namespace stickslip_check {
namespace {

constexpr JsonLimits kLimits{std::uint64_t{1} << 28U, 32, true, std::uint64_t{1} << 28U};
constexpr std::size_t kMaxContacts = 1'000'000;

/// The properties that "defaults" may give.
struct Properties {
  std::optional<Rational> friction;
  std::optional<Rational> stiffness;
  std::optional<Rational> preload;
};

class GraspReader : public JsonHandler {
 public:
  explicit GraspReader(std::string file) : file_(std::move(file)) {}

  bool begin_member(const std::string& key, std::size_t line) override {
    allow(key, {"format", "name", "defaults", "contacts", "wrench", "normals"}, "", line);
    seen_.push_back(key);
    return key == "contacts";
  }

  void element(const Value& value) override {
    const std::string path = "contacts[" + std::to_string(contacts_.size()) + "]";
    if (contacts_.size() == kMaxContacts) fail(value.line, "contacts", "too many contacts");
    expect_object(value, path, {"position", "normal", "friction", "stiffness", "preload"});
    GraspContact contact;
    contact.position = vector<2>(member(value, path, "position"), path + ".position");
    contact.normal = vector<2>(member(value, path, "normal"), path + ".normal");
    if (contact.normal[0] == 0 && contact.normal[1] == 0) {
      fail(value.line, path + ".normal", "the normal is (0, 0); give a vector into the object");
    }
    contacts_.push_back(std::move(contact));
    own_.push_back(properties(value, path));
  }

  void end_member(const std::string& key, const Value& value) override {
    if (key == "format") {
      if (value.kind != Value::Kind::kString || value.text != "stickslip-grasp/1") {
        fail(value.line, key, "found " + describe(value) + ", expected \"stickslip-grasp/1\"");
      }
    } else if (key == "name") {
      expect(value.kind == Value::Kind::kString, value, key, "a string");
    } else if (key == "contacts") {
      expect(value.kind == Value::Kind::kArray, value, key, "an array of contacts");
    } else if (key == "wrench") {
      wrench_ = vector<3>(value, key);
    } else if (key == "defaults") {
      expect_object(value, key, {"friction", "stiffness", "preload"});
      defaults_ = properties(value, key);
    } else {
      read_normals(value);
    }
  }

  Question finish() {
    for (const char* key : {"format", "contacts", "wrench"}) {
      if (std::find(seen_.begin(), seen_.end(), key) == seen_.end()) {
        throw Malformed{file_, "top level",
                        std::string("the member \"") + key + "\" is missing"};
      }
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const std::optional<Rational> friction =
          own_[i].friction ? own_[i].friction : defaults_.friction;
      if (!friction) {
        throw Malformed{file_, "contacts[" + std::to_string(i) + "]",
                        "the member \"friction\" is missing, and \"defaults\" has none"};
      }
      contacts_[i].friction = *friction;
      contacts_[i].stiffness = own_[i].stiffness.value_or(defaults_.stiffness.value_or(1));
      contacts_[i].preload = own_[i].preload.value_or(defaults_.preload.value_or(0));
    }
    return {std::move(contacts_), wrench_, std::nullopt, std::nullopt, false, snap_tolerance_};
  }

 private:
  using Names = std::vector<std::string>;

  [[noreturn]] void fail(std::size_t line, const std::string& path,
                         const std::string& problem) const {
    throw Malformed{file_, "line " + std::to_string(line) + (path.empty() ? path : ", " + path),
                    problem};
  }

  void expect(bool good, const Value& value, const std::string& path, const char* what) const {
    if (!good) fail(value.line, path, "found " + describe(value) + ", expected " + what);
  }

  void allow(const std::string& key, const Names& names, const std::string& path,
             std::size_t line) const {
    if (std::find(names.begin(), names.end(), key) != names.end()) return;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    fail(line, path, "unknown member " + quote(key) + "; known here are " + list);
  }

  void expect_object(const Value& value, const std::string& path, const Names& names) const {
    expect(value.kind == Value::Kind::kObject, value, path, "an object {...}");
    for (const std::string& key : value.keys) allow(key, names, path, value.line);
  }

  const Value& member(const Value& object, const std::string& path, const char* key) const {
    const Value* value = object.find(key);
    if (value == nullptr) {
      fail(object.line, path, std::string("the member \"") + key + "\" is missing");
    }
    return *value;
  }

  Rational number(const Value& value, const std::string& path) const {
    std::optional<Rational> read;
    if (value.kind == Value::Kind::kNumber || value.kind == Value::Kind::kString) {
      read = parse_decimal(value.text);
    }
    expect(read.has_value(), value, path,
           "a number such as 0.25 or 1e-3, or a string as \"3/5\"");
    return *read;
  }

  template <std::size_t kSize>
  std::array<Rational, kSize> vector(const Value& value, const std::string& path) const {
    expect(value.is_array(kSize), value, path,
           kSize == 2 ? "an array [x, y]" : "an array [force x, force y, torque]");
    std::array<Rational, kSize> result;
    for (std::size_t i = 0; i < kSize; ++i) {
      result[i] = number(value.items[i], path + "[" + std::to_string(i) + "]");
    }
    return result;
  }

  /// A member that is at least 0, or above 0.
  std::optional<Rational> property(const Value& object, const std::string& path,
                                   const char* key, bool above) const {
    const Value* value = object.find(key);
    if (value == nullptr) return std::nullopt;
    const std::string place = path + "." + key;
    const Rational read = number(*value, place);
    if (read < 0 || (above && read == 0)) {
      fail(value->line, place,
           "found " + show(read) + ", expected a number " +
               (above ? "above 0" : "of 0 or more"));
    }
    return read;
  }

  Properties properties(const Value& object, const std::string& path) const {
    return {property(object, path, "friction", false),
            property(object, path, "stiffness", true),
            property(object, path, "preload", false)};
  }

  void read_normals(const Value& value) {
    if (value.kind == Value::Kind::kObject) {
      expect_object(value, "normals", {"snap"});
      const Value& tolerance = member(value, "normals", "snap");
      snap_tolerance_ = number(tolerance, "normals.snap");
      expect(*snap_tolerance_ > 0 && *snap_tolerance_ < 1, tolerance, "normals.snap",
             "a number between 0 and 1, such as 1e-9");
      return;
    }
    const bool text = value.kind == Value::Kind::kString;
    expect(text && (value.text == "exact" || value.text == "snap"), value, "normals",
           R"("exact", "snap" or {"snap": EPS})");
    if (value.text == "snap") snap_tolerance_ = Rational(1, 1'000'000'000);
  }

  std::string file_;
  Names seen_;
  std::vector<GraspContact> contacts_;
  std::vector<Properties> own_;
  Properties defaults_;
  Vector3 wrench_;
  std::optional<Rational> snap_tolerance_;
};

Rational square(const Vector2& v) {
  return v[0] * v[0] + v[1] * v[1];
}

}  // namespace

Question read_question(std::istream& in, const std::string& file,
                       const QuestionOptions& options) {
  GraspReader reader(file);
  read_json(in, file, kLimits, reader);
  Question question = reader.finish();
  if (options.direction) question.wrench = Vector3{};  // FORMAT.md §10
  if (options.wrench) question.wrench = *options.wrench;
  question.direction = options.direction;
  if (question.direction == Vector3{}) {
    throw Malformed{"the question", "direction", "found (0, 0, 0), expected another"};
  }
  if (options.preload) {
    if (*options.preload < 0) {
      throw Malformed{"the question", "preload",
                      "found " + show(*options.preload) + ", expected 0 or more"};
    }
    question.preload = options.preload;
    for (GraspContact& contact : question.contacts) contact.preload = *options.preload;
  }
  question.bilateral = options.bilateral;
  if (options.snap_tolerance) {
    if (*options.snap_tolerance <= 0 || *options.snap_tolerance >= 1) {
      throw Malformed{"the question", "snap tolerance",
                      "found " + show(*options.snap_tolerance) + ", expected 0 < EPS < 1"};
    }
    question.snap_tolerance = options.snap_tolerance;
  }
  return question;
}

std::optional<std::string> snap_refusal(const GraspContact& contact, const Vector2& u,
                                        const Rational& tolerance) {
  const Rational length_squared = square(contact.normal);
  if (exact_sqrt(length_squared)) return "the normal has rational length, so it must be kept";
  if (square(u) != 1) return "the length of the new normal is not 1";
  // |u - n/|n||^2 = 2 - 2 u.n/|n|, so the distance is at most eps iff
  // s = u.n >= (1 - eps^2/2) |n|, where the right side is positive: square both.
  const Rational s = u[0] * contact.normal[0] + u[1] * contact.normal[1];
  const Rational cosine = 1 - tolerance * tolerance / 2;
  if (s <= 0 || s * s < cosine * cosine * length_squared) {
    return "the new normal is further from the old one than " + show(tolerance);
  }
  return std::nullopt;
}

Rational snap_distance_squared(const GraspContact& contact, const Vector2& u) {
  // With c = cos of the angle, 2 - 2c = 2 (1 - c^2) / (1 + c) <= 2 sin^2 / (1 + c^2), as c >=
  // c^2.
  const Vector2& n = contact.normal;
  const Rational cross = u[0] * n[1] - u[1] * n[0];
  const Rational sine_squared = cross * cross / square(n);
  return 2 * sine_squared / (2 - sine_squared);
}

std::optional<Row> make_row(const GraspContact& contact) {
  const Vector2& p = contact.position;
  const Vector2& n = contact.normal;
  const Vector2 t{Rational(-n[1]), n[0]};
  const Rational length_squared = square(n);
  Rational preload = 0;
  if (contact.preload > 0) {
    const std::optional<Rational> length = exact_sqrt(length_squared);
    if (!length) return std::nullopt;
    preload = contact.preload / *length;
  }
  return Row{{n[0], n[1], Rational(p[0] * n[1] - p[1] * n[0])},
             {t[0], t[1], Rational(p[0] * t[1] - p[1] * t[0])},
             contact.friction,
             preload,
             Rational(contact.stiffness / length_squared)};
}

}  // namespace stickslip_check
